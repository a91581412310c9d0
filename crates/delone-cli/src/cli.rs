//! The command line as a whole: one command a file, two global options.

use crate::completions::{Completions, Man};
use crate::exit::{self, Failure};
use crate::{
    algorithms::Algorithms, check::Check, cluster::Cluster, config::RunFile, contour::Contour,
    convert::Convert, cover::Cover, doctor::Doctor, formats::Formats, graph::Graph, info::Info,
    interpolate::Interpolate, mesh::Mesh, nearest::Nearest, race::Race, sample::Sample,
    theatre::Theatre, triangle::Triangle, triangulate::Triangulate, voronoi::Voronoi,
};

const EXAMPLES: &str = "\
Examples:
  delone mesh                                 try it: a lake with islands, no file needed
  delone mesh map.poly --max-edge 0.5 -o m.vtu  good triangles in outlines, for ParaView
  delone triangulate points.csv -o mesh.ele   points in, mesh.node + mesh.ele + … out
  delone triangulate points.npy --json        only the figures, as one JSON object
  delone nearest towns.csv sites.csv -o near.csv   which town is nearest to each site, how far
  delone voronoi towns.csv --clip land.geojson -o cells.geojson   what is nearest to each town
  delone contour survey.xyz --interval 10 -o lines.geojson   contour lines; `interpolate`: rasters
  delone cover survey.csv -d 6 -o c.vtu       6 to 17 data in each triangle, to fit something there
  delone graph towns.csv --kind tour -o tour.geojson   a short tour; also trees and other graphs
  delone cluster towns.csv -n 12 -o groups.csv   twelve groups of points that lie together
  delone info map.poly                        what a file holds: points, segments, columns, regions
  delone doctor map.poly --repair clean.poly  what is wrong with it, exactly, and the repair
  delone check mesh.ele                       is every circle empty? exactly, from the files alone
  delone sample uniform -n 1000000 -o u.npy   a million points to play with
  delone algorithms run sweep --svg sweep.svg   watch a classical algorithm at work, step by step
  delone theatre                              the algorithms in your browser: play, step, race, mesh
  delone convert mesh.ele mesh.vtu            the same mesh for ParaView
  delone formats                              what is read and written, and what survives
  delone run job.toml                         jobs that a file describes, done again and again
  delone triangle -pq30a0.1 map.poly          for scripts: Triangle's switches, Triangle's files";

/// Quality meshes and Delaunay triangulations: exact, canonical, fast.
///
/// A point set, with or without segments, has exactly one triangulation here, whatever the order, the
/// number of threads or the machine; and a domain has one mesh for what is asked. Coordinates are
/// numbers without unit; y points up; triangles are counter-clockwise. Results and --json go to standard output, everything said to people to
/// standard error.
#[derive(clap::Parser)]
#[command(name = "delone", version, after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{}", exit::HELP))]
pub struct Cli {
    /// Say nothing but errors: no summary, no notes, no progress bar
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Say more: which format a file has and why, what it holds, how long each phase takes and how fast
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    verbose: bool,
    #[command(subcommand)]
    command: Command,
}

/// What there is to do.
#[derive(clap::Subcommand)]
pub enum Command {
    Mesh(Mesh),
    Triangulate(Triangulate),
    Nearest(Nearest),
    Voronoi(Voronoi),
    Interpolate(Interpolate),
    Contour(Contour),
    Cover(Cover),
    Graph(Graph),
    Cluster(Cluster),
    Info(Info),
    Doctor(Doctor),
    Check(Check),
    Sample(Sample),
    Algorithms(Algorithms),
    Race(Race),
    Theatre(Theatre),
    Convert(Convert),
    Formats(Formats),
    Triangle(Triangle),
    Run(RunFile),
    Completions(Completions),
    Man(Man),
}

impl Cli {
    /// Does what the command line asks for.
    pub fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::Mesh(command) => command.run(self.quiet),
            Command::Triangulate(command) => command.run(self.quiet),
            Command::Nearest(command) => command.run(self.quiet),
            Command::Voronoi(command) => command.run(self.quiet),
            Command::Interpolate(command) => command.run(self.quiet),
            Command::Contour(command) => command.run(self.quiet),
            Command::Cover(command) => command.run(self.quiet),
            Command::Graph(command) => command.run(self.quiet),
            Command::Cluster(command) => command.run(self.quiet),
            Command::Info(command) => command.run(self.quiet),
            Command::Doctor(command) => command.run(self.quiet),
            Command::Check(command) => command.run(self.quiet),
            Command::Sample(command) => command.run(self.quiet),
            Command::Algorithms(command) => command.run(self.quiet),
            Command::Race(command) => command.run(self.quiet),
            Command::Theatre(command) => command.run(self.quiet),
            Command::Convert(command) => command.run(self.quiet),
            Command::Formats(command) => command.run(),
            Command::Triangle(command) => command.run(self.quiet),
            Command::Run(command) => command.run(self.quiet),
            Command::Completions(command) => command.run(),
            Command::Man(command) => command.run(self.quiet),
        }
    }

    /// Returns what there is to do.
    pub fn asked(&self) -> &Command {
        &self.command
    }

    /// Tells whether everything is to be said that may interest somebody.
    pub fn is_verbose(&self) -> bool {
        self.verbose
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
