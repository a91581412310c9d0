//! Finding a compiler that knows the target.

use crate::failure::Failure;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// What is built for.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// How long rustup may take to fetch the target.
const PATIENCE: Duration = Duration::from_secs(180);

/// Debian's compiler, its cargo, and its linker.
const DEBIAN: [&str; 3] = ["/usr/bin/rustc", "/usr/bin/cargo", "/usr/bin/wasm-ld-19"];

/// Which toolchain is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Wanted {
    #[value(name = "auto")]
    Any,
    Usual,
    Debian,
}

/// A way to build.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toolchain {
    /// The compiler of the workspace, with a standard library for the target.
    Usual,
    /// Debian's, which builds the standard library along with the crate.
    Debian,
}

impl Toolchain {
    /// Says which it is.
    pub fn describe(self) -> String {
        let (name, rustc) = match self {
            Self::Usual => ("the usual one", "rustc"),
            Self::Debian => ("Debian's, with its own standard library", DEBIAN[0]),
        };
        let version = Command::new(rustc).arg("--version").output();
        let version = version.map_or_else(|_| Vec::new(), |output| output.stdout);
        format!("{name}: {}", String::from_utf8_lossy(&version).trim())
    }

    /// Prepares `cargo build` for the target, in a folder below `target`.
    pub fn cargo_build(self, target: &Path) -> Command {
        let mut cargo = match self {
            Self::Usual => Command::new("cargo"),
            Self::Debian => Command::new(DEBIAN[1]),
        };
        cargo.args(["build", "--target", TARGET]);
        match self {
            Self::Usual => {
                cargo.arg("--target-dir").arg(target);
            }
            Self::Debian => {
                // Another compiler: what it builds must not lie among what the usual one builds.
                cargo.arg("--target-dir").arg(target.join("debian-web"));
                cargo.arg("-Zbuild-std=std,panic_abort");
                cargo.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", DEBIAN[0]);
                cargo.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", DEBIAN[2]);
                // Whoever runs this program by cargo has these set, for the usual one.
                for name in ["RUSTUP_TOOLCHAIN", "RUSTC_WRAPPER", "CARGO"] {
                    cargo.env_remove(name);
                }
            }
        }
        cargo
    }

    /// Returns the folder of the target in which it builds.
    pub fn output(self, target: &Path) -> std::path::PathBuf {
        match self {
            Self::Usual => target.join(TARGET),
            Self::Debian => target.join("debian-web").join(TARGET),
        }
    }
}

/// Finds a toolchain.
///
/// # Errors
/// If the one that is wanted is not here.
pub fn find(wanted: Wanted) -> Result<Toolchain, Failure> {
    let wants = |one| wanted == Wanted::Any || wanted == one;
    if wants(Wanted::Usual) && (has_library() || (add_target() && has_library())) {
        return Ok(Toolchain::Usual);
    }
    let is_debian = DEBIAN.iter().all(|path| Path::new(path).exists());
    match wants(Wanted::Debian) && is_debian {
        true => Ok(Toolchain::Debian),
        false => Err(Failure::NoToolchain),
    }
}

/// Tells whether the usual compiler has a standard library for the target.
fn has_library() -> bool {
    let asked = Command::new("rustc")
        .args(["--print", "target-libdir", "--target", TARGET])
        .output();
    asked.is_ok_and(|answer| {
        let folder = String::from_utf8_lossy(&answer.stdout);
        answer.status.success() && Path::new(folder.trim()).is_dir()
    })
}

/// Asks rustup for the target, and does not wait for ever.
fn add_target() -> bool {
    println!("rustup target add {TARGET}");
    let rustup = Command::new("rustup")
        .args(["target", "add", TARGET])
        .stdin(Stdio::null())
        .spawn();
    rustup.is_ok_and(ends_well)
}

fn ends_well(mut child: Child) -> bool {
    let begin = Instant::now();
    while begin.elapsed() < PATIENCE {
        match child.try_wait() {
            Ok(Some(status)) => return status.success(),
            Ok(None) => std::thread::sleep(Duration::from_millis(100)),
            Err(_) => break,
        }
    }
    drop(child.kill());
    drop(child.wait());
    false
}
