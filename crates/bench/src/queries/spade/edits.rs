//! Edits of spade's triangulation.
//!
//! A removal gives the last vertex the number of the removed one, so the numbers of the vertices to come are
//! known before the clock starts. A move is a removal and an insertion.

use super::place;
use crate::measure::under_the_clock;
use crate::queries::edits::{Edit, Edits, sum_of};
use crate::queries::job::Answer;
use crate::queries::question::Question;
use spade::handles::FixedVertexHandle;
use spade::{
    DelaunayTriangulation, HierarchyHintGenerator, HintGenerator, LastUsedVertexHintGenerator,
    Point2, Triangulation,
};

type Mesh<L> = DelaunayTriangulation<Point2<f64>, (), (), (), L>;

/// Makes a triangulation and changes it. Where every edit has to be found anew it has a hierarchy of hints,
/// else it remembers the last vertex.
///
/// # Errors
/// What spade says, and that it takes nothing back.
pub fn edit(question: Question, edits: Edits, check: bool) -> Result<Answer, String> {
    match question {
        _ if edits.is_undone => Err("spade takes nothing back".to_owned()),
        Question::Insert | Question::Move | Question::Nudge => {
            edit_with::<HierarchyHintGenerator<f64>>(edits, check)
        }
        _ => edit_with::<LastUsedVertexHintGenerator>(edits, check),
    }
}

fn edit_with<L: HintGenerator<f64>>(edits: Edits, check: bool) -> Result<Answer, String> {
    let steps = steps(&edits);
    let points = edits.points.into_iter().map(place).collect();
    let (mesh, build) = under_the_clock(|| Mesh::<L>::bulk_load_stable(points));
    let mut mesh = mesh.map_err(|error| error.to_string())?;
    let (outcome, work) = under_the_clock(|| {
        steps.iter().try_for_each(|step| {
            if let Some(vertex) = step.remove {
                mesh.remove(vertex);
            }
            step.insert.map_or(Ok(()), |p| mesh.insert(p).map(drop))
        })
    });
    outcome.map_err(|error| error.to_string())?;
    let triangles = mesh.inner_faces().map(|face| face.positions());
    let sum = check.then(|| sum_of(triangles.map(|corners| corners.map(|p| [p.x, p.y]))));
    Ok(Answer {
        build: Some(build),
        work,
        number: steps.len(),
        sum,
    })
}

/// An edit in spade's words.
struct Step {
    remove: Option<FixedVertexHandle>,
    insert: Option<Point2<f64>>,
}

fn steps(edits: &Edits) -> Vec<Step> {
    let mut numbers = Numbers::new(edits.points.len());
    let step = |&edit: &Edit| match edit {
        Edit::Insert(p) => Step {
            remove: None,
            insert: Some(place(p)),
        },
        Edit::Remove(v) => Step {
            remove: Some(numbers.remove(v)),
            insert: None,
        },
        Edit::Move(v, p) => {
            let remove = Some(numbers.remove(v));
            numbers.insert(v);
            Step {
                remove,
                insert: Some(place(p)),
            }
        }
    };
    edits.list.iter().map(step).collect()
}

/// Which number each vertex has.
struct Numbers {
    number_of: Vec<usize>,
    vertex_at: Vec<usize>,
}

impl Numbers {
    fn new(count: usize) -> Self {
        Self {
            number_of: (0..count).collect(),
            vertex_at: (0..count).collect(),
        }
    }

    fn remove(&mut self, vertex: usize) -> FixedVertexHandle {
        let number = self.number_of[vertex];
        self.vertex_at.swap_remove(number);
        if let Some(&moved) = self.vertex_at.get(number) {
            self.number_of[moved] = number;
        }
        FixedVertexHandle::from_index(number)
    }

    fn insert(&mut self, vertex: usize) {
        self.number_of[vertex] = self.vertex_at.len();
        self.vertex_at.push(vertex);
    }
}
