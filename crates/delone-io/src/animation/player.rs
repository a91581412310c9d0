//! Plays a log on a [`Scene`], and keeps the marks of what there is.
//!
//! Marks are added and taken away as steps come, so a frame costs what has changed since the one before.
//! What belongs to the current step alone is taken away with the next frame.

use super::beach;
use super::frames::Frame;
use super::highlight::Highlight;
use super::mark::{CLASSES, Look, Mark, Tone};
use super::panel::{Caption, Panel};
use super::pen::Pen;
use super::words::words;
use crate::picture::smallest_angle;
use crate::{Error, Recording, cancel};
use delone::{
    Event, Item, Log, Observer, Phase, Point, Queue, Scene, Step, Sweep, Tally, VertexId, Watch,
};
use std::collections::BTreeMap;

/// All marks, each as often as it is there, and which have changed.
#[derive(Default)]
pub(super) struct Marks {
    there: BTreeMap<Mark, u32>,
    /// Marks that have come or gone, if anybody wants to know.
    pub changed: Option<Vec<Mark>>,
}

impl Marks {
    pub fn add(&mut self, mark: Mark) {
        if let Some(changed) = &mut self.changed {
            changed.push(mark.clone());
        }
        *self.there.entry(mark).or_default() += 1;
    }

    pub fn remove(&mut self, mark: Mark) {
        if let Some(times) = self.there.get_mut(&mark) {
            *times -= 1;
            if *times == 0 {
                self.there.remove(&mark);
            }
        }
        if let Some(changed) = &mut self.changed {
            changed.push(mark);
        }
    }

    pub fn has(&self, mark: &Mark) -> bool {
        self.there.contains_key(mark)
    }

    /// Visits the marks in the order in which they are drawn.
    pub fn iter(&self) -> impl Iterator<Item = &Mark> {
        self.there.keys()
    }
}

/// A log being played.
pub(super) struct Player<'a> {
    file: &'a str,
    log: &'a Log,
    watch: &'a dyn Watch,
    pub pen: &'a Pen,
    panel: Option<&'a Panel>,
    scene: Scene,
    tally: Tally,
    played: usize,
    /// The step that the current frame is about.
    step: Option<Step>,
    pub marks: Marks,
    /// What only the current frame shows.
    passing: Vec<Mark>,
    /// Whose turn it is, and where its walk has come by.
    turn: Vec<Mark>,
}

impl<'a> Player<'a> {
    /// Begins before the first step; `file` is named in errors.
    pub fn new(
        file: &'a str,
        recording: &'a Recording,
        pen: &'a Pen,
        panel: Option<&'a Panel>,
        watch: &'a dyn Watch,
    ) -> Self {
        let log = &recording.log;
        let mut marks = Marks::default();
        for &p in &log.points {
            marks.add(pen.dot(Look::Vertex, p));
        }
        if let Some(panel) = panel {
            panel.fixed().into_iter().for_each(|mark| marks.add(mark));
        }
        Self {
            file,
            log,
            watch,
            pen,
            panel,
            scene: log.first_scene(),
            tally: Tally::default(),
            played: 0,
            step: None,
            marks,
            passing: Vec::new(),
            turn: Vec::new(),
        }
    }

    /// Plays until so many steps are played, and shows what the last one did; in the result, nothing of it,
    /// and nobody's turn.
    ///
    /// # Errors
    /// If a step does not fit those before it, or the watch cancels.
    pub fn advance(&mut self, Frame { end, is_result }: Frame) -> Result<(), Error> {
        for mark in std::mem::take(&mut self.passing) {
            self.marks.remove(mark);
        }
        let steps = &self.log.steps[self.played..end];
        for &step in steps {
            self.play(step)?;
        }
        let step = steps.last().copied();
        self.step = step.filter(|step| step.line != 0 && !is_result);
        if is_result {
            self.end_turn();
        }
        let steps = self.log.steps.len() as u64;
        self.watch.progress(Phase::Draw, end as u64, steps);
        self.passing = self.current();
        for mark in &self.passing {
            self.marks.add(mark.clone());
        }
        Ok(())
    }

