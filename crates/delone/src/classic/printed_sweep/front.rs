//! The sweep: a front, and what points see of it.

use super::{Replay, edges};
use crate::Failure;
use crate::classic::ascending;
use crate::predicates::{cross_properly, is_between};
use crate::{Error, Event, Observer, Point, Stage, Sweep, VertexId};
use std::ops::RangeInclusive;

impl<O: Observer> Replay<'_, O> {
    /// Takes one point after the other.
    pub(super) fn sweep(&mut self, helpers: Option<[Point; 2]>) -> Result<(), Error> {
        self.board.at(2);
        let places = helpers.filter(|_| !self.order.is_empty());
        for at in places.into_iter().flatten() {
            self.helpers.push(self.board.create_vertex(at)?);
        }
        self.board.at(3);
        let board = &self.board;
        self.order
            .sort_unstable_by(|&v, &w| board.point(v).lex_cmp(&board.point(w)));
        self.order.splice(0..0, self.helpers.iter().copied());
        self.board.at(4);
        self.begin();
        for next in self.front.len()..self.order.len() {
            self.board.step()?;
            self.take(next)?;
        }
        self.end();
        self.board.end(Stage::Sweep);
        Ok(())
    }

    /// Makes the first triangle, if there are helpers.
    fn begin(&mut self) {
        let &[below, above] = &self.helpers[..] else {
            return;
        };
        let first = self.order[2];
        self.sweep_to(first);
        for edge in [[below, above], [below, first], [above, first]] {
            self.join(edge);
        }
        self.emit([below, first, above]);
        self.front = vec![below, first, above];
        self.board.open_front(&self.front);
    }

    /// Lets the sweep come to the point that is next in order.
    fn take(&mut self, next: usize) -> Result<(), Error> {
        let p = self.order[next];
        self.board.at(5);
        self.sweep_to(p);
        self.board.tell(|| Event::PointConsidered { vertex: p });
        self.board.at(6);
        let Some(run) = self.visible_run(next)? else {
            self.fail(Failure::SeesNothing(p));
            return Ok(());
        };
        let (start, end) = run.into_inner();
        if start == end {
            self.fail(Failure::SeesOne(p));
        }
        let run = self.front[start..=end].to_vec();
        for &v in &run {
            self.board.at(8);
            self.join([v, p]);
        }
        for pair in run.windows(2) {
            self.emit([pair[0], p, pair[1]]);
        }
        self.board.at(9);
        self.replace(start..=end, p);
        Ok(())
    }

    /// Looks at all vertices of the front, and returns the longest run that is visible, of equals the first.
    fn visible_run(&mut self, next: usize) -> Result<Option<RangeInclusive<usize>>, Error> {
        let p = self.order[next];
        let front = self.front.clone();
        let mut is_visible = Vec::with_capacity(front.len());
        for &v in &front {
            self.board.spend(next + self.edges.len())?;
            is_visible.push(self.sees(next, v));
        }
        let mut runs = Vec::new();
        let mut start = 0;
        for same in is_visible.chunk_by(|a, b| a == b) {
            if same[0] {
                runs.push(start..=start + same.len() - 1);
            }
            start += same.len();
        }
        if runs.len() > 1 {
            self.fail(Failure::SeesSeveralRuns(p));
        }
        let length = |run: &RangeInclusive<usize>| run.end() - run.start();
        Ok(runs.into_iter().rev().max_by_key(length))
    }

    /// Tells whether the point that is next in order sees a vertex of the front: there is an edge between
    /// them; or no point in between, and no edge that crosses.
    fn sees(&mut self, next: usize, v: VertexId) -> bool {
        let p = self.order[next];
        let [from, to] = [p, v].map(|w| self.board.point(w));
        let point = |&w: &VertexId| self.board.point(w);
        let crosses = |edge: &[VertexId; 2]| cross_properly([from, to], edge.map(|w| point(&w)));
        let is_visible = self.edges.contains(&ascending([p, v]))
            || !self.order[..next]
                .iter()
                .any(|w| is_between(from, to, point(w)))
                && !self.edges.iter().any(crosses);
        let ray = [p, v];
        self.board.tell(|| Event::RayCast { ray, is_visible });
        is_visible
    }

    /// Lets `p` take the place of the inner vertices of a run.
    fn replace(&mut self, run: RangeInclusive<usize>, p: VertexId) {
        let (start, end) = run.into_inner();
        for inner in (start + 1..end).rev() {
            self.leave(inner);
        }
        self.front.insert(start + 1, p);
        self.board.enter_front(p, Some(self.front[start]));
    }

    /// Gives up a place of the front.
    fn leave(&mut self, at: usize) {
        let vertex = self.front.remove(at);
        let after = at.checked_sub(1).map(|before| self.front[before]);
        self.board.leave_front(vertex, after);
    }

    fn end(&mut self) {
        for at in (0..self.front.len()).rev() {
            self.leave(at);
        }
        self.line.tell_end(&mut self.board);
    }

    fn sweep_to(&mut self, p: VertexId) {
        let x = self.board.point(p).x;
        self.line.tell_at(&mut self.board, || Sweep::Vertical(x));
    }

    /// Enters an edge, and shows it if it is new.
    fn join(&mut self, edge: [VertexId; 2]) {
        let edge = ascending(edge);
        if self.edges.insert(edge) && self.shown.insert(edge) {
            self.board.tell(|| Event::EdgeCreated { edge });
        }
    }

    /// Adds a triangle, and shows those of its sides that nobody has entered.
    fn emit(&mut self, triangle: [VertexId; 3]) {
        self.board.at(8);
        for edge in edges(triangle) {
            if self.shown.insert(edge) {
                self.board.tell(|| Event::EdgeCreated { edge });
            }
        }
        self.board.tell(|| Event::TriangleCreated { triangle });
        self.triangles.push(triangle);
    }
}
