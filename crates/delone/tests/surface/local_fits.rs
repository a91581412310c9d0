//! Polynomials fitted to the data of triangles.

use super::support::franke;
use delone::scattered::DataTriangulation;
use delone::surface::{
    Cursor, Evaluation, FitOptions, Grid, Interpolant, LocalFit, LocalFits, average_equal_data,
};
use delone::{Error, Phase, Point, TriangleId, VertexId, Watch, on_threads};
use delone_testkit::cover::{halton, lattice};
use delone_testkit::generate::{Kind, Random};
use proptest::prelude::*;

const UNIT: [Point; 2] = [Point::new(0.0, 0.0), Point::new(1.0, 1.0)];

fn points(list: &[(f64, f64)]) -> Vec<Point> {
    list.iter().map(|&p| p.into()).collect()
}

fn fitted<'t>(
    t: &'t DataTriangulation,
    options: FitOptions,
    f: impl Fn(Point) -> f64,
) -> LocalFits<'t> {
    let values: Vec<f64> = t.data().iter().map(|&p| f(p)).collect();
    LocalFits::new(t, values, options, &()).expect("fits")
}

/// Takes what data there are, however they lie.
fn lenient(degree: usize) -> FitOptions {
    FitOptions {
        max_condition: 1e3,
        max_rings: 4,
        ..FitOptions::degree(degree)
    }
}

/// A polynomial of the degree in two variables about 0, of the size of 1, and its gradient.
fn polynomial(degree: usize, x: f64, y: f64) -> (f64, [f64; 2]) {
    let (mut value, mut gradient) = (0.0, [0.0; 2]);
    for i in 0..=degree as i32 {
        for j in 0..=degree as i32 - i {
            let factor = 0.5 + f64::from((7 * i + 3 * j) % 5) - 2.0;
            let slope = |i: i32, c: f64| {
                if i == 0 {
                    0.0
                } else {
                    f64::from(i) * c.powi(i - 1)
                }
            };
            value += factor * x.powi(i) * y.powi(j);
            gradient[0] += factor * slope(i, x) * y.powi(j);
            gradient[1] += factor * x.powi(i) * slope(j, y);
        }
    }
    (value, gradient)
}

/// Polynomials of degrees up to the one fitted come back, wherever and however large the domain is.
#[test]
fn polynomials_are_reproduced() {
    let places = [
        ([0.0, 0.0], [1.0, 1.0]),
        ([1e6, -1e6], [1.0, 1.0]),
        ([0.0, 0.0], [1e-150, 1e-150]),
        ([-1e150, 0.0], [1e150, 1e150]),
        ([3.0, 5.0], [1e6, 1.0]),
    ];
    for (offset, scale) in places {
        let there = |p: Point| Point::new(offset[0] + scale[0] * p.x, offset[1] + scale[1] * p.y);
        let back = |p: Point| [(p.x - offset[0]) / scale[0], (p.y - offset[1]) / scale[1]];
        let data: Vec<Point> = halton(400).into_iter().map(there).collect();
        let domain = [Point::new(-0.1, -0.1), Point::new(1.1, 1.1)].map(there);
        for degree in 0..=5 {
            let side = if degree < 3 { 3 } else { 2 };
            let t = lattice(domain, side, &data, FitOptions::degree(degree).least_data());
            let t = t.expect("enough data");
            for of in 0..=degree {
                let f = |p: Point| {
                    let [x, y] = back(p);
                    polynomial(of, x, y)
                };
                let surface = fitted(&t, lenient(degree), |p| f(p).0);
                let summary = surface.summary();
                let what = format!("{offset:?} {scale:?} {degree} {of} {summary:?}");
                assert_eq!(summary.num_lowered(), 0, "{what}");
                assert!(summary.max < 1e-10, "{what}");
                for q in halton(150) {
                    let p = there(Point::new(q.x * 1.2 - 0.1, q.y * 1.2 - 0.1));
                    let jet = surface.value_and_gradient(p).expect("inside");
                    let (value, gradient) = f(p);
                    assert!((jet.value - value).abs() < 1e-10, "{what} {jet:?} {value}");
                    for axis in 0..2 {
                        let slope = jet.gradient[axis] * scale[axis];
                        assert!((slope - gradient[axis]).abs() < 1e-8, "{what} {p:?}");
                    }
                }
            }
        }
    }
}

