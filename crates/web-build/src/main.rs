//! `cargo run -p delone-web-build --release`: builds the browser module into `web/src/wasm/`.
//!
//! 1. [`toolchain`]: a compiler that knows `wasm32-unknown-unknown`: the ordinary one, if need be after
//!    `rustup target add`; else Debian's, which builds the standard library along.
//! 2. [`module`]: the crate `delone-wasm`, its JavaScript and its types; smaller by `wasm-opt`, if that is here.
//! 3. Its size, compressed as servers send it, which must keep to a budget.
//!
//! Whoever builds for the first time needs a network, for crates and perhaps the target.

mod module;
mod toolchain;

use flate2::{Compression, write::GzEncoder};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use toolchain::Wanted;

/// Bytes that the compressed module may have.
const BUDGET: usize = 1_500_000;

const USAGE: &str = "\
usage: delone-web-build [--toolchain auto|usual|debian] [--no-opt] [--out FOLDER]
Builds the browser module into web/src/wasm, or into FOLDER.";

/// What went wrong.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error("{0}\n{USAGE}")]
    Usage(String),
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
    #[error("wasm-bindgen: {0}")]
    Bindings(String),
    #[error("{0} bytes compressed are more than the budget of {BUDGET}")]
    TooLarge(usize),
}

/// What was asked for.
struct Options {
    wanted: Wanted,
    optimises: bool,
    out: PathBuf,
}

impl Options {
    fn parse(mut args: impl Iterator<Item = String>) -> Result<Self, Failure> {
        let mut options = Self {
            wanted: Wanted::Any,
            optimises: true,
            out: root().join("web/src/wasm"),
        };
        while let Some(arg) = args.next() {
            let mut value = || {
                let value = args.next();
                value.ok_or_else(|| Failure::Usage(format!("{arg} needs a value")))
            };
            match arg.as_str() {
                "--toolchain" => options.wanted = Wanted::named(&value()?)?,
                "--no-opt" => options.optimises = false,
                "--out" => options.out = value()?.into(),
                _ => return Err(Failure::Usage(format!("unknown argument {arg}"))),
            }
        }
        Ok(options)
    }
}

fn main() -> ExitCode {
    let done = Options::parse(std::env::args().skip(1)).and_then(|options| build(&options));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("web-build: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn build(options: &Options) -> Result<(), Failure> {
    let toolchain = toolchain::find(options.wanted)?;
    println!("toolchain: {}", toolchain.describe());
    let compiled = module::compile(&toolchain)?;
    println!("compiled:  {} bytes", read(&compiled)?.len());
    let module = module::bind(&compiled, &options.out)?;
    println!("bound:     {} bytes", read(&module)?.len());
    match options.optimises.then(|| module::optimise(&module)) {
        Some(Ok(())) => println!("wasm-opt:  {} bytes", read(&module)?.len()),
        Some(Err(why)) => println!("wasm-opt:  not used: {why}"),
        None => println!("wasm-opt:  not wanted"),
    }
    let compressed = compressed(&read(&module)?);
    println!("gzip:      {compressed} bytes of at most {BUDGET}");
    println!("written:   {}", options.out.display());
    match compressed > BUDGET {
        true => Err(Failure::TooLarge(compressed)),
        false => Ok(()),
    }
}

/// The folder of the workspace.
fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here).to_owned()
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(|source| Failure::File {
        action: "cannot read",
        path: path.to_owned(),
        source,
    })
}

/// Counts the bytes that a server sends.
fn compressed(bytes: &[u8]) -> usize {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.expect("bug: memory takes every byte").len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(args: &[&str]) -> Result<Options, Failure> {
        Options::parse(args.iter().map(|&arg| arg.to_owned()))
    }

    #[test]
    fn options_are_read() {
        let options = parse(&["--toolchain", "debian", "--no-opt", "--out", "x"]).expect("options");
        assert_eq!(options.wanted, Wanted::Debian);
        assert_eq!(
            (options.optimises, options.out),
            (false, PathBuf::from("x"))
        );
        let usual = parse(&[]).expect("no options");
        assert!(usual.out.ends_with("web/src/wasm"));
        for bad in [&["--out"][..], &["--toolchain", "other"], &["x"]] {
            parse(bad).err().expect("a refusal");
        }
    }

    #[test]
    fn sizes_are_those_of_compressed_bytes() {
        assert!(compressed(&[0; 100_000]) < 1000);
    }
}
