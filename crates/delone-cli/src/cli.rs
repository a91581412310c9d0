//! The command line as a whole: one command a file, one global option.

use crate::exit::{self, Failure};
use crate::{check::Check, convert::Convert, info::Info, sample::Sample, triangulate::Triangulate};

const EXAMPLES: &str = "\
Examples:
  delone triangulate                          try it: a lake with islands, no file needed
  delone triangulate points.csv -o mesh.ele   points in, mesh.node + mesh.ele + … out
  delone triangulate map.poly -o mesh.vtu     outlines, holes and regions, for ParaView
  delone triangulate points.npy --json        only the figures, as one JSON object
  delone info map.poly                        do segments cross or overlap, and where? exactly
  delone check mesh.ele                       is every circle empty? exactly, from the files alone
  delone sample uniform -n 1000000 -o u.npy   a million points to play with
  delone convert mesh.ele mesh.vtu            the same mesh for ParaView";

/// Exact, canonical, fast Delaunay triangulation.
///
/// A point set, with or without segments, has exactly one triangulation here, whatever the order, the
/// number of threads or the machine. Coordinates are numbers without unit; y points up; triangles are
/// counter-clockwise. Results and --json go to standard output, everything said to people to
/// standard error.
#[derive(clap::Parser)]
#[command(name = "delone", version, after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{}", exit::HELP))]
pub struct Cli {
    /// Say nothing but errors: no summary, no notes, no progress bar
    #[arg(short, long, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Triangulate(Triangulate),
    Info(Info),
    Check(Check),
    Sample(Sample),
    Convert(Convert),
}

impl Cli {
    /// Does what the command line asks for.
    pub fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::Triangulate(command) => command.run(self.quiet),
            Command::Info(command) => command.run(self.quiet),
            Command::Check(command) => command.run(self.quiet),
            Command::Sample(command) => command.run(self.quiet),
            Command::Convert(command) => command.run(self.quiet),
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_sound() {
        super::Cli::command().debug_assert();
    }
}
