//! Nodes, elements and data, put together to a mesh.

use super::data::{Views, quoted};
use super::elements::{Element, Groupings};
use super::entities::PhysicalNames;
use super::groups::number_in;
use super::nodes::Nodes;
use super::{MARKER, MARKERS, NO_REGION, REGION, REGIONS};
use crate::cursor::Cursor;
use crate::{Attribute, Constraints, Error, MeshData, PointSet, Problem, points};
use delone::VertexId;
use std::collections::{BTreeMap, BTreeSet};

/// Most names that a note lists.
const NAMES_LISTED: usize = 12;

/// What a file holds.
#[derive(Default)]
pub(super) struct Parts {
    pub nodes: Nodes,
    pub names: PhysicalNames,
    pub points: Vec<Element<1>>,
    pub lines: Vec<Element<2>>,
    pub triangles: Vec<Element<3>>,
    pub middles: Vec<u32>,
    pub num_quadratic: usize,
    pub groupings: Groupings,
    pub node_data: Views,
    pub element_data: Views,
    pub notes: Vec<String>,
}

impl Parts {
    /// Makes the mesh.
    pub fn into_mesh(mut self, cursor: &Cursor<'_>) -> Result<MeshData, Error> {
        let filled = self.node_data.require_filled(self.nodes.points.len());
        let filled = filled.and_then(|()| self.element_data.require_filled(self.triangles.len()));
        filled.map_err(|problem| cursor.fail_whole(problem))?;
        sort(&mut self.lines);
        sort(&mut self.triangles);
        let in_several = self.are_in_several_groups();
        self.drop_repeated_triangles();
        let quadratic = !self.triangles.is_empty() && self.num_quadratic >= self.triangles.len();
        let vertex_of = self.vertices(cursor)?;
        self.note_groups(in_several);
        let triangle_attributes = self.triangle_attributes();
        let constraints = self.constraints(&vertex_of);
        let corners = |t: &Element<3>| t.corners.map(|v| VertexId::from(vertex_of[v as usize]));
        let triangles = self.triangles.iter().map(corners).collect();
        Ok(MeshData {
            triangles,
            triangle_attributes,
            constraints,
            quadratic,
            vertices: self.point_set(&vertex_of),
        })
    }

    /// Numbers the vertices, nodes but for midpoints; those have no number.
    fn vertices(&self, cursor: &Cursor<'_>) -> Result<Vec<u32>, Error> {
        let mut vertex_of = vec![0; self.nodes.points.len()];
        self.middles
            .iter()
            .for_each(|&m| vertex_of[m as usize] = u32::MAX);
        let of_triangles = self.triangles.iter().flat_map(|t| t.corners);
        let of_lines = self.lines.iter().flat_map(|l| l.corners);
        let is_middle = |&v: &u32| vertex_of[v as usize] == u32::MAX;
        if let Some(v) = of_triangles.chain(of_lines).find(is_middle) {
            let tag = self.nodes.tag(v);
            return Err(cursor.fail_whole(Problem::Other(format!(
                "node {tag} is a corner of one element and a midpoint of another"
            ))));
        }
        let vertices = vertex_of.iter_mut().filter(|v| **v == 0);
        vertices
            .zip(0..)
            .for_each(|(vertex, number)| *vertex = number);
        Ok(vertex_of)
    }

    /// In version 2 a triangle of several groups is there several times; its first group is kept, as in
    /// version 4.
    fn drop_repeated_triangles(&mut self) {
        if self.groupings.is_empty() {
            return;
        }
        let keys = by_corners(&self.triangles);
        let same = keys.chunk_by(|a, b| a.0 == b.0).flat_map(|same| &same[1..]);
        let repeated: BTreeSet<usize> = same.map(|&(_, place)| place).collect();
        if repeated.is_empty() {
            return;
        }
        let mut place = 0;
        self.triangles.retain(|_| {
            place += 1;
            !repeated.contains(&(place - 1))
        });
        let count = repeated.len();
        self.notes.push(format!(
            "triangles that are there twice are kept once: {count}"
        ));
    }

