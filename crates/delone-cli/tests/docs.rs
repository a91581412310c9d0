//! The pages of `docs`: links lead somewhere, the summary lists every page, and what tutorials tell readers to type works
//! and says what they say it does.

mod support;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

/// Texts outside of `docs` that readers come by.
const OUTSIDE: [&str; 7] = [
    "README.md",
    "BENCHMARKS.md",
    "REFERENCES.md",
    "CHANGELOG.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "fuzz/README.md",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// The names of all pages below a folder, from the root on.
fn pages_below(folder: &str) -> Vec<String> {
    let mut pages = Vec::new();
    for entry in std::fs::read_dir(root().join(folder)).expect("a folder") {
        let entry = entry.expect("an entry");
        let name = format!("{folder}/{}", entry.file_name().to_str().expect("UTF-8"));
        if entry.file_type().expect("a type").is_dir() {
            pages.extend(pages_below(&name));
        } else if name.ends_with(".md") {
            pages.push(name);
        }
    }
    pages.sort();
    pages
}

fn events(text: &str) -> impl Iterator<Item = Event<'_>> {
    let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    Parser::new_ext(text, options)
}

/// Addresses of links and pictures.
fn links(text: &str) -> Vec<String> {
    let addresses = events(text).filter_map(|event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
            Some(dest_url.into_string())
        }
        _ => None,
    });
    addresses.collect()
}

/// What links call the headings of a text.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut anchors = BTreeSet::new();
    let mut heading: Option<String> = None;
    for event in events(text) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::Text(part) | Event::Code(part) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&part);
                }
            }
            Event::End(TagEnd::Heading(_)) => {
                let heading = heading.take().expect("it has begun").to_lowercase();
                let anchor: String = heading
                    .chars()
                    .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
                    .map(|c| if c == ' ' { '-' } else { c })
                    .collect();
                let again = (1..).map(|n| format!("{anchor}-{n}"));
                let mut names = std::iter::once(anchor.clone()).chain(again);
                anchors.insert(names.find(|n| !anchors.contains(n)).expect("one is free"));
            }
            _ => {}
        }
    }
    anchors
}

/// Follows a path from the folder of a page.
fn resolved(page: &str, path: &str) -> PathBuf {
    let mut place = Path::new(page).parent().expect("a folder").to_owned();
    for part in Path::new(path).components() {
        match part {
            Component::ParentDir => assert!(place.pop(), "{page}: {path} leaves the repository"),
            other => place.push(other),
        }
    }
    place
}

