//! Reading: the entities of the drawing, and of blocks where they are inserted.

use super::assembly::Assembly;
use super::codes::Groups;
use super::drawing::{self, Drawing, Entity, block_key};
use super::entity::{self, Drawn, Fields, Wrong};
use crate::curve::{self, Affine, Outline};
use crate::{DomainData, Error, Place, Problem, ReadOptions, cancel, words};
use delone::{DomainRule, Watch};
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

/// Deepest nesting of blocks.
const MAX_DEPTH: usize = 32;

/// Most entities that are drawn by insertions.
const MAX_COPIES: u64 = 1 << 22;

/// Most layers that a note or an error names.
const MAX_NAMED: usize = 40;

/// Reads a domain.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let mut groups = Groups::new(file, bytes, watch);
    let drawing = drawing::read(&mut groups)?;
    let mut walk = Walk {
        drawing: &drawing,
        options,
        watch,
        assembly: Assembly::default(),
        layers: Layers::default(),
        left_out: BTreeMap::new(),
        round: 0,
        copies: 0,
        made: 0,
    };
    for own in drawing.own.clone() {
        walk.entities(own, &Affine::IDENTITY, None)
            .map_err(|stop| match stop {
                Stop::Wrong((at, problem)) => groups.malformed(at, problem),
                Stop::Cancelled => Error::Cancelled,
            })?;
    }
    walk.finish().map_err(|problem| Error::Malformed {
        file: file.to_owned(),
        place: Place::File,
        problem,
    })
}

enum Stop {
    Wrong(Wrong),
    Cancelled,
}

impl From<Wrong> for Stop {
    fn from(wrong: Wrong) -> Self {
        Self::Wrong(wrong)
    }
}

/// The layers of the entities so far.
#[derive(Default)]
struct Layers {
    /// In the order in which they appear.
    names: Vec<String>,
    /// By their names in upper case.
    numbers: HashMap<String, usize>,
}

impl Layers {
    /// Returns the number of a layer, from 0.
    fn number(&mut self, name: String) -> usize {
        let new = self.names.len();
        let number = *self.numbers.entry(name.to_uppercase()).or_insert(new);
        if number == new {
            self.names.push(name);
        }
        number
    }
}

/// Returns the marker that our own drawings have in the name of a layer.
fn marker_of(layer: &str) -> Option<i32> {
    layer.strip_prefix("SEGMENTS_")?.parse().ok()
}

/// An insertion around what is drawn.
#[derive(Clone, Copy)]
struct Around<'d> {
    depth: usize,
    /// The layer of what is on layer 0.
    layer: &'d str,
}

struct Walk<'d, 'a> {
    drawing: &'d Drawing<'a>,
    options: &'d ReadOptions,
    watch: &'d dyn Watch,
    assembly: Assembly,
    layers: Layers,
    /// What is not read, and how often it is there.
    left_out: BTreeMap<String, usize>,
    round: usize,
    copies: u64,
    /// Points that the file does not have: of curves, and by insertions.
    made: usize,
}

impl<'d, 'a> Walk<'d, 'a> {
    fn entities(
        &mut self,
        range: Range<usize>,
        map: &Affine,
        around: Option<Around<'_>>,
    ) -> Result<(), Stop> {
        let end = range.end;
        let mut next = range.start;
        while next < end {
            let entity = &self.drawing.entities[next];
            self.round += 1;
            cancel::check(self.watch, self.round).map_err(|_| Stop::Cancelled)?;
            if around.is_some() {
                self.count_copy(entity.at)?;
            }
            let parts = next + 1..match entity.is("POLYLINE") {
                true => next + 1 + self.num_vertices(next + 1..end),
                false => next + 1,
            };
            next = parts.end;
            self.entity(entity, parts, map, around)?;
        }
        Ok(())
    }

    /// Counts the vertices of a polyline, which come behind it.
    fn num_vertices(&self, range: Range<usize>) -> usize {
        let entities = self.drawing.entities[range].iter();
        entities.take_while(|entity| entity.is("VERTEX")).count()
    }

