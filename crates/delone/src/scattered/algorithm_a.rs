//! Algorithm A (chapter 3.25): an outer polygon, and centers of clusters in it, as many as leave every triangle of the
//! Delaunay triangulation enough data.
//!
//! The text triangulates anew for every center. Here a center that goes is removed from the triangulation and the two
//! that come are inserted, and only the data of triangles that change are dealt out again; since the Delaunay
//! triangulation is unique, the result is the same. And a polygon that must fail is not tried: see [`Witness`].

use super::Cover;
use super::centers::Centers;
use super::field::Field;
use super::outline::{Outline, Reduction};
use super::trial::{Short, Trial, triangulate};
use super::witness::Witness;
use crate::{Error, Event, Observer, Point, Stage, TriangleId, VertexId};

/// Its pseudocode.
pub(crate) const CODE_A: &[&str] = &[
    "S_A := the hull of the data, blown up, needless corners dropped",
    "S_I := ∅; T := Delaunay triangulation of S_A",
    "tria := T if every triangle holds at least d data, else none; misses := 0",
    "while misses < 3:",
    "  divide the fullest cluster: S_I has one more center; T := Delaunay triangulation of S_A ∪ S_I",
    "  if every triangle of T holds at least d data: tria := T, misses := 0",
    "  else: misses := misses + 1",
    "if tria is none: shrink the shortest edge of S_A to the point where its neighbours meet; go to 2",
    "return tria",
];

/// Runs it: afterwards every triangle holds enough.
///
/// # Errors
/// [`Error::DomainTooEmpty`] if the domain is given, and no triangulation of it does; [`Error::BadDomain`],
/// [`Error::DatumOutside`] if it is not good; [`Error::Cancelled`].
pub(super) fn run(field: &mut Field<impl Observer>, options: &Cover) -> Result<(), Error> {
    field.at(1);
    let mut polygon = match &options.domain {
        Some(corners) => Polygon::Given(Outline::of_domain(corners)?),
        None => Polygon::Free(Outline::around(&field.data.points, options.factor)?),
    };
    end(field, Stage::OuterPolygon);
    let centers = Centers::new(&field.data.points);
    loop {
        if let Polygon::Free(outline) = &mut polygon {
            while !field.is_watched()
                && is_hopeless(outline, field.data.points.len(), options.least)
            {
                reduce_once(field, outline);
                field.spend(64)?;
            }
        }
        let corners = polygon.corners();
        let failure = match best(field, &polygon, &corners, centers.clone(), options)? {
            Ok(inner) => {
                field.at(9);
                let triangles = triangulate(&corners, &inner)?;
                field.lay_out([corners, inner].concat(), &triangles)?;
                require_filled(field, options.least)?;
                end(field, Stage::Clusters);
                return Ok(());
            }
            Err(failure) => failure,
        };
        match &mut polygon {
            Polygon::Free(outline) => reduce(field, outline, failure.witnesses.as_deref())?,
            Polygon::Given(_) => return Err(failure.too_empty),
        }
    }
}

/// Tells whether the polygon has so many corners that any triangulation of it has more triangles than the data suffice
/// for: then no center helps, and there is no need to try. Each datum counts once.
fn is_hopeless(outline: &Outline, data: usize, least: usize) -> bool {
    (outline.num_corners() - 2).saturating_mul(least) > data
}

/// What the outer points are.
enum Polygon {
    /// The corners of a domain: they stay.
    Given(Vec<Point>),
    /// What was laid around the data: it may have fewer corners.
    Free(Outline),
}

impl Polygon {
    fn corners(&self) -> Vec<Point> {
        match self {
            Self::Given(corners) => corners.clone(),
            Self::Free(outline) => outline.points(),
        }
    }
}

/// Why no triangulation was good.
struct Failure {
    /// The first one.
    too_empty: Error,
    /// What shows, for each triangulation that was tried, that the like of it in another polygon is no good either.
    witnesses: Option<Vec<Witness>>,
}

