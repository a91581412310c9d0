//! Medit, STL, TikZ and ASCII grids: what is written is what was meant, and is read back.

use delone::{ConstrainedDelaunay, DomainRule, Point, Region, VertexId};
use delone_io::{
    Attribute, DomainData, Error, Inherited, MeshData, MeshView, PointSet, ReadOptions, Relief,
    ReliefOptions, Source, Target, WriteOptions, read_domain, read_mesh, read_points, write_domain,
    write_mesh, write_points, write_relief,
};
use std::path::Path;

/// A square of two regions with a segment between them, markers and heights.
fn square() -> DomainData {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.1, 0.3]];
    let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
    let region = |at: [f64; 2], attribute| Region {
        at: at.into(),
        attribute,
        max_area: None,
    };
    DomainData {
        vertices: PointSet {
            points: points.map(Point::from).to_vec(),
            attributes: vec![Attribute {
                name: "z".to_owned(),
                values: vec![1.0, 2.5, 4.0, 8.0, 0.1],
            }],
            markers: Some(vec![1, -2, 3, 4, 0]),
            ..PointSet::default()
        },
        segments: segments.map(|s| s.map(VertexId::from)).to_vec(),
        segment_markers: Some(vec![7, 8, 9, 10, -5]),
        regions: vec![region([3.0, 1.0], 30.0), region([1.0, 3.0], 40.0)],
        usual_rule: DomainRule::Carve,
        ..DomainData::default()
    }
}