    fn entity(
        &mut self,
        entity: &Entity<'a>,
        parts: Range<usize>,
        map: &Affine,
        around: Option<Around<'_>>,
    ) -> Result<(), Stop> {
        let fields = Fields::new(entity, &self.drawing.groups);
        if entity.is("SEQEND") || entity.is("VERTEX") {
            return Ok(());
        }
        if fields.is_on_paper()? {
            self.leave_out("on paper");
            return Ok(());
        }
        let own = drawing::name(fields.layer());
        let layer = match around {
            Some(around) if own == "0" => around.layer.to_owned(),
            _ => own,
        };
        if entity.is("INSERT") {
            return self.insert(fields, map, &layer, around);
        }
        let wanted = &self.options.layers;
        let is_wanted = wanted.is_empty() || wanted.iter().any(|name| is_same(name, &layer));
        if !entity.is_kept() {
            if is_wanted {
                self.leave_out(&drawing::name(entity.kind).to_uppercase());
            }
            return Ok(());
        }
        let named = marker_of(&layer);
        let marker = self.layers.number(layer);
        if !is_wanted {
            return Ok(());
        }
        let marker = named.unwrap_or_else(|| i32::try_from(marker + 1).unwrap_or(i32::MAX));
        let drawn = match entity.is("POLYLINE") {
            true => {
                let vertices = self.drawing.entities[parts].iter();
                let vertices = vertices.map(|vertex| Fields::new(vertex, &self.drawing.groups));
                entity::polyline(fields, &vertices.collect::<Vec<_>>())?
            }
            false => entity::draw(entity, fields)?,
        };
        let added = self.add(drawn, map, marker, around.is_some());
        added.map_err(|problem| Stop::Wrong((entity.at, problem)))?;
        if self.made > curve::MAX_POINTS {
            return Err(too_many_copies(entity.at));
        }
        Ok(())
    }

    fn add(
        &mut self,
        drawn: Drawn,
        map: &Affine,
        marker: i32,
        is_copy: bool,
    ) -> Result<(), Problem> {
        let before = self.assembly.num_points();
        let in_file = match &drawn {
            Drawn::Curve(outline) if !is_copy => outline.pieces.len() + 1,
            Drawn::Curve(_) => 0,
            // Points and faces in blocks are counted as copies.
            _ => usize::MAX,
        };
        match drawn {
            Drawn::Point(place) => self.assembly.point(map.place(place))?,
            Drawn::Curve(outline) => {
                let line = self.flatten(&outline, map)?;
                match &line[..] {
                    [point] => self.assembly.point(*point)?,
                    [a, b] if a == b => self.assembly.point(*a)?,
                    line => self.assembly.line(line, marker)?,
                }
            }
            Drawn::Face(outline) => {
                let line = self.flatten(&outline, map)?;
                self.assembly.face(&line, marker)?;
            }
            Drawn::Unread(what) => self.leave_out(what),
        }
        let added = self.assembly.num_points() - before;
        self.made += added.saturating_sub(in_file);
        Ok(())
    }

    fn flatten(&self, outline: &Outline, map: &Affine) -> Result<Vec<curve::Place3>, Problem> {
        match *map == Affine::IDENTITY {
            true => outline.flatten(self.options.flatness),
            false => outline.mapped(map).flatten(self.options.flatness),
        }
    }

    /// Draws a block where it is inserted, each of its copies.
    fn insert(
        &mut self,
        fields: Fields<'_, '_>,
        map: &Affine,
        layer: &str,
        around: Option<Around<'_>>,
    ) -> Result<(), Stop> {
        let name = fields.text(2);
        let Some(block) = self.drawing.blocks.get(&block_key(name)) else {
            self.leave_out(&format!(
                "INSERT of {:?}, which is no block",
                drawing::name(name)
            ));
            return Ok(());
        };
        let depth = around.map_or(0, |around| around.depth) + 1;
        if depth > MAX_DEPTH {
            let text = format!(
                "block {:?} lies in more than {MAX_DEPTH} others, or in itself",
                drawing::name(name)
            );
            return Err(Stop::Wrong((fields.at, Problem::Other(text))));
        }
        let [columns, rows] = fields.copies()?;
        for row in 0..rows {
            for column in 0..columns {
                self.count_copy(fields.at)?;
                let inner = fields.insertion(block.base, [column as f64, row as f64])?;
                let around = Around { depth, layer };
                self.entities(block.entities.clone(), &map.after(&inner), Some(around))?;
            }
        }
        Ok(())
    }

