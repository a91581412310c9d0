//! Reading: a walk over the elements that collects the arrays.

use super::array::{Appended, ArrayHead, attribute};
use super::grid::{Data, Grid};
use super::packed::{Budget, Encoding};
use super::{Stop, other};
use crate::{Error, MeshData, Place, Problem, scan};
use delone::{Phase, Watch};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;

/// Elements whose arrays are read.
const SECTIONS: [&[u8]; 4] = [b"Points", b"Cells", b"PointData", b"CellData"];

/// The one way of compression that is understood.
const ZLIB: &str = "vtkZLibDataCompressor";

/// Tells whether the bytes begin like a VTK file.
pub(crate) fn sniff(head: &[u8]) -> bool {
    memchr::memmem::find(head, b"<VTKFile").is_some()
}

/// Reads points, triangles and the data that go with them.
pub(crate) fn read_mesh(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<MeshData, Error> {
    let at = |place: Place, stop| match stop {
        Stop::Cancelled => Error::Cancelled,
        Stop::Problem(problem) => Error::Malformed {
            file: file.to_owned(),
            place,
            problem,
        },
    };
    if bytes.trim_ascii().is_empty() {
        return Err(at(Place::File, Problem::Empty.into()));
    }
    let (elements, tail) = part(bytes);
    let mut reader = Reader::from_reader(elements);
    let mut walk = Walk::new(tail, bytes.len(), watch);
    let outcome = walk.read(&mut reader);
    outcome.map_err(|stop| at(Place::Byte(reader.buffer_position()), stop))?;
    let mesh = walk.grid.into_mesh(watch);
    mesh.map_err(|stop| at(Place::File, stop))
}

/// Parts the elements from what is appended behind them: that may be bytes, which are no XML.
fn part(bytes: &[u8]) -> (&[u8], Option<Tail<'_>>) {
    let Some(start) = memchr::memmem::find(bytes, b"<AppendedData") else {
        return (bytes, None);
    };
    let end = memchr::memchr(b'>', &bytes[start..]);
    let end = end.map_or(bytes.len(), |end| start + end + 1);
    let (element, rest) = (&bytes[start..end], &bytes[end..]);
    // The data begin behind an underscore.
    let begin = memchr::memchr(b'_', rest).map_or(rest.len(), |place| place + 1);
    let closing = memchr::memmem::rfind(rest, b"</AppendedData");
    let data = rest
        .get(begin..closing.unwrap_or(rest.len()))
        .unwrap_or(&[]);
    let is_raw = memchr::memmem::find(element, b"raw").is_some();
    let behind = &rest[closing.unwrap_or(rest.len())..];
    let tail = Tail {
        is_complete: memchr::memmem::find(behind, b"</VTKFile").is_some(),
        data: Appended {
            bytes: if is_raw { data } else { data.trim_ascii_end() },
            is_raw,
        },
    };
    (&bytes[..end], Some(tail))
}

/// What stands behind the elements.
#[derive(Clone, Copy)]
struct Tail<'a> {
    data: Appended<'a>,
    /// Whether the root element is closed behind it.
    is_complete: bool,
}

/// Where in the file the reader stands, and what it has collected.
struct Walk<'a, 'w> {
    watch: &'w dyn Watch,
    encoding: Encoding,
    budget: Budget,
    tail: Option<Tail<'a>>,
    grid: Grid,
    pieces: usize,
    /// The section that arrays belong to, empty outside of all.
    section: &'static [u8],
    /// The array whose element is open.
    array: Option<OpenArray<'a>>,
    /// Whether the root element has been closed.
    complete: bool,
}

/// An array whose text is being gathered.
struct OpenArray<'a> {
    head: ArrayHead,
    text: Cow<'a, [u8]>,
    /// Elements open within it; what they hold is about the array, not of it.
    depth: usize,
}

impl<'a> OpenArray<'a> {
    /// Adds text; a comment may have parted it from what is there already.
    fn gather(&mut self, text: Cow<'a, [u8]>) {
        if self.depth > 0 {
        } else if self.text.is_empty() {
            self.text = text;
        } else {
            self.text.to_mut().extend_from_slice(&text);
        }
    }
}

impl<'a, 'w> Walk<'a, 'w> {
    fn new(tail: Option<Tail<'a>>, size: usize, watch: &'w dyn Watch) -> Self {
        Self {
            watch,
            encoding: Encoding::default(),
            budget: Budget::of_file(size),
            tail,
            grid: Grid::default(),
            pieces: 0,
            section: b"",
            array: None,
            complete: false,
        }
    }

    fn read(&mut self, reader: &mut Reader<&'a [u8]>) -> Result<(), Stop> {
        let total = reader.get_ref().len() as u64;
        loop {
            if self.watch.is_cancelled() {
                return Err(Stop::Cancelled);
            }
            self.watch
                .progress(Phase::Read, reader.buffer_position(), total);
            let event = reader
                .read_event()
                .map_err(|e| other(format!("broken XML: {e}")))?;
            match event {
                Event::Start(start) => self.open(&start)?,
                Event::Empty(start) => {
                    self.open(&start)?;
                    self.close(start.name().as_ref())?;
                }
                Event::End(end) => self.close(end.name().as_ref())?,
                Event::Text(text) => self.gather(text.into_inner()),
                Event::CData(text) => self.gather(text.into_inner()),
                Event::GeneralRef(_) => self.refuse_reference()?,
                Event::Eof => return self.finish().map_err(Stop::from),
                Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::DocType(_) => {}
            }
        }
    }

