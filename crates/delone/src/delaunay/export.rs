//! From slots to the result, in place: triangles to the front, ghosts behind them, empty slots cut
//! off, corners renumbered to the caller's indices.

use super::sheet::{DEAD, Sheet};
use crate::parallel::Workers;
use crate::{Duplicate, VertexId, Watch};

/// Moves the triangles to the front and the ghosts behind them; returns the number of each.
///
/// `ghost` is the handle of any ghost, `dead` tells whether there are empty slots.
pub(super) fn compact(sheet: Sheet, slots: usize, ghost: Option<u32>, dead: bool) -> [usize; 2] {
    let slots = 3 * slots as u32;
    let mut holes = hull_ring(sheet, ghost);
    let ghosts = holes.len() as u32;
    if dead {
        holes.extend((0..slots).step_by(3).filter(|&t| sheet.corner(t) == DEAD));
    }
    let end_of_triangles = slots - 3 * holes.len() as u32;
    let end_of_ghosts = end_of_triangles + 3 * ghosts;
    fill(sheet, holes, end_of_triangles, slots, |corner| {
        corner < sheet.infinite()
    });
    if dead {
        let holes = (end_of_triangles..end_of_ghosts).step_by(3);
        let empty = holes.filter(|&t| sheet.corner(t) == DEAD).collect();
        fill(sheet, empty, end_of_ghosts, slots, |corner| {
            corner == sheet.infinite()
        });
    }
    [
        end_of_triangles / 3,
        end_of_ghosts / 3 - end_of_triangles / 3,
    ]
    .map(|count| count as usize)
}

/// The handles of all ghosts, in the order of the hull.
fn hull_ring(sheet: Sheet, first: Option<u32>) -> Vec<u32> {
    let after = |&g: &u32| Some(sheet.twin(g + 2) - 1).filter(|&next| Some(next) != first);
    std::iter::successors(first, after).collect()
}

/// Fills the `holes` below handle `end`, in order, with the faces from there on whose first corner is
/// `wanted`. A ghost in a hole takes the place of what fills it.
fn fill(sheet: Sheet, mut holes: Vec<u32>, end: u32, slots: u32, wanted: impl Fn(u32) -> bool) {
    holes.retain(|&t| t < end);
    holes.sort_unstable();
    let mut faces = (end..slots).step_by(3).filter(|&t| wanted(sheet.corner(t)));
    for hole in holes {
        let face = faces.next().expect("bug: more holes than faces");
        if sheet.corner(hole) == DEAD {
            sheet.relocate(face, hole);
        } else {
            swap(sheet, hole, face);
        }
    }
}

/// Swaps two faces, which may be neighbours.
fn swap(sheet: Sheet, a: u32, b: u32) {
    let moved = |h: u32| match h - h % 3 {
        t if t == a => b + h % 3,
        t if t == b => a + h % 3,
        _ => h,
    };
    let [row_a, row_b] =
        [a, b].map(|t| [0, 1, 2].map(|k| (sheet.corner(t + k), sheet.twin(t + k))));
    for (k, ((corner_a, twin_a), (corner_b, twin_b))) in (0..).zip(row_a.into_iter().zip(row_b)) {
        sheet.set_corner(a + k, corner_b);
        sheet.set_corner(b + k, corner_a);
        sheet.bond(a + k, moved(twin_b));
        sheet.bond(b + k, moved(twin_a));
    }
}

/// Gives every corner a new name; `None` if the watch cancelled.
pub(crate) fn rename(
    corners: &mut [[VertexId; 3]],
    name: impl Fn(VertexId) -> VertexId + Sync,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<()> {
    let chunk = workers.chunk_len(corners.len(), 4).min(1 << 18);
    let done = workers.map(
        corners.chunks_mut(chunk).collect(),
        |rows: &mut [[VertexId; 3]]| {
            if watch.is_cancelled() {
                return None;
            }
            for v in rows.as_flattened_mut() {
                *v = name(*v);
            }
            Some(())
        },
    );
    done.into_iter().collect()
}

/// Lists the points that were merged into others, sorted by index.
pub(crate) fn duplicates(points: &[crate::Point], keys: &[u64]) -> Vec<Duplicate> {
    let merged = points.iter().zip(keys).filter(|(p, _)| p.x.is_nan());
    let mut list: Vec<_> = merged
        .map(|(_, &key)| Duplicate {
            dropped: VertexId::from(key as u32),
            kept: VertexId::from((key >> 32) as u32),
        })
        .collect();
    list.sort_unstable_by_key(|d| d.dropped);
    list
}