/// Values that are large and alike, tiny or huge: what is left is small beside their differences.
#[test]
fn values_may_be_of_any_size() {
    let t = lattice(UNIT, 2, &halton(200), 6).expect("enough data");
    for (offset, scale) in [(1e9, 1.0), (0.0, 1e-300), (0.0, 1e300), (-1e300, 1e290)] {
        let f = |p: Point| offset + scale * polynomial(2, p.x, p.y).0;
        let surface = fitted(&t, FitOptions::degree(2), f);
        let allowed = 1e-12 * scale + 4e-16 * f64::abs(offset);
        assert!(surface.summary().max <= allowed, "{:?}", surface.summary());
    }
    let constant = fitted(&t, FitOptions::degree(3), |_| 0.1);
    assert!((constant.value(UNIT[0]).expect("inside") - 0.1).abs() < 1e-16);
    assert!(constant.summary().max < 1e-16);
}

/// The square from 0 to 4, cut from (0, 0) to (4, 4); the first data are of the lower triangle.
fn square(lower: &[(f64, f64)], upper: &[(f64, f64)]) -> DataTriangulation {
    let data = [points(lower), points(upper)].concat();
    let corners = points(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.)]);
    let triangles = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::new));
    let holders = (0..data.len()).map(|i| TriangleId::new(usize::from(i >= lower.len())));
    DataTriangulation::from_parts(data, corners, triangles.into(), holders.collect(), 1)
        .expect("parts")
}

fn triangle(data: &[(f64, f64)]) -> DataTriangulation {
    let corners = points(&[(0., 0.), (4., 0.), (4., 4.)]);
    let triangle = [0, 1, 2].map(VertexId::new);
    let holders = vec![TriangleId::new(0); data.len()];
    DataTriangulation::from_parts(points(data), corners, vec![triangle], holders, 1).expect("parts")
}

const GOOD: [(f64, f64); 8] = [
    (0.2, 3.8),
    (1.9, 3.9),
    (3.6, 3.9),
    (0.2, 2.0),
    (1.8, 2.1),
    (0.1, 0.3),
    (1.0, 3.0),
    (2.5, 3.2),
];
/// On the line y = x/2.
const ROW: [(f64, f64); 7] = [
    (0.5, 0.25),
    (1.0, 0.5),
    (1.5, 0.75),
    (2.0, 1.0),
    (2.5, 1.25),
    (3.0, 1.5),
    (3.5, 1.75),
];
/// On the hyperbola (x − 2)·y = 1/2.
const CONIC: [(f64, f64); 7] = [
    (2.25, 2.0),
    (2.5, 1.0),
    (3.0, 0.5),
    (4.0, 0.25),
    (3.25, 0.4),
    (2.3125, 1.6),
    (2.625, 0.8),
];

fn only(t: &DataTriangulation, degree: usize) -> LocalFit {
    fitted(t, FitOptions::degree(degree), franke).fits()[0]
}

#[test]
fn data_that_determine_nothing_are_helped_out() {
    for data in [&ROW, &CONIC] {
        let fit = only(&square(data, &GOOD), 2);
        let LocalFit {
            degree,
            rings,
            data,
            condition,
            ..
        } = fit;
        assert_eq!((degree, rings, data), (2, 1, 15), "{fit:?}");
        assert!(condition <= 5.0, "{fit:?}");
    }
    let t = square(&CONIC, &GOOD);
    let surface = fitted(&t, FitOptions::degree(2), franke);
    let summary = surface.summary();
    assert_eq!((summary.num_widened(), summary.num_lowered()), (1, 0));
    assert_eq!(
        (summary.by_rings, summary.by_degree),
        (vec![1, 1], vec![0, 0, 2])
    );
}

#[test]
fn without_help_the_degree_is_lowered() {
    let fit = only(&triangle(&ROW), 2);
    assert_eq!((fit.degree, fit.rings, fit.data), (0, 0, 7));
    assert!((fit.condition - 1.0).abs() < 1e-15, "{fit:?}");
    assert_eq!(only(&triangle(&CONIC), 2).degree, 1);
    assert_eq!(only(&triangle(&CONIC), 1).degree, 1);
    assert_eq!(only(&triangle(&CONIC[..2]), 3).degree, 0);
    let alone = FitOptions {
        max_rings: 0,
        ..FitOptions::degree(2)
    };
    let t = square(&ROW, &GOOD);
    let surface = fitted(&t, alone, franke);
    assert_eq!(
        surface.fits().iter().map(|f| f.degree).collect::<Vec<_>>(),
        [0, 2]
    );
    assert_eq!(surface.summary().num_lowered(), 1);
}

/// The mean is what a constant comes closest with; equal data count once.
#[test]
fn constants_are_means() {
    let t = triangle(&[(1., 0.5), (2., 1.), (1., 0.5), (3., 1.)]);
    let values = [1.0, 2.0, 1.0, 6.0];
    let surface = LocalFits::new(&t, values, FitOptions::degree(0), &()).expect("fits");
    assert_eq!(surface.value(Point::new(3.0, 3.0)), Some(3.0));
    assert_eq!(surface.residuals(), [-2.0, -1.0, -2.0, 3.0]);
    let fit = surface.fits()[0];
    assert_eq!(fit.data, 3);
    assert!((fit.max - 3.0).abs() < 1e-15 && (fit.rms - (14.0_f64 / 3.0).sqrt()).abs() < 1e-15);
    let summary = surface.summary();
    assert!((summary.max - fit.max).abs() < 1e-15 && (summary.rms - fit.rms).abs() < 1e-15);
}

