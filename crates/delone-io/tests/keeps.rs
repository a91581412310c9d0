//! What the table of formats promises to keep is kept, and nothing is kept that it does not promise.
//!
//! For every format that is written and read, a mesh, a domain and points that have everything are written, read back,
//! and looked through.

use delone::{DomainRule, Point, Region, VertexId};
use delone_io::{
    Attribute, Constraints, DomainData, Error, Format, MeshData, MeshView, PointSet, ReadOptions,
    Source, Target, Trait, WriteOptions, read_domain, read_mesh, read_points, write_domain,
    write_mesh, write_points,
};

/// Numbers that no other format of numbers than doubles keeps.
const PRECISE: f64 = 0.1 + 1e-15;

fn attribute(name: &str, values: &[f64]) -> Attribute {
    Attribute {
        name: name.to_owned(),
        values: values.to_vec(),
    }
}

fn ids<const N: usize>(rows: &[[usize; N]]) -> Vec<[VertexId; N]> {
    rows.iter().map(|row| row.map(VertexId::new)).collect()
}

fn everything() -> PointSet {
    let points = [(0.0, 0.0), (1.0, 0.0), (1.0, PRECISE), (0.0, 1.0)];
    PointSet {
        points: points.map(Point::from).to_vec(),
        attributes: vec![
            attribute("z", &[41.5, 42.5, 43.5, 44.5]),
            attribute("heat", &[51.5, 52.5, 53.5, 54.5]),
        ],
        markers: Some(vec![61, 62, 63, 64]),
        ..PointSet::default()
    }
}

fn region(x: f64, attribute: f64) -> Region {
    Region {
        at: Point::new(x, 0.25),
        attribute,
        max_area: None,
    }
}

fn constraints() -> Constraints {
    Constraints {
        edges: ids(&[[0, 1], [1, 2], [0, 2], [2, 3], [3, 0]]),
        markers: Some(vec![71, 72, 73, 74, 75]),
        holes: vec![Point::new(8.25, 8.25)],
        regions: vec![region(0.75, 81.0), region(0.25, 82.0)],
        region_of: Some(vec![Some(1), Some(0)]),
        ..Constraints::default()
    }
}

/// What came back, of the mesh, of the domain or of the points.
#[derive(Debug, Default)]
struct Found {
    points: Vec<Point>,
    attributes: Vec<Attribute>,
    markers: Option<Vec<i32>>,
    segments: Vec<[VertexId; 2]>,
    segment_markers: Vec<i32>,
    holes: usize,
    regions: usize,
    triangles: usize,
    triangle_attributes: Vec<Attribute>,
    quadratic: bool,
}

impl Found {
    fn of_domain(read: DomainData) -> Self {
        Self {
            segments: read.segments,
            segment_markers: read.segment_markers.unwrap_or_default(),
            holes: read.holes.len(),
            regions: read.regions.len(),
            ..Self::of_points(read.vertices)
        }
    }

    fn of_points(read: PointSet) -> Self {
        Self {
            points: read.points,
            attributes: read.attributes,
            markers: read.markers,
            ..Self::default()
        }
    }

    fn of_mesh(read: MeshData) -> Self {
        let constraints = read.constraints.unwrap_or_default();
        Self {
            segments: constraints.edges,
            segment_markers: constraints.markers.unwrap_or_default(),
            holes: constraints.holes.len(),
            regions: constraints.regions.len(),
            triangles: read.triangles.len(),
            triangle_attributes: read.triangle_attributes,
            quadratic: read.quadratic,
            ..Self::of_points(read.vertices)
        }
    }