    /// Enters an element.
    fn open(&mut self, start: &BytesStart<'_>) -> Result<(), Problem> {
        if let Some(array) = &mut self.array {
            array.depth += 1;
            return Ok(());
        }
        match start.name().as_ref() {
            b"VTKFile" => self.root(start)?,
            b"Piece" => self.piece(start)?,
            // Nothing but this follows.
            b"AppendedData" => self.complete = self.tail.is_some_and(|tail| tail.is_complete),
            b"DataArray" if !self.section.is_empty() => {
                self.array = Some(OpenArray {
                    head: ArrayHead::read(start)?,
                    text: Cow::Borrowed(b""),
                    depth: 0,
                });
            }
            name => {
                if let Some(section) = SECTIONS.into_iter().find(|s| *s == name) {
                    self.section = section;
                }
            }
        }
        Ok(())
    }

    /// Leaves an element; an array is decoded when all its text is there.
    fn close(&mut self, name: &[u8]) -> Result<(), Stop> {
        if let Some(array) = self.array.as_mut().filter(|array| array.depth > 0) {
            array.depth -= 1;
        } else if let Some(OpenArray { head, text, .. }) = self.array.take() {
            let data = head.decode(
                self.encoding,
                &text,
                self.tail.map(|tail| tail.data),
                &mut self.budget,
                self.watch,
            )?;
            self.keep(data)?;
        } else if name == self.section {
            self.section = b"";
        } else if name == b"VTKFile" {
            self.complete = true;
        }
        Ok(())
    }

    /// Keeps an array, if it is one that a mesh needs.
    fn keep(&mut self, data: Data) -> Result<(), Problem> {
        match (self.section, data.name.as_str()) {
            (b"Points", _) if data.components == 3 => self.grid.points = data.values,
            (b"Points", _) => return Err(other("points must have 3 components")),
            (b"Cells", "connectivity") => self.grid.connectivity = data.values,
            (b"Cells", "offsets") => self.grid.offsets = data.values,
            (b"Cells", "types") => self.grid.types = data.values,
            (b"PointData", _) => self.grid.add_point_data(data)?,
            (b"CellData", _) => self.grid.add_cell_data(data)?,
            _ => {}
        }
        Ok(())
    }

    fn gather(&mut self, text: Cow<'a, [u8]>) {
        if let Some(array) = &mut self.array {
            array.gather(text);
        }
    }

    /// References such as `&#32;` have no business among numbers; dropping one could join two.
    fn refuse_reference(&self) -> Result<(), Problem> {
        match &self.array {
            Some(array) if array.depth == 0 => Err(other("broken XML: a reference among numbers")),
            _ => Ok(()),
        }
    }

    fn root(&mut self, start: &BytesStart<'_>) -> Result<(), Problem> {
        if let Some(kind) = attribute(start, "type")?
            && kind != "UnstructuredGrid"
        {
            return Err(other(format!(
                "VTK type {kind}: only UnstructuredGrid is understood"
            )));
        }
        let compressor = attribute(start, "compressor")?;
        if let Some(other_one) = compressor.as_deref().filter(|c| *c != ZLIB) {
            return Err(other(format!(
                "data are compressed by {other_one}: only {ZLIB} is understood; write with that, or without \
                 compression"
            )));
        }
        self.encoding = Encoding {
            compressed: compressor.is_some(),
            big_endian: attribute(start, "byte_order")?.as_deref() == Some("BigEndian"),
            wide_counts: attribute(start, "header_type")?.as_deref() == Some("UInt64"),
        };
        Ok(())
    }

    fn piece(&mut self, start: &BytesStart<'_>) -> Result<(), Problem> {
        self.pieces += 1;
        self.grid.declared_points = count(start, "NumberOfPoints")?;
        self.grid.declared_cells = count(start, "NumberOfCells")?;
        Ok(())
    }

    fn finish(&self) -> Result<(), Problem> {
        match self.pieces {
            _ if !self.complete => Err(other("truncated: the file ends before </VTKFile>")),
            0 => Err(other("no <Piece> of an unstructured grid in the file")),
            1 => Ok(()),
            n => Err(other(format!(
                "{n} pieces: only one is understood; merge them"
            ))),
        }
    }
}

/// Reads a count from an attribute of an element, if it has it.
fn count(start: &BytesStart<'_>, key: &str) -> Result<Option<u64>, Problem> {
    let Some(text) = attribute(start, key)? else {
        return Ok(None);
    };
    let count = text.trim().parse().map_err(|_| Problem::NotANumber {
        what: key.to_owned(),
        text: scan::show(text.as_bytes()),
    })?;
    Ok(Some(count))
}