    /// Tells whether an element is in several groups: by its entity or, in version 2, since it is there once for each.
    fn are_in_several_groups(&self) -> bool {
        let mut lists = self
            .triangles
            .iter()
            .map(|t| t.groups)
            .chain(self.lines.iter().map(|l| l.groups))
            .chain(self.points.iter().map(|p| p.groups));
        !self.groupings.is_empty()
            && (lists.any(|groups| self.groupings.list(groups).len() > 1)
                || are_repeated_in_other_groups(&self.triangles)
                || are_repeated_in_other_groups(&self.lines)
                || are_repeated_in_other_groups(&self.points))
    }

    /// Says which groups and names a mesh has no place for; `in_several` tells whether elements are in several groups.
    fn note_groups(&mut self, in_several: bool) {
        let names = &self.names.0;
        let is_other = |&(&(dimension, _), name): &(&(i64, i32), &String)| {
            let start = if dimension == 2 { REGION } else { MARKER };
            (0..=2).contains(&dimension) && number_in(name, start).is_none()
        };
        let others = names.iter().filter(is_other);
        let others: Vec<_> = others
            .map(|(&(dimension, tag), name)| {
                let kind = if dimension == 2 { "region" } else { "marker" };
                format!("{kind} {tag} {}", quoted(name))
            })
            .collect();
        if !others.is_empty() {
            let listed = others[..others.len().min(NAMES_LISTED)].join(", ");
            let more = if others.len() > NAMES_LISTED {
                " …"
            } else {
                ""
            };
            self.notes
                .push(format!("names of groups are not kept: {listed}{more}"));
        }
        if in_several {
            let text = "of elements in several physical groups only the first group is kept";
            self.notes.push(text.to_owned());
        }
    }

    /// Returns the number that the first group of a list stands for.
    fn number(&self, dimension: i64, groups: u32) -> Option<i32> {
        let &tag = self.groupings.list(groups).first()?;
        let start = if dimension == 2 { REGION } else { MARKER };
        let name = self.names.0.get(&(dimension, tag));
        Some(name.and_then(|name| number_in(name, start)).unwrap_or(tag))
    }

    /// Returns the number of every list of groups.
    fn numbers(&self, dimension: i64, lists: impl Iterator<Item = u32>) -> BTreeMap<u32, i32> {
        let lists: BTreeSet<u32> = lists.collect();
        let number = |list| Some((list, self.number(dimension, list)?));
        lists.into_iter().filter_map(number).collect()
    }

    fn triangle_attributes(&mut self) -> Vec<Attribute> {
        let regions = self.numbers(2, self.triangles.iter().map(|t| t.groups));
        let mut attributes = Vec::new();
        if !regions.is_empty() {
            let region = |t: &Element<3>| regions.get(&t.groups).map_or(NO_REGION, |&r| r.into());
            attributes.push(Attribute {
                name: REGIONS.to_owned(),
                values: self.triangles.iter().map(region).collect(),
            });
        }
        let data = std::mem::take(&mut self.element_data);
        if data.is_empty() {
            return attributes;
        }
        let place = |tag| self.triangles.binary_search_by_key(&tag, |t| t.tag).ok();
        let (further, has_others) = data.into_attributes(self.triangles.len(), place);
        let is_new = |a: &Attribute| a.name != REGIONS || regions.is_empty();
        attributes.extend(further.into_iter().filter(is_new));
        if has_others {
            let text = "data of elements that are no triangles are not kept";
            self.notes.push(text.to_owned());
        }
        attributes
    }

