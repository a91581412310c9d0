//! Triangulated domains: what they inherit, and that files keep it.

use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Region, SegmentPolicy,
    VertexId,
};
use delone_io::{
    Attribute, Constraints, DomainData, Error, Inherited, MeshData, MeshView, PointSet,
    ReadOptions, Source, Target, WriteOptions, read_domain, read_mesh, write_domain, write_mesh,
};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

fn ids<const N: usize>(segments: [[usize; 2]; N]) -> Vec<[VertexId; 2]> {
    segments.map(|s| s.map(VertexId::new)).to_vec()
}

fn triangulate(domain: &mut DomainData, rule: DomainRule) -> ConstrainedTriangulation {
    let pslg = domain.take_pslg();
    ConstrainedDelaunay::new()
        .crossings(SegmentPolicy::Split)
        .domain(rule)
        .triangulate(pslg)
        .expect("a domain")
}

fn inherit(domain: &DomainData, rule: DomainRule) -> (ConstrainedTriangulation, Inherited) {
    let mut domain = domain.clone();
    let result = triangulate(&mut domain, rule);
    let inherited = Inherited::new(&result, domain, &()).expect("its own domain");
    (result, inherited)
}

/// Writes a mesh under these names and returns the folder.
fn written(mesh: &MeshView<'_>, names: &[&str], one_based: bool) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    let targets: Vec<_> = names
        .iter()
        .map(|name| Target::from_arg(folder.path().join(name), None))
        .collect();
    let options = WriteOptions {
        one_based,
        ..WriteOptions::default()
    };
    write_mesh(&targets, mesh, &options, &()).expect("written");
    folder
}

fn mesh_at(path: &Path) -> MeshData {
    read_mesh(&Source::from_arg(path), &ReadOptions::default(), &()).expect("written by us")
}

fn domain_at(path: &Path) -> DomainData {
    read_domain(&Source::from_arg(path), &ReadOptions::default(), &()).expect("written by us")
}

/// A square from 0 to 8, both diagonals, which cross in (4, 4), the lower one twice, a hole below,
/// two regions, and an open line outside.
fn square() -> DomainData {
    let points = [
        (0.0, 0.0),
        (8.0, 0.0),
        (8.0, 8.0),
        (0.0, 8.0),
        (9.0, 0.0),
        (9.0, 8.0),
    ];
    let region = |x, attribute, max_area| Region {
        at: Point::new(x, 4.0),
        attribute,
        max_area,
    };
    DomainData {
        vertices: PointSet {
            points: points.map(Point::from).to_vec(),
            attributes: vec![Attribute {
                name: "attribute1".to_owned(),
                values: vec![0.0, 10.0, 20.0, 50.0, 1.5, f64::NAN],
            }],
            markers: Some(vec![1, 2, 3, 4, 5, 6]),
            ..PointSet::default()
        },
        segments: ids([
            [0, 1],
            [1, 2],
            [2, 3],
            [3, 0],
            [1, 3],
            [0, 2],
            [2, 0],
            [4, 5],
        ]),
        segment_markers: Some(vec![11, 0, 13, 14, 15, 0, 16, 17]),
        holes: vec![Point::new(4.0, 1.0)],
        regions: vec![region(1.0, 7.0, Some(0.5)), region(7.0, -3.5, None)],
        usual_rule: DomainRule::Carve,
        ..DomainData::default()
    }
}

#[test]
fn data_travel_along_the_lineage() {
    let (result, inherited) = inherit(&square(), DomainRule::Carve);
    assert_eq!(result.num_crossings(), 1);
    // The first of the segments that cross is 1–3, from 10 to 50.
    assert_eq!(inherited.attributes[0].values[6], 30.0);
    assert_eq!(inherited.markers, Some(vec![1, 2, 3, 4, 5, 6, 15]));
    let markers = inherited.constraints.markers.as_deref().expect("markers");
    let edges = inherited.constraints.edges.iter().copied();
    let marker_of: BTreeMap<_, _> = edges.zip(markers.iter().copied()).collect();
    let expected = [
        ([0, 1], 11),
        ([0, 3], 14),
        ([0, 6], 16), // of its two segments the first has no marker
        ([1, 2], 0),
        ([1, 6], 15),
        ([2, 3], 13),
        ([2, 6], 16),
        ([3, 6], 15),
        ([4, 5], 17), // carved away, but not forgotten
    ];
    let expected = expected.map(|(ends, marker)| (ends.map(VertexId::new), marker));
    assert_eq!(marker_of, BTreeMap::from(expected));
    let known: BTreeSet<_> = result
        .constrained_edges()
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    assert_eq!(known, marker_of.into_keys().collect());
    assert_eq!(result.triangulation().num_triangles(), 3);
    let mut of_regions = inherited.triangle_attributes[0].values.clone();
    of_regions.sort_by(f64::total_cmp);
    assert_eq!(of_regions, [-3.5, 0.0, 7.0]);
}

