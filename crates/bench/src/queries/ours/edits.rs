//! Edits, one after the other.

use crate::measure::under_the_clock;
use crate::queries::edits::{Edit, Edits, sum_of};
use crate::queries::job::Answer;
use delone::edit::{EditError, LiveTriangulation};
use delone::{Delaunay, Error, VertexId};

/// Makes a triangulation that can change, and changes it.
///
/// # Errors
/// Those of the library, and, if that is checked, that what was undone has left something behind.
pub fn edit(edits: Edits, check: bool) -> Result<Answer, String> {
    let Edits {
        points,
        list,
        is_undone,
    } = edits;
    let (live, build) = under_the_clock(|| -> Result<_, Error> {
        let t = Delaunay::new().threads(1).triangulate(points)?;
        Ok(LiveTriangulation::from_triangulation(&t))
    });
    let mut live = live.map_err(|error| error.to_string())?;
    let before = check.then(|| live.hash());
    let (outcome, work) = under_the_clock(|| match is_undone {
        false => list.iter().try_for_each(|&edit| apply(&mut live, edit)),
        true => undone(&mut live, &list),
    });
    outcome.map_err(|error| error.to_string())?;
    if is_undone && check && before != Some(live.hash()) {
        return Err("not all is undone".to_owned());
    }
    Ok(Answer {
        build: Some(build),
        work,
        number: list.len(),
        sum: check.then(|| sum_of(triangles(&live))),
    })
}

fn apply(live: &mut LiveTriangulation, edit: Edit) -> Result<(), EditError> {
    match edit {
        Edit::Insert(p) => live.insert(p).map(drop),
        Edit::Remove(v) => live.remove(VertexId::new(v)).map(drop),
        Edit::Move(v, p) => live.move_to(VertexId::new(v), p),
    }
}

/// Does all edits and takes them back, unless one fails.
fn undone(live: &mut LiveTriangulation, list: &[Edit]) -> Result<(), EditError> {
    let outcome: Result<(), Option<EditError>> = live.transaction(|live| {
        let done = list.iter().try_for_each(|&edit| apply(live, edit));
        Err(done.err())
    });
    outcome.or_else(|failure| failure.map_or(Ok(()), Err))
}

fn triangles(live: &LiveTriangulation) -> impl Iterator<Item = [[f64; 2]; 3]> + '_ {
    let place = |v| live.point(v).expect("a corner is a vertex").into();
    live.triangles().map(move |corners| corners.map(place))
}
