//! Reading: a walk over the sections of a file.

use super::assemble::Parts;
use super::entities::{Entities, PhysicalNames};
use super::nodes::Nodes;
use super::{elements, nodes};
use crate::cursor::{Cursor, signed};
use crate::{Error, MeshData, Problem, ReadOptions, scan};
use delone::Watch;

/// The version of a file, as far as layouts differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Version {
    V2,
    V40,
    V41,
}

/// A file whose header has been read.
pub(super) struct Reader<'a> {
    pub cursor: Cursor<'a>,
    pub version: Version,
    pub is_binary: bool,
    /// Bytes of a `size_t`.
    size_width: usize,
}

impl<'a> Reader<'a> {
    /// Reads an `int`.
    pub fn int(&mut self, what: &'static str) -> Result<i64, Error> {
        match self.is_binary {
            true => Ok(signed(self.cursor.bits(4, what)?, 4)),
            false => self.cursor.text_integer(what),
        }
    }

    /// Reads a tag, which fits 32 bits.
    pub fn tag(&mut self, what: &'static str) -> Result<i32, Error> {
        let tag = self.int(what)?;
        i32::try_from(tag).map_err(|_| {
            self.cursor
                .refuse(format!("{what} {tag} does not fit 32 bits"))
        })
    }

    /// Reads a `size_t`; in version 2 that is an `int`.
    pub fn size(&mut self, what: &'static str) -> Result<u64, Error> {
        if self.version == Version::V2 || !self.is_binary {
            let size = self.int(what)?;
            return u64::try_from(size).map_err(|_| self.cursor.negative(what, size));
        }
        self.cursor.bits(self.size_width, what)
    }

    /// Reads how many nodes or elements a section has; in version 2 that is text, even before bytes.
    pub fn section_size(&mut self, what: &'static str) -> Result<u64, Error> {
        if self.version != Version::V2 {
            return self.size(what);
        }
        let size = self.cursor.text_count(what)?;
        if self.is_binary {
            self.cursor.line();
        }
        Ok(size)
    }

    /// Reads a tag of a node or an element: a `size_t` since 4.1, an `int` before.
    pub fn wide_tag(&mut self, what: &'static str) -> Result<u64, Error> {
        if self.version == Version::V41 {
            return self.size(what);
        }
        let tag = self.int(what)?;
        u64::try_from(tag).map_err(|_| self.cursor.refuse(format!("{what} {tag} is negative")))
    }

    /// Reads a `double`.
    pub fn double(&mut self, what: &'static str) -> Result<f64, Error> {
        match self.is_binary {
            true => Ok(f64::from_bits(self.cursor.bits(8, what)?)),
            false => self.cursor.text_number(what),
        }
    }

    /// Reads numbers to get behind them.
    pub fn skip_doubles(&mut self, count: usize) -> Result<(), Error> {
        (0..count).try_for_each(|_| self.double("a number").map(drop))
    }

    /// Reads as many tags as a count before them says.
    pub fn tags(&mut self, what: &'static str) -> Result<Vec<i32>, Error> {
        let count = self.size(what)?;
        let mut tags = Vec::new();
        self.cursor.reserve(&mut tags, 2, count);
        for _ in 0..count {
            tags.push(self.tag(what)?);
        }
        Ok(tags)
    }
}

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut cursor = Cursor::new(file, bytes, watch);
    if bytes.trim_ascii().is_empty() {
        return Err(cursor.fail_whole(Problem::Empty));
    }
    while let Some(section) = section(&mut cursor)? {
        if section == b"MeshFormat" {
            let mut reader = format(cursor)?;
            let parts = Sections::default().read(&mut reader)?;
            return parts.into_mesh(&reader.cursor);
        }
        if section == b"NOD" {
            return Err(cursor.refuse(
                "version 1 is not understood; let Gmsh save the mesh as version 2.2 or 4.1",
            ));
        }
        skip(&mut cursor, section)?;
    }
    Err(cursor.fail_whole(Problem::Other("no $MeshFormat".to_owned())))
}

/// Returns the name of the section that begins next; `None` at the end.
fn section<'a>(cursor: &mut Cursor<'a>) -> Result<Option<&'a [u8]>, Error> {
    let Some(word) = cursor.word()? else {
        return Ok(None);
    };
    match word.strip_prefix(b"$") {
        Some(name) if !name.starts_with(b"End") => {
            cursor.line();
            Ok(Some(name))
        }
        _ => Err(cursor.refuse(format!(
            "expected a section such as $Nodes, found {:?}",
            scan::show(word)
        ))),
    }
}

/// Goes behind a section.
fn skip(cursor: &mut Cursor<'_>, name: &[u8]) -> Result<(), Error> {
    let end = [b"$End", name].concat();
    match cursor.seek_behind(&end) {
        true => Ok(()),
        false => {
            let end = scan::show(&end);
            Err(cursor.fail_whole(Problem::Other(format!(
                "truncated: the file ends before {end}"
            ))))
        }
    }
}

