//! What a table of times must state: the machine, the compiler, the versions.
//!
//! Everything is read from Linux's `/proc` and `/sys`; elsewhere the entries say `unknown`.

use serde::Serialize;
use std::fs;
use std::process::Command;

/// The conditions of a measurement.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Machine {
    /// Model of the processor.
    pub processor: String,
    /// Hardware threads that this process may use.
    pub threads: usize,
    /// Size of the last-level cache.
    pub last_level_cache: String,
    /// Memory of the machine.
    pub memory: String,
    /// Operating system and kernel version.
    pub kernel: String,
    /// Setting of transparent huge pages.
    pub huge_pages: String,
    /// Load averages when the measurement began.
    pub load: String,
    /// Version of the compiler.
    pub compiler: String,
    /// Target triple, compiler flags and profile.
    pub build: String,
    /// Commit of the working tree, `-dirty` if it has changes.
    pub commit: String,
}

impl Machine {
    /// Asks the system and the build.
    pub fn inspect() -> Self {
        let or_unknown = |found: Option<String>| found.unwrap_or_else(|| "unknown".to_owned());
        Self {
            processor: or_unknown(field("/proc/cpuinfo", "model name")),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            last_level_cache: or_unknown(last_level_cache()),
            memory: or_unknown(field("/proc/meminfo", "MemTotal")),
            kernel: format!(
                "{} {}",
                std::env::consts::OS,
                or_unknown(text("/proc/sys/kernel/osrelease"))
            ),
            huge_pages: or_unknown(
                text("/sys/kernel/mm/transparent_hugepage/enabled").map(|t| chosen(&t)),
            ),
            load: or_unknown(text("/proc/loadavg").map(|t| first_words(&t, 3))),
            compiler: env!("BENCH_RUSTC").to_owned(),
            build: build(),
            commit: or_unknown(commit()),
        }
    }

    /// Returns label and value of every entry, in the order of a report.
    pub fn entries(&self) -> [(&'static str, String); 10] {
        [
            ("Processor", self.processor.clone()),
            ("Hardware threads", self.threads.to_string()),
            ("Last-level cache", self.last_level_cache.clone()),
            ("Memory", self.memory.clone()),
            ("Kernel", self.kernel.clone()),
            ("Transparent huge pages", self.huge_pages.clone()),
            ("Load at the start", self.load.clone()),
            ("Compiler", self.compiler.clone()),
            ("Build", self.build.clone()),
            ("Commit", self.commit.clone()),
        ]
    }
}

/// Returns the version of `package` that this program was built with, from the lock file.
pub fn version_of(package: &str) -> &'static str {
    const LOCK: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.lock"));
    let named = format!("name = \"{package}\"");
    let mut lines = LOCK.lines().skip_while(|line| *line != named).skip(1);
    let version = lines.next().and_then(|line| line.split('"').nth(1));
    version.unwrap_or("unknown")
}

fn build() -> String {
    let flags = match env!("BENCH_RUSTFLAGS") {
        "" => "no RUSTFLAGS",
        flags => flags,
    };
    let profile = if cfg!(debug_assertions) {
        "DEBUG build: the times mean nothing"
    } else {
        "optimised"
    };
    format!("{}, {flags}, {profile}", env!("BENCH_TARGET"))
}

fn commit() -> Option<String> {
    let output = Command::new("git")
        .args(["-C", env!("CARGO_MANIFEST_DIR")])
        .args([
            "describe",
            "--always",
            "--dirty",
            "--abbrev=12",
            "--exclude=*",
        ])
        .output()
        .ok()?;
    let name = String::from_utf8(output.stdout).ok()?;
    (output.status.success()).then(|| name.trim().to_owned())
}

fn text(path: &str) -> Option<String> {
    Some(fs::read_to_string(path).ok()?.trim().to_owned())
}

/// Returns the value of the first `name : value` line.
fn field(path: &str, name: &str) -> Option<String> {
    let text = text(path)?;
    let line = text.lines().find(|line| line.starts_with(name))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

fn last_level_cache() -> Option<String> {
    (0..8)
        .rev()
        .find_map(|i| text(&format!("/sys/devices/system/cpu/cpu0/cache/index{i}/size")))
}

/// Returns what stands in brackets: the kernel marks the setting in force so.
fn chosen(setting: &str) -> String {
    let inside = setting
        .split_once('[')
        .and_then(|(_, rest)| rest.split_once(']'));
    inside.map_or(setting, |(chosen, _)| chosen).to_owned()
}

fn first_words(text: &str, number: usize) -> String {
    let words: Vec<&str> = text.split_whitespace().take(number).collect();
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::{chosen, first_words, version_of};

    #[test]
    fn versions_come_from_the_lock_file() {
        assert!(version_of("spade").starts_with("2."));
        assert!(version_of("delaunator").starts_with("1."));
        assert_eq!(version_of("no-such-crate"), "unknown");
    }

    #[test]
    fn settings_parse() {
        assert_eq!(chosen("always [madvise] never"), "madvise");
        assert_eq!(first_words("0.1 0.2 0.3 1/90 7", 3), "0.1 0.2 0.3");
    }
}
