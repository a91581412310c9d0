//! What a frame shows of the step that has just been taken, and of nothing else.

use super::mark::{Look, Mark, Tone};
use super::pen::Pen;
use delone::predicates::{CircleSide, Orientation};
use delone::{Event, Failure, Item, Point, Scene, VertexId};

/// Draws what a step is about.
pub(super) struct Highlight<'a> {
    pub pen: &'a Pen,
    pub scene: &'a Scene,
    pub marks: Vec<Mark>,
}

impl Highlight<'_> {
    /// Adds the marks of an event, in the scene after it.
    pub fn add(&mut self, event: Event) {
        match event {
            Event::VertexCreated { at, .. } => self.ring_at(Tone::Good, at),
            Event::VertexDeleted { at, .. } => self.ring_at(Tone::Bad, at),
            Event::VertexMoved { from, to, .. } => self.way(Some(from), Some(to)),
            Event::EdgeCreated { edge } => self.line(Look::Trace(Tone::Good), edge),
            Event::EdgeDeleted { edge } => self.line(Look::Dashed(Tone::Bad), edge),
            Event::EdgeLocked { edge } | Event::TangentFound { edge } => {
                self.line(Look::Trace(Tone::Good), edge);
            }
            Event::EdgeUnlocked { edge } => self.line(Look::Trace(Tone::Bad), edge),
            Event::TriangleCreated { triangle } => self.triangle(Tone::Good, triangle),
            Event::TriangleDeleted { triangle } => self.triangle(Tone::Bad, triangle),
            Event::EdgeFlipped { from, to } => self.flip(from, to),
            Event::FrontEntered { vertex, .. } => self.ring(Tone::Good, vertex),
            Event::FrontLeft { vertex, .. } => self.ring(Tone::Bad, vertex),
            Event::Pushed { item, .. } => self.item(Tone::Good, item),
            Event::Popped { item, .. } => self.item(Tone::Asked, item),
            Event::DatumReassigned { datum, from, to } => {
                self.ring(Tone::Asked, datum);
                let of = |tone, t: Option<_>| t.map(|t| (tone, t));
                for (tone, t) in [of(Tone::Bad, from), of(Tone::Good, to)]
                    .into_iter()
                    .flatten()
                {
                    self.triangle(tone, t);
                }
            }
            Event::ClusterMoved { from, to, .. } => self.way(from, to),
            _ => self.add_look(event),
        }
    }

    /// Adds the marks of an event that changes nothing.
    fn add_look(&mut self, event: Event) {
        match event {
            Event::EdgeExamined { edge } | Event::WalkStepped { edge } => {
                self.line(Look::Trace(Tone::Asked), edge);
            }
            Event::TriangleVisited { triangle } => self.triangle(Tone::Asked, triangle),
            Event::PointLocated { vertex, at } => {
                self.ring(Tone::Good, vertex);
                at.into_iter().for_each(|item| self.item(Tone::Good, item));
            }
            Event::RayCast { ray, is_visible } => {
                self.line(Look::Dashed(good(is_visible)), ray);
            }
            Event::OrientationTested {
                line,
                point,
                answer,
            } => self.orientation(line, point, answer),
            Event::CircleTested {
                triangle,
                point,
                answer,
                is_inside,
            } => self.circle_test(triangle, point, answer, is_inside),
            Event::InsideTested {
                triangle,
                is_inside,
                ..
            } => self.triangle(good(is_inside), triangle),
            Event::SetDivided { cut } | Event::ClusterSplit { cut, .. } => {
                let mark = self.pen.cut(Look::Trace(Tone::Asked), cut);
                self.marks.push(mark);
            }
            Event::Encroached { segment, by } => {
                self.line(Look::Trace(Tone::Bad), segment);
                self.ring(Tone::Bad, by);
                if let Some(ends) = self.points(segment) {
                    let circle = self.pen.diametral(Look::Ring(Tone::Bad), ends);
                    self.marks.push(circle);
                }
            }
            Event::SegmentSplit { edge, vertex } => {
                self.line(Look::Trace(Tone::Asked), edge);
                self.ring(Tone::Asked, vertex);
            }
            Event::CircumcenterProposed { triangle, at } => {
                self.triangle(Tone::Asked, triangle);
                self.circle(Look::Ring(Tone::Asked), triangle);
                if self.pen.view.holds(at) {
                    self.ring_at(Tone::Good, at);
                }
            }
            Event::CircumcenterRejected { triangle, edge } => {
                self.triangle(Tone::Bad, triangle);
                self.line(Look::Trace(Tone::Bad), edge);
            }
            Event::CoverRejected { triangle, data } => {
                self.triangle(Tone::Bad, triangle);
                self.counts(triangle, &[data]);
            }
            Event::OuterReduced { edge: Some(edge) } => self.line(Look::Trace(Tone::Bad), edge),
            Event::PlaceTried { at, counts } => self.place(at, counts),
            Event::DivisionFailed { triangle } => self.triangle(Tone::Bad, triangle),
            Event::PrintFailed { failure } => self.failure(failure),
            Event::TakenBack { from } => self.ring(Tone::Bad, from),
            _ => {}
        }
    }

    fn points<const N: usize>(&self, corners: [VertexId; N]) -> Option<[Point; N]> {
        let points = corners.map(|v| self.scene.point(v));
        points
            .iter()
            .all(Option::is_some)
            .then(|| points.map(|p| p.expect("bug: just seen")))
    }

    fn line(&mut self, look: Look, ends: [VertexId; 2]) {
        if let Some(ends) = self.points(ends) {
            self.marks.push(self.pen.line(look, ends));
        }
    }

    fn triangle(&mut self, tone: Tone, corners: [VertexId; 3]) {
        if let Some(corners) = self.points(corners) {
            self.marks
                .push(self.pen.triangle(Look::Face(tone), corners));
        }
    }

    fn circle(&mut self, look: Look, corners: [VertexId; 3]) {
        let corners = self.points(corners);
        let circle = corners.and_then(|corners| self.pen.circle(look, corners));
        self.marks.extend(circle);
    }

    fn ring(&mut self, tone: Tone, v: VertexId) {
        if let Some(p) = self.scene.point(v) {
            self.ring_at(tone, p);
        }
    }

    fn ring_at(&mut self, tone: Tone, p: Point) {
        self.marks.push(self.pen.ring(Look::Ring(tone), p));
    }

    fn item(&mut self, tone: Tone, item: Item) {
        match item {
            Item::Vertex(v) => self.ring(tone, v),
            Item::Edge(edge) => self.line(Look::Trace(tone), edge),
            Item::Triangle(triangle) => self.triangle(tone, triangle),
        }
    }

    fn flip(&mut self, from: [VertexId; 2], to: [VertexId; 2]) {
        let (Some(from), Some(to)) = (self.points(from), self.points(to)) else {
            return;
        };
        let quad = [[from[0], to[0], to[1]], [from[1], to[0], to[1]]];
        for half in quad {
            let mark = self.pen.triangle(Look::Face(Tone::Good), half);
            self.marks.push(mark);
        }
        self.marks
            .push(self.pen.line(Look::Dashed(Tone::Bad), from));
        let turn = self.pen.turn(Look::Trace(Tone::Good), from, to);
        self.marks.push(turn);
    }

    fn way(&mut self, from: Option<Point>, to: Option<Point>) {
        if let (Some(from), Some(to)) = (from, to) {
            let line = self.pen.line(Look::Dashed(Tone::Asked), [from, to]);
            self.marks.push(line);
        }
        if let Some(at) = to.or(from) {
            self.ring_at(Tone::Asked, at);
        }
    }

    /// A place that is tried, and how many data the new triangles would hold there.
    fn place(&mut self, at: Point, counts: [u32; 4]) {
        // Beyond the last triangle there are zeros.
        let number = counts.iter().rposition(|&count| count > 0);
        let held = &counts[..number.map_or(0, |last| last + 1)];
        if self.pen.view.holds(at) {
            self.ring_at(Tone::Asked, at);
            self.marks.extend(self.pen.numbers(at, held));
        }
    }

    /// Numbers in the middle of a triangle.
    fn counts(&mut self, corners: [VertexId; 3], numbers: &[u32]) {
        if let Some([a, b, c]) = self.points(corners) {
            // Divided first, so that no sum overflows.
            let mean = |a: f64, b: f64, c: f64| a / 3.0 + b / 3.0 + c / 3.0;
            let middle = Point::new(mean(a.x, b.x, c.x), mean(a.y, b.y, c.y));
            self.marks.extend(self.pen.numbers(middle, numbers));
        }
    }

    fn orientation(&mut self, line: [VertexId; 2], point: VertexId, answer: Orientation) {
        let tone = match answer {
            Orientation::Left => Tone::Good,
            Orientation::Right => Tone::Bad,
            Orientation::Collinear => Tone::Asked,
        };
        self.triangle(tone, [line[0], line[1], point]);
        self.line(Look::Trace(tone), line);
        self.ring(tone, point);
    }

    fn circle_test(
        &mut self,
        triangle: [VertexId; 3],
        point: VertexId,
        answer: CircleSide,
        is_inside: bool,
    ) {
        let tone = good(!is_inside);
        self.triangle(tone, triangle);
        let look = match answer {
            CircleSide::On => Look::Dashed(tone),
            _ => Look::Ring(tone),
        };
        self.circle(look, triangle);
        self.ring(tone, point);
    }

    fn failure(&mut self, failure: Failure) {
        match failure {
            Failure::SeesNothing(v) | Failure::SeesOne(v) | Failure::SeesSeveralRuns(v) => {
                self.ring(Tone::Bad, v);
            }
            Failure::SegmentLost(segment) => self.line(Look::Dashed(Tone::Bad), segment),
            _ => {}
        }
    }
}

fn good(is_good: bool) -> Tone {
    if is_good { Tone::Good } else { Tone::Bad }
}
