//! The search for a place in a triangle, step by step: where the new vertex would be, and how many data each part has.

use super::panels::Panels;
use delone::Point;
use delone::scattered::{Counting, Move, Next, PointSearch, SearchStep};
use std::error::Error;
use std::path::Path;

const CORNERS: [Point; 3] = [
    Point::new(0.0, 0.0),
    Point::new(60.0, 0.0),
    Point::new(20.0, 50.0),
];

const DATA: [Point; 6] = [
    Point::new(13.0, 7.0),
    Point::new(23.0, 46.0),
    Point::new(28.0, 17.0),
    Point::new(27.0, 23.0),
    Point::new(43.0, 15.0),
    Point::new(41.0, 18.0),
];

/// Fills of the parts opposite corners 0, 1 and 2, told apart by people who see red and green alike, too.
const FILLS: [&str; 3] = ["#cfe3f1", "#fbe2c4", "#cfeade"];

/// Draws one panel for each point of the search.
pub fn draw(file: &Path) -> Result<(), Box<dyn Error>> {
    let search = PointSearch::new(CORNERS, &DATA, 2, Counting::Unique)?;
    let steps: Vec<_> = search.collect();
    let mut panels = Panels::new([Point::new(-3.0, -2.0), Point::new(63.0, 52.0)], 330.0);
    for (k, step) in steps.iter().enumerate() {
        panel(&mut panels, k, step, steps.get(k + 1));
    }
    std::fs::write(file, panels.page())?;
    Ok(())
}

/// Draws a point of the search, and the way to the next one.
fn panel(panels: &mut Panels, k: usize, step: &SearchStep, next: Option<&SearchStep>) {
    panels.next(&format!("{}: {}", k + 1, words(step.next)));
    for (part, fill) in FILLS.into_iter().enumerate() {
        let [a, b] = [CORNERS[(part + 1) % 3], CORNERS[(part + 2) % 3]];
        panels.triangle([a, b, step.at], fill);
        panels.number(beside(panels, [a, b]), step.counts[part]);
    }
    DATA.into_iter().for_each(|p| panels.dot(p, 4.0, "#222"));
    if let Some(next) = next {
        panels.way([step.at, next.at]);
    }
    panels.dot(step.at, 5.0, "#c0187a");
    let look = "font-size=\"14\" text-anchor=\"middle\"";
    for (corner, [dx, dy]) in [[-12.0, 6.0], [12.0, 6.0], [0.0, -8.0]]
        .into_iter()
        .enumerate()
    {
        let [x, y] = panels.place(CORNERS[corner]);
        panels.text([x + dx, y + dy], look, &format!("t{}", corner + 1));
    }
}

/// Returns a place outside of the triangle, beside the middle of the edge from `a` to `b`, which has it to its left.
fn beside(panels: &Panels, [a, b]: [Point; 2]) -> [f64; 2] {
    let [[ax, ay], [bx, by]] = [a, b].map(|p| panels.place(p));
    let [dx, dy] = [bx - ax, by - ay];
    let out = 15.0 / dx.hypot(dy);
    // On the page y points down.
    [(ax + bx) / 2.0 - out * dy, (ay + by) / 2.0 + out * dx]
}

fn words(next: Next) -> String {
    match next {
        Next::Moves(Move::Away(corner)) => format!("on, away from t{}", corner + 1),
        Next::Moves(Move::Towards(corner)) => format!("towards t{}", corner + 1),
        Next::Found => "each part can have two".to_owned(),
        other => format!("{other:?}"),
    }
}
