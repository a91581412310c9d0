//! `delone algorithms`: the classical algorithms, listed, explained, run and watched.

mod figures;
mod given;
mod run;
mod watched;

use crate::exit::Failure;
use crate::files;
use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser;
use clap::{Args, Subcommand};
use delone::classic::{About, Algorithm, Takes};
use run::Run;
use serde::Serialize;

const EXAMPLES: &str = "\
Examples:
  delone algorithms                          list them, with source and cost
  delone algorithms --json | jq '.[].name'
  delone algorithms show fortune             idea, pseudocode, cost, guarantees
  delone algorithms run incremental points.csv --svg run.svg   an animation for the browser
  delone algorithms run greedy-flips mesh.ele --json           flips from a given triangulation";

/// List the classical algorithms, explain them, run one and watch it at work
///
/// They are exact, and faithful to the documents and papers that they come from; all that claim a Delaunay
/// triangulation end in the one that `delone triangulate` makes, which is faster. The guide is in
/// docs/algorithms.
#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, after_help = EXAMPLES,
          after_long_help = format!("{EXAMPLES}\n\n{}", crate::exit::HELP))]
pub struct Algorithms {
    /// Print the list as a JSON array of objects
    #[arg(long)]
    json: bool,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    Show(Show),
    Run(Box<Run>),
}

/// Explain an algorithm: its idea, its pseudocode, its cost
#[derive(Args)]
struct Show {
    /// Which
    #[arg(value_name = "NAME", value_parser = named(), hide_possible_values = true)]
    algorithm: Algorithm,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// Takes the name of an algorithm.
pub fn named() -> impl TypedValueParser<Value = Algorithm> {
    let names = Algorithm::ALL
        .iter()
        .map(|algorithm| algorithm.about().name);
    let known = |name: String| Algorithm::named(&name).expect("bug: a name that is not known");
    PossibleValuesParser::new(names).map(known)
}

/// What there is to say of an algorithm, for programs.
#[derive(Serialize)]
struct Description {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    idea: &'static str,
    cost: &'static str,
    guarantees: &'static str,
    takes: &'static str,
    delaunay: bool,
    code: &'static [&'static str],
}

impl From<&About> for Description {
    fn from(about: &About) -> Self {
        Self {
            name: about.name,
            title: about.title,
            source: about.source,
            idea: about.idea,
            cost: about.cost,
            guarantees: about.guarantees,
            takes: match about.takes {
                Takes::Points => "points",
                Takes::Triangulation => "triangulation",
                Takes::Domain => "domain",
                Takes::Data => "data",
            },
            delaunay: about.is_delaunay,
            code: about.code,
        }
    }
}

impl Algorithms {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        match &self.command {
            None if self.json => {
                let all = Algorithm::ALL.iter().map(|a| Description::from(a.about()));
                files::print_json(&all.collect::<Vec<_>>())
            }
            None => files::print(&list()),
            Some(Command::Show(show)) if show.json => {
                files::print_json(&Description::from(show.algorithm.about()))
            }
            Some(Command::Show(show)) => files::print(&explained(show.algorithm.about())),
            Some(Command::Run(run)) => run.run(quiet),
        }
    }
}

/// One line for each algorithm.
fn list() -> String {
    let names = Algorithm::ALL.iter().map(|a| a.about().name.len());
    let sources = Algorithm::ALL.iter().map(|a| a.about().source.len());
    let (names, sources) = (names.max().unwrap_or(0), sources.max().unwrap_or(0));
    let line = |algorithm: &Algorithm| {
        let About {
            name, source, cost, ..
        } = algorithm.about();
        format!("{name:names$}  {source:sources$}  {cost}")
    };
    Algorithm::ALL
        .iter()
        .map(line)
        .collect::<Vec<_>>()
        .join("\n")
}

/// All that there is to say, in paragraphs.
fn explained(about: &About) -> String {
    let width = about.code.len().to_string().len();
    let numbered = about.code.iter().zip(1..);
    let code = numbered.map(|(line, number)| format!("  {number:width$}  {line}"));
    let delaunay = if about.is_delaunay { "yes" } else { "no" };
    [
        format!("{} ({})", about.title, about.name),
        format!("{}\n", about.source),
        format!("{}\n", about.idea),
        code.collect::<Vec<_>>().join("\n"),
        format!("\nCost: {}", about.cost),
        format!("Result: {}", about.guarantees),
        format!("Delaunay: {delaunay}"),
    ]
    .join("\n")
}
