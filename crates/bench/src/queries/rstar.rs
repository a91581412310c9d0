//! `rstar` at queries.

use super::input::Input;
use super::job::Answer;
use super::question::{Question, TEN, square};
use crate::measure::under_the_clock;
use rstar::RTree;

/// Builds and asks, one query after the other.
pub fn answer(input: &Input) -> Answer {
    let points = input.points.clone();
    let (tree, build) = under_the_clock(|| RTree::bulk_load(points));
    let each = match input.question {
        Question::Nearest => 1,
        _ => TEN,
    };
    let (found, work) = under_the_clock(|| {
        let mut found = Vec::with_capacity(input.asked.len() * each);
        for &p in &input.asked {
            match input.question {
                Question::Nearest => found.extend(tree.nearest_neighbor(p)),
                _ => found.extend(tree.nearest_neighbor_iter(p).take(TEN)),
            }
        }
        found
    });
    let pairs = input.asked.iter().zip(found.chunks(each));
    let squares = pairs.flat_map(|(&p, found)| found.iter().map(move |&&q| square(p, q)));
    Answer {
        build: Some(build),
        work,
        number: input.asked.len(),
        sum: input.sum(each, squares),
    }
}
