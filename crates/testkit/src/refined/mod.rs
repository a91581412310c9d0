//! A judge of refined meshes: what must hold of every one, asked of the mesh and the report alone.
//!
//! It shares no code with the refinement or the verifier. It measures triangles itself, looks for the
//! excuses that the report gives, and has the constrained triangulation of all vertices and subsegments
//! built anew: a refined mesh must be exactly that. *Cost*: a few constrained triangulations.

mod bounds;
mod excuses;
mod lines;
mod shape;
mod structure;

pub use shape::Shape;

use crate::domains::Domain;
use crate::generate::scaled;
use bounds::check_bounds;
use delone::{
    Budget, ConstrainedTriangulation, Encroachment, Error, Locked, Outcome, Point, Quality,
    RefinedMesh, Refinement, SizingField, VertexId, Watch,
};
use excuses::check_excuses;
use lines::Lines;
use structure::check_structure;

/// A domain, and how it is to be refined.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Job {
    /// What is drawn, and what of it is kept.
    pub domain: Domain,
    /// What triangles should be like.
    pub quality: Quality,
    /// How large they may be, place by place.
    pub sizing: Option<Cone>,
    /// What must not be split.
    pub locked: Locked,
    /// When segments are split.
    pub encroachment: Encroachment,
    /// Passes of smoothing.
    pub smoothing: usize,
    /// Largest number of vertices.
    pub vertices: Option<usize>,
}

/// A sizing field: edges may grow with the distance from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Where edges are shortest.
    pub tip: Point,
    /// How long they may be there.
    pub least: f64,
    /// By how much they grow a unit of distance, the larger of those along the axes.
    pub growth: f64,
}

impl SizingField for Cone {
    fn max_edge(&self, at: Point) -> f64 {
        let distance = (at.x - self.tip.x).abs().max((at.y - self.tip.y).abs());
        self.least + self.growth * distance
    }
}

impl Job {
    /// Refines.
    ///
    /// # Errors
    /// Those of the library.
    pub fn mesh(&self, threads: usize, watch: &dyn Watch) -> Result<RefinedMesh, Error> {
        let refinement = Refinement::new(self.quality)
            .domain(self.domain.rule)
            .crossings(self.domain.crossings)
            .locked(self.locked)
            .encroachment(self.encroachment)
            .smoothing(self.smoothing)
            .budget(Budget {
                vertices: self.vertices,
                ..Budget::default()
            })
            .threads(threads)
            .watch(watch);
        let refinement = match &self.sizing {
            Some(field) => refinement.sizing(field),
            None => refinement,
        };
        refinement.mesh(self.domain.pslg.clone())
    }

    /// Multiplies everything by `2^exponent`: coordinates and lengths, areas twice.
    pub fn scaled(&self, exponent: i32) -> Self {
        let mut job = self.clone();
        let by = |value: &mut f64| *value = scaled(*value, exponent);
        let by_point =
            |p: &mut Point| *p = Point::new(scaled(p.x, exponent), scaled(p.y, exponent));
        let pslg = &mut job.domain.pslg;
        pslg.points.iter_mut().for_each(by_point);
        pslg.holes.iter_mut().for_each(by_point);
        for region in &mut pslg.regions {
            by_point(&mut region.at);
            region.max_area = region.max_area.map(|area| scaled(area, 2 * exponent));
        }
        job.quality.max_edge.iter_mut().for_each(by);
        let areas = job.quality.max_area.iter_mut();
        areas.for_each(|area| *area = scaled(*area, 2 * exponent));
        if let Some(cone) = &mut job.sizing {
            by_point(&mut cone.tip);
            by(&mut cone.least);
        }
        job
    }
}

/// What is wrong, in words.
type Verdict = Result<(), String>;

fn ensure(holds: bool, otherwise: impl FnOnce() -> String) -> Verdict {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// Judges a mesh and its report.
///
/// # Errors
/// What is wrong.
pub fn judge(job: &Job, refined: &RefinedMesh) -> Verdict {
    let lines = Lines::new(&refined.mesh);
    check_structure(job, refined, &lines)?;
    check_outcome(job, refined)?;
    check_bounds(job, refined)?;
    check_excuses(job, refined, &lines)
}

/// The outcome agrees with what was left undone, and the budget was kept.
fn check_outcome(job: &Job, refined: &RefinedMesh) -> Verdict {
    let RefinedMesh { mesh, report, .. } = refined;
    ensure(report.asked == job.quality, || {
        format!("{:?} was not asked for", report.asked)
    })?;
    let vertices = mesh.triangulation().num_vertices();
    let added = mesh.num_steiner();
    let is_within = job
        .vertices
        .is_none_or(|most| added == 0 || vertices <= most);
    ensure(is_within, || {
        format!(
            "{vertices} vertices exceed the budget of {:?}",
            job.vertices
        )
    })?;
    let unexcused = report.num_unexcused();
    let is_true = match report.outcome {
        Outcome::Complete => unexcused == 0,
        Outcome::BudgetExhausted => job.vertices.is_some(),
        Outcome::PrecisionLimit => unexcused > 0,
        _ => true,
    };
    ensure(is_true, || {
        let outcome = report.outcome;
        format!("{outcome:?} with {unexcused} unmet triangles that nothing excuses")
    })
}

/// The position of a vertex.
fn at(mesh: &ConstrainedTriangulation, v: VertexId) -> Point {
    mesh.triangulation().point(v)
}

/// The distance from a positive number to the next larger one.
fn ulp(value: f64) -> f64 {
    value.abs().next_up() - value.abs()
}

/// How close vertices beside some of the mesh's points may come to leave no room for more.
fn least_room(mesh: &ConstrainedTriangulation, points: impl IntoIterator<Item = Point>) -> f64 {
    let largest = magnitude(mesh.triangulation().points().iter().copied());
    let is_usual = (1e-30..1e30).contains(&largest);
    let least = 2.0_f64.powi(-248) * if is_usual { 1.0 } else { largest };
    least.max(4096.0 * ulp(magnitude(points)))
}

/// The larger coordinate of the largest point, without sign.
fn magnitude(points: impl IntoIterator<Item = Point>) -> f64 {
    let sizes = points.into_iter().map(|p| p.x.abs().max(p.y.abs()));
    sizes.fold(0.0, f64::max)
}
