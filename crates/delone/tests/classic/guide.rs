//! The guide: each algorithm has its page, with the pseudocode that runs, and links lead somewhere.

use delone::classic::{About, Algorithm};
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/algorithms")
}

fn read(name: &str) -> String {
    let path = folder().join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn abouts() -> impl Iterator<Item = &'static About> {
    Algorithm::ALL.iter().map(|algorithm| algorithm.about())
}

/// The pseudocode as pages have it: numbered, numbers aligned at their right.
fn numbered(code: &[&str]) -> String {
    let width = code.len().to_string().len();
    let lines = code
        .iter()
        .zip(1..)
        .map(|(line, number)| format!("{number:width$}  {line}\n"));
    lines.collect()
}

/// Where the links of a page lead, those to other sites left out.
fn links(page: &str) -> impl Iterator<Item = &str> {
    let links = page.split("](").skip(1);
    let links = links.filter_map(|rest| rest.split_once(')').map(|(link, _)| link));
    links.filter(|link| !link.contains("://"))
}

#[test]
fn every_page_has_the_pseudocode_that_runs() {
    for about in abouts() {
        let page = read(&format!("{}.md", about.name));
        let code = format!("```text\n{}```\n", numbered(about.code));
        assert!(
            page.contains(&code),
            "{}.md should have\n{code}",
            about.name
        );
        let strip = format!("](pictures/{}.png)", about.name);
        assert!(page.contains(&strip), "{}.md shows no strip", about.name);
        let command = format!("delone algorithms run {}", about.name);
        assert!(page.contains(&command), "{}.md: {command}", about.name);
    }
}

#[test]
fn the_index_says_what_the_program_says() {
    let index = read("README.md");
    for about in abouts() {
        let delaunay = if about.is_delaunay { "yes" } else { "no" };
        let About {
            name, source, cost, ..
        } = about;
        let row = format!("| [`{name}`]({name}.md) | {source} | {cost} | {delaunay} |");
        assert!(index.contains(&row), "missing: {row}");
    }
    let rows = index.lines().filter(|line| line.starts_with("| [`"));
    assert_eq!(rows.count(), Algorithm::ALL.len());
}

#[test]
fn links_lead_to_files_and_headings() {
    let pages = abouts().map(|about| format!("{}.md", about.name));
    let others = ["README.md", "log-format.md", "../scattered.md"];
    for name in pages.chain(others.map(str::to_owned)) {
        let page = read(&name);
        let beside = Path::new(&name).parent().expect("it is a file");
        for link in links(&page) {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let path = beside.join(file);
            assert!(folder().join(&path).exists(), "{name}: {link}");
            if !heading.is_empty() {
                let there = if file.is_empty() {
                    page.clone()
                } else {
                    read(path.to_str().expect("UTF-8"))
                };
                assert!(
                    anchors(&there).any(|anchor| anchor == heading),
                    "{name}: {link}"
                );
            }
        }
    }
}

/// The anchors of a page's headings: lower case, blanks to hyphens, without marks.
fn anchors(page: &str) -> impl Iterator<Item = String> {
    let headings = page.lines().filter(|line| line.starts_with('#'));
    headings.map(|line| {
        let text = line.trim_start_matches('#').trim().to_lowercase();
        let kept = text
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    })
}
