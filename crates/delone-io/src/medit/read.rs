//! Reading: the sections that a mesh of the plane has; others are passed over.
//!
//! In files of dimension 3, z becomes an attribute. References of vertices become markers, those of edges markers of
//! constrained edges, those of triangles the attribute `ref`, unless all are 0. Of triangles with six nodes only the
//! corners are kept. Cells other than edges and triangles are refused.

use crate::scan::{self, Row, Scanner};
use crate::six_nodes;
use crate::{Attribute, Constraints, Error, MeshData, Place, PointSet, Problem, cancel, node};
use delone::{Point, VertexId, Watch};

/// Tells whether text begins like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let mut scanner = Scanner::new("", head, &());
    matches!(scanner.next_row(), Ok(Some(row)) if row.text.starts_with(b"MeshVersionFormatted"))
}

/// Reads a mesh; edges and triangles there may be none.
pub(crate) fn read_mesh(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<MeshData, Error> {
    let mut reader = Reader::new(Scanner::new(file, bytes, watch), watch);
    let mut mesh = Mesh::default();
    let mut has_points = false;
    while let Some(word) = reader.word()? {
        match word {
            b"MeshVersionFormatted" => match reader.integer("version")? {
                1..=4 => {}
                version => {
                    return Err(reader.problem(format!("version {version}: known are 1 to 4")));
                }
            },
            b"Dimension" => match reader.integer("dimension")? {
                dimension @ 2..=3 => mesh.dimension = dimension as usize,
                dimension => return Err(reader.at_word(Problem::Dimension(dimension))),
            },
            b"Vertices" => {
                if has_points {
                    return Err(reader.problem("a second section of vertices".to_owned()));
                }
                has_points = true;
                mesh.read_vertices(&mut reader)?;
            }
            b"Edges" => mesh.read_edges(&mut reader, 0)?,
            b"EdgesP2" => mesh.read_edges(&mut reader, 1)?,
            b"Triangles" => mesh.read_triangles(&mut reader, 0)?,
            b"TrianglesP2" => mesh.read_triangles(&mut reader, 3)?,
            b"End" => break,
            cells if CELLS.contains(&cells) => {
                let found = reader.integer("number of cells")?;
                if found != 0 {
                    let text = format!(
                        "{found} {}: only edges and triangles are understood",
                        scan::show(cells)
                    );
                    return Err(reader.problem(text));
                }
            }
            other if other.first().is_some_and(u8::is_ascii_alphabetic) => reader.skip()?,
            other => {
                let text = format!("{:?} is no keyword", scan::show(other));
                return Err(reader.problem(text));
            }
        }
    }
    if !has_points {
        let problem = match bytes.is_empty() {
            true => Problem::Empty,
            false => Problem::Other("no section of vertices".to_owned()),
        };
        return Err(reader.scanner.malformed(Place::File, problem));
    }
    mesh.finish(&reader.scanner)
}

/// Cells that are neither edges nor triangles.
const CELLS: [&[u8]; 7] = [
    b"Quadrilaterals",
    b"QuadrilateralsQ2",
    b"Tetrahedra",
    b"Tetrahedrons",
    b"Hexahedra",
    b"Hexahedrons",
    b"Prisms",
];

/// Walks over words, wherever lines end.
struct Reader<'a> {
    scanner: Scanner<'a>,
    row: Option<Row<'a>>,
    /// What is left of the row.
    rest: &'a [u8],
    watch: &'a dyn Watch,
    /// Words read so far.
    words: usize,
}

impl<'a> Reader<'a> {
    fn new(scanner: Scanner<'a>, watch: &'a dyn Watch) -> Self {
        Self {
            scanner,
            row: None,
            rest: &[],
            watch,
            words: 0,
        }
    }