/// Says what is wrong with a link of a page; links to other sites are not followed.
fn fault(page: &str, link: &str) -> Option<String> {
    let has_scheme = ["https:", "http:", "mailto:"]
        .iter()
        .any(|s| link.starts_with(s));
    if has_scheme {
        return None;
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = match path {
        "" => PathBuf::from(page),
        path => resolved(page, path),
    };
    if !root().join(&target).exists() {
        return Some(format!("{page}: {link}: there is no {}", target.display()));
    }
    let name = target.to_str().expect("UTF-8");
    let lost = !anchor.is_empty() && !anchors(&read(name)).contains(anchor);
    lost.then(|| format!("{page}: {link}: no such heading"))
}

#[test]
fn every_link_leads_somewhere() {
    let mut faults = Vec::new();
    let mut count = 0;
    let outside = OUTSIDE.map(str::to_owned);
    for page in pages_below("docs").into_iter().chain(outside) {
        for link in links(&read(&page)) {
            count += 1;
            faults.extend(fault(&page, &link));
        }
    }
    assert!(count > 100, "links are found: {count}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn faults_of_links_are_found() {
    let page = "docs/faq.md";
    assert_eq!(fault(page, "formats.md#ply"), None);
    assert_eq!(fault(page, "../README.md#two-commands"), None);
    assert!(fault(page, "formats.md#docx").is_some());
    assert!(fault(page, "nowhere.md").is_some());
    assert!(fault(page, "#nowhere").is_some());
}

#[test]
fn the_summary_lists_every_page_once() {
    let summary = read("docs/SUMMARY.md");
    let mut listed: BTreeMap<String, usize> = BTreeMap::new();
    for link in links(&summary) {
        *listed.entry(format!("docs/{link}")).or_default() += 1;
    }
    for page in pages_below("docs") {
        let expected = usize::from(page != "docs/SUMMARY.md");
        let times = listed.remove(&page).unwrap_or(0);
        assert_eq!(times, expected, "docs/SUMMARY.md lists {page} so often");
    }
    assert!(listed.is_empty(), "there are no {listed:?}");
}

#[test]
fn the_book_brings_the_texts_that_pages_link_to() {
    let book = read("docs/book.toml");
    for text in OUTSIDE {
        assert!(
            book.contains(&format!("\"{text}\"")),
            "docs/book.toml: {text}"
        );
    }
}

/// Says what a line for the shell names that the page of its command does not have.
fn misnamed(line: &str) -> Vec<String> {
    let line = line.split(" # ").next().expect("a beginning");
    let mut words = line.split_whitespace().skip(1).peekable();
    let command = words.next_if(|w| w.starts_with(|c: char| c.is_ascii_lowercase()));
    let page = match command {
        Some("help") => return Vec::new(),
        Some(name) => format!("docs/reference/{name}.md"),
        None => "docs/reference/README.md".to_owned(),
    };
    let Ok(page) = std::fs::read_to_string(root().join(page)) else {
        return vec![format!("there is no command: {line}")];
    };
    let options = words
        .take_while(|word| !["|", "||", "&&", ">"].contains(word))
        .filter(|word| word.starts_with("--") && word.len() > 2)
        .map(|word| word.split(['=', '[']).next().expect("a beginning"));
    let known: BTreeSet<&str> = page
        .split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'))
        .collect();
    let missing = options.filter(|option| !known.contains(option));
    missing
        .map(|o| format!("there is no {o}: {line}"))
        .collect()
}

#[test]
fn pages_name_commands_and_options_that_there_are() {
    let mut faults = Vec::new();
    let mut count = 0;
    let pages = pages_below("docs").into_iter();
    let readme = std::iter::once("README.md".to_owned());
    for page in pages
        .filter(|page| !page.starts_with("docs/reference/"))
        .chain(readme)
    {
        let text = read(&page);
        let mut lines: Vec<String> = events(&text)
            .filter_map(|event| match event {
                Event::Code(code) => Some(code.into_string()),
                _ => None,
            })
            .collect();
        for block in blocks(&text).iter().filter(|block| block.language == "sh") {
            lines.extend(block.text.lines().map(str::to_owned));
        }
        for line in lines.iter().filter(|line| line.starts_with("delone ")) {
            count += 1;
            faults.extend(misnamed(line).into_iter().map(|f| format!("{page}: {f}")));
        }
    }
    assert!(count > 100, "lines are found: {count}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert_eq!(
        misnamed("delone mesh a.poly --max-edge 1 --to=vtu").len(),
        0
    );
    assert_eq!(misnamed("delone mesh a.poly --max-corner 1").len(), 1);
    assert_eq!(misnamed("delone meshes a.poly").len(), 1);
}

/// A block of code of a page.
struct Block {
    language: String,
    text: String,
}

fn blocks(text: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut is_in_code = false;
    for event in events(text) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                is_in_code = true;
                let language = language.into_string();
                blocks.push(Block {
                    language,
                    text: String::new(),
                });
            }
            Event::Text(part) if is_in_code => {
                let block = blocks.last_mut().expect("it has begun");
                block.text.push_str(&part);
            }
            Event::End(TagEnd::CodeBlock) => is_in_code = false,
            _ => {}
        }
    }
    blocks
}

/// Pages whose lines for the shell run from top to bottom, in one folder.
#[cfg(unix)]
const TOLD: [&str; 5] = [
    "docs/start.md",
    "docs/tutorials/elements.md",
    "docs/tutorials/maps.md",
    "docs/tutorials/students.md",
    "docs/exactness.md",
];

