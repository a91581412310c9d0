//! The module: compiled, bound to JavaScript, made smaller.

use crate::failure::{Failure, run};
use crate::options::Options;
use crate::place::root;
use crate::stale::is_fresh;
use crate::toolchain::{self, Toolchain};
use crate::weight::{Budget, read};
use std::path::{Path, PathBuf};
use std::process::Command;
use wasm_bindgen_cli_support::Bindgen;

/// What the module may weigh.
const BUDGET: Budget = Budget {
    what: "module",
    bytes: 1_500_000,
};

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

/// Builds the module; if the theatre is to be opened, only if it is stale.
pub fn build(options: &Options) -> Result<(), Failure> {
    let toolchain = toolchain::find(options.toolchain)?;
    println!("toolchain: {}", toolchain.describe());
    let compiled = compile(&toolchain)?;
    println!("compiled:  {} bytes", read(&compiled)?.len());
    let out = options.module_folder();
    let module = module(&out);
    if !options.builds_all() && is_fresh(&module, [compiled.as_path()]) {
        println!("module:    up to date");
    } else {
        bind(&compiled, &out)?;
        println!("bound:     {} bytes", read(&module)?.len());
        match (!options.no_opt).then(|| optimise(&module)) {
            Some(Ok(())) => println!("wasm-opt:  {} bytes", read(&module)?.len()),
            Some(Err(why)) => println!("wasm-opt:  not used: {why}"),
            None => println!("wasm-opt:  not wanted"),
        }
    }
    BUDGET.weigh([module.as_path()])?;
    println!("written:   {}", out.display());
    Ok(())
}

/// Returns where the module is written.
fn module(out: &Path) -> PathBuf {
    out.join(format!("{NAME}_bg.wasm"))
}

/// Compiles the crate and returns where it is.
fn compile(toolchain: &Toolchain) -> Result<PathBuf, Failure> {
    let root = root();
    let target = root.join("target");
    let mut cargo = toolchain.cargo_build(&target);
    cargo.args(["--package", CRATE, "--profile", PROFILE, "--locked"]);
    run(cargo.current_dir(&root), "cargo build")?;
    Ok(toolchain.output(&target).join(PROFILE).join(FILE))
}

/// Writes the module with its JavaScript and its types.
fn bind(compiled: &Path, out: &Path) -> Result<(), Failure> {
    let refused = |error| Failure::Bindings(format!("{error:#}"));
    std::fs::create_dir_all(out).map_err(Failure::file("cannot create", out))?;
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
        .map_err(refused)
}

/// Makes the module smaller, or says why not; then it is as it was.
fn optimise(module: &Path) -> Result<(), String> {
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