/// Reads what the file says about itself.
fn format(mut cursor: Cursor<'_>) -> Result<Reader<'_>, Error> {
    let number = cursor.need_word("the version")?;
    let version = match number {
        b"2" | b"2.0" | b"2.1" | b"2.2" => Version::V2,
        b"4" | b"4.0" => Version::V40,
        b"4.1" => Version::V41,
        _ => {
            let version = scan::show(number);
            return Err(cursor.refuse(format!(
                "version {version}: only 2.2, 4.0 and 4.1 are understood; let Gmsh save it anew"
            )));
        }
    };
    let kind = cursor.text_integer("the type of the file")?;
    if !(0..=1).contains(&kind) {
        let what = format!("type {kind} of file: 0 is text, 1 bytes, others are not understood");
        return Err(cursor.refuse(what));
    }
    let size_width = cursor.text_integer("the size of data")?;
    if ![4, 8].contains(&size_width) {
        let what =
            format!("data size {size_width}: only 8 is understood, and 4 for numbers of nodes");
        return Err(cursor.refuse(what));
    }
    let is_binary = kind == 1;
    if is_binary {
        cursor.line();
        cursor.in_bytes = true;
        cursor.big_endian = match cursor.take(4, "the number one")? {
            [1, 0, 0, 0] => false,
            [0, 0, 0, 1] => true,
            _ => {
                return Err(
                    cursor.refuse("broken: the header should have the number one in four bytes")
                );
            }
        };
    }
    let mut reader = Reader {
        cursor,
        version,
        is_binary,
        size_width: size_width as usize,
    };
    end(&mut reader, b"MeshFormat")?;
    Ok(reader)
}

/// Requires that a section ends here.
fn end(reader: &mut Reader<'_>, name: &[u8]) -> Result<(), Error> {
    let expected = [b"$End", name].concat();
    let found = reader.cursor.word()?;
    if found == Some(&expected) {
        return Ok(());
    }
    let expected = scan::show(&expected);
    Err(reader.cursor.refuse(match found {
        Some(word) => format!("expected {expected}, found {:?}", scan::show(word)),
        None => format!("truncated: the file ends before {expected}"),
    }))
}

/// What the sections read so far hold.
#[derive(Default)]
struct Sections {
    names: PhysicalNames,
    entities: Entities,
    nodes: Option<Nodes>,
    parts: Parts,
}

impl Sections {
    fn read(mut self, reader: &mut Reader<'_>) -> Result<Parts, Error> {
        let mut has_elements = false;
        while let Some(name) = section(&mut reader.cursor)? {
            let is_second = match name {
                b"Nodes" | b"ParametricNodes" => self.nodes.is_some(),
                b"Elements" => std::mem::replace(&mut has_elements, true),
                _ => false,
            };
            if is_second {
                // Gmsh puts the mesh before the data once more when it adds data to a file.
                self.note("of several meshes only the first is kept");
                skip(&mut reader.cursor, name)?;
                continue;
            }
            match name {
                b"PhysicalNames" => self.names.read(&mut reader.cursor)?,
                b"Entities" => self.entities.read(reader)?,
                b"PartitionedEntities" => {
                    self.entities.read_partitioned(reader)?;
                    self.note("partitions are not kept");
                }
                b"Nodes" => self.nodes = Some(nodes::read(reader, false)?),
                b"ParametricNodes" => self.nodes = Some(nodes::read(reader, true)?),
                b"Elements" => {
                    let Some(nodes) = &self.nodes else {
                        return Err(reader.cursor.refuse("$Elements before $Nodes"));
                    };
                    elements::read(reader, nodes, &self.entities, &mut self.parts)?;
                }
                b"NodeData" => self.parts.node_data.read(reader)?,
                b"ElementData" => self.parts.element_data.read(reader)?,
                b"ElementNodeData" => self.note("data of nodes of elements are not kept"),
                b"Periodic" => self.note("periodic links are not kept"),
                _ => {}
            }
            match name {
                // Whatever the others hold, it is passed over.
                b"PhysicalNames"
                | b"Entities"
                | b"PartitionedEntities"
                | b"Nodes"
                | b"ParametricNodes"
                | b"Elements"
                | b"NodeData"
                | b"ElementData" => {
                    end(reader, name)?;
                }
                name => skip(&mut reader.cursor, name)?,
            }
        }
        let Some(nodes) = self.nodes else {
            let none = Problem::Other("no $Nodes".to_owned());
            return Err(reader.cursor.fail_whole(none));
        };
        Ok(Parts {
            nodes,
            names: self.names,
            ..self.parts
        })
    }

    fn note(&mut self, what: &str) {
        let notes = &mut self.parts.notes;
        if !notes.iter().any(|note| note == what) {
            notes.push(what.to_owned());
        }
    }
}