    fn count_copy(&mut self, at: u64) -> Result<(), Stop> {
        self.copies += 1;
        cancel::check(self.watch, self.copies as usize).map_err(|_| Stop::Cancelled)?;
        match self.copies <= MAX_COPIES {
            true => Ok(()),
            false => Err(too_many_copies(at)),
        }
    }

    fn leave_out(&mut self, what: &str) {
        // Names come from the file: there may be as many as entities.
        if self.left_out.len() < MAX_NAMED || self.left_out.contains_key(what) {
            *self.left_out.entry(what.to_owned()).or_default() += 1;
        } else {
            *self.left_out.entry("others".to_owned()).or_default() += 1;
        }
    }

    fn finish(self) -> Result<DomainData, Problem> {
        let there = &self.layers.names;
        let wanted = &self.options.layers;
        let is_there = |name: &&String| !there.iter().any(|layer| is_same(layer, name));
        if let Some(missing) = wanted.iter().find(is_there) {
            let names = named(there.iter().map(|name| format!("{name:?}")));
            return Err(Problem::Other(format!(
                "no layer {missing:?}; there are {names}"
            )));
        }
        let (mut domain, loose) = self.assembly.finish();
        let notes = &mut domain.vertices.notes;
        if there.len() > 1 && !there.iter().all(|name| marker_of(name).is_some()) {
            let names = there
                .iter()
                .enumerate()
                .map(|(i, name)| format!("{} {name:?}", i + 1));
            notes.push(format!("markers of segments are layers: {}", named(names)));
        }
        let is_read = |name: &&String| {
            let is_wanted = wanted.is_empty() || wanted.iter().any(|w| is_same(w, name));
            is_wanted && there.iter().any(|layer| is_same(layer, name))
        };
        let hidden: Vec<_> = self.drawing.hidden.iter().filter(is_read).collect();
        if !hidden.is_empty() {
            let names = named(hidden.into_iter().map(|name| format!("{name:?}")));
            notes.push(format!(
                "read although frozen or off, as --layer does not say otherwise: {names}"
            ));
        }
        if !self.left_out.is_empty() {
            let counts = self.left_out.iter().map(|(what, n)| format!("{n} {what}"));
            notes.push(format!(
                "left out: {}",
                words::list(&counts.collect::<Vec<_>>())
            ));
        }
        if loose > 0 && domain.usual_rule == DomainRule::Hull {
            let places = words::counted(loose, "place", "places");
            notes.push(format!(
                "lines end loosely in {places}, so they bound nothing: the domain is the hull, unless --domain says otherwise"
            ));
        }
        Ok(domain)
    }
}

fn is_same(a: &str, b: &str) -> bool {
    a.to_uppercase() == b.to_uppercase()
}

/// Joins names, if they are not too many.
fn named(names: impl ExactSizeIterator<Item = String>) -> String {
    let further = names.len().saturating_sub(MAX_NAMED);
    let mut names: Vec<_> = names.take(MAX_NAMED).collect();
    names.extend((further > 0).then(|| format!("{further} more")));
    match names.is_empty() {
        true => "none".to_owned(),
        false => names.join(", "),
    }
}

fn too_many_copies(at: u64) -> Stop {
    let text = "the drawing is too large: blocks are inserted too often, or curves are cut too finely; insert \
                fewer copies, or choose a larger --flatness";
    Stop::Wrong((at, Problem::Other(text.to_owned())))
}
