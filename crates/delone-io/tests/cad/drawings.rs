//! Drawings, `.dxf`.

use crate::{area, data, domain, file, places, read, refuses};
use delone::{ConstrainedDelaunay, DomainRule, VertexId};
use delone_io::{
    Constraints, Format, MeshView, ReadOptions, Source, Target, WriteOptions, read_domain,
    write_mesh,
};

/// A drawing of these entities.
fn drawing(entities: &str) -> String {
    let body = entities.split_whitespace().collect::<Vec<_>>().join("\n");
    format!("0\nSECTION\n2\nENTITIES\n{body}\n0\nENDSEC\n0\nEOF\n")
}

const SQUARE: &str = "0 LWPOLYLINE 8 wall 90 4 70 1 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4";

#[test]
fn loops_within_loops_are_holes() {
    let text = drawing(&format!("{SQUARE} 0 CIRCLE 8 hole 10 2 20 2 40 1"));
    let domain = domain("a.dxf", &text);
    assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
    assert!(domain.polygons.is_empty(), "all close together");
    let markers = domain.segment_markers.clone().unwrap();
    assert_eq!(&markers[..5], [1, 1, 1, 1, 2]);
    assert_eq!(
        domain.vertices.notes,
        ["markers of segments are layers: 1 \"wall\", 2 \"hole\""]
    );
    assert!(domain.vertices.attributes.is_empty(), "z is zero");
    assert!((area(domain) - (16.0 - std::f64::consts::PI)).abs() < 0.02);
}

#[test]
fn lines_and_arcs_that_meet_close() {
    // A half disc: its arc ends exactly where the line does, as its angles are quarters.
    let arc = "0 ARC 8 0 10 3 20 5 40 2 50 0 51 180";
    let closed = domain(
        "a.dxf",
        &drawing(&format!("{arc} 0 LINE 8 0 10 1 20 5 11 5 21 5")),
    );
    assert_eq!(closed.usual_rule, DomainRule::EvenOdd);
    assert!(closed.vertices.notes.is_empty());
    let options = ReadOptions {
        flatness: Some(1e-4),
        ..ReadOptions::default()
    };
    let fine = drawing(&format!("{arc} 0 LINE 8 0 10 1 20 5 11 5 21 5"));
    let fine = read("a.dxf", fine.as_bytes(), &options).unwrap();
    assert!((area(fine) - 2.0 * std::f64::consts::PI).abs() < 1e-3);
    let open = domain(
        "a.dxf",
        &drawing(&format!("{arc} 0 LINE 8 0 10 1 20 5 11 5 21 5.01")),
    );
    assert_eq!(open.usual_rule, DomainRule::Hull);
    let [note] = &open.vertices.notes[..] else {
        panic!("{:?}", open.vertices.notes)
    };
    assert!(note.starts_with("lines end loosely in 2 places"), "{note}");
}

#[test]
fn layers_are_picked() {
    let text = drawing(&format!(
        "{SQUARE} 0 CIRCLE 8 hole 10 2 20 2 40 1 0 POINT 8 marks 10 9 20 9"
    ));
    let with = |layers: &[&str]| {
        let options = ReadOptions {
            layers: layers.iter().map(|l| (*l).to_owned()).collect(),
            ..ReadOptions::default()
        };
        read("a.dxf", text.as_bytes(), &options)
    };
    let hole = with(&["HOLE"]).unwrap();
    assert!(
        hole.segment_markers.unwrap().iter().all(|m| *m == 2),
        "as without picking"
    );
    assert_eq!(places(&with(&["marks"]).unwrap()), [[9.0, 9.0]]);
    let error = with(&["marks", "roof"]).unwrap_err().to_string();
    assert_eq!(
        error,
        "a.dxf: no layer \"roof\"; there are \"wall\", \"hole\", \"marks\""
    );
}

