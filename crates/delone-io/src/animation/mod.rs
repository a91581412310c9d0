//! Moving pictures of a run: `.svg` for browsers, `.gif` for elsewhere, and filmstrips (`.png`).
//!
//! All three show the same: vertices, edges, triangles in the pale colours of their smallest angle,
//! constraints, the front, the sweep, what waits; upon them, for one frame, what the current step is about.
//! What comes, or may stay, is blue; what goes, or must go, is red; what is asked, or has its turn, is
//! magenta; what waits is orange; what has gone or is only thought of is dashed.
//!
//! A frame is a set of [marks](mark), kept up to date step by step ([`player`]); [`raster`] makes pixels of
//! one, [`smil`] remembers when each mark is there.
//!
//! *Cost*: time O(steps · log n) and, for pixels, O(frames · what is to be seen). Memory beside the log:
//! four frames of pixels for a GIF, the page for a filmstrip; for SVG what is ever seen in a frame, at most
//! 200 000 elements, each with the times when it comes and goes.

mod beach;
mod frames;
mod gif;
mod highlight;
mod mark;
mod palette;
mod panel;
mod pen;
mod player;
mod raster;
mod smil;
mod strip;
mod words;

use crate::picture::View;
use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Error, Format, Recording, Target};
use delone::Watch;
use frames::{FASTEST, Plan};
use panel::Panel;
use pen::Pen;
use player::{Player, points_of};
use std::path::PathBuf;

/// How a run is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct AnimationOptions {
    /// Length of the longer side in pixels, from 64 to 8192.
    pub size: u32,
    /// How fast it goes.
    pub pace: Pace,
    /// Which steps make a frame.
    pub shown: ShownSteps,
    /// Most frames of a moving picture, at least 2; of more steps, so many are shown, evenly spread.
    pub max_frames: usize,
    /// The frames of a filmstrip.
    pub strip: Strip,
    /// If there are any, after how many steps a filmstrip has its frames, instead of those that `strip` asks for;
    /// the result follows as the last one.
    pub moments: Vec<usize>,
}

impl Default for AnimationOptions {
    fn default() -> Self {
        Self {
            size: 1200,
            pace: Pace::PerSecond(4.0),
            shown: ShownSteps::All,
            max_frames: 1000,
            strip: Strip::default(),
            moments: Vec::new(),
        }
    }
}

/// How fast an animation goes; the last frame stays longer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// So many frames a second, at most 50.
    PerSecond(f64),
    /// All frames in so many seconds, from 0.1 to 36 000. No more are shown than 50 a second.
    InSeconds(f64),
}

/// Which steps make a frame. Steps of line 0, which lay out what an algorithm begins with, never do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShownSteps {
    /// All.
    All,
    /// Those that change the drawing. To be looked at, to wait, or to count for another triangle is no change.
    Changes,
}

/// The frames of a filmstrip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Strip {
    /// How many, from 1 to 100.
    pub frames: usize,
    /// The ends of stages instead of steps that are evenly spread.
    pub at_stages: bool,
}

impl Default for Strip {
    fn default() -> Self {
        Self {
            frames: 12,
            at_stages: false,
        }
    }
}

/// What has been written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnimationReport {
    /// The names of the files.
    pub files: Vec<PathBuf>,
    /// How many frames a moving picture has, or a filmstrip if there is no other.
    pub frames: usize,
    /// How many there would have been without a limit.
    pub wanted: usize,
}

