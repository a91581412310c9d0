//! A classical algorithm at work: every step kept, and any of them shown.
//!
//! A [`Player`] stands between two steps. To go elsewhere takes the steps in between, forwards or backwards, from
//! where it stands or from the nearest of some scenes that it has kept on its way (`tape.rs`).
//!
//! What it tells of the whole run: `ledger.rs` (how much work up to a step), `curve.rs` (numbers that change),
//! `search.rs` (steps to be found). What it tells of a scene beyond its lists: `judging.rs` and
//! [`look`](crate::look).

mod clock;
mod curve;
mod judging;
mod keeper;
mod ledger;
mod marks;
mod named;
mod run;
mod search;
mod seeking;
mod tape;

use crate::drawing::Drawing;
use crate::look::Looker;
use crate::progress::Progress;
use crate::{Trouble, json};
use clock::Times;
use delone::classic::Algorithm;
use delone::{Item, Scene, Step, VertexId};
use delone_io::narration::{Language, narrate};
use delone_io::{Recording, Source, read_log};
use js_sys::Function;
use ledger::Ledger;
use marks::Mark;
use seeking::Kind;
use serde::Serialize;
use tape::Tape;
use wasm_bindgen::prelude::wasm_bindgen;

/// What stands for no vertex in a row of three.
const NONE: u32 = u32::MAX;

/// A run, and a place in it.
#[wasm_bindgen]
pub struct Player {
    recording: Recording,
    tape: Tape,
    ledger: Ledger,
}

/// What there is to say of an algorithm.
#[derive(Serialize)]
struct Description {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    idea: &'static str,
    cost: &'static str,
    guarantees: &'static str,
    takes: &'static str,
    delaunay: bool,
    code: &'static [&'static str],
}

/// The step that has just been taken.
#[derive(Serialize)]
struct Current<'a> {
    line: u16,
    kind: Kind,
    event: &'a delone::Event,
    marks: Vec<Mark>,
}

#[wasm_bindgen]
impl Player {
    /// Lists the algorithms, as JSON: `[{name, title, source, idea, cost, guarantees, takes, delaunay, code}]`;
    /// `takes` is `"points"`, `"triangulation"`, `"domain"` or `"data"`.
    pub fn algorithms() -> String {
        let all = Algorithm::ALL.iter().map(|a| run::describe(a.about()));
        json::write(&all.collect::<Vec<_>>())
    }

    /// Runs an algorithm on a drawing, and stands before its first step. Segments are left aside by algorithms
    /// that take points alone.
    ///
    /// `options` is JSON: `{seed, minAngle, maxEdge, dataPerTriangle, domain}`: for random orders; bounds for
    /// `thesis` and `refinement`; for algorithms that cover data; `"hull"`, `"carve"` or `"evenodd"`.
    ///
    /// `progress` is called with `("recording", steps, 0)` now and then, for nobody knows how many there will be;
    /// the run stops, with an error, once it returns `false`.
    pub fn run(
        algorithm: &str,
        drawing: &Drawing,
        options: Option<String>,
        progress: Option<Function>,
    ) -> Result<Self, Trouble> {
        let options = json::options(options.as_deref())?;
        let progress = Progress::told_to(progress);
        let listener = |steps| progress.tell("recording", steps as u64, 0);
        let (recording, times) = run::record(algorithm, drawing, &options, &listener)?;
        Ok(Self::of(recording, Some(times)))
    }

    /// Reads a run from the bytes of a log file, `.json` or `.dlog`.
    #[wasm_bindgen(js_name = fromLog)]
    pub fn from_log(name: &str, bytes: &[u8]) -> Result<Self, Trouble> {
        let source = Source::Memory {
            name: name.to_owned(),
            bytes: bytes.to_vec(),
        };
        Ok(Self::of(read_log(&source, &())?, None))
    }

    /// Returns the name of the algorithm.
    #[wasm_bindgen(getter)]
    pub fn algorithm(&self) -> String {
        self.recording.log.algorithm.clone()
    }

    /// Returns what people call the algorithm.
    #[wasm_bindgen(getter)]
    pub fn title(&self) -> String {
        self.recording.title.clone()
    }

    /// Returns the lines of the pseudocode, as JSON: an array of strings, indented by two spaces a level.
    pub fn code(&self) -> String {
        json::write(&self.recording.code)
    }