fn with_mesh<T>(domain: DomainData, use_it: impl FnOnce(&MeshView<'_>) -> T) -> T {
    let mut domain = domain;
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    let result = builder.triangulate(domain.take_pslg()).expect("a domain");
    let inherited = Inherited::new(&result, domain, &()).expect("its own domain");
    use_it(&MeshView::constrained(&result, &inherited))
}

fn write(mesh: &MeshView<'_>, path: &Path, options: &WriteOptions) -> Result<(), Error> {
    write_mesh(&[Target::from_arg(path, None)], mesh, options, &()).map(drop)
}

fn read(path: &Path) -> MeshData {
    let mesh = read_mesh(&Source::from_arg(path), &ReadOptions::default(), &());
    mesh.unwrap_or_else(|error| panic!("{error}"))
}

fn lattice(side: usize) -> Vec<Point> {
    let place = |i: usize| Point::new((i % side) as f64, (i / side) as f64);
    (0..side * side).map(place).collect()
}

#[test]
fn medit_keeps_triangles_markers_and_regions() {
    let folder = tempfile::tempdir().expect("folder");
    for quadratic in [false, true] {
        let path = folder.path().join(format!("{quadratic}.mesh"));
        let (triangles, regions, edges, points) = with_mesh(square(), |mesh| {
            let mesh = if quadratic { mesh.quadratic() } else { *mesh };
            write(&mesh, &path, &WriteOptions::default()).expect("written");
            let constraints = mesh.constraints.expect("constraints");
            (
                mesh.triangles.to_vec(),
                constraints.region_of.clone().expect("regions"),
                constraints.clone(),
                mesh.points.to_vec(),
            )
        });
        let text = std::fs::read_to_string(&path).expect("text");
        assert!(
            text.starts_with("MeshVersionFormatted 2\n\nDimension 2\n\nVertices\n"),
            "{text}"
        );
        let cells = if quadratic {
            "\nTrianglesP2\n"
        } else {
            "\nTriangles\n"
        };
        assert!(text.contains(cells) && text.ends_with("\nEnd\n"), "{text}");
        let back = read(&path);
        assert_eq!(back.quadratic, quadratic);
        assert_eq!(back.vertices.points, points);
        assert_eq!(back.vertices.markers, Some(vec![1, -2, 3, 4, 0]));
        assert_eq!(back.triangles, triangles);
        let expected: Vec<f64> = regions
            .iter()
            .map(|r| r.map_or(0.0, |r| f64::from(r) + 1.0))
            .collect();
        assert_eq!(back.triangle_attributes[0].values, expected);
        assert!(expected.contains(&1.0) && expected.contains(&2.0));
        let constraints = back.constraints.expect("edges");
        assert_eq!(constraints.edges, edges.edges);
        assert_eq!(constraints.markers, edges.markers);
    }
}

#[test]
fn medit_takes_domains_and_points_and_refuses_seeds() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("d.mesh");
    let target = [Target::from_arg(&path, None)];
    let refused = write_domain(&target, &square(), &WriteOptions::default(), &());
    let message = refused.expect_err("regions").to_string();
    assert!(message.ends_with(
        "format mesh cannot hold holes and regions that are named by points; use one of poly"
    ));
    assert!(!path.exists());
    let domain = DomainData {
        regions: Vec::new(),
        ..square()
    };
    write_domain(&target, &domain, &WriteOptions::default(), &()).expect("written");
    let back = read_domain(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("read");
    assert_eq!(back.segments, domain.segments);
    assert_eq!(back.segment_markers, domain.segment_markers);
    assert_eq!(back.vertices.points, domain.vertices.points);
    write_points(&target, &domain.vertices, &WriteOptions::default(), &()).expect("written");
    let back = read_points(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("read");
    assert_eq!(
        (back.points, back.markers),
        (domain.vertices.points, domain.vertices.markers)
    );
}

/// Takes binary STL apart: normal and corners of each triangle.
fn facets(bytes: &[u8]) -> Vec<[[f32; 3]; 4]> {
    assert!(!bytes.starts_with(b"solid"));
    let count = u32::from_le_bytes(bytes[80..84].try_into().expect("four")) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    let number = |b: &[u8]| f32::from_le_bytes(b.try_into().expect("four"));
    let facet = |row: &[u8]| {
        let at = |i: usize| number(&row[4 * i..4 * i + 4]);
        [0, 1, 2, 3].map(|k| [0, 1, 2].map(|j| at(3 * k + j)))
    };
    bytes[84..].chunks_exact(50).map(facet).collect()
}

#[test]
fn stl_holds_heights_and_normals() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("s.stl");
    with_mesh(square(), |mesh| {
        write(mesh, &path, &WriteOptions::default()).expect("written");
        let facets = facets(&std::fs::read(&path).expect("bytes"));
        assert_eq!(facets.len(), mesh.triangles.len());
        let z = &mesh.attributes[0].values;
        for ([normal, corners @ ..], triangle) in facets.iter().zip(mesh.triangles) {
            for (corner, v) in corners.iter().zip(triangle) {
                let p = mesh.points[v.index()];
                assert_eq!(*corner, [p.x, p.y, z[v.index()]].map(|x| x as f32));
            }
            let dot = |along: usize| -> f32 {
                (0..3)
                    .map(|k| normal[k] * (corners[along][k] - corners[0][k]))
                    .sum()
            };
            assert!(dot(1).abs() < 1e-5 && dot(2).abs() < 1e-5 && normal[2] > 0.0);
            let length: f32 = normal.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-5);
        }
        let options = WriteOptions {
            ascii: true,
            ..WriteOptions::default()
        };
        write(mesh, &path, &options).expect("written");
        let text = std::fs::read_to_string(&path).expect("text");
        assert!(
            text.starts_with("solid delone\nfacet normal ")
                && text.ends_with("endfacet\nendsolid delone\n")
        );
        assert_eq!(
            text.matches("outer loop\nvertex ").count(),
            mesh.triangles.len()
        );
        // Text keeps all digits.
        assert!(text.contains("vertex 0.1 0.3 0.1\n"), "{text}");
    });
}

#[test]
fn stl_refuses_what_is_no_height() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("s.stl");
    let mut domain = square();
    domain.vertices.attributes[0].values[3] = f64::NAN;
    let message = with_mesh(domain, |mesh| write(mesh, &path, &WriteOptions::default()));
    assert_eq!(
        message.expect_err("no height").to_string(),
        "cannot write the mesh: point 3 (numbered from 0) at (0, 4) has z NaN: STL needs finite heights; \
         remove it, or the attribute z"
    );
    let mut domain = square();
    domain.vertices.points[2].x = 1e39;
    let message = with_mesh(domain, |mesh| write(mesh, &path, &WriteOptions::default()));
    let message = message.expect_err("too large").to_string();
    assert!(
        message.ends_with("has a corner beyond single precision; write STL as text"),
        "{message}"
    );
    assert!(!path.exists());
}

