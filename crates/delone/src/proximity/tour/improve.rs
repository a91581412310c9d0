//! Making a tour shorter, move by move.
//!
//! Two kinds of moves, in both directions of the tour; each joins `v` to a neighbour `c` in the
//! triangulation, so there are few to try, and none if the edges at `v` are shorter than that.
//!
//! ```text
//!   2-opt         v → b ┄┄ c → d            v → c ┄┄ b → d
//!   or-opt    p → v┄e → n ┄┄ c → d      p → n ┄┄ c → v┄e → d     up to three sites v┄e move to c,
//!             p → v┄e → n ┄┄ u → c      p → n ┄┄ u → e┄v → c     as they are or reversed
//! ```

use super::cycle::Cycle;
use super::limits::{Limits, Random};
use super::sites::{Kind, Sites};
use crate::Error;
use std::collections::VecDeque;

/// No move reverses more sites than this; tours up to twice as long can be reversed at will. For longer
/// ones such moves gain little and cost the most (Johnson and McGeoch, *The traveling salesman problem: a
/// case study in local optimization*, 1997).
const LONGEST_FLIP: usize = 50_000;

/// The longest part of a tour that or-opt moves.
const LONGEST_PART: usize = 3;

/// The same for what follows a kick, which is to remain a local matter.
const LONGEST_FLIP_AFTER_KICK: usize = 1000;

/// The longest part of a tour that a kick exchanges for the next one.
const LONGEST_KICK: usize = 50;

/// A move as flips to be done one after the other.
#[derive(Clone, Copy, Default)]
struct Move {
    gain: i64,
    flips: [Option<[u32; 4]>; 3],
}

/// A tour that gets shorter.
pub(super) struct Improvement<'s> {
    sites: &'s Sites,
    cycle: Cycle,
    /// Sites whose surroundings have changed since they were looked at.
    waiting: VecDeque<u32>,
    is_waiting: Vec<bool>,
    /// Flips since the last kick began.
    done: Vec<[u32; 4]>,
    longest_flip: usize,
    pub moves: u64,
}

impl<'s> Improvement<'s> {
    pub fn new(sites: &'s Sites) -> Self {
        let n = sites.len();
        Self {
            sites,
            cycle: Cycle::new(n),
            waiting: (0..n as u32).collect(),
            is_waiting: vec![true; n],
            done: Vec::new(),
            longest_flip: LONGEST_FLIP,
            moves: 0,
        }
    }

    /// Moves until no site wants to any more, then tries so many kicks; says whether it came to that.
    pub fn run(&mut self, budget: &mut Limits, kicks: u64) -> Result<bool, Error> {
        if is_tiny(self.sites) {
            self.run_tiny();
            return Ok(true);
        }
        self.settle(budget)?;
        self.longest_flip = LONGEST_FLIP_AFTER_KICK;
        let mut random = Random(0);
        for _ in 0..kicks {
            if budget.is_spent {
                break;
            }
            self.done.clear();
            let gain = self.settle_kick(&mut random, budget)?;
            if gain < 0 {
                self.undo();
            }
        }
        Ok(!budget.is_spent)
    }

    /// Moves until no site wants to any more or the budget is spent, and returns what was gained.
    fn settle(&mut self, budget: &mut Limits) -> Result<i128, Error> {
        let mut gain = 0;
        while let Some(v) = self.waiting.pop_front() {
            self.is_waiting[v as usize] = false;
            if !budget.allows(self.moves)? {
                // What waits will not be looked at any more.
                continue;
            }
            let best = self.best_move(v);
            if best.gain > 0 {
                gain += i128::from(best.gain);
                self.moves += 1;
                best.flips.into_iter().flatten().for_each(|f| self.flip(f));
            }
        }
        Ok(gain)
    }

    /// Exchanges two neighbouring parts of the tour somewhere, and settles what that has stirred up. It
    /// takes four edges at once, which no sequence of gainful moves finds (Martin, Otto and Felten,
    /// *Large-step Markov chains for the traveling salesman problem*, 1991).
    ///
    /// ```text
    ///     p → b ┄┄ c → d ┄┄ e → n        p → d ┄┄ e → b ┄┄ c → n
    /// ```
    fn settle_kick(&mut self, random: &mut Random, budget: &mut Limits) -> Result<i128, Error> {
        let n = self.sites.len();
        let longest = LONGEST_KICK.min((n - 2) / 2);
        let [first, second] = [0; 2].map(|_| 1 + random.below(longest));
        let at = |i: usize, this: &Self| this.cycle.at(i % n);
        let p = random.below(n);
        let places = [0, 1, first, first + 1, first + second, first + second + 1];
        let [p, b, c, d, e, n] = places.map(|i| at(p + i, self));
        let lost = self.distance(p, d) + self.distance(e, b) + self.distance(c, n);
        let freed = self.distance(p, b) + self.distance(c, d) + self.distance(e, n);
        for flip in [[p, b, e, n], [p, e, d, c], [e, c, b, n]] {
            self.flip(flip);
        }
        Ok(i128::from(freed) - i128::from(lost) + self.settle(budget)?)
    }

    /// Undoes all that was done since the last kick began.
    fn undo(&mut self) {
        while let Some([a, b, c, d]) = self.done.pop() {
            self.cycle.flip([a, c, b, d]);
        }
    }

    fn flip(&mut self, flip: [u32; 4]) {
        self.cycle.flip(flip);
        self.done.push(flip);
        for v in flip {
            if !std::mem::replace(&mut self.is_waiting[v as usize], true) {
                self.waiting.push_back(v);
            }
        }
    }

