//! `spade` at queries, one after the other.

mod edits;

pub use edits::edit;

use super::bounds::Bounds;
use super::input::Input;
use super::job::Answer;
use super::question::{Question, square};
use crate::measure::{Cost, under_the_clock};
use spade::handles::VoronoiVertex::Inner;
use spade::{
    DelaunayTriangulation, FloatTriangulation, HasPosition, HierarchyHintGenerator, Point2,
    PositionInTriangulation, Triangulation,
};

/// A vertex with a value.
struct Sample {
    place: Point2<f64>,
    value: f64,
}

impl HasPosition for Sample {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.place
    }
}

type Mesh<V> = DelaunayTriangulation<V, (), (), (), HierarchyHintGenerator<f64>>;

/// Builds and asks.
///
/// # Errors
/// What spade says, and that it cannot be asked.
pub fn answer(input: &Input) -> Result<Answer, String> {
    match input.question {
        Question::Locate | Question::Nearest => near(input),
        Question::Voronoi => voronoi(input),
        Question::Linear | Question::Natural => values(input),
        other => Err(format!("spade cannot be asked `{other}`")),
    }
}

fn place([x, y]: [f64; 2]) -> Point2<f64> {
    Point2::new(x, y)
}

fn load<V: HasPosition<Scalar = f64>>(vertices: Vec<V>) -> Result<(Mesh<V>, Cost), String> {
    let (mesh, build) = under_the_clock(|| Mesh::bulk_load(vertices));
    Ok((mesh.map_err(|error| error.to_string())?, build))
}

fn near(input: &Input) -> Result<Answer, String> {
    let (mesh, build) = load(input.points.iter().copied().map(place).collect())?;
    let asked: Vec<_> = input.asked.iter().copied().map(place).collect();
    let (work, sum) = if input.question == Question::Locate {
        let (found, work) =
            under_the_clock(|| asked.iter().map(|&p| mesh.locate(p)).collect::<Vec<_>>());
        let is_inside = |found: &PositionInTriangulation| {
            let is_outside = matches!(found, PositionInTriangulation::OutsideOfConvexHull(_));
            f64::from(u8::from(!is_outside))
        };
        (work, input.sum(1, found.iter().map(is_inside)))
    } else {
        let (found, work) = under_the_clock(|| {
            let nearest = |&p| mesh.nearest_neighbor(p).map(|vertex| vertex.fix());
            asked.iter().map(nearest).collect::<Vec<_>>()
        });
        let squares = input.asked.iter().zip(found).filter_map(|(&p, vertex)| {
            let q = mesh.vertex(vertex?).position();
            Some(square(p, [q.x, q.y]))
        });
        (work, input.sum(1, squares))
    };
    Ok(Answer {
        build: Some(build),
        work,
        number: asked.len(),
        sum,
    })
}

/// Makes the bounded cells; nothing is clipped.
fn voronoi(input: &Input) -> Result<Answer, String> {
    let points = input.points.iter().copied().map(place).collect();
    let (cells, work) = under_the_clock(|| {
        let mesh = DelaunayTriangulation::<Point2<f64>>::bulk_load(points)?;
        let cell = |face: spade::handles::VoronoiFace<'_, _, _, _, _>| -> Option<Vec<[f64; 2]>> {
            let corners = face.adjacent_edges().map(|edge| match edge.from() {
                Inner(triangle) => Some(triangle.circumcenter().into()),
                _ => None,
            });
            corners.collect()
        };
        Ok(mesh.voronoi_faces().filter_map(cell).collect::<Vec<_>>())
    });
    let cells = cells.map_err(|error: spade::InsertionError| error.to_string())?;
    let bounds = Bounds::of(&input.points);
    Ok(Answer::of_cells(input, work, &bounds, cells.iter()))
}

fn values(input: &Input) -> Result<Answer, String> {
    let valued = input.points.iter().copied().zip(input.values());
    let samples = valued.map(|(p, value)| Sample {
        place: place(p),
        value,
    });
    let (mesh, build) = load(samples.collect())?;
    let asked: Vec<_> = input.asked.iter().copied().map(place).collect();
    let (values, work) = if input.question == Question::Linear {
        let surface = mesh.barycentric();
        let value = |&p| surface.interpolate(|vertex| vertex.data().value, p);
        under_the_clock(|| asked.iter().map(value).collect::<Vec<_>>())
    } else {
        let surface = mesh.natural_neighbor();
        let value = |&p| surface.interpolate(|vertex| vertex.data().value, p);
        under_the_clock(|| asked.iter().map(value).collect())
    };
    let values = values.into_iter().map(|value| value.unwrap_or(0.0));
    Ok(Answer {
        build: Some(build),
        work,
        number: asked.len(),
        sum: input.sum(1, values),
    })
}
