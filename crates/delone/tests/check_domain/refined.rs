//! Refined meshes: Steiner points where they may be, and where they may not.

use crate::claim::{RULES, add_square, crossed, lake, point};
use crate::mesh::Mesh;
use delone::check::{self, Defect, Defects, DomainMesh};
use delone::{DomainRule, Error, Point, Pslg, VertexId};
use delone_testkit::generate::Random;

/// A hull that is parallel to no axis, with a segment and a loose point in it.
fn tilted() -> Pslg {
    let mut input = Pslg::from_points([(0.1, 0.0), (3.3, 0.7), (2.9, 3.1), (0.3, 2.3)]);
    input.points.extend([point(1.1, 1.3), point(2.1, 1.7)]);
    input.points.push(point(0.9, 0.4));
    input.add_segment(4, 5);
    input
}

fn defects(mesh: &Mesh) -> Defects {
    mesh.verify().expect_err("a wrong mesh passed")
}

macro_rules! assert_named {
    ($mesh:expr, $kind:pat) => {{
        let defects = defects(&$mesh);
        let is_named = defects.listed().iter().any(|d| matches!(d, $kind));
        assert!(is_named, "no {}:\n{defects}", stringify!($kind));
    }};
}

#[test]
fn accepts_steiner_points_on_segments_and_elsewhere_under_every_rule() {
    for rule in RULES {
        let mut mesh = Mesh::new(&lake(), rule);
        assert_eq!(mesh.steiner(), [0, 0]);
        for segment in [0, 5, 10] {
            mesh.halve(segment, 0);
            mesh.halve(segment, 1);
        }
        mesh.free(6.5, 6.25);
        mesh.triangulate().unwrap();
        assert_eq!(mesh.steiner(), [6, 1]);
        let text = mesh.verify().expect("right").to_string();
        let tail = "6 Steiner points on segments and 1 elsewhere";
        assert!(text.ends_with(tail), "{text}");
    }
}

#[test]
fn steiner_points_need_leave() {
    let mut mesh = Mesh::new(&lake(), DomainRule::Carve);
    mesh.halve(0, 0);
    mesh.free(6.5, 6.25);
    mesh.triangulate().unwrap();
    let subsegments = mesh.subsegments();
    let claim = DomainMesh::new(&mesh.points, &mesh.triangles, &subsegments);
    let verdict = check::verify_domain(&mesh.input, mesh.rule, &claim, &()).unwrap();
    let defects = verdict.into_result().expect_err("nobody asked for them");
    let is_needless = |d: &&Defect| matches!(d, Defect::NeedlessVertex { .. });
    assert_eq!(defects.listed().iter().filter(is_needless).count(), 2);
}

#[test]
fn rounded_points_on_a_tilted_hull_are_right() {
    let mut mesh = Mesh::new(&tilted(), DomainRule::Hull);
    assert_eq!(mesh.chains.len(), 5);
    for segment in 0..mesh.chains.len() {
        for _ in 0..5 {
            for k in (0..mesh.chains[segment].len() - 1).rev() {
                mesh.halve(segment, k);
            }
        }
    }
    mesh.triangulate().unwrap();
    let ends = mesh.chains[1].iter();
    let [from, to] = [0, 1].map(|v| mesh.points[v]);
    let off = ends.filter(|v| {
        let at = mesh.points[v.index()];
        delone::predicates::orient2d(from, to, at) != delone::predicates::Orientation::Collinear
    });
    assert!(off.count() > 10);
    assert_eq!(mesh.steiner(), [5 * 31, 0]);
    // Where the hull is not said to be split, it is not there.
    let hull = mesh.chains.pop().unwrap();
    mesh.triangulate().unwrap();
    assert_named!(
        Mesh {
            chains: [&mesh.chains[..], &[vec![hull[0]]]].concat(),
            ..mesh.clone()
        },
        Defect::BrokenChain { segment: 4, .. }
    );
}

#[test]
fn a_hull_of_many_points_on_one_line_is_split_between_them() {
    let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 3.0)]);
    let mut mesh = Mesh::new(&input, DomainRule::Hull);
    assert_eq!(mesh.chains.len(), 4);
    mesh.halve(1, 0);
    mesh.triangulate().unwrap();
    assert_eq!(mesh.steiner(), [1, 0]);
    // All on one line there is no hull to split.
    input.points.truncate(3);
    let mut mesh = Mesh::new(&Pslg::default(), DomainRule::Carve);
    mesh.points.clone_from(&input.points);
    (mesh.input, mesh.rule) = (input, DomainRule::Hull);
    assert_eq!(mesh.steiner(), [0, 0]);
}