#[test]
fn tikz_draws_what_there_is() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("p.tikz");
    let draw = |mesh: &MeshView<'_>| {
        write(mesh, &path, &WriteOptions::default()).expect("written");
        std::fs::read_to_string(&path).expect("text")
    };
    with_mesh(square(), |mesh| {
        let text = draw(mesh);
        assert!(text.contains("\\begin{tikzpicture}") && text.ends_with("\\end{tikzpicture}\n"));
        assert_eq!(
            text.matches("--cycle").count(),
            mesh.triangles.len() + 4,
            "triangles, and two regions twice"
        );
        assert_eq!(text.matches("circle").count(), mesh.points.len());
        // 12 cm, for a square.
        assert!(
            text.contains("(12.000,12.000)") && text.contains("(0.000,0.000)"),
            "{text}"
        );
        assert_eq!(
            text.matches("\\begin{scope}").count(),
            text.matches("\\end{scope}").count()
        );
        assert_eq!(
            draw(&mesh.quadratic()).matches("--cycle").count(),
            mesh.triangles.len() + 4
        );
    });
    let points = PointSet {
        points: lattice(10),
        ..PointSet::default()
    };
    let target = [Target::from_arg(&path, None)];
    write_points(&target, &points, &WriteOptions::default(), &()).expect("written");
    let text = std::fs::read_to_string(&path).expect("text");
    assert_eq!(text.matches("circle").count(), 100);
}

#[test]
fn tikz_refuses_what_latex_cannot_do() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("p.tex");
    let t = delone::triangulate(lattice(102)).expect("points");
    let message = write(&MeshView::from(&t), &path, &WriteOptions::default());
    assert_eq!(
        message.expect_err("too many").to_string(),
        format!(
            "cannot draw {}: 20402 triangles, and LaTeX copes with 20000; write .svg or .png and include that",
            path.display()
        )
    );
    let t = delone::triangulate(lattice(100)).expect("points");
    write(&MeshView::from(&t), &path, &WriteOptions::default()).expect("19602 triangles");
}

#[test]
fn grids_are_read_back() {
    use delone::surface::{Evaluation, Grid, Linear, Samples};
    let t = delone::triangulate([(0.3, 0.1), (4.0, 0.0), (0.0, 4.0)]).expect("points");
    let samples = Samples::new(&t, [10.0, 20.0, 35.0]).expect("samples");
    let grid = Grid::with_cells((0.0, 0.0).into(), (4.0, 3.0).into(), 0.25).expect("grid");
    let raster = Evaluation::new()
        .raster(&Linear::new(&samples), grid)
        .expect("raster");
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("g.asc");
    let relief = Relief {
        raster: Some(&raster),
        contours: &[],
    };
    let target = [Target::from_arg(&path, None)];
    write_relief(&target, relief, &ReliefOptions::default(), &()).expect("written");
    let by_name =
        read_points(&Source::from_arg(&path), &ReadOptions::default(), &()).expect("read");
    let by_content = Source::Memory {
        name: "grid".to_owned(),
        bytes: std::fs::read(&path).expect("bytes"),
    };
    assert_eq!(
        read_points(&by_content, &ReadOptions::default(), &()).expect("read"),
        by_name
    );
    let mut expected = Vec::new();
    for (r, row) in raster.rows().enumerate() {
        for (c, &value) in row.iter().enumerate() {
            if !value.is_nan() {
                let (x, y) = (0.125 + 0.25 * c as f64, 2.875 - 0.25 * r as f64);
                expected.push((x, y, value));
            }
        }
    }
    let z = &by_name.attributes[0].values;
    let found: Vec<_> = by_name
        .points
        .iter()
        .zip(z)
        .map(|(p, &z)| (p.x, p.y, z))
        .collect();
    assert!(found.len() > 20);
    assert_eq!(found, expected);
}