/// What is left over is perpendicular to every polynomial: no other comes closer.
#[test]
fn residuals_are_those_of_least_squares() {
    let t = lattice(UNIT, 2, &halton(400), 20).expect("enough data");
    for degree in 0..=4 {
        let surface = fitted(&t, FitOptions::degree(degree), franke);
        let residuals = surface.residuals();
        for (f, fit) in surface.fits().iter().enumerate() {
            assert_eq!((fit.degree, fit.rings), (degree, 0));
            let own = t.holders().iter().enumerate();
            let own: Vec<usize> = own
                .filter(|(_, t)| t.index() == f)
                .map(|(i, _)| i)
                .collect();
            for i in 0..=degree as i32 {
                for j in 0..=degree as i32 - i {
                    let term = |p: Point| p.x.powi(i) * p.y.powi(j);
                    let along = own.iter().map(|&i| residuals[i] * term(t.data()[i]));
                    assert!(along.sum::<f64>().abs() < 1e-11, "{degree} {i} {j}");
                }
            }
            let squares: f64 = own.iter().map(|&i| residuals[i] * residuals[i]).sum();
            assert!(((squares / own.len() as f64).sqrt() - fit.rms).abs() < 1e-13);
            let max = own
                .iter()
                .fold(0.0_f64, |max, &i| max.max(residuals[i].abs()));
            assert!((max - fit.max).abs() < 1e-13);
        }
    }
}

/// Errors of values are nowhere magnified by more than is reported.
#[test]
fn magnification_is_a_bound() {
    let mut random = Random::new(4);
    let mut worst = 0.0_f64;
    for round in 0..40 {
        let data = (0..8).map(|_| {
            let (a, b) = (random.unit() * 4.0, random.unit() * 4.0);
            (a.max(b), a.min(b))
        });
        let t = triangle(&data.collect::<Vec<_>>());
        let values: Vec<f64> = t.data().iter().map(|_| random.unit() - 0.5).collect();
        let rms = (values.iter().map(|v| v * v).sum::<f64>() / 8.0).sqrt();
        let options = FitOptions {
            max_condition: 1e4,
            ..FitOptions::degree(1 + round % 2)
        };
        let surface = LocalFits::new(&t, values, options, &()).expect("fits");
        let most = surface.fits()[0].magnification() * rms * (1.0 + 1e-9);
        for p in halton(200) {
            let p = Point::new(4.0 * p.x.max(p.y), 4.0 * p.x.min(p.y));
            let share = surface.value(p).expect("inside").abs() / most;
            assert!(share <= 1.0, "{share} {p:?}");
            worst = worst.max(share);
        }
    }
    assert!(worst > 0.1, "{worst}: no bound worth the name");
}

#[test]
fn grids_lists_and_threads_agree_with_single_points() {
    let t = lattice(UNIT, 5, &halton(3000), 20).expect("enough data");
    let make = || fitted(&t, FitOptions::degree(3), franke);
    let surface = on_threads(1, make).expect("one thread");
    let grid = Grid::with_size(Point::new(-0.3, -0.2), Point::new(1.1, 1.2), 41, 37).expect("grid");
    let raster = Evaluation::new()
        .threads(1)
        .raster(&surface, grid)
        .expect("a raster");
    let mut cursor = Cursor::default();
    let (mut inside, mut centers) = (0, Vec::new());
    for (row, column) in (0..37).flat_map(|row| (0..41).map(move |column| (row, column))) {
        let p = grid.center(column, row);
        let value = surface.value(p);
        assert_eq!(raster.value(column, row), value);
        assert_eq!(surface.value_near(p, &mut cursor), value);
        let is_inside = (0.0..=1.0).contains(&p.x) && (0.0..=1.0).contains(&p.y);
        assert_eq!(value.is_some(), is_inside, "{p:?}");
        inside += usize::from(is_inside);
        centers.push((p, value));
    }
    assert!(inside > 500);
    for threads in [2, 7] {
        let other = on_threads(threads, make).expect("threads");
        assert_eq!(other.fits(), surface.fits());
        let list: Vec<Point> = centers.iter().map(|&(p, _)| p).collect();
        let values = Evaluation::new()
            .threads(threads)
            .values(&other, &list)
            .expect("values");
        assert!(values.iter().zip(&centers).all(|(a, (_, b))| a == b));
    }
}

