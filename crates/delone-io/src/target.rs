//! Where output goes: files, written to temporary names and renamed together, or standard output.
//!
//! A file appears under its name only when it and all that are written with it, in one call or within a
//! [commit](crate::Commit), are complete. Should one of several then not get its name, those before it stay, and the
//! error names them. The promise holds against errors, cancellation and a crash of the program; the files are not
//! flushed to the disk, so it does not hold against a power cut.

use crate::certificate::Hashing;
use crate::commit::{self, Complete};
use crate::memory;
use crate::unfinished::{NotRenamed, Unfinished, persist_all};
use crate::{Error, FileFact, Format};
use delone::{Phase, Watch};
use std::ffi::OsStr;
use std::fmt;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Bytes collected before they go to the operating system; also between two looks at the watch.
const BUFFER: usize = 1 << 17;

/// Where output goes, and in which format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// The file, or `None` for standard output.
    pub path: Option<PathBuf>,
    /// The format; `None` means by extension.
    pub format: Option<Format>,
}

impl Target {
    /// Makes a target from a command-line argument: `-` is standard output, which needs a format.
    pub fn from_arg(arg: impl AsRef<OsStr>, format: Option<Format>) -> Self {
        let arg = arg.as_ref();
        let path = (arg != "-").then(|| arg.into());
        Self { path, format }
    }

    /// Returns the format asked for, or that of the extension.
    ///
    /// # Errors
    /// If there is neither.
    pub fn format(&self) -> Result<Format, Error> {
        let by_name = || self.path.as_deref().and_then(Format::from_path);
        self.format
            .or_else(by_name)
            .ok_or_else(|| Error::UnknownFormat {
                file: self.to_string(),
                known: Format::names(Format::writes_mesh),
            })
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.path {
            Some(path) => path.display().fmt(f),
            None => f.write_str("-"),
        }
    }
}

/// Files that are being written; dropping it removes them.
pub(crate) struct Staging<'a> {
    complete: Vec<Complete>,
    /// The names as the caller gave them.
    names: Vec<PathBuf>,
    watch: &'a dyn Watch,
    rows_done: u64,
    rows_total: u64,
    /// The hashes of the files, if they are wanted.
    digests: Option<Vec<FileFact>>,
}

impl<'a> Staging<'a> {
    /// Begins with `rows_total` rows to be written, all files together.
    pub fn new(rows_total: u64, watch: &'a dyn Watch) -> Self {
        Self {
            complete: Vec::new(),
            names: Vec::new(),
            watch,
            rows_done: 0,
            rows_total,
            digests: None,
        }
    }

    /// Hashes the files that are written from now on.
    pub fn with_digests(self) -> Self {
        Self {
            digests: Some(Vec::new()),
            ..self
        }
    }

    /// Hands out the hashes of the files since the last time.
    pub fn take_digests(&mut self) -> Vec<FileFact> {
        self.digests
            .as_mut()
            .map(std::mem::take)
            .unwrap_or_default()
    }

    /// Writes one file, or standard output if `path` is `None`; `fill` makes its content.
    pub fn write(
        &mut self,
        path: Option<&Path>,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(path) = path else {
            return self.fill("-", &mut io::stdout().lock(), fill);
        };
        if memory::is_wanted() {
            return self.keep(path, fill);
        }
        let name = path.display().to_string();
        let at = |action| {
            let file = name.clone();
            move |source| Error::Io {
                action,
                file,
                source,
            }
        };
        let existing = fs::metadata(path).ok();
        if existing
            .as_ref()
            .is_some_and(|m| !m.is_file() && !m.is_dir())
        {
            // A device or a pipe cannot be replaced by a file.
            let mut device = OpenOptions::new()
                .write(true)
                .open(path)
                .map_err(at("open"))?;
            self.names.push(path.to_owned());
            return self.fill(&name, &mut device, fill);
        }
        if existing.is_some_and(|m| m.is_dir()) {
            return Err(at("write")(io::ErrorKind::IsADirectory.into()));
        }
        let place = behind_links(path).map_err(at("create"))?;
        let (mut file, temporary) = Unfinished::create_beside(&place).map_err(at("create"))?;
        self.fill(&name, &mut file, fill)?;
        self.complete.push((temporary, place));
        self.names.push(path.to_owned());
        Ok(())
    }

    /// Writes one file that stays in memory.
    fn keep(
        &mut self,
        path: &Path,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut bytes = Vec::new();
        self.fill(&path.display().to_string(), &mut bytes, fill)?;
        memory::keep(path, bytes);
        self.names.push(path.to_owned());
        Ok(())
    }

    fn fill(
        &mut self,
        file: &str,
        sink: &mut dyn Write,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        if self.digests.is_none() {
            return self.fill_sink(file, sink, fill);
        }
        let mut hashing = Hashing::new(sink);
        self.fill_sink(file, &mut hashing, fill)?;
        if let Some(digests) = &mut self.digests {
            digests.push(hashing.finish(file));
        }
        Ok(())
    }

