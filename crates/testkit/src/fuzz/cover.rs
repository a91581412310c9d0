//! Data of every kind, covered with random options, and what every cover must keep.
//!
//! The oracles share nothing with the builder but the predicates: [`verify_cover`] proves the result from its arrays, and
//! an error is looked into by definition.

mod refusal;

use super::{Case, array, guarded, without_one};
use crate::data::{DataKind, data};
use crate::generate::{Kind, Random};
use delone::check::{CoverCertificate, SpecialCause, verify_cover};
use delone::scattered::{Cause, Cover, DataTriangulation};
use delone::{Log, Point, VertexId};

/// Data and how to cover them.
#[derive(Clone, Debug, PartialEq)]
pub struct Covering {
    /// The data.
    pub data: Vec<Point>,
    /// d.
    pub least: usize,
    /// How much larger than the hull the outer polygon is.
    pub factor: f64,
    /// The outline, if it is given.
    pub domain: Domain,
    /// Whether Algorithm A adds centers of clusters.
    pub inner_points: bool,
    /// Whether Algorithm B runs.
    pub divides_edges: bool,
    /// Whether Algorithm C runs.
    pub divides_triangles: bool,
    /// Whether edges are flipped.
    pub optimizes: bool,
}

/// A domain that is given, on the bounding box of the data.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Domain {
    /// None: the outer polygon is free.
    #[default]
    Free,
    /// The box itself, so that data lie on its border.
    Box,
    /// The box, and its upper side broken inwards, down to its middle: not convex, and data may lie outside.
    Notch,
}

/// The chapter's options, for no data.
impl Default for Covering {
    fn default() -> Self {
        Self {
            data: Vec::new(),
            least: 1,
            factor: 1.1,
            domain: Domain::Free,
            inner_points: true,
            divides_edges: true,
            divides_triangles: true,
            optimizes: true,
        }
    }
}

impl Covering {
    /// Returns what the library is told.
    pub fn options(&self) -> Cover<'static> {
        let options = Cover::new(self.least)
            .factor(self.factor)
            .inner_points(self.inner_points)
            .divides_edges(self.divides_edges)
            .divides_triangles(self.divides_triangles)
            .optimizes(self.optimizes);
        match self.corners() {
            Some(corners) => options.domain(corners),
            None => options,
        }
    }

    /// Lists the corners of the domain, if one is given, counter-clockwise.
    pub fn corners(&self) -> Option<Vec<Point>> {
        let all = self.data.iter().copied();
        let low = all
            .clone()
            .reduce(|p, q| Point::new(p.x.min(q.x), p.y.min(q.y)));
        let high = all.reduce(|p, q| Point::new(p.x.max(q.x), p.y.max(q.y)));
        let (low, high) = (low.unwrap_or_default(), high.unwrap_or_default());
        let middle = Point::new(f64::midpoint(low.x, high.x), f64::midpoint(low.y, high.y));
        let bottom = [low, Point::new(high.x, low.y)];
        let top = [high, Point::new(low.x, high.y)];
        let mut corners = match self.domain {
            Domain::Free => return None,
            Domain::Box => [bottom, top].concat(),
            Domain::Notch => [&bottom[..], &[top[0], middle, top[1]]].concat(),
        };
        // Of the smallest box the middle may be a corner.
        corners.dedup();
        Some(corners)
    }

    /// Changes a copy.
    fn with(&self, change: impl FnOnce(&mut Self)) -> Self {
        let mut covering = self.clone();
        change(&mut covering);
        covering
    }
}

/// Fills `covering` with the one that `seed` names, of at most so many data.
pub fn case(seed: u64, max_data: usize, covering: &mut Covering) {
    let mut r = Random::new(seed);
    let n = 1 + r.below(max_data);
    covering.data = if r.below(2) == 0 {
        data(r.choose(&DataKind::ALL), n, r.bits())
    } else {
        let side = r.choose(&[3, 5, 8, 20]);
        r.choose(&[
            Kind::Lattice { side },
            Kind::CocircularRings,
            Kind::UlpLattice,
            Kind::Borders,
        ])
        .points(n, r.bits())
    };
    choose_options(covering, &mut r);
}

