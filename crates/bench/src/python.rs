//! The peers that are reached through Python: found at run time, given the same bits, run by a script.

use crate::process::{Fault, Launcher};
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// A script of the folder `peers`, part of this program.
#[derive(Clone, Copy, Debug)]
pub struct Script {
    name: &'static str,
    text: &'static str,
}

/// What all scripts import.
const CLOCK: Script = Script {
    name: "clock.py",
    text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/peers/clock.py")),
};

/// How long Python may take to say what is installed.
const PATIENCE: Duration = Duration::from_secs(60);

impl Script {
    /// Refines domains.
    pub const REFINE: Self = Self {
        name: "refine.py",
        text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/peers/refine.py")),
    };
    /// Answers queries.
    pub const QUERIES: Self = Self {
        name: "queries.py",
        text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/peers/queries.py")),
    };

    /// Writes and reads files.
    pub const FILES: Self = Self {
        name: "files.py",
        text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/peers/files.py")),
    };

    fn write_to(self, folder: &Path) -> io::Result<PathBuf> {
        let path = folder.join(self.name);
        std::fs::write(&path, self.text)?;
        Ok(path)
    }
}

/// A Python interpreter, a script, and a folder for its input, which vanishes with this.
#[derive(Debug)]
pub struct Python {
    launcher: Launcher,
    script: PathBuf,
    versions: BTreeMap<String, Option<String>>,
    files: Files,
}

impl Python {
    /// Asks `program` which peers of `script` it has.
    ///
    /// # Errors
    /// If it cannot be run or does not answer, or if there is no place for files.
    pub fn find(program: &Path, script: Script) -> Result<Self, String> {
        let files = Files::new().map_err(|error| format!("no place for files: {error}"))?;
        let written = [CLOCK, script].map(|script| script.write_to(&files.folder));
        let [_, script] = written.map(|path| path.map_err(|error| error.to_string()));
        let mut python = Self {
            launcher: Launcher::new(program.to_owned()),
            script: script?,
            versions: BTreeMap::new(),
            files,
        };
        let versions = python.answer(["versions".to_owned()], PATIENCE);
        python.versions = versions.map_err(|fault| match fault {
            Fault::Failed { how, message } => format!("{how}: {message}"),
            Fault::TimedOut(limit) => format!("no answer within {limit:?}"),
        })?;
        Ok(python)
    }

    /// Returns the version of a package that is installed, numpy with it.
    pub fn version(&self, package: &str) -> Option<&str> {
        self.versions.get(package)?.as_deref()
    }

    /// Returns the folder for its input.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Runs the script with `words`, for no longer than `timeout`, the start of Python included.
    ///
    /// # Errors
    /// What became of it, if it does not answer.
    pub fn answer<A: DeserializeOwned>(
        &self,
        words: impl IntoIterator<Item = String>,
        timeout: Duration,
    ) -> Result<A, Fault> {
        let script = [self.script.display().to_string()];
        let args: Vec<_> = script.into_iter().chain(words).collect();
        self.launcher.answer(&args, timeout)
    }
}

/// A folder for files that others shall read; it vanishes with this.
#[derive(Debug)]
pub struct Files {
    folder: PathBuf,
}

impl Files {
    /// Makes one.
    ///
    /// # Errors
    /// Those of the system.
    pub fn new() -> io::Result<Self> {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("delone-bench-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder)?;
        Ok(Self { folder })
    }

    /// Returns the place of a file with this name.
    pub fn place(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Writes a file, unless it is there already, and returns where it is.
    ///
    /// # Errors
    /// Those of writing.
    pub fn keep(&self, name: &str, content: impl FnOnce() -> Vec<u8>) -> io::Result<String> {
        let path = self.place(name);
        if !path.exists() {
            std::fs::write(&path, content())?;
        }
        Ok(path.display().to_string())
    }
}

impl Drop for Files {
    fn drop(&mut self) {
        // What is left behind in a folder for temporary files harms nobody.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

#[cfg(test)]
mod tests {
    use super::{Python, Script};
    use std::path::Path;

    #[test]
    fn a_missing_interpreter_is_an_error() {
        let complaint = Python::find(Path::new("/nowhere/python"), Script::REFINE).unwrap_err();
        assert!(complaint.contains("no process"), "{complaint}");
    }
}