    /// Returns what is said of the current frame: the line that runs, and what it does.
    pub fn caption(&self) -> Caption {
        let is_done = self.played > 0 && self.played == self.log.steps.len();
        let end = if is_done { "done" } else { "" };
        Caption {
            line: self.step.map_or(0, |step| step.line.into()),
            words: self.step.map_or(end, |step| words(step.event)),
            played: self.played,
            tally: self.tally,
        }
    }

    fn play(&mut self, step: Step) -> Result<(), Error> {
        cancel::check(self.watch, self.played)?;
        let before = self.affected(step.event);
        let fits = self.scene.apply(step.event);
        fits.map_err(|why| Error::Picture {
            file: self.file.to_owned(),
            reason: format!("step {} of the log: {why}", self.played),
        })?;
        for mark in before {
            self.marks.remove(mark);
        }
        for mark in self.affected(reversed(step.event)) {
            self.marks.add(mark);
        }
        self.follow(step.event);
        self.tally.observe(step);
        self.played += 1;
        Ok(())
    }

    /// Lists the marks that an event takes away, in the scene before it.
    fn affected(&self, event: Event) -> Vec<Mark> {
        let mut marks = Vec::new();
        match event {
            Event::VertexDeleted { vertex, at } => marks.push(self.dot(vertex, at)),
            Event::VertexMoved { vertex, from, .. } => marks.push(self.dot(vertex, from)),
            Event::EdgeDeleted { edge } => marks.extend(self.line(Look::Edge, edge)),
            Event::EdgeUnlocked { edge } => marks.extend(self.line(Look::Segment, edge)),
            Event::TriangleDeleted { triangle } => marks.extend(self.face(triangle)),
            Event::EdgeFlipped { from: [a, b], .. } => {
                for edge in [[a, b], [b, a]] {
                    let apex = self.scene.apex(edge);
                    marks.extend(apex.and_then(|c| self.face([edge[0], edge[1], c])));
                }
                marks.extend(self.line(Look::Edge, [a, b]));
            }
            Event::Popped { queue, item } => marks.extend(self.waiting(queue, item)),
            Event::ClusterMoved {
                from: Some(from), ..
            } => marks.push(self.pen.square(Look::Cluster, from)),
            _ => {}
        }
        marks
    }

    /// Keeps whose turn it is, and where it has come by.
    fn follow(&mut self, event: Event) {
        let marks: Vec<_> = match event {
            Event::PointConsidered { vertex } => {
                let p = self.scene.point(vertex);
                p.into_iter().flat_map(|p| self.pen.considered(p)).collect()
            }
            Event::SegmentConsidered { segment } => {
                let line = self.line(Look::Dashed(Tone::Asked), segment);
                line.into_iter().collect()
            }
            Event::TriangleConsidered { triangle } => {
                let outline = self.triangle(Look::Ring(Tone::Asked), triangle);
                outline.into_iter().collect()
            }
            Event::WalkStepped { edge: [a, b] } => {
                let apex = self.scene.apex([b, a]);
                let entered = apex.and_then(|c| self.triangle(Look::Visited, [b, a, c]));
                return self.keep(entered);
            }
            Event::TriangleVisited { triangle } => {
                let visited = self.triangle(Look::Visited, triangle);
                return self.keep(visited);
            }
            Event::SetDivided { cut } => return self.marks.add(self.pen.cut(Look::Cut, cut)),
            // Clusters come and go, and so does what cuts them.
            Event::ClusterSplit { cut, .. } => vec![self.pen.cut(Look::Cut, cut)],
            Event::StageEnded { .. } => Vec::new(),
            _ => return,
        };
        self.end_turn();
        marks.into_iter().for_each(|mark| self.keep(Some(mark)));
    }

    fn end_turn(&mut self) {
        for mark in std::mem::take(&mut self.turn) {
            self.marks.remove(mark);
        }
    }

    fn keep(&mut self, mark: Option<Mark>) {
        if let Some(mark) = mark {
            self.marks.add(mark.clone());
            self.turn.push(mark);
        }
    }

