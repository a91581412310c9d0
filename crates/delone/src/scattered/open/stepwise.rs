//! The point search of the text, step by step and exactly, for study, and where nothing faster succeeds.
//!
//! Wanted is a point t within a triangle such that each of the three sub-triangles holds at least d of l ≥ 3d data
//! (T_i is the one opposite corner t_i). The search begins with the center of gravity and moves t until it is found:
//!
//! - If only T_μ holds enough, t moves away from t_μ, into T_μ, until a line through one of the other corners
//!   and a datum within T_μ is met: the nearest one. So T_μ loses none that T_μ alone had.
//! - If only T_k holds too few, and each of the others can do without what it shares with T_k, t moves towards
//!   t_k, until the first datum has come from within the other two to their boundary, or into t. Otherwise, if
//!   T_i cannot, t moves away from t_j, j being the third: that gives T_i more, or T_k.
//!
//! Two kinds of [counting](Counting): the text counts a datum on an edge on both sides, and advises
//! (remark 3.40) to assign each to one. For that, any two triangles together must have enough, too (Hall's
//! condition). When all three have d, but T_i and T_k have fewer than 2d together, t moves away from t_j.
//!
//! *Ends*: Let f be what is missing in all triangles together, at first at most 2d. No move lets f grow, since
//! what has d keeps it. A move that does not make f smaller is one away from t_j for the sake of T_i, which gives
//! T_i one more of those that it has but for its edge with T_k, d of which suffice. So after at most (d + 1)·2d
//! moves f is zero. Unique counting goes on then: T_i and T_k with fewer than 2d, at least d, get one more with
//! each move. Every other pair has, after such a move, all but those that the third triangle has and the
//! deficient partner has not, fewer than d; so it has enough. These are at most d moves. That there is a datum to
//! stop at is where the two conditions of theorem 3.39 are needed. (In practice, 2d moves do.)
//!
//! The text exchanges the two triangles in its steps 5 and 6, against its proof (cases 3 (c) and (d)):
//! [`Steps::Printed`] does as printed, and may find no candidate, or no end.
//!
//! *Cost*: O(l) a move, some 2 µs a datum.
//!
//! *Source*: diploma thesis, Duisburg, about 1998, theorem 3.39 and algorithm 3.44.

use crate::predicates::{Barycentric, ExactPoint};
use crate::{Error, Point};
use std::cmp::Ordering;
use std::iter::FusedIterator;

/// Which data a sub-triangle has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counting {
    /// All that lie in it or on its boundary: those on an edge count on both sides.
    Closed,
    /// Those assigned to it: each datum is assigned to one of the sub-triangles in which it lies.
    Unique,
}

/// How steps 5 and 6 are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Steps {
    /// As the proof has them.
    #[default]
    Corrected,
    /// As printed, which goes wrong at times.
    Printed,
}

/// Where a point moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// On the line from corner 0, 1 or 2, away from it.
    Away(usize),
    /// On the line to a corner, towards it.
    Towards(usize),
}

/// What comes after a point of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// It moves.
    Moves(Move),
    /// It is found: every sub-triangle has enough.
    Found,
    /// It should move, but nothing lies where it could stop. Then a condition of theorem 3.39 does not
    /// hold, or steps were taken as printed.
    Stuck(Move),
    /// It has moved more often than a search does that ends.
    Endless,
    /// There are fewer data than three times as many as a sub-triangle is to have.
    TooFew,
}

/// A point of the search.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchStep {
    /// Where it is.
    pub place: ExactPoint,
    /// Where it is, rounded.
    pub at: Point,
    /// How many data lie in the sub-triangle opposite each corner, those on its boundary included.
    pub counts: [usize; 3],
    /// What is done next.
    pub next: Next,
}

/// The search: an iterator over its points, of which the last one has the result.
///
/// ```
/// use delone::scattered::{Counting, Next, PointSearch};
/// let corners = [(0.0, 0.0), (60.0, 0.0), (20.0, 50.0)].map(Into::into);
/// let data = [(13.0, 7.0), (23.0, 46.0), (28.0, 17.0), (27.0, 23.0), (43.0, 15.0), (41.0, 18.0)];
/// let search = PointSearch::new(corners, &data.map(Into::into), 2, Counting::Closed)?;
/// let steps: Vec<_> = search.collect();
/// assert_eq!(steps.len(), 4);
/// assert_eq!(steps[3].place.to_string(), "(712/25, 3026/175)");
/// assert_eq!((steps[3].counts, steps[3].next), ([4, 2, 2], Next::Found));
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointSearch {
    corners: [Point; 3],
    data: Vec<Barycentric>,
    least: usize,
    counting: Counting,
    steps: Steps,
    /// Where the search is, and what comes after it; `None` at its end.
    at: Option<Barycentric>,
    moves: usize,
}

