//! A few lines for a mesh: an outline in, good triangles inside it out.
//!
//! The README shows them with their output; `tests/readme.rs` holds it to both.

use delone::{Angle, DomainRule, Pslg, Quality, Refinement};

/// Meshes the front of a house.
pub fn main() -> Result<(), delone::Error> {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 4.0), (0.0, 3.0)];
    let mut outline = Pslg::from_points(corners);
    outline.add_ring([0, 1, 2, 3, 4]);
    let quality = Quality {
        min_angle: Some(Angle::degrees(30.0)),
        max_edge: Some(0.5),
        ..Quality::default()
    };
    let refinement = Refinement::new(quality).domain(DomainRule::Carve);
    let refined = refinement.mesh(outline)?;
    println!("{:?}", refined.report.outcome);
    println!("{} triangles not as asked", refined.report.unmet.len());
    Ok(())
}
