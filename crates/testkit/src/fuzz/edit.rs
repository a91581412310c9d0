//! Random sequences of edits, each compared with a triangulation made from scratch, and with a model
//! that knows which edits must be refused.

mod model;

use super::points::{kind, points_from_bytes};
use super::{Case, array, guarded, without_one};
use crate::generate::Random;
use delone::edit::LiveTriangulation;
use delone::{Delaunay, Point};
use model::Model;

/// One edit. Vertices and constraints are named by any number, modulo how many there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    /// Inserts a point.
    Insert(Point),
    /// Removes a vertex.
    Remove(usize),
    /// Moves a vertex.
    Move(usize, Point),
    /// Constrains the segment between two vertices.
    Constrain(usize, usize),
    /// Removes a constraint.
    Release(usize),
    /// Does the following edits, so many of them, in a transaction, which fails in the end or does not.
    Together(usize, bool),
}

/// What is to be edited, and how.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// The points to begin with, triangulated in bulk.
    pub start: Vec<Point>,
    /// The edits, one after the other.
    pub edits: Vec<Edit>,
}

/// Fills `script` with the case that `seed` names, with at most so many points to begin with, and at
/// most so many edits.
pub fn case(seed: u64, max_points: usize, max_edits: usize, script: &mut Script) {
    let r = &mut Random::new(seed);
    let kind = kind(r);
    let start = r.below(max_points + 1);
    kind.fill(&mut script.start, start, r);
    let edits = 1 + r.below(max_edits);
    let mut points = Vec::new();
    kind.fill(&mut points, edits, r);
    // Some sequences grow, some shrink, some are all about constraints.
    let style = r.below(4);
    script.edits.clear();
    script
        .edits
        .extend(points.into_iter().map(|p| edit(style, p, r)));
}

fn edit(style: usize, p: Point, r: &mut Random) -> Edit {
    let [a, b] = [0; 2].map(|_| r.below(1 << 16));
    // Insert, remove, move, constrain, release, together.
    const WEIGHTS: [[usize; 6]; 4] = [
        [5, 3, 4, 0, 0, 1],
        [3, 6, 2, 2, 1, 1],
        [5, 2, 4, 6, 2, 1],
        [2, 2, 6, 6, 3, 2],
    ];
    let weights = WEIGHTS[style];
    let mut drawn = r.below(weights.iter().sum());
    let mut which = 0;
    while drawn >= weights[which] {
        drawn -= weights[which];
        which += 1;
    }
    match which {
        0 => Edit::Insert(p),
        1 => Edit::Remove(a),
        2 => Edit::Move(a, p),
        3 => Edit::Constrain(a, b),
        4 => Edit::Release(a),
        _ => Edit::Together(1 + a % 6, b % 2 == 0),
    }
}

/// Reads a script from a fuzzer's bytes: how many edits, three bytes each, and then
/// [points](points_from_bytes), those of the edits before those to begin with.
pub fn script_from_bytes(bytes: &[u8]) -> Script {
    let Some((&count, rest)) = bytes.split_first() else {
        return Script::default();
    };
    let count = usize::from(count).min(rest.len() / 3);
    let (edits, rest) = rest.split_at(3 * count);
    let mut points = points_from_bytes(rest).into_iter();
    let edits = edits.chunks_exact(3).map(|bytes| {
        let [a, b] = [bytes[1], bytes[2]].map(usize::from);
        let mut point = || points.next().unwrap_or_default();
        match bytes[0] % 16 {
            0..5 => Edit::Insert(point()),
            5..8 => Edit::Remove(a),
            8..11 => Edit::Move(a, point()),
            11..14 => Edit::Constrain(a, b),
            14 => Edit::Release(a),
            _ => Edit::Together(1 + a % 8, b % 2 == 0),
        }
    });
    Script {
        edits: edits.collect(),
        start: points.filter(Point::is_finite).collect(),
    }
}

/// Does the edits, and checks everything after each; a panic is a failure too.
///
/// # Errors
/// What went wrong.
pub fn check(script: &Script) -> Result<(), String> {
    guarded(|| check_edits(script))
}

fn check_edits(script: &Script) -> Result<(), String> {
    let t = Delaunay::new().threads(1);
    let t = t.triangulate(script.start.iter().copied());
    let mut live = LiveTriangulation::from_triangulation(&t.map_err(|e| e.to_string())?);
    let mut model = Model::new(&script.start);
    model.compare(&live)?;
    let mut left = &script.edits[..];
    while let Some((&edit, rest)) = left.split_first() {
        left = rest;
        match edit {
            Edit::Together(count, fails) => {
                let (these, rest) = rest.split_at(count.min(rest.len()));
                left = rest;
                together(&mut live, &mut model, these, fails)?;
            }
            edit => single(&mut live, &mut model, edit)?,
        }
        let in_words = |reason| format!("{reason}, with {} edits left", left.len());
        model.compare(&live).map_err(in_words)?;
    }
    Ok(())
}

