//! One measurement inside a process: time, processor time and peak memory of one triangulation.
//!
//! Peak memory is the resident high-water mark, set back just before the clock starts (Linux;
//! elsewhere memory is not measured). What the engine allocates counts, the input array that the
//! caller had before does not.

use crate::engines::Contender;
use delone_samples::Drawing;
use serde::{Deserialize, Serialize};
use std::fs;
use std::time::Instant;

/// What some work took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// Wall time, seconds.
    pub seconds: f64,
    /// Processor time in user mode, seconds, all threads.
    pub user: f64,
    /// Processor time in the kernel, seconds, all threads.
    pub system: f64,
    /// Resident memory, if the system tells.
    pub memory: Option<Memory>,
}

impl Cost {
    /// Returns what this and then `next` took.
    pub fn and_then(self, next: Self) -> Self {
        let memory = self.memory.zip(next.memory);
        Self {
            seconds: self.seconds + next.seconds,
            user: self.user + next.user,
            system: self.system + next.system,
            memory: memory.map(|(first, last)| Memory {
                before: first.before,
                peak: first.peak.max(last.peak),
                after: last.after,
            }),
        }
    }
}

/// One triangulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// What it took.
    #[serde(flatten)]
    pub cost: Cost,
    /// Finite triangles in the result.
    pub triangles: usize,
    /// Constrained edges in the result, if the engine knows them.
    pub constrained: Option<usize>,
    /// Name of the set of triangles; only from a verified run of an engine that has one.
    pub hash: Option<String>,
}

/// Resident memory around one triangulation, bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Memory {
    /// Before, the input being there.
    pub before: u64,
    /// High-water mark during it.
    pub peak: u64,
    /// After, the result being there.
    pub after: u64,
}

impl Memory {
    /// Returns what the engine needed at its worst, result included and input not.
    pub fn beyond_input(&self) -> u64 {
        self.peak.saturating_sub(self.before)
    }

    /// Returns what the engine needed at its worst and gave back in the end.
    pub fn beyond_output(&self) -> u64 {
        self.peak.saturating_sub(self.after)
    }
}

/// Lets `contender` triangulate `drawing` under the clock; checks the result afterwards if `verify`.
///
/// # Errors
/// What the engine, or its verification, says.
pub fn measure<C: Contender>(contender: &C, drawing: Drawing, verify: bool) -> Result<Run, String> {
    let mut input = contender.prepare(drawing);
    let (output, cost) = under_the_clock(|| contender.triangulate(&mut input));
    let output = output?;
    if verify {
        contender.verify(&output)?;
    }
    Ok(Run {
        cost,
        triangles: contender.num_triangles(&output),
        constrained: contender.num_constrained(&output),
        hash: verify.then(|| contender.hash(&output)).flatten(),
    })
}

/// Does `work`; returns its result and what it took.
pub fn under_the_clock<T>(work: impl FnOnce() -> T) -> (T, Cost) {
    reset_peak();
    let before = resident();
    let processor = ProcessorTime::now();
    let clock = Instant::now();
    let result = work();
    let seconds = clock.elapsed().as_secs_f64();
    let spent = ProcessorTime::now().since(processor);
    let peak = status_bytes("VmHWM:");
    let cost = Cost {
        seconds,
        user: spent.user,
        system: spent.system,
        memory: memory(before, peak, resident()),
    };
    (result, cost)
}

fn memory(before: Option<u64>, peak: Option<u64>, after: Option<u64>) -> Option<Memory> {
    Some(Memory {
        before: before?,
        peak: peak?,
        after: after?,
    })
}

/// Sets the high-water mark back to what is resident now. Where that fails the mark still holds
/// the generation of the input, which needs little more than it does.
fn reset_peak() {
    let _ = fs::write("/proc/self/clear_refs", "5");
}

fn resident() -> Option<u64> {
    status_bytes("VmRSS:")
}

fn status_bytes(key: &str) -> Option<u64> {
    parse_status(&fs::read_to_string("/proc/self/status").ok()?, key)
}

fn parse_status(status: &str, key: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix(key))?;
    let kibibytes: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kibibytes * 1024)
}

/// Processor time of this process, seconds.
#[derive(Clone, Copy)]
struct ProcessorTime {
    user: f64,
    system: f64,
}

impl ProcessorTime {
    #[cfg(unix)]
    fn now() -> Self {
        // SAFETY: all-zero bytes are a valid `rusage`, and the call writes at most one of them.
        let usage = unsafe {
            let mut usage = std::mem::zeroed::<libc::rusage>();
            libc::getrusage(libc::RUSAGE_SELF, &mut usage);
            usage
        };
        let seconds = |time: libc::timeval| time.tv_sec as f64 + time.tv_usec as f64 * 1e-6;
        Self {
            user: seconds(usage.ru_utime),
            system: seconds(usage.ru_stime),
        }
    }

    #[cfg(not(unix))]
    fn now() -> Self {
        Self {
            user: 0.0,
            system: 0.0,
        }
    }

    fn since(self, start: Self) -> Self {
        Self {
            user: self.user - start.user,
            system: self.system - start.system,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Contender, Drawing, measure, parse_status};

    /// Allocates 48 MiB, gives them back, keeps 64 more, and finds as many triangles as there are points.
    struct Glutton;

    impl Contender for Glutton {
        type Input = Vec<[f64; 2]>;
        type Output = (usize, Vec<u8>);

        fn prepare(&self, drawing: Drawing) -> Self::Input {
            drawing.points
        }

        fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String> {
            drop(std::hint::black_box(vec![1u8; 48 << 20]));
            let kept = std::hint::black_box(vec![1u8; 64 << 20]);
            Ok((input.len(), kept))
        }

        fn num_triangles(&self, output: &Self::Output) -> usize {
            output.0
        }

        fn verify(&self, output: &Self::Output) -> Result<(), String> {
            if output.0 == 3 {
                return Err("three is a crowd".to_owned());
            }
            Ok(())
        }
    }

    fn points(count: usize) -> Drawing {
        Drawing {
            points: vec![[0.0; 2]; count],
            segments: Vec::new(),
            holes: Vec::new(),
        }
    }

    #[test]
    fn memory_is_what_the_engine_allocates() {
        let run = measure(&Glutton, points(10), true).unwrap();
        assert_eq!(run.triangles, 10);
        assert!(run.cost.seconds > 0.0);
        if let Some(memory) = run.cost.memory {
            let peak = memory.beyond_input() >> 20;
            assert!((60..130).contains(&peak), "{peak} MiB");
        }
    }

    #[test]
    fn verification_is_asked_for_and_heard() {
        assert!(measure(&Glutton, points(3), false).is_ok());
        let error = measure(&Glutton, points(3), true);
        assert_eq!(error, Err("three is a crowd".to_owned()));
    }

    #[test]
    fn status_lines_parse() {
        let status = "Name:\tx\nVmHWM:\t    2188 kB\nVmRSS:\t 12 kB\n";
        assert_eq!(parse_status(status, "VmHWM:"), Some(2188 * 1024));
        assert_eq!(parse_status(status, "VmSwap:"), None);
    }
}
