use super::*;
use std::f64::consts::{PI, TAU};

/// Distance of a point from a polyline, in the plane.
fn distance(p: Place3, line: &[Place3]) -> f64 {
    let to_segment = |w: &[Place3]| {
        let [a, b] = [w[0], w[1]];
        let d = [b[0] - a[0], b[1] - a[1]];
        let square = d[0] * d[0] + d[1] * d[1];
        let along = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / square.max(1e-300);
        let along = along.clamp(0.0, 1.0);
        (p[0] - a[0] - along * d[0]).hypot(p[1] - a[1] - along * d[1])
    };
    line.windows(2)
        .map(to_segment)
        .fold(f64::INFINITY, f64::min)
}

/// The point of a Bézier curve, by Bernstein's formula.
fn bezier_at(control: &[[f64; 4]], t: f64) -> Place3 {
    let d = control.len() - 1;
    let mut sum = [0.0; 4];
    let mut binomial = 1.0;
    for (i, p) in control.iter().enumerate() {
        let factor = binomial * t.powi(i as i32) * (1.0 - t).powi((d - i) as i32);
        (0..4).for_each(|k| sum[k] += factor * p[k]);
        binomial *= (d - i) as f64 / (i + 1) as f64;
    }
    project(sum)
}

/// Checks that all of a curve lies within the flatness of its polyline, and that this is not far too fine.
fn check(line: &[Place3], flatness: f64, at: impl Fn(f64) -> Place3) {
    let samples = 5000;
    let farthest = (0..=samples)
        .map(|i| distance(at(f64::from(i) / f64::from(samples)), line))
        .fold(0.0, f64::max);
    assert!(farthest <= flatness * 1.000001, "{farthest} for {flatness}");
    let is_coarse = farthest >= 0.15 * flatness || line.len() < 6;
    assert!(
        is_coarse,
        "{farthest} for {flatness}: too many points, {}",
        line.len()
    );
}

#[test]
fn angles_of_quarters_are_exact() {
    let quarters = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    for i in -9..9i32 {
        let expected = quarters[i.rem_euclid(4) as usize];
        assert_eq!(unit(90.0 * f64::from(i)), expected, "{i}");
    }
    for i in -80..80 {
        let angle = 7.3 * f64::from(i);
        let [cos, sin] = unit(angle);
        let radians = angle.to_radians();
        assert!((cos - radians.cos()).abs() < 1e-14 && (sin - radians.sin()).abs() < 1e-14);
    }
}

#[test]
fn arcs_are_as_flat_as_asked() {
    for (k, sweep) in [TAU, -TAU, 0.3, -2.0, 5.0, PI, 1e-3]
        .into_iter()
        .enumerate()
    {
        for flatness in [1.0, 0.1, 1e-3, 1e-6] {
            let arc = Arc {
                center: [3.0, -1.0, 2.0],
                u: [4.0, 1.0, 0.0],
                v: [0.5, 1.5, 0.0],
                start: if k < 2 { 0.0 } else { 0.7 },
                sweep,
            };
            let mut outline = Outline::new(arc.at(arc.start));
            outline.arc(
                arc,
                if k < 2 {
                    outline.start
                } else {
                    arc.at(arc.start + sweep)
                },
            );
            let line = outline.flatten(Some(flatness)).unwrap();
            check(&line, flatness, |t| arc.at(arc.start + sweep * t));
            assert!(line.iter().all(|p| p[2] == 2.0));
        }
    }
}

#[test]
fn circles_close_and_keep_their_extremes() {
    let arc = Arc::whole([10.0, 20.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]);
    let mut outline = Outline::new([13.0, 20.0, 0.0]);
    outline.arc(arc, outline.start);
    let line = outline.flatten(None).unwrap();
    assert_eq!(line.first(), line.last());
    assert_eq!(line.len() % 4, 1);
    for extreme in [[13.0, 20.0], [10.0, 23.0], [7.0, 20.0], [10.0, 17.0]] {
        assert!(line.iter().any(|p| p[..2] == extreme), "{extreme:?}");
    }
    check(&line, 6e-3, |t| arc.at(TAU * t));
    assert_eq!(line.len(), 53);
}

