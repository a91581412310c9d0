//! Elements, sorted by kind.

use super::assemble::Parts;
use super::entities::Entities;
use super::nodes::Nodes;
use super::read::{Reader, Version};
use super::{LINE, POINT, QUADRATIC_LINE, QUADRATIC_TRIANGLE, TRIANGLE};
use crate::{Error, topology};
use std::collections::BTreeMap;

/// An element with `N` corners.
#[derive(Clone, Copy)]
pub(super) struct Element<const N: usize> {
    pub tag: u64,
    pub corners: [u32; N],
    /// Its list among [`Groupings`].
    pub groups: u32,
}

/// The lists of physical groups that elements have; the first is empty.
pub(super) struct Groupings {
    lists: Vec<Vec<i32>>,
    indices: BTreeMap<Vec<i32>, u32>,
    /// The list asked for last, which is most often asked for next.
    last: u32,
}

impl Default for Groupings {
    fn default() -> Self {
        Self {
            lists: vec![Vec::new()],
            indices: BTreeMap::from([(Vec::new(), 0)]),
            last: 0,
        }
    }
}

impl Groupings {
    /// Returns a list.
    pub fn list(&self, index: u32) -> &[i32] {
        &self.lists[index as usize]
    }

    /// Tells whether there is no group at all.
    pub fn is_empty(&self) -> bool {
        self.lists.len() == 1
    }

    /// Returns the index of a list.
    fn index(&mut self, list: &[i32]) -> u32 {
        if self.list(self.last) != list {
            self.last = match self.indices.get(list) {
                Some(&index) => index,
                None => {
                    let index = self.lists.len() as u32;
                    self.lists.push(list.to_vec());
                    self.indices.insert(list.to_vec(), index);
                    index
                }
            };
        }
        self.last
    }
}

/// Reads the section into points, lines and triangles.
pub(super) fn read(
    reader: &mut Reader<'_>,
    nodes: &Nodes,
    entities: &Entities,
    parts: &mut Parts,
) -> Result<(), Error> {
    let mut taker = Taker { nodes, parts };
    match reader.version {
        Version::V2 if reader.is_binary => read_2_binary(reader, &mut taker)?,
        Version::V2 => read_2(reader, &mut taker)?,
        Version::V40 | Version::V41 => read_4(reader, entities, &mut taker)?,
    }
    topology::check_num_triangles(parts.triangles.len())
}

fn read_2(reader: &mut Reader<'_>, taker: &mut Taker<'_>) -> Result<(), Error> {
    for _ in 0..reader.section_size("elements")? {
        let tag = reader.wide_tag("element")?;
        let kind = reader.int("the type of an element")?;
        let num_tags = reader.size("tags of an element")?;
        let group = tags_2(reader, num_tags)?;
        let groups = taker.group(group);
        taker.take(reader, kind, tag, groups)?;
    }
    Ok(())
}

fn read_2_binary(reader: &mut Reader<'_>, taker: &mut Taker<'_>) -> Result<(), Error> {
    let declared = reader.section_size("elements")?;
    let mut read = 0;
    while read < declared {
        let kind = reader.int("the type of elements")?;
        let count = reader.size("elements in a block")?;
        let num_tags = reader.size("tags of an element")?;
        for _ in 0..count {
            let tag = reader.wide_tag("element")?;
            let group = tags_2(reader, num_tags)?;
            let groups = taker.group(group);
            taker.take(reader, kind, tag, groups)?;
        }
        read = read.saturating_add(count);
    }
    Ok(())
}

/// Reads the tags of an element, and returns its group; 0 is none. A minus says that it is turned round.
fn tags_2(reader: &mut Reader<'_>, count: u64) -> Result<i32, Error> {
    let mut group = 0;
    for i in 0..count {
        let tag = reader.tag("a tag of an element")?;
        if i == 0 {
            group = tag.saturating_abs();
        }
    }
    Ok(group)
}