/// Draws d and all that can be chosen; half of all cases are as in the chapter.
pub fn choose_options(covering: &mut Covering, r: &mut Random) {
    let n = covering.data.len();
    let least = r.choose(&[1, 1, 2, 3, 6, 10, 30, n]);
    *covering = Covering {
        data: std::mem::take(&mut covering.data),
        least: least.max(1),
        ..Covering::default()
    };
    if r.below(2) == 0 {
        return;
    }
    let mut often = || r.below(3) > 0;
    covering.inner_points = often();
    covering.divides_edges = often();
    covering.divides_triangles = often();
    covering.optimizes = often();
    covering.factor = r.choose(&[1.0, 1.0, 1.1, 3.0, 1.000_000_1]);
    covering.domain = r.choose(&[Domain::Free, Domain::Free, Domain::Box, Domain::Notch]);
}

/// Covers data and judges the result, or the error; a panic is a failure too. With `is_deep`, the run is also watched and
/// played, and the same data are covered in another order, some of them several times.
///
/// # Errors
/// What went wrong.
pub fn check(covering: &Covering, is_deep: bool) -> Result<(), String> {
    guarded(|| check_result(covering, is_deep))
}

fn check_result(covering: &Covering, is_deep: bool) -> Result<(), String> {
    let result = covering.options().cover(covering.data.iter().copied());
    match &result {
        Ok(cover) => {
            judge(covering, cover)?;
        }
        Err(error) => refusal::check(covering, error)?,
    }
    if is_deep {
        check_shuffled(covering, result.as_ref().ok())?;
    }
    match result {
        Ok(cover) if is_deep => check_watched(covering, &cover),
        _ => Ok(()),
    }
}

/// Proves a cover right, and returns its numbers.
///
/// # Errors
/// What is wrong with it.
pub fn judge(covering: &Covering, cover: &DataTriangulation) -> Result<CoverCertificate, String> {
    let verdict = verify_cover(
        cover.points(),
        cover.triangles(),
        cover.data(),
        cover.holders(),
        covering.least,
        &(),
    );
    let verdict = verdict.map_err(|e| e.to_string())?;
    let certificate = verdict
        .into_result()
        .map_err(|defects| format!("{defects:?}"))?;
    if cover.data() != covering.data {
        return Err("the data are others".to_owned());
    }
    let CoverCertificate {
        vertices,
        triangles,
        border_edges,
        ..
    } = certificate;
    if triangles + border_edges + 2 != 2 * vertices {
        return Err(format!(
            "{triangles} triangles are not 2 · {vertices} − {border_edges} − 2"
        ));
    }
    check_corners(covering, cover)?;
    check_exceptions(covering, cover, &certificate)?;
    Ok(certificate)
}

/// The corners of a domain are the first vertices.
fn check_corners(covering: &Covering, cover: &DataTriangulation) -> Result<(), String> {
    match covering.corners() {
        Some(corners) if !cover.points().starts_with(&corners) => Err(format!(
            "the corners {corners:?} are not the first vertices"
        )),
        _ => Ok(()),
    }
}

/// Exceptions are named if, and only if, a triangle holds too many, each with its cause.
fn check_exceptions(
    covering: &Covering,
    cover: &DataTriangulation,
    certificate: &CoverCertificate,
) -> Result<(), String> {
    let named = cover.exceptions().iter();
    let named = named.map(|e| (e.triangle, e.data, e.cause));
    let found = certificate.special.iter().map(|special| {
        let cause = match covering.divides_triangles {
            true => cause(special.cause),
            false => Cause::Untried,
        };
        (special.triangle, special.data, cause)
    });
    if named.eq(found) {
        return Ok(());
    }
    let special = &certificate.special;
    Err(format!(
        "{:?} are named, {special:?} are there",
        cover.exceptions()
    ))
}