/// Lines that are not tried: they install, or serve until they are stopped.
#[cfg(unix)]
const UNTRIED: [&str; 3] = ["cargo ", "pip ", "delone theatre"];

#[cfg(unix)]
mod told {
    use super::{Block, TOLD, UNTRIED, blocks, read, root};
    use crate::support::Folder;
    use std::path::Path;
    use std::process::Command;

    /// A Python that has SciPy, if there is one to try.
    fn python() -> Option<String> {
        std::env::var("DELONE_PYTHON").ok()
    }

    /// The lines of a block that are tried.
    fn script(block: &Block) -> String {
        let is_tried = |line: &&str| !UNTRIED.iter().any(|begin| line.starts_with(begin));
        let lines: Vec<&str> = block.text.lines().filter(is_tried).collect();
        lines.join("\n")
    }

    /// Runs a script of the shell in a folder; returns all that it says.
    fn said(folder: &Folder, page: &str, script: &str) -> String {
        let program = assert_cmd::cargo::cargo_bin("delone");
        let programs = program.parent().expect("a folder").display();
        let path = std::env::var("PATH").unwrap_or_default();
        let output = Command::new("sh")
            .args(["-e", "-c", &format!("exec 2>&1\n{script}")])
            .env("PATH", format!("{programs}:{path}"))
            .env("COLUMNS", "100")
            .current_dir(folder.path())
            .output()
            .expect("a shell");
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{page}:\n{script}\n{said}");
        said
    }

    /// Tells whether a page quotes a line; `…` stands for its rest.
    fn is_quoted(quote: &str, line: &str) -> bool {
        match quote.split_once('…') {
            Some((begin, rest)) => rest.is_empty() && line.starts_with(begin),
            None => quote == line,
        }
    }

    fn copy_folder(name: &str, to: &Path) {
        std::fs::create_dir_all(to).expect("a folder");
        for entry in std::fs::read_dir(root().join(name)).expect("a folder") {
            let entry = entry.expect("an entry");
            if entry.file_type().expect("a type").is_file() {
                std::fs::copy(entry.path(), to.join(entry.file_name())).expect("a copy");
            }
        }
    }

    /// Python's files begin with a comment that is their name. A block of text that follows one for the shell is part of
    /// what that says, line by line. Where there is no Python with SciPy, a page is
    /// tried up to its first line for it.
    fn try_page(page: &str) {
        let folder = Folder::new();
        for data in ["queries", "doctor"] {
            copy_folder(&format!("docs/{data}"), &folder.path().join(data));
        }
        let python = python();
        let blocks = blocks(&read(page));
        let mut tried = 0;
        for (i, block) in blocks.iter().enumerate() {
            match block.language.as_str() {
                "python" => {
                    let name = block.text.lines().next().and_then(|l| l.strip_prefix("# "));
                    folder.write(name.expect("the name of the file"), &block.text);
                }
                "sh" => {
                    let mut script = script(block);
                    if script.contains("python3 ") {
                        let Some(python) = &python else { break };
                        script = script.replace("python3 ", &format!("{python} "));
                    }
                    let said = said(&folder, page, &script);
                    tried += script.lines().filter(|l| l.contains("delone ")).count();
                    let answer = blocks.get(i + 1).filter(|b| b.language == "text");
                    let Some(answer) = answer else { continue };
                    for line in answer.text.lines() {
                        let is_said = said.lines().any(|said| is_quoted(line.trim(), said.trim()));
                        assert!(
                            is_said,
                            "{page} quotes {line:?}, but the program says:\n{said}"
                        );
                    }
                }
                _ => {}
            }
        }
        assert!(tried > 0, "{page} has lines for the shell");
    }

    #[test]
    fn what_pages_tell_readers_to_type_works_and_says_what_they_quote() {
        if python().is_none() {
            eprintln!(
                "lines for Python are not tried: DELONE_PYTHON names no Python that has SciPy"
            );
        }
        for page in TOLD {
            try_page(page);
        }
    }
}
