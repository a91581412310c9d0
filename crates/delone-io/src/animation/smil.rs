//! `.svg`: an animation that plays in a browser, without a script.
//!
//! Every mark is an element, once, with the times at which it is there (SMIL, `animate` of `visibility`);
//! marks that come and go together share one. A program that knows no animation shows the last frame.

use super::frames::Plan;
use super::mark::{Detail, Form, Look, Mark, Spot};
use super::player::{Marks, Player};
use crate::picture::{PAPER, glyphs};
use crate::svg::{push_tenths, write_strokes};
use crate::target::Output;
use crate::{Error, Recording};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Most elements: beyond, no browser plays them smoothly.
const MOST: usize = 200_000;

/// The first frame that shows something, and the first that does not any more.
type Span = [u32; 2];

/// When marks are there.
#[derive(Default)]
struct Timeline {
    spans: BTreeMap<Mark, Vec<Span>>,
}

impl Timeline {
    /// Notes what has changed in a frame.
    fn note(&mut self, marks: &mut Marks, frame: u32) {
        let changed = marks.changed.replace(Vec::new()).unwrap_or_default();
        for mark in changed {
            if marks.has(&mark) {
                self.begin(mark, frame);
            } else {
                self.end(&mark, frame);
            }
        }
    }

    fn begin(&mut self, mark: Mark, frame: u32) {
        let spans = self.spans.entry(mark).or_default();
        match spans.last_mut() {
            Some(span) if span[1] == u32::MAX => {}
            _ => spans.push([frame, u32::MAX]),
        }
    }

    fn end(&mut self, mark: &Mark, frame: u32) {
        if let Some(span) = self.spans.get_mut(mark).and_then(|spans| spans.last_mut())
            && span[1] == u32::MAX
        {
            span[1] = frame;
        }
    }
}

/// Writes an animation.
pub(super) fn write(
    out: &mut Output<'_>,
    recording: &Recording,
    mut player: Player<'_>,
    plan: &Plan,
) -> Result<(), Error> {
    let timeline = film(out.file(), &mut player, plan)?;
    let [width, height] = player.pen.view.page;
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        quick_xml::escape::escape(recording.title.as_str()),
        PAPER.hex()
    ))?;
    let clock = Clock { plan };
    let all: Vec<_> = timeline.spans.iter().collect();
    for alike in all.chunk_by(|a, b| a.0.look == b.0.look) {
        write_alike(out, alike, player.pen.detail, &clock)?;
    }
    out.text(format_args!("</svg>\n"))
}

/// Plays all frames, and keeps when which marks are there.
fn film(file: &str, player: &mut Player<'_>, plan: &Plan) -> Result<Timeline, Error> {
    let mut timeline = Timeline::default();
    player.marks.changed = Some(player.marks.iter().cloned().collect());
    for (number, frame) in plan.frames().enumerate() {
        player.advance(frame)?;
        timeline.note(&mut player.marks, number as u32);
        if timeline.spans.len() > MOST {
            return Err(Error::Picture {
                file: file.to_owned(),
                reason: format!(
                    "more than {MOST} elements would move; write a GIF, or show fewer frames"
                ),
            });
        }
    }
    Ok(timeline)
}

/// Writes the marks of one look.
fn write_alike(
    out: &mut Output<'_>,
    marks: &[(&Mark, &Vec<Span>)],
    detail: Detail,
    clock: &Clock<'_>,
) -> Result<(), Error> {
    let look = marks[0].0.look;
    open_group(out, look, detail)?;
    let mut together: BTreeMap<&[Span], Vec<&Form>> = BTreeMap::new();
    for (mark, spans) in marks {
        match &mark.form {
            Form::Turn(turn) => {
                for &span in *spans {
                    write_turn(out, *turn, span, clock)?;
                }
            }
            form => together.entry(&spans[..]).or_default().push(form),
        }
    }
    for (spans, forms) in together {
        write_together(out, look, spans, &forms, clock)?;
    }
    out.text(format_args!("</g>\n"))
}

fn open_group(out: &mut Output<'_>, look: Look, detail: Detail) -> Result<(), Error> {
    let ink = look.ink(detail);
    let fill = ink.fill.map_or("none".to_owned(), |color| color.hex());
    out.text(format_args!("<g fill=\"{fill}\""))?;
    if let Some((color, width)) = ink.line {
        out.text(format_args!(
            " stroke=\"{}\" stroke-width=\"{width:.2}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"",
            color.hex()
        ))?;
    }
    if ink.is_dashed {
        let dash = detail.dash();
        out.text(format_args!(" stroke-dasharray=\"{dash:.1}\""))?;
    }
    if ink.opacity < 1.0 {
        out.text(format_args!(" opacity=\"{:.2}\"", ink.opacity))?;
    }
    out.text(format_args!(">\n"))
}

