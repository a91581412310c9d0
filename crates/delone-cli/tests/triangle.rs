//! `delone triangle` as scripts call it: switches in, files out.

mod support;

use std::collections::BTreeMap;
use support::Folder;

/// A square of side 4 with a segment from corner 1 to its centre, and a point outside; numbered
/// from 1. What is expected of it was compared with what Triangle 1.6 writes.
const SQUARE: &str = "\
6 2 0 1
1 0 0 0
2 4 0 0
3 4 4 3
4 0 4 0
5 2 2 0
6 9 9 0
5 1
1 1 2 0
2 2 3 7
3 3 4 0
4 4 1 0
5 1 5 5
0
";

/// A strip of 10 by 1 with a point close to its lower side, numbered from 0.
const STRIP: &str = "\
5 2 0 0
0 0 0
1 10 0
2 10 1
3 0 1
4 5 0.02
4 0
0 0 1
1 1 2
2 2 3
3 3 0
0
";

/// A square of side 6 around a square hole, with two regions on both sides of the middle.
const RING: &str = "\
10 2 0 0
1 0 0
2 3 0
3 6 0
4 6 6
5 3 6
6 0 6
7 2 2
8 4 2
9 4 4
10 2 4
12 0
1 1 2
2 2 3
3 3 4
4 4 5
5 5 6
6 6 1
7 7 8
8 8 9
9 9 10
10 10 7
11 2 7
12 5 10
1
1 3 3
2
1 1 3 0.25
2 5 3 2
";

fn with(name: &str, content: &str) -> Folder {
    let folder = Folder::new();
    folder.write(name, content);
    folder
}

/// The numbers in the rows of a file behind its header, which is the first row.
fn rows(folder: &Folder, name: &str) -> Vec<Vec<f64>> {
    let text = folder.read(name);
    let row = |line: &str| {
        line.split_whitespace()
            .map(|w| w.parse().expect("a number"))
            .collect()
    };
    text.lines().skip(1).map(row).collect()
}

/// Markers of vertices.
fn markers(folder: &Folder, name: &str) -> Vec<f64> {
    let last = |row: Vec<f64>| row[row.len() - 1];
    rows(folder, name).into_iter().map(last).collect()
}

/// Markers of the edges in an `.edge` file, or of the segments in the `.poly` file of a mesh.
fn edge_markers(folder: &Folder, name: &str) -> BTreeMap<[u32; 2], i32> {
    let rows = rows(folder, name);
    let edges = match name.ends_with(".poly") {
        true => &rows[1..=rows[0][0] as usize],
        false => &rows[..],
    };
    let edge = |row: &Vec<f64>| {
        let mut ends = [row[1] as u32, row[2] as u32];
        ends.sort();
        (ends, row[3] as i32)
    };
    edges.iter().map(edge).collect()
}

/// The corners of the triangles of a mesh.
fn triangles(folder: &Folder, stem: &str) -> Vec<[[f64; 2]; 3]> {
    let nodes = rows(folder, &format!("{stem}.node"));
    let base = nodes[0][0];
    let corner = |&v: &f64| {
        let row = &nodes[(v - base) as usize];
        [row[1], row[2]]
    };
    let triangle = |row: Vec<f64>| [1, 2, 3].map(|k| corner(&row[k]));
    let triangles = rows(folder, &format!("{stem}.ele"));
    triangles.into_iter().map(triangle).collect()
}

fn area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
}

fn smallest_angle(triangle: [[f64; 2]; 3]) -> f64 {
    let angle = |k: usize| {
        let [p, q, r] = [k, (k + 1) % 3, (k + 2) % 3].map(|k| triangle[k]);
        let [u, v] = [[q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]];
        let cross = u[0] * v[1] - u[1] * v[0];
        cross.atan2(u[0] * v[0] + u[1] * v[1]).to_degrees()
    };
    angle(0).min(angle(1)).min(angle(2))
}