#[test]
fn blocks_are_inserted() {
    let block = "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 Bolt 70 0 10 1 20 1 30 0 \
        0 LINE 8 0 10 1 20 1 11 3 21 1 0 POINT 8 own 10 1 20 2 30 7 0 ENDBLK 8 0 \
        0 BLOCK 2 twice 10 0 20 0 0 INSERT 8 0 2 BOLT 10 0 20 0 0 ENDBLK 0 ENDSEC";
    let read_with = |insert: &str| {
        let text = drawing(insert);
        let block = block.split_whitespace().collect::<Vec<_>>().join("\n");
        domain("a.dxf", &format!("{block}\n{text}"))
    };
    let once = read_with("0 INSERT 8 steel 2 bolt 10 10 20 20 41 2 42 3 50 90");
    assert_eq!(places(&once), [[10.0, 20.0], [10.0, 24.0], [7.0, 20.0]]);
    assert_eq!(once.vertices.attributes[0].values, [0.0, 0.0, 7.0]);
    assert!(
        once.vertices.notes[0].contains("1 \"steel\", 2 \"own\""),
        "{:?}",
        once.vertices.notes
    );
    let array = read_with("0 INSERT 8 steel 2 bolt 10 0 20 0 70 3 71 2 44 10 45 100");
    let loose = [4, 7, 10, 13, 16].map(|i| places(&array)[i - 2]);
    assert_eq!(array.vertices.points.len(), 18);
    assert_eq!(loose[0], [0.0 + 0.0, 1.0]);
    assert_eq!(
        places(&array)[15..],
        [[20.0, 100.0], [22.0, 100.0], [20.0, 101.0]]
    );
    let nested = read_with("0 INSERT 8 steel 2 twice 10 5 20 5 210 0 220 0 230 -1");
    assert_eq!(places(&nested)[0], [-5.0, 5.0], "mirrored");
    assert_eq!(places(&nested)[1], [-7.0, 5.0]);
    let missing = read_with("0 INSERT 8 steel 2 nut 10 5 20 5");
    assert_eq!(
        missing.vertices.notes,
        ["left out: 1 INSERT of \"nut\", which is no block"]
    );
}

#[test]
fn what_is_not_read_is_said() {
    let text = drawing(&format!(
        "{SQUARE} 0 TEXT 8 0 1 Text 0 HATCH 8 0 0 TEXT 8 0 0 LINE 67 1 8 0 10 0 20 0 11 1 21 1 \
         0 SPLINE 8 0 70 8 71 3 74 2 11 0 21 0 11 1 21 1"
    ));
    let notes = domain("a.dxf", &text).vertices.notes;
    let [_, note] = &notes[..] else {
        panic!("{notes:?}")
    };
    assert_eq!(
        note,
        "left out: 1 HATCH, 1 SPLINE without control points, 2 TEXT and 1 on paper"
    );
    let frozen = format!(
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nWALL\n70\n1\n62\n7\n0\nENDTAB\n0\nENDSEC\n{}",
        drawing(SQUARE)
    );
    let notes = domain("a.dxf", &frozen).vertices.notes;
    assert_eq!(notes.len(), 1);
    assert!(
        notes[0].ends_with("frozen or off, as --layer does not say otherwise: \"WALL\""),
        "{notes:?}"
    );
}

#[test]
fn faces_are_areas() {
    let faces = "0 3DFACE 8 0 10 0 20 0 30 1 11 2 21 0 31 2 12 2 22 2 32 3 13 2 23 2 33 3 \
        0 3DFACE 8 0 10 0 20 0 30 1 11 2 21 2 31 3 12 0 22 2 32 4 13 0 23 2 33 4 \
        0 LINE 8 0 10 0 20 0 11 2 21 2 0 SOLID 8 0 10 5 20 0 11 6 21 0 12 5 22 1 13 6 23 1";
    let domain = domain("a.dxf", &drawing(faces));
    assert_eq!(domain.polygons, [0..3, 3..6, 6..10]);
    assert_eq!(domain.vertices.attributes[0].values[..3], [1.0, 2.0, 3.0]);
    assert_eq!(area(domain), 5.0);
    // Loops come before the borders of faces, and are a polygon of their own.
    let mixed = crate::domain("a.dxf", &drawing(&format!("{faces} {SQUARE}")));
    assert_eq!(mixed.polygons, [4..7, 7..10, 10..14, 0..4]);
}

