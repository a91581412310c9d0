//! Edits as data, the same for everybody, and what a triangulation comes to after them.
//!
//! A tenth as many edits as there are vertices: of one draw of distinct points some are vertices from the
//! beginning and some come later, so lattices stay lattices with holes.

use super::question::Question;
use delone_samples::Distribution;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use std::collections::HashSet;
use std::num::NonZero;

/// One edit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    /// A vertex comes.
    Insert([f64; 2]),
    /// The vertex of this number goes.
    Remove(usize),
    /// The vertex of this number moves.
    Move(usize, [f64; 2]),
}

/// A triangulation's vertices, and what is done to them.
#[derive(Clone, Debug)]
pub struct Edits {
    /// The vertices before, all distinct.
    pub points: Vec<[f64; 2]>,
    /// What is done, in this order.
    pub list: Vec<Edit>,
    /// Is it all undone in the end?
    pub is_undone: bool,
}

impl Edits {
    /// Draws vertices and edits.
    ///
    /// # Errors
    /// If there are too few distinct points, or if `question` asks for no edit.
    pub fn draw(
        question: Question,
        distribution: Distribution,
        size: usize,
        seed: u64,
    ) -> Result<Self, String> {
        let number = size / 10;
        let mut points = distinct(distribution.points(size + 2 * number, seed));
        if points.len() < 4 * number || number == 0 {
            return Err(format!("too few distinct points for {number} edits"));
        }
        let vacant = points.split_off(points.len() - number);
        let (kept, mut edited) = {
            let edited = points.split_off(points.len() - number);
            (points, edited)
        };
        if matches!(
            question,
            Question::InsertNear | Question::RemoveNear | Question::Undo
        ) {
            put_in_rows(&mut edited);
        }
        let first = kept.len();
        let vertices = [kept.as_slice(), &edited].concat();
        let (points, list) = match question {
            Question::Insert | Question::InsertNear | Question::Undo => {
                (kept, edited.into_iter().map(Edit::Insert).collect())
            }
            Question::Remove | Question::RemoveNear => (
                vertices,
                (first..first + number).map(Edit::Remove).collect(),
            ),
            Question::Move => (vertices, moves(first, vacant)),
            Question::Nudge => {
                let places = nudged(&vertices, &edited);
                (vertices, moves(first, places))
            }
            other => return Err(format!("`{other}` asks for no edit")),
        };
        Ok(Self {
            points,
            list,
            is_undone: question == Question::Undo,
        })
    }
}

fn moves(first: usize, places: Vec<[f64; 2]>) -> Vec<Edit> {
    let numbered = places.into_iter().enumerate();
    numbered
        .map(|(i, place)| Edit::Move(first + i, place))
        .collect()
}

/// Keeps the first of equal points.
fn distinct(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut seen = HashSet::with_capacity(points.len());
    // Zero is added so that −0 is 0.
    let is_new = |p: &[f64; 2]| seen.insert(p.map(|c| (c + 0.0).to_bits()));
    points.into_iter().filter(is_new).collect()
}

/// Orders points in rows, every other row backwards.
fn put_in_rows(points: &mut [[f64; 2]]) {
    points.sort_by(|p, q| p[0].total_cmp(&q[0]));
    let length = points.len().isqrt().max(1);
    for (i, row) in points.chunks_mut(length).enumerate() {
        row.sort_by(|p, q| p[1].total_cmp(&q[1]));
        if i % 2 == 1 {
            row.reverse();
        }
    }
}

/// Returns where points lie after a tenth of the way to the nearest other vertex.
fn nudged(vertices: &[[f64; 2]], points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let tree = ImmutableKdTree::<f64, 2>::new_from_slice(vertices).expect("vertices are finite");
    let two = NonZero::new(2).expect("two is not zero");
    let near = tree
        .query_batch(points)
        .nearest_n::<SquaredEuclidean<f64>>(two)
        .execute();
    let pairs = points.iter().zip(near.iter());
    pairs
        .map(|(&p, near)| {
            let near = near.iter().map(|found| vertices[found.item as usize]);
            let q = near.into_iter().find(|&q| q != p).unwrap_or(p);
            [0, 1].map(|k| p[k] + 0.1 * (q[k] - p[k]))
        })
        .collect()
}

