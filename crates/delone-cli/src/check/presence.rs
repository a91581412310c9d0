//! Are the vertices of a mesh the points of another file?

use delone::Point;
use delone_io::Source;

/// Most points that are named for one reason.
const NAMED: usize = 8;

/// Points that should be there and vertices that should not: how many, and some of them in words.
#[derive(Default)]
pub struct Absences {
    /// All of them.
    pub total: usize,
    /// The first few of either kind.
    pub listed: Vec<String>,
}

impl Absences {
    fn push(&mut self, absences: impl Iterator<Item = String>) {
        for (i, absence) in absences.enumerate() {
            self.total += 1;
            if i < NAMED {
                self.listed.push(absence);
            }
        }
    }
}

/// Says in words which points of `expected` are no vertices, and which vertices are none of them.
///
/// Order and repetition do not matter. *Cost*: two sorts.
pub fn compare(source: &Source, expected: &[Point], vertices: &[Point]) -> Absences {
    let [expected, vertices] = [expected, vertices].map(sorted);
    let lost = missing(&expected, &vertices)
        .map(|(i, p)| format!("point {i} ({:?}, {:?}) of {source} is no vertex", p.x, p.y));
    let added = missing(&vertices, &expected)
        .map(|(i, p)| format!("vertex {i} ({:?}, {:?}) is no point of {source}", p.x, p.y));
    let mut absences = Absences::default();
    absences.push(lost);
    absences.push(added);
    absences
}

fn sorted(points: &[Point]) -> Vec<(usize, Point)> {
    let mut sorted: Vec<_> = points.iter().copied().enumerate().collect();
    sorted.sort_by(|(_, p), (_, q)| p.lex_cmp(q));
    sorted
}

/// Visits what is in `wanted` but not in `present`, both sorted by position.
fn missing<'a>(
    wanted: &'a [(usize, Point)],
    present: &'a [(usize, Point)],
) -> impl Iterator<Item = (usize, Point)> + 'a {
    let mut rest = present.iter().peekable();
    wanted.iter().copied().filter(move |(_, p)| {
        while rest.next_if(|(_, q)| q.lex_cmp(p).is_lt()).is_some() {}
        rest.peek().is_none_or(|(_, q)| q.lex_cmp(p).is_ne())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compare_sets(expected: &[[f64; 2]], vertices: &[[f64; 2]]) -> Vec<String> {
        let points = |set: &[[f64; 2]]| set.iter().copied().map(Point::from).collect::<Vec<_>>();
        compare(&Source::Stdin, &points(expected), &points(vertices)).listed
    }

    #[test]
    fn order_repetition_and_the_sign_of_zero_do_not_matter() {
        let expected = [[1.0, 2.0], [0.0, 0.0], [1.0, 2.0]];
        assert!(compare_sets(&expected, &[[-0.0, 0.0], [1.0, 2.0]]).is_empty());
    }

    #[test]
    fn lost_and_added_points_are_named() {
        let said = compare_sets(&[[1.0, 2.0], [0.0, 0.0]], &[[0.0, 0.0], [1.0, 3.0]]);
        assert_eq!(
            said,
            [
                "point 0 (1.0, 2.0) of - is no vertex",
                "vertex 1 (1.0, 3.0) is no point of -"
            ]
        );
    }
}
