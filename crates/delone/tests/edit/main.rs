//! Live editing: after every edit the triangulation is the one that would be made from scratch.

mod bulk;
mod calls;
mod scripts;

use delone::VertexId;

fn v(i: usize) -> VertexId {
    VertexId::new(i)
}
