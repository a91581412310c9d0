//! Files that show a run: logs and moving pictures.

use crate::exit::Failure;
use crate::files::{self, Outputs};
use crate::progress::Progress;
use crate::words::count;
use delone_io::{
    AnimationOptions, Format, LogFormat, Pace, Recording, ShownSteps, Strip, Target,
    write_animation, write_log,
};
use std::path::PathBuf;

/// Pixels of a GIF at its longer side, unless others are asked for: it has no lines, only dots.
const GIF_SIZE: u32 = 800;

/// Most frames of moving pictures. Each frame of a GIF is drawn anew; an SVG holds what changes.
const SVG_FRAMES: usize = 1000;
const GIF_FRAMES: usize = 300;

/// Pixels below which a run cannot be shown.
const SMALLEST: u32 = 64;

/// Seconds that an animation may last.
const LENGTHS: std::ops::RangeInclusive<f64> = 0.1..=36_000.0;

/// Steps of which it is said that a log of them is large, and steps that are not kept: each takes some 64
/// bytes of memory.
const MANY: u64 = 5_000_000;
const TOO_MANY: u64 = 50_000_000;

/// Options about what is to be seen of a run.
#[derive(clap::Args)]
#[command(next_help_heading = "Watching")]
pub struct Watched {
    /// Log to write: every step, .json or .dlog (bytes); docs/algorithms/log-format.md describes both
    #[arg(long, value_name = "LOG")]
    log: Option<PathBuf>,
    /// Animation to write, .svg: it plays in a browser
    #[arg(long, value_name = "SVG")]
    svg: Option<PathBuf>,
    /// Animation to write, .gif: 800 pixels wide unless --size says otherwise
    #[arg(long, value_name = "GIF")]
    gif: Option<PathBuf>,
    /// Filmstrip to write, .png: some frames beside each other
    #[arg(long, value_name = "PNG")]
    filmstrip: Option<PathBuf>,
    /// Frames of the filmstrip
    #[arg(long, value_name = "N", default_value_t = 12,
          value_parser = clap::value_parser!(u8).range(1..=100))]
    frames: u8,
    /// Length of an animation in seconds, from 0.1 to 36000 [default: four frames a second]
    #[arg(long, value_name = "S", value_parser = length, allow_negative_numbers = true)]
    seconds: Option<f64>,
    /// Most frames of an animation, evenly spread [default: 1000 for .svg, 300 for .gif]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    max_frames: Option<u32>,
    /// Show only steps that change the drawing, not what is looked at
    #[arg(long)]
    changes: bool,
}

impl Watched {
    /// Tells whether anything is to be written.
    pub fn is_wanted(&self) -> bool {
        let pictures = [&self.svg, &self.gif, &self.filmstrip];
        self.log.is_some() || pictures.into_iter().any(Option::is_some)
    }

    /// Settles where to write pictures of such a size, or says what is wrong, before the work begins.
    pub fn settle(&self, size: Option<u32>, outputs: &mut Outputs) -> Result<(), Failure> {
        self.require_names()?;
        if self.pictures().next().is_some() && size.is_some_and(|size| size < SMALLEST) {
            let small = format!("a run cannot be shown on less than {SMALLEST} pixels: --size");
            return Err(Failure::Usage(small));
        }
        let pictures = self.pictures().map(|(path, _)| path);
        let mut files = self.log.iter().chain(pictures);
        files.try_for_each(|path| outputs.reserve(path))
    }

    /// Refuses runs that are too long to be kept, and says which take much memory.
    pub fn require_room(&self, steps: u64, progress: &Progress) -> Result<(), Failure> {
        let told = count(steps as usize);
        if steps > TOO_MANY {
            let (most, advice) = (count(TOO_MANY as usize), "show it on fewer points");
            let long =
                format!("the run has {told} steps, and at most {most} can be kept; {advice}");
            return Err(Failure::NotReached(long));
        }
        if steps > MANY {
            progress.note(&[format!(
                "{told} steps: they take some 70 bytes each in memory"
            )]);
        }
        Ok(())
    }

    fn require_names(&self) -> Result<(), Failure> {
        if let Some(path) = &self.log
            && LogFormat::from_path(path).is_none()
        {
            let wrong = format!("{}: logs are .json or .dlog", path.display());
            return Err(Failure::Usage(wrong));
        }
        for (path, format) in self.pictures() {
            if Format::from_path(path) != Some(format) {
                let wrong = format!("{}: this is to be a .{format} file", path.display());
                return Err(Failure::Usage(wrong));
            }
        }
        Ok(())
    }

    fn pictures(&self) -> impl Iterator<Item = (&PathBuf, Format)> {
        let wanted = [
            (&self.svg, Format::Svg),
            (&self.gif, Format::Gif),
            (&self.filmstrip, Format::Png),
        ];
        wanted
            .into_iter()
            .filter_map(|(path, format)| Some((path.as_ref()?, format)))
    }

    /// Writes what is wanted, pictures with `size` pixels at their longer side if that is given, and returns
    /// the names.
    pub fn write(
        &self,
        recording: &Recording,
        size: Option<u32>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mut written = Vec::new();
        if let Some(path) = &self.log {
            let log = write_log(recording, Some(path), None, progress);
            written.extend(log.map_err(files::unwritable)?);
        }
        for (path, format) in self.pictures() {
            let target = Target::from_arg(path, Some(format));
            let options = self.options(format, size);
            let report = write_animation(&[target], recording, &options, progress);
            let report = report.map_err(files::unwritable)?;
            if report.frames < report.wanted && format != Format::Png {
                let (frames, wanted, path) = (report.frames, report.wanted, path.display());
                progress.note(&[format!(
                    "{path} shows {frames} of {wanted} frames, evenly spread"
                )]);
            }
            written.extend(report.files);
        }
        Ok(written)
    }

    fn options(&self, format: Format, size: Option<u32>) -> AnimationOptions {
        let usual = AnimationOptions::default();
        let (usual_size, max_frames) = match format {
            Format::Gif => (GIF_SIZE, GIF_FRAMES),
            _ => (usual.size, SVG_FRAMES),
        };
        AnimationOptions {
            size: size.unwrap_or(usual_size),
            max_frames: self.max_frames.map_or(max_frames, |n| n as usize),
            pace: self.seconds.map_or(usual.pace, Pace::InSeconds),
            shown: if self.changes {
                ShownSteps::Changes
            } else {
                ShownSteps::All
            },
            strip: Strip {
                frames: self.frames.into(),
                ..usual.strip
            },
            ..usual
        }
    }
}

fn length(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|s| LENGTHS.contains(s));
    seconds.ok_or_else(|| "seconds are needed, from 0.1 to 36000".to_owned())
}
