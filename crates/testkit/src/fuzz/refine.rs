//! Small domains as in [`segments`], refined with random bounds and budgets.

use super::segments::{self, domain_from_bytes};
use super::{Case, guarded};
use crate::domains::{Domain, check_error};
use crate::generate::{Random, scaled};
use crate::refined::{Cone, Job, judge};
use delone::{Angle, Encroachment, Locked, Outcome, Point, Quality, RefinedMesh, SegmentPolicy};

/// Smallest angles asked for, in degrees; most within what refinement is known to end with.
const ANGLES: [f64; 10] = [20.0, 20.0, 25.0, 28.0, 30.0, 30.0, 33.0, 10.0, 45.0, 59.0];

/// Up to this angle a [plain](is_plain) job must be finished.
const SURE_ANGLE: f64 = 28.0;

/// With so many vertices a [plain](is_plain) job must be finished.
const PLENTY: usize = 4000;

/// Fills `job` with the one that `seed` names, of at most so many points and segments.
///
/// Its coordinates are zero or between 1e-30 and 1e30. Beside edges of 1e200 and 1e-200, rounded
/// numbers cannot tell the shape of a triangle.
pub fn case(seed: u64, max_points: usize, max_segments: usize, job: &mut Job) {
    let mut seeds = Random::new(seed);
    loop {
        segments::case(seeds.bits(), max_points, max_segments, &mut job.domain);
        if job.domain.pslg.points.iter().all(is_ordinary) {
            break;
        }
    }
    choose_options(job, &mut seeds);
}

/// Tells that no coordinate is enormous or tiny.
fn is_ordinary(p: &Point) -> bool {
    [p.x, p.y]
        .iter()
        .all(|&c| c == 0.0 || (1e-30..1e30).contains(&c.abs()))
}

/// Draws bounds, budget and the rest.
fn choose_options(job: &mut Job, r: &mut Random) {
    let points = &job.domain.pslg.points;
    let n = points.len();
    let size = extent(points);
    let one_in = |n: usize, r: &mut Random| r.below(n) == 0;
    let share = |r: &mut Random| size * r.choose(&[0.5, 0.2, 0.1, 0.05]);
    let is_angle = !one_in(8, r);
    job.quality = Quality {
        min_angle: is_angle.then(|| Angle::degrees(r.choose(&ANGLES))),
        max_edge: one_in(6, r).then(|| share(r)).filter(|&edge| edge > 0.0),
        max_area: one_in(6, r)
            .then(|| share(r) * size)
            .filter(|&area| area > 0.0),
        region_areas: one_in(2, r),
    };
    for region in &mut job.domain.pslg.regions {
        let area = share(r) * share(r);
        region.max_area = (area > 0.0 && area < f64::INFINITY).then_some(area);
    }
    job.sizing = one_in(12, r).then(|| Cone {
        tip: points[0],
        least: size * 0.01,
        growth: r.choose(&[0.1, 0.5]),
    });
    job.locked = r.choose(&[
        Locked::Nothing,
        Locked::Nothing,
        Locked::Nothing,
        Locked::Nothing,
        Locked::Boundary,
        Locked::Segments,
    ]);
    let encroachments = [Encroachment::Lens, Encroachment::Lens, Encroachment::Circle];
    job.encroachment = r.choose(&encroachments);
    job.smoothing = if one_in(8, r) { 2 } else { 0 };
    let budgets = [n, n + 1 + r.below(40), 500, PLENTY, PLENTY, PLENTY];
    job.vertices = Some(r.choose(&budgets));
}

/// The larger side of the bounding box.
fn extent(points: &[Point]) -> f64 {
    let side = |of: fn(&Point) -> f64| {
        let [low, high] = [f64::min, f64::max].map(|pick| {
            let all = points.iter().map(of);
            all.reduce(pick).unwrap_or(0.0)
        });
        (high - low).min(f64::MAX)
    };
    side(|p| p.x).max(side(|p| p.y))
}

/// Reads a job from a fuzzer's bytes: two for the options, then a [domain](domain_from_bytes).
pub fn job_from_bytes(bytes: &[u8]) -> Job {
    let Some((&options, rest)) = bytes.split_first_chunk::<2>() else {
        return Job::default();
    };
    let mut job = Job {
        domain: domain_from_bytes(rest),
        ..Job::default()
    };
    if job.domain.pslg.points.iter().all(Point::is_finite) && !job.domain.pslg.points.is_empty() {
        choose_options(
            &mut job,
            &mut Random::new(u16::from_le_bytes(options).into()),
        );
    }
    job
}

/// Refines and judges; a panic is a failure too. With `is_deep`, also on several threads, and with all
/// lengths doubled some times: the mesh must be the same.
///
/// # Errors
/// What went wrong.
pub fn check(job: &Job, is_deep: bool) -> Result<(), String> {
    guarded(|| check_result(job, is_deep))
}

fn check_result(job: &Job, is_deep: bool) -> Result<(), String> {
    let refined = match job.mesh(1, &()) {
        Ok(refined) => refined,
        Err(error) => return check_error(&job.domain, &error),
    };
    judge(job, &refined)?;
    let outcome = refined.report.outcome;
    if is_plain(job) && outcome != Outcome::Complete {
        return Err(format!("{outcome:?}, though nothing is difficult about it"));
    }
    if is_deep {
        let again = job
            .mesh(3, &())
            .map_err(|e| format!("on three threads: {e}"))?;
        if !is_same(&refined, &again, 0) {
            return Err("on three threads it has another mesh".to_owned());
        }
        check_scaled(job, &refined)?;
    }
    Ok(())
}