    /// Finds the move that gains most by joining `v` to one of its neighbours.
    fn best_move(&self, v: u32) -> Move {
        let mut best = Move::default();
        for forward in [true, false] {
            self.try_two_opt(v, forward, &mut best);
            self.try_or_opt(v, forward, &mut best);
        }
        best
    }

    /// Tries to replace the edge ahead of `v` and the one ahead of a neighbour.
    fn try_two_opt(&self, v: u32, forward: bool, best: &mut Move) {
        let b = self.cycle.next(v, forward);
        let ahead = self.distance(v, b);
        for &c in self.sites.neighbors(v) {
            let gain = ahead - self.distance(v, c);
            if gain <= 0 {
                return;
            }
            let d = self.cycle.next(c, forward);
            let gain = gain + self.distance(c, d) - self.distance(b, d);
            if gain > best.gain && self.cycle.cost(b, c) <= self.longest_flip {
                *best = Move {
                    gain,
                    flips: [Some([v, b, c, d]), None, None],
                };
            }
        }
    }

    /// Tries to move up to three sites, of which `v` is the first, to a neighbour of `v`.
    fn try_or_opt(&self, v: u32, forward: bool, best: &mut Move) {
        let p = self.cycle.next(v, !forward);
        let mut part = [v; LONGEST_PART];
        for len in 1..=LONGEST_PART {
            let e = part[len - 1];
            let n = self.cycle.next(e, forward);
            let freed = self.distance(p, v) + self.distance(e, n) - self.distance(p, n);
            for &c in self.sites.neighbors(v) {
                let gain = freed - self.distance(v, c);
                if gain <= 0 {
                    break;
                }
                if !part[..len].contains(&c) {
                    self.try_places([p, v, e, n], c, gain, forward, best);
                }
            }
            if let Some(next) = part.get_mut(len) {
                *next = n;
            }
        }
    }

    /// Tries both edges of `c` as the place where the part from `v` to `e` between `p` and `n` goes.
    fn try_places(
        &self,
        [p, v, e, n]: [u32; 4],
        c: u32,
        gain: i64,
        forward: bool,
        best: &mut Move,
    ) {
        if self.cycle.cost(v, c) > self.longest_flip {
            return;
        }
        // The part comes to its place reversed; if it is `n` that it follows, after one flip.
        let come = |u, x| [Some([p, v, u, x]), (u != n).then_some([p, u, n, e]), None];
        let x = self.cycle.next(c, forward);
        let between = gain + self.distance(c, x) - self.distance(e, x);
        if c != p && between > best.gain {
            let [first, second, _] = come(c, x);
            let turn = Some([c, e, v, x]);
            *best = Move {
                gain: between,
                flips: [first, second, turn],
            };
        }
        let u = self.cycle.next(c, !forward);
        let between = gain + self.distance(u, c) - self.distance(u, e);
        // Before p the part is better reversed by 2-opt.
        if c != n && c != p && between > best.gain {
            *best = Move {
                gain: between,
                flips: come(u, c),
            };
        }
    }

    /// Takes the shortest of all tours: there are at most 720.
    fn run_tiny(&mut self) {
        let n = self.sites.len();
        let length = |order: &[u32]| -> i128 {
            let back = [order[n - 1], order[0]];
            let steps = order.windows(2).map(|w| [w[0], w[1]]).chain([back]);
            steps.map(|[a, b]| i128::from(self.distance(a, b))).sum()
        };
        let mut order: Vec<u32> = (0..n as u32).collect();
        let mut best = (length(&order), order.clone());
        while next_permutation(&mut order[1..]) {
            let length = length(&order);
            if length < best.0 {
                best = (length, order.clone());
            }
        }
        self.moves = u64::from(!best.1.is_sorted());
        self.cycle = Cycle::of(best.1);
    }

    #[inline]
    fn distance(&self, a: u32, b: u32) -> i64 {
        self.sites.distance(a, b)
    }

    /// Returns the tour from its beginning; if either direction would do, in that which begins with the
    /// lower names.
    pub fn into_order(self) -> Vec<u32> {
        let nowhere = self.sites.len() as u32 - 1;
        let first = match self.sites.kind() {
            Kind::Closed => 0,
            Kind::From | Kind::Free => nowhere,
        };
        let [ahead, behind] = [true, false].map(|forward| self.cycle.next(first, forward));
        let is_forward = match self.sites.kind() {
            Kind::From => ahead == 0,
            Kind::Closed | Kind::Free => self.sites.name(ahead) <= self.sites.name(behind),
        };
        let mut order = self.cycle.from(first, is_forward);
        order.retain(|&site| self.sites.kind() == Kind::Closed || site != nowhere);
        order
    }
}

/// Finds the shortest tour, if there are so few sites that it can be found.
pub(super) fn shortest(sites: &Sites) -> Option<Vec<u32>> {
    is_tiny(sites).then(|| {
        let mut improvement = Improvement::new(sites);
        improvement.run_tiny();
        improvement.into_order()
    })
}

/// Tells whether there are so few sites that parts of the tour would overlap their surroundings.
fn is_tiny(sites: &Sites) -> bool {
    sites.len() < 8
}

/// Goes on to the lexicographically next order; `false` after the last one.
fn next_permutation(order: &mut [u32]) -> bool {
    let Some(i) = (1..order.len()).rev().find(|&i| order[i - 1] < order[i]) else {
        return false;
    };
    let next = (i..order.len()).rev().find(|&j| order[j] > order[i - 1]);
    order.swap(i - 1, next.expect("bug: order[i] is larger"));
    order[i..].reverse();
    true
}
