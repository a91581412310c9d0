//! What is triangulated: a kind of points, or a domain; and the task that this makes.

use delone_samples::{Distribution, Domain, Drawing};
use serde::{Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// Which kind of work it is. Each has tables of its own, for the engines are called differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Task {
    /// Delaunay triangulation of points.
    Points,
    /// Constrained Delaunay triangulation of clean segments.
    Domain,
    /// Constrained Delaunay triangulation of crossing segments, which are split.
    Crossings,
}

impl Task {
    /// All tasks.
    pub const ALL: [Self; 3] = [Self::Points, Self::Domain, Self::Crossings];

    /// Names what sizes count, in the singular.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Points => "point",
            Self::Domain | Self::Crossings => "segment",
        }
    }
}

/// Points or a domain, by name; a size and a seed make it definite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    /// So many points.
    Points(Distribution),
    /// So many segments.
    Domain(Domain),
}

impl Subject {
    /// Returns the name by which commands and tables call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Points(distribution) => distribution.name(),
            Self::Domain(domain) => domain.name(),
        }
    }

    /// Returns what is to be done with it.
    pub const fn task(self) -> Task {
        match self {
            Self::Points(_) => Task::Points,
            Self::Domain(domain) if domain.crosses() => Task::Crossings,
            Self::Domain(_) => Task::Domain,
        }
    }

    /// Tells whether it is one closed ring.
    pub const fn is_ring(self) -> bool {
        matches!(self, Self::Domain(domain) if domain.is_ring())
    }

    /// Makes it: `size` points or segments.
    pub fn make(self, size: usize, seed: u64) -> Drawing {
        match self {
            Self::Points(distribution) => Drawing {
                points: distribution.points(size, seed),
                segments: Vec::new(),
                holes: Vec::new(),
            },
            Self::Domain(domain) => domain.draw(size, seed),
        }
    }
}

impl From<Distribution> for Subject {
    fn from(distribution: Distribution) -> Self {
        Self::Points(distribution)
    }
}

impl From<Domain> for Subject {
    fn from(domain: Domain) -> Self {
        Self::Domain(domain)
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Subject {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let points = || name.parse().map(Self::Points);
        let domain = || name.parse().map(Self::Domain);
        points()
            .or_else(|no_points| domain().map_err(|no_domain| format!("{no_points}; {no_domain}")))
    }
}

impl Serialize for Subject {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::{Subject, Task};
    use delone_samples::{Distribution, Domain};

    #[test]
    fn names_parse_back() {
        let points = Distribution::ALL.map(Subject::Points);
        let domains = Domain::ALL.map(Subject::Domain);
        for subject in points.into_iter().chain(domains) {
            assert_eq!(subject.name().parse(), Ok(subject));
        }
        let error = "cost".parse::<Subject>().unwrap_err();
        assert!(error.contains("uniform") && error.contains("coast"));
    }

    #[test]
    fn sizes_count_what_the_unit_says() {
        let line = Subject::from(Distribution::Line);
        assert_eq!(line.make(50, 1).points.len(), 50);
        assert_eq!(line.task(), Task::Points);
        for (domain, task) in [
            (Domain::Spiral, Task::Domain),
            (Domain::Tangle, Task::Crossings),
        ] {
            let subject = Subject::from(domain);
            assert_eq!(subject.make(50, 1).segments.len(), 50);
            assert_eq!(subject.task(), task);
        }
    }
}
