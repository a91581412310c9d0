//! Options about segments and what lies between them.

use clap::ValueEnum;
use delone::{DomainRule, Locked, SegmentPolicy};
use std::fmt;

/// What to do where segments cross.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Crossings {
    /// refuse, and name both segments
    #[default]
    Error,
    /// cut both, and add a vertex there
    Split,
}

/// Which triangles are kept.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Rule {
    /// all of the convex hull
    Hull,
    /// what the outside cannot reach across segments
    Carve,
    /// what lies behind an odd number of segments: rings in rings are holes
    #[value(name = "evenodd")]
    EvenOdd,
}

/// Which segments are not split.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Kept {
    /// those with the domain on one side only
    Outer,
    /// all
    All,
}

impl From<Kept> for Locked {
    fn from(kept: Kept) -> Self {
        match kept {
            Kept::Outer => Self::Boundary,
            Kept::All => Self::Segments,
        }
    }
}

impl fmt::Display for Rule {
    /// Writes the name that the command line has for it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Hull => "hull",
            Self::Carve => "carve",
            Self::EvenOdd => "evenodd",
        })
    }
}

impl From<Crossings> for SegmentPolicy {
    fn from(crossings: Crossings) -> Self {
        match crossings {
            Crossings::Error => Self::Error,
            Crossings::Split => Self::Split,
        }
    }
}

impl From<DomainRule> for Rule {
    fn from(rule: DomainRule) -> Self {
        match rule {
            DomainRule::Hull => Self::Hull,
            DomainRule::Carve => Self::Carve,
            DomainRule::EvenOdd => Self::EvenOdd,
        }
    }
}

impl From<Rule> for DomainRule {
    fn from(rule: Rule) -> Self {
        match rule {
            Rule::Hull => Self::Hull,
            Rule::Carve => Self::Carve,
            Rule::EvenOdd => Self::EvenOdd,
        }
    }
}
