//! The drawing as the file has it: entities, blocks of entities, layers that are not shown.

use super::codes::{Group, Groups};
use crate::{Error, Problem};
use std::collections::{BTreeSet, HashMap};
use std::ops::Range;

/// Entities of which the groups are kept; of all others only the layer is.
const KEPT: [&[u8]; 14] = [
    b"POINT",
    b"LINE",
    b"LWPOLYLINE",
    b"POLYLINE",
    b"VERTEX",
    b"SEQEND",
    b"ARC",
    b"CIRCLE",
    b"ELLIPSE",
    b"SPLINE",
    b"3DFACE",
    b"SOLID",
    b"TRACE",
    b"INSERT",
];

/// Codes from here on are data of other programs.
const FOREIGN: i32 = 1000;

/// The code of the name of the layer.
pub(super) const LAYER: i32 = 8;

/// An entity and its groups.
#[derive(Clone, Debug)]
pub(super) struct Entity<'a> {
    pub kind: &'a [u8],
    pub groups: Range<usize>,
    pub at: u64,
}

impl Entity<'_> {
    /// Tells whether the entity is of this kind.
    pub fn is(&self, kind: &str) -> bool {
        self.kind.eq_ignore_ascii_case(kind.as_bytes())
    }

    /// Tells whether entities of this kind are read.
    pub fn is_kept(&self) -> bool {
        KEPT.iter().any(|kept| self.kind.eq_ignore_ascii_case(kept))
    }
}

/// A block: entities that are drawn where they are inserted.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// What lies at the place of insertion.
    pub base: [f64; 3],
    /// The entities.
    pub entities: Range<usize>,
}

/// Everything of a file that matters.
#[derive(Default)]
pub(super) struct Drawing<'a> {
    pub groups: Vec<Group<'a>>,
    /// Those of blocks and of the drawing itself.
    pub entities: Vec<Entity<'a>>,
    /// By their names in upper case, as names do not depend on case.
    pub blocks: HashMap<String, Block>,
    /// The entities of the drawing itself.
    pub own: Vec<Range<usize>>,
    /// Layers that are frozen or off.
    pub hidden: BTreeSet<String>,
}

/// The sections that matter.
#[derive(Clone, Copy, PartialEq)]
enum Section {
    Tables,
    Blocks,
    Entities,
    Other,
}

/// Reads a file up to `0 EOF`.
pub(super) fn read<'a>(groups: &mut Groups<'a>) -> Result<Drawing<'a>, Error> {
    let mut parser = Parser {
        drawing: Drawing::default(),
        section: Section::Other,
        open: None,
        next: groups.next()?,
    };
    while let Some(head) = parser.next {
        if head.is(0, "EOF") {
            return Ok(parser.drawing);
        }
        parser.next = groups.next()?;
        if head.is(0, "SECTION") {
            parser.begin_section();
        } else if head.is(0, "ENDSEC") {
            parser.section = Section::Other;
        } else if head.code == 0 {
            parser.part(head, groups)?;
        }
    }
    let begins = parser.drawing.own.is_empty() && parser.drawing.groups.is_empty();
    Err(match begins && groups.round() < 2 {
        true => groups.malformed(1, Problem::Empty),
        false => groups.truncated("0 EOF"),
    })
}

struct Parser<'a> {
    drawing: Drawing<'a>,
    section: Section,
    /// The block whose entities come.
    open: Option<(String, Block)>,
    /// The group that is looked at next.
    next: Option<Group<'a>>,
}

impl<'a> Parser<'a> {
    fn begin_section(&mut self) {
        let name = self.next.filter(|group| group.code == 2);
        let name = name.map_or(&b""[..], |group| group.text());
        self.section = match name.to_ascii_uppercase().as_slice() {
            b"TABLES" => Section::Tables,
            b"BLOCKS" => Section::Blocks,
            b"ENTITIES" => Section::Entities,
            _ => Section::Other,
        };
        if self.section == Section::Entities {
            let here = self.drawing.entities.len();
            self.drawing.own.push(here..here);
        }
    }