/// Draws a run to every target: `.svg` and `.gif` move, `.png` is a filmstrip.
///
/// ```
/// use delone::classic::{Algorithm, Input};
/// use delone::Log;
/// use delone_io::{AnimationOptions, Recording, Target, write_animation};
///
/// # let folder = tempfile::tempdir()?;
/// # let place = |name: &str| folder.path().join(name);
/// let input = Input::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)]);
/// let mut log = Log::new("incremental", input.pslg.points.clone());
/// Algorithm::Incremental.observe(&input, &mut log)?;
/// let recording = Recording::new(Algorithm::Incremental.about(), log);
///
/// let targets = ["run.svg", "run.png"].map(|name| Target::from_arg(place(name), None));
/// let report = write_animation(&targets, &recording, &AnimationOptions::default(), &())?;
/// assert_eq!(report.files.len(), 2);
/// assert_eq!(report.frames, report.wanted);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If an option is out of range, a step does not fit those before it, a target has another format, an SVG
/// would have too many elements, writing fails, or the watch cancels.
pub fn write_animation(
    targets: &[Target],
    recording: &Recording,
    options: &AnimationOptions,
    watch: &dyn Watch,
) -> Result<AnimationReport, Error> {
    let mut staging = Staging::new(0, watch);
    let mut moving = None;
    let mut still = None;
    for target in targets {
        let format = target.format()?;
        require(target, options)?;
        let plan = match format {
            Format::Png => still.insert(Plan::strip(&recording.log, options)),
            Format::Svg | Format::Gif => moving.insert(Plan::new(&recording.log, options)),
            other => {
                let can = Format::writes_animation;
                return Err(unsupported(target, other, "show a run", can));
            }
        };
        staging.write(target.path.as_deref(), |out| match format {
            Format::Png => strip::write(out, recording, plan, options.size, watch),
            _ => write_moving(out, format, recording, plan, options.size, watch),
        })?;
    }
    let plan = moving.or(still);
    Ok(AnimationReport {
        files: staging.commit()?,
        frames: plan.as_ref().map_or(0, |plan| plan.ends.len()),
        wanted: plan.map_or(0, |plan| plan.wanted),
    })
}

/// Refuses what is out of range.
fn require(target: &Target, options: &AnimationOptions) -> Result<(), Error> {
    let refuse = |reason: String| {
        let file = target.to_string();
        Err(Error::Picture { file, reason })
    };
    let size = options.size;
    if !(64..=8192).contains(&size) {
        return refuse(format!("size {size} pixels: must be from 64 to 8192"));
    }
    let frames = match options.moments.len() {
        0 => options.strip.frames,
        chosen => chosen + 1,
    };
    if !(1..=100).contains(&frames) {
        return refuse(format!("{frames} frames of a strip: must be from 1 to 100"));
    }
    match options.pace {
        Pace::PerSecond(rate) if !(0.01..=FASTEST).contains(&rate) => refuse(format!(
            "{rate} frames a second: must be from 0.01 to {FASTEST}"
        )),
        Pace::InSeconds(total) if !(0.1..=36_000.0).contains(&total) => {
            refuse(format!("{total} seconds: must be from 0.1 to 36000"))
        }
        _ => Ok(()),
    }
}

/// Writes a picture that moves: the drawing on the left, words on the right.
fn write_moving(
    out: &mut Output<'_>,
    format: Format,
    recording: &Recording,
    plan: &Plan,
    size: u32,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let unit = size as f32 / 1200.0;
    let page = [size as f32, (0.6 * size as f32).round()];
    let margin = 40.0 * unit;
    let side = page[1] - 2.0 * margin;
    let points = points_of(&recording.log);
    let view = View::within(&points, page, [[margin; 2], [side; 2]]);
    let pen = Pen::new(view, unit, points.len());
    let left = page[1];
    let note = match plan.wanted > plan.ends.len() {
        true => format!("{} of {} frames", plan.ends.len(), plan.wanted),
        false => String::new(),
    };
    let place = [left, 0.0, page[0] - left, page[1]];
    let panel = Panel::new(recording, place, unit, note);
    let file = out.file().to_owned();
    let start = || Player::new(&file, recording, &pen, Some(&panel), watch);
    match format {
        Format::Gif => gif::write(out, start, plan),
        _ => smil::write(out, recording, start(), plan),
    }
}
