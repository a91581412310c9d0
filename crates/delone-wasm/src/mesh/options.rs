//! What is asked of a mesh.

use crate::drawing::Rule;
use delone::{
    Angle, Budget, DomainRule, Encroachment, Quality, Refinement, SegmentPolicy, Strategy,
};
use delone_io::DomainData;
use serde::Deserialize;

/// Vertices beyond which refinement does not go unless it is asked to.
const USUAL_BUDGET: usize = 1_000_000;

/// How a domain is understood, and how good its triangles are to be.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub(super) struct Options {
    domain: Option<Rule>,
    crossings: Crossings,
    min_angle: Option<f64>,
    max_edge: Option<f64>,
    max_area: Option<f64>,
    region_areas: bool,
    max_vertices: Option<usize>,
    smoothing: usize,
    conforming: bool,
    thesis: bool,
    explains: bool,
}

/// What to do where segments cross.
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Crossings {
    #[default]
    Error,
    Split,
}

impl From<Crossings> for SegmentPolicy {
    fn from(crossings: Crossings) -> Self {
        match crossings {
            Crossings::Error => Self::Error,
            Crossings::Split => Self::Split,
        }
    }
}

impl Options {
    /// Which triangles belong to the domain.
    pub fn rule(&self, data: &DomainData) -> DomainRule {
        self.domain.map_or(data.usual_rule, Into::into)
    }

    /// What to do where segments cross.
    pub fn crossings(&self) -> SegmentPolicy {
        self.crossings.into()
    }

    /// Whether causes are to be kept.
    pub fn explains(&self) -> bool {
        self.explains
    }

    /// Whether the strategy is that of the thesis.
    pub fn is_thesis(&self) -> bool {
        self.thesis
    }

    fn quality(&self) -> Quality {
        Quality {
            min_angle: self.min_angle.filter(|&a| a != 0.0).map(Angle::degrees),
            max_edge: self.max_edge,
            max_area: self.max_area,
            region_areas: self.region_areas,
        }
    }

    /// What refinement is to do.
    pub fn refinement(&self, data: &DomainData) -> Refinement<'_> {
        let budget = Budget {
            vertices: Some(self.max_vertices.unwrap_or(USUAL_BUDGET)),
            ..Budget::default()
        };
        let encroachment = match self.conforming {
            true => Encroachment::Circle,
            false => Encroachment::Lens,
        };
        let strategy = match self.thesis {
            true => Strategy::Thesis,
            false => Strategy::Delaunay,
        };
        Refinement::new(self.quality())
            .budget(budget)
            .encroachment(encroachment)
            .smoothing(self.smoothing)
            .strategy(strategy)
            .crossings(self.crossings.into())
            .domain(self.rule(data))
    }
}