#[test]
fn data_of_another_domain_are_refused() {
    let mut domain = square();
    let result = triangulate(&mut domain, DomainRule::Hull);
    let refused = |change: fn(&mut DomainData), expected: &str| {
        let mut other = domain.clone();
        change(&mut other);
        let error = Inherited::new(&result, other, &()).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}");
    };
    refused(
        |d| d.segment_markers = Some(vec![1]),
        "1 markers of segments for 8",
    );
    refused(
        |d| d.vertices.markers = Some(vec![]),
        "0 markers of points for 6",
    );
    refused(
        |d| d.vertices.attributes[0].values.clear(),
        "0 attributes of points for 6",
    );
}

#[test]
fn the_family_of_a_domain_is_written_as_triangle_does() {
    let (result, inherited) = inherit(&square(), DomainRule::Carve);
    let mesh = MeshView::constrained(&result, &inherited);
    let folder = written(&mesh, &["s.ele"], true);
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect(name);
    assert_eq!(
        text("s.poly"),
        "0 2 1 1\n\
         9 1\n1 1 2 11\n2 1 4 14\n3 1 7 16\n4 2 3 1\n5 2 7 15\n6 3 4 13\n7 3 7 16\n8 4 7 15\n9 5 6 17\n\
         1\n1 4 1\n\
         2\n1 1 4 7 0.5\n2 7 4 -3.5 -1\n"
    );
    assert!(text("s.node").starts_with("7 2 1 1\n1 0 0 0 1\n"));
    assert!(text("s.node").contains("\n6 9 8 NaN 6\n7 4 4 30 15\n"));
    assert!(text("s.ele").starts_with("3 3 1\n"));
    let edges = text("s.edge");
    let mut markers: Vec<_> = edges
        .lines()
        .skip(1)
        .map(|row| row.rsplit(' ').next())
        .collect();
    markers.sort();
    let expected = ["1", "13", "14", "15", "15", "16", "16"].map(Some);
    assert_eq!(markers, expected, "the edges of triangles alone");
}

#[test]
fn every_format_keeps_what_it_can() {
    let (result, inherited) = inherit(&square(), DomainRule::Carve);
    let view = MeshView::constrained(&result, &inherited);
    let names = ["s.poly", "s.vtu", "s.npy", "s.geojson", "s.svg", "s.png"];
    let folder = written(&view, &names, false);
    let files = std::fs::read_dir(folder.path()).expect("folder").count();
    assert_eq!(files, 5 + 1 + 3 + 1 + 2);

    let family = mesh_at(&folder.path().join("s.ele"));
    let constraints = family.constraints.expect("constraints");
    let kept = &inherited.constraints;
    assert_eq!(constraints.edges, kept.edges);
    assert_eq!(
        (&constraints.holes, &constraints.regions),
        (&kept.holes, &kept.regions)
    );
    let domain = domain_at(&folder.path().join("s.poly"));
    assert_eq!(domain.vertices.points, result.triangulation().points());
    assert_eq!(domain.segments, kept.edges);
    assert_eq!(domain.segment_markers, constraints.markers);

    let grid = mesh_at(&folder.path().join("s.vtu"));
    assert_eq!(grid.triangles, result.triangulation().triangles());
    let lines = grid.constraints.expect("lines");
    assert_eq!(
        (lines.edges, lines.markers),
        (constraints.edges, constraints.markers)
    );
    let names = grid.triangle_attributes.iter().map(|a| a.name.as_str());
    assert_eq!(names.collect::<Vec<_>>(), ["attribute", "region"]);
    assert_eq!(
        grid.triangle_attributes[0],
        inherited.triangle_attributes[0]
    );

    let features = domain_at(&folder.path().join("s.geojson"));
    assert_eq!(features.polygons.len(), 3);
    assert_eq!(features.segments.len(), 3 * 3 + 9);
    let text = std::fs::read_to_string(folder.path().join("s.geojson")).expect("features");
    assert!(text.contains("{\"region\":1,\"attribute\":-3.5}"), "{text}");
    assert!(text.contains("{\"region\":null,\"attribute\":0}"), "{text}");
    assert!(text.contains("{\"marker\":17}"), "{text}");
}

