//! Node.js and its npm, which install and bundle what the page is made of.

use crate::failure::{self, Failure};
use crate::stale::is_fresh;
use std::path::Path;
use std::process::Command;

/// The oldest version that the bundler runs on.
const OLDEST: [u32; 2] = [20, 19];

/// What npm is called.
const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Requires Node.js, recent enough, and npm, and says what is here.
///
/// # Errors
/// If something is not here, or too old.
pub fn require() -> Result<String, Failure> {
    let version = said("node")?;
    if !is_recent(&version) {
        return Err(Failure::NoNode(format!("what is here is {version}")));
    }
    let npm = said(NPM)?;
    Ok(format!("{version}, npm {npm}"))
}

/// Asks a program for its version.
fn said(program: &str) -> Result<String, Failure> {
    let asked = Command::new(program).arg("--version").output();
    match asked {
        Ok(output) if output.status.success() => {
            Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
        }
        _ => Err(Failure::NoNode(format!("no {program} runs here"))),
    }
}

/// Tells whether a version, such as `v20.19.0`, is recent enough.
fn is_recent(version: &str) -> bool {
    let mut numbers = version.trim_start_matches('v').split('.').map(str::parse);
    match [numbers.next(), numbers.next()] {
        [Some(Ok(major)), Some(Ok(minor))] => [major, minor] >= OLDEST,
        _ => false,
    }
}

/// Installs what the lock file names, unless that has been done since it changed.
pub fn install(web: &Path) -> Result<(), Failure> {
    // npm writes this one when all else is there.
    let installed = web.join("node_modules/.package-lock.json");
    let wanted = web.join("package-lock.json");
    if is_fresh(&installed, [wanted.as_path()]) {
        println!("npm ci:    not needed");
        return Ok(());
    }
    npm(web, &["ci"])
}

/// Runs a script of the page's `package.json`.
pub fn script(web: &Path, name: &str) -> Result<(), Failure> {
    npm(web, &["run", name])
}

fn npm(web: &Path, args: &[&str]) -> Result<(), Failure> {
    let line = format!("npm {}", args.join(" "));
    println!("{line}");
    failure::run(Command::new(NPM).args(args).current_dir(web), &line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_as_numbers() {
        for (version, expected) in [
            ("v20.19.0", true),
            ("v20.20.2", true),
            ("v100.1.0", true),
            ("v22.0.0", true),
            ("v20.9.0", false),
            ("v18.30.0", false),
            ("v20", false),
            ("", false),
            ("nonsense", false),
        ] {
            assert_eq!(is_recent(version), expected, "{version}");
        }
    }
}