/// The builder's word for what the checker says.
fn cause(cause: SpecialCause) -> Cause {
    match cause {
        SpecialCause::Edge { edge, data } => Cause::Edge { edge, data },
        SpecialCause::TwoEdges { corner, data } => Cause::TwoEdges { corner, data },
        _ => Cause::Resolution,
    }
}

/// In another order, and with some data several times, they have the same triangles.
fn check_shuffled(covering: &Covering, cover: Option<&DataTriangulation>) -> Result<(), String> {
    let mut r = Random::new(covering.data.len() as u64);
    let again = covering.with(|c| {
        let some: Vec<_> = c.data.iter().copied().step_by(3).collect();
        c.data.extend(some);
        r.shuffle(&mut c.data);
    });
    match (again.options().cover(again.data.iter().copied()), cover) {
        (Ok(again), Some(cover)) if again.points() != cover.points() => {
            Err("in another order it has other vertices".to_owned())
        }
        (Ok(again), Some(cover)) if again.triangles() != cover.triangles() => {
            Err("in another order it has other triangles".to_owned())
        }
        (Ok(shuffled), Some(_)) => judge(&again, &shuffled).map(drop),
        (Err(_), None) => Ok(()),
        (Ok(_), None) => Err("in another order there is no error".to_owned()),
        (Err(error), Some(_)) => Err(format!("in another order: {error}")),
    }
}

/// Watched, it is the same, and what was told can be played forwards and backwards.
fn check_watched(covering: &Covering, cover: &DataTriangulation) -> Result<(), String> {
    let mut log = Log::new("cover", covering.data.clone());
    let watched = covering
        .options()
        .observe(covering.data.iter().copied(), &mut log);
    if watched.as_ref() != Ok(cover) {
        return Err("watched it is another".to_owned());
    }
    let mut scene = log.first_scene();
    for (i, step) in log.steps.iter().enumerate() {
        scene
            .apply(step.event)
            .map_err(|e| format!("step {i} forwards: {e}"))?;
    }
    let data = covering.data.len();
    let mut told: Vec<_> = scene.triangles().map(lowest_first).collect();
    let names = cover
        .triangles()
        .iter()
        .map(|t| t.map(|v| VertexId::new(data + v.index())));
    let mut made: Vec<_> = names.map(lowest_first).collect();
    told.sort_unstable();
    made.sort_unstable();
    if told != made {
        return Err("other triangles were told of".to_owned());
    }
    for (i, step) in log.steps.iter().enumerate().rev() {
        scene
            .revert(step.event)
            .map_err(|e| format!("step {i} backwards: {e}"))?;
    }
    match scene == log.first_scene() {
        true => Ok(()),
        false => Err("backwards it does not come to its beginning".to_owned()),
    }
}

/// Turns a triangle so that its lowest corner is the first.
fn lowest_first<V: Copy + Ord>([a, b, c]: [V; 3]) -> [V; 3] {
    [[a, b, c], [b, c, a], [c, a, b]]
        .into_iter()
        .min()
        .unwrap_or([a, b, c])
}

impl Case for Covering {
    fn smaller(&self) -> Vec<Self> {
        let fewer = without_one(&self.data);
        let mut all: Vec<_> = fewer.map(|data| self.with(|c| c.data = data)).collect();
        all.extend([
            self.with(|c| c.least = (c.least - 1).max(1)),
            self.with(|c| c.factor = 1.1),
            self.with(|c| c.domain = Domain::Free),
            self.with(|c| c.inner_points = true),
            self.with(|c| c.divides_edges = true),
            self.with(|c| c.divides_triangles = true),
            self.with(|c| c.optimizes = true),
        ]);
        all.retain(|c| c != self);
        all
    }

    fn as_source(&self) -> String {
        let options = self.with(|c| c.data.clear());
        format!("{}\n// {options:?}", array(&self.data))
    }
}

#[cfg(test)]
mod tests;
