//! `delone-bench`: measures ours and its peers, prints one table. `--help` says how.

mod cover_command;
mod files_command;
mod peers_option;
mod queries_command;
mod refine_command;

use clap::{Args, Parser, Subcommand};
use delone_bench::engines::Engine;
use delone_bench::job::Job;
use delone_bench::machine::Machine;
use delone_bench::plan::Plan;
use delone_bench::process::Launcher;
use delone_bench::report::Report;
use delone_bench::stats::{median, parse_size};
use delone_bench::subject::{Subject, Task};
use delone_samples::{Distribution, Domain};
use serde::Serialize;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Measures Delone and its peers on the same points or domains and prints tables in Markdown
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct CommandLine {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    options: Options,
}

#[derive(Subcommand)]
enum Action {
    /// Triangulates with Delone again and again in this process, for a profiler
    Profile(Profile),
    /// Measures refinement of outlines to meshes
    Refine(refine_command::Options),
    /// Measures queries, cells, surfaces and edits
    Queries(queries_command::Options),
    /// Measures covers of data: triangles with enough of them each, and not too many
    Cover(cover_command::Options),
    /// Measures writing and reading of files
    Files(files_command::Options),
    /// Does one job in this process and prints what it found as JSON; the table maker calls this
    #[command(hide = true)]
    Job(Job),
    /// The same for refinement
    #[command(hide = true)]
    MeshJob(delone_bench::refine::job::Job),
    /// The same for queries
    #[command(hide = true)]
    QueryJob(delone_bench::queries::job::Job),
    /// The same for covers
    #[command(hide = true)]
    CoverJob(delone_bench::cover::job::Job),
    /// The same for files
    #[command(hide = true)]
    FileJob(delone_bench::files::job::Job),
}

