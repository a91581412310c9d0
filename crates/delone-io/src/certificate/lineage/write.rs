//! Writing the table of lineage as text, with commas.

use super::Lineage;
use super::row::{COLUMNS, Row};
use crate::target::Output;
use crate::{Error, cancel};
use delone::Watch;

impl Lineage {
    /// Writes the table, with commas.
    pub(in crate::certificate) fn write(
        &self,
        out: &mut Output<'_>,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        out.bytes(COLUMNS.join(",").as_bytes())?;
        out.end_line()?;
        let rows = self.rows();
        for i in 0..rows.len() {
            cancel::check(watch, i)?;
            write_row(out, &rows.get(i))?;
        }
        Ok(())
    }
}

fn write_row(out: &mut Output<'_>, row: &Row<'_>) -> Result<(), Error> {
    let Row {
        element,
        number,
        origin,
        ..
    } = row;
    out.text(format_args!("{element},{number},{origin}"))?;
    for cell in row.numbers() {
        out.separator(b',');
        if let Some(number) = cell {
            out.number(number);
        }
    }
    out.end_line()
}
