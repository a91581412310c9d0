//! Who is asked.

use super::question::Question;
use crate::machine::version_of;
use std::fmt;
use std::str::FromStr;

/// Something that answers queries, with its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Engine {
    /// This project, all queries at once, on so many threads.
    Delone {
        /// Number of threads.
        threads: usize,
    },
    /// This project, one query after the other.
    Singly,
    /// `spade`: a triangulation with a hierarchy of hints.
    Spade,
    /// `kiddo`: k-d trees.
    Kiddo,
    /// `rstar`: R*-trees.
    Rstar,
}

impl Engine {
    /// The peers, in the order of the table.
    pub const PEERS: [Self; 3] = [Self::Spade, Self::Kiddo, Self::Rstar];

    /// Returns the version in `Cargo.lock`.
    pub fn version(self) -> &'static str {
        version_of(match self {
            Self::Delone { .. } | Self::Singly => "delone",
            Self::Spade => "spade",
            Self::Kiddo => "kiddo",
            Self::Rstar => "rstar",
        })
    }

    /// Tells whether it can be asked.
    pub const fn knows(self, question: Question) -> bool {
        match self {
            Self::Delone { .. } | Self::Singly => true,
            Self::Spade => !matches!(question, Question::TenNearest),
            Self::Kiddo | Self::Rstar => !matches!(question, Question::Locate),
        }
    }

    /// Says what is called.
    pub const fn timed(self) -> &'static str {
        match self {
            Self::Delone { .. } => {
                "`triangulate` and `Locator::new`, or `Nearest::of_points`; then `locate_all`, \
                 `nearest_all`, `k_nearest_all`: exact, ties by index"
            }
            Self::Singly => "the same; `locate`, `nearest`, `k_nearest`, one by one",
            Self::Spade => {
                "`bulk_load` with `HierarchyHintGenerator`; `locate`, `nearest_neighbor`, one by one"
            }
            Self::Kiddo => {
                "`ImmutableKdTree`; `query_batch` with `nearest_one`, `nearest_n`: rounded distances"
            }
            Self::Rstar => {
                "`RTree::bulk_load`; `nearest_neighbor`, `nearest_neighbor_iter`, one by one: rounded \
                 distances"
            }
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Delone { threads } => write!(f, "delone:{threads}"),
            Self::Singly => f.write_str("delone:singly"),
            Self::Spade => f.write_str("spade"),
            Self::Kiddo => f.write_str("kiddo"),
            Self::Rstar => f.write_str("rstar"),
        }
    }
}

impl FromStr for Engine {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let threads = || {
            let threads = name.strip_prefix("delone:")?.parse().ok()?;
            (threads > 0).then_some(Self::Delone { threads })
        };
        let named = || {
            [Self::Singly]
                .into_iter()
                .chain(Self::PEERS)
                .find(|e| e.to_string() == name)
        };
        threads().or_else(named).ok_or_else(|| {
            let peers = Self::PEERS.map(|p| p.to_string()).join(", ");
            format!(
                "nobody called `{name}` answers; there are delone:THREADS, delone:singly, {peers}"
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Engine;

    #[test]
    fn names_parse_back() {
        let ours = [Engine::Delone { threads: 3 }, Engine::Singly];
        for engine in ours.into_iter().chain(Engine::PEERS) {
            assert_eq!(engine.to_string().parse(), Ok(engine));
            assert!(!engine.version().is_empty());
        }
        for wrong in ["delone", "delone:0", "kd"] {
            assert!(wrong.parse::<Engine>().unwrap_err().contains("kiddo"));
        }
    }
}
