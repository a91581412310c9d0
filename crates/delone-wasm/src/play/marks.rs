//! What a step is about, to be drawn upon the scene after it.

use delone::predicates::Orientation;
use delone::{Cut, Event, Failure, Item, Point, Scene, VertexId};
use serde::Serialize;

/// What a mark says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Tone {
    /// Comes, or may stay.
    Good,
    /// Goes, or must go.
    Bad,
    /// Is looked at, or has its turn.
    Asked,
}

/// Something to be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase", tag = "shape")]
pub(super) enum Mark {
    Vertex {
        tone: Tone,
        vertex: VertexId,
    },
    Edge {
        tone: Tone,
        edge: [VertexId; 2],
    },
    Triangle {
        tone: Tone,
        triangle: [VertexId; 3],
    },
    Circle {
        tone: Tone,
        center: Point,
        radius: f64,
    },
    Place {
        tone: Tone,
        at: Point,
    },
    Cut {
        tone: Tone,
        cut: Cut,
    },
}

use Tone::{Asked, Bad, Good};

/// Lists the marks of an event, in the scene after it.
pub(super) fn of(event: Event, scene: &Scene) -> Vec<Mark> {
    let mut sheet = Sheet {
        scene,
        marks: Vec::new(),
    };
    sheet.add_change(event);
    sheet.marks
}

struct Sheet<'s> {
    scene: &'s Scene,
    marks: Vec<Mark>,
}

