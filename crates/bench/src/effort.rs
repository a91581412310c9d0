//! How carefully to measure, and whose turn it is.

use std::time::Duration;

/// How often each cell is measured, on which input, and for how long.
#[derive(Clone, Copy, Debug, PartialEq, clap::Args)]
pub struct Effort {
    /// Processes that count for each cell
    #[arg(long, default_value_t = 3)]
    pub runs: usize,
    /// Processes discarded before them
    #[arg(long, default_value_t = 1)]
    pub warmups: usize,
    /// Seed of the input
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Seconds that one process may take, the making of its input included
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "60")]
    pub timeout: Duration,
}

impl Effort {
    /// Lets contenders take turns, so that a slow minute of the machine hits all of them. `turn` hears which
    /// of the runs that count it is; those before are warm-ups.
    pub fn take_turns<C>(&self, group: &mut [C], mut turn: impl FnMut(&mut C, Option<usize>)) {
        for round in 0..self.warmups + self.runs {
            for contender in &mut *group {
                turn(contender, round.checked_sub(self.warmups));
            }
        }
    }

    /// Says in words how the figures come about.
    pub fn in_words(&self) -> String {
        let Self { runs, warmups, .. } = self;
        format!("in a fresh process, median of {runs} after {warmups} warm-ups")
    }
}

fn seconds(text: &str) -> Result<Duration, std::num::ParseIntError> {
    text.parse().map(Duration::from_secs)
}

#[cfg(test)]
mod tests {
    use super::Effort;
    use clap::Parser;
    use std::time::Duration;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        effort: Effort,
    }

    #[test]
    fn warmups_come_first_and_all_take_turns() {
        let args = ["it", "--runs=2", "--warmups=1", "--timeout=7"];
        let effort = CommandLine::parse_from(args).effort;
        assert_eq!(effort.timeout, Duration::from_secs(7));
        let mut turns = Vec::new();
        effort.take_turns(&mut ["a", "b"], |who, run| turns.push((*who, run)));
        let rounds = [None, Some(0), Some(1)];
        assert_eq!(turns, rounds.map(|run| [("a", run), ("b", run)]).concat());
    }
}