    fn word(&mut self) -> Result<Option<&'a [u8]>, Error> {
        // All of a file may stand on one line.
        cancel::check(self.watch, self.words)?;
        self.words += 1;
        while self.rest.is_empty() {
            let Some(row) = self.scanner.next_row()? else {
                return Ok(None);
            };
            (self.row, self.rest) = (Some(row), row.text);
        }
        let end = self.rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.trim_ascii_start();
        Ok(Some(word))
    }

    /// Makes the error for a problem with the word just read.
    fn at_word(&self, problem: Problem) -> Error {
        match self.row {
            Some(row) => self.scanner.at(row, problem),
            None => self.scanner.malformed(Place::File, problem),
        }
    }

    fn problem(&self, text: String) -> Error {
        self.at_word(Problem::Other(text))
    }

    fn expect(&mut self, what: &str) -> Result<&'a [u8], Error> {
        match self.word()? {
            Some(word) => Ok(word),
            None => Err(self.problem(format!("truncated: the file ends before {what}"))),
        }
    }

    fn integer(&mut self, what: &str) -> Result<i64, Error> {
        let word = self.expect(what)?;
        scan::integer(word).ok_or_else(|| {
            let (what, text) = (what.to_owned(), scan::show(word));
            self.at_word(Problem::NotANumber { what, text })
        })
    }

    fn count(&mut self, what: &'static str) -> Result<u64, Error> {
        let count = self.integer(what)?;
        u64::try_from(count)
            .map_err(|_| self.problem(format!("{count} {what}: must not be negative")))
    }

    /// Reads a reference, which is a marker.
    fn reference(&mut self) -> Result<i32, Error> {
        let reference = self.integer("a reference")?;
        let found = i32::try_from(reference);
        found.map_err(|_| self.problem(format!("reference {reference}: beyond 32 bits")))
    }

    /// Passes over a section that is not understood: all numbers up to the next keyword.
    fn skip(&mut self) -> Result<(), Error> {
        loop {
            let before = (self.row, self.rest);
            match self.word()? {
                Some(word) if word[0].is_ascii_alphabetic() && scan::number(word).is_none() => {
                    // The word is the next keyword: it is read again.
                    self.rest = match before.1.is_empty() {
                        true => self.row.map_or(&[][..], |row| row.text),
                        false => before.1,
                    };
                    return Ok(());
                }
                Some(_) => {}
                None => return Ok(()),
            }
        }
    }
}

/// What has been read so far.
struct Mesh {
    dimension: usize,
    points: Vec<Point>,
    z: Vec<f64>,
    markers: Vec<i32>,
    edges: Vec<[VertexId; 2]>,
    edge_markers: Vec<i32>,
    triangles: Vec<[VertexId; 3]>,
    references: Vec<i32>,
    middles: Vec<VertexId>,
}

impl Default for Mesh {
    fn default() -> Self {
        Self {
            dimension: 2,
            points: Vec::new(),
            z: Vec::new(),
            markers: Vec::new(),
            edges: Vec::new(),
            edge_markers: Vec::new(),
            triangles: Vec::new(),
            references: Vec::new(),
            middles: Vec::new(),
        }
    }
}