    /// Tells whether something has survived.
    fn has(&self, what: Trait) -> bool {
        let has_column = |columns: &[Attribute], expected: &[f64]| {
            columns.iter().any(|a| a.values.starts_with(expected))
        };
        // Points may come in another order, and more than once.
        let belongs = |values: &[f64], [a, b, c, d]: [f64; 4]| {
            let expected = everything().points.into_iter().zip([a, b, c, d]);
            let found = self.points.iter().zip(values);
            let found: Vec<_> = found.map(|(p, v)| (*p, *v)).collect();
            expected.into_iter().all(|row| found.contains(&row))
        };
        let has_data = |values| self.attributes.iter().any(|a| belongs(&a.values, values));
        match what {
            Trait::Z => has_data([41.5, 42.5, 43.5, 44.5]),
            Trait::PointAttributes => has_data([51.5, 52.5, 53.5, 54.5]),
            Trait::PointMarkers => {
                let markers = self.markers.as_ref();
                markers.is_some_and(|m| m.starts_with(&[61, 62, 63, 64]))
                    || has_data([61.0, 62.0, 63.0, 64.0])
            }
            Trait::Segments => self.segments.len() == 5,
            Trait::SegmentMarkers => {
                let mut markers = self.segment_markers.clone();
                markers.sort_unstable();
                markers == [71, 72, 73, 74, 75]
            }
            Trait::Holes => self.holes == 1,
            Trait::Regions => self.regions == 2,
            // References count from 1, for 0 is none.
            Trait::TriangleRegions => [[1.0, 0.0], [2.0, 1.0]]
                .iter()
                .any(|column| has_column(&self.triangle_attributes, column)),
            Trait::TriangleAttributes => has_column(&self.triangle_attributes, &[91.5, 92.5]),
            Trait::SixNodes => self.quadratic,
            _ => panic!("{what:?} is not looked for"),
        }
    }
}

/// Writes to a file of a format of its own and reads it back.
struct Trial {
    folder: tempfile::TempDir,
    format: Format,
}

impl Trial {
    fn new(format: Format) -> Self {
        let folder = tempfile::tempdir().expect("folder");
        Self { folder, format }
    }

    fn target(&self) -> Target {
        Target::from_arg(
            self.folder
                .path()
                .join("all")
                .with_extension(self.format.name()),
            None,
        )
    }

    fn source(&self, format: Format) -> (Source, ReadOptions) {
        let path = self.folder.path().join("all").with_extension(format.name());
        (Source::Path(path), ReadOptions::default())
    }

    /// Writes a mesh, with six nodes if the format has them, and reads it back.
    fn mesh(&self) -> Result<Option<Found>, Error> {
        let mesh = MeshData {
            vertices: everything(),
            triangles: ids(&[[0, 1, 2], [0, 2, 3]]),
            triangle_attributes: vec![attribute("heat", &[91.5, 92.5])],
            constraints: Some(constraints()),
            quadratic: self.format.writes_quadratic_mesh(),
        };
        let view = MeshView::from(&mesh);
        write_mesh(&[self.target()], &view, &WriteOptions::default(), &())?;
        let format = match self.format {
            // One family.
            Format::Node | Format::Edge | Format::Neigh | Format::Poly => Format::Ele,
            format => format,
        };
        let (source, options) = self.source(format);
        if format.reads_mesh() {
            return read_mesh(&source, &options, &()).map(|read| Some(Found::of_mesh(read)));
        }
        Ok(None)
    }

    fn domain(&self) -> Result<Option<Found>, Error> {
        if !self.format.writes_segments() {
            return Ok(None);
        }
        let graph = constraints();
        let takes_seeds = self.format.keeps().is_some_and(|k| k.keeps(Trait::Holes));
        use Format::{GeoJson, Medit, Msh, Msh2, Vtk, Vtu};
        let refuses_seeds = matches!(self.format, GeoJson | Medit | Msh | Msh2 | Vtk | Vtu);
        assert!(!(takes_seeds && refuses_seeds));
        let domain = DomainData {
            vertices: everything(),
            segments: graph.edges,
            segment_markers: graph.markers,
            holes: if refuses_seeds { vec![] } else { graph.holes },
            regions: if refuses_seeds { vec![] } else { graph.regions },
            polygons: Vec::new(),
            usual_rule: DomainRule::Carve,
        };
        write_domain(&[self.target()], &domain, &WriteOptions::default(), &())?;
        if !self.format.reads_segments() {
            return Ok(None);
        }
        let (source, options) = self.source(self.format);
        read_domain(&source, &options, &()).map(|read| Some(Found::of_domain(read)))
    }

