//! Breaks files and feeds them to every reader and every way through the library, for as long or as often as asked.

use delone_filekit::{BODIES, Body, Breaker, Seed, seeds};
use std::fs;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::{Duration, Instant};

const USAGE: &str = "\
Usage: fuzz-files [--seconds S | --runs N] [--seed X] [--only NAME] [--from K] [--seeds FOLDER]… [--list]
       fuzz-files --only NAME --file FILE
       fuzz-files --only NAME --seeds-to FOLDER

Feeds every body with broken files, for S seconds (default 1) or N files each; case K of a seed and a body is the same
on every machine. Small files of --seeds are broken, too. A failure leaves its file in target/fuzz-files and ends the
program with exit code 1; so do a case that takes more than 10 seconds, and one that takes too much memory. If the
program is killed, the file `current` there tells the case. --file feeds a body with one file as it is, --seeds-to
writes the unbroken inputs of a body into a folder.";

/// Longest time of a case.
const LONGEST: Duration = Duration::from_secs(10);

/// Where failures are left.
const FOLDER: &str = "target/fuzz-files";

#[derive(Default)]
struct Options {
    seconds: Option<u64>,
    runs: Option<u64>,
    seed: u64,
    from: u64,
    only: Option<String>,
    file: Option<PathBuf>,
    seeds_to: Option<PathBuf>,
    folders: Vec<PathBuf>,
    list: bool,
}

impl Options {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self::default();
        while let Some(name) = arguments.next() {
            if name == "--list" {
                options.list = true;
                continue;
            }
            let value = arguments
                .next()
                .ok_or_else(|| format!("{name}: unknown, or lacks a value"))?;
            let number = || {
                value
                    .parse()
                    .map_err(|_| format!("{name} needs a whole number, not {value:?}"))
            };
            match &*name {
                "--seconds" => options.seconds = Some(number()?),
                "--runs" => options.runs = Some(number()?),
                "--seed" => options.seed = number()?,
                "--from" => options.from = number()?,
                "--only" => options.only = Some(value),
                "--file" => options.file = Some(value.into()),
                "--seeds-to" => options.seeds_to = Some(value.into()),
                "--seeds" => options.folders.push(value.into()),
                _ => return Err(format!("unknown option {name}")),
            }
        }
        Ok(options)
    }

    fn bodies(&self) -> Result<Vec<&'static Body>, String> {
        match &self.only {
            None => Ok(BODIES.iter().collect()),
            Some(name) => match Body::named(name) {
                Some(body) => Ok(vec![body]),
                None => Err(format!("no body is called {name}; --list lists them")),
            },
        }
    }
}

fn main() -> ExitCode {
    delone_filekit::keep_panics_of_others_quiet();
    let run = || -> Result<bool, String> {
        let options = Options::parse(std::env::args().skip(1))?;
        let bodies = options.bodies()?;
        if options.list {
            bodies.iter().for_each(|body| println!("{}", body.name));
            return Ok(true);
        }
        if let Some(file) = &options.file {
            let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
            bodies.iter().for_each(|body| body.run(&bytes));
            return Ok(true);
        }
        let seeds = seeds(&options.folders);
        if let Some(folder) = &options.seeds_to {
            return write_seeds(&bodies, &seeds, folder).map(|()| true);
        }
        fs::create_dir_all(FOLDER).map_err(|error| format!("{FOLDER}: {error}"))?;
        std::thread::spawn(watch);
        // One that fails stops no other.
        let failed = bodies.iter().filter(|body| !fuzz(body, &seeds, &options));
        Ok(failed.count() == 0)
    };
    match run() {
        Ok(right) => ExitCode::from(u8::from(!right)),
        Err(message) => {
            eprintln!("{message}\n\n{USAGE}");
            ExitCode::from(2)
        }
    }
}

fn write_seeds(bodies: &[&Body], seeds: &[Seed], folder: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(failed)?;
    for body in bodies {
        for (i, seed) in seeds
            .iter()
            .enumerate()
            .filter(|(_, seed)| body.takes(seed))
        {
            // The first choices name the format, as far as there is one.
            let bytes = body.input(seed, i as u64 * 257);
            fs::write(
                folder.join(format!("{}-{i}.{}", body.name, seed.kind)),
                bytes,
            )
            .map_err(failed)?;
        }
    }
    Ok(())
}

