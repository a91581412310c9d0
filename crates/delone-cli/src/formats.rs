//! `delone formats`: what is read and written, and what each format keeps.

mod notes;

use crate::exit::Failure;
use crate::files;
use delone_io::{Format, Keeps, Trait};
use serde::Serialize;
use std::fmt::Write;

const EXAMPLES: &str = "\
Examples:
  delone formats                table of all
  delone formats msh            one in full: what happens to what, and a command to try
  delone formats --json | jq '.[] | select(.keeps | index(\"z\")) | .name'";

const JSON: &str = "\
The JSON object of --json, in an array if no format is named:
  name, about      name and what it is
  extensions       file name extensions that mean it
  built            whether this build knows more of it than its name
  reads            of points, segments, mesh
  writes           of points, segments, mesh, six nodes, cells, links, raster, contours, report, animation
  keeps            what survives of points, domains and meshes that are written
  coordinates      f64, decimals (read back as the same), f32 or rounded; null if none are written
  notes            what happens to what
  example          a command to try";

/// Show the formats of files, and what each keeps
///
/// What a format has no place for is left out when it is written, and said in a note.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Formats {
    /// Format to show in full, by name or extension; all if none is named
    format: Option<Format>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Print table and notes as Markdown
    #[arg(long, conflicts_with_all = ["json", "format"])]
    markdown: bool,
}

impl Formats {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        match (self.format, self.json) {
            (Some(format), true) => files::print_json(&Entry::of(format)),
            (Some(format), false) => files::print(&in_full(format)),
            (None, true) => files::print_json(&Format::ALL.map(Entry::of)),
            (None, false) if self.markdown => files::print(markdown().trim_end()),
            (None, false) => files::print(table().trim_end()),
        }
    }
}

/// What there is to say about a format.
#[derive(Serialize)]
struct Entry {
    name: &'static str,
    about: &'static str,
    extensions: &'static [&'static str],
    built: bool,
    reads: Vec<&'static str>,
    writes: Vec<&'static str>,
    keeps: Vec<&'static str>,
    coordinates: Option<&'static str>,
    notes: &'static str,
    example: String,
}

impl Entry {
    fn of(format: Format) -> Self {
        let keeps = format.keeps();
        Self {
            name: format.name(),
            about: format.about(),
            extensions: format.extensions(),
            built: format.is_built(),
            reads: reads(format),
            writes: writes(format),
            keeps: keeps.map_or_else(Vec::new, |keeps| kept(keeps).map(Trait::name).collect()),
            coordinates: keeps.map(|keeps| keeps.coordinates.name()),
            notes: notes::of(format),
            example: example(format),
        }
    }
}

fn kept(keeps: Keeps) -> impl Iterator<Item = Trait> {
    Trait::ALL
        .into_iter()
        .filter(move |&what| keeps.keeps(what))
}

fn reads(format: Format) -> Vec<&'static str> {
    chosen(&[
        ("points", format.reads_points()),
        ("segments", format.reads_segments()),
        ("mesh", format.reads_mesh()),
    ])
}

fn writes(format: Format) -> Vec<&'static str> {
    chosen(&[
        ("points", format.writes_points()),
        ("segments", format.writes_segments()),
        ("mesh", format.writes_mesh()),
        ("six nodes", format.writes_quadratic_mesh()),
        ("cells", format.writes_cells()),
        ("links", format.writes_links()),
        ("raster", format.writes_raster()),
        ("contours", format.writes_contours()),
        ("report", format.writes_report()),
        ("animation", format.writes_animation()),
    ])
}