#[test]
fn on_an_edge_the_lowest_triangle_counts() {
    let t = square(&[(3., 1.)], &[(1., 3.)]);
    let values = [5.0, 7.0];
    let surface = LocalFits::new(&t, values, FitOptions::degree(0), &()).expect("fits");
    let mut cursor = Cursor::default();
    for (p, expected) in [
        ((1., 3.), Some(7.0)),
        ((2., 2.), Some(5.0)),
        ((0., 0.), Some(5.0)),
        ((0., 4.), Some(7.0)),
        ((4.0, 4.0), Some(5.0)),
        ((4.0, 4.0_f64.next_up()), None),
        ((-1e-300, 0.0), None),
        ((f64::NAN, 1.0), None),
        ((f64::INFINITY, 1.0), None),
    ] {
        assert_eq!(surface.value_near(p.into(), &mut cursor), expected, "{p:?}");
        assert_eq!(surface.value(p.into()), expected, "{p:?}");
    }
    assert_eq!(
        surface.triangle_of(Point::new(2., 2.)),
        Some(TriangleId::new(0))
    );
    let none = DataTriangulation::from_parts(vec![], vec![], vec![], vec![], 1).expect("nothing");
    let nothing = LocalFits::new(&none, [], FitOptions::degree(2), &()).expect("nothing");
    assert_eq!(nothing.value(Point::new(0.0, 0.0)), None);
    assert_eq!(nothing.summary().max, 0.0);
}

struct Impatient;

impl Watch for Impatient {
    fn progress(&self, _: Phase, _: u64, _: u64) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let t = triangle(&[(1., 0.5), (2., 1.), (1., 0.5)]);
    let error = |values: &[f64], options, watch: &dyn Watch| {
        let result = LocalFits::new(&t, values, options, watch);
        result.expect_err("refused").to_string()
    };
    let plane = FitOptions::degree(1);
    assert!(error(&[1.0; 2], plane, &()).contains("2 values given for 3 points"));
    assert!(error(&[1.0, f64::NAN, 1.0], plane, &()).contains("point 1 is NaN"));
    let mut values = [1.0, 2.0, 4.0];
    assert!(error(&values, plane, &()).contains("points 0 and 2 are equal"));
    average_equal_data(&t, &mut values).expect("three values");
    assert_eq!(values, [2.5, 2.0, 2.5]);
    assert!(average_equal_data(&t, &mut values[..2]).is_err());
    assert!(error(&values, FitOptions::degree(6), &()).contains("degree of local fits is 6"));
    for max_condition in [f64::NAN, 0.0, -1.0] {
        let options = FitOptions {
            max_condition,
            ..plane
        };
        assert!(error(&values, options, &()).contains("largest condition"));
    }
    assert_eq!(
        error(&values, plane, &Impatient),
        Error::Cancelled.to_string()
    );
}

/// Whatever data there are: two triangles around them have polynomials, with finite values. Tells whether there
/// are two triangles with data.
fn check_kind(kind: Kind, n: usize, seed: u64, scale: f64) -> bool {
    let data = kind.points(n, seed);
    let low = data
        .iter()
        .fold(data[0], |a, b| Point::new(a.x.min(b.x), a.y.min(b.y)));
    let high = data
        .iter()
        .fold(data[0], |a, b| Point::new(a.x.max(b.x), a.y.max(b.y)));
    let Ok(t) = lattice([low, high], 1, &data, 1) else {
        return false;
    };
    let mut random = Random::new(seed);
    let mut values: Vec<f64> = data.iter().map(|_| (random.unit() - 0.5) * scale).collect();
    average_equal_data(&t, &mut values).expect("as many values");
    let surface = LocalFits::new(&t, values, FitOptions::degree(3), &()).expect("fits");
    let summary = surface.summary();
    assert!(
        summary.rms.is_finite() && summary.condition <= 5.0,
        "{kind:?} {summary:?}"
    );
    for fit in surface.fits() {
        assert!(
            fit.rms <= fit.max && fit.max.is_finite(),
            "{kind:?} {fit:?}"
        );
    }
    for &p in &data {
        let value = surface.value(p).expect("data are inside");
        let most = 5.0 * 24.0 * scale;
        assert!(value.abs() <= most, "{kind:?} {p:?} {value}");
    }
    true
}

#[test]
fn any_data_have_a_surface() {
    let mut checked = 0;
    for kind in Kind::ALL {
        for (seed, scale) in [(1, 1.0), (2, 1e-300), (3, 1e300)] {
            checked += usize::from(check_kind(kind, 60, seed, scale));
        }
    }
    assert!(checked > 24, "only {checked}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn few_data_have_a_surface(kind in 0..Kind::ALL.len(), n in 3usize..30, seed in 0u64..1000) {
        check_kind(Kind::ALL[kind], n, seed, 1.0);
    }
}
