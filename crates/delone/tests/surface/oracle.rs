//! Natural neighbours by clipping the plane with every bisector.

use delone::Point;

/// A convex polygon; each side with the point whose bisector it lies on.
type Cell = Vec<([f64; 2], Option<usize>)>;

/// Clips to the points nearer to `p` than to `q`; the new side belongs to `name`. All is relative to an
/// origin near by.
fn clip(cell: &Cell, p: [f64; 2], q: [f64; 2], name: Option<usize>) -> Cell {
    let squared = |a: [f64; 2]| a[0] * a[0] + a[1] * a[1];
    let side = |x: [f64; 2]| {
        let d = [q[0] - p[0], q[1] - p[1]];
        d[0] * x[0] + d[1] * x[1] - (squared(q) - squared(p)) / 2.0
    };
    let mut clipped = Cell::new();
    for (i, &(a, name_of_side)) in cell.iter().enumerate() {
        let b = cell[(i + 1) % cell.len()].0;
        let (f, g) = (side(a), side(b));
        let meet = || [0, 1].map(|k| a[k] + (b[k] - a[k]) * f / (f - g));
        match (f <= 0.0, g <= 0.0) {
            (true, true) => clipped.push((a, name_of_side)),
            (true, false) => clipped.extend([(a, name_of_side), (meet(), name)]),
            (false, true) => clipped.push((meet(), name_of_side)),
            (false, false) => {}
        }
    }
    clipped
}

fn area(cell: &Cell) -> f64 {
    let sides = (0..cell.len()).map(|i| {
        let (a, b) = (cell[i].0, cell[(i + 1) % cell.len()].0);
        a[0] * b[1] - a[1] * b[0]
    });
    sides.sum::<f64>() / 2.0
}

/// The Voronoi cell of `p` among the points, all relative to `p`; `None` if it is not well bounded.
fn cell_of(points: &[[f64; 2]]) -> Option<Cell> {
    let far = 1e3;
    let corners = [[-far, -far], [far, -far], [far, far], [-far, far]];
    let mut cell: Cell = corners.map(|corner| (corner, None)).into();
    for (i, &v) in points.iter().enumerate() {
        cell = clip(&cell, [0.0; 2], v, Some(i));
    }
    let is_bounded = cell.iter().all(|(_, name)| name.is_some());
    is_bounded.then_some(cell)
}

fn relative(points: &[Point], p: Point) -> Vec<[f64; 2]> {
    points.iter().map(|v| [v.x - p.x, v.y - p.y]).collect()
}

/// Sibson's weights of distinct points, by definition: the areas of what `p` takes from their cells.
pub fn sibson(points: &[Point], p: Point) -> Option<Vec<f64>> {
    let vectors = relative(points, p);
    let cell = cell_of(&vectors)?;
    let taken = |i: usize| {
        let mut part = cell.clone();
        for (j, &other) in vectors.iter().enumerate() {
            if j != i {
                part = clip(&part, vectors[i], other, None);
            }
        }
        area(&part) / area(&cell)
    };
    Some((0..points.len()).map(taken).collect())
}

/// Laplace's weights, by definition: the sides of the cell of `p` over the distances.
pub fn laplace(points: &[Point], p: Point) -> Option<Vec<f64>> {
    let vectors = relative(points, p);
    let cell = cell_of(&vectors)?;
    let mut weights = vec![0.0; points.len()];
    for (i, &(a, name)) in cell.iter().enumerate() {
        let b = cell[(i + 1) % cell.len()].0;
        let v = name?;
        weights[v] += (b[0] - a[0]).hypot(b[1] - a[1]) / vectors[v][0].hypot(vectors[v][1]);
    }
    let sum: f64 = weights.iter().sum();
    Some(weights.into_iter().map(|w| w / sum).collect())
}
