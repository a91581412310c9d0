//! A few lines for a domain: an outline in, the triangles inside it out.
//!
//! The README shows them with their output; `tests/readme.rs` holds it to both.

use delone::{ConstrainedDelaunay, DomainRule, Pslg};

/// Triangulates an outline with a notch, and carves the notch away.
pub fn main() -> Result<(), delone::Error> {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)];
    let mut outline = Pslg::from_points(corners);
    outline.add_ring([0, 1, 2, 3, 4]);
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    let t = builder.triangulate(outline)?;
    println!("{:?}", t.triangulation().triangles());
    Ok(())
}
