//! Records what the bench table must state about its own build: compiler and flags.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rustc-env=BENCH_RUSTC={}", compiler_version());
    println!("cargo::rustc-env=BENCH_RUSTFLAGS={}", rustflags());
    println!(
        "cargo::rustc-env=BENCH_TARGET={}",
        env::var("TARGET").unwrap_or_default()
    );
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
}

fn compiler_version() -> String {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    Command::new(rustc)
        .arg("--version")
        .output()
        .map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
        .unwrap_or_else(|_| "unknown".to_owned())
}

/// Cargo separates the flags by the unit separator, 0x1f.
fn rustflags() -> String {
    env::var("CARGO_ENCODED_RUSTFLAGS")
        .unwrap_or_default()
        .replace('\x1f', " ")
}