    /// Counts the steps.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> u32 {
        self.steps().len() as u32
    }

    /// Tells how many steps have been taken.
    #[wasm_bindgen(getter)]
    pub fn position(&self) -> u32 {
        self.tape.position() as u32
    }

    /// Goes to where so many steps have been taken; beyond the end, to the end.
    pub fn seek(&mut self, position: u32) -> Result<(), Trouble> {
        Ok(self.tape.seek(&self.recording.log, position as usize)?)
    }

    /// Returns the coordinates of the vertices.
    pub fn points(&self) -> Vec<f64> {
        json::coordinates(self.scene().vertices().map(|(_, p)| p))
    }

    /// Returns the edges, as pairs of vertices.
    pub fn edges(&self) -> Vec<u32> {
        json::indices(self.scene().edges())
    }

    /// Returns for each of the edges whether it is a constraint: 1, or else 0.
    pub fn locked(&self) -> Vec<u8> {
        let edges = self.scene().edges();
        edges
            .map(|edge| self.scene().is_locked(edge).into())
            .collect()
    }

    /// Returns the corners of the triangles, counter-clockwise.
    pub fn triangles(&self) -> Vec<u32> {
        json::indices(self.scene().triangles())
    }

    /// Returns the vertices of the front, in their order.
    pub fn front(&self) -> Vec<u32> {
        self.scene().front().map(|v| v.index() as u32).collect()
    }

    /// Returns where the sweep is, as JSON: `{"vertical": x}`, `{"horizontal": y}`, `{"circle": {center: [x, y],
    /// radius}}` or `null`.
    pub fn sweep(&self) -> String {
        json::write(&self.scene().sweep())
    }

    /// Returns what waits in a queue, three numbers each: a triangle, an edge and 0xFFFFFFFF, or a vertex and that
    /// twice. Queues are `"suspects"`, `"search"`, `"cavity"`, `"events"` and `"crossings"`.
    pub fn waiting(&self, queue: &str) -> Result<Vec<u32>, Trouble> {
        let queue = seeking::queue(queue)?;
        let items = self.scene().queue(queue);
        Ok(items.flat_map(row).collect())
    }

    /// Returns the centers of clusters: three numbers each, its number, x and y.
    pub fn clusters(&self) -> Vec<f64> {
        let clusters = self.scene().clusters();
        clusters.flat_map(|(i, p)| [i.into(), p.x, p.y]).collect()
    }

    /// Returns for each vertex three numbers: the triangle for which it counts as a datum, or 0xFFFFFFFF thrice.
    pub fn holders(&self) -> Vec<u32> {
        let all = self.scene().vertices();
        let holders = all.map(|(v, _)| self.scene().holder(v).map(Item::Triangle));
        holders
            .flat_map(|item| item.map_or([NONE; 3], row))
            .collect()
    }

    /// Makes what finds places in the scene: triangles by their order in `triangles`.
    pub fn looker(&self) -> Looker {
        let scene = self.scene();
        Looker::of(scene.vertices().map(|(_, p)| p), scene.triangles())
    }

    /// Returns the hash of the triangles.
    pub fn hash(&self) -> String {
        self.scene().hash().to_string()
    }

    /// Tells of the step that has just been taken, as JSON: `{line, kind, event, marks}`; `null` at the beginning.
    /// `line` counts from 1, and is 0 for what lays out the beginning. `marks` are what the event is about, each
    /// with a `tone`: `"good"` comes or may stay, `"bad"` goes or must, `"asked"` is looked at.
    pub fn step(&self) -> String {
        let current = self.last_step().map(|step| Current {
            line: step.line,
            kind: seeking::kind(&step.event),
            event: &step.event,
            marks: marks::of(step.event, self.scene()),
        });
        json::write(&current)
    }

    /// Returns the running line of the pseudocode, from 1; 0 if there is none.
    #[wasm_bindgen(getter)]
    pub fn line(&self) -> u16 {
        self.last_step().map_or(0, |step| step.line)
    }

    /// Says in a sentence what has just been done, in `"en"` or `"de"`.
    pub fn narration(&self, language: &str) -> Result<String, Trouble> {
        let language: Language = language.parse().map_err(Trouble::Asked)?;
        let step = self.last_step();
        Ok(step.map_or_else(String::new, |step| narrate(step.event, language)))
    }
}

impl Player {
    fn of(recording: Recording, times: Option<Times>) -> Self {
        Self {
            tape: Tape::new(&recording.log),
            ledger: Ledger::new(&recording.log, times),
            recording,
        }
    }

    /// Returns the run.
    pub(crate) fn recording(&self) -> &Recording {
        &self.recording
    }

    fn steps(&self) -> &[Step] {
        &self.recording.log.steps
    }

    fn scene(&self) -> &Scene {
        self.tape.scene()
    }

    fn last_step(&self) -> Option<&Step> {
        let last = self.tape.position().checked_sub(1)?;
        self.steps().get(last)
    }
}

/// Writes what waits as three numbers.
fn row(item: Item) -> [u32; 3] {
    let number = |v: VertexId| v.index() as u32;
    match item {
        Item::Vertex(v) => [number(v), NONE, NONE],
        Item::Edge([a, b]) => [number(a), number(b), NONE],
        Item::Triangle(corners) => corners.map(number),
    }
}

#[cfg(test)]
mod tests;