/// Tells that a job has small whole numbers for coordinates, no tiny crossings, and asks for nothing
/// that is difficult: it must be finished. What is locked forbids no more than it excuses.
fn is_plain(job: &Job) -> bool {
    let is_small = |c: f64| c.fract() == 0.0 && c.abs() < 10.0;
    let points = &job.domain.pslg.points;
    let angle = job.quality.min_angle.map_or(0.0, Angle::to_degrees);
    job.domain.crossings == SegmentPolicy::Error
        && points.iter().all(|p| is_small(p.x) && is_small(p.y))
        && angle <= SURE_ANGLE
        && job.vertices.is_none_or(|most| most >= PLENTY)
        && job.sizing.is_none()
}

/// Multiplied by a power of two, the same job has the same mesh, multiplied.
fn check_scaled(job: &Job, refined: &RefinedMesh) -> Result<(), String> {
    let pslg = &job.domain.pslg;
    let regions = pslg.regions.iter().map(|r| r.at);
    let mut all = pslg
        .points
        .iter()
        .chain(&pslg.holes)
        .copied()
        .chain(regions);
    if !all.all(|p| is_ordinary(&p)) {
        return Ok(());
    }
    for exponent in [-37, 41] {
        let larger = job.scaled(exponent).mesh(1, &());
        let larger = larger.map_err(|e| format!("times 2^{exponent}: {e}"))?;
        if !is_same(refined, &larger, exponent) {
            return Err(format!("times 2^{exponent} it has another mesh"));
        }
    }
    Ok(())
}

/// Tells whether the second mesh is the first one, multiplied by `2^exponent`, number by number.
pub fn is_same(first: &RefinedMesh, second: &RefinedMesh, exponent: i32) -> bool {
    let [a, b] = [first, second].map(|refined| refined.mesh.triangulation());
    let is_place =
        |(p, q): (&Point, &Point)| scaled(p.x, exponent) == q.x && scaled(p.y, exponent) == q.y;
    a.mesh() == b.mesh()
        && a.num_triangles() == b.num_triangles()
        && a.points().len() == b.points().len()
        && a.points().iter().zip(b.points()).all(is_place)
        && first.report.unmet == second.report.unmet
        && first.report.outcome == second.report.outcome
}

impl Case for Job {
    fn smaller(&self) -> Vec<Self> {
        let fewer = self.domain.smaller().into_iter();
        let mut all: Vec<_> = fewer
            .map(|domain| self.with(|job| job.domain = domain))
            .collect();
        all.extend([
            self.with(|job| job.quality.max_edge = None),
            self.with(|job| job.quality.max_area = None),
            self.with(|job| job.quality.min_angle = None),
            self.with(|job| job.quality.region_areas = false),
            self.with(|job| job.sizing = None),
            self.with(|job| job.locked = Locked::Nothing),
            self.with(|job| job.encroachment = Encroachment::Lens),
            self.with(|job| job.smoothing = 0),
        ]);
        all.retain(|job| job != self);
        all
    }

    fn as_source(&self) -> String {
        let Self { domain, .. } = self;
        let options = Self {
            domain: Domain::default(),
            ..self.clone()
        };
        format!("{}\n// {options:?}", domain.as_source())
    }
}

impl Job {
    /// Changes a copy.
    fn with(&self, change: impl FnOnce(&mut Self)) -> Self {
        let mut job = self.clone();
        change(&mut job);
        job
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn job(seed: u64) -> Job {
        let mut job = Job::default();
        case(seed, 8, 6, &mut job);
        job
    }

    #[test]
    fn cases_are_named_by_their_seeds_and_pass() {
        for seed in 0..300 {
            let found = job(seed);
            assert_eq!(found, job(seed));
            let outcome = check(&found, seed % 8 == 0);
            assert_eq!(outcome, Ok(()), "seed {seed}\n{}", found.as_source());
        }
    }

    #[test]
    fn cases_are_of_every_sort() {
        let sorts: [fn(&Job) -> bool; 7] = [
            |j| j.quality.min_angle.is_none(),
            |j| j.quality.max_edge.is_some(),
            |j| j.quality.max_area.is_some(),
            |j| j.sizing.is_some(),
            |j| j.locked == Locked::Boundary,
            |j| j.encroachment == Encroachment::Circle,
            is_plain,
        ];
        for (i, is_of_sort) in sorts.iter().enumerate() {
            let count = (0..1000).filter(|&seed| is_of_sort(&job(seed))).count();
            // Plain ones have to be everything at once.
            let least = if i + 1 == sorts.len() { 5 } else { 50 };
            assert!(count > least, "only {count} of sort {i}");
        }
    }

    #[test]
    fn bytes_become_jobs() {
        assert_eq!(job_from_bytes(&[1]), Job::default());
        let bytes = [7, 0, 0xc3, 2, 0, 1, 2, 3, 0, 0, 0, 0, 1, 1, 1, 1, 0];
        let found = job_from_bytes(&bytes);
        assert_eq!(
            found.domain,
            domain_from_bytes(&bytes[2..]).with_areas_of(&found.domain)
        );
        assert!(found.vertices.is_some());
    }

    impl Domain {
        /// Takes over the largest areas of the regions, which the options choose.
        fn with_areas_of(mut self, other: &Self) -> Self {
            for (region, of) in self.pslg.regions.iter_mut().zip(&other.pslg.regions) {
                region.max_area = of.max_area;
            }
            self
        }
    }
}