    fn points(&self) -> Result<Option<Found>, Error> {
        if !self.format.writes_points() {
            return Ok(None);
        }
        write_points(
            &[self.target()],
            &everything(),
            &WriteOptions::default(),
            &(),
        )?;
        if !self.format.reads_points() {
            return Ok(None);
        }
        let (source, options) = self.source(self.format);
        read_points(&source, &options, &()).map(|read| Some(Found::of_points(read)))
    }
}

/// What can be there at all.
const OF_POINTS: &[Trait] = &[Trait::Z, Trait::PointAttributes, Trait::PointMarkers];
const OF_DOMAINS: &[Trait] = &[
    Trait::Segments,
    Trait::SegmentMarkers,
    Trait::Holes,
    Trait::Regions,
];
const OF_MESHES: &[Trait] = &[
    Trait::TriangleRegions,
    Trait::TriangleAttributes,
    Trait::SixNodes,
];

/// Compares what has come back with the promise.
fn compare(
    format: Format,
    content: &str,
    found: &Found,
    possible: &[&[Trait]],
    faults: &mut Vec<String>,
) {
    let keeps = format.keeps().expect("written");
    for &what in possible.concat().iter() {
        if found.has(what) != keeps.keeps(what) {
            let said = if keeps.keeps(what) {
                "promised, but lost"
            } else {
                "kept, but not promised"
            };
            faults.push(format!("{format}, {content}: {} {said}", what.name()));
        }
    }
    if content == "mesh" && found.triangles != 2 {
        faults.push(format!("{format}: {} triangles", found.triangles));
    }
    let mut points: Vec<_> = found.points.iter().map(|p| (p.x, p.y)).collect();
    points.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    points.dedup();
    let expected = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, PRECISE)];
    if (points == expected) != keeps.coordinates.is_exact() {
        faults.push(format!("{format}, {content}: coordinates {points:?}"));
    }
}

/// Pictures are read as what they show, not as what they were made of.
fn is_shown(format: Format) -> bool {
    matches!(format, Format::Svg | Format::Png | Format::Tikz)
}

#[test]
fn every_format_keeps_what_it_promises_and_nothing_else() {
    let mut faults = Vec::new();
    let mut tried = 0;
    for format in Format::ALL {
        if format.keeps().is_none() || is_shown(format) {
            continue;
        }
        let mut attempt =
            |content: &str, outcome: Result<Option<Found>, Error>, possible: &[&[Trait]]| {
                match outcome {
                    Ok(Some(found)) => {
                        tried += 1;
                        compare(format, content, &found, possible, &mut faults);
                    }
                    Ok(None) => {}
                    Err(error) => faults.push(format!("{format}, {content}: {error}")),
                }
            };
        if format.writes_mesh() {
            attempt(
                "mesh",
                Trial::new(format).mesh(),
                &[OF_POINTS, OF_DOMAINS, OF_MESHES],
            );
        }
        // Of Triangle's family, each file alone holds what its name says.
        if format != Format::Node {
            attempt("points", Trial::new(format).points(), &[OF_POINTS]);
        }
        attempt(
            "domain",
            Trial::new(format).domain(),
            &[OF_POINTS, OF_DOMAINS],
        );
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(tried > 10);
}

#[test]
fn formats_that_are_written_promise_something_and_others_nothing() {
    for format in Format::ALL {
        let writes = format.writes_points() || format.writes_segments() || format.writes_mesh();
        assert_eq!(format.keeps().is_some(), writes, "{format}");
    }
}
