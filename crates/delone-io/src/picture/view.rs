//! The page, and the map from the plane to the page.

use delone::Point;

/// Ratios of height to width that the drawing may have; flatter or steeper point sets get room
/// around them.
const RATIOS: [f64; 2] = [0.4, 2.0];

/// The proportions of the page, in pixels.
pub(crate) struct Page {
    /// Length of the longer side.
    size: f32,
    /// Size of a detail that should look alike at any size of the picture.
    pub unit: f32,
    margin: f32,
    /// Width kept free on the right.
    legend: f32,
}

impl Page {
    pub fn new(size: f32, legend: bool) -> Self {
        let unit = size / 1600.0;
        Self {
            size,
            unit,
            margin: 56.0 * unit,
            legend: if legend { 190.0 * unit } else { 0.0 },
        }
    }
}

/// Maps the plane to the page.
///
/// Points are first scaled by a power of two to a size at which differences neither overflow nor
/// vanish.
#[derive(Clone, Debug)]
pub(crate) struct View {
    /// Width and height of the page in pixels.
    pub page: [f32; 2],
    /// Corner of the drawing nearest to the origin of the page, and its extent.
    pub drawing: [[f32; 2]; 2],
    power: f64,
    center: Point,
    pixels_per_unit: f64,
}

impl View {
    pub fn new(points: &[Point], page: &Page) -> Self {
        let power = power_for(points);
        let scaled = |p: &Point| Point::new(p.x * power, p.y * power);
        let (low, high) = bounds(points.iter().map(scaled));
        let [width, height] = [high.x - low.x, high.y - low.y];
        let ratio = if width.max(height) > 0.0 {
            (height / width).clamp(RATIOS[0], RATIOS[1])
        } else {
            1.0
        };
        let (across, down) = (2.0 * page.margin + page.legend, 2.0 * page.margin);
        let free = [page.size - across, page.size - down].map(f64::from);
        let wide = free[0].min(free[1] / ratio);
        let area = [wide, wide * ratio];
        Self::within(
            points,
            [area[0] as f32 + across, area[1] as f32 + down].map(f32::round),
            [[page.margin; 2], area.map(|v| v as f32)],
        )
    }

    /// Fits points into a box of the page, given by corner and extent.
    pub fn within(points: &[Point], page: [f32; 2], drawing: [[f32; 2]; 2]) -> Self {
        let power = power_for(points);
        let scaled = |p: &Point| Point::new(p.x * power, p.y * power);
        let (low, high) = bounds(points.iter().map(scaled));
        let [width, height] = [high.x - low.x, high.y - low.y];
        let [across, down] = drawing[1].map(f64::from);
        let per_unit = (across / width).min(down / height);
        Self {
            page,
            drawing,
            power,
            center: Point::new(low.x + width / 2.0, low.y + height / 2.0),
            // One point, or many in one place, lie in the middle at any scale.
            pixels_per_unit: if per_unit.is_finite() { per_unit } else { 0.0 },
        }
    }

    /// Returns a point at a size at which differences are safe.
    pub fn normalized(&self, p: Point) -> Point {
        Point::new(p.x * self.power, p.y * self.power)
    }

    /// Tells whether a point lies within the drawing, and not beside it.
    pub fn holds(&self, p: Point) -> bool {
        let p = self.normalized(p);
        let offsets = [p.x - self.center.x, p.y - self.center.y];
        let [_, extent] = self.drawing;
        (0..2).all(|k| (offsets[k] * self.pixels_per_unit).abs() <= f64::from(extent[k]) / 2.0)
    }

    /// Returns where on the page a point lies, y down.
    pub fn place(&self, p: Point) -> [f32; 2] {
        let p = self.normalized(p);
        let [corner, extent] = self.drawing;
        let along = |offset: f64, axis: usize| {
            // The clamp only takes off what rounding may add.
            let offset = (offset * self.pixels_per_unit) as f32;
            corner[axis] + (extent[axis] / 2.0 + offset).clamp(0.0, extent[axis])
        };
        [along(p.x - self.center.x, 0), along(self.center.y - p.y, 1)]
    }

    /// Returns how many pixels a length takes; the page may end before.
    pub fn length(&self, length: f64) -> f64 {
        length * self.power * self.pixels_per_unit
    }

    /// Returns the area of the drawing in square pixels.
    pub fn area(&self) -> f32 {
        self.drawing[1][0] * self.drawing[1][1]
    }
}

fn bounds(points: impl Iterator<Item = Point>) -> (Point, Point) {
    points
        .map(|p| (p, p))
        .reduce(|(low, high), (p, _)| {
            (
                Point::new(low.x.min(p.x), low.y.min(p.y)),
                Point::new(high.x.max(p.x), high.y.max(p.y)),
            )
        })
        .unwrap_or_default()
}

/// Chooses a power of two that brings extreme points to ordinary size.
fn power_for(points: &[Point]) -> f64 {
    let largest = points
        .iter()
        .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    match largest {
        1e150.. => 2f64.powi(-600),
        0.0..1e-150 => 2f64.powi(600),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Page, View};
    use delone::Point;

    #[test]
    fn every_point_lies_within_the_drawing() {
        let sets: [&[(f64, f64)]; 8] = [
            &[],
            &[(5.0, 5.0)],
            &[(f64::MAX, f64::MIN), (f64::MIN, f64::MAX), (0.0, 5e-324)],
            &[(5e-324, 0.0), (0.0, 1e-323)],
            &[(1e-300, 1e300), (0.0, 0.0)],
            &[(500_000.25, 5_500_000.5), (500_000.5, 5_500_000.5)],
            &[(0.0, 0.0), (0.0, 7.0)],
            &[(1e308, 1e308), (1e308, -1e308)],
        ];
        for set in sets {
            let points: Vec<_> = set.iter().copied().map(Point::from).collect();
            let view = View::new(&points, &Page::new(800.0, true));
            assert!(
                view.page.iter().all(|&v| (64.0..=801.0).contains(&v)),
                "{view:?}"
            );
            let [corner, extent] = view.drawing;
            for place in points.iter().map(|&p| view.place(p)) {
                for k in 0..2 {
                    let within = corner[k]..=corner[k] + extent[k];
                    assert!(within.contains(&place[k]), "{place:?} {view:?}");
                }
            }
        }
    }

    #[test]
    fn y_points_up_and_the_drawing_is_filled() {
        let points = [(0.0, 0.0), (1e-310, 1e-310)].map(Point::from);
        let view = View::new(&points, &Page::new(1000.0, false));
        let [low, high] = points.map(|p| view.place(p));
        assert!(low[0] < 100.0 && high[0] > 900.0, "{low:?} {high:?}");
        assert!(low[1] > 900.0 && high[1] < 100.0, "{low:?} {high:?}");
    }
}