    /// Reads what begins with a group of code 0, up to the next of them.
    fn part(&mut self, head: Group<'a>, groups: &mut Groups<'a>) -> Result<(), Error> {
        match self.section {
            Section::Tables if head.is(0, "LAYER") => self.layer(groups),
            Section::Blocks if head.is(0, "BLOCK") => self.begin_block(groups),
            Section::Blocks if head.is(0, "ENDBLK") => {
                self.end_block();
                self.collect(groups, |_| false).map(drop)
            }
            Section::Blocks | Section::Entities => self.entity(head, groups),
            Section::Tables | Section::Other => self.collect(groups, |_| false).map(drop),
        }
    }

    /// Adds the wanted groups up to the next of code 0.
    fn collect(
        &mut self,
        groups: &mut Groups<'a>,
        is_wanted: impl Fn(i32) -> bool,
    ) -> Result<Range<usize>, Error> {
        let first = self.drawing.groups.len();
        while let Some(group) = self.next.filter(|group| group.code != 0) {
            if is_wanted(group.code) {
                self.drawing.groups.push(group);
            }
            self.next = groups.next()?;
        }
        Ok(first..self.drawing.groups.len())
    }

    fn entity(&mut self, head: Group<'a>, groups: &mut Groups<'a>) -> Result<(), Error> {
        let mut entity = Entity {
            kind: head.text(),
            groups: 0..0,
            at: head.at,
        };
        let is_kept = entity.is_kept();
        entity.groups =
            self.collect(groups, |code| code == LAYER || (is_kept && code < FOREIGN))?;
        self.drawing.entities.push(entity);
        if self.section == Section::Entities
            && let Some(own) = self.drawing.own.last_mut()
        {
            own.end = self.drawing.entities.len();
        }
        Ok(())
    }

    /// Remembers a layer if it is not shown: frozen by its flags, or off by a negative colour.
    fn layer(&mut self, groups: &mut Groups<'a>) -> Result<(), Error> {
        let range = self.collect(groups, |code| matches!(code, 2 | 62 | 70))?;
        let of_layer: Vec<_> = self.drawing.groups.drain(range).collect();
        let find = |code| of_layer.iter().find(|group| group.code == code);
        let number = |code| find(code).and_then(|group| group.number().ok());
        let is_frozen = number(70).is_some_and(|flags| flags as i64 & 1 == 1);
        let is_off = number(62).is_some_and(|color| color < 0.0);
        if is_frozen || is_off {
            let name = find(2).map(|group| name(group.text()));
            self.drawing.hidden.extend(name);
        }
        Ok(())
    }

    fn begin_block(&mut self, groups: &mut Groups<'a>) -> Result<(), Error> {
        self.end_block();
        let range = self.collect(groups, |code| matches!(code, 2 | 10 | 20 | 30))?;
        let here = self.drawing.entities.len();
        let mut block = Block {
            base: [0.0; 3],
            entities: here..here,
        };
        let mut key = String::new();
        for group in self.drawing.groups.drain(range) {
            match group.code {
                2 => key = block_key(group.text()),
                code => {
                    let number = group.number();
                    block.base[(code / 10 - 1) as usize] =
                        number.map_err(|problem| groups.malformed(group.at, problem))?;
                }
            }
        }
        self.open = Some((key, block));
        Ok(())
    }

    fn end_block(&mut self) {
        if let Some((key, mut block)) = self.open.take() {
            block.entities.end = self.drawing.entities.len();
            self.drawing.blocks.insert(key, block);
        }
    }
}

/// Returns the name of a block as it is looked up.
pub(super) fn block_key(text: &[u8]) -> String {
    name(text).to_uppercase()
}

/// Returns a name, repaired to UTF-8.
pub(super) fn name(text: &[u8]) -> String {
    String::from_utf8_lossy(text).into_owned()
}
