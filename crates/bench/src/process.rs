//! Runs a job in a process of its own and says what became of it: no crash, hang or runaway
//! allocation of an engine reaches the table maker.

use serde::de::DeserializeOwned;
use serde::{Serialize, Serializer};
use std::io::{self, Read};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Why a job has no answer, or none that counts.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// It did not get through, or what it answered is wrong: `how` in a word or two (`panic`, `error`,
    /// `signal 6`).
    Failed {
        /// The kind of failure.
        how: String,
        /// The last thing the process, or the check, said.
        message: String,
    },
    /// It was stopped after the given time.
    #[serde(serialize_with = "in_seconds")]
    TimedOut(Duration),
}

fn in_seconds<S: Serializer>(limit: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(limit.as_secs_f64())
}

impl Fault {
    /// Makes a failure.
    pub fn failed(how: &str, message: impl ToString) -> Self {
        Self::Failed {
            how: how.to_owned(),
            message: message.to_string(),
        }
    }

    /// Makes the failure of a check that says nothing.
    pub fn silence() -> Self {
        Self::failed("no answer", "the check reported nothing")
    }

    /// Says in a word or two what stands in a table instead of a figure.
    pub fn in_short(&self) -> String {
        match self {
            Self::Failed { how, .. } => how.clone(),
            Self::TimedOut(limit) => format!("> {:.0} s", limit.as_secs_f64()),
        }
    }
}

/// Runs jobs, each in a new process of one program.
#[derive(Clone, Debug)]
pub struct Launcher {
    program: PathBuf,
}

impl Launcher {
    /// Uses the running program, whose subcommand [`SUBCOMMAND`](crate::job::SUBCOMMAND) does jobs.
    ///
    /// # Errors
    /// If the system does not tell where the program is.
    pub fn this_program() -> io::Result<Self> {
        Ok(Self::new(std::env::current_exe()?))
    }

    /// Uses `program`.
    pub fn new(program: PathBuf) -> Self {
        Self { program }
    }

    /// Runs the program with `args`, for no longer than `timeout`, and reads its answer from JSON.
    ///
    /// # Errors
    /// What became of it, if it does not answer.
    pub fn answer<A: DeserializeOwned>(
        &self,
        args: &[String],
        timeout: Duration,
    ) -> Result<A, Fault> {
        self.spawn(args)
            .and_then(|child| watch(child, timeout))
            .unwrap_or_else(|error| Err(Fault::failed("no process", error)))
    }

    fn spawn(&self, args: &[String]) -> io::Result<Child> {
        Command::new(&self.program)
            .args(args)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
    }
}

fn watch<A: DeserializeOwned>(mut child: Child, timeout: Duration) -> io::Result<Result<A, Fault>> {
    let said = drain(child.stdout.take());
    let complained = drain(child.stderr.take());
    let Some(status) = wait(&mut child, timeout)? else {
        child.kill()?;
        child.wait()?;
        return Ok(Err(Fault::TimedOut(timeout)));
    };
    let said = said.join().unwrap_or_default();
    let complained = complained.join().unwrap_or_default();
    Ok(judge(status, &said, &complained))
}

/// Reads everything in the background, so that a talkative child never blocks on a full pipe.
fn drain(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What was read before an error is kept; a cut-off answer fails to parse.
            let _ = pipe.read_to_end(&mut bytes);
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// Waits for the end, asking rarely enough not to disturb the measurement.
fn wait(child: &mut Child, timeout: Duration) -> io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    while start.elapsed() < timeout {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        thread::sleep(Duration::from_millis(5));
    }
    Ok(None)
}

fn judge<A: DeserializeOwned>(
    status: ExitStatus,
    said: &str,
    complained: &str,
) -> Result<A, Fault> {
    if status.success() {
        return serde_json::from_str(said).map_err(|error| Fault::failed("no answer", error));
    }
    Err(match status.code() {
        Some(101) => Fault::failed("panic", panic_message(complained)),
        Some(_) => Fault::failed("error", last_line(complained)),
        None => Fault::failed(&signal_name(status), last_line(complained)),
    })
}

#[cfg(unix)]
fn signal_name(status: ExitStatus) -> String {
    use std::os::unix::process::ExitStatusExt;
    format!("signal {}", status.signal().unwrap_or_default())
}

#[cfg(not(unix))]
fn signal_name(_: ExitStatus) -> String {
    "killed".to_owned()
}

/// Returns the line that follows `thread … panicked at …:`.
fn panic_message(complained: &str) -> &str {
    let mut lines = complained.lines();
    let panicked = lines.any(|line| line.contains("panicked at"));
    let message = lines.next().filter(|_| panicked);
    message.unwrap_or_else(|| last_line(complained))
}

fn last_line(complained: &str) -> &str {
    complained.lines().next_back().unwrap_or_default()
}

#[cfg(all(test, unix))]
mod tests {
    use super::{Fault, drain, judge, wait, watch};
    use crate::job::Answer;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    fn shell(script: &str) -> Child {
        Command::new("sh")
            .args(["-c", script])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("a shell")
    }

    fn outcome(script: &str) -> Result<Answer, Fault> {
        watch(shell(script), Duration::from_secs(20)).expect("a child")
    }

    fn failure(outcome: Result<Answer, Fault>) -> (String, String) {
        match outcome {
            Err(Fault::Failed { how, message }) => (how, message),
            other => panic!("{other:?} is no failure"),
        }
    }

    #[test]
    fn answers_come_through() {
        let answer =
            outcome(r#"echo '{"runs": [], "expected": {"triangles": 5, "constrained": 0}}'"#);
        assert!(matches!(answer, Ok(a) if a.expected.is_some_and(|e| e.triangles == 5)));
    }

    #[test]
    fn failures_are_told_apart() {
        let panic =
            r"printf 'note\nthread main panicked at x.rs:1:2:\nnot yet\nhint\n' >&2; exit 101";
        assert_eq!(failure(outcome(panic)), ("panic".into(), "not yet".into()));
        let error = "echo 'no seed' >&2; exit 1";
        assert_eq!(failure(outcome(error)), ("error".into(), "no seed".into()));
        assert_eq!(failure(outcome("kill -9 $$")).0, "signal 9");
        assert_eq!(failure(outcome("echo '{'")).0, "no answer");
    }

    #[test]
    fn hanging_children_are_stopped() {
        let start = Instant::now();
        let timeout = Duration::from_millis(50);
        let hung: Result<Answer, _> = watch(shell("exec sleep 30"), timeout).expect("a child");
        assert_eq!(hung, Err(Fault::TimedOut(timeout)));
        assert!(start.elapsed() < Duration::from_secs(20));
    }

    #[test]
    fn much_output_does_not_block_the_child() {
        let mut child = shell("yes | head -c 1000000");
        let said = drain(child.stdout.take());
        let status = wait(&mut child, Duration::from_secs(20)).unwrap().unwrap();
        let said = said.join().unwrap();
        assert_eq!(said.len(), 1_000_000);
        assert_eq!(failure(judge(status, &said, "")).0, "no answer");
    }
}
