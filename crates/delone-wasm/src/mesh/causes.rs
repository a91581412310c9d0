//! Why vertices were added: what an observer of refinement keeps of all that it is told.
//!
//! One record of a fixed size for each vertex, and no log. What leads to a vertex is told just before it: the triangle
//! whose turn it is, a place proposed for it or rejected, a segment and who lies too close to it. Which edge is
//! divided is told before the vertex by one strategy, and behind it by the other.

use delone::{Event, Observer, Step, VertexId};

/// What stands for no vertex.
const NONE: u32 = u32::MAX;

/// Why a vertex was added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// To remove a triangle with a small angle, by a vertex in the middle of its circle, or near to that.
    Circumcenter,
    /// The same, but that place could not be used: an edge is divided instead.
    RejectedCircumcenter,
    /// To divide a segment that another vertex lies too close to.
    Encroachment,
    /// To divide what is larger than asked for.
    Size,
    /// As part of a lattice, where sizes are uniform.
    Lattice,
}

/// Why and when a vertex was added; vertices by their numbers in the result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cause {
    pub rule: Rule,
    /// The step that added it, from 1.
    pub step: u32,
    triangle: [u32; 3],
    edge: [u32; 2],
    by: u32,
}

/// A million vertices must fit into the memory of a page beside their mesh.
const _: () = assert!(size_of::<Cause>() <= 40);

impl Cause {
    /// The triangle that was to go.
    pub fn triangle(&self) -> Option<[VertexId; 3]> {
        known(self.triangle)
    }

    /// The edge that was divided.
    pub fn edge(&self) -> Option<[VertexId; 2]> {
        known(self.edge)
    }

    /// The vertex that lay too close to that edge.
    pub fn by(&self) -> Option<VertexId> {
        known([self.by]).map(|[v]| v)
    }
}

/// Keeps the cause of each vertex.
#[derive(Debug, Default)]
pub(super) struct Causes {
    /// The number of the first vertex that was added.
    first: Option<usize>,
    causes: Vec<Cause>,
    steps: u32,
    waiting: Waiting,
    /// In the thesis a triangle has its turn for its angle, otherwise for its size.
    is_thesis: bool,
}

/// What was told since the last vertex.
#[derive(Clone, Copy, Debug, Default)]
struct Waiting {
    considered: Option<[VertexId; 3]>,
    proposed: Option<[VertexId; 3]>,
    rejected: Option<([VertexId; 3], [VertexId; 2])>,
    encroached: Option<([VertexId; 2], VertexId)>,
    split: Option<[VertexId; 2]>,
    /// Whether the vertex has come.
    is_over: bool,
}

impl Causes {
    /// Keeps nothing yet.
    pub fn new(is_thesis: bool) -> Self {
        Self {
            is_thesis,
            ..Self::default()
        }
    }

    /// Returns the cause of a vertex that was added.
    pub fn of(&self, vertex: VertexId) -> Option<&Cause> {
        let i = vertex.index().checked_sub(self.first?)?;
        self.causes.get(i)
    }

    fn created(&mut self, vertex: VertexId) {
        let first = *self.first.get_or_insert(vertex.index());
        if vertex.index() != first + self.causes.len() {
            return;
        }
        let cause = self.waiting.cause(self.steps, self.is_thesis);
        self.causes.push(cause);
        self.waiting.is_over = true;
    }

    fn deleted(&mut self, vertex: VertexId) {
        let last = self.first.map(|first| first + self.causes.len());
        if last == Some(vertex.index() + 1) {
            self.causes.pop();
        }
    }

    fn split(&mut self, edge: [VertexId; 2], vertex: VertexId) {
        let is_last = self.of(vertex).is_some();
        if !is_last {
            self.waiting().split = Some(edge);
            return;
        }
        self.waiting.split = Some(edge);
        if let Some(last) = self.causes.last_mut() {
            *last = self.waiting.cause(last.step, self.is_thesis);
        }
    }

    /// What is told for the next vertex.
    fn waiting(&mut self) -> &mut Waiting {
        if self.waiting.is_over {
            self.waiting = Waiting::default();
        }
        &mut self.waiting
    }
}

impl Observer for Causes {
    fn observe(&mut self, step: Step) {
        self.steps = self.steps.saturating_add(1);
        match step.event {
            Event::TriangleConsidered { triangle } => {
                self.waiting = Waiting {
                    considered: Some(triangle),
                    ..Waiting::default()
                };
            }
            Event::CircumcenterProposed { triangle, .. } => {
                let considered = self.waiting().considered;
                // One that had its turn before, and for which nothing was found, is not what this is about.
                let is_it = |other: &[VertexId; 3]| other.iter().all(|v| triangle.contains(v));
                self.waiting = Waiting {
                    considered: considered.filter(is_it),
                    proposed: Some(triangle),
                    ..Waiting::default()
                };
            }
            Event::CircumcenterRejected { triangle, edge } => {
                self.waiting().rejected = Some((triangle, edge));
            }
            Event::Encroached { segment, by } => self.waiting().encroached = Some((segment, by)),
            Event::SegmentSplit { edge, vertex } => self.split(edge, vertex),
            Event::VertexCreated { vertex, .. } => self.created(vertex),
            Event::VertexDeleted { vertex, .. } => self.deleted(vertex),
            Event::StageEnded { .. } => self.waiting = Waiting::default(),
            _ => {}
        }
    }
}

impl Waiting {
    fn cause(&self, step: u32, is_thesis: bool) -> Cause {
        let (rule, triangle, by) = self.why(is_thesis);
        Cause {
            rule,
            step,
            triangle: triangle.map_or([NONE; 3], numbers),
            edge: self.split.map_or([NONE; 2], numbers),
            by: by.map_or(NONE, |v| numbers([v])[0]),
        }
    }

