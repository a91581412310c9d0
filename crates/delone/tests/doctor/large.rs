//! How long the doctor takes, and that he does not take more than that.

use super::*;
use std::time::Instant;

/// A long winding ring with small mistakes: n segments.
fn winding(n: usize) -> Pslg {
    let corner = |i: usize| {
        let t = i as f64 / n as f64 * std::f64::consts::TAU;
        let r = 1.0 + 0.2 * (40.0 * t).sin() + 1e-6 * ((i * 7919 % 101) as f64 - 50.0) / n as f64;
        (r * t.cos(), r * t.sin())
    };
    let mut pslg = Pslg::from_points((0..n).map(corner));
    pslg.add_ring(0..n as u32);
    pslg
}

/// Long parallel lines in a slant, whose boxes all overlap, and a point beside each.
fn parallel(n: usize) -> Pslg {
    let mut pslg = Pslg::default();
    for i in 0..n {
        let [x, y] = [i as f64, -(i as f64)];
        let far = n as f64;
        pslg.points.extend(
            [
                (x, y),
                (x + far, y + far),
                (x + far / 3.0 + 0.1, y + far / 3.0),
            ]
            .map(Point::from),
        );
        let first = 3 * i as u32;
        pslg.add_segment(first, first + 1);
    }
    pslg
}

#[test]
fn a_hundred_thousand_segments_take_no_time_squared() {
    let n = 100_000;
    for (name, pslg, tolerance) in [
        ("winding", winding(n), 1e-5),
        ("parallel", parallel(n / 2), 0.2),
    ] {
        // Long lines side by side take triangulation long, which is not what is looked at.
        let rule = match name {
            "winding" => delone::DomainRule::Carve,
            _ => delone::DomainRule::Hull,
        };
        let doctor = Doctor::new().domain(rule).limit(10);
        let start = Instant::now();
        doctor.examine(&pslg).expect("a drawing");
        let exact = start.elapsed();
        let found = doctor
            .tolerance(tolerance)
            .examine(&pslg)
            .expect("a drawing");
        let near = start.elapsed() - exact;
        let repair = doctor
            .tolerance(tolerance)
            .repair(&pslg)
            .expect("a drawing");
        let whole = start.elapsed();
        println!(
            "{name}: examined in {exact:?}, with tolerance in {near:?} ({:?}), repaired in {:?} ({} rounds)",
            found
                .troubles
                .iter()
                .map(|(k, l)| (*k, l.count))
                .collect::<Vec<_>>(),
            whole - near - exact,
            repair.rounds
        );
        require_promises(&pslg, &repair, tolerance);
        assert!(repair.is_settled);
        assert!(whole.as_secs() < 120, "{whole:?}");
    }
}
