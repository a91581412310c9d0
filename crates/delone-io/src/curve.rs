//! Curves, and the polylines that stand for them.
//!
//! An [`Outline`] is a chain of lines, arcs of ellipses, and Bézier curves of any degree, rational ones
//! included; circles, bulges, splines and the commands of SVG's paths are all made of these. Both kinds of
//! curve are mapped affinely by mapping what defines them, so they are flattened where they end up.
//!
//! No point of the polyline is farther from the curve than the *flatness*, and none of the curve from the
//! polyline, up to the rounding of coordinates:
//! - An arc c + u cos t + v sin t is cut at equal steps h of t. A chord deviates from a curve by at most
//!   h² / 8 times its largest second derivative, which here is the longer half axis.
//! - A Bézier curve of positive weights lies in the hull of its control points. It is halved, by de
//!   Casteljau, until all of them lie within the flatness of the segment between its ends.
//!
//! Ends are those given, bit for bit, and a closed outline ends where it begins. Sines and cosines come from
//! `libm`, so that polylines are the same on every machine.

mod affine;
mod arc;
mod bezier;
mod spline;

pub(crate) use affine::{Affine, Place3};
pub(crate) use arc::Arc;
pub(crate) use spline::Spline;

use crate::Problem;

/// Most pieces of one curve.
const MAX_PIECES: usize = 1 << 16;

/// Most points of all curves of a file together.
pub(crate) const MAX_POINTS: usize = 1 << 24;

/// Largest magnitude of a coordinate of a curve, so that no square overflows.
const FARTHEST: f64 = 1e150;

/// The finest flatness, as a part of the largest coordinate: some units in the last place.
const ROUNDING: f64 = 1e-15;

/// The usual flatness, as a part of the larger side of an outline's box.
const USUAL: f64 = 1e-3;

/// What joins a point of an outline to the next.
#[derive(Clone, Debug)]
pub(crate) enum Piece {
    Line,
    Arc(Arc),
    /// The control points x w, y w, z w, w, those of the ends included.
    Bezier(Vec<[f64; 4]>),
}

/// A chain of pieces.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub start: Place3,
    /// The pieces and where each ends.
    pub pieces: Vec<(Piece, Place3)>,
    /// Whether the end is joined to the start.
    pub is_closed: bool,
}

impl Outline {
    /// Begins an outline.
    pub fn new(start: Place3) -> Self {
        Self {
            start,
            pieces: Vec::new(),
            is_closed: false,
        }
    }

    /// Returns where the outline ends so far.
    pub fn end(&self) -> Place3 {
        self.pieces.last().map_or(self.start, |&(_, to)| to)
    }

    /// Adds a line.
    pub fn line(&mut self, to: Place3) {
        self.pieces.push((Piece::Line, to));
    }

    /// Adds an arc.
    pub fn arc(&mut self, arc: Arc, to: Place3) {
        self.pieces.push((Piece::Arc(arc), to));
    }

    /// Adds a Bézier curve with these control points between its ends.
    pub fn bezier(&mut self, between: &[Place3], to: Place3) {
        let places = [&[self.end()], between, &[to]].concat();
        let control = places.into_iter().map(|[x, y, z]| [x, y, z, 1.0]);
        self.pieces.push((Piece::Bezier(control.collect()), to));
    }

    /// Closes the outline if it ends where it begins but for rounding, a part of its size.
    pub fn close_nearly(&mut self, part: f64) {
        let [size, _] = self.extent();
        let (start, end) = (self.start, self.end());
        if size.is_finite()
            && (0..3).all(|k| (start[k] - end[k]).abs() <= part * size)
            && let Some((_, to)) = self.pieces.last_mut()
        {
            *to = start;
            self.is_closed = true;
        }
    }