#[test]
fn holes_on_the_bare_hull_stand_for_what_is_inside_though_it_is_split() {
    let mut input = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
    input.points.extend([point(4.0, 0.0), point(4.0, 8.0)]);
    input.add_segment(4, 5);
    let mut mesh = Mesh::new(&input, DomainRule::Hull);
    mesh.halve(3, 0);
    mesh.input.holes.push(point(2.0, 4.0));
    mesh.triangulate().unwrap();
    for at in [(0.0, 3.0), (0.0, 0.0), (2.0, 8.0)] {
        mesh.input.holes = vec![at.into()];
        let domain = mesh.verify().map(|c| c.domain.expect("numbers"));
        assert_eq!(
            domain.map(|d| (d.components, d.carved)),
            Ok((1, 2)),
            "{at:?}"
        );
    }
    // But the one upon a segment is undecided.
    mesh.input.holes = vec![point(4.0, 2.0)];
    let subsegments = mesh.subsegments();
    let claim = DomainMesh::new(&mesh.points, &mesh.triangles, &subsegments).refined();
    let verdict = check::verify_domain(&mesh.input, mesh.rule, &claim, &());
    assert!(matches!(
        verdict,
        Err(Error::SeedOnSegment { segment: 0, .. })
    ));
}

#[test]
fn rejects_a_steiner_point_that_has_left_its_segment() {
    let mesh = |ulps: i32| {
        let mut mesh = Mesh::new(&tilted(), DomainRule::Hull);
        let v = mesh.halve(0, 0);
        let y = &mut mesh.points[v.index()].y;
        for _ in 0..ulps.abs() {
            *y = if ulps < 0 { y.next_down() } else { y.next_up() };
        }
        mesh.triangulate().unwrap();
        mesh
    };
    for ulps in [0, 1, -1, 16, -16] {
        assert_eq!(mesh(ulps).steiner(), [1, 0], "{ulps}");
    }
    for ulps in [20, -20] {
        assert_named!(mesh(ulps), Defect::BrokenChain { segment: 0, .. });
    }
    let mut moved = Mesh::new(&tilted(), DomainRule::Hull);
    let v = moved.halve(2, 0);
    moved.points[v.index()].x += 1e-9;
    moved.triangulate().unwrap();
    assert_named!(moved, Defect::BrokenChain { segment: 2, .. });
}

#[test]
fn only_steiner_points_may_bend_what_nothing_crosses() {
    let middle = point(1.0, 1.0 + 2.0 * f64::EPSILON);
    let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (0.0, 3.0)]);
    input.add_segment(0, 1);
    let mut mesh = Mesh::new(&input, DomainRule::Hull);
    let bent = [0, 1].map(VertexId::new);
    mesh.split(bent, middle);
    mesh.triangulate().unwrap();
    assert_eq!(mesh.steiner(), [1, 0]);
    // As a point of the input it is no reason.
    mesh.input.points.push(middle);
    assert_named!(mesh, Defect::BentChain { segment: 0, .. });
}

#[test]
fn rejects_steiner_points_that_serve_nothing() {
    let mut mesh = Mesh::new(&lake(), DomainRule::Carve);
    mesh.free(20.0, 20.0);
    mesh.triangulate().unwrap();
    let defects = defects(&mesh);
    let text = "vertex 17 (20.0, 20.0) was added, but no triangle has it";
    assert_eq!(defects.to_string(), text);
    let mut mesh = Mesh::new(&lake(), DomainRule::Carve);
    mesh.free(-8.0, 8.0);
    assert_named!(mesh, Defect::NotNew { .. });
    // A subsegment between Steiner points that is part of nothing.
    let mut mesh = Mesh::new(&lake(), DomainRule::Carve);
    let ends = [mesh.free(6.5, 6.25), mesh.free(6.5, -6.25)];
    mesh.chains.push(ends.to_vec());
    mesh.triangulate().unwrap();
    let subsegments = mesh.subsegments();
    let claim = DomainMesh::new(&mesh.points, &mesh.triangles, &subsegments).refined();
    let verdict = check::verify_domain(&mesh.input, mesh.rule, &claim, &()).unwrap();
    let defects = verdict.into_result().expect_err("a stray subsegment");
    assert!(matches!(defects.listed(), [Defect::StraySubsegment { .. }]));
}