fn read_4(
    reader: &mut Reader<'_>,
    entities: &Entities,
    taker: &mut Taker<'_>,
) -> Result<(), Error> {
    let blocks = reader.size("blocks of elements")?;
    let declared = reader.size("elements")?;
    let is_41 = reader.version == Version::V41;
    if is_41 {
        reader.size("the least tag of an element")?;
        reader.size("the largest tag of an element")?;
    }
    let mut read = 0u64;
    let mut known = BTreeMap::new();
    for _ in 0..blocks {
        let first = reader.tag("an entity")?;
        let second = reader.tag("an entity")?;
        let (dimension, entity) = if is_41 {
            (first, second)
        } else {
            (second, first)
        };
        let kind = reader.int("the type of elements")?;
        let count = reader.size("elements in a block")?;
        let groups = *known.entry((dimension, entity)).or_insert_with(|| {
            let groups = entities.groups(dimension.into(), entity).iter();
            let groups: Vec<i32> = groups.map(|g| g.saturating_abs()).collect();
            taker.parts.groupings.index(&groups)
        });
        for _ in 0..count {
            let tag = reader.wide_tag("element")?;
            taker.take(reader, kind, tag, groups)?;
        }
        read = read.saturating_add(count);
    }
    if read != declared {
        let text = format!("the section declares {declared} elements, its blocks hold {read}");
        return Err(reader.cursor.refuse(text));
    }
    Ok(())
}

/// Takes elements as they come.
struct Taker<'a> {
    nodes: &'a Nodes,
    parts: &'a mut Parts,
}

impl Taker<'_> {
    fn group(&mut self, group: i32) -> u32 {
        match group {
            0 => 0,
            group => self.parts.groupings.index(&[group]),
        }
    }

    /// Reads the nodes of an element and keeps it.
    fn take(
        &mut self,
        reader: &mut Reader<'_>,
        kind: i64,
        tag: u64,
        groups: u32,
    ) -> Result<(), Error> {
        match kind {
            POINT => {
                let corners = self.corners(reader, tag)?;
                self.parts.points.push(Element {
                    tag,
                    corners,
                    groups,
                });
            }
            LINE | QUADRATIC_LINE => {
                let corners = self.corners(reader, tag)?;
                self.parts.lines.push(Element {
                    tag,
                    corners,
                    groups,
                });
                if kind == QUADRATIC_LINE {
                    let middles = self.corners::<1>(reader, tag)?;
                    self.parts.middles.extend(middles);
                }
            }
            TRIANGLE | QUADRATIC_TRIANGLE => {
                let corners = self.corners(reader, tag)?;
                self.parts.triangles.push(Element {
                    tag,
                    corners,
                    groups,
                });
                if kind == QUADRATIC_TRIANGLE {
                    let middles = self.corners::<3>(reader, tag)?;
                    self.parts.middles.extend(middles);
                    self.parts.num_quadratic += 1;
                }
            }
            _ => {
                let name = name(kind);
                return Err(reader.cursor.refuse(format!(
                    "element {tag} is {name} (type {kind}); only points, lines and triangles, of three or six \
                     nodes, are understood"
                )));
            }
        }
        Ok(())
    }

    /// Reads nodes of an element.
    fn corners<const N: usize>(
        &self,
        reader: &mut Reader<'_>,
        element: u64,
    ) -> Result<[u32; N], Error> {
        let mut corners = [0; N];
        for corner in &mut corners {
            let tag = reader.wide_tag("node of an element")?;
            let Some(place) = self.nodes.find(tag) else {
                let text = format!("element {element} names node {tag}, which is not there");
                return Err(reader.cursor.refuse(text));
            };
            *corner = place;
        }
        Ok(corners)
    }
}

/// Says what elements of a type are.
fn name(kind: i64) -> &'static str {
    match kind {
        3 | 10 | 16 | 36..=39 => "a quadrangle",
        4 | 11 | 29..=31 => "a tetrahedron",
        5 | 12 | 17 | 92 | 93 => "a hexahedron",
        6 | 13 | 18 | 90 | 91 => "a prism",
        7 | 14 | 19 => "a pyramid",
        20..=25 => "a triangle of higher order",
        26..=28 => "a line of higher order",
        _ => "of another kind",
    }
}