fn worst_angle(folder: &Folder, stem: &str) -> f64 {
    let angles = triangles(folder, stem).into_iter().map(smallest_angle);
    angles.fold(60.0, f64::min)
}

fn total_area(folder: &Folder, stem: &str) -> f64 {
    triangles(folder, stem).into_iter().map(area).sum()
}

#[test]
fn a_graph_becomes_the_files_that_triangle_writes() {
    let folder = with("s.poly", SQUARE);
    let said = folder.run("triangle -pen s", 0);
    assert_eq!(
        folder.names(),
        [
            "s.1.edge",
            "s.1.ele",
            "s.1.neigh",
            "s.1.node",
            "s.1.poly",
            "s.poly"
        ]
    );
    assert!(
        folder
            .read("s.1.node")
            .starts_with("6 2 0 1\n1 0 0 5\n2 4 0 7\n")
    );
    assert_eq!(markers(&folder, "s.1.node"), [5.0, 7.0, 3.0, 1.0, 5.0, 0.0]);
    assert!(folder.read("s.1.ele").starts_with("4 3 0\n"));
    let segments = [
        ([1, 2], 1),
        ([2, 3], 7),
        ([3, 4], 1),
        ([1, 4], 1),
        ([1, 5], 5),
    ];
    let segments = BTreeMap::from(segments);
    assert!(folder.read("s.1.poly").starts_with("0 2 0 1\n5 1\n"));
    assert_eq!(edge_markers(&folder, "s.1.poly"), segments);
    let mut edges = segments;
    edges.extend([([2, 5], 0), ([3, 5], 0), ([4, 5], 0)]);
    assert_eq!(edge_markers(&folder, "s.1.edge"), edges);
    assert_eq!(rows(&folder, "s.1.neigh").len(), 4);
    for words in [
        "s.poly: 6 points",
        "6 vertices, 4 triangles, 8 edges",
        "wrote s.1.node",
    ] {
        assert!(said.stdout.contains(words), "{words}: {}", said.stdout);
    }
    assert_eq!(said.stderr, "");
}

#[test]
fn quiet_is_quiet_however_it_is_said() {
    let folder = with("s.poly", SQUARE);
    for line in [
        "triangle -pQ s",
        "-q triangle -p s",
        "triangle -p -Q s.poly",
    ] {
        let said = folder.run(line, 0);
        assert_eq!(said.stdout + &said.stderr, "", "{line}");
    }
}

#[test]
fn iterations_go_on_where_the_input_stands() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pQ s", 0);
    folder.run("triangle -rpQ s.1", 0);
    folder.run("triangle -Qr s.2.ele", 0);
    let names = folder.names();
    assert!(names.contains(&"s.2.poly".to_owned()));
    assert!(names.contains(&"s.3.ele".to_owned()));
    assert!(
        !names.contains(&"s.3.poly".to_owned()),
        "no graph was asked for"
    );
    assert_eq!(folder.read("s.2.node"), folder.read("s.1.node"));
    assert_eq!(folder.read("s.2.ele"), folder.read("s.1.ele"));
    assert_eq!(folder.read("s.2.poly"), folder.read("s.1.poly"));
    assert_eq!(folder.read("s.3.ele"), folder.read("s.1.ele"));
}

#[test]
fn files_may_be_left_out() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pPNQB s", 0);
    assert_eq!(folder.names(), ["s.1.ele", "s.poly"]);
    folder.run("triangle -pEBQe s", 0);
    assert_eq!(
        folder.names(),
        ["s.1.edge", "s.1.ele", "s.1.node", "s.1.poly", "s.poly"]
    );
    assert!(folder.read("s.1.node").starts_with("6 2 0 0\n1 0 0\n"));
    assert!(folder.read("s.1.poly").starts_with("0 2 0 0\n5 0\n1 1 2\n"));
    assert!(folder.read("s.1.edge").starts_with("8 0\n"));
}