#[test]
fn rejects_what_is_wrong_in_a_refined_mesh() {
    let mut right = Mesh::new(&lake(), DomainRule::EvenOdd);
    right.halve(0, 0);
    right.halve(6, 0);
    right.free(6.5, 6.25);
    right.triangulate().unwrap();
    assert_eq!(right.steiner(), [2, 1]);
    for t in 0..right.triangles.len() {
        let mut wrong = right.clone();
        wrong.triangles.remove(t);
        assert!(wrong.verify().is_err(), "{t}");
        let mut wrong = right.clone();
        wrong.triangles[t].swap(0, 1);
        assert!(wrong.verify().is_err(), "{t}");
    }
    let flip = |mesh: &mut Mesh, [a, b]: [VertexId; 2]| {
        let apex = |t: &[VertexId; 3], [a, b]: [VertexId; 2]| {
            let turned = [[t[0], t[1], t[2]], [t[1], t[2], t[0]], [t[2], t[0], t[1]]];
            turned.iter().find(|r| r[..2] == [a, b]).map(|r| r[2])
        };
        let find = |edge| {
            let mut triangles = mesh.triangles.iter().enumerate();
            triangles.find_map(|(i, t)| Some((i, apex(t, edge)?)))
        };
        let ((t, c), (u, d)) = (find([a, b])?, find([b, a])?);
        mesh.triangles[t] = [a, d, c];
        mesh.triangles[u] = [d, b, c];
        Some(())
    };
    let mut flipped = 0;
    for t in right.triangles.clone() {
        let mut wrong = right.clone();
        if flip(&mut wrong, [t[0], t[1]]).is_some() {
            flipped += 1;
            assert!(wrong.verify().is_err(), "{t:?}");
        }
    }
    assert!(flipped > 10, "only {flipped}");
    // Split for the segment, but not for the triangles beside it.
    let mut wrong = right.clone();
    wrong.halve(0, 0);
    assert_named!(wrong, Defect::OpenEdge { .. });
    assert_named!(wrong, Defect::UnusedVertex { .. });
}

#[test]
fn crossings_are_told_from_steiner_points() {
    let mut mesh = Mesh::new(&crossed(), DomainRule::Hull);
    mesh.halve(4, 0);
    mesh.halve(5, 1);
    mesh.triangulate().unwrap();
    let domain = mesh.verify().map(|c| c.domain.expect("numbers"));
    let domain = domain.expect("right");
    assert_eq!((domain.added, domain.on_segments, domain.free), (1, 2, 0));
}

/// Splits pieces again and again, each near the middle, rounded and moved by a unit at random.
fn split_at_random(mesh: &mut Mesh, random: &mut Random, times: usize) {
    for _ in 0..times {
        let segment = random.below(mesh.chains.len());
        let chain = &mesh.chains[segment];
        let k = random.below(chain.len() - 1);
        let ends = [chain[k], chain[k + 1]];
        let [p, q] = ends.map(|v| mesh.points[v.index()]);
        let t = 1.0 / 3.0 + random.unit() / 3.0;
        let mut at = [(1.0 - t) * p.x + t * q.x, (1.0 - t) * p.y + t * q.y];
        for c in &mut at {
            *c = match random.below(3) {
                0 => c.next_up(),
                1 => c.next_down(),
                _ => *c,
            };
        }
        mesh.split(ends, at.into());
    }
}

#[test]
fn accepts_chains_that_were_split_again_and_again() {
    let mut random = Random::new(7);
    for case in 0..60 {
        let [x, y] = random.choose(&[[0.0, 0.0], [500_000.25, 4_500_000.5], [-1e-3, 1e9]]);
        let corners = [0.0, 1.6, 3.1, 4.7].map(|turn: f64| {
            let turn = turn + random.unit();
            Point::new(x + 3.0 * turn.cos(), y + 3.0 * turn.sin())
        });
        let mut input = Pslg::from_points(corners);
        input.add_segment(0, 2);
        let mut mesh = Mesh::new(&input, DomainRule::Hull);
        split_at_random(&mut mesh, &mut random, 100);
        mesh.triangulate().unwrap();
        assert_eq!(mesh.steiner(), [100, 0], "{case}");
    }
}

#[test]
fn chains_may_be_split_as_often_as_there_is_room() {
    let mut input = Pslg::default();
    add_square(&mut input, [0.3, 0.7], 1.1);
    input.points.extend([point(-0.5, 0.1), point(1.0, 0.7)]);
    input.add_segment(4, 5);
    let mut mesh = Mesh::new(&input, DomainRule::Carve);
    // Towards the middle of the segment, forty times.
    mesh.halve(4, 0);
    for _ in 0..40 {
        mesh.halve(4, 0);
        let k = mesh.chains[4].len() - 2;
        mesh.halve(4, k);
    }
    for side in [1, -1] {
        let mut at = mesh.chains[4].len() / 2;
        for _ in 0..30 {
            mesh.halve(4, at);
            at = at.saturating_add_signed(side.max(0));
        }
    }
    mesh.triangulate().unwrap();
    assert_eq!(mesh.steiner(), [81 + 60, 0]);
}
