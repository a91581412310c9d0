//! Who writes and reads.

use crate::machine::version_of;
use crate::peer::Peer;
use std::fmt;
use std::str::FromStr;

/// Something that reads or writes files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// This project.
    Delone,
    /// `meshio`, from Python: meshes.
    Meshio,
    /// `laspy` with `lazrs`, from Python: clouds of points.
    Laspy,
}

impl Engine {
    /// Everybody.
    pub const ALL: [Self; 3] = [Self::Delone, Self::Meshio, Self::Laspy];

    /// Tells whether it knows meshes in files with this ending.
    pub fn knows_mesh(self, ending: &str) -> bool {
        match self {
            Self::Delone => true,
            Self::Meshio => !["npy", "parquet", "ele"].contains(&ending),
            Self::Laspy => false,
        }
    }

    /// Tells whether it knows clouds of points.
    pub const fn knows_clouds(self) -> bool {
        !matches!(self, Self::Meshio)
    }
}

impl Peer for Engine {
    fn python_package(self) -> Option<&'static str> {
        match self {
            Self::Delone => None,
            Self::Meshio => Some("meshio"),
            Self::Laspy => Some("laspy"),
        }
    }

    fn crate_version(self) -> Option<&'static str> {
        (self == Self::Delone).then(|| version_of("delone"))
    }

    fn timed(self) -> String {
        let what = match self {
            Self::Delone => "`write_mesh`, `read_mesh`, `read_points`: points and triangles",
            Self::Meshio => "`write`, `read`: points and cells, as NumPy's arrays",
            Self::Laspy => "`read` and `xyz`, all dimensions of the points being read",
        };
        what.to_owned()
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Delone => "delone",
            Self::Meshio => "meshio",
            Self::Laspy => "laspy",
        })
    }
}

impl FromStr for Engine {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let known = Self::ALL.into_iter().find(|each| each.to_string() == name);
        known.ok_or_else(|| format!("nobody here is called `{name}`"))
    }
}