#[test]
fn a_file_for_geomview_is_written_beside_the_others() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pgQ s", 0);
    assert_eq!(
        folder.names(),
        ["s.1.ele", "s.1.node", "s.1.off", "s.1.poly", "s.poly"]
    );
    // Its numbers begin with 0, whatever those of the others do.
    let corners = |row: &Vec<f64>| [row[1], row[2], row[3]];
    let of_family: Vec<_> = rows(&folder, "s.1.ele").iter().map(corners).collect();
    let off = rows(&folder, "s.1.off");
    assert_eq!(off[0], [6.0, of_family.len() as f64, 0.0]);
    assert_eq!(off[5], [2.0, 2.0, 0.0]);
    let of_off = off[7..].iter().map(|row| corners(row).map(|v| v + 1.0));
    assert_eq!(of_off.collect::<Vec<_>>(), of_family);
    folder.run("triangle -pgjNEPQ s", 0);
    assert_eq!(
        rows(&folder, "s.1.off")[0][0],
        5.0,
        "without the point outside"
    );
}

#[test]
fn without_iteration_numbers_no_input_is_overwritten() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pIQe s", 0);
    assert_eq!(folder.names(), ["s.edge", "s.ele", "s.node", "s.poly"]);
    assert_eq!(folder.read("s.poly"), SQUARE);
    // Now that the points stand in a file of their own, that one is spared.
    let node = folder.read("s.node");
    let graph = "0 2 0 0\n1 0\n1 1 3\n0\n";
    folder.write("s.poly", graph);
    folder.run("triangle -pcIQ s", 0);
    assert_eq!(
        (folder.read("s.node"), folder.read("s.poly")),
        (node.clone(), graph.to_owned())
    );
    folder.run("triangle -IQ s.node", 0);
    assert_eq!(folder.read("s.node"), node);
}

#[test]
fn the_hull_is_kept_and_drawn() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pcQ s", 0);
    assert_eq!(total_area(&folder, "s.1"), 16.0 + 20.0);
    assert_eq!(markers(&folder, "s.1.node"), [5.0, 7.0, 3.0, 1.0, 5.0, 1.0]);
    let segments = edge_markers(&folder, "s.1.poly");
    assert_eq!(segments.len(), 7);
    let expected = [([3, 4], 0), ([1, 2], 1), ([2, 6], 1), ([4, 6], 1)];
    for (edge, marker) in expected {
        assert_eq!(segments[&edge], marker, "{edge:?}");
    }
    folder.write("d.node", "5 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 1\n");
    folder.run("triangle -Q d", 0);
    assert!(!folder.names().contains(&"d.1.poly".to_owned()));
    assert_eq!(markers(&folder, "d.1.node"), [1.0, 1.0, 1.0, 1.0, 0.0]);
    folder.run("triangle -cQ d", 0);
    let hull = [[0, 1], [1, 2], [2, 3], [0, 3]].map(|edge| (edge, 1));
    assert_eq!(edge_markers(&folder, "d.1.poly"), BTreeMap::from(hull));
}

#[test]
fn unused_vertices_are_jettisoned() {
    let twice = SQUARE
        .replace("5 2 2 0\n", "5 0 0 0\n")
        .replace("6 9 9 0", "6 2 2 0");
    let twice = twice.replace("5 1 5 5", "5 5 6 5");
    let folder = with("s.poly", &twice);
    folder.run("triangle -pQ s", 0);
    assert_eq!(rows(&folder, "s.1.node").len(), 6);
    folder.run("triangle -pejQ s", 0);
    let nodes = rows(&folder, "s.1.node");
    assert_eq!(nodes.len(), 5);
    assert_eq!(nodes[4], [5.0, 2.0, 2.0, 5.0]);
    assert_eq!(edge_markers(&folder, "s.1.poly")[&[1, 5]], 5);
    assert_eq!(edge_markers(&folder, "s.1.edge").len(), 8);
    assert_eq!(total_area(&folder, "s.1"), 16.0);
}