    /// Makes constrained edges of lines, each once; of one that is there twice the first marker counts.
    fn constraints(&self, vertex_of: &[u32]) -> Option<Constraints> {
        let markers = self.numbers(1, self.lines.iter().map(|l| l.groups));
        let keys = by_corners(&self.lines);
        let mut firsts: Vec<usize> = keys
            .chunk_by(|a, b| a.0 == b.0)
            .map(|same| same[0].1)
            .collect();
        firsts.sort_unstable();
        let edge = |&l: &usize| {
            let ends = self.lines[l].corners;
            ends.map(|v| VertexId::from(vertex_of[v as usize]))
        };
        let marker = |&l: &usize| markers.get(&self.lines[l].groups).copied().unwrap_or(0);
        (!firsts.is_empty()).then(|| Constraints {
            edges: firsts.iter().map(edge).collect(),
            markers: (!markers.is_empty()).then(|| firsts.iter().map(marker).collect()),
            ..Constraints::default()
        })
    }

    fn point_set(self, vertex_of: &[u32]) -> PointSet {
        let is_vertex = |i: usize| vertex_of[i] != u32::MAX;
        let markers = self.markers_of_points();
        let nodes = &self.nodes;
        let data = self.node_data;
        let place = |tag| nodes.find(tag).map(|place| place as usize);
        let (mut attributes, has_others) = data.into_attributes(vertex_of.len(), place);
        let own = attributes
            .iter()
            .position(|a| a.name == MARKERS && a.values.iter().all(|&v| f64::from(v as i32) == v));
        let own = own.map(|place| attributes.remove(place).values);
        let own = own.map(|values| values.into_iter().map(|v| v as i32).collect());
        let heights = points::heights(nodes.heights.clone(), &attributes);
        attributes.splice(0..0, heights);
        let mut notes = self.notes;
        if has_others {
            notes.push("data of nodes that are not there are not kept".to_owned());
        }
        let keep = |values: Vec<f64>| pick(values, is_vertex);
        for attribute in &mut attributes {
            attribute.values = keep(std::mem::take(&mut attribute.values));
        }
        PointSet {
            markers: own.or(markers).map(|markers| pick(markers, is_vertex)),
            base: nodes.is_numbered().into(),
            points: pick(self.nodes.points, is_vertex),
            attributes,
            notes,
            ..PointSet::default()
        }
    }

    /// Returns the groups of points as markers of their nodes; of a point that is there twice the first counts.
    fn markers_of_points(&self) -> Option<Vec<i32>> {
        let numbers = self.numbers(0, self.points.iter().map(|p| p.groups));
        (!numbers.is_empty()).then(|| {
            let mut markers = vec![0; self.nodes.points.len()];
            for point in self.points.iter().rev() {
                if let Some(&marker) = numbers.get(&point.groups) {
                    markers[point.corners[0] as usize] = marker;
                }
            }
            markers
        })
    }
}

/// Sorts elements by their tags; of equal ones the order stays.
fn sort<const N: usize>(elements: &mut [Element<N>]) {
    if !elements.is_sorted_by_key(|e| e.tag) {
        elements.sort_by_key(|e| e.tag);
    }
}

/// Lists the corners of elements, whatever their order, with their places: equal ones together, the first one first.
fn by_corners<const N: usize>(elements: &[Element<N>]) -> Vec<([u32; N], usize)> {
    let sorted = |element: &Element<N>| {
        let mut corners = element.corners;
        corners.sort_unstable();
        corners
    };
    let mut keys: Vec<_> = elements.iter().map(sorted).zip(0..).collect();
    keys.sort_unstable();
    keys
}

/// Tells whether an element is there several times, in different groups.
fn are_repeated_in_other_groups<const N: usize>(elements: &[Element<N>]) -> bool {
    let groups = |place: usize| elements[place].groups;
    by_corners(elements)
        .windows(2)
        .any(|two| two[0].0 == two[1].0 && groups(two[0].1) != groups(two[1].1))
}

fn pick<T>(values: Vec<T>, keeps: impl Fn(usize) -> bool) -> Vec<T> {
    let all = values.into_iter().enumerate();
    all.filter(|&(i, _)| keeps(i))
        .map(|(_, value)| value)
        .collect()
}
