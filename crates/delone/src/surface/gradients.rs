//! Gradients at vertices: given, or estimated from the values.

use super::adjacency::Adjacency;
use super::fit::Fit;
use super::number::{Frame, dot};
use super::samples::require_number;
use super::{Samples, interpolant};
use crate::pace::Pace;
use crate::{Error, Phase, Point, TriangleId, VertexId, Watch};

/// A gradient at every vertex, for surfaces that are smooth.
///
/// Numbers are in values per unit of the coordinates. Where `f64` cannot hold one (values of 10³⁰⁰ a
/// distance of 10⁻³⁰⁰ apart) it is zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradients {
    rows: Vec<[f64; 2]>,
}

/// How gradients are estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Estimate {
    /// The mean of the gradients of the triangles around, by area. Exact for linear functions; the fastest.
    Mean,
    /// That of the quadratic which comes closest to the values two edges around, near ones counting
    /// more. Exact for quadratics where a vertex has neighbours enough; the most accurate for smooth functions.
    Quadratic,
    /// All at once those that bend the edges least: the sum over all edges of the integral of the squared
    /// second derivative of the cubic along the edge is smallest (Nielson 1983; Renka and Cline 1984). Exact
    /// for linear functions; the least ripples.
    #[default]
    LeastBending,
}

impl Gradients {
    /// Takes one gradient for each point.
    ///
    /// # Errors
    /// [`Error::ValuesMissing`] unless there is one for each point of `samples`;
    /// [`Error::ValueNotFinite`] names a point whose gradient is NaN or infinite.
    pub fn given(samples: &Samples<'_>, gradients: Vec<[f64; 2]>) -> Result<Self, Error> {
        let rows = Self { rows: gradients };
        rows.require_for(samples)?;
        let wrong = |row: &[f64; 2]| row.iter().copied().find(|c| !c.is_finite());
        let culprit = rows.rows.iter().enumerate().find_map(|(i, row)| {
            let given = wrong(row)?;
            let vertex = VertexId::new(i);
            let what = "gradient";
            Some(Error::ValueNotFinite {
                vertex,
                given,
                what,
            })
        });
        culprit.map_or(Ok(rows), Err)
    }

    /// Estimates gradients from values. Those of points in no triangle are zero, those of merged points
    /// too.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: O(n); [`LeastBending`](Estimate::LeastBending) goes through all vertices until none changes
    /// by more than a millionth of the steepest, at most 400 times.
    pub fn estimate(
        samples: &Samples<'_>,
        estimate: Estimate,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        match estimate {
            Estimate::Mean => means(samples, watch),
            Estimate::Quadratic => quadratics(samples, watch),
            Estimate::LeastBending => least_bending(samples, watch),
        }
    }

    /// Returns the gradient at a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline]
    pub fn at(&self, v: VertexId) -> [f64; 2] {
        self.rows[v.index()]
    }

    /// Fails unless there is a gradient for each point.
    pub(super) fn require_for(&self, samples: &Samples<'_>) -> Result<(), Error> {
        let triangulation = samples.ground().triangulation();
        require_number(self.rows.len(), triangulation, "gradients")
    }
}

/// Means of the gradients of triangles, by area.
fn means(samples: &Samples<'_>, watch: &dyn Watch) -> Result<Gradients, Error> {
    let ground = samples.ground();
    let triangulation = ground.triangulation();
    let n = triangulation.points().len();
    let mut pace = Pace::new(
        watch,
        Phase::Interpolate,
        triangulation.num_triangles() as u64,
    );
    let mut sums = vec![([0.0; 2], 0.0); n];
    for t in (0..triangulation.num_triangles()).map(TriangleId::new) {
        pace.step()?;
        let slope = interpolant::slope(samples, t);
        let area = half_area(ground.corners(t));
        for v in ground.mesh().corners(t) {
            let (sum, total) = &mut sums[v.index()];
            *sum = [0, 1].map(|k| sum[k] + area * slope[k]);
            *total += area;
        }
    }
    pace.finish();
    let rows = sums.into_iter().map(|(sum, total)| sum.map(|c| c / total));
    Ok(Gradients {
        rows: rows.map(finite).collect(),
    })
}

/// A rounded area of a triangle, in any unit that is common to all.
fn half_area([a, b, c]: [Point; 3]) -> f64 {
    let half = |p: Point| [p.x * 0.5 - a.x * 0.5, p.y * 0.5 - a.y * 0.5];
    super::number::cross(half(b), half(c)).abs()
}