#[test]
fn segments_that_cross_are_split() {
    let crossed = "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 1 3 8\n6 2 4 9\n0\n";
    let folder = with("x.poly", crossed);
    folder.run("triangle -pQ x", 0);
    assert_eq!(rows(&folder, "x.1.node")[4], [5.0, 1.0, 1.0, 8.0]);
    let segments = edge_markers(&folder, "x.1.poly");
    assert_eq!((segments[&[1, 5]], segments[&[4, 5]]), (8, 9));
}

#[test]
fn regions_and_holes_are_carried_on() {
    let folder = with("r.poly", RING);
    folder.run("triangle -pAQ r", 0);
    assert_eq!(total_area(&folder, "r.1"), 32.0);
    let ele = folder.read("r.1.ele");
    assert!(
        ele.lines().next().expect("header").ends_with(" 3 1"),
        "{ele}"
    );
    let attributes = markers(&folder, "r.1.ele");
    assert!(attributes.contains(&0.25) && attributes.contains(&2.0));
    // A region's single number is its largest area as well.
    let poly = folder.read("r.1.poly");
    assert!(
        poly.ends_with("1\n1 3 3\n2\n1 1 3 0.25 0.25\n2 5 3 2 2\n"),
        "{poly}"
    );
    folder.run("triangle -pOQ r", 0);
    assert_eq!(total_area(&folder, "r.1"), 36.0);
    assert!(
        folder
            .read("r.1.ele")
            .lines()
            .next()
            .expect("header")
            .ends_with(" 3 0")
    );
}

#[test]
fn angles_and_areas_are_bounded() {
    let folder = with("s.poly", STRIP);
    let said = folder.run("triangle -pq30a0.1D s.poly", 0);
    assert!(
        worst_angle(&folder, "s.1") >= 30.0 - 1e-9,
        "{}",
        said.stdout
    );
    let largest = triangles(&folder, "s.1")
        .into_iter()
        .map(area)
        .fold(0.0, f64::max);
    assert!(largest <= 0.1, "{largest}");
    assert!((total_area(&folder, "s.1") - 10.0).abs() < 1e-9);
    assert!(said.stdout.contains("added: "), "{}", said.stdout);
    folder.run("triangle -pqQ s.poly", 0);
    assert!(worst_angle(&folder, "s.1") >= 20.0 - 1e-9);
    // Steiner points on the border are marked as such, others not.
    for row in &rows(&folder, "s.1.node")[5..] {
        let on_border = row[1] == 0.0 || row[1] == 10.0 || row[2] == 0.0 || row[2] == 1.0;
        assert_eq!(row[3], f64::from(on_border), "{row:?}");
    }
}

#[test]
fn bare_points_are_refined_within_their_hull() {
    let folder = with("d.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 1\n4 0 1\n5 2 0.1\n");
    folder.run("triangle -q25Q d", 0);
    assert_eq!(folder.names(), ["d.1.ele", "d.1.node", "d.node"]);
    assert!(worst_angle(&folder, "d.1") >= 25.0 - 1e-9);
    assert!((total_area(&folder, "d.1") - 4.0).abs() < 1e-9);
}

#[test]
fn regions_bound_the_areas_of_their_triangles() {
    let folder = with("r.poly", RING);
    folder.run("triangle -paAQ r", 0);
    let attributes = markers(&folder, "r.1.ele");
    let mut largest = BTreeMap::new();
    for (triangle, attribute) in triangles(&folder, "r.1").into_iter().zip(attributes) {
        let largest = largest.entry(attribute.to_bits()).or_insert(0.0);
        *largest = area(triangle).max(*largest);
    }
    let [small, large] = [0.25f64, 2.0].map(|attribute| largest[&attribute.to_bits()]);
    assert!(
        small <= 0.25 && (0.25..=2.0).contains(&large),
        "{small} {large}"
    );
}