#[derive(Args)]
struct Options {
    /// Numbers of points or segments
    #[arg(long, value_delimiter = ',', value_parser = parse_size, default_value = "10k,100k,1M")]
    sizes: Vec<usize>,
    /// Kinds of points [default: all]
    #[arg(long, value_delimiter = ',')]
    distributions: Vec<Distribution>,
    /// Domains instead of points: either clean ones or ones whose segments cross
    #[arg(long, value_delimiter = ',', conflicts_with = "distributions")]
    domains: Vec<Domain>,
    /// Peers [default: all that can do it]
    #[arg(long, value_delimiter = ',')]
    peers: Option<Vec<Engine>>,
    /// Numbers of threads for Delone
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<NonZeroUsize>,
    /// Processes that count for each cell [default: 9, with --quick 3]
    #[arg(long)]
    runs: Option<usize>,
    /// Processes discarded before them [default: 2, with --quick 1]
    #[arg(long)]
    warmups: Option<usize>,
    /// Triangulations in one process; 0 leaves that table out [default: 9, with --quick 3]
    #[arg(long)]
    repeats: Option<usize>,
    /// Measures less often
    #[arg(long)]
    quick: bool,
    /// Seed of the input
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Seconds that one triangulation may take
    #[arg(long, default_value_t = 60)]
    timeout: u64,
    /// Also writes every single run to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Args)]
struct Profile {
    /// Kind of points, or domain
    subject: Subject,
    /// Number of points or segments
    #[arg(value_parser = parse_size)]
    size: usize,
    /// How often, each time on new input
    repeats: usize,
    /// Number of threads
    #[arg(long, default_value = "1")]
    threads: NonZeroUsize,
    /// Seed of the first input
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    let CommandLine { action, options } = CommandLine::parse();
    let result = match action {
        None => print_tables(options),
        Some(Action::Profile(profile)) => print_profile(&profile),
        Some(Action::Refine(options)) => refine_command::print_tables(options, command()),
        Some(Action::Queries(options)) => queries_command::print_tables(options, command()),
        Some(Action::Cover(options)) => cover_command::print_tables(options, command()),
        Some(Action::Files(options)) => files_command::print_tables(options, command()),
        Some(Action::Job(job)) => print_answer(job.run()),
        Some(Action::MeshJob(job)) => print_answer(job.run()),
        Some(Action::QueryJob(job)) => print_answer(job.run()),
        Some(Action::CoverJob(job)) => print_answer(job.run()),
        Some(Action::FileJob(job)) => print_answer(job.run()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn print_tables(options: Options) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let launcher = Launcher::this_program()?;
    let json = options.json.clone();
    let plan = plan(options)?;
    let cells = plan.run(&launcher, &mut |group| eprintln!("{group}"));
    let report = Report {
        plan,
        machine,
        command: command(),
        cells,
    };
    if let Some(path) = json {
        std::fs::write(path, serde_json::to_string_pretty(&report.to_json())?)?;
    }
    print!("{}", report.to_markdown());
    Ok(())
}

fn plan(options: Options) -> Result<Plan, String> {
    let subjects = options.subjects();
    let task = common_task(&subjects)?;
    let threads = options.threads.into_iter().map(NonZeroUsize::get);
    let ours = threads.map(|threads| Engine::Delone { threads });
    let unless_quick = |normal, quick| if options.quick { quick } else { normal };
    let mut sizes = options.sizes;
    sizes.sort_unstable();
    Ok(Plan {
        engines: ours.chain(peers(options.peers, task)?).collect(),
        task,
        subjects,
        sizes,
        seed: options.seed,
        warmups: options.warmups.unwrap_or(unless_quick(2, 1)),
        runs: options.runs.unwrap_or(unless_quick(9, 3)),
        repeats: options.repeats.unwrap_or(unless_quick(9, 3)),
        timeout: Duration::from_secs(options.timeout),
    })
}

impl Options {
    fn subjects(&self) -> Vec<Subject> {
        let points = self.distributions.iter().copied().map(Subject::from);
        let domains = self.domains.iter().copied().map(Subject::from);
        let asked_for: Vec<_> = points.chain(domains).collect();
        if asked_for.is_empty() {
            Distribution::ALL.map(Subject::from).to_vec()
        } else {
            asked_for
        }
    }
}

/// Returns what is done with all of `subjects`.
fn common_task(subjects: &[Subject]) -> Result<Task, String> {
    let [first, others @ ..] = subjects else {
        return Ok(Task::Points);
    };
    match others.iter().find(|other| other.task() != first.task()) {
        Some(other) => Err(format!(
            "the segments of `{first}` and of `{other}` need different treatment; \
             ask for clean and for crossing ones in two runs"
        )),
        None => Ok(first.task()),
    }
}

/// Returns the peers that were asked for, or all that can do `task`.
fn peers(asked_for: Option<Vec<Engine>>, task: Task) -> Result<Vec<Engine>, String> {
    let able = |engine: &Engine| engine.facts(task).is_some();
    let Some(asked_for) = asked_for else {
        return Ok(Engine::PEERS.into_iter().filter(able).collect());
    };
    match asked_for.iter().find(|engine| !able(engine)) {
        Some(engine) => Err(format!("{engine} cannot do this")),
        None => Ok(asked_for),
    }
}

fn command() -> String {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let command = format!("cargo run --release -p delone-bench -- {}", args.join(" "));
    command.trim_end_matches([' ', '-']).to_owned()
}

fn print_profile(profile: &Profile) -> Result<(), Box<dyn Error>> {
    let engine = Engine::Delone {
        threads: profile.threads.get(),
    };
    let Profile { subject, size, .. } = *profile;
    let unit = subject.task().unit();
    let mut times = Vec::new();
    for repeat in 0..profile.repeats as u64 {
        let seed = profile.seed.wrapping_add(repeat);
        let run = engine.run(subject.task(), subject.make(size, seed), false)?;
        let nanoseconds = run.cost.seconds * 1e9 / size as f64;
        println!(
            "run {repeat}: {nanoseconds:.1} ns/{unit}, {} triangles",
            run.triangles
        );
        times.push(nanoseconds);
    }
    let fastest = times.iter().copied().min_by(f64::total_cmp);
    if let (Some(fastest), Some(median)) = (fastest, median(times)) {
        println!("min {fastest:.1}, median {median:.1} ns/{unit}");
    }
    Ok(())
}

fn print_answer(answer: Result<impl Serialize, String>) -> Result<(), Box<dyn Error>> {
    println!("{}", serde_json::to_string(&answer?)?);
    Ok(())
}
