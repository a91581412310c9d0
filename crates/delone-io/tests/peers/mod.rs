//! Programs of others that read what we write, and write what we read.
#![allow(dead_code, reason = "every test file uses a part")]

use std::path::Path;
use std::process::Command;

/// Returns the Python that `DELONE_PYTHON` names, or else `python3`, if it has the modules; says so if not.
pub fn python(modules: &[&str]) -> Option<Command> {
    let named = std::env::var("DELONE_PYTHON");
    let program = named.unwrap_or_else(|_| "python3".to_owned());
    let imports = format!("import {}", modules.join(", "));
    let tried = Command::new(&program).args(["-c", &imports]).output();
    if tried.is_ok_and(|output| output.status.success()) {
        return Some(Command::new(program));
    }
    eprintln!(
        "skipped: {program} has not all of {}; DELONE_PYTHON may name another",
        modules.join(", ")
    );
    None
}

/// Runs a program and returns what it prints; one that fails, fails the test.
pub fn said(program: &mut Command) -> String {
    let output = program.output().expect("it runs");
    let [out, err] =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(output.status.success(), "{out}{err}");
    out
}

/// Runs a script in a folder and returns what it prints, as JSON.
pub fn run(mut python: Command, folder: &Path, script: &str) -> serde_json::Value {
    let text = said(python.current_dir(folder).args(["-c", script]));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text}"))
}
