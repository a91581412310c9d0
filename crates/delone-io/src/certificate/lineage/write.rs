//! Writing the table of lineage.

use super::{Along, Lineage, OfVertex};
use crate::target::Output;
use crate::{Error, cancel};
use delone::Watch;

/// The names of the columns.
pub(super) const HEADER: &str =
    "element,number,origin,feature,at,to,other,other_at,from_vertex,to_vertex";

impl Lineage {
    /// Writes the table, with commas.
    pub(in crate::certificate) fn write(
        &self,
        out: &mut Output<'_>,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        out.text(format_args!("{HEADER}"))?;
        out.end_line()?;
        for (number, &vertex) in self.vertices.iter().enumerate() {
            cancel::check(watch, number)?;
            self.write_vertex(out, number, vertex)?;
        }
        for (number, edge) in self.edges.iter().enumerate() {
            cancel::check(watch, number)?;
            out.text(format_args!("edge,{number},"))?;
            self.write_feature(out, edge.segment)?;
            out.number(edge.at[0]);
            out.separator(b',');
            out.number(edge.at[1]);
            let [a, b] = edge.ends.map(|v| v.index());
            out.text(format_args!(",,,{a},{b}"))?;
            out.end_line()?;
        }
        for (number, region) in self.regions.iter().flatten().enumerate() {
            cancel::check(watch, number)?;
            match region {
                Some(region) => out.text(format_args!("triangle,{number},region,{region}"))?,
                None => out.text(format_args!("triangle,{number},none,"))?,
            }
            out.text(format_args!(",,,,,,"))?;
            out.end_line()?;
        }
        Ok(())
    }

    fn write_vertex(
        &self,
        out: &mut Output<'_>,
        number: usize,
        vertex: OfVertex,
    ) -> Result<(), Error> {
        out.text(format_args!("vertex,{number},"))?;
        match vertex {
            OfVertex::Input => out.text(format_args!("input,{number},,,,"))?,
            OfVertex::Duplicate(kept) => {
                out.text(format_args!("duplicate,{},,,,", kept.index()))?;
            }
            OfVertex::Free => out.text(format_args!("free,,,,,"))?,
            OfVertex::OnSegment(Along { segment, at }) => {
                self.write_feature(out, segment)?;
                out.number(at);
                out.text(format_args!(",,,"))?;
            }
            OfVertex::Crossing([first, second]) => {
                out.text(format_args!("crossing,{},", first.segment))?;
                out.number(first.at);
                out.text(format_args!(",,{},", second.segment))?;
                out.number(second.at);
            }
        }
        out.text(format_args!(",,"))?;
        out.end_line()
    }

    /// Writes two cells, and the comma behind them.
    fn write_feature(&self, out: &mut Output<'_>, segment: usize) -> Result<(), Error> {
        match segment.checked_sub(self.num_segments) {
            None => out.text(format_args!("segment,{segment},")),
            Some(hull) => out.text(format_args!("hull,{hull},")),
        }
    }
}
