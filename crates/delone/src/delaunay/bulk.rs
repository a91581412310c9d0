//! From points to the result in one go: look, order, divide and conquer, hand out.

use super::divide::Divide;
use super::export;
use super::gather::{Ordered, order};
use super::input::{self, Class, Extent};
use super::sheet::Sheet;
use super::witness::Witness;
use crate::memory::reserve;
use crate::order::{Frame, Radix, split_power};
use crate::parallel::Workers;
use crate::{Error, HalfEdgeId, Mesh, Phase, Point, Triangulation, VertexId, Watch};

/// The largest number of points whose half-edges 32 bits can number, one of them reserved.
const MAX_POINTS: usize = (u32::MAX / 6) as usize;
const _: () = assert!(6 * MAX_POINTS < u32::MAX as usize);

/// Refuses more points than ids can number.
pub(crate) fn check_number(given: usize) -> Result<(), Error> {
    let limit = MAX_POINTS;
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    Ok(())
}

/// Triangulates points, whose number has been checked.
pub(super) fn build(
    points: Vec<Point>,
    workers: Workers,
    watch: &dyn Watch,
    witness: impl Witness,
) -> Result<Triangulation, Error> {
    if points.is_empty() {
        let mesh = Mesh::default();
        return Ok(Triangulation::from_parts(points, mesh, 0, Vec::new()));
    }
    let curve = Curve::build_before(&points, workers, watch, witness)?;
    hand_out(points, curve, workers, watch).ok_or(Error::Cancelled)
}

/// A Delaunay triangulation in the numbering of the space-filling curve: neighbours in the plane are
/// neighbours in memory, which is where to go on working on it.
pub(crate) struct Curve {
    ordered: Ordered,
    /// Triangles first, ghosts behind them; the vertex at infinity is the number of points.
    corners: Vec<[VertexId; 3]>,
    twins: Vec<[HalfEdgeId; 3]>,
    triangles: usize,
    /// Whether equal points have been merged.
    has_merged: bool,
    /// The points have been multiplied by 2 to this power.
    scale: i32,
}

impl Curve {
    /// Triangulates at least one point, whose number has been checked.
    pub(crate) fn build(
        points: &[Point],
        workers: Workers,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        Self::build_before(points, workers, watch, ())
    }

    /// Does the same before a witness.
    fn build_before(
        points: &[Point],
        workers: Workers,
        watch: &dyn Watch,
        witness: impl Witness,
    ) -> Result<Self, Error> {
        let chunk = workers.chunk_len(points.len(), 1);
        let extent = workers
            .map(points.chunks(chunk).collect(), Extent::of)
            .into_iter()
            .fold(Extent::EMPTY, Extent::union);
        if !extent.is_finite() {
            return Err(input::first_not_finite(points).expect("bug: all points are finite"));
        }
        let curve = match extent.class() {
            Class::Ordinary { scale } => {
                run::<_, true>(points, extent, scale, workers, watch, witness)
            }
            Class::Wide => run::<_, false>(points, extent, 0, workers, watch, witness),
        };
        curve.ok_or(Error::Cancelled)
    }

    /// Takes the triangulation apart for further work.
    pub(crate) fn into_parts(self) -> CurveParts {
        let infinite = VertexId::new(self.ordered.points.len() - 1);
        let mut corners = self.corners;
        for v in corners[self.triangles..].as_flattened_mut() {
            if *v == infinite {
                *v = VertexId::INFINITE;
            }
        }
        let Ordered {
            mut points,
            mut keys,
        } = self.ordered;
        points.pop();
        keys.pop();
        if self.scale != 0 {
            let [a, b] = split_power(-self.scale);
            for p in &mut points {
                *p = Point::new(p.x * a * b, p.y * a * b);
            }
        }
        CurveParts {
            points,
            keys,
            mesh: Mesh::from_rows(corners, self.twins),
        }
    }
}

/// What a [`Curve`] consists of.
pub(crate) struct CurveParts {
    /// The points in the order of the curve; NaN if merged into another.
    pub points: Vec<Point>,
    /// For each point in its low half its index in the caller's numbering; for a merged one in the
    /// high half the index of the point that stands for it.
    pub keys: Vec<u64>,
    /// Triangles first, ghosts behind them.
    pub mesh: Mesh,
}

/// Triangulates at least one point; with `FILTERED` their coordinates, times 2^`scale`, are ordinary.
/// `None` if the watch cancelled.
fn run<W: Witness, const FILTERED: bool>(
    points: &[Point],
    extent: Extent,
    scale: i32,
    workers: Workers,
    watch: &dyn Watch,
    witness: W,
) -> Option<Curve> {
    let radix = Radix::for_points(points.len());
    let frame = Frame::new(extent.min, extent.max, radix.bits);
    let ordered = order(points, &frame, radix, scale, workers, watch)?;
    let curve = divide::<W, FILTERED>(ordered, &frame, workers, watch, witness)?;
    Some(Curve { scale, ..curve })
}

fn divide<W: Witness, const FILTERED: bool>(
    mut ordered: Ordered,
    frame: &Frame,
    workers: Workers,
    watch: &dyn Watch,
    witness: W,
) -> Option<Curve> {
    let n = ordered.points.len() - 1;
    let (mut corners, mut twins) = (reserve(2 * n), reserve(2 * n));
    let rows = (corners.spare_capacity_mut(), twins.spare_capacity_mut());
    // SAFETY: the arrays outlive the sheet, and nobody touches them while it is in use.
    let sheet = unsafe { Sheet::new(&mut ordered.points, &mut ordered.keys, rows.0, rows.1) };
    let divide = Divide::<W, FILTERED> {
        sheet,
        watch,
        workers,
        witness,
        done: 0.into(),
        has_merged: false.into(),
    };
    let hull = divide.run(0, n, frame)?;
    let has_merged = divide.has_merged.into_inner();
    let [triangles, ghosts] = export::compact(sheet, 2 * n - 2, hull.ghost(), has_merged);
    // SAFETY: 2n slots are reserved, and every face that is left has been written.
    unsafe {
        corners.set_len(triangles + ghosts);
        twins.set_len(triangles + ghosts);
    }
    if has_merged {
        corners.shrink_to_fit();
        twins.shrink_to_fit();
    }
    Some(Curve {
        ordered,
        corners,
        twins,
        triangles,
        has_merged,
        scale: 0,
    })
}

/// Puts the result together in the caller's numbering.
fn hand_out(
    points: Vec<Point>,
    mut curve: Curve,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<Triangulation> {
    watch.progress(Phase::Export, 0, 1);
    let keys = &curve.ordered.keys;
    // The key of the vertex at infinity is all ones, and so is its name.
    let name = |v: VertexId| VertexId::from(keys[v.index()] as u32);
    export::rename(&mut curve.corners, name, workers, watch)?;
    let duplicates = if curve.has_merged {
        export::duplicates(&curve.ordered.points[..points.len()], keys)
    } else {
        Vec::new()
    };
    watch.progress(Phase::Export, 1, 1);
    let mesh = Mesh::from_rows(curve.corners, curve.twins);
    Some(Triangulation::from_parts(
        points,
        mesh,
        curve.triangles,
        duplicates,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_points_than_ids_are_refused() {
        assert_eq!(check_number(MAX_POINTS), Ok(()));
        let (given, limit) = (MAX_POINTS + 1, MAX_POINTS);
        assert_eq!(
            check_number(given),
            Err(Error::TooManyPoints { given, limit })
        );
    }
}