#[test]
fn a_file_of_areas_bounds_the_triangles_of_a_mesh() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -pQ s", 0);
    let fine = |t: [[f64; 2]; 3]| t.contains(&[4.0, 0.0]) && t.contains(&[4.0, 4.0]);
    let bounds = triangles(&folder, "s.1")
        .into_iter()
        .map(|t| if fine(t) { 0.125 } else { -1.0 });
    let rows = bounds
        .enumerate()
        .map(|(i, bound)| format!("{} {bound}\n", i + 1));
    folder.write("s.1.area", format!("4\n{}", rows.collect::<String>()));
    folder.run("triangle -rpaQ s.1", 0);
    assert_eq!(total_area(&folder, "s.2"), 16.0);
    for triangle in triangles(&folder, "s.2") {
        let middle = [0, 1].map(|k| triangle.iter().map(|p| p[k]).sum::<f64>() / 3.0);
        let [x, y] = middle;
        if x > y && x + y > 4.0 {
            assert!(area(triangle) <= 0.125, "{triangle:?}");
        }
    }
    folder.write("s.1.area", "3\n1 1\n2 1\n3 1\n");
    folder
        .run("triangle -raQ s.1", 3)
        .says(&["s.1.area:1", "3 triangles", "has 4"]);
    folder.command("triangle -ra s.2").assert().code(3);
}

#[test]
fn a_mesh_keeps_its_border_and_its_segments() {
    let folder = with("r.poly", RING);
    folder.run("triangle -pQ r", 0);
    folder.run("triangle -rq30Q r.1", 0);
    assert!(
        (total_area(&folder, "r.2") - 32.0).abs() < 1e-9,
        "the hole stays"
    );
    assert!(worst_angle(&folder, "r.2") >= 30.0 - 1e-9);
    let first = rows(&folder, "r.1.node");
    let places = |rows: &[Vec<f64>]| rows.iter().map(|r| [r[1], r[2]]).collect::<Vec<_>>();
    assert_eq!(
        places(&rows(&folder, "r.2.node")[..first.len()]),
        places(&first)
    );
    folder.run("triangle -rcpQ r.1", 0);
    assert_eq!(edge_markers(&folder, "r.2.poly").len(), 12);
    folder.run("triangle -rcQ r.1", 0);
    assert_eq!(
        edge_markers(&folder, "r.2.poly").len(),
        10,
        "the border alone"
    );
    folder.write("r.1.poly", RING);
    folder
        .run("triangle -rpQ r.1", 3)
        .says(&["r.1.poly has points of its own"]);
    folder.write("lone.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    folder.write("lone.ele", "1 3 0\n1 1 2 3\n");
    folder
        .run("triangle -rpQ lone", 3)
        .says(&["lone.poly", "leave -p out"]);
}

#[test]
fn borders_and_segments_may_be_locked() {
    // How good the triangles may become within locked segments is another matter: any exit code.
    let folder = with("s.poly", STRIP);
    let _ = folder.command("triangle -pYYq20Q s").assert();
    assert_eq!(
        edge_markers(&folder, "s.1.poly").len(),
        4,
        "no segment is split"
    );
    folder.write("r.poly", RING);
    let _ = folder.command("triangle -pYYa0.1Q r").assert();
    assert_eq!(edge_markers(&folder, "r.1.poly").len(), 12);
    let _ = folder.command("triangle -pYa0.1Q r").assert();
    let segments = edge_markers(&folder, "r.1.poly");
    let on_border = segments.values().filter(|&&marker| marker == 1).count();
    assert_eq!(on_border, 10, "no border is split");
    assert!(segments.len() > 12, "those within are");
}

#[test]
fn steiner_points_are_counted() {
    let folder = with("s.poly", STRIP);
    for (switch, most) in [("S3", 3), ("S", 0), ("S0", 0)] {
        let said = folder.run(&format!("triangle -pq20{switch} s"), 4);
        let added = rows(&folder, "s.1.node").len() - 5;
        assert!(added <= most, "{switch}: {added}");
        said.says(&["s.poly", "the input is no excuse"]);
    }
    folder.run("triangle -pq20S10000Q s", 0);
}

#[test]
fn six_nodes_are_written_and_checked() {
    let folder = with("s.poly", SQUARE);
    folder.run("triangle -po2Q s", 0);
    assert!(folder.read("s.1.ele").starts_with("4 6 0\n"));
    assert!(folder.read("s.1.node").starts_with("14 2 0 1\n"));
    let mut of_midpoints = markers(&folder, "s.1.node")[6..].to_vec();
    of_midpoints.sort_by(f64::total_cmp);
    assert_eq!(of_midpoints, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 5.0, 7.0]);
    folder.run("check s.1.ele --domain s.poly", 0);
    folder.write("d.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 1\n4 0 1\n5 2 0.1\n");
    folder.run("triangle -o2jQ d", 0);
    folder.run("check d.1.ele --points d.node", 0);
    // And a mesh of such triangles may be refined.
    folder.run("triangle -rQ d.1", 0);
    assert_eq!(rows(&folder, "d.2.node").len(), 5);
}

