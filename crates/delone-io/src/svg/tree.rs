//! The elements of a picture, as far as they matter.

use crate::{Problem, cancel};
use delone::{Phase, Watch};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::collections::HashMap;

/// The attributes that matter.
const ATTRIBUTES: [&[u8]; 25] = [
    b"d",
    b"points",
    b"transform",
    b"style",
    b"display",
    b"id",
    b"href",
    b"xlink:href",
    b"viewBox",
    b"preserveAspectRatio",
    b"x",
    b"y",
    b"x1",
    b"y1",
    b"x2",
    b"y2",
    b"cx",
    b"cy",
    b"r",
    b"rx",
    b"ry",
    b"width",
    b"height",
    b"clip-path",
    b"mask",
];

/// Deepest nesting of elements.
pub(super) const MAX_DEPTH: usize = 256;

/// An element.
pub(super) struct Element {
    /// Its name, without the prefix of SVG.
    pub name: Vec<u8>,
    attributes: Vec<(&'static [u8], Vec<u8>)>,
    pub children: Vec<usize>,
    /// Where it begins in the file.
    pub at: usize,
}

impl Element {
    /// Returns an attribute, if it is there.
    pub fn get(&self, name: &str) -> Option<&[u8]> {
        let found = self.attributes.iter().find(|(n, _)| *n == name.as_bytes());
        found.map(|(_, value)| &value[..])
    }

    /// Tells whether neither the element nor what is in it is shown.
    pub fn is_hidden(&self) -> bool {
        let style = self.get("style").unwrap_or_default();
        let in_style = style.split(|b| *b == b';').any(|rule| {
            let mut parts = rule.splitn(2, |b| *b == b':').map(<[u8]>::trim_ascii);
            parts.next() == Some(b"display") && parts.next() == Some(b"none")
        });
        in_style || self.get("display") == Some(b"none")
    }
}

/// A picture: its elements, the first of which is the root.
#[derive(Default)]
pub(super) struct Tree {
    pub elements: Vec<Element>,
    pub ids: HashMap<Vec<u8>, usize>,
}

/// Why reading stopped early: at this byte, or cancelled.
pub(super) enum Stop {
    Wrong(usize, Problem),
    Cancelled,
}

/// Reads a picture. Entities of a document type are not expanded.
pub(super) fn read(bytes: &[u8], watch: &dyn Watch) -> Result<Tree, Stop> {
    let mut reader = Reader::from_reader(bytes);
    let mut tree = Tree::default();
    let mut open: Vec<usize> = Vec::new();
    for round in 0.. {
        cancel::check(watch, round).map_err(|_| Stop::Cancelled)?;
        let at = reader.buffer_position() as usize;
        if round % 4096 == 0 {
            watch.progress(Phase::Read, at as u64, bytes.len() as u64);
        }
        let event = reader.read_event();
        let event = event.map_err(|error| {
            let at = reader.error_position() as usize;
            Stop::Wrong(at, Problem::Other(format!("broken XML: {error}")))
        })?;
        match event {
            Event::Start(start) => {
                let element = tree.add(start, &open, at)?;
                open.push(element);
            }
            Event::Empty(start) => drop(tree.add(start, &open, at)?),
            Event::End(_) => drop(open.pop()),
            Event::Eof if !open.is_empty() || tree.elements.is_empty() => {
                let problem = match tree.elements.is_empty() {
                    true => Problem::Other("there is no element in the file".to_owned()),
                    false => {
                        Problem::Other("truncated: the file ends within an element".to_owned())
                    }
                };
                return Err(Stop::Wrong(at, problem));
            }
            Event::Eof => break,
            _ => {}
        }
    }
    match &tree.elements[0].name[..] {
        b"svg" => Ok(tree),
        name => {
            let name = String::from_utf8_lossy(name).into_owned();
            let text = format!("the root element is {name:?}, not svg");
            Err(Stop::Wrong(tree.elements[0].at, Problem::Other(text)))
        }
    }
}

impl Tree {
    fn add(&mut self, start: BytesStart<'_>, open: &[usize], at: usize) -> Result<usize, Stop> {
        let wrong = |text: String| Stop::Wrong(at, Problem::Other(text));
        if open.len() == MAX_DEPTH {
            return Err(wrong(format!(
                "elements in elements, deeper than {MAX_DEPTH}"
            )));
        }
        let mut attributes = Vec::new();
        for attribute in start.attributes() {
            let attribute = attribute.map_err(|error| wrong(format!("broken XML: {error}")))?;
            let key = attribute.key.as_ref();
            if let Some(known) = ATTRIBUTES.iter().find(|known| **known == key) {
                let value = match memchr::memchr(b'&', &attribute.value) {
                    None => attribute.value.into_owned(),
                    Some(_) => match attribute.unescape_value() {
                        Ok(value) => value.into_owned().into_bytes(),
                        Err(error) => return Err(wrong(format!("broken XML: {error}"))),
                    },
                };
                attributes.push((*known, value));
            }
        }
        let index = self.elements.len();
        let qualified = start.name();
        let name = qualified.as_ref();
        let element = Element {
            name: name.strip_prefix(b"svg:").unwrap_or(name).to_vec(),
            attributes,
            children: Vec::new(),
            at,
        };
        if let Some(id) = element.get("id") {
            self.ids.entry(id.to_vec()).or_insert(index);
        }
        if let Some(&parent) = open.last() {
            self.elements[parent].children.push(index);
        }
        self.elements.push(element);
        Ok(index)
    }
}