#[test]
fn a_graph_with_points_of_its_own_is_no_part_of_a_mesh() {
    let domain = square();
    let (result, inherited) = inherit(&domain, DomainRule::Hull);
    let folder = written(
        &MeshView::constrained(&result, &inherited),
        &["s.ele"],
        false,
    );
    let poly = folder.path().join("s.poly");
    let targets = [Target::from_arg(&poly, None)];
    write_domain(&targets, &domain, &WriteOptions::default(), &()).expect("written");
    assert_eq!(mesh_at(&folder.path().join("s.ele")).constraints, None);
    std::fs::write(&poly, "0 2 0 0\n1 0\n0 0 99\n0\n").expect("written");
    let outcome = read_mesh(
        &Source::from_arg(folder.path().join("s.node")),
        &ReadOptions::default(),
        &(),
    );
    let error = outcome.expect_err("a bad segment").to_string();
    assert!(
        error.contains("s.poly:3: segment 0 names vertex 99 of 7"),
        "{error}"
    );
}

#[test]
fn a_graph_does_not_outlive_its_mesh() {
    let (result, inherited) = inherit(&square(), DomainRule::Hull);
    let folder = written(
        &MeshView::constrained(&result, &inherited),
        &["s.ele"],
        false,
    );
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
    let triangles = [[0, 1, 2]].map(|t| t.map(VertexId::new));
    let target = Target::from_arg(folder.path().join("s.ele"), None);
    let mesh = MeshView::new(&points, &triangles);
    write_mesh(&[target], &mesh, &WriteOptions::default(), &()).expect("written");
    let copy = mesh_at(&folder.path().join("s.ele"));
    assert_eq!((copy.triangles.len(), copy.constraints), (1, None));
}

#[test]
fn bad_constraints_are_not_written() {
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
    let triangles = [[0, 1, 2]].map(|t| t.map(VertexId::new));
    let constraints = Constraints {
        edges: ids([[0, 3]]),
        ..Constraints::default()
    };
    let mesh = MeshView::new(&points, &triangles).with_constraints(&constraints);
    let error = write_mesh(&[], &mesh, &WriteOptions::default(), &()).expect_err("vertex 3");
    assert!(
        error
            .to_string()
            .contains("constrained edge 0 names vertex 3 of 3"),
        "{error}"
    );
}

#[test]
fn formats_that_cannot_hold_segments_say_so() {
    let folder = tempfile::tempdir().expect("folder");
    let write = |name: &str, domain: &DomainData| {
        let target = Target::from_arg(folder.path().join(name), None);
        write_domain(&[target], domain, &WriteOptions::default(), &())
    };
    let error = write("a.csv", &square()).expect_err("segments").to_string();
    assert!(
        error.contains("format csv cannot hold segments; use one of poly, geojson, vtu"),
        "{error}"
    );
    let error = write("a.geojson", &square())
        .expect_err("a hole")
        .to_string();
    assert!(error.contains("holes and regions"), "{error}");
    let bare = DomainData::from(square().vertices);
    assert!(write("a.csv", &bare).is_ok());
    let torn = DomainData {
        polygons: std::iter::once(0..3).collect(),
        holes: vec![],
        regions: vec![],
        ..square()
    };
    let outcome = write("a.geojson", &torn);
    assert!(matches!(outcome, Err(Error::BadMesh(_))), "{outcome:?}");
}

prop_compose! {
    /// Any segments between lattice points, with all that goes with them.
    fn lattice()(
        points in prop::collection::vec((0..6i32, 0..6i32, any::<i32>()), 2..14),
        seeds in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), -2..3i32), 0..16),
        regions in prop::collection::vec((0..6i32, 0..6i32, -4..4i32, prop::option::of(1..9i32)), 0..4),
    ) -> DomainData {
        let n = points.len();
        let half = |v: i32| f64::from(v) + 0.37;
        DomainData {
            vertices: PointSet {
                points: points.iter().map(|p| Point::new(p.0.into(), p.1.into())).collect(),
                attributes: vec![Attribute {
                    name: "z".to_owned(),
                    values: points.iter().map(|p| f64::from(p.2) / 7.0).collect(),
                }],
                markers: None,
                ..PointSet::default()
            },
            segments: seeds.iter().map(|s| [s.0, s.1].map(|i| VertexId::new(i.index(n)))).collect(),
            segment_markers: Some(seeds.iter().map(|s| s.2).collect()),
            regions: regions.iter().map(|r| Region {
                at: Point::new(half(r.0) , half(r.1) + 0.0137),
                attribute: r.2.into(),
                max_area: r.3.map(f64::from),
            }).collect(),
            usual_rule: if seeds.is_empty() { DomainRule::Hull } else { DomainRule::Carve },
            ..DomainData::default()
        }
    }
}