    fn fill_sink(
        &mut self,
        file: &str,
        sink: &mut dyn Write,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut output = Output {
            file,
            sink,
            buffer: Vec::with_capacity(BUFFER + BUFFER / 8),
            watch: self.watch,
            rows_done: self.rows_done,
            rows_total: self.rows_total,
        };
        fill(&mut output)?;
        output.flush()?;
        self.rows_done = output.rows_done;
        Ok(())
    }

    /// Gives all files their names, or lets them wait for others, and returns the names.
    pub fn commit(self) -> Result<Vec<PathBuf>, Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        if let Some(files) = commit::wait(self.complete) {
            give_names(files)?;
        }
        Ok(self.names)
    }
}

/// Gives files their names.
pub(crate) fn give_names(files: Vec<Complete>) -> Result<(), Error> {
    persist_all(files).map_err(not_renamed)
}

/// Returns what a symbolic link points to, even if that is not there yet: it is replaced, not the link.
fn behind_links(path: &Path) -> io::Result<PathBuf> {
    let mut place = path.to_owned();
    loop {
        match fs::canonicalize(&place) {
            Ok(known) => return Ok(known),
            Err(error) if error.kind() != io::ErrorKind::NotFound && place.is_symlink() => {
                // Links that point at each other, for example.
                return Err(error);
            }
            Err(_) => {}
        }
        // Each turn follows a link at the end of the name, and a circle of them is another error.
        match fs::read_link(&place) {
            Ok(next) => place = place.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(place),
        }
    }
}

fn not_renamed(failed: NotRenamed) -> Error {
    let file = failed.place.display().to_string();
    let source = failed.source;
    if failed.replaced.is_empty() {
        let action = "write";
        return Error::Io {
            action,
            file,
            source,
        };
    }
    let names = failed.replaced.iter().map(|p| p.display().to_string());
    Error::PartlyWritten {
        file,
        replaced: names.collect::<Vec<_>>().join(", "),
        source,
    }
}

/// A file being filled: buffers, formats numbers, reports progress, notices cancellation.
pub(crate) struct Output<'a> {
    file: &'a str,
    sink: &'a mut dyn Write,
    buffer: Vec<u8>,
    watch: &'a dyn Watch,
    rows_done: u64,
    rows_total: u64,
}

impl<'a> Output<'a> {
    /// Returns the name of the file, for messages.
    pub fn file(&self) -> &'a str {
        self.file
    }

    /// Fails once the watch has cancelled: for writers that collect much before they append it.
    #[cfg_attr(
        not(feature = "parquet"),
        expect(dead_code, reason = "the one such writer is optional")
    )]
    pub fn check(&self) -> Result<(), Error> {
        match self.watch.is_cancelled() {
            true => Err(Error::Cancelled),
            false => Ok(()),
        }
    }

    /// Appends formatted text.
    pub fn text(&mut self, text: fmt::Arguments<'_>) -> Result<(), Error> {
        self.buffer
            .write_fmt(text)
            .expect("bug: a vector takes every byte");
        self.flush_if_full()
    }

    /// Appends bytes.
    pub fn bytes(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.buffer.extend_from_slice(bytes);
        self.flush_if_full()
    }

    /// Appends many bytes, in pieces between which cancellation is noticed.
    pub fn many_bytes(&mut self, bytes: &[u8]) -> Result<(), Error> {
        bytes.chunks(BUFFER).try_for_each(|chunk| self.bytes(chunk))
    }

    /// Appends an integer.
    pub fn integer(&mut self, value: i64) {
        let mut digits = itoa::Buffer::new();
        self.buffer
            .extend_from_slice(digits.format(value).as_bytes());
    }

    /// Appends the shortest decimal that reads back as the same number.
    pub fn number(&mut self, value: f64) {
        let mut digits = ryu::Buffer::new();
        let text = digits.format(value);
        let text = text.strip_suffix(".0").unwrap_or(text);
        self.buffer.extend_from_slice(text.as_bytes());
    }

    /// Appends a separator between two words.
    pub fn blank(&mut self) {
        self.buffer.push(b' ');
    }

    /// Appends what sets two cells apart.
    pub fn separator(&mut self, byte: u8) {
        self.buffer.push(byte);
    }

    /// Ends a row of text.
    pub fn end_line(&mut self) -> Result<(), Error> {
        self.buffer.push(b'\n');
        self.end_row()
    }

    /// Counts a row as written.
    pub fn end_row(&mut self) -> Result<(), Error> {
        self.rows_done += 1;
        self.flush_if_full()
    }

    fn flush_if_full(&mut self) -> Result<(), Error> {
        if self.buffer.len() < BUFFER {
            return Ok(());
        }
        self.flush()
    }

    fn flush(&mut self) -> Result<(), Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let written = self
            .sink
            .write_all(&self.buffer)
            .and_then(|()| self.sink.flush());
        written.map_err(|source| Error::Io {
            action: "write",
            file: self.file.to_owned(),
            source,
        })?;
        self.buffer.clear();
        self.watch.progress(
            Phase::Write,
            self.rows_done,
            self.rows_total.max(self.rows_done),
        );
        Ok(())
    }
}