/// Does an edit, but for transactions, which are not nested here.
fn single(live: &mut LiveTriangulation, model: &mut Model, edit: Edit) -> Result<(), String> {
    match edit {
        Edit::Insert(p) => model.insert(live, p),
        Edit::Remove(k) => model.remove(live, k),
        Edit::Move(k, p) => model.move_to(live, k, p),
        Edit::Constrain(k, l) => model.constrain(live, k, l),
        Edit::Release(k) => model.release(live, k),
        Edit::Together(..) => Ok(()),
    }
}

/// Does edits in a transaction. If it fails, nothing may have changed, not even the ids to come.
fn together(
    live: &mut LiveTriangulation,
    model: &mut Model,
    edits: &[Edit],
    fails: bool,
) -> Result<(), String> {
    let (mut twin, mut changed) = (live.clone(), model.clone());
    let mut outcome = Ok(());
    let ended = live.transaction(|live| {
        outcome = edits
            .iter()
            .try_for_each(|&edit| single(live, &mut changed, edit));
        if fails { Err(()) } else { Ok(()) }
    });
    outcome?;
    if ended.is_err() != fails {
        return Err("a transaction has another outcome than its edits".to_owned());
    }
    if !fails {
        *model = changed;
        return Ok(());
    }
    model.compare(live)?;
    let mut again = live.clone();
    let ids = |live: &mut LiveTriangulation| {
        let mut model = model.clone();
        let outcomes = edits.iter().map(|&edit| {
            let _ = single(live, &mut model, edit);
            let vertices: Vec<_> = live.vertices().collect();
            (vertices, live.constraints().collect::<Vec<_>>())
        });
        outcomes.collect::<Vec<_>>()
    };
    if ids(&mut twin) == ids(&mut again) {
        Ok(())
    } else {
        Err("ids after a transaction that failed are others".to_owned())
    }
}

impl Case for Script {
    fn smaller(&self) -> Vec<Self> {
        let fewer_edits = without_one(&self.edits).map(|edits| Self {
            edits,
            start: self.start.clone(),
        });
        let fewer_points = without_one(&self.start).map(|start| Self {
            start,
            edits: self.edits.clone(),
        });
        fewer_edits.chain(fewer_points).collect()
    }

    fn as_source(&self) -> String {
        let mut source = format!("let start = {};\nlet edits = [\n", array(&self.start));
        for edit in &self.edits {
            let edit = match edit {
                Edit::Insert(p) => format!("Insert(Point::new({:?}, {:?}))", p.x, p.y),
                Edit::Move(k, p) => format!("Move({k}, Point::new({:?}, {:?}))", p.x, p.y),
                other => format!("{other:?}"),
            };
            source += &format!("    Edit::{edit},\n");
        }
        source + "];"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn script(seed: u64) -> Script {
        let mut script = Script::default();
        case(seed, 12, 30, &mut script);
        script
    }

    #[test]
    fn cases_are_named_by_their_seeds_and_pass() {
        for seed in 0..1000 {
            let found = script(seed);
            assert_eq!(found, script(seed));
            let outcome = check(&found);
            assert_eq!(outcome, Ok(()), "seed {seed}\n{}", found.as_source());
        }
    }

    #[test]
    fn bytes_become_scripts() {
        assert_eq!(script_from_bytes(&[]), Script::default());
        let bytes = [3, 0, 9, 9, 11, 1, 2, 15, 3, 4, 9, 1, 2, 3, 0];
        let found = script_from_bytes(&bytes);
        let points = [(1.0, 2.0), (3.0, 0.0)].map(Point::from);
        let edits = [
            Edit::Insert(points[0]),
            Edit::Constrain(1, 2),
            Edit::Together(4, true),
        ];
        assert_eq!(
            (&found.edits[..], &found.start[..]),
            (&edits[..], &points[1..])
        );
        assert_eq!(check(&found), Ok(()));
    }

    #[test]
    fn source_is_exact() {
        let script = Script {
            start: Vec::new(),
            edits: vec![Edit::Move(3, Point::new(0.1 + 0.2, 5e-324))],
        };
        let source = script.as_source();
        assert!(source.contains("Edit::Move(3, Point::new(0.30000000000000004, 5e-324)),"));
    }
}