    /// Lists what only this frame shows.
    fn current(&self) -> Vec<Mark> {
        let mut highlight = Highlight {
            pen: self.pen,
            scene: &self.scene,
            marks: Vec::new(),
        };
        if let Some(step) = self.step {
            highlight.add(step.event);
        }
        let mut marks = highlight.marks;
        marks.extend(self.front());
        marks.extend(self.scene.sweep().map(|sweep| self.pen.sweep(sweep)));
        if let Some(panel) = self.panel {
            marks.extend(panel.changing(&self.caption()));
        }
        marks
    }

    /// The front, from place to place; while a line comes down, the parabolas of which it is made.
    fn front(&self) -> Vec<Mark> {
        let points: Vec<_> = self
            .scene
            .front()
            .filter_map(|v| self.scene.point(v))
            .collect();
        // The result, after the last step, shows the hull instead.
        if let (Some(Sweep::Horizontal(y)), Some(_)) = (self.scene.sweep(), self.step) {
            return beach::marks(self.pen, &points, y);
        }
        let pairs = points.windows(2).filter(|pair| pair[0] != pair[1]);
        pairs
            .map(|pair| self.pen.line(Look::Front, [pair[0], pair[1]]))
            .collect()
    }

    fn dot(&self, v: VertexId, at: Point) -> Mark {
        let look = match v.index() < self.log.points.len() {
            true => Look::Vertex,
            false => Look::Added,
        };
        self.pen.dot(look, at)
    }

    fn line(&self, look: Look, [a, b]: [VertexId; 2]) -> Option<Mark> {
        // The same mark whichever end comes first.
        let ends = [a.min(b), a.max(b)].map(|v| self.scene.point(v));
        Some(self.pen.line(look, [ends[0]?, ends[1]?]))
    }

    /// A triangle of the mesh.
    fn face(&self, corners: [VertexId; 3]) -> Option<Mark> {
        let [a, b, c] = corners.map(|v| self.scene.point(v));
        let normal = [a?, b?, c?].map(|p| self.pen.view.normalized(p));
        let share = smallest_angle(normal) / 60.0;
        let class = (share * f64::from(CLASSES)) as u8;
        self.triangle(Look::Triangle(class.min(CLASSES - 1)), corners)
    }

    fn triangle(&self, look: Look, mut corners: [VertexId; 3]) -> Option<Mark> {
        // The same mark whichever corner comes first.
        let smallest = (0..3).min_by_key(|&k| corners[k])?;
        corners.rotate_left(smallest);
        let [a, b, c] = corners.map(|v| self.scene.point(v));
        Some(self.pen.triangle(look, [a?, b?, c?]))
    }

    /// Something that waits. Of events that a sweep expects, the circles.
    fn waiting(&self, queue: Queue, item: Item) -> Option<Mark> {
        match (queue, item) {
            (Queue::Events, Item::Triangle(triangle)) => {
                let [a, b, c] = triangle.map(|v| self.scene.point(v));
                self.pen.circle(Look::Cut, [a?, b?, c?])
            }
            (_, Item::Triangle(triangle)) => self.triangle(Look::WaitingTriangle, triangle),
            (_, Item::Edge(edge)) => self.line(Look::WaitingEdge, edge),
            (_, Item::Vertex(v)) => {
                let p = self.scene.point(v)?;
                Some(self.pen.ring(Look::WaitingVertex, p))
            }
        }
    }
}

/// Returns the event whose removals are what this one adds.
fn reversed(event: Event) -> Event {
    match event.changes_scene() {
        true => event.reversed(),
        false => event,
    }
}

/// Lists all points that a log ever shows.
pub(super) fn points_of(log: &Log) -> Vec<Point> {
    let created = log.steps.iter().filter_map(|step| match step.event {
        Event::VertexCreated { at, .. } | Event::VertexMoved { to: at, .. } => Some(at),
        _ => None,
    });
    let points = log.points.iter().copied().chain(created);
    points.filter(Point::is_finite).collect()
}
