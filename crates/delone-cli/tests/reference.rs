//! `docs/reference` is what the program says of its commands, and lists them all.
//!
//! Run with `DELONE_BLESS=1` to write the pages, and their part of `docs/SUMMARY.md`, anew, and read the difference.

mod support;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use support::{Folder, Output};

/// How lines of the summary begin that lead to commands.
const ENTRY: &str = "  - [`delone ";

/// A command of the program.
struct Command {
    /// How it is called, as `algorithms run`.
    name: String,
    /// What it says of itself.
    help: String,
    /// Its commands, in the order of the help.
    inner: Vec<Command>,
}

impl Command {
    fn of(folder: &Folder, name: &str) -> Self {
        let mut command = folder.command(&format!("{name} --help"));
        let help = Output::of(command.env("COLUMNS", "100").assert().code(0)).stdout;
        let inner = names(&help)
            .map(|inner| Self::of(folder, format!("{name} {inner}").trim_start()))
            .collect();
        let name = name.to_owned();
        Self { name, help, inner }
    }

    fn file(&self) -> String {
        format!("{}.md", self.name.replace(' ', "-"))
    }

    /// The first line of the help, for lists.
    fn summary(&self) -> &str {
        self.help.lines().next().expect("a summary")
    }

    /// Its page: what it says, and then what its commands say.
    fn page(&self) -> String {
        let mut page = format!("# delone {}\n\n{}.\n", self.name, self.summary());
        self.write_help(&mut page);
        for inner in &self.inner {
            write!(page, "\n## delone {}\n", inner.name).expect("memory");
            inner.write_help(&mut page);
        }
        page
    }

    fn write_help(&self, page: &mut String) {
        let help = self.help.lines().map(str::trim_end);
        let help: Vec<&str> = help.collect();
        let help = help.join("\n");
        write!(page, "\n```text\n{}\n```\n", help.trim_end()).expect("memory");
    }
}

/// The names below the heading of commands in a help text, but for `help` itself.
fn names(help: &str) -> impl Iterator<Item = &str> {
    let lines = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty());
    lines
        .filter_map(|line| line.strip_prefix("  "))
        .filter(|line| !line.starts_with(' '))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
}

/// All pages by name.
fn pages(program: &Command) -> BTreeMap<String, String> {
    let mut list = String::from(
        "# Commands\n\nWhat `delone COMMAND --help` prints, page by page; `delone COMMAND -h` is shorter. \
         The program writes these pages itself.\n\n| command | |\n|---|---|\n",
    );
    for command in &program.inner {
        let (name, file, summary) = (&command.name, command.file(), command.summary());
        writeln!(list, "| [`delone {name}`]({file}) | {summary} |").expect("memory");
    }
    list += "\n## delone\n";
    program.write_help(&mut list);
    let mut pages: BTreeMap<String, String> = program
        .inner
        .iter()
        .map(|command| (command.file(), command.page()))
        .collect();
    pages.insert("README.md".to_owned(), list);
    pages
}

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The names of the pages that are there.
fn present() -> Vec<String> {
    let entries = std::fs::read_dir(docs().join("reference")).expect("the folder is there");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("an entry").file_name())
        .map(|name| name.into_string().expect("UTF-8"))
        .collect();
    names.sort();
    names
}

/// The summary with the entries of these commands where such entries stand.
fn summary_with(summary: &str, program: &Command) -> String {
    let is_entry = |line: &&str| line.starts_with(ENTRY);
    let place = summary
        .lines()
        .position(|line| line.ends_with("(reference/README.md)"))
        .expect("the summary lists the reference");
    let lines: Vec<&str> = summary.lines().collect();
    let (before, after) = lines.split_at(place + 1);
    let mut text = before.join("\n");
    for command in &program.inner {
        let (name, file) = (&command.name, command.file());
        write!(text, "\n{ENTRY}{name}`](reference/{file})").expect("memory");
    }
    for line in after.iter().skip_while(|line| is_entry(line)) {
        write!(text, "\n{line}").expect("memory");
    }
    text + "\n"
}

#[test]
fn the_pages_of_commands_are_what_the_program_says() {
    let program = Command::of(&Folder::new(), "");
    assert!(program.inner.len() > 15, "the list of commands is found");
    let pages = pages(&program);
    let summary = docs().join("SUMMARY.md");
    let listed = summary_with(&read(&summary), &program);
    if std::env::var_os("DELONE_BLESS").is_some() {
        for name in present() {
            std::fs::remove_file(docs().join("reference").join(name)).expect("it can be removed");
        }
        for (name, text) in &pages {
            std::fs::write(docs().join("reference").join(name), text).expect("it can be written");
        }
        std::fs::write(&summary, &listed).expect("the summary can be written");
    }
    let advice = "DELONE_BLESS=1 writes it anew";
    assert!(
        present().iter().eq(pages.keys()),
        "docs/reference has the page of each command and no other: {advice}"
    );
    for (name, text) in &pages {
        let there = read(&docs().join("reference").join(name));
        assert!(
            there == *text,
            "docs/reference/{name} is not what the program says: {advice}"
        );
    }
    assert!(
        read(&summary) == listed,
        "docs/SUMMARY.md does not list every command: {advice}"
    );
}