#[test]
fn polylines_of_one_vertex_are_points() {
    let text = drawing("0 LWPOLYLINE 8 0 10 3 20 4 0 LWPOLYLINE 8 0 70 1 10 5 20 6");
    let domain = domain("a.dxf", &text);
    assert_eq!(places(&domain), [[3.0, 4.0], [5.0, 6.0]]);
    assert!(domain.segments.is_empty());
}

#[test]
fn old_polylines_have_vertices_of_their_own() {
    let text = drawing(
        "0 POLYLINE 8 0 66 1 70 1 10 0 20 0 30 5 0 VERTEX 8 0 10 0 20 0 42 1 0 VERTEX 8 0 10 2 20 0 42 1 0 SEQEND \
         0 POLYLINE 8 0 66 1 70 8 0 VERTEX 8 0 10 9 20 9 30 1 0 VERTEX 8 0 10 8 20 9 30 2 0 SEQEND \
         0 POLYLINE 8 0 70 16 0 VERTEX 8 0 10 1 20 1 0 SEQEND",
    );
    let domain = domain("a.dxf", &text);
    let z = &domain.vertices.attributes[0].values;
    let n = z.len();
    assert!(z[..n - 2].iter().all(|z| *z == 5.0) && z[n - 2..] == [1.0, 2.0]);
    assert!(n > 40, "two half circles: {n}");
    assert_eq!(domain.segments.len(), n - 2 + 1);
    assert!(domain.vertices.notes[0].contains("1 POLYLINE that is a mesh"));
}

/// Broken drawings, and what must be said.
#[test]
fn broken_drawings_name_the_line() {
    refuses("a.dxf", "", "a.dxf:1: the file is empty");
    refuses(
        "a.dxf",
        "0\nSECTION\n2\nENTITIES\n",
        "a.dxf:4: truncated: the file ends before 0 EOF",
    );
    refuses(
        "a.dxf",
        "0\nSECTION\n2\nENTITIES\n0",
        "a.dxf:5: truncated: the file ends before the value",
    );
    refuses(
        "a.dxf",
        "zero\nSECTION\n",
        "a.dxf:1: the code of a group is not a number: \"zero\"",
    );
    let cases = [
        (
            "0 POINT 8 0 10 one 20 2",
            "a.dxf:10: the value of group 10 is not a number: \"one\"",
        ),
        (
            "0 POINT 8 0 10 nan 20 2",
            "a.dxf:10: the value of group 10 is nan, numbers must be finite",
        ),
        ("0 POINT 8 0 20 2", "a.dxf:6: group 10, x, is missing"),
        (
            "0 CIRCLE 8 0 10 0 20 0",
            "a.dxf:6: group 40, the radius, is missing",
        ),
        (
            "0 LWPOLYLINE 8 0 20 3",
            "a.dxf:10: group 20 of a vertex before its x",
        ),
        (
            "0 LWPOLYLINE 8 0 10 3",
            "a.dxf:6: vertex 1 of the polyline has no y",
        ),
        (
            "0 SPLINE 8 0 71 3 10 0 20 0",
            "a.dxf:6: a spline of degree 3 with 1 control points and 0 knots",
        ),
        (
            "0 CIRCLE 8 0 10 0 20 0 40 1e200",
            "a.dxf:6: a point of the curve is farther out than 1e150",
        ),
    ];
    for (entity, expected) in cases {
        refuses("a.dxf", &drawing(entity), expected);
    }
}

#[test]
fn insertions_are_bounded() {
    let nested = |inner: &str, outer: &str| {
        let block = format!("0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 {inner} 0 ENDBLK 0 ENDSEC");
        let block = block.split_whitespace().collect::<Vec<_>>().join("\n");
        format!("{block}\n{}", drawing(outer))
    };
    let once = "0 INSERT 2 B 10 0 20 0";
    refuses(
        "a.dxf",
        &nested(once, once),
        "block \"B\" lies in more than 32 others, or in itself",
    );
    let many = "0 INSERT 2 B 10 0 20 0 70 32767 71 32767";
    refuses("a.dxf", &nested("", many), "blocks are inserted too often");
    refuses(
        "a.dxf",
        &nested("0 POINT 8 0 10 0 20 0", many),
        "blocks are inserted too often",
    );
    // Two insertions of itself in each: without bound, 2^32 of them.
    refuses(
        "a.dxf",
        &nested(&format!("{once} {once}"), once),
        "more than 32 others",
    );
}

