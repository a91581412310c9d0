//! `rstar` at queries.

use super::job::Answer;
use super::question::{Question, TEN, square};
use crate::measure::under_the_clock;
use rstar::RTree;

/// Builds and asks, one query after the other.
///
/// # Errors
/// None; the others have some.
pub fn answer(
    points: Vec<[f64; 2]>,
    asked: &[[f64; 2]],
    question: Question,
    check: bool,
) -> Result<Answer, String> {
    let (tree, build) = under_the_clock(|| RTree::bulk_load(points));
    let number = if question == Question::Nearest {
        1
    } else {
        TEN
    };
    let (found, queries) = under_the_clock(|| {
        let mut found = Vec::with_capacity(asked.len() * number);
        for &p in asked {
            match question {
                Question::Nearest => found.extend(tree.nearest_neighbor(p)),
                _ => found.extend(tree.nearest_neighbor_iter(p).take(TEN)),
            }
        }
        found
    });
    let pairs = asked.iter().zip(found.chunks(number));
    let squares = pairs.flat_map(|(&p, found)| found.iter().map(move |&&q| square(p, q)));
    let sum = check.then(|| squares.sum());
    Ok(Answer {
        build,
        queries,
        sum,
    })
}
