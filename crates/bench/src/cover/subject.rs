//! Which data are covered.

use crate::stats::{parse_size, size_name};
use delone::Point;
use delone_io::{ReadOptions, Source, read_points};
use delone_testkit::data::{DataKind, data};
use std::fmt;
use std::str::FromStr;

/// The kinds of data that are made, and their names.
const KINDS: [(DataKind, &str); 7] = [
    (DataKind::Uniform, "uniform"),
    (DataKind::Clusters, "clusters"),
    (DataKind::ShipTracks, "tracks"),
    (DataKind::FlightLines, "flights"),
    (DataKind::Lattice, "lattice"),
    (DataKind::Circle, "circle"),
    (DataKind::LineAndPoint, "line"),
];

/// A kind of data that can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Made(DataKind);

impl Made {
    /// The kinds that are measured unless others are asked for.
    pub const USUAL: [Self; 4] = [
        Self(DataKind::Uniform),
        Self(DataKind::Clusters),
        Self(DataKind::ShipTracks),
        Self(DataKind::Lattice),
    ];

    /// Returns its name.
    pub fn name(self) -> &'static str {
        let known = KINDS.iter().find(|(kind, _)| *kind == self.0);
        known.map_or("unknown", |&(_, name)| name)
    }
}

impl fmt::Display for Made {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Made {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let known = KINDS.iter().find(|&&(_, known)| known == name);
        known.map(|&(kind, _)| Self(kind)).ok_or_else(|| {
            let names = KINDS.map(|(_, name)| name).join(", ");
            format!("there are no data called `{name}`; there are {names}")
        })
    }
}

/// Data to be covered; written `KIND:NUMBER`, or as the name of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// So many of a kind.
    Made(Made, usize),
    /// What is in a file.
    File(String),
}

impl Subject {
    /// Makes or reads the data.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn data(&self, seed: u64) -> Result<Vec<Point>, String> {
        match self {
            Self::Made(Made(kind), size) => Ok(data(*kind, *size, seed)),
            Self::File(path) => {
                let found = read_points(&Source::from_arg(path), &ReadOptions::default(), &());
                found
                    .map(|set| set.points)
                    .map_err(|error| error.to_string())
            }
        }
    }

    /// Returns what a table calls the kind: of a file its last name.
    pub fn kind(&self) -> &str {
        match self {
            Self::Made(made, _) => made.name(),
            Self::File(path) => path.rsplit('/').next().unwrap_or(path),
        }
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Made(made, size) => write!(f, "{made}:{}", size_name(*size)),
            Self::File(path) => f.write_str(path),
        }
    }
}

impl FromStr for Subject {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let made = text.split_once(':').and_then(|(kind, size)| {
            let made = kind.parse().ok()?;
            Some(Self::Made(made, parse_size(size).ok()?))
        });
        Ok(made.unwrap_or_else(|| Self::File(text.to_owned())))
    }
}

#[cfg(test)]
mod tests {
    use super::{KINDS, Made, Subject};

    #[test]
    fn subjects_parse_back() {
        let made = KINDS.map(|(kind, _)| Subject::Made(Made(kind), 12_345));
        for subject in made.into_iter().chain([Subject::File("a/b.xyz".into())]) {
            assert_eq!(subject.to_string().parse(), Ok(subject));
        }
        assert!("tides".parse::<Made>().unwrap_err().contains("uniform"));
    }

    #[test]
    fn data_are_as_many_as_asked_for() {
        let subject: Subject = "tracks:300".parse().unwrap();
        assert_eq!(subject.data(1).map(|data| data.len()), Ok(300));
        assert!(Subject::File("no such file.xyz".into()).data(1).is_err());
        assert_eq!(Subject::File("a/b.xyz".into()).kind(), "b.xyz");
    }
}