fn chosen(all: &[(&'static str, bool)]) -> Vec<&'static str> {
    let chosen = all.iter().filter(|(_, is)| *is);
    chosen.map(|(name, _)| *name).collect()
}

/// Returns the letter of a trait in the table.
fn letter(what: Trait) -> char {
    match what {
        Trait::Z => 'z',
        Trait::PointAttributes => 'a',
        Trait::PointMarkers => 'm',
        Trait::Segments => 's',
        Trait::SegmentMarkers => 'k',
        Trait::Holes => 'h',
        Trait::Regions => 'r',
        Trait::TriangleRegions => 'R',
        Trait::TriangleAttributes => 'A',
        Trait::SixNodes => '6',
        _ => '?',
    }
}

/// Writes those kept as letters, with dots for the others.
fn letters(keeps: Option<Keeps>) -> String {
    let Some(keeps) = keeps else {
        return String::new();
    };
    let shown = |what| {
        if keeps.keeps(what) {
            letter(what)
        } else {
            '·'
        }
    };
    Trait::ALL.map(shown).into_iter().collect()
}

/// Writes points, segments and mesh as letters.
fn contents([points, segments, mesh]: [bool; 3]) -> String {
    let all = [(points, 'p'), (segments, 's'), (mesh, 't')];
    if all.iter().all(|(is, _)| !is) {
        return String::new();
    }
    all.map(|(is, letter)| if is { letter } else { '·' })
        .into_iter()
        .collect()
}

fn table() -> String {
    let mut text = format!(
        "{:9} {:4}  {:5}  {:10}  {:8}  what it is\n",
        "name", "read", "write", "keeps", "numbers"
    );
    for format in Format::ALL {
        let read = [
            format.reads_points(),
            format.reads_segments(),
            format.reads_mesh(),
        ];
        let written = [
            format.writes_points(),
            format.writes_segments(),
            format.writes_mesh(),
        ];
        let numbers = format.keeps().map_or("", |keeps| keeps.coordinates.name());
        let built = if format.is_built() {
            ""
        } else {
            " (not in this build)"
        };
        let line = format!(
            "{:9} {:4}  {:5}  {:10}  {numbers:8}  {}{built}",
            format.name(),
            contents(read),
            contents(written),
            letters(format.keeps()),
            format.about()
        );
        text.push_str(line.trim_end());
        text.push('\n');
    }
    let legend = Trait::ALL.map(|what| match what {
        Trait::Z => "z".to_owned(),
        what => format!("{} {}", letter(what), what.name()),
    });
    text.push_str("\nread and write: p points, s segments, t triangles\nkeeps: ");
    text.push_str(&legend[..5].join(", "));
    text.push_str(",\n       ");
    text.push_str(&legend[5..].join(", "));
    text.push_str("\n`delone formats NAME` shows one in full.\n");
    text
}

fn or_nothing(names: &[&str]) -> String {
    match names {
        [] => "nothing".to_owned(),
        names => names.join(", "),
    }
}

fn in_full(format: Format) -> String {
    let entry = Entry::of(format);
    let extensions: Vec<String> = entry.extensions.iter().map(|e| format!(".{e}")).collect();
    let mut text = format!("{}: {}\n", entry.name, entry.about);
    let mut line = |name: &str, what: &str| {
        let _ = writeln!(text, "  {name:12} {what}");
    };
    line("extensions", &extensions.join(", "));
    line("reads", &or_nothing(&entry.reads));
    line("writes", &or_nothing(&entry.writes));
    if let Some(coordinates) = entry.coordinates {
        line("keeps", &or_nothing(&entry.keeps));
        line("coordinates", coordinates);
    }
    if !entry.built {
        line("", "this build cannot read or write it");
    }
    let _ = write!(text, "\n{}\n  {}", wrapped(entry.notes), entry.example);
    text
}

/// Breaks sentences into lines that fit a terminal.
fn wrapped(sentences: &str) -> String {
    let mut text = String::new();
    let mut width = 0;
    for word in sentences.split(' ') {
        let len = word.chars().count();
        if width > 0 && width + len >= WIDTH {
            text.push('\n');
            width = 0;
        } else if width > 0 {
            text.push(' ');
        }
        text.push_str(word);
        width += len + 1;
    }
    text.push('\n');
    text
}

/// Columns of a terminal that every user has.
const WIDTH: usize = 80;

/// Makes a command that reads or writes the format.
fn example(format: Format) -> String {
    let name = format.name();
    match format {
        Format::Node | Format::Poly => format!("delone mesh in.{name} --max-area 0.1 -o mesh.ele"),
        Format::Ele | Format::Edge | Format::Neigh => {
            "delone triangulate in.csv -o mesh.ele".to_owned()
        }
        Format::Gif => "delone algorithms run sweep --gif sweep.gif".to_owned(),
        Format::Html => "delone mesh in.poly --report mesh.html".to_owned(),
        Format::Airfoil => "delone mesh in.dat --from airfoil -o mesh.vtu".to_owned(),
        Format::Jigsaw => "delone convert in.msh out.vtu --from jigsaw".to_owned(),
        Format::Svg | Format::Png => format!("delone mesh in.poly -p mesh.{name}"),
        Format::Table => "delone triangulate in.csv --columns lon,lat -o mesh.vtu".to_owned(),
        format if format.writes_mesh() => format!("delone mesh in.poly -o mesh.{name}"),
        format if format.reads_segments() => format!("delone mesh in.{name} -o mesh.vtu"),
        _ => format!("delone triangulate in.{name} -o mesh.vtu"),
    }
}

fn markdown() -> String {
    let mut text = "\
# Formats of files

What `delone` reads and writes, and what survives; `delone formats` prints the same. A name's extension tells the
format, `--from` and `--to` overrule it, and where there is no name the content is looked at. What a format has no place
for is left out when it is written, and a note says so. Coordinates: `f64` are doubles, `decimals` read back as the same
doubles, `f32` keep 7 digits, `rounded` is what a picture shows.

| format | extensions | reads | writes | keeps | coordinates |
|---|---|---|---|---|---|
"
    .to_owned();
    for entry in Format::ALL.map(Entry::of) {
        let extensions: Vec<String> = entry.extensions.iter().map(|e| format!("`.{e}`")).collect();
        let _ = writeln!(
            text,
            "| [`{0}`](#{0}) | {1} | {2} | {3} | {4} | {5} |",
            entry.name,
            extensions.join(" "),
            entry.reads.join(", "),
            entry.writes.join(", "),
            entry.keeps.join(", "),
            entry.coordinates.unwrap_or_default()
        );
    }
    for entry in Format::ALL.map(Entry::of) {
        let Entry {
            name,
            about,
            notes,
            example,
            ..
        } = entry;
        let _ = write!(
            text,
            "\n## {name}\n\n{about}. {notes}\n\n```sh\n{example}\n```\n"
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_apart() {
        let mut letters = Trait::ALL.map(letter);
        letters.sort_unstable();
        assert!(letters.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(!letters.contains(&'?'));
    }

    #[test]
    fn every_format_has_notes_that_end() {
        for format in Format::ALL {
            assert!(notes::of(format).ends_with('.'), "{format}");
        }
    }
}
