//! Bézier curves of any degree, polynomial and rational.

use super::{Affine, MAX_PIECES, Place3, project, too_fine};
use crate::Problem;

/// Most halvings of a curve: far beyond what any curve of reasonable weights needs.
const MAX_DEPTH: u32 = 60;

/// Returns control points as a map moves them.
pub(super) fn mapped(control: &[[f64; 4]], map: &Affine) -> Vec<[f64; 4]> {
    let moved = control.iter().map(|&[x, y, z, w]| {
        let [x, y, z] = map.place([x / w, y / w, z / w]);
        [x * w, y * w, z * w, w]
    });
    moved.collect()
}

/// Adds the points between the ends, from halves that are flat enough.
///
/// *Cost*: O(d²) for each point, of degree d.
pub(super) fn flatten(
    control: &[[f64; 4]],
    flatness: f64,
    line: &mut Vec<Place3>,
) -> Result<(), Problem> {
    let first = line.len();
    let mut waiting = vec![(control.to_vec(), 0)];
    while let Some((mut piece, depth)) = waiting.pop() {
        if is_flat(&piece, flatness) {
            if let Some(&end) = piece.last()
                && !waiting.is_empty()
            {
                line.push(project(end));
            }
            continue;
        }
        if depth == MAX_DEPTH || line.len() - first + waiting.len() + 2 > MAX_PIECES {
            return Err(too_fine());
        }
        let second = halve(&mut piece);
        waiting.push((second, depth + 1));
        waiting.push((piece, depth + 1));
    }
    Ok(())
}

/// Tells whether all control points lie near the segment between the ends.
fn is_flat(control: &[[f64; 4]], flatness: f64) -> bool {
    let [.., last] = control else {
        return true;
    };
    let ends = [control[0], *last].map(project);
    let between = &control[1..control.len() - 1];
    between
        .iter()
        .all(|&p| distance(project(p), ends) <= flatness)
}

/// Returns the distance of a point from a segment, in the plane.
fn distance([x, y, _]: Place3, [[ax, ay, _], [bx, by, _]]: [Place3; 2]) -> f64 {
    let [dx, dy] = [bx - ax, by - ay];
    let length = dx * dx + dy * dy;
    let along = match length > 0.0 {
        true => (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0),
        false => 0.0,
    };
    let [ex, ey] = [x - ax - along * dx, y - ay - along * dy];
    (ex * ex + ey * ey).sqrt()
}

/// Leaves the first half and returns the second.
fn halve(control: &mut [[f64; 4]]) -> Vec<[f64; 4]> {
    let mut second = control.to_vec();
    let degree = control.len() - 1;
    for (level, first) in control.iter_mut().enumerate().skip(1) {
        for i in 0..=degree - level {
            second[i] = [0, 1, 2, 3].map(|k| 0.5 * second[i][k] + 0.5 * second[i + 1][k]);
        }
        *first = second[0];
    }
    second
}
