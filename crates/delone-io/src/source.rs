//! Where input comes from: a file, standard input, or memory.

use crate::{Error, MemoryFile};
use delone::Watch;
use std::borrow::Cow;
use std::ffi::OsStr;
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Arc, mpsc};
use std::time::Duration;

/// Bytes asked of the operating system at once; small enough to answer cancellation in time.
const CHUNK: usize = 1 << 20;

/// Where input comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Source {
    /// A file.
    Path(PathBuf),
    /// Standard input.
    Stdin,
    /// Bytes in memory, with a name for messages; its extension tells the format as a file's would.
    Memory {
        /// The name.
        name: String,
        /// The content.
        bytes: Vec<u8>,
    },
    /// One of several files in memory, which lie beside each other as in a folder.
    Together {
        /// The files.
        files: Arc<[MemoryFile]>,
        /// Which of them is read, from 0; none if there is no such file.
        opened: usize,
    },
}

impl Source {
    /// Makes a source from a command-line argument: `-` is standard input.
    pub fn from_arg(arg: impl AsRef<OsStr>) -> Self {
        match arg.as_ref() {
            dash if dash == "-" => Self::Stdin,
            path => Self::Path(path.into()),
        }
    }

    /// Returns the path, if this is a file or a name like one.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            Self::Path(path) => Some(path),
            Self::Stdin => None,
            Self::Memory { name, .. } => Some(Path::new(name)),
            Self::Together { files, opened } => files.get(*opened).map(|file| &*file.name),
        }
    }

    /// Returns the file of the same stem with another extension; `alone` is the error if this source never has
    /// neighbours.
    pub(crate) fn beside(
        &self,
        extension: &str,
        alone: impl FnOnce() -> Error,
    ) -> Result<Self, Error> {
        let Some(path) = self.path() else {
            return Err(alone());
        };
        let needed = path.with_extension(extension);
        match self {
            Self::Path(_) => Ok(Self::Path(needed)),
            Self::Together { files, .. } => find(files, &needed).ok_or_else(|| Error::Alone {
                file: self.to_string(),
                needed: needed.display().to_string(),
            }),
            _ => Err(alone()),
        }
    }

    /// Returns the file of the same stem with another extension, if there is one.
    pub(crate) fn beside_if_any(&self, extension: &str) -> Option<Self> {
        let path = self.path()?.with_extension(extension);
        match self {
            Self::Path(_) => path.is_file().then_some(Self::Path(path)),
            Self::Together { files, .. } => find(files, &path),
            _ => None,
        }
    }

    /// Reads everything into memory.
    pub(crate) fn load(&self, watch: &dyn Watch) -> Result<Cow<'_, [u8]>, Error> {
        let content = match self {
            Self::Path(path) => load_file(path, watch),
            Self::Stdin => drain(io::stdin(), watch),
            Self::Memory { bytes, .. } => return Ok(Cow::Borrowed(bytes)),
            Self::Together { files, opened } => match files.get(*opened) {
                Some(file) => return Ok(Cow::Borrowed(&file.bytes)),
                None => Err(io::ErrorKind::NotFound.into()),
            },
        };
        match content {
            Ok(Some(bytes)) => Ok(Cow::Owned(bytes)),
            Ok(None) => Err(Error::Cancelled),
            Err(source) => Err(Error::Io {
                action: "read",
                file: self.to_string(),
                source,
            }),
        }
    }
}

/// Finds a file by its name; case does not matter, as on the disks that such files mostly come from.
fn find(files: &Arc<[MemoryFile]>, name: &Path) -> Option<Source> {
    let is_wanted = |file: &MemoryFile| file.name.as_os_str().eq_ignore_ascii_case(name);
    let opened = files.iter().position(is_wanted)?;
    Some(Source::Together {
        files: Arc::clone(files),
        opened,
    })
}

/// Reads a file; `None` means cancelled.
fn load_file(path: &Path, watch: &dyn Watch) -> io::Result<Option<Vec<u8>>> {
    let mut file = File::open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !metadata.is_file() {
        return drain(file, watch);
    }
    let mut bytes = Vec::new();
    let size = usize::try_from(metadata.len()).unwrap_or(usize::MAX);
    bytes.try_reserve_exact(size)?;
    while (&mut file).take(CHUNK as u64).read_to_end(&mut bytes)? > 0 {
        if watch.is_cancelled() {
            return Ok(None);
        }
    }
    Ok(Some(bytes))
}

/// Reads from something that may keep us waiting, a pipe or a terminal, in a thread of its own, so
/// that cancellation need not wait for the other side. A cancelled thread ends with its next chunk.
fn drain(mut input: impl Read + Send + 'static, watch: &dyn Watch) -> io::Result<Option<Vec<u8>>> {
    let (sender, receiver) = mpsc::sync_channel(4);
    std::thread::Builder::new().spawn(move || {
        loop {
            let mut chunk = Vec::new();
            let read = (&mut input).take(CHUNK as u64).read_to_end(&mut chunk);
            let done = !matches!(read, Ok(n) if n > 0);
            if sender.send(read.map(|_| chunk)).is_err() || done {
                return;
            }
        }
    })?;
    let mut bytes = Vec::new();
    loop {
        match receiver.recv_timeout(Duration::from_millis(20)) {
            Ok(chunk) => bytes.append(&mut chunk?),
            Err(mpsc::RecvTimeoutError::Timeout) => {}
            Err(mpsc::RecvTimeoutError::Disconnected) => return Ok(Some(bytes)),
        }
        if watch.is_cancelled() {
            return Ok(None);
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Path(path) => path.display().fmt(f),
            Self::Stdin => f.write_str("-"),
            Self::Memory { name, .. } => f.write_str(name),
            Self::Together { files, opened } => match files.get(*opened) {
                Some(file) => file.name.display().fmt(f),
                None => f.write_str("-"),
            },
        }
    }
}