#[test]
fn bulges_are_arcs_to_the_right() {
    let [from, to] = [[1.0, 1.0, 0.0], [3.0, 1.0, 0.0]];
    let half = Arc::bulge([from, to], 1.0).unwrap();
    assert_eq!(half.center, [2.0, 1.0, 0.0]);
    assert!((half.at(half.sweep / 2.0)[1] - 0.0).abs() < 1e-15);
    let back = Arc::bulge([from, to], -1.0).unwrap();
    assert!((back.at(back.sweep / 2.0)[1] - 2.0).abs() < 1e-15);
    assert_eq!(Arc::bulge([from, to], 0.0), None);
    assert_eq!(Arc::bulge([from, from], 1.0), None);
    // The sagitta is the bulge times half of the chord, however flat the arc.
    for bulge in [0.5, -0.2, 3.0, 1e-3, 1e-9] {
        let arc = Arc::bulge([from, to], bulge).unwrap();
        let mut outline = Outline::new(from);
        outline.arc(arc, to);
        let flatness = (bulge.abs() * 1e-3).max(2e-15);
        let line = outline.flatten(Some(flatness)).unwrap();
        let lowest = line
            .iter()
            .map(|p| (1.0 - p[1]) / bulge)
            .fold(0.0, f64::max);
        assert!((lowest - 1.0).abs() < 2e-3, "{bulge}: {lowest}");
        assert_eq!((line[0], line[line.len() - 1]), (from, to));
    }
}

#[test]
fn bezier_curves_are_as_flat_as_asked() {
    let quadratic = vec![
        [0.0, 0.0, 0.0, 1.0],
        [2.0, 5.0, 0.0, 1.0],
        [4.0, -1.0, 0.0, 1.0],
    ];
    let cubic = [[0.0, 0.0], [10.0, 8.0], [-6.0, 8.0], [4.0, 0.0]];
    let cubic = cubic.map(|[x, y]| [x, y, 0.0, 1.0]).to_vec();
    let w = 0.5f64.sqrt();
    let quarter = vec![[1.0, 0.0, 0.0, 1.0], [w, w, 0.0, w], [0.0, 1.0, 0.0, 1.0]];
    let cusp = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let cusp = cusp.map(|[x, y]| [x, y, 0.0, 1.0]).to_vec();
    for control in [quadratic, cubic, quarter, cusp] {
        for flatness in [0.1, 1e-2, 1e-4, 1e-6] {
            let [start, end] = [control[0], control[control.len() - 1]].map(project);
            let mut outline = Outline::new(start);
            outline.pieces.push((Piece::Bezier(control.clone()), end));
            let line = outline.flatten(Some(flatness)).unwrap();
            check(&line, flatness, |t| bezier_at(&control, t));
        }
    }
}

#[test]
fn splines_are_cut_at_knots() {
    // The uniform cubic, at whose knots are the well-known means of three points.
    let places = [[0.0, 0.0], [1.0, 2.0], [3.0, 3.0], [4.0, 0.0], [6.0, 1.0]];
    let spline = Spline {
        degree: 3,
        knots: (0..9).map(f64::from).collect(),
        control: places.map(|[x, y]| [x, y, 0.0, 1.0]).to_vec(),
    };
    let outline = spline.outline().unwrap();
    assert_eq!(outline.pieces.len(), 2);
    let mean = |i: usize| {
        let [a, b, c] = [places[i], places[i + 1], places[i + 2]];
        [0, 1].map(|k| (a[k] + 4.0 * b[k] + c[k]) / 6.0)
    };
    let ends = [outline.start, outline.pieces[0].1, outline.pieces[1].1];
    for (i, end) in ends.into_iter().enumerate() {
        let mean = mean(i);
        assert!((0..2).all(|k| (end[k] - mean[k]).abs() < 1e-14), "{i}");
    }
}

#[test]
fn a_circle_is_a_rational_spline() {
    let w = 0.5f64.sqrt();
    let corners = [
        [1, 0],
        [1, 1],
        [0, 1],
        [-1, 1],
        [-1, 0],
        [-1, -1],
        [0, -1],
        [1, -1],
        [1, 0],
    ];
    let control = corners.iter().enumerate().map(|(i, c)| {
        let weight = if i % 2 == 1 { w } else { 1.0 };
        [f64::from(c[0]), f64::from(c[1]), 0.0, weight]
    });
    let spline = Spline {
        degree: 2,
        knots: [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4].map(f64::from).to_vec(),
        control: control.collect(),
    };
    let line = spline.outline().unwrap().flatten(Some(1e-5)).unwrap();
    assert_eq!(line.first(), line.last());
    let radius = |p: &Place3| p[0].hypot(p[1]);
    assert!(line.iter().all(|p| (radius(p) - 1.0).abs() < 1e-14));
    assert!(line.windows(2).all(|w| {
        let middle = [0, 1, 2].map(|k| (w[0][k] + w[1][k]) / 2.0);
        radius(&middle) > 1.0 - 1e-5
    }));
}

