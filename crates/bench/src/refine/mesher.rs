//! The contenders at refinement.

use crate::machine::version_of;
use crate::peer::Peer;
use std::fmt;
use std::str::FromStr;

/// Something that refines, with its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mesher {
    /// This project, on so many threads.
    Delone {
        /// Number of threads.
        threads: usize,
    },
    /// Triangle 1.6, from PyPI's `triangle`.
    Triangle,
    /// CGAL's two-dimensional mesh generator, from PyPI's `cgal`.
    Cgal,
    /// `spade`.
    Spade,
    /// Gmsh, from PyPI's `gmsh`.
    Gmsh,
}

impl Mesher {
    /// The peers, in the order of the table.
    pub const PEERS: [Self; 4] = [Self::Triangle, Self::Cgal, Self::Spade, Self::Gmsh];

    /// Tells whether this is the project itself.
    pub const fn is_ours(self) -> bool {
        matches!(self, Self::Delone { .. })
    }

    /// Tells whether it can be asked for a smallest angle.
    pub const fn bounds_angles(self) -> bool {
        !matches!(self, Self::Gmsh)
    }
}

impl Peer for Mesher {
    fn python_package(self) -> Option<&'static str> {
        match self {
            Self::Delone { .. } | Self::Spade => None,
            Self::Triangle => Some("triangle"),
            Self::Cgal => Some("cgal"),
            Self::Gmsh => Some("gmsh"),
        }
    }

    fn crate_version(self) -> Option<&'static str> {
        match self {
            Self::Delone { .. } => Some(version_of("delone")),
            Self::Spade => Some(version_of("spade")),
            Self::Triangle | Self::Cgal | Self::Gmsh => None,
        }
    }

    fn timed(self) -> String {
        let timed = match self {
            Self::Delone { .. } => {
                "`Refinement::mesh`: triangles, neighbours, constrained edges, report"
            }
            Self::Triangle => "`triangulate` in C, switches `pzQq` and `a`: triangles, segments",
            Self::Cgal => {
                "points and segments inserted one by one, then `refine_Delaunay_mesh_2`; instead \
                 of areas it bounds edges, by that of the equilateral triangle"
            }
            Self::Spade => "`bulk_load_cdt`, then `refine` without outer faces",
            Self::Gmsh => {
                "`generate(2)` of its own geometry; no bounds: the size is the edge of the \
                 equilateral triangle, and no angle is asked for"
            }
        };
        timed.to_owned()
    }
}

impl fmt::Display for Mesher {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Delone { threads } => write!(f, "delone:{threads}"),
            Self::Triangle => f.write_str("triangle"),
            Self::Cgal => f.write_str("cgal"),
            Self::Spade => f.write_str("spade"),
            Self::Gmsh => f.write_str("gmsh"),
        }
    }
}

impl FromStr for Mesher {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let ours = || {
            let threads = name.strip_prefix("delone:")?.parse().ok()?;
            (threads > 0).then_some(Self::Delone { threads })
        };
        let peer = || Self::PEERS.into_iter().find(|p| p.to_string() == name);
        ours().or_else(peer).ok_or_else(|| {
            let peers = Self::PEERS.map(|p| p.to_string()).join(", ");
            format!("nothing that refines is called `{name}`; there are delone:THREADS, {peers}")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Mesher, Peer};

    #[test]
    fn names_parse_back() {
        let ours = [1, 16].map(|threads| Mesher::Delone { threads });
        for mesher in ours.into_iter().chain(Mesher::PEERS) {
            assert_eq!(mesher.to_string().parse(), Ok(mesher));
            let sources = [mesher.python_package(), mesher.crate_version()];
            assert_eq!(sources.iter().flatten().count(), 1, "{mesher}");
        }
        for wrong in ["delone", "delone:0", "netgen"] {
            assert!(wrong.parse::<Mesher>().unwrap_err().contains("cgal"));
        }
    }
}