impl Mesh {
    fn read_vertices(&mut self, reader: &mut Reader<'_>) -> Result<(), Error> {
        let declared = reader.count("vertices")?;
        if declared > node::MAX_POINTS {
            return Err(reader.at_word(node::too_many(declared)));
        }
        reader.scanner.reserve(&mut self.points, 6, declared);
        for index in 1..=declared {
            let coordinate = |reader: &mut Reader<'_>, axis| {
                let word = reader.expect("all vertices have come")?;
                scan::coordinate(word, axis, index).map_err(|p| reader.at_word(p))
            };
            let (x, y) = (coordinate(reader, 'x')?, coordinate(reader, 'y')?);
            self.points.push(Point::new(x, y));
            if self.dimension == 3 {
                self.z.push(coordinate(reader, 'z')?);
            }
            self.markers.push(reader.reference()?);
        }
        Ok(())
    }

    /// Reads a vertex of a cell.
    fn vertex(
        &self,
        reader: &mut Reader<'_>,
        item: &'static str,
        row: u64,
    ) -> Result<VertexId, Error> {
        let index = reader.integer("a vertex")?;
        let limit = self.points.len() as u64;
        match u64::try_from(index) {
            Ok(number) if (1..=limit).contains(&number) => Ok(VertexId::new(number as usize - 1)),
            _ => Err(reader.at_word(Problem::BadIndex {
                item,
                row,
                target: "vertex",
                index,
                limit,
                base: 1,
            })),
        }
    }

    fn read_edges(&mut self, reader: &mut Reader<'_>, middles: usize) -> Result<(), Error> {
        let declared = reader.count("edges")?;
        reader.scanner.reserve(&mut self.edges, 6, declared);
        for row in 1..=declared {
            let a = self.vertex(reader, "edge", row)?;
            let b = self.vertex(reader, "edge", row)?;
            for _ in 0..middles {
                let middle = self.vertex(reader, "edge", row)?;
                self.middles.push(middle);
            }
            self.edges.push([a, b]);
            self.edge_markers.push(reader.reference()?);
        }
        Ok(())
    }

    fn read_triangles(&mut self, reader: &mut Reader<'_>, middles: usize) -> Result<(), Error> {
        let declared = reader.count("triangles")?;
        reader.scanner.reserve(&mut self.triangles, 8, declared);
        for row in 1..=declared {
            let mut corners = [VertexId::INFINITE; 3];
            for corner in &mut corners {
                *corner = self.vertex(reader, "triangle", row)?;
            }
            for _ in 0..middles {
                let middle = self.vertex(reader, "triangle", row)?;
                self.middles.push(middle);
            }
            self.triangles.push(corners);
            self.references.push(reader.reference()?);
        }
        Ok(())
    }

    fn finish(self, scanner: &Scanner<'_>) -> Result<MeshData, Error> {
        let z = (self.dimension == 3).then(|| Attribute {
            name: "z".to_owned(),
            values: self.z,
        });
        let is_set = |references: &[i32]| references.iter().any(|&r| r != 0);
        let mut vertices = PointSet {
            points: self.points,
            attributes: z.into_iter().collect(),
            markers: is_set(&self.markers).then_some(self.markers),
            base: 1,
            ..PointSet::default()
        };
        let quadratic = !self.middles.is_empty();
        if quadratic {
            six_nodes::drop_midpoints(&mut vertices, &self.triangles, &self.middles)
                .map_err(|p| scanner.malformed(Place::File, p))?;
            let limit = vertices.points.len();
            let bad = self
                .edges
                .as_flattened()
                .iter()
                .find(|v| v.index() >= limit);
            if let Some(v) = bad {
                let text = format!(
                    "node {} is the end of an edge and a midpoint",
                    v.index() + 1
                );
                return Err(scanner.malformed(Place::File, Problem::Other(text)));
            }
        }
        let references = is_set(&self.references).then(|| Attribute {
            name: "ref".to_owned(),
            values: self.references.iter().map(|&r| r.into()).collect(),
        });
        let constraints = (!self.edges.is_empty()).then(|| Constraints {
            markers: is_set(&self.edge_markers).then_some(self.edge_markers),
            edges: self.edges,
            ..Constraints::default()
        });
        Ok(MeshData {
            vertices,
            triangles: self.triangles,
            triangle_attributes: references.into_iter().collect(),
            constraints,
            quadratic,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<MeshData, Error> {
        read_mesh("m.mesh", text.as_bytes(), &())
    }

    #[test]
    fn sections_come_in_any_lines_and_unknown_ones_are_passed_over() {
        let text = "MeshVersionFormatted 2\nDimension\n2\n# a remark\nVertices 3\n0 0 5\n1 0 0 0 1 7\n\
                    Corners 2 1 2 RequiredVertices\n1\n2\nEdges\n1\n2 3 -4\nTriangles\n1\n1 2 3 9\nEnd\nnonsense";
        let mesh = read(text).unwrap();
        assert_eq!(mesh.vertices.points.len(), 3);
        assert_eq!(mesh.vertices.markers, Some(vec![5, 0, 7]));
        assert_eq!(mesh.triangles, [[0, 1, 2].map(VertexId::new)]);
        assert_eq!(mesh.triangle_attributes[0].values, [9.0]);
        let constraints = mesh.constraints.unwrap();
        assert_eq!(constraints.edges, [[1, 2].map(VertexId::new)]);
        assert_eq!(constraints.markers, Some(vec![-4]));
    }

    #[test]
    fn height_is_an_attribute() {
        let mesh = read("MeshVersionFormatted 1 Dimension 3 Vertices 1 1 2 3 0 End").unwrap();
        assert_eq!(mesh.vertices.attributes[0].values, [3.0]);
        assert_eq!(mesh.vertices.markers, None);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        for (text, message) in [
            ("", "m.mesh: the file is empty"),
            ("MeshVersionFormatted 2\n", "m.mesh: no section of vertices"),
            (
                "MeshVersionFormatted 9\n",
                "m.mesh:1: version 9: known are 1 to 4",
            ),
            ("Dimension 4\n", "m.mesh:1: dimension must be 2, not 4"),
            (
                "Vertices\n2\n0 0 0\n1 nan 0\n",
                "m.mesh:4: point 2: y is nan, coordinates must be finite; repair or remove it",
            ),
            (
                "Vertices\n2\n0 0 0\n1",
                "m.mesh:4: truncated: the file ends before all vertices have come",
            ),
            (
                "Vertices\n1\n0 0 0\nEdges\n1\n1 2 0\n",
                "m.mesh:6: edge 1 names vertex 2 of 1 (numbered from 1)",
            ),
            (
                "Vertices\n1\n0 0 0\nQuadrilaterals\n3\n",
                "m.mesh:5: 3 Quadrilaterals: only edges and triangles are understood",
            ),
            ("Vertices\n1\n0 0 0\n17\n", "m.mesh:4: \"17\" is no keyword"),
            (
                "Vertices\n1\n0 0 0\nVertices 1",
                "m.mesh:4: a second section of vertices",
            ),
            (
                "Vertices\n99999999999\n",
                "m.mesh:2: 99999999999 points, at most 4294967294 are possible; split the data into tiles",
            ),
        ] {
            assert_eq!(read(text).unwrap_err().to_string(), message, "{text}");
        }
    }
}