/// Returns a gradient, or zero if it is no number or infinite.
fn finite(gradient: [f64; 2]) -> [f64; 2] {
    if gradient.iter().all(|c| c.is_finite()) {
        gradient
    } else {
        [0.0; 2]
    }
}

/// Fits a quadratic at every vertex.
fn quadratics(samples: &Samples<'_>, watch: &dyn Watch) -> Result<Gradients, Error> {
    let adjacency = Adjacency::new(&samples.ground());
    let points = samples.ground().triangulation().points();
    let mut rows = vec![[0.0; 2]; points.len()];
    let mut pace = Pace::new(watch, Phase::Interpolate, adjacency.order.len() as u64);
    let (mut around, mut fit) = (Vec::new(), Fit::default());
    for &v in &adjacency.order {
        pace.step()?;
        around.clear();
        for &u in adjacency.of(v) {
            around.push(u);
            around.extend(adjacency.of(u).iter().filter(|&&w| w != v));
        }
        around.sort_unstable();
        around.dedup();
        let place = |v: VertexId| (points[v.index()], samples.value(v));
        let (p, value) = place(v);
        rows[v.index()] = finite(fit.gradient(p, value, around.iter().map(|&u| place(u))));
    }
    pace.finish();
    Ok(Gradients { rows })
}

/// Minimises the bending of all edges, vertex by vertex, until nothing changes.
fn least_bending(samples: &Samples<'_>, watch: &dyn Watch) -> Result<Gradients, Error> {
    /// Change at which to stop, relative to the steepest gradient.
    const ENOUGH: f64 = 1e-6;
    const MOST_ROUNDS: u64 = 400;
    let adjacency = Adjacency::new(&samples.ground());
    // A good beginning saves half of the rounds.
    let mut rows = means(samples, watch)?.rows;
    let total = adjacency.order.len() as u64 * MOST_ROUNDS;
    let mut pace = Pace::new(watch, Phase::Interpolate, total);
    for _ in 0..MOST_ROUNDS {
        let (mut change, mut steepest) = (0.0_f64, 0.0_f64);
        for &v in &adjacency.order {
            pace.step()?;
            let new = finite(straighten(samples, &rows, v, adjacency.of(v)));
            let old = std::mem::replace(&mut rows[v.index()], new);
            for k in 0..2 {
                change = change.max((new[k] - old[k]).abs());
                steepest = steepest.max(new[k].abs());
            }
        }
        if change <= ENOUGH * steepest {
            break;
        }
    }
    pace.finish();
    Ok(Gradients { rows })
}

/// Returns the gradient at `v` that bends its edges least, the gradients at their other ends being as they
/// are.
///
/// On an edge e of length L with rise Δ the cubic with slopes d = g·e and d′ at its ends bends by
/// (12Δ² − 12Δ(d + d′) + 4(d² + dd′ + d′²)) / L³. Its derivative by g vanishes in sum if
/// Σ 2(e·g)e / L³ = Σ (3Δ − d′)e / L³.
fn straighten(
    samples: &Samples<'_>,
    rows: &[[f64; 2]],
    v: VertexId,
    neighbors: &[VertexId],
) -> [f64; 2] {
    let points = samples.ground().triangulation().points();
    let (p, value) = (points[v.index()], samples.value(v));
    let ends = neighbors.iter().map(|u| points[u.index()]);
    let frame = Frame::alike(p, ends);
    let ([mut xx, mut xy, mut yy], mut right) = ([0.0; 3], [0.0; 2]);
    for &u in neighbors {
        let end = points[u.index()];
        let slope = dot(rows[u.index()], [end.x - p.x, end.y - p.y]);
        let rise = 3.0 * (samples.value(u) - value) - slope;
        let edge: [f64; 2] = frame.vector(end);
        let squared = dot(edge, edge);
        let weight = 1.0 / (squared * squared.sqrt());
        xx += 2.0 * weight * edge[0] * edge[0];
        xy += 2.0 * weight * edge[0] * edge[1];
        yy += 2.0 * weight * edge[1] * edge[1];
        right = [0, 1].map(|k| right[k] + weight * rise * edge[k]);
    }
    let determinant = xx * yy - xy * xy;
    let gradient = [
        (yy * right[0] - xy * right[1]) / determinant,
        (xx * right[1] - xy * right[0]) / determinant,
    ];
    // All edges on one line, as far as can be told: only the change along them is known.
    let along = right.map(|c| c / (xx + yy));
    let gradient = match determinant > 1e-14 * (xx + yy) * (xx + yy) {
        true => gradient,
        false => along,
    };
    [0, 1].map(|k| gradient[k] * frame.scale[k])
}
