//! The module: compiled, bound to JavaScript, made smaller.

use crate::toolchain::Toolchain;
use crate::{Failure, root};
use std::path::{Path, PathBuf};
use std::process::Command;
use wasm_bindgen_cli_support::Bindgen;

/// The crate, and what Cargo makes of its name.
const CRATE: &str = "delone-wasm";
const FILE: &str = "delone_wasm.wasm";

/// The profile of the workspace's manifest.
const PROFILE: &str = "module";

/// What the JavaScript files are called.
const NAME: &str = "delone";

/// What compilers of today use of the format, and `wasm-opt` has to be told.
const FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// The oldest `wasm-opt` that is used. 108, which is Debian 12's, mixes up the two tables of the module: it can
/// not be loaded afterwards.
const OLDEST: u32 = 116;

/// Compiles the crate and returns where it is.
pub fn compile(toolchain: &Toolchain) -> Result<PathBuf, Failure> {
    let root = root();
    let target = root.join("target");
    let mut cargo = toolchain.cargo_build(&target);
    cargo.args(["--package", CRATE, "--profile", PROFILE, "--locked"]);
    run(cargo.current_dir(&root), "cargo build")?;
    Ok(toolchain.output(&target).join(PROFILE).join(FILE))
}

/// Writes the module with its JavaScript and its types, and returns where the module is.
pub fn bind(compiled: &Path, out: &Path) -> Result<PathBuf, Failure> {
    let refused = |error| Failure::Bindings(format!("{error:#}"));
    std::fs::create_dir_all(out).map_err(|source| Failure::File {
        action: "cannot create",
        path: out.to_owned(),
        source,
    })?;
    let mut bindings = Bindgen::new();
    bindings
        .input_path(compiled)
        .out_name(NAME)
        .typescript(true)
        .omit_default_module_path(false)
        .remove_name_section(true)
        .remove_producers_section(true);
    bindings
        .web(true)
        .map_err(refused)?
        .generate(out)
        .map_err(refused)?;
    Ok(out.join(format!("{NAME}_bg.wasm")))
}

/// Makes the module smaller, or says why not; then it is as it was.
pub fn optimise(module: &Path) -> Result<(), String> {
    require_recent()?;
    let smaller = module.with_extension("opt");
    let mut command = Command::new("wasm-opt");
    command
        .arg("-Os")
        .args(FEATURES)
        .arg(module)
        .arg("-o")
        .arg(&smaller);
    let done = command.output().map_err(|error| error.to_string())?;
    if !done.status.success() {
        drop(std::fs::remove_file(&smaller));
        let said = String::from_utf8_lossy(&done.stderr);
        return Err(said.lines().next().unwrap_or("it failed").to_owned());
    }
    std::fs::rename(&smaller, module).map_err(|error| error.to_string())
}

/// Refuses a `wasm-opt` that is not here, or too old.
fn require_recent() -> Result<(), String> {
    let asked = Command::new("wasm-opt").arg("--version").output();
    let said = asked.map_err(|error| error.to_string())?.stdout;
    let said = String::from_utf8_lossy(&said);
    let mut numbers = said.split_whitespace().map(str::parse::<u32>);
    match numbers.find_map(Result::ok) {
        Some(version) if version >= OLDEST => Ok(()),
        _ => Err(format!("{} is older than {OLDEST}", said.trim())),
    }
}

fn run(command: &mut Command, name: &str) -> Result<(), Failure> {
    let status = command.status().map_err(|source| Failure::Start {
        program: name.to_owned(),
        source,
    })?;
    match status.success() {
        true => Ok(()),
        false => Err(Failure::Program(name.to_owned())),
    }
}
