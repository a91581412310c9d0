//! The program with the page in it, built and run.

use crate::failure::Failure;
use crate::place::root;
use std::path::Path;
use std::process::Command;

/// Builds `delone`, which embeds the page, and has it open the theatre.
///
/// Where systems can, this process becomes that one: so Ctrl-C is for nobody else.
pub fn open(file: Option<&Path>) -> Result<(), Failure> {
    let mut cargo = Command::new("cargo");
    cargo.args(["run", "--release", "--locked", "--package", "delone-cli"]);
    // From the folder of whoever asks, for FILE is meant from there.
    cargo.arg("--manifest-path").arg(root().join("Cargo.toml"));
    cargo.args(["--", "theatre"]).args(file);
    println!("cargo run --release -p delone-cli -- theatre");
    become_it(&mut cargo)
}

#[cfg(unix)]
fn become_it(cargo: &mut Command) -> Result<(), Failure> {
    let source = std::os::unix::process::CommandExt::exec(cargo);
    Err(Failure::Start {
        program: "cargo run".to_owned(),
        source,
    })
}

#[cfg(not(unix))]
fn become_it(cargo: &mut Command) -> Result<(), Failure> {
    crate::failure::run(cargo, "delone theatre")
}
