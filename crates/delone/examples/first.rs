//! The first five lines: points in, triangles, hull and name out.
//!
//! The README shows them with their output; `tests/readme.rs` holds it to both.

/// Triangulates five points, of which four lie on one circle.
pub fn main() -> Result<(), delone::Error> {
    let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)];
    let t = delone::triangulate(points)?;
    println!("{} triangles: {:?}", t.num_triangles(), t.triangles());
    println!("hull: {:?}", t.hull().collect::<Vec<_>>());
    println!("hash: {}", t.hash());
    Ok(())
}
