//! The smallest of several fields.

use super::SizingField;
use crate::Point;

/// A field that obeys several others: their smallest bounds, wherever one is a bound at all.
///
/// ```
/// use delone::{Point, SizingField, sizing::Smallest};
/// let falling = |p: Point| 2.0 - p.x;
/// let rising = |p: Point| 1.0 + p.x;
/// let both = Smallest::of(vec![Box::new(falling), Box::new(rising)]);
/// assert_eq!([0.0, 0.5, 1.0].map(|x| both.max_edge(Point::new(x, 0.0))), [1.0, 1.5, 1.0]);
/// ```
#[derive(Default)]
pub struct Smallest<'a> {
    fields: Vec<Box<dyn SizingField + 'a>>,
}

impl<'a> Smallest<'a> {
    /// Puts fields together; of none there is no bound.
    pub fn of(fields: Vec<Box<dyn SizingField + 'a>>) -> Self {
        Self { fields }
    }

    fn least(&self, bound: impl Fn(&dyn SizingField) -> f64) -> f64 {
        let bounds = self.fields.iter().map(|field| bound(&**field));
        bounds.filter(|&b| b > 0.0).fold(f64::INFINITY, f64::min)
    }
}

impl SizingField for Smallest<'_> {
    fn max_edge(&self, at: Point) -> f64 {
        self.least(|field| field.max_edge(at))
    }

    fn max_area(&self, at: Point) -> f64 {
        self.least(|field| field.max_area(at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Area(f64);

    impl SizingField for Area {
        fn max_edge(&self, _: Point) -> f64 {
            f64::NAN
        }

        fn max_area(&self, _: Point) -> f64 {
            self.0
        }
    }

    #[test]
    fn only_bounds_count() {
        let at = Point::new(0.0, 0.0);
        let none = Smallest::default();
        assert_eq!(
            (none.max_edge(at), none.max_area(at)),
            (f64::INFINITY, f64::INFINITY)
        );
        let senseless = |_: Point| -1.0;
        let field = Smallest::of(vec![
            Box::new(Area(0.5)),
            Box::new(senseless),
            Box::new(Area(0.25)),
        ]);
        assert_eq!(
            (field.max_edge(at), field.max_area(at)),
            (f64::INFINITY, 0.25)
        );
    }
}
