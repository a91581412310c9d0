//! `kiddo` at queries.

use super::input::Input;
use super::job::Answer;
use super::question::{Question, TEN};
use crate::measure::under_the_clock;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use std::num::NonZero;

/// Builds and asks, all queries at once, on one thread.
///
/// # Errors
/// What kiddo says.
pub fn answer(input: &Input) -> Result<Answer, String> {
    let (tree, build) =
        under_the_clock(|| ImmutableKdTree::<f64, 2>::new_from_slice(&input.points));
    let tree = tree.map_err(|error| format!("{error:?}"))?;
    let (work, sum) = if input.question == Question::Nearest {
        let (found, work) = under_the_clock(|| {
            tree.query_batch(&input.asked)
                .nearest_one::<SquaredEuclidean<f64>>()
                .execute()
        });
        let squares = found.iter().map(|found| found.distance);
        (work, input.sum(1, squares))
    } else {
        let ten = NonZero::new(TEN).expect("ten is not zero");
        let (found, work) = under_the_clock(|| {
            tree.query_batch(&input.asked)
                .nearest_n::<SquaredEuclidean<f64>>(ten)
                .execute()
        });
        let squares = found.iter().flatten().map(|found| found.distance);
        (work, input.sum(TEN, squares))
    };
    Ok(Answer {
        build: Some(build),
        work,
        number: input.asked.len(),
        sum,
    })
}