impl PointSearch {
    /// Starts a search for a point such that each sub-triangle has at least `least` of the data, which are
    /// different from each other.
    ///
    /// *Errors*: [`Error::NotFinite`] (corners are points 0 to 2, data follow), [`Error::BadDomain`] if the
    /// corners are on one line, and [`Error::DatumOutside`] of the triangle.
    pub fn new(
        corners: [Point; 3],
        data: &[Point],
        least: usize,
        counting: Counting,
    ) -> Result<Self, Error> {
        let all = corners.iter().chain(data);
        if let Some((index, p)) = all.enumerate().find(|(_, p)| !p.is_finite()) {
            let Point { x, y } = *p;
            return Err(Error::NotFinite { index, x, y });
        }
        let relative = |(datum, &at): (usize, &Point)| {
            let relative = Barycentric::of(corners, at).ok_or(FLAT)?;
            match relative.is_within() {
                true => Ok(relative),
                false => Err(Error::DatumOutside { datum, at }),
            }
        };
        Barycentric::of(corners, corners[0]).ok_or(FLAT)?;
        Ok(Self {
            corners,
            data: data
                .iter()
                .enumerate()
                .map(relative)
                .collect::<Result<_, _>>()?,
            least,
            counting,
            steps: Steps::default(),
            at: Some(Barycentric::centroid()),
            moves: 0,
        })
    }

    /// Takes steps 5 and 6 in one of two ways.
    pub fn with_steps(self, steps: Steps) -> Self {
        Self { steps, ..self }
    }

    /// Returns how many moves a search makes at most: d·(2d + 3), if each sub-triangle is to have d data.
    pub fn most_moves(&self) -> usize {
        let d = self.least;
        d.saturating_mul(d.saturating_mul(2).saturating_add(3))
    }

    /// Searches to the end and returns where the point is found, if it is, with one of the data on each line
    /// through a corner and that point, if one lies there.
    pub(super) fn found(mut self) -> Option<(Barycentric, [Option<usize>; 3])> {
        while let Some(at) = self.at.take() {
            if let (_, Next::Found) = self.step(&at) {
                let lines = [0, 1, 2].map(|k| self.on_line(&at, k));
                return Some((at, lines));
            }
        }
        None
    }

    /// Finds a datum on the line through a corner and a point, the corner excepted.
    fn on_line(&self, at: &Barycentric, corner: usize) -> Option<usize> {
        let others = [(corner + 1) % 3, (corner + 2) % 3];
        let lies_there = |p: &Barycentric| !p.is_corner(corner) && at.compare(p, others).is_eq();
        self.data.iter().position(lies_there)
    }

    /// Decides what to do at a point, and does it.
    fn step(&mut self, at: &Barycentric) -> ([usize; 3], Next) {
        let lie = Lie::new(at, &self.data);
        let next = self.next_at(&lie);
        let Next::Moves(way) = next else {
            return (lie.counts(), next);
        };
        if self.moves == self.most_moves() {
            return (lie.counts(), Next::Endless);
        }
        self.moves += 1;
        self.at = lie.nearest(way).map(Barycentric::reduced);
        let next = match self.at {
            Some(_) => next,
            None => Next::Stuck(way),
        };
        (lie.counts(), next)
    }

    /// Steps 2 to 6.
    fn next_at(&self, lie: &Lie) -> Next {
        if self.data.len() / 3 < self.least {
            return Next::TooFew;
        }
        let counts = lie.counts();
        match [0, 1, 2].map(|i| counts[i] >= self.least) {
            [true, true, true] => self.next_if_all(lie),
            [false, true, true] => Next::Moves(self.way_if_two(lie, 0)),
            [true, false, true] => Next::Moves(self.way_if_two(lie, 1)),
            [true, true, false] => Next::Moves(self.way_if_two(lie, 2)),
            [true, false, false] => Next::Moves(Move::Away(0)),
            [false, true, false] => Next::Moves(Move::Away(1)),
            [false, false, true] => Next::Moves(Move::Away(2)),
            // Three times fewer than d, of 3d: that cannot be.
            [false, false, false] => Next::TooFew,
        }
    }

