//! Who is asked.

use super::question::{COMPARED, Question, Room};
use crate::machine::version_of;
use crate::peer::Peer;
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
    /// `voronoice`: Voronoi diagrams.
    Voronoice,
    /// `voronator`: Voronoi diagrams.
    Voronator,
    /// SciPy, from Python: Qhull and k-d trees.
    Scipy,
}

impl Engine {
    /// The peers, in the order of the table.
    pub const PEERS: [Self; 6] = [
        Self::Spade,
        Self::Kiddo,
        Self::Rstar,
        Self::Voronoice,
        Self::Voronator,
        Self::Scipy,
    ];

    /// Tells whether it can be asked.
    pub const fn knows(self, question: Question) -> bool {
        match self {
            Self::Delone { .. } => !matches!(question.room(), Room::Edits),
            Self::Singly => !matches!(question.room(), Room::Cells),
            Self::Spade => !matches!(
                question,
                Question::TenNearest | Question::CloughTocher | Question::Undo
            ),
            Self::Kiddo | Self::Rstar => {
                matches!(question, Question::Nearest | Question::TenNearest)
            }
            Self::Voronoice | Self::Voronator => matches!(question.room(), Room::Cells),
            Self::Scipy => {
                !matches!(question, Question::Natural) && !matches!(question.room(), Room::Edits)
            }
        }
    }

    /// Returns how many queries it is asked at most: those who walk from afar for each get fewer.
    pub const fn most_queries(self, question: Question) -> usize {
        match (self, question) {
            (Self::Scipy, Question::Locate) => COMPARED,
            (Self::Singly | Self::Scipy, _) if matches!(question.room(), Room::Surfaces) => {
                COMPARED
            }
            _ => usize::MAX,
        }
    }

    /// Says what is called; `None` if it knows nothing of this.
    pub const fn called(self, room: Room) -> Option<&'static str> {
        Some(match (self, room) {
            (Self::Delone { .. }, Room::Places) => {
                "`triangulate` and `Locator::new`, or `Nearest::of_points`; then `locate_all`, \
                 `nearest_all`, `k_nearest_all`: exact, ties by index"
            }
            (Self::Singly, Room::Places) => {
                "the same; `locate`, `nearest`, `k_nearest`, one by one"
            }
            (Self::Delone { .. }, Room::Cells) => {
                "`triangulate`, `Voronoi::new`, and `clip` to the \
                 bounds of the sites: polygons, lengths of common borders"
            }
            (Self::Delone { .. }, Room::Surfaces) => {
                "`triangulate`, then `Evaluation::values`; before Clough–Tocher, gradients of least \
                 bending"
            }
            (Self::Singly, Room::Surfaces) => {
                "the same; `Interpolant::value`, 20k queries, one by one, each a walk from afar"
            }
            (Self::Singly, Room::Edits) => {
                "`triangulate` and `LiveTriangulation::from_triangulation`; `insert`, `remove`, \
                 `move_to`; `transaction`"
            }
            (Self::Spade, Room::Places) => {
                "`bulk_load` with `HierarchyHintGenerator`; `locate`, `nearest_neighbor`, one by one"
            }
            (Self::Spade, Room::Cells) => {
                "`bulk_load`, then the circumcenters around each of `voronoi_faces`, one list for each \
                 bounded cell: not clipped"
            }
            (Self::Spade, Room::Surfaces) => {
                "`bulk_load` with `HierarchyHintGenerator`; `barycentric`, `natural_neighbor`, one by one"
            }
            (Self::Spade, Room::Edits) => {
                "`bulk_load_stable`; `insert`, `remove`, and for a move both; with \
                 `HierarchyHintGenerator` unless edits are near each other, or removals alone"
            }
            (Self::Kiddo, Room::Places) => {
                "`ImmutableKdTree`; `query_batch` with `nearest_one`, `nearest_n`: rounded distances"
            }
            (Self::Rstar, Room::Places) => {
                "`RTree::bulk_load`; `nearest_neighbor`, `nearest_neighbor_iter`, one by one: rounded \
                 distances"
            }
            (Self::Voronoice, Room::Cells) => {
                "`VoronoiBuilder::build`: rounded predicates, clipped to the bounds"
            }
            (Self::Voronator, Room::Cells) => {
                "`VoronoiDiagram::from_tuple`, without its threads: rounded predicates, clipped to the \
                 bounds"
            }
            (Self::Scipy, Room::Places) => {
                "`Delaunay` (Qhull), then `find_simplex` of 20k queries; `cKDTree`, then `query`, \
                 on one thread: rounded"
            }
            (Self::Scipy, Room::Cells) => {
                "`Voronoi` (Qhull): lists of numbers, not clipped, rounded"
            }
            (Self::Scipy, Room::Surfaces) => {
                "`Delaunay`, then `LinearNDInterpolator`, `CloughTocher2DInterpolator`; 20k queries"
            }
            _ => return None,
        })
    }
}

impl Peer for Engine {
    fn python_package(self) -> Option<&'static str> {
        (self == Self::Scipy).then_some("scipy")
    }

    fn crate_version(self) -> Option<&'static str> {
        Some(version_of(match self {
            Self::Delone { .. } | Self::Singly => "delone",
            Self::Spade => "spade",
            Self::Kiddo => "kiddo",
            Self::Rstar => "rstar",
            Self::Voronoice => "voronoice",
            Self::Voronator => "voronator",
            Self::Scipy => return None,
        }))
    }

    fn timed(self) -> String {
        let called = Room::ALL.into_iter().filter_map(|room| self.called(room));
        called.collect::<Vec<_>>().join("; ")
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
            Self::Voronoice => f.write_str("voronoice"),
            Self::Voronator => f.write_str("voronator"),
            Self::Scipy => f.write_str("scipy"),
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
    use super::{Engine, Peer, Question};

    #[test]
    fn names_parse_back() {
        let ours = [Engine::Delone { threads: 3 }, Engine::Singly];
        for engine in ours.into_iter().chain(Engine::PEERS) {
            assert_eq!(engine.to_string().parse(), Ok(engine));
            let sources = [engine.python_package(), engine.crate_version()];
            assert_eq!(sources.iter().flatten().count(), 1, "{engine}");
        }
        for wrong in ["delone", "delone:0", "kd"] {
            assert!(wrong.parse::<Engine>().unwrap_err().contains("kiddo"));
        }
    }

    #[test]
    fn whoever_answers_says_what_is_called() {
        for engine in [Engine::Delone { threads: 1 }, Engine::Singly]
            .into_iter()
            .chain(Engine::PEERS)
        {
            for room in super::Room::ALL {
                let mut questions = Question::ALL.into_iter().filter(|q| q.room() == room);
                let knows = questions.any(|question| engine.knows(question));
                assert_eq!(knows, engine.called(room).is_some(), "{engine} {room:?}");
            }
        }
    }
}
