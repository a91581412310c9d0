//! `cargo run -p delone-web-build --release`: builds the browser module and the page of the theatre around it.
//!
//! 1. [`toolchain`]: a compiler that knows `wasm32-unknown-unknown`: the ordinary one, if need be after
//!    `rustup target add`; else Debian's, which builds the standard library along.
//! 2. [`module`]: the crate `delone-wasm`, its JavaScript and its types, into `web/src/wasm/`; smaller by `wasm-opt`,
//!    if that is here.
//! 3. [`node`], [`page`]: what npm installs and bundles, into `web/dist/`.
//! 4. [`weight`]: sizes, compressed as servers send them, which must keep to budgets.
//! 5. [`theatre`], if it is to be opened: the program, which embeds the page, and its command `theatre`.
//!
//! Whoever builds for the first time needs a network, for crates, packages and perhaps the target.

mod failure;
mod module;
mod node;
mod options;
mod page;
mod place;
mod stale;
mod theatre;
mod toolchain;
mod weight;

use clap::Parser;
use failure::Failure;
use options::Options;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("web-build: {failure}");
            ExitCode::FAILURE
        }
    }
}

/// Does what is asked for, in the order above.
fn run(options: &Options) -> Result<(), Failure> {
    if !options.module_only && options.builds_all() {
        // Said at once, and not after minutes.
        node::require()?;
    }
    module::build(options)?;
    if options.module_only {
        return Ok(());
    }
    page::build(options)?;
    match &options.open {
        Some(file) => theatre::open(file.as_deref()),
        None => Ok(()),
    }
}