prop_compose! {
    /// Polygons of several rings, lines and loose points, each with points of its own.
    fn shapes()(
        polygons in prop::collection::vec(prop::collection::vec(3..6usize, 1..3), 0..4),
        lines in prop::collection::vec(2..5usize, 0..3),
        loose in 0..3usize,
    ) -> DomainData {
        let mut pslg = delone::Pslg::default();
        let ring = |n: usize, closed: bool, points: &mut usize, pslg: &mut delone::Pslg| {
            let vertices = (*points..*points + n).map(VertexId::new);
            *points += n;
            if closed { pslg.add_ring(vertices) } else { pslg.add_polyline(vertices) }
        };
        let mut count = 0;
        for rings in polygons {
            let start = pslg.segments.len();
            rings.into_iter().for_each(|n| ring(n, true, &mut count, &mut pslg));
            pslg.polygons.push(start..pslg.segments.len());
        }
        lines.into_iter().for_each(|n| ring(n, false, &mut count, &mut pslg));
        pslg.points = (0..count + loose).map(|i| Point::new(i as f64 / 3.0, (i * i % 17) as f64)).collect();
        let mut domain = DomainData::from(pslg);
        if domain.polygons.is_empty() {
            domain.usual_rule = DomainRule::Hull;
        }
        domain
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn domains_survive_poly(domain in lattice(), one_based: bool) {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("a.poly");
        let options = WriteOptions { one_based, ..WriteOptions::default() };
        write_domain(&[Target::from_arg(&path, None)], &domain, &options, &()).expect("written");
        let mut copy = domain_at(&path);
        prop_assert_eq!(copy.vertices.base, u32::from(one_based));
        copy.vertices.base = 0;
        copy.vertices.lines = domain.vertices.lines.clone();
        copy.vertices.attributes[0].name = "z".to_owned();
        prop_assert_eq!(copy, domain);
    }

    #[test]
    fn domains_survive_geojson(domain in shapes()) {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("a.geojson");
        write_domain(&[Target::from_arg(&path, None)], &domain, &WriteOptions::default(), &()).expect("written");
        let copy = domain_at(&path);
        prop_assert_eq!(copy.vertices.points, domain.vertices.points);
        prop_assert_eq!(copy.segments, domain.segments);
        prop_assert_eq!(copy.polygons, domain.polygons);
        prop_assert_eq!(copy.usual_rule, domain.usual_rule);
    }

    #[test]
    fn meshes_of_domains_survive(domain in lattice(), carve: bool) {
        let rule = if carve { DomainRule::Carve } else { DomainRule::Hull };
        let mut source = domain.clone();
        let pslg = source.take_pslg();
        let builder = ConstrainedDelaunay::new().crossings(SegmentPolicy::Split).domain(rule);
        // A region's seed may lie on a segment.
        let Ok(result) = builder.triangulate(pslg) else { return Ok(()) };
        let inherited = Inherited::new(&result, source, &()).expect("its own domain");
        let view = MeshView::constrained(&result, &inherited);
        let folder = written(&view, &["a.ele", "a.vtu", "a.geojson", "a.npy"], false);
        let [family, grid] = ["a.ele", "a.vtu"].map(|name| mesh_at(&folder.path().join(name)));
        for mesh in [&family, &grid] {
            prop_assert_eq!(&mesh.vertices.points, result.triangulation().points());
            prop_assert_eq!(&mesh.triangles, result.triangulation().triangles());
            let constraints = mesh.constraints.clone().unwrap_or_default();
            prop_assert_eq!(&constraints.edges, &inherited.constraints.edges);
            for (&given, read) in inherited.constraints.markers.iter().flatten().zip(constraints.markers.unwrap_or_default()) {
                prop_assert!(given == read || given == 0 && read == 1);
            }
        }
        let known: BTreeSet<_> = result.constrained_edges().map(|[a, b]| [a.min(b), a.max(b)]).collect();
        prop_assert_eq!(known, inherited.constraints.edges.iter().copied().collect());
        let features = domain_at(&folder.path().join("a.geojson"));
        prop_assert_eq!(features.polygons.len(), family.triangles.len());
        // The mesh is a domain again, and the same one.
        let mut again = domain_at(&folder.path().join("a.poly"));
        let rule = if carve { DomainRule::Carve } else { DomainRule::Hull };
        let hash = triangulate(&mut again, rule).triangulation().hash();
        prop_assert_eq!(hash, result.triangulation().hash());
    }
}