/// Writes forms that come and go together: all lines as one path.
fn write_together(
    out: &mut Output<'_>,
    look: Look,
    spans: &[Span],
    forms: &[&Form],
    clock: &Clock<'_>,
) -> Result<(), Error> {
    let visibility = clock.visibility(spans);
    if !visibility.is_empty() {
        let hidden = match clock.is_last(spans) {
            true => "",
            false => " visibility=\"hidden\"",
        };
        out.text(format_args!("<g{hidden}>{visibility}"))?;
    }
    let mut path = String::new();
    for form in forms {
        match form {
            Form::Line(ends) => push(&mut path, ends),
            Form::Path(places) => push(&mut path, places),
            Form::Triangle(corners) => {
                push(&mut path, corners);
                path.push('z');
            }
            other => write_form(out, look, other)?,
        }
    }
    if !path.is_empty() {
        out.text(format_args!("<path d=\"{path}\"/>"))?;
    }
    out.text(format_args!(
        "{}\n",
        if visibility.is_empty() { "" } else { "</g>" }
    ))
}

fn write_form(out: &mut Output<'_>, look: Look, form: &Form) -> Result<(), Error> {
    match form {
        &Form::Disc { center, radius } => {
            let [x, y, r] = [center[0], center[1], radius].map(number);
            out.text(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"))
        }
        &Form::Bar { corner, extent } => {
            let [[x, y], [width, height]] = [corner, extent].map(|p| p.map(number));
            out.text(format_args!(
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>"
            ))
        }
        Form::Text { start, size, text } => {
            let size = *size as f32 / 1000.0;
            let start = start.map(|v| v as f32 / 10.0);
            let weight = look.weight() * size;
            out.text(format_args!("<path stroke-width=\"{weight:.2}\" d=\""))?;
            write_strokes(out, &glyphs::strokes(text, start, size))?;
            out.text(format_args!("\"/>"))
        }
        Form::Line(_) | Form::Turn(_) | Form::Triangle(_) | Form::Path(_) => Ok(()),
    }
}

/// Writes a line that turns while its frame lasts.
fn write_turn(
    out: &mut Output<'_>,
    [from, to]: [[Spot; 2]; 2],
    span: Span,
    clock: &Clock<'_>,
) -> Result<(), Error> {
    let [begin, end] = clock.turn(span);
    let [from, to] = [from, to].map(|[a, b]| {
        let [[ax, ay], [bx, by]] = [a, b].map(|p| p.map(number));
        format!("M{ax} {ay}L{bx} {by}")
    });
    let hidden = match clock.is_last(&[span]) {
        true => "",
        false => " visibility=\"hidden\"",
    };
    out.text(format_args!(
        "<path d=\"{to}\"{hidden}>{}<animate attributeName=\"d\" values=\"{from};{from};{to};{to}\" keyTimes=\"0;{begin};{end};1\" dur=\"{:.3}s\" repeatCount=\"indefinite\"/></path>\n",
        clock.visibility(&[span]),
        clock.plan.total(),
    ))
}

/// Frames as shares of the whole time.
struct Clock<'p> {
    plan: &'p Plan,
}

