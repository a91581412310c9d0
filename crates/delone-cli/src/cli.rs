//! The command line as a whole: one command a file, one global option.

use crate::exit::{self, Failure};
use crate::{check::Check, convert::Convert, sample::Sample, triangulate::Triangulate};

const EXAMPLES: &str = "\
Examples:
  delone triangulate                          try it: a map of the world's cities, no file needed
  delone triangulate points.csv -o mesh.ele   points in, mesh.node + mesh.ele + … out
  delone triangulate points.npy --json        only the figures, as one JSON object
  delone check mesh.ele                       is every circle empty? exactly, from the files alone
  delone sample uniform -n 1000000 -o u.npy   a million points to play with
  delone convert mesh.ele mesh.vtu            the same mesh for ParaView";

/// Exact, canonical, fast Delaunay triangulation.
///
/// A point set has exactly one triangulation here, whatever the order of its points, the number of
/// threads or the machine. Coordinates are numbers without unit; y points up; triangles are
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
    Check(Check),
    Sample(Sample),
    Convert(Convert),
}

impl Cli {
    /// Does what the command line asks for.
    pub fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::Triangulate(command) => command.run(self.quiet),
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
