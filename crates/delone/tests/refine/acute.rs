//! Segments that meet at small angles.

use crate::support::{assert_complete, assert_ends, job, ring, square};
use delone::{Point, Pslg, Reason};

/// A triangle with an angle of so many degrees at the origin, and sides of these lengths.
fn wedge(degrees: f64, sides: [f64; 2]) -> Pslg {
    let (sin, cos) = degrees.to_radians().sin_cos();
    ring([
        (0.0, 0.0),
        (sides[0], 0.0),
        (sides[1] * cos, sides[1] * sin),
    ])
}

/// A square of side 20 around the origin.
fn frame() -> Pslg {
    ring([(-10.0, -10.0), (10.0, -10.0), (10.0, 10.0), (-10.0, 10.0)])
}

/// Adds a segment from the origin in a direction.
fn add_ray(pslg: &mut Pslg, degrees: f64, length: f64) {
    let origin = pslg.points.iter().position(|p| *p == Point::default());
    let origin = origin.unwrap_or_else(|| {
        pslg.points.push(Point::default());
        pslg.points.len() - 1
    });
    let (sin, cos) = degrees.to_radians().sin_cos();
    pslg.points.push(Point::new(length * cos, length * sin));
    pslg.add_segment(origin as u32, pslg.points.len() as u32 - 1);
}

#[test]
fn wedges_end() {
    for degrees in [59.0, 45.0, 10.0, 1.0, 0.01, 1e-6, 1e-12] {
        assert_ends(&wedge(degrees, [4.0, 4.0]));
        assert_ends(&wedge(degrees, [4.0, 3.0]));
        assert_ends(&wedge(degrees, [1e-3, 7.0]));
    }
}

#[test]
fn a_wedge_names_its_corner() {
    for degrees in [10.0, 1.0, 0.01, 1e-6] {
        let refined = assert_complete(&job(wedge(degrees, [4.0, 4.0]), 20.0));
        let at_corner = refined.report.unmet.iter().find(|u| {
            let corners = refined.mesh.triangulation().mesh().corners(u.triangle);
            corners.contains(&0.into())
        });
        let Some(Reason::SmallInputAngle {
            vertex,
            segments,
            angle,
        }) = at_corner.map(|u| u.reason)
        else {
            panic!("{at_corner:?}");
        };
        let mut named = segments;
        named.sort_unstable();
        assert_eq!((vertex, named), (0.into(), [0, 2]));
        assert!(
            (angle.to_degrees() / degrees - 1.0).abs() < 1e-6,
            "{angle:?}"
        );
    }
}

#[test]
fn slits_into_a_square_end() {
    for degrees in [1.0, 0.01] {
        let mut pslg = frame();
        add_ray(&mut pslg, 20.0, 5.0);
        add_ray(&mut pslg, 20.0 + degrees, 5.0);
        assert_ends(&pslg);
    }
}

#[test]
fn stars_of_acute_segments_end() {
    for (rays, step) in [(36, 10.0), (90, 4.0), (50, 0.1), (20, 1e-4)] {
        let mut pslg = frame();
        for i in 0..rays {
            let length = 2.0 + f64::from(i * 7 % 5);
            add_ray(&mut pslg, 3.0 + step * f64::from(i), length);
        }
        assert_ends(&pslg);
    }
}

#[test]
fn nested_fans_end() {
    // At the end of each ray the next fan opens.
    let mut pslg = frame();
    pslg.points.push(Point::new(-8.0, -1.0));
    let mut from = pslg.points.len() as u32 - 1;
    for level in 0..6 {
        let length = 4.0 * 0.6f64.powi(level);
        let base = pslg.points[from as usize];
        let mut last = from;
        for ray in 0..5 {
            let (sin, cos) = (2.0 * f64::from(ray) + 10.0).to_radians().sin_cos();
            pslg.points
                .push(Point::new(base.x + length * cos, base.y + length * sin));
            last = pslg.points.len() as u32 - 1;
            pslg.add_segment(from, last);
        }
        from = last;
    }
    assert_ends(&pslg);
}

#[test]
fn two_acute_corners_on_one_segment_end() {
    for [left, right] in [[5.0, 5.0], [1.0, 40.0], [0.1, 0.3], [20.0, 1e-3]] {
        let mut pslg = frame();
        let slope = |degrees: f64| degrees.to_radians().tan();
        pslg.points.extend(
            [
                (-3.0, 0.0),
                (3.0, 0.0),
                (1.0, 4.0 * slope(left)),
                (-1.0, 4.0 * slope(right)),
                (2.0, -5.0 * slope(left)),
            ]
            .map(Point::from),
        );
        for [a, b] in [[4u32, 5], [4, 6], [5, 7], [4, 8]] {
            pslg.add_segment(a, b);
        }
        assert_ends(&pslg);
    }
}

#[test]
fn needles_and_saws_end() {
    assert_ends(&ring([(0.0, 0.0), (10.0, 0.0), (10.0, 0.01)]));
    assert_ends(&ring([(0.0, 0.0), (5.0, 0.02), (10.0, 0.0), (5.0, 0.01)]));
    let teeth = (0..40).map(|i| (f64::from(i) * 0.1, if i % 2 == 0 { 1.0 } else { 0.1 }));
    assert_ends(&ring(teeth.chain([(4.0, -1.0), (0.0, -1.0)])));
}

#[test]
fn holes_that_touch_at_acute_corners_end() {
    let mut pslg = square(8.0);
    let holes = [(4.0, 4.0), (7.0, 4.1), (7.0, 3.9), (1.0, 4.3), (1.0, 3.7)];
    pslg.points.extend(holes.map(Point::from));
    pslg.add_ring([4u32, 5, 6]);
    pslg.add_ring([4u32, 7, 8]);
    pslg.holes = vec![Point::new(6.5, 4.0), Point::new(1.5, 4.0)];
    assert_ends(&pslg);
}