#[test]
fn the_voronoi_diagram_has_the_numbers_of_triangles_and_edges() {
    // Three points and one in the middle: the triangles' circles, and three rays.
    let folder = with("t.node", "4 2 1 0\n1 0 0 0\n2 8 0 8\n3 4 8 4\n4 4 3 4\n");
    folder.run("triangle -veQ t", 0);
    assert_eq!(
        folder.names(),
        [
            "t.1.edge",
            "t.1.ele",
            "t.1.node",
            "t.1.v.edge",
            "t.1.v.node",
            "t.node"
        ]
    );
    let [vertices, edges] = ["t.1.v.node", "t.1.v.edge"].map(|name| rows(&folder, name));
    let corners = rows(&folder, "t.1.ele");
    assert_eq!((vertices.len(), edges.len()), (3, 6));
    let points = [[0.0, 0.0], [8.0, 0.0], [4.0, 8.0], [4.0, 3.0]];
    for (vertex, triangle) in vertices.iter().zip(&corners) {
        let [x, y] = [vertex[1], vertex[2]];
        let distances = triangle[1..].iter().map(|&v| {
            let [px, py] = points[v as usize - 1];
            (px - x).hypot(py - y)
        });
        let distances: Vec<f64> = distances.collect();
        assert!(distances.iter().all(|d| (d - distances[0]).abs() < 1e-12));
        // The attribute is x, and linear.
        assert!((vertex[3] - x).abs() < 1e-12);
    }
    let ends = rows(&folder, "t.1.edge");
    for (edge, of_mesh) in edges.iter().zip(&ends) {
        let [a, b] = [1, 2].map(|k| points[of_mesh[k] as usize - 1]);
        let along = match edge[2] {
            -1.0 => [edge[3], edge[4]],
            to => {
                let [from, to] = [edge[1], to].map(|v| &vertices[v as usize - 1]);
                [to[1] - from[1], to[2] - from[2]]
            }
        };
        let dot = along[0] * (b[0] - a[0]) + along[1] * (b[1] - a[1]);
        assert!(dot.abs() < 1e-12, "{edge:?} {of_mesh:?}");
        if edge[2] == -1.0 {
            // Outwards: away from the point in the middle.
            let [x, y] = [a[0] - points[3][0], a[1] - points[3][1]];
            assert!(along[0] * x + along[1] * y > 0.0);
        }
    }
    folder.run("triangle -vNEQ t", 0);
    assert!(folder.names().contains(&"t.1.v.edge".to_owned()));
}

