//! How the figures stand to what was aimed at.
//!
//! With a bound on angles alone the aim is for the mean of two outlines, holes and coast; the mean of
//! all outlines stands beside it, so that nobody tunes to two. With a bound on areas it is for all.

use super::goal::Load;
use super::mesher::Mesher;
use super::plan::Cell;
use super::report::{find, milliseconds, triangles};
use crate::table::Table;
use delone_samples::Domain;

/// What is aimed at with a smallest angle, as parts of what Triangle makes and takes.
///
/// With a bound on areas the aim at size is 0.75 of what CGAL makes. CGAL's Python module bounds edges,
/// not areas, so this is said in Triangle's triangles: of holes, bound for a million, CGAL made 0.984,
/// 0.982, 0.973 and 0.940 of them at the four angles.
struct Aim {
    angle: f64,
    size: f64,
    size_with_area: f64,
}

const AIMS: [Aim; 4] = [
    Aim::new(20.0, 0.82, 0.984),
    Aim::new(25.0, 0.75, 0.982),
    Aim::new(30.0, 0.67, 0.973),
    Aim::new(33.0, 0.62, 0.940),
];
/// Aims at time, with angles alone and with a bound on areas.
const TIME: f64 = 0.65;
const TIME_WITH_AREA: f64 = 0.33;

impl Aim {
    const fn new(angle: f64, size: f64, cgal: f64) -> Self {
        Self {
            angle,
            size,
            size_with_area: 0.75 * cgal,
        }
    }
}

const ONE_THREAD: Mesher = Mesher::Delone { threads: 1 };

type Figure = fn(&Cell) -> Option<f64>;

/// Makes the table of aims for `load` out of the groups of cells that have it.
pub fn table(load: Load, groups: &[&[Cell]]) -> Table {
    let header = ["angle", "figure", "aim", "holes and coast", "all outlines"];
    let mut table = Table::new(header).with_text_columns(2);
    for aim in AIMS {
        let [size, time] = match load {
            Load::AngleOnly => [aim.size, TIME],
            Load::About(_) => [aim.size_with_area, TIME_WITH_AREA],
        };
        let figures: [(&str, Figure, f64); 2] =
            [("triangles", triangles, size), ("time", milliseconds, time)];
        let at_angle = groups
            .iter()
            .filter(|group| group[0].goal.angle == aim.angle);
        for (what, figure, aimed_at) in figures {
            let ratios = Ratios::of(at_angle.clone().copied(), figure);
            if let Some(all) = mean(&ratios.all) {
                table.push(vec![
                    format!("{}°", aim.angle),
                    format!("{what} to triangle"),
                    format!("{aimed_at:.2}"),
                    mean(&ratios.holes_and_coast).map_or("–".to_owned(), |m| format!("{m:.2}")),
                    format!("{all:.2}"),
                ]);
            }
        }
    }
    table
}

/// Ours to Triangle's, one for each outline.
#[derive(Default)]
struct Ratios {
    holes_and_coast: Vec<f64>,
    all: Vec<f64>,
}

impl Ratios {
    fn of<'a>(groups: impl Iterator<Item = &'a [Cell]>, figure: Figure) -> Self {
        let mut ratios = Self::default();
        for group in groups {
            let Some(ratio) = ratio(group, figure, Mesher::Triangle) else {
                continue;
            };
            ratios.all.push(ratio);
            if matches!(group[0].outline.domain, Domain::Holes | Domain::Coast) {
                ratios.holes_and_coast.push(ratio);
            }
        }
        ratios
    }
}

/// Returns a figure of ours on one thread as part of a rival's.
pub fn ratio(group: &[Cell], figure: Figure, rival: Mesher) -> Option<f64> {
    let of = |mesher| find(group, mesher).and_then(figure);
    Some(of(ONE_THREAD)? / of(rival)?)
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}
