//! A folder to work in and the program to run there.
#![allow(dead_code, reason = "every test file uses a part")]

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use serde_json::Value;
use std::path::PathBuf;
use tempfile::TempDir;

/// A rectangle, a point inside, and that point once more.
pub const POINTS: &str = "x,y\n0,0\n4,0\n4,3\n0,3\n1,1\n1,1\n";

/// The triangles of [`POINTS`], by hand.
pub const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];

/// The hash of [`TRIANGLES`].
pub fn hash_by_hand() -> String {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)];
    let triangles = TRIANGLES.map(|t| t.map(|v| delone::Point::from(corners[v])));
    delone::hash_triangles(triangles).to_string()
}

/// A temporary folder, gone at the end.
pub struct Folder(TempDir);

impl Folder {
    /// Makes an empty folder.
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    /// Makes a folder with `points.csv` in it.
    pub fn with_points() -> Self {
        let folder = Self::new();
        folder.write("points.csv", POINTS);
        folder
    }

    pub fn path(&self) -> PathBuf {
        self.0.path().to_owned()
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.0.path().join(name), content).expect("the folder is writable");
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Names of all files, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).expect("the folder is there");
        let mut names: Vec<String> = entries
            .map(|e| {
                e.expect("an entry")
                    .file_name()
                    .into_string()
                    .expect("UTF-8")
            })
            .collect();
        names.sort();
        names
    }

    /// The program with arguments split at blanks, in this folder.
    pub fn command(&self, line: &str) -> Command {
        let mut command = Command::cargo_bin("delone").expect("the program is built");
        command.current_dir(self.0.path());
        command.args(line.split_whitespace());
        command
    }

    /// Runs the program and expects an exit code.
    pub fn run(&self, line: &str, code: i32) -> Output {
        Output::of(self.command(line).assert().code(code))
    }
}

/// What a run has said.
pub struct Output {
    pub stdout: String,
    pub stderr: String,
}

impl Output {
    pub fn of(assert: Assert) -> Self {
        let output = assert.get_output();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Self {
            stdout: text(&output.stdout),
            stderr: text(&output.stderr),
        }
    }

    /// The one JSON object on standard output.
    pub fn json(&self) -> Value {
        assert_eq!(self.stdout.lines().count(), 1, "one line: {}", self.stdout);
        serde_json::from_str(&self.stdout).expect("JSON")
    }

    /// Requires words on standard error.
    pub fn says(&self, words: &[&str]) {
        for word in words {
            assert!(
                self.stderr.contains(word),
                "{word:?} not in: {}",
                self.stderr
            );
        }
    }
}
