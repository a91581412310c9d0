//! A Markdown table whose source is as readable as its rendering.

use std::fmt;

/// Returns what stands in a field, a dash if there is nothing.
pub fn dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "–".to_owned())
}

/// Rows of text under a header; the first columns are words and aligned left, the others right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
    text_columns: usize,
}

impl Table {
    /// Starts a table whose first column is words.
    pub fn new(header: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self {
            header: header.into_iter().map(Into::into).collect(),
            rows: Vec::new(),
            text_columns: 1,
        }
    }

    /// Makes the first `number` columns words.
    pub fn with_text_columns(self, number: usize) -> Self {
        Self {
            text_columns: number,
            ..self
        }
    }

    /// Appends a row.
    ///
    /// # Panics
    /// If the row is not as long as the header.
    pub fn push(&mut self, row: Vec<String>) {
        assert_eq!(row.len(), self.header.len(), "bug: a ragged table");
        self.rows.push(row);
    }

    fn widths(&self) -> Vec<usize> {
        let width = |column: usize| {
            let cells = self.rows.iter().chain([&self.header]);
            // Three characters are the shortest rule that every reader of Markdown accepts.
            cells
                .map(|row| row[column].chars().count())
                .fold(3, usize::max)
        };
        (0..self.header.len()).map(width).collect()
    }

    fn write_row(
        &self,
        f: &mut fmt::Formatter<'_>,
        row: &[String],
        widths: &[usize],
    ) -> fmt::Result {
        for (column, (cell, &width)) in row.iter().zip(widths).enumerate() {
            if column < self.text_columns {
                write!(f, "| {cell:<width$} ")?;
            } else {
                write!(f, "| {cell:>width$} ")?;
            }
        }
        writeln!(f, "|")
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = self.widths();
        self.write_row(f, &self.header, &widths)?;
        for (column, &width) in widths.iter().enumerate() {
            let end = if column < self.text_columns { "-" } else { ":" };
            write!(f, "|{}{end}", "-".repeat(width + 1))?;
        }
        writeln!(f, "|")?;
        self.rows
            .iter()
            .try_for_each(|row| self.write_row(f, row, &widths))
    }
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn columns_line_up() {
        let mut table = Table::new(["points", "n", "ns"]);
        table.push(vec!["grid".into(), "1M".into(), "1234".into()]);
        table.push(vec!["line".into(), "10k".into(), "×2".into()]);
        let lines = [
            "| points |   n |   ns |",
            "|--------|----:|-----:|",
            "| grid   |  1M | 1234 |",
            "| line   | 10k |   ×2 |",
            "",
        ];
        assert_eq!(table.to_string(), lines.join("\n"));
        let words = table.with_text_columns(2).to_string();
        assert!(words.contains("| 1M  | 1234 |") && words.contains("|-----|-----:|"));
    }
}
