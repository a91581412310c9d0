use super::*;
use delone::doctor::Kind;
use delone_testkit::corpus;

/// The result as places, whatever its numbering.
fn places(repair: &Repair) -> (Vec<[u64; 2]>, Vec<[[u64; 2]; 2]>) {
    let bits = |p: Point| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()];
    let out = &repair.pslg;
    let mut points: Vec<_> = out.points.iter().map(|&p| bits(p)).collect();
    let edge = |ends: &[VertexId; 2]| {
        let [a, b] = ends.map(|v| bits(out.points[v.index()]));
        if a < b { [a, b] } else { [b, a] }
    };
    let mut edges: Vec<_> = out.segments.iter().map(edge).collect();
    points.sort_unstable();
    edges.sort_unstable();
    (points, edges)
}

#[test]
fn an_unclosed_square_is_closed() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.125)];
    let mut pslg = Pslg::from_points(corners);
    pslg.add_polyline([0, 1, 2, 3, 4]);
    let done = repair(&pslg, 0.125);
    let moved: Vec<_> = done.moved().collect();
    assert_eq!((moved.len(), moved[0].distance), (1, 0.125));
    assert_eq!(
        done.merged().collect::<Vec<_>>(),
        [[4, 0].map(VertexId::new)]
    );
    assert_eq!(done.pslg.segments.len(), 4);
    assert_eq!(done.pslg.segments[3], [3, 0].map(VertexId::new));
    assert!(done.is_settled);
    assert!(repair(&pslg, 0.12).moved().next().is_none());
}

#[test]
fn ends_that_fall_short_are_joined_and_segments_bend() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (4.0, 4.0), (4.0, 0.25)]);
    pslg.add_segment(0, 1);
    pslg.add_segment(2, 3);
    let done = repair(&pslg, 0.25);
    let bent: Vec<_> = done.bent().collect();
    assert_eq!(
        (bent.len(), bent[0].segment, bent[0].distance),
        (1, 0, 0.25)
    );
    assert_eq!(done.chains[0], [0, 3, 1].map(VertexId::new));
    assert!(done.moved().next().is_none());
    assert_eq!(done.owners, [vec![0], vec![0], vec![1]]);
}

#[test]
fn what_is_doubled_or_without_length_goes() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 0.0), (2.0, 0.0)]);
    for (a, b) in [(0, 1), (1, 2), (2, 0), (0, 3)] {
        pslg.add_segment(a, b);
    }
    let done = repair(&pslg, 0.0);
    assert_eq!(done.vanished().collect::<Vec<_>>(), [1]);
    assert_eq!(done.doubled(), [2, 3]);
    assert_eq!(done.owners, [vec![0, 2, 3], vec![0, 2]]);
    assert_eq!(done.pslg.points.len(), 3);
    require_promises(&pslg, &done, 0.0);
}

#[test]
fn polygons_keep_their_own_segments() {
    let mut pslg = Pslg::from_points([
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 2.0),
        (4.0, 0.01),
        (2.01, 0.0),
        (2.0, 2.01),
    ]);
    pslg.add_ring([0, 1, 2]);
    pslg.add_ring([4, 3, 5]);
    pslg.polygons = vec![0..3, 3..6];
    let done = repair(&pslg, 0.02);
    assert_eq!(done.pslg.polygons, [0..3, 3..6]);
    assert_eq!(done.pslg.segments.len(), 6);
    assert_eq!(done.pslg.points.len(), 4);
    assert_eq!(done.owners[5], [5]);
    require_promises(&pslg, &done, 0.02);
}

#[test]
fn chains_of_near_points_do_not_drift() {
    let n = 200;
    let mut pslg = Pslg::from_points((0..n).map(|i| (f64::from(i) * 0.75, 0.0)));
    pslg.add_polyline(0..n as u32);
    let done = repair(&pslg, 1.0);
    require_promises(&pslg, &done, 1.0);
    assert_eq!(done.pslg.points.len(), 100, "every second one is a center");
    assert!(examine(&done.pslg, 1.0).of(Kind::NearVertices).is_none());
}

#[test]
fn random_drawings_keep_the_promises() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let n = 6 + random.below(40);
        let pslg = scattered(&mut random, n, n, 0.03);
        for tolerance in [0.0, 1e-3, 0.02, 0.1] {
            let done = repair(&pslg, tolerance);
            require_promises(&pslg, &done, tolerance);
            let found = examine(&done.pslg, tolerance);
            assert_eq!(found.count_of(Kind::Crossing), 0);
            if tolerance == 0.0 {
                assert!(done.moved().next().is_none());
            }
        }
    }
}

#[test]
fn repairs_do_not_depend_on_order() {
    for seed in 0..150 {
        let mut random = Random::new(seed);
        let pslg = scattered(&mut random, 30, 25, 0.03);
        let other = shuffled(&pslg, &mut random);
        for tolerance in [0.0, 0.01, 0.05] {
            let [one, two] = [&pslg, &other].map(|pslg| places(&repair(pslg, tolerance)));
            assert!(one == two, "{seed} {tolerance}");
        }
    }
}

#[test]
fn clean_drawings_stay_as_they_are() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (1.0, 1.0), (9.0, 9.0)]);
    pslg.add_ring([0, 1, 2]);
    for tolerance in [0.0, 0.1] {
        assert!(repair(&pslg, tolerance).is_unchanged());
    }
}

#[test]
fn the_whole_corpus_is_repaired() {
    let Some(root) = corpus::root() else {
        println!("no corpus here");
        return;
    };
    let (mut seen, mut left, mut unsettled) = (0, 0, 0);
    for entry in corpus::read_all(&root) {
        let pslg = &entry.pslg;
        if pslg.segments.is_empty() || !pslg.points.iter().all(Point::is_finite) {
            continue;
        }
        let x = pslg.points.iter().map(|p| p.x);
        let extent = x.clone().fold(f64::MIN, f64::max) - x.fold(f64::MAX, f64::min);
        for tolerance in [0.0, 1e-4 * extent] {
            let done = repair(pslg, tolerance);
            require_promises(pslg, &done, tolerance);
            seen += 1;
            let doctor = Doctor::new().tolerance(tolerance).limit(1);
            let found = doctor.examine(&done.pslg).expect("a drawing");
            assert_eq!(
                found.count_of(Kind::Crossing) + found.count_of(Kind::Overlap),
                0
            );
            unsettled += u32::from(!done.is_settled);
            let near = found.count_of(Kind::NearVertices) + found.count_of(Kind::NearSegment);
            if near > 0 {
                println!("{}: {near} near misses left at {tolerance}", entry.name);
                left += 1;
            }
        }
    }
    println!("{seen} repairs, {left} with near misses left, {unsettled} unsettled");
    assert!(seen > 200, "{seen}");
}
