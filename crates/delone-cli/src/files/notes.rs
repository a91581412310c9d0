//! What of a file has not been taken, and what its reader had to decide, in words.

use delone_io::{LeftOut, PointSet};

/// Says what of a file is not used, and what else its reader has to say.
pub fn notes(set: &PointSet) -> Vec<String> {
    columns_left_out(set)
        .into_iter()
        .chain(set.notes.iter().cloned())
        .collect()
}

fn columns_left_out(set: &PointSet) -> Option<String> {
    let columns: Vec<String> = set.left_out.iter().map(|c| in_words(c, set)).collect();
    let columns = columns.join(", ");
    let says = || format!("left out, because they hold no numbers of points: {columns}");
    (!columns.is_empty()).then(says)
}

/// Names a column that was left out; if it began with numbers, with what stands there instead, and where.
fn in_words(left_out: &LeftOut, set: &PointSet) -> String {
    let LeftOut { name, point, text } = left_out;
    match set.lines.of(*point) {
        Some(line) if *point > 0 => format!("{name} (line {line}: {text:?})"),
        _ => name.clone(),
    }
}
