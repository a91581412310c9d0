//! What has become of several files, for people.

use crate::words::{count, counted, measure};
use serde_json::Value;
use std::time::Duration;

/// What has become of a file.
pub struct Row {
    cells: [String; 6],
    is_done: bool,
}

/// Titles of the columns.
const TITLES: [&str; 6] = [
    "file",
    "points",
    "triangles",
    "smallest angle",
    "seconds",
    "result",
];

impl Row {
    /// Takes the figures that a file's JSON has, the exit code that it alone would have had, and the time.
    pub fn of(file: &str, results: &[String], code: u8, took: Duration) -> Self {
        let json = results.last().map(|line| serde_json::from_str(line));
        let json: Value = json.and_then(Result::ok).unwrap_or_default();
        let number = |keys: &[&str]| {
            let known = keys.iter().find_map(|key| json[key].as_u64());
            known.map_or_else(String::new, |n| count(n as usize))
        };
        let angle = json["min_angle_degrees"].as_f64();
        Self {
            cells: [
                file.to_owned(),
                number(&["vertices", "points"]),
                number(&["triangles"]),
                angle.map_or_else(String::new, |angle| format!("{}°", measure(angle))),
                format!("{:.3}", took.as_secs_f64()),
                result(code, &json),
            ],
            is_done: code == 0,
        }
    }
}

/// Says how it ended, in a word.
fn result(code: u8, json: &Value) -> String {
    let word = match code {
        0 => return "done".to_owned(),
        1 => "wrong",
        2 => "usage",
        3 => "bad input",
        4 if json["unexcused"].as_u64() > Some(0) => "not as asked",
        _ => "not reached",
    };
    format!("{word} ({code})")
}

/// Sets rows below each other; columns that nobody fills are left out.
pub fn table(rows: &[Row]) -> String {
    let width = |i: usize| {
        let cells = rows.iter().map(|row| row.cells[i].chars().count());
        let widest = cells.max().unwrap_or(0);
        (widest > 0).then(|| widest.max(TITLES[i].chars().count()))
    };
    let widths: [Option<usize>; 6] = std::array::from_fn(width);
    let line = |cells: [&str; 6]| {
        let mut line = String::new();
        for (i, cell) in cells.into_iter().enumerate() {
            let Some(width) = widths[i] else { continue };
            let padding = " ".repeat(width - cell.chars().count());
            // Words begin, numbers end below each other.
            line += &match i {
                0 => format!("{cell}{padding}"),
                5 => format!("  {cell}"),
                _ => format!("  {padding}{cell}"),
            };
        }
        line.trim_end().to_owned()
    };
    let mut text = vec![line(TITLES)];
    text.extend(
        rows.iter()
            .map(|row| line(row.cells.each_ref().map(|c| &c[..]))),
    );
    let done = rows.iter().filter(|row| row.is_done).count();
    let files = counted(rows.len(), "file", "files");
    text.push(match rows.len() - done {
        0 => format!("{files}, all done"),
        failed => format!("{files}: {} done, {} not", count(done), count(failed)),
    });
    text.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_stand_below_each_other() {
        let json = r#"{"vertices":1234,"triangles":2400,"min_angle_degrees":25.0}"#;
        let took = Duration::from_millis(123);
        let rows = [
            Row::of("maps/ä.poly", &[json.to_owned()], 0, took),
            Row::of("b.poly", &[], 3, 10 * took),
        ];
        let expected = "\
file         points  triangles  smallest angle  seconds  result
maps/ä.poly   1,234      2,400          25.00°    0.123  done
b.poly                                            1.230  bad input (3)
2 files: 1 done, 1 not";
        assert_eq!(table(&rows), expected);
    }

    #[test]
    fn columns_that_nobody_fills_are_left_out() {
        let rows = [Row::of(
            "a.csv",
            &[r#"{"points":3}"#.to_owned()],
            0,
            Duration::ZERO,
        )];
        assert_eq!(
            table(&rows),
            "file   points  seconds  result\na.csv       3    0.000  done\n1 file, all done"
        );
    }
}
