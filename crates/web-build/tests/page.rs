//! The page's own tests, as part of `cargo test`: once it has been built, and where a browser is here.
//!
//! Building it takes minutes and a network; so that is left to `cargo run -p delone-web-build --release`. Where
//! DELONE_NEEDS_PAGE is set it must have been done.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the page.
fn web() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web")
}

/// Tells what is missing, if the tests cannot run.
fn missing() -> Option<String> {
    let browser = env::var("CHROMIUM").unwrap_or_else(|_| "/usr/bin/chromium".to_owned());
    let needs = [
        ("node_modules", "the page has not been built"),
        ("dist/index.html", "the page has not been built"),
        ("src/wasm/delone_bg.wasm", "the module has not been built"),
        (&browser, "there is no Chromium"),
    ];
    let lacking = needs.iter().find(|(path, _)| !web().join(path).exists());
    lacking.map(|(path, why)| format!("{why}: no {path}; see CONTRIBUTING.md"))
}

/// Runs a script of the page's package.
fn npm(script: &str) {
    let status = Command::new("npm")
        .args(["run", "--silent", script])
        .current_dir(web())
        .status();
    let status = status.expect("npm, which has built the page");
    assert!(
        status.success(),
        "npm run {script} failed; the module may be older than its sources: \
         cargo run -p delone-web-build --release -- --module-only"
    );
}

#[test]
fn the_page_passes_its_tests() {
    if let Some(why) = missing() {
        assert!(env::var_os("DELONE_NEEDS_PAGE").is_none(), "{why}");
        eprintln!("skipped: {why}");
        return;
    }
    npm("check");
    npm("build");
    npm("test");
}