/// Begun cases, for the watch; when the last was begun, in milliseconds.
static BEGUN: AtomicU64 = AtomicU64::new(0);
static SINCE: AtomicU64 = AtomicU64::new(0);
static CURRENT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

fn now() -> u64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_millis() as u64
}

/// Ends the program if a case takes too long.
fn watch() {
    loop {
        std::thread::sleep(Duration::from_millis(500));
        let (begun, since) = (BEGUN.load(Relaxed), SINCE.load(Relaxed));
        if since > 0
            && now().saturating_sub(since) > LONGEST.as_millis() as u64
            && BEGUN.load(Relaxed) == begun
        {
            let bytes = CURRENT
                .lock()
                .map(|bytes| bytes.clone())
                .unwrap_or_default();
            let kept = keep("slow", &bytes);
            eprintln!(
                "a case takes more than {} s: {}",
                LONGEST.as_secs(),
                kept.display()
            );
            std::process::exit(1);
        }
    }
}

fn keep(name: &str, bytes: &[u8]) -> PathBuf {
    let path = Path::new(FOLDER).join(name);
    if let Err(error) = fs::write(&path, bytes) {
        eprintln!("{}: {error}", path.display());
    }
    path
}

/// Feeds a body; tells whether nothing failed.
fn fuzz(body: &Body, seeds: &[Seed], options: &Options) -> bool {
    let meant: Vec<_> = seeds.iter().filter(|seed| body.takes(seed)).collect();
    let start = Instant::now();
    let seconds = options
        .seconds
        .unwrap_or(if options.runs.is_some() { u64::MAX } else { 1 });
    let end = options.from + options.runs.unwrap_or(u64::MAX - options.from);
    let mut current = fs::File::create(Path::new(FOLDER).join("current")).ok();
    let mut case = options.from;
    while case < end && start.elapsed().as_secs() < seconds {
        let input = broken(body, &meant, seeds, options.seed, case);
        if let Some(file) = &mut current {
            use std::io::{Seek, SeekFrom};
            let told = format!(
                "--only {} --seed {} --from {case} --runs 1\n",
                body.name, options.seed
            );
            let _ = file
                .seek(SeekFrom::Start(0))
                .and_then(|_| file.write_all(told.as_bytes()));
        }
        if let Err(message) = run(body, &input) {
            let path = keep(&format!("{}-{}-{case}", body.name, options.seed), &input);
            println!(
                "{}: case {case} of seed {}: {message}\n  {}",
                body.name,
                options.seed,
                path.display()
            );
            return false;
        }
        case += 1;
    }
    let took = start.elapsed().as_secs_f64();
    println!(
        "{:18} {:9} files {took:7.1} s",
        body.name,
        case - options.from
    );
    true
}

/// Makes the input of a case: the unbroken ones come first.
fn broken(body: &Body, meant: &[&Seed], seeds: &[Seed], seed: u64, case: u64) -> Vec<u8> {
    let mut breaker = Breaker::new(seed ^ case.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let Some(&like) = meant.get(match usize::try_from(case) {
        Ok(case) if case < meant.len() => case,
        _ => breaker.below(meant.len()),
    }) else {
        // Nothing is right for it: noise.
        return (0..breaker.below(300))
            .map(|_| breaker.bits() as u8)
            .collect();
    };
    let mut input = body.input(like, breaker.bits());
    if case >= meant.len() as u64 {
        let mut file = input.split_off(body.choices);
        let other = match breaker.below(4) {
            0 => &seeds[breaker.below(seeds.len())],
            _ => meant[breaker.below(meant.len())],
        };
        breaker.break_file(&mut file, &other.bytes);
        input.append(&mut file);
    }
    input
}

fn run(body: &Body, input: &[u8]) -> Result<(), String> {
    if let Ok(mut current) = CURRENT.lock() {
        current.clear();
        current.extend(input);
    }
    SINCE.store(now().max(1), Relaxed);
    BEGUN.fetch_add(1, Relaxed);
    let outcome = catch_unwind(AssertUnwindSafe(|| body.run(input)));
    SINCE.store(0, Relaxed);
    outcome.map_err(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        text.or_else(|| panic.downcast_ref::<&str>().map(|&s| s.to_owned()))
            .unwrap_or_default()
    })
}
