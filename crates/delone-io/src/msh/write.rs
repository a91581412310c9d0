//! Writing: entities for groups, nodes, elements, data; as text.

use super::groups::{Group, Groups, regions_in};
use super::{LINE, MARKERS, POINT, QUADRATIC_LINE, QUADRATIC_TRIANGLE, REGIONS, TRIANGLE};
use crate::target::Output;
use crate::{Error, MeshView, WriteOptions};
use delone::{Point, VertexId};
use std::fmt;

/// Writes version 4.1: a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write_4(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let layout = Layout::new(mesh, markers);
    out.text(format_args!("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"))?;
    layout.write_names(out)?;
    layout.write_entities(out)?;
    layout.write_nodes_4(out)?;
    layout.write_elements_4(out)?;
    // Some readers pass tags over and take data in the order of the nodes.
    layout.write_data(out, &layout.blockwise())
}

/// Writes version 2.2: a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write_2(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let layout = Layout::new(mesh, markers);
    out.text(format_args!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"))?;
    layout.write_names(out)?;
    layout.write_nodes_2(out)?;
    layout.write_elements_2(out)?;
    let in_order: Vec<usize> = (0..mesh.points.len()).collect();
    layout.write_data(out, &in_order)
}

/// A mesh, and on which entity everything lies: dimension, and place among those of its dimension.
struct Layout<'a> {
    mesh: &'a MeshView<'a>,
    edges: &'a [[VertexId; 2]],
    curves: Groups,
    surfaces: Groups,
    /// The entity of each node.
    of_nodes: Vec<Place>,
    /// The nodes of no edge and no triangle: elements of their own.
    loose: Vec<usize>,
}

/// Dimension, and place among the entities of this dimension.
type Place = (u8, u32);

/// An element: its type and its nodes, of which the first so many count.
struct Element {
    kind: i64,
    len: usize,
    nodes: [VertexId; 6],
}

impl<'a> Layout<'a> {
    fn new(mesh: &'a MeshView<'a>, markers: &[i32]) -> Self {
        let mut layout = Self {
            mesh,
            edges: mesh.constraints.map_or(&[], |c| &c.edges),
            curves: Groups::of_edges(markers),
            surfaces: Groups::of_triangles(mesh),
            of_nodes: vec![(0, 0); mesh.points.len()],
            loose: Vec::new(),
        };
        for t in 0..mesh.triangles.len() {
            layout.place_nodes(&layout.triangle(t), (2, layout.surfaces.of[t]));
        }
        for e in 0..layout.edges.len() {
            layout.place_nodes(&layout.line(e), (1, layout.curves.of[e]));
        }
        let nodes = layout.of_nodes.iter().enumerate();
        layout.loose = nodes.filter(|(_, at)| at.0 == 0).map(|(v, _)| v).collect();
        layout
    }

    fn place_nodes(&mut self, element: &Element, place: Place) {
        for v in &element.nodes[..element.len] {
            self.of_nodes[v.index()] = place;
        }
    }

    /// Makes the element of a triangle. Midpoints are those opposite its corners, but Gmsh begins with the one
    /// between the first two.
    fn triangle(&self, t: usize) -> Element {
        let [a, b, c] = self.mesh.triangles[t];
        match self.mesh.middles.map(|middles| middles.of_triangles[t]) {
            Some([bc, ca, ab]) => Element {
                kind: QUADRATIC_TRIANGLE,
                len: 6,
                nodes: [a, b, c, ab, bc, ca],
            },
            None => Element {
                kind: TRIANGLE,
                len: 3,
                nodes: [a, b, c, a, a, a],
            },
        }
    }

    /// Makes the element of a constrained edge; one without triangle has no midpoint.
    fn line(&self, e: usize) -> Element {
        let [a, b] = self.edges[e];
        match self
            .mesh
            .middles
            .and_then(|middles| middles.of_constrained[e])
        {
            Some(middle) => Element {
                kind: QUADRATIC_LINE,
                len: 3,
                nodes: [a, b, middle, a, a, a],
            },
            None => Element {
                kind: LINE,
                len: 2,
                nodes: [a, b, a, a, a, a],
            },
        }
    }

    fn point(&self, i: usize) -> Element {
        let nodes = [VertexId::new(self.loose[i]); 6];
        Element {
            kind: POINT,
            len: 1,
            nodes,
        }
    }

    /// Lists the entities of a dimension.
    fn entities(&self, dimension: u8) -> &[Group] {
        match dimension {
            1 => &self.curves.entities,
            2 => &self.surfaces.entities,
            _ => &[],
        }
    }

