//! Sentences with places, and what goes there.

use super::Language;
use delone::{Cut, Item, Point, Sweep, VertexId};

/// A sentence in all languages: `{0}`, `{1}` … are places for its parts.
pub(super) struct Sentence {
    pub texts: [&'static str; 2],
    pub parts: Vec<Part>,
}

/// What a sentence speaks of.
#[derive(Clone, Copy)]
pub(super) enum Part {
    Vertex(VertexId),
    Edge([VertexId; 2]),
    Triangle([VertexId; 3]),
    /// With the word for what it is.
    Item(Item),
    Number(u64),
    Point(Point),
    Cut(Cut),
    Sweep(Sweep),
    Counts([u32; 4]),
}

impl Sentence {
    /// Makes a sentence, English first.
    pub fn new<const N: usize>(texts: [&'static str; 2], parts: [Part; N]) -> Option<Self> {
        let parts = parts.to_vec();
        Some(Self { texts, parts })
    }

    /// Fills in the parts.
    pub fn say(&self, language: Language) -> String {
        let mut text = self.texts[language as usize].to_owned();
        for (i, part) in self.parts.iter().enumerate() {
            text = text.replace(&format!("{{{i}}}"), &part.say(language));
        }
        text
    }
}

impl Part {
    fn say(self, language: Language) -> String {
        let word = |words: [&'static str; 2]| words[language as usize];
        match self {
            Self::Vertex(v) => v.index().to_string(),
            Self::Edge(ends) => joined(ends),
            Self::Triangle(corners) => joined(corners),
            Self::Item(Item::Vertex(v)) => format!("{} {}", word(["vertex", "Punkt"]), v.index()),
            Self::Item(Item::Edge(ends)) => format!("{} {}", word(["edge", "Kante"]), joined(ends)),
            Self::Item(Item::Triangle(corners)) => {
                format!("{} {}", word(["triangle", "Dreieck"]), joined(corners))
            }
            Self::Number(n) => n.to_string(),
            Self::Point(p) => format!("({}, {})", short(p.x), short(p.y)),
            Self::Cut(Cut::Vertical(at)) | Self::Sweep(Sweep::Vertical(at)) => {
                format!("x = {}", short(at))
            }
            Self::Cut(Cut::Horizontal(at)) | Self::Sweep(Sweep::Horizontal(at)) => {
                format!("y = {}", short(at))
            }
            Self::Sweep(Sweep::Circle { radius, .. }) => {
                format!("{} {}", word(["radius", "Radius"]), short(radius))
            }
            Self::Counts(counts) => {
                let counts = counts.iter().filter(|&&count| count > 0);
                let counts: Vec<_> = counts.map(u32::to_string).collect();
                match counts.is_empty() {
                    true => "0".to_owned(),
                    false => counts.join(", "),
                }
            }
        }
    }
}

fn joined<const N: usize>(corners: [VertexId; N]) -> String {
    corners.map(|v| v.index().to_string()).join("–")
}

/// Four digits are enough for the ear.
fn short(c: f64) -> String {
    crate::words::measure(c)
}
