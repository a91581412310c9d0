//! Reading: each element by its name.

use super::EDGE_MARKER;
use super::body::{Body, Cells};
use super::header::{Element, Header};
use crate::scan::Scanner;
use crate::{Attribute, Constraints, Error, MeshData, Place, PointSet, Problem, ReadOptions, node};
use delone::{Point, VertexId, Watch};

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let header = Header::read(&mut scanner)?;
    // Which vertices there are must be known before others are read that refer to them.
    let vertex = header.elements.iter().find(|e| e.name == "vertex");
    let Some(vertex) = vertex else {
        let text = "the header declares no element vertex".to_owned();
        return Err(scanner.malformed(Place::File, Problem::Other(text)));
    };
    let num_vertices = match usize::try_from(vertex.rows) {
        Ok(rows) if vertex.rows <= node::MAX_POINTS => rows,
        _ => {
            let problem = node::too_many(vertex.rows);
            return Err(scanner.malformed(Place::Line(vertex.line), problem));
        }
    };
    let file = file.to_owned();
    let mut mesh = MeshData::default();
    let mut markers = None;
    let mut body = Body::new(&mut scanner, bytes, header.encoding, watch);
    for element in &header.elements {
        let in_header = |problem| Error::Malformed {
            file: file.clone(),
            place: Place::Line(element.line),
            problem,
        };
        match element.name.as_str() {
            "vertex" => mesh.vertices = read_vertices(&mut body, element, in_header)?,
            "face" if element.rows > 0 => {
                let faces = read_faces(&mut body, element, num_vertices, in_header)?;
                (mesh.triangles, mesh.triangle_attributes) = faces;
            }
            "edge" if element.rows > 0 => {
                let edges = read_edges(&mut body, element, num_vertices, in_header)?;
                mesh.constraints = Some(edges);
            }
            EDGE_MARKER => {
                let mut kept = Kept::new(element, &body, &[]);
                body.read(element, None, |_, cells| {
                    kept.push(cells);
                    Ok(())
                })?;
                markers = kept.take_markers(element).map(|of| (of, element.line));
            }
            "tristrips" if element.rows > 0 => {
                let text = "triangle strips are not understood; write faces of 3 corners";
                return Err(in_header(Problem::Other(text.to_owned())));
            }
            _ => body.read(element, None, |_, _| Ok(()))?,
        }
    }
    body.expect_end()?;
    if let Some((markers, line)) = markers {
        mark(&mut mesh.constraints, markers)
            .map_err(|problem| scanner.malformed(Place::Line(line), problem))?;
    }
    Ok(mesh)
}

/// Gives edges the markers that stand in an element of their own.
fn mark(constraints: &mut Option<Constraints>, markers: Vec<i32>) -> Result<(), Problem> {
    let edges = constraints.as_ref().map_or(0, |c| c.edges.len());
    if edges != markers.len() {
        let found = markers.len();
        return Err(Problem::Other(format!(
            "{found} markers of edges for {edges} edges"
        )));
    }
    if let Some(constraints) = constraints {
        constraints.markers = Some(markers);
    }
    Ok(())
}

/// Finds a number that must be there.
fn required(element: &Element, name: &str) -> Result<usize, Problem> {
    element
        .number(name)
        .ok_or_else(|| Problem::Other(format!("element {} has no number {name}", element.name)))
}

/// The columns of an element that become attributes.
struct Kept {
    places: Vec<usize>,
    attributes: Vec<Attribute>,
}

impl Kept {
    /// Takes all numbers but those in `other` places.
    fn new(element: &Element, body: &Body<'_, '_>, other: &[Option<usize>]) -> Self {
        let properties = element.properties.iter().enumerate();
        let kept = properties.filter(|(i, p)| p.length.is_none() && !other.contains(&Some(*i)));
        let (places, attributes) = kept
            .map(|(place, property)| {
                let mut values = Vec::new();
                body.reserve(&mut values, element);
                let name = property.name.clone();
                (place, Attribute { name, values })
            })
            .unzip();
        Self { places, attributes }
    }

    fn push(&mut self, cells: &Cells) {
        for (&place, attribute) in self.places.iter().zip(&mut self.attributes) {
            attribute.values.push(cells.numbers[place]);
        }
    }