    /// Decides which rule was followed, for which triangle, and on account of which vertex. What was told of another
    /// edge than the divided one came to nothing.
    fn why(&self, is_thesis: bool) -> (Rule, Option<[VertexId; 3]>, Option<VertexId>) {
        let is_split = |edge: [VertexId; 2]| {
            let [a, b] = edge;
            self.split.is_some_and(|s| s == [a, b] || s == [b, a])
        };
        let by = self.encroached.filter(|&(segment, _)| is_split(segment));
        let by = by.map(|(_, by)| by);
        if let Some((triangle, _)) = self.rejected.filter(|&(_, edge)| is_split(edge)) {
            return (Rule::RejectedCircumcenter, Some(triangle), by);
        }
        if by.is_some() {
            return (Rule::Encroachment, None, by);
        }
        let is_size = self.considered.is_some() && !is_thesis;
        match self.proposed.or(self.considered) {
            Some(triangle) if is_size => (Rule::Size, Some(triangle), None),
            Some(triangle) => (Rule::Circumcenter, Some(triangle), None),
            None if self.split.is_some() => (Rule::Size, None, None),
            None => (Rule::Lattice, None, None),
        }
    }
}

fn numbers<const N: usize>(vertices: [VertexId; N]) -> [u32; N] {
    vertices.map(|v| v.index() as u32)
}

fn known<const N: usize>(numbers: [u32; N]) -> Option<[VertexId; N]> {
    let is_known = numbers.iter().all(|&v| v != NONE);
    is_known.then(|| numbers.map(|v| VertexId::new(v as usize)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::Point;

    const AT: Point = Point { x: 1.0, y: 2.0 };

    fn ids<const N: usize>(numbers: [usize; N]) -> [VertexId; N] {
        numbers.map(VertexId::new)
    }

    fn after(is_thesis: bool, events: &[Event]) -> Causes {
        let mut causes = Causes::new(is_thesis);
        for &event in events {
            causes.observe(Step { line: 1, event });
        }
        causes
    }

    fn created(v: usize) -> Event {
        let vertex = VertexId::new(v);
        Event::VertexCreated { vertex, at: AT }
    }

    fn split(ends: [usize; 2], v: usize) -> Event {
        let (edge, vertex) = (ids(ends), VertexId::new(v));
        Event::SegmentSplit { edge, vertex }
    }

    fn proposed(corners: [usize; 3]) -> Event {
        let triangle = ids(corners);
        Event::CircumcenterProposed { triangle, at: AT }
    }

    fn rejected(corners: [usize; 3], ends: [usize; 2]) -> Event {
        let (triangle, edge) = (ids(corners), ids(ends));
        Event::CircumcenterRejected { triangle, edge }
    }

    fn encroached(ends: [usize; 2], v: usize) -> Event {
        let (segment, by) = (ids(ends), VertexId::new(v));
        Event::Encroached { segment, by }
    }

    fn considered(corners: [usize; 3]) -> Event {
        let triangle = ids(corners);
        Event::TriangleConsidered { triangle }
    }

    #[test]
    fn each_rule_is_known_by_what_is_told_before() {
        let told = [
            created(10),
            proposed([1, 2, 3]),
            created(11),
            encroached([1, 2], 7),
            split([1, 2], 12),
            created(12),
            // This one comes to nothing …
            proposed([3, 4, 5]),
            // … and this one divides an edge instead.
            proposed([4, 5, 6]),
            rejected([4, 5, 6], [2, 1]),
            split([1, 2], 13),
            created(13),
            considered([7, 8, 9]),
            proposed([7, 8, 9]),
            created(14),
            split([3, 4], 15),
            created(15),
        ];
        let causes = after(false, &told);
        let rule = |v: usize| causes.of(VertexId::new(v)).expect("a cause").rule;
        let expected = [
            Rule::Lattice,
            Rule::Circumcenter,
            Rule::Encroachment,
            Rule::RejectedCircumcenter,
            Rule::Size,
            Rule::Size,
        ];
        assert_eq!([10, 11, 12, 13, 14, 15].map(rule), expected);
        let twelfth = causes.of(VertexId::new(12)).expect("a cause");
        assert_eq!(
            (twelfth.by(), twelfth.edge()),
            (Some(VertexId::new(7)), Some(ids([1, 2])))
        );
        assert_eq!((twelfth.triangle(), twelfth.step), (None, 6));
        assert!(causes.of(VertexId::new(9)).is_none() && causes.of(VertexId::new(16)).is_none());
    }

    #[test]
    fn the_thesis_tells_of_the_edge_behind_the_vertex() {
        let told = [
            created(5),
            split([0, 1], 5),
            considered([1, 2, 3]),
            rejected([1, 2, 3], [1, 2]),
            created(6),
            split([1, 2], 6),
            considered([1, 2, 3]),
            proposed([2, 3, 4]),
            created(7),
            created(8),
            Event::VertexDeleted {
                vertex: VertexId::new(8),
                at: AT,
            },
        ];
        let causes = after(true, &told);
        let of = |v: usize| causes.of(VertexId::new(v));
        let rules = [5, 6, 7].map(|v| of(v).expect("a cause").rule);
        let expected = [Rule::Size, Rule::RejectedCircumcenter, Rule::Circumcenter];
        assert_eq!(rules, expected);
        assert_eq!(of(7).and_then(Cause::triangle), Some(ids([2, 3, 4])));
        assert!(of(8).is_none());
    }
}
