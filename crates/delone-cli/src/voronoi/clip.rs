//! What cells are clipped to: a box, a domain of a file, or what is usual.

use crate::domain::Crossings;
use crate::exit::Failure;
use crate::files::Outputs;
use crate::numbering::Numbering;
use crate::numbers;
use crate::progress::Progress;
use crate::task::Task;
use delone::voronoi::Domain;
use delone::{ConstrainedDelaunay, DomainRule, Point};
use delone_io::PointSet;
use std::path::{Path, PathBuf};

/// Share of the larger side of the box around the points that is added on each side.
const MARGIN: f64 = 0.1;

/// Options about clipping.
#[derive(clap::Args)]
pub struct Clipping {
    /// What to clip to: a box, X0,Y0,X1,Y1, or a file of polygons (GeoJSON, WKT, .poly) [default: the
    /// box around the points, a tenth larger on each side]
    #[arg(long, value_name = "BOX|FILE", value_parser = clip, allow_hyphen_values = true, help_heading = None)]
    clip: Option<Clip>,
    /// What to do where segments of the clip file cross in a point that is no vertex [default: error]
    #[arg(long, value_enum, value_name = "HOW", requires = "clip", help_heading = None)]
    crossings: Option<Crossings>,
}

/// What was asked for.
#[derive(Clone)]
enum Clip {
    Box([Point; 2]),
    File(PathBuf),
}

/// Takes four numbers as a box, anything else as a file.
fn clip(text: &str) -> Result<Clip, String> {
    let parts: Vec<&str> = text.split(',').collect();
    let looks_like_a_box = parts.len() > 1 && parts.iter().all(|p| p.trim().parse::<f64>().is_ok());
    if !looks_like_a_box {
        return Ok(Clip::File(text.into()));
    }
    match numbers::several(text)?[..] {
        [x0, y0, x1, y1] if x0 != x1 && y0 != y1 => {
            Ok(Clip::Box([Point::new(x0, y0), Point::new(x1, y1)]))
        }
        [_, _, _, _] => Err("the box is empty: two opposite corners are needed".to_owned()),
        _ => Err("a box has four numbers, X0,Y0,X1,Y1".to_owned()),
    }
}

impl Clipping {
    /// Returns the file to clip to, if one is named.
    pub fn file(&self) -> Option<&Path> {
        match &self.clip {
            Some(Clip::File(path)) => Some(path),
            _ => None,
        }
    }

    /// Makes the domain; no output may overwrite its file.
    pub fn domain(
        &self,
        task: &Task,
        points: &PointSet,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<Domain, Failure> {
        let corners = match &self.clip {
            Some(Clip::File(path)) => return self.of_file(path, task, outputs, progress),
            Some(Clip::Box(corners)) => *corners,
            None => around(&points.points),
        };
        let [low, high] = corners;
        // Coordinates have been looked at, here or where they were read.
        Domain::rectangle(low, high).map_err(|error| Failure::NotReached(error.to_string()))
    }

    fn of_file(
        &self,
        path: &Path,
        task: &Task,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<Domain, Failure> {
        let input = task.open_another(path)?;
        outputs.spare(&input.files())?;
        let (mut domain, unused) = input.domain(progress)?;
        progress.note(&unused);
        let numbering = Numbering::of(&input.name(), &domain);
        // Lines without polygons would stand for their convex hull.
        if domain.segments.is_empty() || domain.usual_rule == DomainRule::Hull {
            return Err(Failure::BadInput(format!(
                "{}: there is no polygon to clip to; name a file that has one, or a box",
                numbering.file()
            )));
        }
        let builder = ConstrainedDelaunay::new()
            .crossings(self.crossings.unwrap_or_default().into())
            .domain(domain.usual_rule)
            .threads(task.threads())
            .watch(progress);
        let result = builder.triangulate(domain.take_pslg());
        let result = result.map_err(|error| numbering.failure(error))?;
        progress.note(&numbering.notes(&result));
        Ok(Domain::of(&result))
    }
}

/// Returns the box around some points, with a margin, so that it is never empty.
fn around(points: &[Point]) -> [Point; 2] {
    let [mut low, mut high] = [points.first().copied().unwrap_or_default(); 2];
    for p in points {
        low = Point::new(low.x.min(p.x), low.y.min(p.y));
        high = Point::new(high.x.max(p.x), high.y.max(p.y));
    }
    // Multiplied first, for the extent may be beyond the largest number.
    let [width, height] = [
        MARGIN * high.x - MARGIN * low.x,
        MARGIN * high.y - MARGIN * low.y,
    ];
    let margin = match width.max(height) {
        0.0 => 1.0,
        margin => margin,
    };
    let least = |c: f64| (c - margin).min(c.next_down()).max(f64::MIN);
    let most = |c: f64| (c + margin).max(c.next_up()).min(f64::MAX);
    [
        Point::new(least(low.x), least(low.y)),
        Point::new(most(high.x), most(high.y)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_numbers_are_a_box() {
        assert!(matches!(clip("-1,0,2,3"), Ok(Clip::Box([low, _])) if low.x == -1.0));
        assert!(matches!(clip("land.geojson"), Ok(Clip::File(_))));
        assert!(matches!(clip("a,b.geojson"), Ok(Clip::File(_))));
        for wrong in ["1,2,3", "0,0,0,5", "0,0,inf,1", "1,2,3,4,5"] {
            assert!(clip(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn there_is_room_around_any_points() {
        let big = Point::new(f64::MAX, f64::MAX);
        let tiny = Point::new(1e300, 0.0);
        for points in [
            &[][..],
            &[Point::new(3.0, 4.0)],
            &[tiny, tiny],
            &[big, Point::new(-1.0, -f64::MAX)],
        ] {
            let [low, high] = around(points);
            assert!(low.x < high.x && low.y < high.y, "{points:?}");
            assert!([low.x, low.y, high.x, high.y].iter().all(|c| c.is_finite()));
        }
        let [low, high] = around(&[Point::new(0.0, 0.0), Point::new(10.0, 5.0)]);
        assert_eq!((low.x, low.y, high.x, high.y), (-1.0, -1.0, 11.0, 6.0));
    }
}