    /// Takes a column of integers of this name out, if all fit markers.
    fn take_markers(&mut self, element: &Element) -> Option<Vec<i32>> {
        let place = element.number("marker")?;
        let is_integer = element.properties[place].kind.is_integer();
        let found = self.places.iter().position(|&p| p == place)?;
        let values = &self.attributes[found].values;
        if !is_integer || values.iter().any(|&v| f64::from(v as i32) != v) {
            return None;
        }
        self.places.remove(found);
        let marker = self.attributes.remove(found);
        Some(marker.values.into_iter().map(|v| v as i32).collect())
    }
}

fn read_vertices(
    body: &mut Body<'_, '_>,
    element: &Element,
    in_header: impl Fn(Problem) -> Error,
) -> Result<PointSet, Error> {
    let x = required(element, "x").map_err(&in_header)?;
    let y = required(element, "y").map_err(&in_header)?;
    let mut kept = Kept::new(element, body, &[Some(x), Some(y)]);
    let mut points = Vec::new();
    body.reserve(&mut points, element);
    body.read(element, None, |number, cells| {
        let [x, y] = [(x, 'x'), (y, 'y')].map(|(place, axis)| match cells.numbers[place] {
            value if value.is_finite() => Ok(value),
            value => Err(Problem::NotFinite {
                index: number,
                axis,
                text: value.to_string(),
            }),
        });
        points.push(Point::new(x?, y?));
        kept.push(cells);
        Ok(())
    })?;
    let markers = kept.take_markers(element);
    let mut attributes = kept.attributes;
    if let Some(z) = attributes.iter().position(|a| a.name == "z") {
        let z = attributes.remove(z);
        if z.values.iter().any(|&z| z != 0.0) {
            attributes.insert(0, z);
        }
    }
    Ok(PointSet {
        points,
        attributes,
        markers,
        ..PointSet::default()
    })
}

/// Reads triangles and their attributes.
fn read_faces(
    body: &mut Body<'_, '_>,
    element: &Element,
    num_vertices: usize,
    in_header: impl Fn(Problem) -> Error,
) -> Result<(Vec<[VertexId; 3]>, Vec<Attribute>), Error> {
    let names = ["vertex_indices", "vertex_index"];
    let Some(corners) = names.into_iter().find_map(|name| element.list(name)) else {
        let text = "element face has no list vertex_indices".to_owned();
        return Err(in_header(Problem::Other(text)));
    };
    let mut kept = Kept::new(element, body, &[]);
    let mut triangles = Vec::new();
    body.reserve(&mut triangles, element);
    body.read(element, Some(corners), |number, cells| {
        let &[a, b, c] = cells.list.as_slice() else {
            let corners = cells.numbers[corners];
            return Err(Problem::Other(format!(
                "face {number} has {corners} corners: only triangles are understood; have the program that wrote \
                 this triangulate faces"
            )));
        };
        triangles.push(vertices(("face", number), [a, b, c], num_vertices)?);
        kept.push(cells);
        Ok(())
    })?;
    Ok((triangles, kept.attributes))
}

/// Reads constrained edges and their markers.
fn read_edges(
    body: &mut Body<'_, '_>,
    element: &Element,
    num_vertices: usize,
    in_header: impl Fn(Problem) -> Error,
) -> Result<Constraints, Error> {
    let a = required(element, "vertex1").map_err(&in_header)?;
    let b = required(element, "vertex2").map_err(&in_header)?;
    let mut kept = Kept::new(element, body, &[Some(a), Some(b)]);
    let mut edges = Vec::new();
    body.reserve(&mut edges, element);
    body.read(element, None, |number, cells| {
        let ends = [a, b].map(|place| cells.numbers[place]);
        edges.push(vertices(("edge", number), ends, num_vertices)?);
        kept.push(cells);
        Ok(())
    })?;
    Ok(Constraints {
        edges,
        markers: kept.take_markers(element),
        ..Constraints::default()
    })
}

/// Takes numbers as vertices, which must exist.
fn vertices<const N: usize>(
    (item, row): (&'static str, u64),
    numbers: [f64; N],
    num_vertices: usize,
) -> Result<[VertexId; N], Problem> {
    let is_vertex = |v: f64| (0.0..num_vertices as f64).contains(&v) && v.fract() == 0.0;
    match numbers.into_iter().find(|&v| !is_vertex(v)) {
        None => Ok(numbers.map(|v| VertexId::new(v as usize))),
        Some(index) => Err(Problem::BadIndex {
            item,
            row,
            target: "vertex",
            index: index as i64,
            limit: num_vertices as u64,
            base: 0,
        }),
    }
}