    /// Writes which groups there are.
    fn write_names(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let of = |dimension| {
            let groups = self.entities(dimension).iter();
            groups.filter_map(move |g| Some((dimension, g.tag?, &g.name)))
        };
        let all = || of(1).chain(of(2));
        let count = all().count();
        if count == 0 {
            return Ok(());
        }
        out.text(format_args!("$PhysicalNames\n{count}\n"))?;
        for (dimension, tag, name) in all() {
            out.text(format_args!("{dimension} {tag} \"{name}\"\n"))?;
        }
        out.text(format_args!("$EndPhysicalNames\n"))
    }

    /// Writes the entities with their boxes and groups; what bounds them is not told, for elements do.
    fn write_entities(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [curves, surfaces] = [1, 2].map(|dimension| self.entities(dimension).len());
        let points = usize::from(!self.loose.is_empty());
        out.text(format_args!("$Entities\n{points} {curves} {surfaces} 0\n"))?;
        if let Some(&first) = self.loose.first() {
            let Point { x, y } = self.mesh.points[first];
            row(out, [1.0, x, y, 0.0, 0.0])?;
        }
        let boxes = self.boxes();
        for (dimension, boxes) in [1, 2].into_iter().zip(boxes) {
            for (i, (group, [low, high])) in self.entities(dimension).iter().zip(boxes).enumerate()
            {
                let sides = [low.x, low.y, 0.0, high.x, high.y, 0.0];
                out.integer(i as i64 + 1);
                for side in sides {
                    out.blank();
                    out.number(side);
                }
                match group.tag {
                    Some(tag) => out.text(format_args!(" 1 {tag} 0\n"))?,
                    None => out.text(format_args!(" 0 0\n"))?,
                }
            }
        }
        out.text(format_args!("$EndEntities\n"))
    }

