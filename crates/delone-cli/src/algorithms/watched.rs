//! Files that show a run: logs and moving pictures.

use crate::exit::Failure;
use crate::files;
use crate::progress::Progress;
use delone_io::{
    AnimationOptions, Format, LogFormat, Pace, Recording, ShownSteps, Strip, Target,
    write_animation, write_log,
};
use std::path::PathBuf;

/// Steps of which it is said that a log of them is large.
pub const MANY: u64 = 5_000_000;

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
    /// Animation to write, .gif
    #[arg(long, value_name = "GIF")]
    gif: Option<PathBuf>,
    /// Filmstrip to write, .png: some frames beside each other
    #[arg(long, value_name = "PNG")]
    filmstrip: Option<PathBuf>,
    /// Frames of the filmstrip
    #[arg(long, value_name = "N", default_value_t = 12,
          value_parser = clap::value_parser!(u8).range(1..=100))]
    frames: u8,
    /// Length of an animation in seconds [default: four frames a second]
    #[arg(long, value_name = "S", value_parser = crate::numbers::positive)]
    seconds: Option<f64>,
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

    /// Refuses names that do not fit, before the work begins.
    pub fn require_names(&self) -> Result<(), Failure> {
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

    /// Writes what is wanted, pictures with `size` pixels at their longer side, and returns the names.
    pub fn write(
        &self,
        recording: &Recording,
        size: u32,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mut written = Vec::new();
        if let Some(path) = &self.log {
            let log = write_log(recording, Some(path), None, progress);
            written.extend(log.map_err(files::unwritable)?);
        }
        let pictures = self.pictures();
        let targets: Vec<_> = pictures
            .map(|(path, format)| Target::from_arg(path, Some(format)))
            .collect();
        let usual = AnimationOptions::default();
        let options = AnimationOptions {
            size,
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
        };
        let report = write_animation(&targets, recording, &options, progress);
        let report = report.map_err(files::unwritable)?;
        if report.frames < report.wanted {
            let (frames, wanted) = (report.frames, report.wanted);
            progress.note(&[format!(
                "{frames} of {wanted} frames are shown, evenly spread"
            )]);
        }
        written.extend(report.files);
        Ok(written)
    }
}
