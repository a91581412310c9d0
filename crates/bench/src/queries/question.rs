//! What is asked.

use std::fmt;
use std::str::FromStr;

/// What is asked about each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Question {
    /// In which triangle, on which edge or vertex it lies.
    Locate,
    /// Which vertex is nearest.
    Nearest,
    /// Which ten are.
    TenNearest,
}

/// How many of [`Question::TenNearest`].
pub const TEN: usize = 10;

impl Question {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 3] = [Self::Locate, Self::Nearest, Self::TenNearest];

    /// Returns the name by which commands and tables call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Locate => "locate",
            Self::Nearest => "nearest",
            Self::TenNearest => "ten-nearest",
        }
    }
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Question {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|q| q.name() == name);
        found.ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("nobody can be asked `{name}`; there are {names}")
        })
    }
}

/// Returns the square of the distance, as everybody rounds it.
pub fn square(p: [f64; 2], q: [f64; 2]) -> f64 {
    let [x, y] = [p[0] - q[0], p[1] - q[1]];
    x * x + y * y
}