    /// Returns the outline as a map moves it.
    pub fn mapped(&self, map: &Affine) -> Self {
        let pieces = self.pieces.iter().map(|(piece, to)| {
            let piece = match piece {
                Piece::Line => Piece::Line,
                Piece::Arc(arc) => Piece::Arc(arc.mapped(map)),
                Piece::Bezier(control) => Piece::Bezier(bezier::mapped(control, map)),
            };
            (piece, map.place(*to))
        });
        Self {
            start: map.place(self.start),
            pieces: pieces.collect(),
            is_closed: self.is_closed,
        }
    }

    /// Makes the polyline; that of a closed outline ends with its first point.
    ///
    /// # Errors
    /// If a coordinate is not finite, or the curve needs more than [`MAX_PIECES`] pieces.
    pub fn flatten(&self, flatness: Option<f64>) -> Result<Vec<Place3>, Problem> {
        let [size, farthest] = self.extent();
        // Straight pieces are not computed with: they may be as far out as numbers go.
        let is_straight = |(piece, _): &(Piece, Place3)| matches!(piece, Piece::Line);
        let fits = match self.pieces.iter().all(is_straight) {
            true => self.ends().flatten().all(|c| c.is_finite()),
            false => farthest <= FARTHEST,
        };
        if !fits {
            let text =
                format!("a point of the curve is farther out than {FARTHEST:e}; scale the drawing");
            return Err(Problem::Other(text));
        }
        let flatness = flatness.unwrap_or(USUAL * size).max(ROUNDING * farthest);
        let mut line = vec![self.start];
        for (piece, to) in &self.pieces {
            match piece {
                Piece::Line => {}
                Piece::Arc(arc) => arc.flatten(flatness, &mut line)?,
                Piece::Bezier(control) => bezier::flatten(control, flatness, &mut line)?,
            }
            line.push(*to);
        }
        if self.is_closed && (line.len() < 2 || self.end() != self.start) {
            line.push(self.start);
        }
        Ok(line)
    }

    /// Lists where pieces begin and end.
    fn ends(&self) -> impl Iterator<Item = Place3> {
        std::iter::once(self.start).chain(self.pieces.iter().map(|&(_, to)| to))
    }

    /// Returns the larger side of the box, and the largest magnitude of a coordinate; of arcs count the ends
    /// and the extremes, of Bézier curves the control points. NaN if one of them is not finite.
    fn extent(&self) -> [f64; 2] {
        let mut corners = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut farthest = 0f64;
        let mut add = |[x, y, z]: Place3| {
            corners[0] = [corners[0][0].min(x), corners[0][1].min(y)];
            corners[1] = [corners[1][0].max(x), corners[1][1].max(y)];
            let magnitude = [x, y, z].map(f64::abs).into_iter().sum::<f64>();
            // A sum keeps what is no number, a maximum forgets it.
            farthest = match farthest < magnitude || magnitude.is_nan() {
                true if !farthest.is_nan() => magnitude,
                _ => farthest,
            };
        };
        add(self.start);
        for (piece, to) in &self.pieces {
            add(*to);
            match piece {
                Piece::Line => {}
                Piece::Arc(arc) => arc.extremes().into_iter().for_each(&mut add),
                Piece::Bezier(control) => control.iter().copied().map(project).for_each(&mut add),
            }
        }
        let [low, high] = corners;
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        [size, farthest]
    }
}

/// Returns the place of homogeneous coordinates.
fn project([x, y, z, w]: [f64; 4]) -> Place3 {
    [x / w, y / w, z / w]
}

/// Returns cosine and sine of an angle in degrees, exact for multiples of 90.
pub(crate) fn unit(degrees: f64) -> [f64; 2] {
    let turned = degrees % 360.0;
    let quarter = (turned / 90.0).round();
    let rest = (turned - 90.0 * quarter).to_radians();
    let [cos, sin] = [libm::cos(rest), libm::sin(rest)];
    match (quarter as i32).rem_euclid(4) {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    }
    .map(|value| value + 0.0)
}

/// Says that a curve needs too many pieces.
fn too_fine() -> Problem {
    Problem::Other(format!(
        "the curve needs more than {MAX_PIECES} pieces to be as flat as asked; choose a larger --flatness"
    ))
}

#[cfg(test)]
mod tests;
