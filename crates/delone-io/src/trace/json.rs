//! `.json`: a log as text.
//!
//! One object, laid out so that every line of pseudocode, every point and every step has a line of its
//! own: so an error that names a line names a step. A circle test carries its circle, `[x, y, radius]`,
//! for whoever draws it without this library; it is not read back.

use super::{Recording, VERSION};
use crate::target::Output;
use crate::{Error, Place, Problem};
use delone::predicates::circumcenter;
use delone::{Event, Log, Point, Step};
use serde::{Deserialize, Serialize};

/// What tells these files from other JSON.
const FORMAT: &str = "delone-log";

/// Bytes in which a log says that it is one.
const HEAD: usize = 4096;

/// Tells whether JSON says near its beginning that it is a log.
pub(super) fn sniff(head: &[u8]) -> bool {
    let head = &head[..head.len().min(HEAD)];
    memchr::memmem::find(head, FORMAT.as_bytes()).is_some()
}

/// A step as it stands in the file.
#[derive(Serialize)]
struct Row<'a> {
    line: u16,
    #[serde(flatten)]
    event: &'a Event,
    #[serde(skip_serializing_if = "Option::is_none")]
    circle: Option<[f64; 3]>,
}

/// A step that is read: of the circle nothing is kept.
#[derive(Deserialize)]
struct ReadRow {
    line: u16,
    #[serde(flatten)]
    event: Event,
}

/// What is looked at before all else.
#[derive(Deserialize)]
struct Head {
    format: String,
    version: u64,
}

#[derive(Deserialize)]
struct Body {
    algorithm: String,
    title: String,
    source: String,
    code: Vec<String>,
    points: Vec<Point>,
    steps: Vec<ReadRow>,
}

/// Writes a log.
pub(super) fn write(out: &mut Output<'_>, recording: &Recording) -> Result<(), Error> {
    let Recording {
        title,
        source,
        code,
        log,
    } = recording;
    out.text(format_args!(
        "{{\"format\":\"{FORMAT}\",\"version\":{VERSION},\n\"algorithm\":"
    ))?;
    put(out, &log.algorithm)?;
    for (key, value) in [("title", title), ("source", source)] {
        out.text(format_args!(",\n\"{key}\":"))?;
        put(out, value)?;
    }
    let file = out.file().to_owned();
    write_rows(out, "code", code.iter(), |out, line| put(out, line))?;
    write_rows(out, "points", log.points.iter().enumerate(), |out, row| {
        let (i, p) = row;
        if !p.is_finite() {
            return Err(not_finite(&file, format!("point {i}")));
        }
        put(out, p)
    })?;
    let mut places = Places(log.points.clone());
    write_rows(out, "steps", log.steps.iter().enumerate(), |out, row| {
        let (i, step) = row;
        places.learn(step.event);
        out.end_row()?;
        put_step(out, &file, i, step, &places)
    })?;
    out.text(format_args!("}}\n"))
}

/// Writes an array, each element on a line.
fn write_rows<'o, T>(
    out: &mut Output<'o>,
    key: &str,
    rows: impl Iterator<Item = T>,
    mut put: impl FnMut(&mut Output<'o>, T) -> Result<(), Error>,
) -> Result<(), Error> {
    out.text(format_args!(",\n\"{key}\":["))?;
    for (i, row) in rows.enumerate() {
        out.bytes(if i == 0 { b"\n" } else { b",\n" })?;
        put(out, row)?;
    }
    out.bytes(b"\n]")
}

fn put(out: &mut Output<'_>, value: &impl Serialize) -> Result<(), Error> {
    let text = serde_json::to_vec(value).expect("bug: words and numbers can be written");
    out.bytes(&text)
}

fn put_step(
    out: &mut Output<'_>,
    file: &str,
    i: usize,
    step: &Step,
    places: &Places,
) -> Result<(), Error> {
    let &Step { line, ref event } = step;
    let circle = places.circle(step.event);
    let row = Row {
        line,
        event,
        circle,
    };
    let text = serde_json::to_vec(&row).expect("bug: words and numbers can be written");
    // What is not finite becomes `null`, as does what is absent: only reading tells them apart.
    if memchr::memmem::find(&text, b"null").is_some() && reread(&text) != Some(*step) {
        return Err(not_finite(file, format!("step {i}")));
    }
    out.bytes(&text)
}

fn reread(text: &[u8]) -> Option<Step> {
    let row: ReadRow = serde_json::from_slice(text).ok()?;
    Some(row.into())
}

fn not_finite(file: &str, what: String) -> Error {
    Error::Malformed {
        file: file.to_owned(),
        place: Place::File,
        problem: Problem::Other(format!(
            "{what} holds a number that is not finite, for which JSON has no word; write a .dlog"
        )),
    }
}

/// Where vertices lie, as far as steps have told.
struct Places(Vec<Point>);

impl Places {
    fn learn(&mut self, event: Event) {
        if let Event::VertexMoved { vertex, to, .. } = event
            && let Some(place) = self.0.get_mut(vertex.index())
        {
            *place = to;
        }
        if let Event::VertexCreated { vertex, at } = event {
            // Others than the next number that is free no algorithm gives.
            if vertex.index() == self.0.len() {
                self.0.push(at);
            } else if let Some(place) = self.0.get_mut(vertex.index()) {
                *place = at;
            }
        }
    }

    /// Returns center and radius of the circle that a step tests, if it can be told.
    fn circle(&self, event: Event) -> Option<[f64; 3]> {
        let Event::CircleTested { triangle, .. } = event else {
            return None;
        };
        let [a, b, c] = triangle.map(|v| self.0.get(v.index()).copied());
        let (a, b, c) = (a?, b?, c?);
        let center = circumcenter(a, b, c)?;
        let radius = (a.x - center.x).hypot(a.y - center.y);
        let circle = [center.x, center.y, radius];
        circle.iter().all(|v| v.is_finite()).then_some(circle)
    }
}

/// Reads a log.
pub(super) fn read(text: &[u8], file: &str) -> Result<Recording, Error> {
    let head: Head = serde_json::from_slice(text).map_err(|e| malformed(file, &e))?;
    let refuse = |problem| Error::Malformed {
        file: file.to_owned(),
        place: Place::File,
        problem: Problem::Other(problem),
    };
    if head.format != FORMAT {
        return Err(refuse(format!(
            "format is {:?}, expected {FORMAT:?}",
            head.format
        )));
    }
    if head.version != u64::from(VERSION) {
        return Err(refuse(super::binary::other_version(head.version)));
    }
    let body: Body = serde_json::from_slice(text).map_err(|e| malformed(file, &e))?;
    Ok(Recording {
        title: body.title,
        source: body.source,
        code: body.code,
        log: Log {
            algorithm: body.algorithm,
            points: body.points,
            steps: body.steps.into_iter().map(Step::from).collect(),
        },
    })
}

impl From<ReadRow> for Step {
    fn from(ReadRow { line, event }: ReadRow) -> Self {
        Self { line, event }
    }
}

fn malformed(file: &str, error: &serde_json::Error) -> Error {
    let message = error.to_string();
    // The place is told by ourselves.
    let end = message.rfind(" at line ").unwrap_or(message.len());
    let message = match &message[..end] {
        "no variant of enum Event found in flattened data" => {
            "the step names no event that is known"
        }
        other => other,
    };
    Error::Malformed {
        file: file.to_owned(),
        place: Place::Column(error.line() as u64, error.column() as u64),
        problem: Problem::Other(message.to_owned()),
    }
}