#[test]
fn text_and_binary_say_the_same() {
    let [text, binary] =
        ["plate-r12.dxf", "plate-binary.dxf"].map(|n| file(n, &ReadOptions::default()));
    assert_eq!(text.vertices, binary.vertices);
    assert_eq!(text.segments, binary.segments);
    assert_eq!(text.segment_markers, binary.segment_markers);
    let notes = &text.vertices.notes;
    assert!(
        notes[0].contains("1 \"plate\", 2 \"holes\", 3 \"lines\""),
        "{notes:?}"
    );
    assert_eq!(notes[1], "left out: 1 TEXT");
    for name in ["plate-r12.dxf", "plate-binary.dxf"] {
        let head = std::fs::read(data(name)).unwrap();
        assert_eq!(Format::sniff(&head), Some(Format::Dxf));
    }
}

#[test]
fn all_curves_are_read() {
    let domain = file("curves.dxf", &ReadOptions::default());
    assert!(
        domain.vertices.notes.is_empty(),
        "{:?}",
        domain.vertices.notes
    );
    // Arcs are open, but faces are areas: two of them, and what the loops enclose.
    assert_eq!(domain.polygons.len(), 3);
    assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
    let z = &domain.vertices.attributes[0].values;
    assert!(
        z.iter().any(|z| *z > 5.0) && z.contains(&0.0),
        "a tilted circle"
    );
}

#[test]
fn meshes_come_back_from_drawings() {
    let mut square = domain(
        "a.dxf",
        &drawing(&format!(
            "{SQUARE} 0 LINE 8 9 10 0.1 20 0.1 11 1 21 0.3333333333333333"
        )),
    );
    square.usual_rule = DomainRule::Hull;
    let graph = square.take_pslg();
    let result = ConstrainedDelaunay::new().triangulate(graph).unwrap();
    let inherited = delone_io::Inherited::new(&result, square, &()).unwrap();
    let mesh = MeshView::constrained(&result, &inherited);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.dxf");
    let target = Target::from_arg(&path, None);
    write_mesh(&[target], &mesh, &WriteOptions::default(), &()).unwrap();
    let back = read_domain(&Source::Path(path), &ReadOptions::default(), &()).unwrap();
    assert_eq!(
        back.polygons.len(),
        mesh.triangles.len(),
        "a polygon for each triangle"
    );
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let found = &back.vertices.points[3 * t..3 * t + 3];
        assert!(
            corners
                .iter()
                .zip(found)
                .all(|(v, p)| mesh.points[v.index()] == *p),
            "bit for bit"
        );
    }
    assert_eq!(back.usual_rule, DomainRule::EvenOdd);
    let layers = &back.vertices.notes[0];
    assert!(
        layers.contains("1 \"TRIANGLES\", 2 \"SEGMENTS_1\", 3 \"SEGMENTS_2\""),
        "{layers}"
    );
    assert_eq!(area(back), 16.0);
}

#[test]
fn lines_and_loose_points_are_written_too() {
    let points = [[0.0, 0.0], [1.0, 0.0], [7.0, -3.5e-9]].map(delone::Point::from);
    let edges = vec![[VertexId::new(0), VertexId::new(1)]];
    let constraints = Constraints {
        edges,
        markers: Some(vec![-7]),
        ..Constraints::default()
    };
    let mesh = MeshView::new(&points, &[]).with_constraints(&constraints);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("few.dxf");
    let target = Target::from_arg(&path, None);
    write_mesh(&[target], &mesh, &WriteOptions::default(), &()).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("SEGMENTS_-7"));
    let back = read_domain(&Source::Path(path), &ReadOptions::default(), &()).unwrap();
    assert_eq!(back.vertices.points, points);
    assert_eq!(back.segments.len(), 1);
}
