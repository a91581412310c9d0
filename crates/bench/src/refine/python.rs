//! The peers that are reached through Python: found at run time, given the same bits, run by a script.

use super::goal::Outline;
use super::job::{Answer, Job};
use super::mesher::Mesher;
use crate::process::{Fault, Launcher};
use serde_json::json;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The script, part of this program: it is handed to Python as an argument.
const SCRIPT: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/peers/refine.py"));

/// How long Python may take to say what is installed.
const PATIENCE: Duration = Duration::from_secs(60);

/// A Python interpreter and a folder for outlines, which vanishes with this.
#[derive(Debug)]
pub struct Python {
    launcher: Launcher,
    versions: BTreeMap<String, Option<String>>,
    folder: PathBuf,
}

impl Python {
    /// Asks `program` which peers it has.
    ///
    /// # Errors
    /// If it cannot be run or does not answer, or if there is no place for files.
    pub fn find(program: &Path) -> Result<Self, String> {
        let launcher = Launcher::new(program.to_owned());
        let versions = launcher.answer(&script_args(["versions".to_owned()]), PATIENCE);
        let versions = versions.map_err(|fault| match fault {
            Fault::Failed { how, message } => format!("{how}: {message}"),
            Fault::TimedOut(limit) => format!("no answer within {limit:?}"),
        })?;
        let folder = std::env::temp_dir().join(format!("delone-bench-{}", std::process::id()));
        std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        Ok(Self {
            launcher,
            versions,
            folder,
        })
    }

    /// Returns the version of a peer that is installed, numpy with it.
    pub fn version(&self, mesher: Mesher) -> Option<&str> {
        self.versions.get(mesher.python_package()?)?.as_deref()
    }

    /// Does `job`, for no longer than `timeout`, the start of Python included.
    ///
    /// # Errors
    /// What became of it, if it does not answer.
    pub fn mesh(&self, job: &Job, timeout: Duration) -> Result<Answer, Fault> {
        let path = self.file_of(job.outline, job.seed);
        let path = path.map_err(|error| Fault::failed("no file", error))?;
        let words = [
            job.mesher.to_string(),
            path.display().to_string(),
            job.goal.angle.to_string(),
            job.goal.area.unwrap_or(0.0).to_string(),
            if job.check { "check" } else { "time" }.to_owned(),
        ];
        self.launcher.answer(&script_args(words), timeout)
    }

    /// Writes the outline, unless it is there already. Shortest decimals read back as the same bits.
    fn file_of(&self, outline: Outline, seed: u64) -> io::Result<PathBuf> {
        let name = format!("{}-{}-{seed}.json", outline.domain, outline.size);
        let path = self.folder.join(name);
        if !path.exists() {
            let drawing = outline.draw(seed);
            let domain = json!({
                "points": drawing.points,
                "segments": drawing.segments,
                "holes": drawing.holes,
            });
            std::fs::write(&path, domain.to_string())?;
        }
        Ok(path)
    }
}

impl Drop for Python {
    fn drop(&mut self) {
        // What is left behind in a folder for temporary files harms nobody.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

fn script_args(words: impl IntoIterator<Item = String>) -> Vec<String> {
    let script = ["-c".to_owned(), SCRIPT.to_owned()];
    script.into_iter().chain(words).collect()
}

#[cfg(test)]
mod tests {
    use super::Python;
    use std::path::Path;

    #[test]
    fn a_missing_interpreter_is_an_error() {
        let complaint = Python::find(Path::new("/nowhere/python")).unwrap_err();
        assert!(complaint.contains("no process"), "{complaint}");
    }
}
