//! Nodes, in the order of their tags.

use super::read::{Reader, Version};
use crate::{Error, Problem, cancel, node};
use delone::{Point, Watch};

/// The nodes of a file.
#[derive(Default)]
pub(super) struct Nodes {
    /// Tags, ascending.
    tags: Vec<u64>,
    pub points: Vec<Point>,
    pub heights: Vec<f64>,
    /// Whether tags have no gaps.
    is_dense: bool,
}

impl Nodes {
    /// Returns the place of a node.
    pub fn find(&self, tag: u64) -> Option<u32> {
        let place = match (self.is_dense, self.tags.first()) {
            (true, Some(&first)) => {
                let place = tag.checked_sub(first)?;
                (place < self.tags.len() as u64).then_some(place as usize)?
            }
            _ => self.tags.binary_search(&tag).ok()?,
        };
        Some(place as u32)
    }

    /// Returns the tag of a node.
    pub fn tag(&self, place: u32) -> u64 {
        self.tags[place as usize]
    }

    /// Tells whether nodes are numbered 1, 2, 3 …
    pub fn is_numbered(&self) -> bool {
        self.is_dense && self.tags.first() == Some(&1)
    }

    /// Sorts rows of tag, x, y, z.
    fn new(mut rows: Vec<(u64, [f64; 3])>, watch: &dyn Watch) -> Result<Self, Stop> {
        if rows.len() as u64 > node::MAX_POINTS {
            return Err(node::too_many(rows.len() as u64).into());
        }
        if !rows.is_sorted_by_key(|row| row.0) {
            rows.sort_by_key(|row| row.0);
        }
        let mut nodes = Self::default();
        let mut last = None;
        for (i, (tag, [x, y, z])) in rows.into_iter().enumerate() {
            cancel::check(watch, i).map_err(Stop::Cancelled)?;
            if last == Some(tag) {
                return Err(Problem::Other(format!("node {tag} is there twice")).into());
            }
            last = Some(tag);
            if let Some((axis, value)) = [('x', x), ('y', y)].into_iter().find(|c| !c.1.is_finite())
            {
                let (index, text) = (tag, value.to_string());
                return Err(Problem::NotFinite { index, axis, text }.into());
            }
            nodes.tags.push(tag);
            nodes.points.push(Point::new(x, y));
            nodes.heights.push(z);
        }
        let ends = nodes.tags.first().zip(nodes.tags.last());
        nodes.is_dense = ends.is_some_and(|(a, b)| b - a == nodes.tags.len() as u64 - 1);
        Ok(nodes)
    }
}

/// Why nodes are refused.
enum Stop {
    Problem(Problem),
    Cancelled(Error),
}

impl From<Problem> for Stop {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem)
    }
}

/// Reads the section; parameters of nodes on curves and surfaces are passed over.
pub(super) fn read(reader: &mut Reader<'_>, is_parametric: bool) -> Result<Nodes, Error> {
    let rows = match reader.version {
        Version::V2 => read_2(reader, is_parametric)?,
        Version::V40 | Version::V41 => read_4(reader)?,
    };
    Nodes::new(rows, reader.cursor.watch()).map_err(|stop| match stop {
        Stop::Problem(problem) => reader.cursor.fail_whole(problem),
        Stop::Cancelled(error) => error,
    })
}

type Rows = Vec<(u64, [f64; 3])>;

fn read_2(reader: &mut Reader<'_>, is_parametric: bool) -> Result<Rows, Error> {
    let declared = reader.section_size("nodes")?;
    let mut rows = Rows::new();
    reader.cursor.reserve(&mut rows, 8, declared);
    for _ in 0..declared {
        let tag = reader.wide_tag("node")?;
        rows.push((tag, place(reader)?));
        if is_parametric {
            let dimension = reader.int("the dimension of an entity")?;
            reader.int("the tag of an entity")?;
            let parameters = if (1..=2).contains(&dimension) {
                dimension
            } else {
                0
            };
            reader.skip_doubles(parameters as usize)?;
        }
    }
    Ok(rows)
}

fn read_4(reader: &mut Reader<'_>) -> Result<Rows, Error> {
    let blocks = reader.size("blocks of nodes")?;
    let declared = reader.size("nodes")?;
    let is_41 = reader.version == Version::V41;
    if is_41 {
        reader.size("the least tag of a node")?;
        reader.size("the largest tag of a node")?;
    }
    let mut rows = Rows::new();
    reader.cursor.reserve(&mut rows, 8, declared);
    let mut tags = Vec::new();
    for _ in 0..blocks {
        // Before 4.1 the tag comes before the dimension.
        let first = reader.int("an entity")?;
        let second = reader.int("an entity")?;
        let dimension = if is_41 { first } else { second };
        let parameters = match reader.int("whether nodes have parameters")? {
            0 => 0,
            _ => dimension.clamp(0, 3) as usize,
        };
        let count = reader.size("nodes in a block")?;
        if is_41 {
            tags.clear();
            for _ in 0..count {
                tags.push(reader.wide_tag("node")?);
            }
            for &tag in &tags {
                rows.push((tag, place(reader)?));
                reader.skip_doubles(parameters)?;
            }
        } else {
            for _ in 0..count {
                let tag = reader.wide_tag("node")?;
                rows.push((tag, place(reader)?));
                reader.skip_doubles(parameters)?;
            }
        }
    }
    if rows.len() as u64 != declared {
        let found = rows.len();
        let text = format!("the section declares {declared} nodes, its blocks hold {found}");
        return Err(reader.cursor.refuse(text));
    }
    Ok(rows)
}

fn place(reader: &mut Reader<'_>) -> Result<[f64; 3], Error> {
    Ok([
        reader.double("x")?,
        reader.double("y")?,
        reader.double("z")?,
    ])
}