impl Sheet<'_> {
    fn add_change(&mut self, event: Event) {
        match event {
            Event::VertexCreated { at, .. } => self.place(Good, at),
            Event::VertexDeleted { at, .. } => self.place(Bad, at),
            Event::VertexMoved { from, to, .. } => {
                self.place(Bad, from);
                self.place(Good, to);
            }
            Event::EdgeCreated { edge } | Event::EdgeLocked { edge } => self.edge(Good, edge),
            Event::EdgeDeleted { edge } | Event::EdgeUnlocked { edge } => self.edge(Bad, edge),
            Event::TriangleCreated { triangle } => self.triangle(Good, triangle),
            Event::TriangleDeleted { triangle } => self.triangle(Bad, triangle),
            Event::EdgeFlipped { from, to } => {
                self.edge(Bad, from);
                self.edge(Good, to);
            }
            Event::FrontEntered { vertex, .. } => self.vertex(Good, vertex),
            Event::FrontLeft { vertex, .. } => self.vertex(Bad, vertex),
            Event::Pushed { item, .. } => self.item(Good, item),
            Event::Popped { item, .. } => self.item(Asked, item),
            Event::DatumReassigned { datum, from, to } => {
                self.vertex(Asked, datum);
                from.into_iter().for_each(|t| self.triangle(Bad, t));
                to.into_iter().for_each(|t| self.triangle(Good, t));
            }
            Event::ClusterMoved { from, to, .. } => {
                from.into_iter().for_each(|at| self.place(Bad, at));
                to.into_iter().for_each(|at| self.place(Good, at));
            }
            _ => self.add_look(event),
        }
    }

    fn add_look(&mut self, event: Event) {
        match event {
            Event::PointConsidered { vertex } => self.vertex(Asked, vertex),
            Event::SegmentConsidered { segment: edge }
            | Event::EdgeExamined { edge }
            | Event::WalkStepped { edge } => self.edge(Asked, edge),
            Event::TriangleConsidered { triangle } | Event::TriangleVisited { triangle } => {
                self.triangle(Asked, triangle);
            }
            Event::PointLocated { vertex, at } => {
                self.vertex(Good, vertex);
                at.into_iter().for_each(|item| self.item(Good, item));
            }
            Event::RayCast { ray, is_visible } => self.edge(good(is_visible), ray),
            Event::OrientationTested {
                line,
                point,
                answer,
            } => {
                let tone = match answer {
                    Orientation::Left => Good,
                    Orientation::Right => Bad,
                    Orientation::Collinear => Asked,
                };
                self.edge(tone, line);
                self.vertex(tone, point);
            }
            Event::CircleTested {
                triangle,
                point,
                is_inside,
                ..
            } => {
                self.triangle(good(!is_inside), triangle);
                self.circle(good(!is_inside), triangle);
                self.vertex(good(!is_inside), point);
            }
            Event::InsideTested {
                triangle,
                is_inside,
                ..
            } => {
                self.triangle(good(is_inside), triangle);
            }
            Event::SetDivided { cut } | Event::ClusterSplit { cut, .. } => {
                self.marks.push(Mark::Cut { tone: Asked, cut });
            }
            Event::TangentFound { edge } => self.edge(Good, edge),
            _ => self.add_judgement(event),
        }
    }

    fn add_judgement(&mut self, event: Event) {
        match event {
            Event::Encroached { segment, by } => {
                self.edge(Bad, segment);
                self.vertex(Bad, by);
                self.diametral(segment);
            }
            Event::SegmentSplit { edge, vertex } => {
                self.edge(Asked, edge);
                self.vertex(Asked, vertex);
            }
            Event::CircumcenterProposed { triangle, at } => {
                self.triangle(Asked, triangle);
                self.circle(Asked, triangle);
                self.place(Good, at);
            }
            Event::CircumcenterRejected { triangle, edge } => {
                self.triangle(Bad, triangle);
                self.edge(Bad, edge);
            }
            Event::CoverRejected { triangle, .. } | Event::DivisionFailed { triangle } => {
                self.triangle(Bad, triangle);
            }
            Event::OuterReduced { edge: Some(edge) } => self.edge(Asked, edge),
            Event::PlaceTried { at, .. } => self.place(Asked, at),
            Event::TakenBack { from } => self.vertex(Bad, from),
            Event::PrintFailed { failure } => match failure {
                Failure::SeesNothing(v) | Failure::SeesOne(v) | Failure::SeesSeveralRuns(v) => {
                    self.vertex(Bad, v);
                }
                Failure::SegmentLost(segment) => self.edge(Bad, segment),
                Failure::Overlaps(triangle) => self.triangle(Bad, triangle),
                _ => {}
            },
            _ => {}
        }
    }

    fn vertex(&mut self, tone: Tone, vertex: VertexId) {
        self.marks.push(Mark::Vertex { tone, vertex });
    }

    fn edge(&mut self, tone: Tone, edge: [VertexId; 2]) {
        self.marks.push(Mark::Edge { tone, edge });
    }

    fn triangle(&mut self, tone: Tone, triangle: [VertexId; 3]) {
        self.marks.push(Mark::Triangle { tone, triangle });
    }

    fn place(&mut self, tone: Tone, at: Point) {
        self.marks.push(Mark::Place { tone, at });
    }

    fn item(&mut self, tone: Tone, item: Item) {
        match item {
            Item::Vertex(v) => self.vertex(tone, v),
            Item::Edge(edge) => self.edge(tone, edge),
            Item::Triangle(triangle) => self.triangle(tone, triangle),
        }
    }

    fn circle(&mut self, tone: Tone, triangle: [VertexId; 3]) {
        if let Some((center, radius)) = self.scene.circle(triangle) {
            self.marks.push(Mark::Circle {
                tone,
                center,
                radius,
            });
        }
    }

    /// The circle through the ends of a segment, about its middle.
    fn diametral(&mut self, segment: [VertexId; 2]) {
        let [Some(a), Some(b)] = segment.map(|v| self.scene.point(v)) else {
            return;
        };
        self.marks.push(Mark::Circle {
            tone: Bad,
            center: Point::new(a.x.midpoint(b.x), a.y.midpoint(b.y)),
            radius: (a.x - b.x).hypot(a.y - b.y) / 2.0,
        });
    }
}

fn good(is_good: bool) -> Tone {
    if is_good { Good } else { Bad }
}