    /// When each has enough: in unique counting, any two must have enough together.
    fn next_if_all(&self, lie: &Lie) -> Next {
        let is_short = |j: &usize| lie.count(|parts| parts & !(1 << j) != 0) / 2 < self.least;
        match (0..3).find(is_short) {
            Some(j) if self.counting == Counting::Unique => Next::Moves(Move::Away(j)),
            _ => Next::Found,
        }
    }

    /// Steps 5 and 6: which way to go when all but one have enough.
    fn way_if_two(&self, lie: &Lie, few: usize) -> Move {
        let [first, second] = [(few + 1) % 3, (few + 2) % 3];
        let can_spare = |i: usize| lie.without_edge(i, few) >= self.least;
        let [away_first, away_second] = match self.steps {
            Steps::Corrected => [second, first],
            Steps::Printed => [first, second],
        };
        if !can_spare(first) {
            Move::Away(away_first)
        } else if !can_spare(second) {
            Move::Away(away_second)
        } else {
            Move::Towards(few)
        }
    }
}

/// Three corners on one line.
const FLAT: Error = Error::BadDomain {
    why: "its three corners lie on one line",
};

impl Iterator for PointSearch {
    type Item = SearchStep;

    fn next(&mut self) -> Option<SearchStep> {
        let at = self.at.take()?;
        let (counts, next) = self.step(&at);
        let place = at.place(self.corners);
        Some(SearchStep {
            at: place.rounded(),
            place,
            counts,
            next,
        })
    }
}

impl FusedIterator for PointSearch {}

/// How the data lie about a point.
struct Lie<'s> {
    at: &'s Barycentric,
    data: &'s [Barycentric],
    /// The sub-triangles in which each datum lies.
    parts: Vec<u8>,
}

impl<'s> Lie<'s> {
    fn new(at: &'s Barycentric, data: &'s [Barycentric]) -> Self {
        let parts = data.iter().map(|p| at.parts(p)).collect();
        Self { at, data, parts }
    }

    fn count(&self, is_meant: impl Fn(u8) -> bool) -> usize {
        self.parts.iter().filter(|&&parts| is_meant(parts)).count()
    }

    fn counts(&self) -> [usize; 3] {
        [0, 1, 2].map(|i| self.count(|parts| parts >> i & 1 != 0))
    }

    /// Counts the data in sub-triangle `i`, but for its edge with sub-triangle `k`; the corner there remains.
    fn without_edge(&self, i: usize, k: usize) -> usize {
        let corner = 3 - i - k;
        let stays = |(parts, p): &(&u8, &Barycentric)| {
            *parts >> i & 1 != 0 && (*parts >> k & 1 == 0 || p.is_corner(corner))
        };
        self.parts.iter().zip(self.data).filter(stays).count()
    }

    /// Steps 7 and 8: the nearest place to which the point can move.
    fn nearest(&self, way: Move) -> Option<Barycentric> {
        let mut nearest: Option<Barycentric> = None;
        for (&parts, p) in self.parts.iter().zip(self.data) {
            for place in self.candidates(way, parts, p).into_iter().flatten() {
                let is_nearer = |best: &Barycentric| is_before(way, &place, best);
                if nearest.as_ref().is_none_or(is_nearer) {
                    nearest = Some(place);
                }
            }
        }
        nearest
    }

    /// Where a datum stops the point, if it does.
    fn candidates(&self, way: Move, parts: u8, p: &Barycentric) -> [Option<Barycentric>; 2] {
        let is_within = |i: usize| parts == 1 << i && !p.is_opposite(i);
        match way {
            Move::Away(from) if is_within(from) => {
                let others = [(from + 1) % 3, (from + 2) % 3];
                others.map(|other| Some(self.at.meeting([from, other], p)))
            }
            Move::Towards(to) => {
                let [i, j] = [(to + 1) % 3, (to + 2) % 3];
                let is_on_way = parts == 1 << i | 1 << j && !p.is_corner(to);
                if is_within(i) || is_on_way {
                    [Some(self.at.meeting([to, j], p)), None]
                } else if is_within(j) {
                    [Some(self.at.meeting([to, i], p)), None]
                } else {
                    [None, None]
                }
            }
            Move::Away(_) => [None, None],
        }
    }
}

/// Tells whether a point that moves comes through `a` before `b`.
fn is_before(way: Move, a: &Barycentric, b: &Barycentric) -> bool {
    match way {
        Move::Away(from) => a.compare(b, [from, (from + 1) % 3]) == Ordering::Greater,
        Move::Towards(to) => a.compare(b, [to, (to + 1) % 3]) == Ordering::Less,
    }
}