/// Sums up, for each triangle, its area over the radius of its circle: the same in whichever way points on one
/// circle are triangulated.
pub fn sum_of(triangles: impl Iterator<Item = [[f64; 2]; 3]>) -> f64 {
    triangles.map(area_over_radius).sum()
}

fn area_over_radius([a, b, c]: [[f64; 2]; 3]) -> f64 {
    let side = |p: [f64; 2], q: [f64; 2]| [q[0] - p[0], q[1] - p[1]];
    let [u, v, w] = [side(a, b), side(a, c), side(b, c)];
    let doubled = u[0] * v[1] - u[1] * v[0];
    let lengths = [u, v, w].map(|[x, y]| x.hypot(y));
    // The radius is the product of the lengths over four areas.
    doubled * doubled / lengths.iter().product::<f64>()
}

#[cfg(test)]
mod tests {
    use super::{Edit, Edits, Question, put_in_rows, sum_of};
    use delone_samples::Distribution;

    const EDITS: [Question; 7] = [
        Question::Insert,
        Question::InsertNear,
        Question::Remove,
        Question::RemoveNear,
        Question::Move,
        Question::Nudge,
        Question::Undo,
    ];

    #[test]
    fn inserting_and_removing_are_each_others_inverse() {
        let draw = |question| Edits::draw(question, Distribution::Grid, 1000, 1).unwrap();
        let [insert, remove] = [Question::InsertNear, Question::RemoveNear].map(draw);
        assert_eq!((insert.points.len(), insert.list.len()), (1000, 100));
        for (i, (insertion, removal)) in insert.list.iter().zip(&remove.list).enumerate() {
            assert_eq!(*removal, Edit::Remove(1000 + i));
            assert_eq!(*insertion, Edit::Insert(remove.points[1000 + i]));
        }
    }

    #[test]
    fn no_two_vertices_ever_meet() {
        for distribution in [
            Distribution::Grid,
            Distribution::LonLat,
            Distribution::F32Duplicates,
        ] {
            for question in EDITS {
                let edits = Edits::draw(question, distribution, 2000, 3).unwrap();
                let mut points = edits.points.clone();
                for edit in edits.list {
                    match edit {
                        Edit::Insert(p) => points.push(p),
                        Edit::Move(i, p) => points[i] = p,
                        Edit::Remove(_) => {}
                    }
                }
                let number = points.len();
                assert_eq!(super::distinct(points).len(), number, "{question}");
            }
        }
        assert!(Edits::draw(Question::Locate, Distribution::Grid, 100, 1).is_err());
        assert!(Edits::draw(Question::Insert, Distribution::Grid, 9, 1).is_err());
    }

    #[test]
    fn rows_are_short_steps() {
        let mut points = Distribution::Uniform.points(10_000, 1);
        let length = |points: &[[f64; 2]]| -> f64 {
            let steps = points.windows(2);
            steps
                .map(|s| super::super::question::square(s[0], s[1]).sqrt())
                .sum()
        };
        let before = length(&points);
        put_in_rows(&mut points);
        assert!(length(&points) < 0.05 * before);
    }

    #[test]
    fn diagonals_do_not_matter() {
        let [a, b, c, d] = [[0.0, 0.0], [2.0, 1.0], [1.0, 3.0], [-1.0, 2.0]];
        let one = sum_of([[a, b, c], [a, c, d]].into_iter());
        let other = sum_of([[a, b, d], [b, c, d]].into_iter());
        // The area is 5, the radius √10 / 2.
        assert!((one - other).abs() < 1e-15 && (one - 10f64.sqrt()).abs() < 1e-15);
    }
}
