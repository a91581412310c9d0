//! The beach line of a sweep downwards: the lowest, place by place, of the parabolas whose foci are the front.
//!
//! All is computed on the page, in pixels and rounded: it is drawn, and nothing is decided by it. Time
//! O(width of the page · places of the front).

use super::mark::{Form, Look, Mark, spot};
use super::pen::Pen;
use delone::Point;

/// Pixels of the usual size from one place of a line to the next.
const STEP: f32 = 4.0;

/// Draws the beach line over a line at height `at`, within the drawing; a focus on the line is a ray upwards.
pub(super) fn marks(pen: &Pen, front: &[Point], at: f64) -> Vec<Mark> {
    let Some(first) = front.first() else {
        return Vec::new();
    };
    let on_page = |p: Point| pen.view.place(p).map(f64::from);
    let [_, line] = on_page(Point::new(first.x, at));
    let [[left, top], [width, _]] = pen.view.drawing;
    let (above, upon): (Vec<_>, Vec<_>) =
        front.iter().map(|&p| on_page(p)).partition(|p| p[1] < line);
    let beach = |x: f64| lowest(&above, line, x).max(f64::from(top));
    let steps = (width / (STEP * pen.detail.unit)).ceil().max(1.0) as usize;
    let places = (0..=steps).map(|i| {
        let x = f64::from(left) + f64::from(width) * i as f64 / steps as f64;
        [x, beach(x)]
    });
    let places: Vec<_> = places.collect();
    let seen = places.chunk_by(|a, b| a[1] > f64::from(top) || b[1] > f64::from(top));
    let arcs = seen
        .filter(|arc| arc.len() > 1)
        .map(|arc| Form::Path(arc.iter().map(|&place| on_paper(place)).collect()));
    let rays = upon
        .iter()
        .map(|&[x, y]| Form::Line([[x, y], [x, beach(x)]].map(on_paper)));
    let look = Look::Front;
    arcs.chain(rays).map(|form| Mark { look, form }).collect()
}

/// Returns how low the parabolas of these foci reach at `x`; heights of a page grow downwards.
fn lowest(foci: &[[f64; 2]], line: f64, x: f64) -> f64 {
    let height = |&[fx, fy]: &[f64; 2]| {
        let across = x - fx;
        (fy + line) / 2.0 - across * across / (2.0 * (line - fy))
    };
    foci.iter().map(height).fold(f64::NEG_INFINITY, f64::max)
}

fn on_paper(place: [f64; 2]) -> [i32; 2] {
    spot(place.map(|v| v as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_beach_is_as_far_from_its_focus_as_from_the_line() {
        let foci = [[10.0, 20.0], [60.0, 45.0], [90.0, 5.0]];
        let line = 50.0;
        for x in 0..100 {
            let x = f64::from(x);
            let y = lowest(&foci, line, x);
            let distances = foci.map(|[fx, fy]| (x - fx).hypot(y - fy));
            let nearest = distances.into_iter().fold(f64::INFINITY, f64::min);
            assert!(((line - y) - nearest).abs() < 1e-9, "{x}: {y}");
        }
        assert_eq!(lowest(&[], line, 0.0), f64::NEG_INFINITY);
    }
}
