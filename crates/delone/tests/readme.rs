//! Holds the README to the truth: its lines for points are those of `examples/first.rs`, and those for
//! a mesh of `examples/mesh.rs`, and their output is theirs; and so do those of `docs/scattered.md` for fits.

use std::cell::RefCell;
use std::path::Path;

const README: &str = "../../README.md";

thread_local! {
    static PRINTED: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Shadows the macro of the standard library in the example, to keep what it prints.
macro_rules! println {
    ($($argument:tt)*) => {
        crate::PRINTED.with_borrow_mut(|text| {
            text.push_str(&format!($($argument)*));
            text.push('\n');
        })
    };
}

#[path = "../examples/first.rs"]
mod first;
#[path = "../examples/local_fits.rs"]
mod local_fits;
#[path = "../examples/mesh.rs"]
mod mesh;

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Returns the body of the example's `main` but for its last line, which is no concern of a reader.
fn body(example: &str) -> String {
    let lines = example
        .lines()
        .skip_while(|l| !l.contains("fn main"))
        .skip(1);
    lines
        .take_while(|line| line.trim() != "Ok(())")
        .map(|line| format!("{}\n", line.strip_prefix("    ").unwrap_or(line)))
        .collect()
}

/// Requires that a page has the few lines of an example, and what they print.
fn require(page: &str, example: &str, lines: usize, main: fn() -> Result<(), delone::Error>) {
    let code = body(&read(example));
    assert_eq!(code.lines().count(), lines, "{code}");
    main().expect("finite points");
    let output = PRINTED.take();
    let text_of_page = read(page);
    for (language, text) in [("rust", code), ("text", output)] {
        let block = format!("```{language}\n{text}```\n");
        assert!(text_of_page.contains(&block), "{page} lacks:\n{block}");
    }
}

#[test]
fn the_readme_shows_the_example_and_its_output() {
    require(README, "examples/first.rs", 5, first::main);
}

#[test]
fn the_readme_shows_the_example_of_a_mesh_and_its_output() {
    require(README, "examples/mesh.rs", 12, mesh::main);
}

#[test]
fn the_page_on_scattered_data_shows_fits_and_what_they_print() {
    let page = "../../docs/scattered.md";
    require(page, "examples/local_fits.rs", 18, local_fits::main);
}