#[test]
fn what_is_no_spline_is_refused() {
    let good = Spline {
        degree: 2,
        knots: [0, 0, 0, 1, 1, 1].map(f64::from).to_vec(),
        control: vec![[0.0, 0.0, 0.0, 1.0]; 3],
    };
    assert!(good.outline().is_ok());
    let says = |change: &dyn Fn(&mut Spline)| {
        let mut bad = good.clone();
        change(&mut bad);
        bad.outline().unwrap_err().to_string()
    };
    assert!(says(&|s| s.degree = 0).contains("degree 0; 1 to 24"));
    assert!(says(&|s| s.knots.truncate(5)).contains("3 control points and 5 knots"));
    assert!(says(&|s| s.knots[3] = -1.0).contains("knot 3 of the spline, -1, is less"));
    assert!(says(&|s| s.knots[2] = f64::NAN).contains("knot 2"));
    assert!(says(&|s| s.control[1][3] = 0.0).contains("weight of the spline is 0"));
    assert!(says(&|s| s.knots = vec![1.0; 6]).contains("all knots"));
}

#[test]
fn what_is_too_much_is_refused() {
    let circle = |radius: f64| {
        let mut outline = Outline::new([radius, 0.0, 0.0]);
        let arc = Arc::whole([0.0; 3], [radius, 0.0, 0.0], [0.0, radius, 0.0]);
        outline.arc(arc, outline.start);
        outline
    };
    let text = circle(1.0).flatten(Some(1e-12)).unwrap_err().to_string();
    assert!(
        text.contains("more than 65536 pieces") && text.contains("--flatness"),
        "{text}"
    );
    for radius in [f64::NAN, f64::INFINITY, 1e200] {
        let text = circle(radius).flatten(None).unwrap_err().to_string();
        assert!(text.contains("farther out than 1e150"), "{radius}: {text}");
    }
    // Weights that differ by all that numbers can still end, one way or another.
    let control = vec![
        [0.0, 0.0, 0.0, 1e300],
        [1e-300, 1e-300, 0.0, 1e-300],
        [1.0, 0.0, 0.0, 1.0],
    ];
    let mut outline = Outline::new([0.0; 3]);
    outline
        .pieces
        .push((Piece::Bezier(control), [1.0, 0.0, 0.0]));
    assert!(outline.flatten(None).map_or(0, |line| line.len()) < 1000);
    // A curve that is smaller than the rounding of its coordinates is one all the same.
    let mut tiny = Outline::new([1e6, 1e6, 0.0]);
    tiny.bezier(
        &[[1e6 + 1e-9, 1e6, 0.0], [1e6 + 1e-9, 1e6 + 1e-9, 0.0]],
        [1e6, 1e6 + 1e-9, 0.0],
    );
    assert!(tiny.flatten(None).unwrap().len() < 10);
}

#[test]
fn what_has_no_extent_is_closed() {
    let mut place = Outline::new([1.0, 2.0, 0.0]);
    place.line([1.0, 2.0, 0.0]);
    place.close_nearly(1e-9);
    assert!(place.is_closed);
}

#[test]
fn straight_lines_may_be_as_far_out_as_numbers_go() {
    let far = f64::MAX;
    let mut outline = Outline::new([-far, 0.0, 0.0]);
    outline.line([far, far, far]);
    outline.line([0.0, -far, 0.0]);
    // Their extent is beyond all numbers, which makes no two ends the same.
    outline.close_nearly(0.01);
    let line = outline.flatten(None).expect("finite");
    assert_eq!(line, [[-far, 0.0, 0.0], [far, far, far], [0.0, -far, 0.0]]);
    outline.line([f64::INFINITY, 0.0, 0.0]);
    outline.flatten(None).expect_err("not finite");
}
