//! Figures as people read them.

pub use delone_io::words::{count, counted, duration, list, measure};

use delone::Pslg;
use std::path::PathBuf;

/// Writes what a domain consists of: `9 points, 9 segments and 1 hole`.
pub fn domain(pslg: &Pslg) -> String {
    let mut parts = vec![counted(pslg.points.len(), "point", "points")];
    for (n, one, many) in [
        (pslg.segments.len(), "segment", "segments"),
        (pslg.polygons.len(), "polygon", "polygons"),
        (pslg.holes.len(), "hole", "holes"),
        (pslg.regions.len(), "region", "regions"),
    ] {
        if n > 0 {
            parts.push(counted(n, one, many));
        }
    }
    list(&parts)
}

/// Says which files have been written, if any have been.
pub fn wrote(files: &[PathBuf]) -> Option<String> {
    let names: Vec<String> = files.iter().map(|p| p.display().to_string()).collect();
    (!names.is_empty()).then(|| format!("wrote {}", list(&names)))
}

/// Returns the command that runs, as a shell would take it.
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    let words = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("delone".to_owned())
        .chain(words)
        .collect::<Vec<_>>()
        .join(" ")
}

/// Quotes a word if a shell would change it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-./=:,+%@".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn words_are_quoted_where_a_shell_would_change_them() {
        let shown = ["a/ü.poly", "--max-edge=1e-3", "", "x*y", "it's"].map(quoted);
        let expected = ["a/ü.poly", "--max-edge=1e-3", "''", "'x*y'", "'it'\\''s'"];
        assert_eq!(shown, expected.map(String::from));
    }
}
