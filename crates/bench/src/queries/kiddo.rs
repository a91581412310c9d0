//! `kiddo` at queries.

use super::job::Answer;
use super::question::{Question, TEN};
use crate::measure::under_the_clock;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use std::num::NonZero;

/// Builds and asks, all queries at once, on one thread.
///
/// # Errors
/// What kiddo says.
pub fn answer(
    points: &[[f64; 2]],
    asked: &[[f64; 2]],
    question: Question,
    check: bool,
) -> Result<Answer, String> {
    let (tree, build) = under_the_clock(|| ImmutableKdTree::<f64, 2>::new_from_slice(points));
    let tree = tree.map_err(|error| format!("{error:?}"))?;
    let (queries, sum): (_, f64) = if question == Question::Nearest {
        let (found, queries) = under_the_clock(|| {
            tree.query_batch(asked)
                .nearest_one::<SquaredEuclidean<f64>>()
                .execute()
        });
        (queries, found.iter().map(|found| found.distance).sum())
    } else {
        let ten = NonZero::new(TEN).expect("ten is not zero");
        let (found, queries) = under_the_clock(|| {
            tree.query_batch(asked)
                .nearest_n::<SquaredEuclidean<f64>>(ten)
                .execute()
        });
        (
            queries,
            found.iter().flatten().map(|found| found.distance).sum(),
        )
    };
    Ok(Answer {
        build,
        queries,
        sum: check.then_some(sum),
    })
}
