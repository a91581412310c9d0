//! Runs of algorithms in files: every step, with all that is needed to play, draw and explain them.
//!
//! - `.json` ([`json`]): one object, a step to a line, for people and for programs of any kind;
//! - `.dlog` ([`binary`]): the same in a tenth of the room, with a checksum.
//!
//! `docs/algorithms/log-format.md` describes both. A file is read as what it is, whatever its name says.
//! That the steps fit together is not asked here: whoever plays them will see.
//!
//! *Cost*: O(steps). Writing keeps nothing; a log in memory takes up to 30 times the room of its `.dlog`.

mod binary;
mod decode;
mod encode;
mod json;

use crate::target::Staging;
use crate::{Error, Source};
use delone::classic::About;
use delone::{Log, Watch};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Version of both formats; files of another are refused.
const VERSION: u16 = 1;

/// A run with the words that explain it: what a log file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    /// What people call the algorithm.
    pub title: String,
    /// Where the algorithm comes from.
    pub source: String,
    /// Its pseudocode; [`Step::line`](delone::Step::line) counts from 1.
    pub code: Vec<String>,
    /// Points and steps.
    pub log: Log,
}

impl Recording {
    /// Puts a run and the description of its algorithm together.
    pub fn new(about: &About, log: Log) -> Self {
        Self {
            title: about.title.to_owned(),
            source: about.source.to_owned(),
            code: about.code.iter().map(|&line| line.to_owned()).collect(),
            log,
        }
    }
}

/// A format of log files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LogFormat {
    /// `.json`: text.
    Json,
    /// `.dlog`: bytes.
    Binary,
}

impl LogFormat {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Json, Self::Binary];

    /// Returns its name, which is also the extension of its files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Binary => "dlog",
        }
    }

    /// Tells the format from the extension of a file name; case does not matter.
    pub fn from_path(path: &Path) -> Option<Self> {
        path.extension()?.to_str()?.parse().ok()
    }

    /// Tells the format from the first bytes of the content.
    pub fn sniff(head: &[u8]) -> Option<Self> {
        if binary::sniff(head) {
            return Some(Self::Binary);
        }
        let first = head.iter().find(|byte| !byte.is_ascii_whitespace());
        (first == Some(&b'{')).then_some(Self::Json)
    }

    /// Tells whether a content begins like a log: other JSON does not say that it is one.
    pub fn is_log(head: &[u8]) -> bool {
        match Self::sniff(head) {
            Some(Self::Binary) => true,
            Some(Self::Json) => json::sniff(head),
            None => false,
        }
    }

    fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }
}

impl fmt::Display for LogFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for LogFormat {
    type Err = String;

    /// Takes the name, with or without a dot, in any case.
    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = text.trim_start_matches('.').to_ascii_lowercase();
        let mut all = Self::ALL.into_iter();
        all.find(|format| format.name() == wanted).ok_or_else(|| {
            let names = Self::names();
            format!("unknown format of logs {text:?}; known are {names}")
        })
    }
}

/// Writes a run to a file, or to standard output if there is no path; without a format, the extension
/// tells it. The file appears under its name when it is complete. Returns the names of the files written.
///
/// ```
/// use delone::classic::{Algorithm, Input};
/// use delone::Log;
/// use delone_io::{Recording, Source, read_log, write_log};
///
/// # let folder = tempfile::tempdir()?;
/// let input = Input::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
/// let mut log = Log::new("incremental", input.pslg.points.clone());
/// Algorithm::Incremental.observe(&input, &mut log)?;
/// let recording = Recording::new(Algorithm::Incremental.about(), log);
///
/// let path = folder.path().join("square.dlog");
/// write_log(&recording, Some(&path), None, &())?;
/// assert_eq!(read_log(&Source::from_arg(&path), &())?, recording);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If neither format nor extension is known, a number is not finite (in JSON), writing fails, or the watch
/// cancels.
pub fn write_log(
    recording: &Recording,
    path: Option<&Path>,
    format: Option<LogFormat>,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let format = format.or_else(|| path.and_then(LogFormat::from_path));
    let Some(format) = format else {
        let file = path.map_or("-".to_owned(), |path| path.display().to_string());
        let known = LogFormat::names();
        return Err(Error::UnknownFormat { file, known });
    };
    let mut staging = Staging::new(recording.log.steps.len() as u64, watch);
    staging.write(path, |out| match format {
        LogFormat::Json => json::write(out, recording),
        LogFormat::Binary => binary::write(out, recording),
    })?;
    staging.commit()
}

/// Reads a run; the content tells the format.
///
/// # Errors
/// If it is no log, of another version, or damaged: the error names the place and, if it is in a step, its
/// number. If reading fails, or the watch cancels.
pub fn read_log(source: &Source, watch: &dyn Watch) -> Result<Recording, Error> {
    let bytes = source.load(watch)?;
    let file = source.to_string();
    match LogFormat::sniff(&bytes) {
        Some(LogFormat::Json) => json::read(&bytes, &file),
        Some(LogFormat::Binary) => binary::read(&bytes, &file, watch),
        None => Err(Error::UnknownFormat {
            file,
            known: LogFormat::names(),
        }),
    }
}