#[test]
fn what_cannot_be_done_is_said() {
    let folder = with("s.poly", SQUARE);
    for (line, code, words) in [
        ("triangle", 2, vec!["Usage: delone triangle [-prq"]),
        ("triangle -p", 2, vec!["no file is named"]),
        ("triangle -pq60 s", 2, vec!["-q60", "below 60"]),
        ("triangle -p --json s", 2, vec!["--json", "-Q is for quiet"]),
        ("triangle -p nowhere", 3, vec!["nowhere.poly"]),
        ("triangle nowhere", 3, vec!["nowhere.node"]),
        ("triangle -r s", 3, vec!["s.ele"]),
        ("triangle -Ir s", 2, vec!["-I and -r"]),
        ("triangle -pgo2 s", 2, vec!["-g and -o2"]),
    ] {
        folder.run(line, code).says(&words);
    }
    assert_eq!(folder.names(), ["s.poly"]);
    folder.write("bad.poly", SQUARE.replace("5 1 5 5", "5 1 9 5"));
    folder
        .run("triangle -p bad", 3)
        .says(&["bad.poly:13", "vertex 9 of 6"]);
}

#[test]
fn the_help_knows_every_switch() {
    let folder = Folder::new();
    let help = folder.run("triangle -h", 0).stdout;
    assert_eq!(help, folder.run("triangle --help", 0).stdout);
    for switch in "prqauAcDjevngBPNEIOXzoYSiFlsLCQV".chars() {
        assert!(help.contains(&format!("-{switch}")), "-{switch}");
    }
    assert!(help.contains("Exit codes"));
}

#[test]
fn old_triangles_hand_their_attributes_down() {
    let folder = with("r.poly", RING);
    folder.run("triangle -pAQ r", 0);
    folder.run("triangle -rpa0.2Q r.1", 0);
    let of_triangles = markers(&folder, "r.2.ele");
    let triangles = triangles(&folder, "r.2");
    assert!(triangles.len() > 160);
    // Segments part the regions: from (3, 0) to (2, 2), along the hole, and from (2, 4) to (3, 6).
    for (triangle, attribute) in triangles.into_iter().zip(of_triangles) {
        let [x, y] = [0, 1].map(|k| triangle.iter().map(|p| p[k]).sum::<f64>() / 3.0);
        let is_left = x < 3.0 - y.min(6.0 - y).min(2.0) / 2.0;
        let expected = if is_left { 0.25 } else { 2.0 };
        assert_eq!(attribute, expected, "{triangle:?}");
    }
}

#[test]
fn attributes_and_hull_go_to_new_vertices() {
    // At the bottom the attribute is 5, at the top 7, and at the point between 5.04.
    let rows_of_points = "0 0 0 5\n1 10 0 5\n2 10 1 7\n3 0 1 7\n4 5 0.02 5.04\n";
    let graph = format!("5 2 1 0\n{rows_of_points}1 1\n0 0 2 9\n0\n");
    let folder = with("s.poly", &graph);
    folder.run("triangle -pcq20Q s", 0);
    let added = rows(&folder, "s.1.node").split_off(5);
    assert!(!added.is_empty());
    for row in added {
        let [y, attribute, marker] = [row[2], row[3], row[4]];
        assert!((attribute - (5.0 + 2.0 * y)).abs() < 1e-9, "{row:?}");
        let on_hull = row[1] == 0.0 || row[1] == 10.0 || y == 0.0 || y == 1.0;
        let on_segment = (row[1] - 10.0 * y).abs() < 1e-9;
        assert!(
            marker == f64::from(on_hull) || on_segment && marker == 9.0,
            "{row:?}"
        );
    }
    let segments = edge_markers(&folder, "s.1.poly");
    let hull = segments.values().filter(|&&marker| marker == 1).count();
    let drawn = segments.values().filter(|&&marker| marker == 9).count();
    assert!(hull > 4 && drawn >= 1 && hull + drawn == segments.len());
}