/// Finds the last good triangulation that has these corners, and returns its vertices besides; or why there is none.
fn best<'a>(
    field: &mut Field<'a, impl Observer>,
    polygon: &Polygon,
    corners: &[Point],
    centers: Centers<'a>,
    options: &Cover,
) -> Result<Result<Vec<Point>, Failure>, Error> {
    let least = options.least;
    let mut trial = Trial::begin(field, corners, centers)?;
    let mut best = match trial.judge(least, [3, 3]) {
        None => Ok(Vec::new()),
        Some(t) => Err(Failure {
            too_empty: too_empty(trial.field, t, least),
            witnesses: witness(&trial, polygon, least).map(|first| vec![first]),
        }),
    };
    let mut misses = 0;
    while options.inner_points && misses < options.misses {
        trial.field.at(5);
        if !trial.add_center()? {
            break;
        }
        trial.field.advance()?;
        match trial.judge(least, [6, 7]) {
            None => (best, misses) = (Ok(trial.inner_points()), 0),
            Some(_) => misses += 1,
        }
        if let Err(failure) = &mut best
            && let Some(mut witnesses) = failure.witnesses.take()
        {
            failure.witnesses = witness(&trial, polygon, least).map(|next| {
                witnesses.push(next);
                witnesses
            });
        }
    }
    trial.end();
    Ok(best)
}

/// Looks for a triangle that shows that other polygons are no good either; not for who watches and wants to see that, nor
/// where a center is hidden by a corner that may go.
fn witness(trial: &Trial<impl Observer>, polygon: &Polygon, least: usize) -> Option<Witness> {
    match polygon {
        Polygon::Free(outline) if !trial.field.is_watched() && trial.has_all_centers() => {
            Witness::find(trial.field, outline, least)
        }
        _ => None,
    }
}

/// Refuses a triangulation one of whose triangles cannot hold enough; chooses who holds what so that all do.
///
/// # Errors
/// [`Error::DomainTooEmpty`] names one that does not.
pub(super) fn require_filled(field: &mut Field<impl Observer>, least: usize) -> Result<(), Error> {
    match Short::default().settle(field, least) {
        None => Ok(()),
        Some(t) => Err(too_empty(field, t, least)),
    }
}

fn too_empty(field: &Field<impl Observer>, t: TriangleId, least: usize) -> Error {
    Error::DomainTooEmpty {
        triangle: field.corners(t),
        data: field.stock.count(t),
        least,
    }
}

/// Makes the outer polygon smaller by a corner, and goes on as long as witnesses show that it is no good.
///
/// # Errors
/// [`Error::Cancelled`].
fn reduce(
    field: &mut Field<impl Observer>,
    outline: &mut Outline,
    witnesses: Option<&[Witness]>,
) -> Result<(), Error> {
    loop {
        let reduction = reduce_once(field, outline);
        field.spend(64)?;
        let survives = |witness: &Witness| witness.survives(outline, &reduction);
        if !witnesses.is_some_and(|all| all.iter().all(survives)) {
            return Ok(());
        }
    }
}

fn reduce_once(field: &mut Field<impl Observer>, outline: &mut Outline) -> Reduction {
    field.at(8);
    let numbers: Vec<_> = match field.is_watched() {
        true => outline.corners().map(|(number, _)| number).collect(),
        false => Vec::new(),
    };
    let vertex = |number| VertexId::new(numbers.partition_point(|&other| other < number));
    let reduction = outline.reduce().expect("bug: a triangle holds all data");
    let edge = match reduction {
        Reduction::Edge { ends, .. } => Some(ends.map(|number| field.name(vertex(number)))),
        Reduction::Enclosed => None,
    };
    field.tell(|| Event::OuterReduced { edge });
    reduction
}

fn end(field: &mut Field<impl Observer>, stage: Stage) {
    field.tell(|| Event::StageEnded {
        stage,
        min_angle: None,
    });
}