    /// Returns the boxes of curves and of surfaces.
    fn boxes(&self) -> [Vec<[Point; 2]>; 2] {
        let infinite = f64::INFINITY;
        let empty = [
            Point::new(infinite, infinite),
            Point::new(-infinite, -infinite),
        ];
        let mut boxes = [1, 2].map(|dimension| vec![empty; self.entities(dimension).len()]);
        let mut extend = |(dimension, place): Place, element: Element| {
            let [low, high] = &mut boxes[usize::from(dimension) - 1][place as usize];
            for v in &element.nodes[..element.len] {
                let p = self.mesh.points[v.index()];
                (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
                (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
            }
        };
        for e in 0..self.edges.len() {
            extend((1, self.curves.of[e]), self.line(e));
        }
        for t in 0..self.mesh.triangles.len() {
            extend((2, self.surfaces.of[t]), self.triangle(t));
        }
        boxes
    }

    /// Lists the nodes entity by entity.
    fn blockwise(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.mesh.points.len()).collect();
        order.sort_by_key(|&v| self.of_nodes[v]);
        order
    }

    /// Writes the nodes, a block for each entity.
    fn write_nodes_4(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let n = self.mesh.points.len();
        let order = self.blockwise();
        let blocks = || order.chunk_by(|&v, &w| self.of_nodes[v] == self.of_nodes[w]);
        let count = blocks().count();
        out.text(format_args!("$Nodes\n{count} {n} {} {n}\n", n.min(1)))?;
        for block in blocks() {
            let (dimension, place) = self.of_nodes[block[0]];
            let (entity, len) = (place + 1, block.len());
            out.text(format_args!("{dimension} {entity} 0 {len}\n"))?;
            for v in block {
                out.integer(*v as i64 + 1);
                out.end_line()?;
            }
            for &v in block {
                let Point { x, y } = self.mesh.points[v];
                row(out, [x, y, 0.0])?;
            }
        }
        out.text(format_args!("$EndNodes\n"))
    }

    fn write_nodes_2(&self, out: &mut Output<'_>) -> Result<(), Error> {
        out.text(format_args!("$Nodes\n{}\n", self.mesh.points.len()))?;
        for (v, &Point { x, y }) in self.mesh.points.iter().enumerate() {
            out.integer(v as i64 + 1);
            out.blank();
            row(out, [x, y, 0.0])?;
        }
        out.text(format_args!("$EndNodes\n"))
    }

    /// Returns how many elements there are: triangles come first, as data are theirs, then edges, then points.
    fn counts(&self) -> [usize; 3] {
        [
            self.mesh.triangles.len(),
            self.edges.len(),
            self.loose.len(),
        ]
    }

    /// Writes the elements, a block for each entity and type.
    fn write_elements_4(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [m, k, l] = self.counts();
        let all = m + k + l;
        let points = (0..l).map(|i| ((0, 0), self.point(i), m + k + i));
        let lines = (0..k).map(|e| ((1, self.curves.of[e]), self.line(e), m + e));
        let triangles = (0..m).map(|t| ((2, self.surfaces.of[t]), self.triangle(t), t));
        let keys = points.chain(lines).chain(triangles);
        let mut order: Vec<(Place, i64, usize)> = keys
            .map(|(place, element, number)| (place, element.kind, number))
            .collect();
        order.sort_unstable();
        let blocks = || order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
        let count = blocks().count();
        out.text(format_args!(
            "$Elements\n{count} {all} {} {all}\n",
            all.min(1)
        ))?;
        for block in blocks() {
            let ((dimension, place), kind, _) = block[0];
            let (entity, len) = (place + 1, block.len());
            out.text(format_args!("{dimension} {entity} {kind} {len}\n"))?;
            for &(_, _, number) in block {
                out.integer(number as i64 + 1);
                self.write_corners(out, &self.element(number))?;
            }
        }
        out.text(format_args!("$EndElements\n"))
    }

    /// Returns the element of a number.
    fn element(&self, number: usize) -> Element {
        let [m, k, _] = self.counts();
        match number {
            t if t < m => self.triangle(t),
            e if e < m + k => self.line(e - m),
            i => self.point(i - m - k),
        }
    }

    fn write_elements_2(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [m, k, l] = self.counts();
        out.text(format_args!("$Elements\n{}\n", m + k + l))?;
        for number in 0..m + k + l {
            let (place, group) = match number {
                t if t < m => (self.surfaces.of[t], Some(&self.surfaces)),
                e if e < m + k => (self.curves.of[e - m], Some(&self.curves)),
                _ => (0, None),
            };
            let tag = group
                .and_then(|g| g.entities[place as usize].tag)
                .unwrap_or(0);
            let element = self.element(number);
            for value in [number as i64 + 1, element.kind, 2, tag.into()] {
                out.integer(value);
                out.blank();
            }
            out.integer(i64::from(place) + 1);
            self.write_corners(out, &element)?;
        }
        out.text(format_args!("$EndElements\n"))
    }

    fn write_corners(&self, out: &mut Output<'_>, element: &Element) -> Result<(), Error> {
        for v in &element.nodes[..element.len] {
            out.blank();
            out.integer(v.index() as i64 + 1);
        }
        out.end_line()
    }

    /// Writes attributes and markers of vertices, and attributes of triangles; those that say the groups are not
    /// repeated.
    fn write_data(&self, out: &mut Output<'_>, order: &[usize]) -> Result<(), Error> {
        let mesh = self.mesh;
        for attribute in mesh.attributes {
            let values = order.iter().map(|&v| (v, attribute.values[v]));
            write_view(out, "NodeData", &attribute.name, values)?;
        }
        if let Some(markers) = mesh.markers {
            let values = order.iter().map(|&v| (v, markers[v].into()));
            write_view(out, "NodeData", MARKERS, values)?;
        }
        let has_regions = mesh.constraints.is_some_and(|c| c.region_of.is_some());
        let are_groups = !has_regions && regions_in(mesh).is_some();
        for attribute in mesh.triangle_attributes {
            if attribute.name == REGIONS && are_groups {
                continue;
            }
            let values = attribute.values.iter().copied().enumerate();
            write_view(out, "ElementData", &attribute.name, values)?;
        }
        Ok(())
    }
}

/// Writes one field of numbers; nodes or elements without a number have no row.
fn write_view(
    out: &mut Output<'_>,
    section: &str,
    name: &str,
    values: impl Iterator<Item = (usize, f64)> + Clone,
) -> Result<(), Error> {
    let count = values.clone().filter(|(_, v)| !v.is_nan()).count();
    let name = Bare(name);
    out.text(format_args!(
        "${section}\n1\n\"{name}\"\n1\n0\n3\n0\n1\n{count}\n"
    ))?;
    for (i, value) in values {
        if !value.is_nan() {
            out.integer(i as i64 + 1);
            out.blank();
            out.number(value);
            out.end_line()?;
        }
    }
    out.text(format_args!("$End{section}\n"))
}

/// A name without what would end it.
struct Bare<'a>(&'a str);

impl fmt::Display for Bare<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bare = |c: char| if c == '"' || c.is_control() { '_' } else { c };
        self.0
            .chars()
            .try_for_each(|c| fmt::Write::write_char(f, bare(c)))
    }
}

fn row<const N: usize>(out: &mut Output<'_>, numbers: [f64; N]) -> Result<(), Error> {
    for (i, number) in numbers.into_iter().enumerate() {
        if i > 0 {
            out.blank();
        }
        out.number(number);
    }
    out.end_line()
}
