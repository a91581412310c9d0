//! What is said of a triangle that is not as asked: where it lies, what it lacks, and why.

use crate::words::{list, measure};
use delone::check::Shape;
use delone::{Angle, Point, Reason, RefinedMesh, TriangleId, Unmet, VertexId};

/// Says in words what is wrong with the unmet triangles of a mesh, with the numbers of its input.
///
/// ```
/// use delone::{Pslg, Quality, Reason, Refinement};
/// use delone_io::Explainer;
///
/// let mesh = Refinement::new(Quality::default()).mesh(Pslg::default())?;
/// let explainer = Explainer::new(&mesh, 1);
/// assert_eq!(explainer.reason(Reason::Stopped), "the work stopped before its turn");
/// # Ok::<(), delone::Error>(())
/// ```
pub struct Explainer<'a> {
    refined: &'a RefinedMesh,
    base: usize,
}

impl<'a> Explainer<'a> {
    /// Takes a mesh, and the number of the first point and the first segment in the file of its input.
    pub fn new(refined: &'a RefinedMesh, base: usize) -> Self {
        Self { refined, base }
    }

    /// Says where a triangle lies: `(1.5, 0.25)`, the middle of it.
    pub fn place(&self, unmet: &Unmet) -> String {
        place(self.corners(unmet.triangle))
    }

    /// Says which bounds a triangle breaks: `angle 19.37° and edge 2.043 above 2`.
    pub fn lack(&self, unmet: &Unmet) -> String {
        let shape = Shape::of(self.corners(unmet.triangle));
        let asked = &self.refined.report.asked;
        let longest = shape.edges.into_iter().fold(0.0, f64::max);
        // What the asked bound allows, a region or a field forbids.
        let above = |asked: Option<f64>, found: f64| match asked.filter(|&asked| found > asked) {
            Some(asked) => format!(" above {}", bound(asked)),
            None => String::new(),
        };
        let mut parts = Vec::new();
        if unmet.broken.angle {
            parts.push(format!("angle {}", degrees(shape.min_angle())));
        }
        if unmet.broken.edge {
            let above = above(asked.max_edge, longest);
            parts.push(format!("edge {}{above}", measure(longest)));
        }
        if unmet.broken.area {
            let above = above(asked.max_area, shape.area);
            parts.push(format!("area {}{above}", measure(shape.area)));
        }
        list(&parts)
    }

    /// Says why a triangle was left: `segments 1 and 3 meet at vertex 1 at 1°`.
    pub fn reason(&self, reason: Reason) -> String {
        let words = match reason {
            Reason::SmallInputAngle {
                vertex,
                segments,
                angle,
            } => return self.corner(vertex, segments, angle),
            Reason::LockedBoundary => "a segment there must not be split",
            Reason::Precision => "coordinates have no room for another vertex there",
            Reason::Gradation => {
                "another vertex would be far closer to others than the features of the input are"
            }
            Reason::Stopped => "the work stopped before its turn",
            _ => "it was left as it is",
        };
        words.to_owned()
    }

    fn corner(&self, vertex: VertexId, [s, t]: [usize; 2], angle: Angle) -> String {
        let are_numbered = s.max(t) < self.refined.mesh.num_input_segments();
        let segments = match are_numbered {
            true => format!("segments {} and {}", s + self.base, t + self.base),
            false => format!("{} and {}", self.segment(s), self.segment(t)),
        };
        let vertex = self.vertex(vertex);
        format!("{segments} meet at {vertex} at {}", degrees_of(angle))
    }

    fn segment(&self, segment: usize) -> String {
        let mesh = &self.refined.mesh;
        if segment < mesh.num_input_segments() {
            return format!("segment {}", segment + self.base);
        }
        let [a, b] = mesh.segments()[segment].map(|v| v.index() + self.base);
        format!("the hull's edge from {a} to {b}")
    }

    fn vertex(&self, v: VertexId) -> String {
        let mesh = &self.refined.mesh;
        if v.index() < mesh.num_input_points() {
            return format!("vertex {}", v.index() + self.base);
        }
        let Point { x, y } = mesh.triangulation().point(v);
        format!("their crossing ({x}, {y})")
    }

    fn corners(&self, t: TriangleId) -> [Point; 3] {
        let triangulation = self.refined.mesh.triangulation();
        triangulation.triangles()[t.index()].map(|v| triangulation.point(v))
    }
}

/// Writes the middle of a triangle, no finer than a hundredth of its longest edge.
fn place(corners: [Point; 3]) -> String {
    let [a, b, c] = Shape::of(corners).edges;
    let fineness = a.max(b).max(c).max(f64::MIN_POSITIVE).log10().floor() - 1.0;
    let write = |c: f64| {
        if c != 0.0 && !(1e-4..1e15).contains(&c.abs()) {
            return format!("{c:.4e}");
        }
        format!("{c:.*}", (-fineness).clamp(0.0, 17.0) as usize)
    };
    let mean = |along: fn(&Point) -> f64| corners.iter().map(|p| along(p) / 3.0).sum::<f64>();
    format!("({}, {})", write(mean(|p| p.x)), write(mean(|p| p.y)))
}

/// Writes a number as people do who ask for it: with all its digits, and no more.
pub(crate) fn bound(number: f64) -> String {
    match number {
        1e-4..1e6 => number.to_string(),
        _ => format!("{number:e}"),
    }
}

/// Writes an angle: three digits behind the point tell whether it is below the bound.
pub(crate) fn degrees(angle: f64) -> String {
    let text = format!("{angle:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "0" if angle > 0.0 => format!("{angle:.1e}°"),
        text => format!("{text}°"),
    }
}

pub(crate) fn degrees_of(angle: Angle) -> String {
    degrees(angle.to_degrees())
}

#[cfg(test)]
mod tests {
    use super::{degrees, place};
    use delone::Point;

    #[test]
    fn angles_have_as_many_digits_as_they_need() {
        let found = [30.0, 20.5, 29.9996, 29.999, 0.01, 1e-9, 0.0].map(degrees);
        let expected = ["30°", "20.5°", "30°", "29.999°", "0.01°", "1.0e-9°", "0°"];
        assert_eq!(found, expected.map(String::from));
    }

    #[test]
    fn places_are_as_fine_as_their_triangles() {
        let at = |corners: [(f64, f64); 3]| place(corners.map(Point::from));
        assert_eq!(at([(0.0, 0.0), (3.0, 0.0), (0.0, 3.0)]), "(1.0, 1.0)");
        let far = [(456_789.0, 0.0), (456_789.03, 0.0), (456_789.0, 0.03)];
        assert_eq!(at(far), "(456789.010, 0.010)");
        let wide = [(1e30, -1e30), (1e30, 2e30), (2e30, 2e30)];
        assert_eq!(at(wide), "(1.3333e30, 1.0000e30)");
    }
}
