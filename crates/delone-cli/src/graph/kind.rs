//! The graphs, by name.

use crate::numbers;
use crate::words::{counted, measure};
use delone::proximity::{Proximity, Route, Tour};
use delone::{Error, VertexId};
use serde::Serialize;
use std::str::FromStr;

/// Which graph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The Euclidean minimum spanning tree.
    Tree,
    Gabriel,
    /// The relative neighbourhood graph.
    Relative,
    /// Each point with the nearest other one.
    Nearest,
    /// A short closed tour.
    Tour,
    /// The boundary of the alpha shape, of this radius.
    Alpha(Option<f64>),
}

impl FromStr for Kind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(match text {
            "mst" => Self::Tree,
            "gabriel" => Self::Gabriel,
            "rng" => Self::Relative,
            "nearest" => Self::Nearest,
            "tour" => Self::Tour,
            "alpha" => Self::Alpha(None),
            _ => match text.strip_prefix("alpha=") {
                Some(radius) => Self::Alpha(Some(numbers::radius(radius)?)),
                None => {
                    let kinds = "mst, gabriel, rng, nearest, tour, alpha, alpha=R";
                    return Err(format!("there is no such graph; there are: {kinds}"));
                }
            },
        })
    }
}

/// The edges of a graph, and what else is known of it.
pub struct Drawn {
    /// The ends of the edges, in the order in which they are written.
    pub edges: Vec<[VertexId; 2]>,
    pub more: Figures,
    /// The tour, if it is one.
    pub tour: Option<Route>,
}

impl Drawn {
    /// Adds how short a tour could be at best, if this is one.
    pub fn find_bound(&mut self, proximity: &Proximity<'_>) -> Result<(), Error> {
        if let Some(route) = &self.tour {
            let bound = Tour::new().lower_bound(proximity)?;
            self.more.lower_bound = Some(bound);
            self.more.ratio = Some(route.ratio(bound));
        }
        Ok(())
    }
}

/// What some graphs have and others have not; the fields are keys of `--json`.
#[derive(Default, Serialize)]
pub struct Figures {
    #[serde(skip_serializing_if = "Option::is_none")]
    lower_bound: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ratio: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    moves: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    triangles: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    loose_points: Option<usize>,
}

impl Figures {
    /// Says it to people, if there is anything to say.
    pub fn line(&self) -> Option<String> {
        if let [Some(bound), Some(ratio)] = [self.lower_bound, self.ratio] {
            let bound = measure(bound);
            return Some(format!(
                "no tour is shorter than {bound}: this one is at most {ratio:.4} times the shortest"
            ));
        }
        let radius = measure(self.radius?);
        let triangles = counted(self.triangles?, "triangle", "triangles");
        Some(format!("radius {radius}, {triangles} within"))
    }
}

impl From<Vec<[VertexId; 2]>> for Drawn {
    fn from(edges: Vec<[VertexId; 2]>) -> Self {
        Self {
            edges,
            more: Figures::default(),
            tour: None,
        }
    }
}

impl Kind {
    /// Returns the name that the command line has for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tree => "mst",
            Self::Gabriel => "gabriel",
            Self::Relative => "rng",
            Self::Nearest => "nearest",
            Self::Tour => "tour",
            Self::Alpha(_) => "alpha",
        }
    }

    /// Finds the graph.
    pub fn draw(self, proximity: &Proximity<'_>) -> Result<Drawn, Error> {
        Ok(match self {
            Self::Tree => proximity.spanning_tree()?.edges().to_vec().into(),
            Self::Gabriel => proximity.gabriel_graph()?.into(),
            Self::Relative => proximity.relative_neighborhood_graph()?.into(),
            Self::Nearest => {
                let nearest = proximity.nearest_neighbors()?;
                let pair = |(i, near): (usize, Option<VertexId>)| Some([VertexId::new(i), near?]);
                let pairs = nearest.into_iter().enumerate().filter_map(pair);
                pairs.collect::<Vec<_>>().into()
            }
            Self::Tour => tour(proximity)?,
            Self::Alpha(radius) => alpha(proximity, radius)?,
        })
    }
}

/// Plans a closed tour; its edges are its legs.
fn tour(proximity: &Proximity<'_>) -> Result<Drawn, Error> {
    let route = Tour::new().plan(proximity)?;
    let more = Figures {
        moves: Some(route.moves),
        ..Figures::default()
    };
    let edges = match &route.order[..] {
        [] | [_] => Vec::new(),
        order => closed(order).collect(),
    };
    let tour = Some(route);
    Ok(Drawn { edges, more, tour })
}

/// Finds the boundary of the alpha shape, and edges that belong to it without a triangle.
fn alpha(proximity: &Proximity<'_>, radius: Option<f64>) -> Result<Drawn, Error> {
    let shapes = proximity.alpha_shapes()?;
    let radius = match radius {
        Some(radius) => radius,
        None => match shapes.solid_radius()? {
            Some(radius) => radius,
            None => shapes.connecting_radius()?,
        },
    };
    let shape = shapes.shape(radius)?;
    let more = Figures {
        radius: Some(radius),
        triangles: Some(shape.triangles.len()),
        loose_points: Some(shape.singular_vertices.len()),
        ..Figures::default()
    };
    let mut edges: Vec<_> = shape
        .boundary
        .iter()
        .flat_map(|ring| closed(ring))
        .collect();
    edges.extend(shape.singular_edges);
    let tour = None;
    Ok(Drawn { edges, more, tour })
}

/// Visits the edges of a ring.
fn closed(ring: &[VertexId]) -> impl Iterator<Item = [VertexId; 2]> + '_ {
    let next = ring.iter().skip(1).chain(ring.first());
    ring.iter().zip(next).map(|(&a, &b)| [a, b])
}

#[cfg(test)]
mod tests {
    use super::Kind;

    #[test]
    fn kinds_have_names() {
        for name in ["mst", "gabriel", "rng", "nearest", "tour", "alpha"] {
            assert_eq!(name.parse::<Kind>().map(Kind::name), Ok(name));
        }
        assert_eq!("alpha=0.5".parse(), Ok(Kind::Alpha(Some(0.5))));
        for wrong in ["alpha=-1", "alpha=", "TOUR", ""] {
            assert!(wrong.parse::<Kind>().is_err(), "{wrong}");
        }
    }
}
