//! Running an algorithm on a drawing, and what there is to say of it.

use super::Description;
use super::clock::Times;
use super::keeper::{Brake, Keeper, Listener};
use crate::Trouble;
use crate::drawing::{Drawing, Rule};
use delone::classic::{About, Algorithm, Input, Takes};
use delone::{Angle, Quality};
use delone_io::Recording;
use serde::Deserialize;

/// What the thesis' own example asks for.
const USUAL_ANGLE: f64 = 20.0;
const USUAL_EDGE: f64 = 3.0;

/// What some algorithms want to know.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub(super) struct Options {
    seed: u64,
    min_angle: Option<f64>,
    max_edge: Option<f64>,
    data_per_triangle: Option<usize>,
    domain: Option<Rule>,
}

/// Runs an algorithm and keeps every step, and when it was taken.
pub(super) fn record(
    name: &str,
    drawing: &Drawing,
    options: &Options,
    listener: &Listener,
) -> Result<(Recording, Times), Trouble> {
    let Some(algorithm) = Algorithm::named(name) else {
        let names = Algorithm::ALL.iter().map(|a| a.about().name);
        let names = names.collect::<Vec<_>>().join(", ");
        let message = format!("no algorithm is called {name:?}; there are {names}");
        return Err(Trouble::asked(message));
    };
    let about = algorithm.about();
    let brake = Brake::default();
    let input = Input {
        watch: &brake,
        ..input(about, drawing, options)
    };
    let mut keeper = Keeper::new(name, &input.pslg.points, &brake, listener);
    let run = algorithm.observe(&input, &mut keeper);
    let run = run.map_err(|error| Trouble::of_drawing(error, drawing));
    let (log, times) = keeper.finish(run)?;
    Ok((Recording::new(about, log), times))
}

/// Gives an algorithm what it takes.
fn input(about: &About, drawing: &Drawing, options: &Options) -> Input<'static> {
    let mut data = drawing.data.clone();
    let rule = options.domain.map_or(data.usual_rule, Into::into);
    let is_bare = matches!(about.takes, Takes::Points | Takes::Data);
    let mut input = match is_bare {
        true => Input::from_points(data.vertices.points),
        false => Input::from_pslg(data.take_pslg()),
    };
    if about.takes == Takes::Triangulation {
        input.start.clone_from(&drawing.start);
    }
    if !is_bare {
        input.domain = rule;
    }
    input.seed = options.seed;
    input.least = options.data_per_triangle.unwrap_or(input.least);
    let is_bounded = options.min_angle.is_some() || options.max_edge.is_some();
    let bound = |given: Option<f64>, usual| if is_bounded { given } else { Some(usual) };
    input.quality = Quality {
        min_angle: bound(options.min_angle, USUAL_ANGLE).map(Angle::degrees),
        max_edge: match about == Algorithm::Thesis.about() {
            true => bound(options.max_edge, USUAL_EDGE),
            false => options.max_edge,
        },
        ..Quality::default()
    };
    input
}

/// Says what there is to say of an algorithm.
pub(super) fn describe(about: &'static About) -> Description {
    Description {
        name: about.name,
        title: about.title,
        source: about.source,
        idea: about.idea,
        cost: about.cost,
        guarantees: about.guarantees,
        takes: match about.takes {
            Takes::Points => "points",
            Takes::Triangulation => "triangulation",
            Takes::Domain => "domain",
            Takes::Data => "data",
        },
        delaunay: about.is_delaunay,
        code: about.code,
    }
}
