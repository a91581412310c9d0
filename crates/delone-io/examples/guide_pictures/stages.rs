//! How many data the triangles hold after Algorithm A, and what B and C make of that.

use super::panels::Panels;
use delone::Point;
use delone::classic::Input;
use delone::scattered::{Cover, DataTriangulation};
use std::error::Error;
use std::path::Path;

/// Draws a panel for each of the three.
pub fn draw(input: &Input, file: &Path) -> Result<(), Box<dyn Error>> {
    let builder = Cover::new(input.least);
    let stages = [
        (
            "A",
            builder
                .clone()
                .divides_edges(false)
                .divides_triangles(false),
        ),
        ("A, then B", builder.clone().divides_triangles(false)),
        ("A, then C", builder.divides_edges(false)),
    ];
    let mut panels = None;
    for (words, builder) in stages {
        let cover = builder.cover(input.pslg.points.iter().copied())?;
        let panels = panels.get_or_insert_with(|| Panels::new(extent(cover.points()), 430.0));
        panel(panels, words, &cover);
    }
    std::fs::write(file, panels.expect("there are stages").page())?;
    Ok(())
}

fn panel(panels: &mut Panels, words: &str, cover: &DataTriangulation) {
    let counts = cover.counts();
    let most = counts.iter().max().expect("there are triangles");
    panels.next(&format!(
        "{words}: {} triangles, at most {most} data in one",
        counts.len()
    ));
    let corners = |t: usize| cover.triangles()[t].map(|v| cover.points()[v.index()]);
    for (t, &count) in counts.iter().enumerate() {
        panels.triangle(corners(t), fill(count, cover));
    }
    for &p in cover.data() {
        panels.dot(p, 2.5, "#444");
    }
    for (t, &count) in counts.iter().enumerate() {
        let at = corners(t).map(|p| panels.place(p));
        let middle = [0, 1].map(|axis| at.iter().map(|p| p[axis]).sum::<f64>() / 3.0);
        panels.number(middle, count);
    }
}

/// The fewer data, the paler; orange for more than wanted.
fn fill(count: usize, cover: &DataTriangulation) -> &'static str {
    match count {
        _ if count > cover.most() => "#f2b36b",
        _ if count >= 2 * cover.least() => "#a9d0e8",
        _ => "#e3f0f7",
    }
}

fn extent(points: &[Point]) -> [Point; 2] {
    let fold = |of: fn(&Point) -> f64, pick: fn(f64, f64) -> f64| {
        points
            .iter()
            .map(of)
            .reduce(pick)
            .expect("there are points")
    };
    let low = Point::new(fold(|p| p.x, f64::min), fold(|p| p.y, f64::min));
    let high = Point::new(fold(|p| p.x, f64::max), fold(|p| p.y, f64::max));
    [low, high]
}