impl Clock<'_> {
    fn share(&self, seconds: f64) -> String {
        let text = format!("{:.5}", (seconds / self.plan.total()).clamp(0.0, 1.0));
        text.trim_start_matches('0').to_owned()
    }

    fn begin(&self, frame: u32) -> String {
        self.share(self.plan.begin(frame as usize))
    }

    /// Tells whether something is there in the end.
    fn is_last(&self, spans: &[Span]) -> bool {
        spans.last().is_some_and(|span| self.is_open(*span))
    }

    fn is_open(&self, [_, end]: Span) -> bool {
        end as usize >= self.plan.ends.len()
    }

    /// When a line begins and ends to turn: in the first half of its frame.
    fn turn(&self, [frame, _]: Span) -> [String; 2] {
        let begin = self.plan.begin(frame as usize);
        [0.0, 0.6].map(|share| self.share(begin + share * self.plan.interval))
    }

    /// Writes when something is there; nothing if it always is.
    fn visibility(&self, spans: &[Span]) -> String {
        let mut values = String::new();
        let mut times = String::new();
        let mut put = |value, time: &str| {
            let separator = if values.is_empty() { "" } else { ";" };
            let written = write!(values, "{separator}{value}")
                .and_then(|()| write!(times, "{separator}{time}"));
            written.expect("bug: a string takes every character");
        };
        if spans[0][0] > 0 {
            put("hidden", "0");
        } else if self.is_open(spans[0]) {
            return String::new();
        }
        for &[begin, end] in spans {
            let time = if begin == 0 {
                "0".to_owned()
            } else {
                self.begin(begin)
            };
            put("visible", &time);
            if !self.is_open([begin, end]) {
                put("hidden", &self.begin(end));
            }
        }
        format!(
            "<animate attributeName=\"visibility\" values=\"{values}\" keyTimes=\"{times}\" calcMode=\"discrete\" dur=\"{:.3}s\" repeatCount=\"indefinite\"/>",
            self.plan.total()
        )
    }
}

/// Adds a line to a path: the first place, then from place to place.
fn push(path: &mut String, places: &[Spot]) {
    let mut last = [0; 2];
    for (i, &place) in places.iter().enumerate() {
        path.push(if i == 0 { 'M' } else { 'l' });
        push_tenths(path, place[0] - last[0]);
        if place[1] >= last[1] {
            path.push(' ');
        }
        push_tenths(path, place[1] - last[1]);
        last = place;
    }
}

fn number(tenths: i32) -> String {
    let mut text = String::new();
    push_tenths(&mut text, tenths);
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::AnimationOptions;
    use crate::animation::pen::Pen;
    use crate::picture::View;
    use delone::classic::{Algorithm, Input};
    use delone::{Log, Point};
    use std::collections::BTreeSet;

    fn recording() -> Recording {
        let place = |i: i32| Point::new(f64::from(i * i % 17), f64::from(i * 7 % 13));
        let input = Input::from_points((0..12).map(place));
        let mut log = Log::new("incremental", input.pslg.points.clone());
        let run = Algorithm::Incremental.observe(&input, &mut log);
        run.expect("finite points");
        Recording::new(Algorithm::Incremental.about(), log)
    }

    #[test]
    fn a_mark_is_there_when_its_frame_has_it() {
        let recording = recording();
        let drawing = [[0.0; 2], [100.0; 2]];
        let view = View::within(&recording.log.points, [100.0; 2], drawing);
        let pen = Pen::new(view, 0.1, 12);
        let start = || Player::new("run.svg", &recording, &pen, None, &());
        for max_frames in [7, 1000] {
            let options = AnimationOptions {
                max_frames,
                ..AnimationOptions::default()
            };
            let plan = Plan::new(&recording.log, &options);
            let timeline = film("run.svg", &mut start(), &plan).expect("few marks");
            let mut player = start();
            for (number, frame) in plan.frames().enumerate() {
                player.advance(frame).expect("a run");
                let number = number as u32;
                let shown = |spans: &[Span]| spans.iter().any(|s| s[0] <= number && number < s[1]);
                let seen = timeline.spans.iter().filter(|(_, spans)| shown(spans));
                let seen: BTreeSet<_> = seen.map(|(mark, _)| mark).collect();
                assert_eq!(seen, player.marks.iter().collect(), "frame {number}");
            }
        }
    }

    #[test]
    fn visibility_is_told_by_shares_of_the_time() {
        let plan = Plan {
            ends: vec![0; 8],
            wanted: 8,
            interval: 1.0,
            rest: 2.0,
        };
        let clock = Clock { plan: &plan };
        let open = u32::MAX;
        assert_eq!(clock.visibility(&[[0, open]]), "");
        let told = |spans: &[Span]| {
            let text = clock.visibility(spans);
            let from = text.find("values").expect("values");
            let to = text.find(" calcMode").expect("a mode");
            text[from..to].replace('"', "")
        };
        assert_eq!(told(&[[0, 4]]), "values=visible;hidden keyTimes=0;.40000");
        assert_eq!(
            told(&[[5, open]]),
            "values=hidden;visible keyTimes=0;.50000"
        );
        let twice = "values=hidden;visible;hidden;visible keyTimes=0;.10000;.20000;.30000";
        assert_eq!(told(&[[1, 2], [3, open]]), twice);
    }
}
