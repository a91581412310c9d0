use super::{Cell, Fault, Load, Mesher, Plan, Report};
use crate::effort::Effort;
use crate::heading::Heading;
use crate::machine::Machine;
use crate::measure::{Cost, Memory};
use crate::refine::goal::{Goal, Outline};
use crate::refine::quality::Quality;
use std::time::Duration;

const ONE: Mesher = Mesher::Delone { threads: 1 };
const TWO: Mesher = Mesher::Delone { threads: 2 };

fn cell(outline: &str, mesher: Mesher, triangles: usize, milliseconds: f64) -> Cell {
    let run = |factor: f64| Cost {
        seconds: factor * milliseconds * 1e-3,
        user: 0.0,
        system: 0.0,
        memory: Some(Memory {
            before: 1000,
            peak: 1000 + 300 * triangles as u64,
            after: 2000,
        }),
    };
    Cell {
        outline: outline.parse().unwrap(),
        load: Load::AngleOnly,
        goal: Goal {
            angle: 20.0,
            area: None,
        },
        mesher,
        mesh: Ok(Quality {
            triangles,
            min_angle: 20.25,
            max_area: 0.5,
            area: 1.0,
            skinny: 0,
            oversized: 0,
            unexcused: None,
            hash: None,
        }),
        runs: [3.0, 1.0, 0.5].map(run).to_vec(),
    }
}

fn report() -> Report {
    let group = |outline: &str, ours: usize| {
        let mut cells = vec![
            cell(outline, ONE, ours, 20.0),
            cell(outline, TWO, ours, 10.0),
            cell(outline, Mesher::Triangle, 1000, 40.0),
            cell(outline, Mesher::Cgal, 1600, 400.0),
            cell(outline, Mesher::Spade, 0, 1.0),
        ];
        cells[4].mesh = Err(Fault::TimedOut(Duration::from_secs(60)));
        cells
    };
    let mut cells = [
        group("holes", 800),
        group("coast", 600),
        group("star", 1000),
    ]
    .concat();
    if let Ok(quality) = &mut cells[12].mesh {
        quality.skinny = 7;
    }
    cells[13].mesh = Err(Fault::failed("area", "2 instead of 1"));
    let meshers = vec![
        ONE,
        TWO,
        Mesher::Triangle,
        Mesher::Cgal,
        Mesher::Spade,
        Mesher::Gmsh,
    ];
    Report {
        plan: Plan {
            meshers,
            outlines: Outline::ALL.to_vec(),
            loads: vec![Load::AngleOnly],
            angles: vec![20.0],
            effort: Effort {
                runs: 3,
                warmups: 1,
                seed: 1,
                timeout: Duration::from_secs(60),
            },
        },
        heading: Heading {
            command: "delone-bench refine".to_owned(),
            machine: Machine::inspect(),
            contenders: Vec::new(),
        },
        cells,
    }
}

/// Returns the trimmed fields of the first row that begins with `name` in the section of `title`.
fn row(markdown: &str, title: &str, name: &str) -> Vec<String> {
    let section = &markdown[markdown.find(title).expect(title)..];
    let row = section
        .lines()
        .find(|line| line.starts_with(&format!("| {name}")));
    let fields = row.expect("a row").trim_matches('|').split('|');
    fields.map(|field| field.trim().to_owned()).collect()
}

#[test]
fn sizes_and_times_stand_beside_their_ratios() {
    let markdown = report().to_markdown();
    assert_eq!(
        row(&markdown, "**Triangles", "holes"),
        [
            "holes", "18004", "20°", "800", "800", "1000", "1600", "> 60 s", "–", "0.80", "0.50"
        ]
    );
    assert_eq!(
        row(&markdown, "**Milliseconds", "holes")[3..],
        [
            "20.0", "10.0", "40.0", "400.0", "> 60 s", "–", "0.50", "0.05", "2.00"
        ]
    );
    assert_eq!(
        row(&markdown, "**Thousand", "holes")[3..6],
        ["40", "80", "25"]
    );
    assert_eq!(row(&markdown, "**Smallest", "holes")[3], "20.25");
    assert_eq!(row(&markdown, "**Peak", "holes")[3], "300");
}

#[test]
fn missed_bounds_and_failures_are_told() {
    let markdown = report().to_markdown();
    let star = row(&markdown, "**Triangles", "star");
    assert_eq!(star[5..7], ["1000 (7)", "area"]);
    assert!(markdown.contains("- cgal on star:200 at 20°, area none: area: 2 instead of 1"));
}

#[test]
fn aims_are_for_the_mean_of_holes_and_coast() {
    let markdown = report().to_markdown();
    let size = row(&markdown, "**Ratios", "20°   | triangles");
    assert_eq!(size[2..], ["0.82", "0.70", "0.80"]);
    let time = row(&markdown, "**Ratios", "20°   | time");
    assert_eq!(time[2..], ["0.65", "0.50", "0.50"]);
}

#[test]
fn json_keeps_every_run() {
    let json = report().to_json();
    assert_eq!(json["cells"][0]["runs"].as_array().map(Vec::len), Some(3));
    assert_eq!(json["cells"][12]["quality"]["skinny"], 7);
    assert_eq!(json["cells"][13]["fault"]["failed"]["how"], "area");
    assert_eq!(json["cells"][4]["fault"]["timed_out"], 60.0);
}
