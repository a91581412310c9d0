//! A closed fractal line: Koch's snowflake with random angles.
//!
//! A piece of coast runs from a to b inside the triangle a c b. It goes by way of the apex c:
//!
//! ```text
//!            c                 from a to c inside the triangle a p c, whose apex p lies on a b,
//!          ╱╱ ╲╲               from c to b inside the triangle c q b, whose apex q lies on a b.
//!       ╱ ╱     ╲ ╲
//!     ╱  ╱       ╲  ╲          The two have only c in common as long as p comes before q, and
//!   ╱   ╱         ╲   ╲        both lie inside a c b: so no two pieces ever meet but at their
//!  a───p───────────q───b       common ends (Knopp's construction, 1917).
//! ```
//!
//! The base angles are between 19° and 37° (6° and 37° where the coast is [uneven](Character::UNEVEN)),
//! so the wedge p c q is never less than 32° wide, no triangle degenerates, and about 0.5 to 0.7 of a length is left at each step: a line of dimension
//! 1.2 to 1.4, as real coasts are. Rounding puts p and q a little off a b; each step therefore turns
//! them inwards by a millionth, which at a size of 10⁻⁸ is still a hundred times what rounding does.

use crate::Random;

/// How rough a coast is.
#[derive(Clone, Copy)]
pub struct Character {
    /// Range of the tangents of base angles; at most 0.75, or pieces would meet.
    tangents: [f64; 2],
    /// By up to which factor one half of a piece gets more segments than its length asks for.
    unevenness: f64,
}

impl Character {
    /// Segments are equally long, nearly.
    pub const EVEN: Self = Self {
        tangents: [0.35, 0.75],
        unevenness: 1.0,
    };
    /// Next to short segments lie long ones, and bays end in acute corners.
    pub const UNEVEN: Self = Self {
        tangents: [0.1, 0.75],
        unevenness: 2.75,
    };

    fn tangent(self, random: &mut Random) -> f64 {
        random.between(self.tangents[0], self.tangents[1])
    }

    /// Draws what the share of a half is multiplied by.
    fn weight(self, random: &mut Random) -> f64 {
        if self.unevenness == 1.0 {
            return 1.0;
        }
        libm::pow(self.unevenness, random.between(-1.0, 1.0))
    }
}

/// What is left of a tangent at each step.
const INWARDS: f64 = 1.0 - 1e-6;

/// A piece of coast yet to be drawn.
#[derive(Clone, Copy)]
struct Piece {
    from: [f64; 2],
    to: [f64; 2],
    /// Tangents of the base angles, at `from` and at `to`; negative if the apex lies on the right.
    tangents: [f64; 2],
    /// How many segments it becomes.
    segments: usize,
}

/// Makes the vertices of a coast of `count` ≥ 3 segments, counter-clockwise.
///
/// *Cost*: O(count); the pieces that wait are at most about 30.
pub fn vertices(count: usize, character: Character, random: &mut Random) -> Vec<[f64; 2]> {
    let mut waiting: Vec<Piece> = island(count, character, random).into_iter().rev().collect();
    let mut vertices = Vec::with_capacity(count);
    while let Some(piece) = waiting.pop() {
        if piece.segments == 1 {
            vertices.push(piece.from);
        } else {
            let [first, second] = piece.halves(character, random);
            waiting.extend([second, first]);
        }
    }
    vertices
}

/// Makes a triangle whose sides are pieces of coast that begin outwards.
fn island(count: usize, character: Character, random: &mut Random) -> [Piece; 3] {
    let corner = |k: f64| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * k / 3.0);
        [0.5 + 0.42 * cos, 0.5 + 0.42 * sin]
    };
    [0, 1, 2].map(|k| Piece {
        from: corner(k as f64),
        to: corner((k + 1) as f64),
        tangents: [(); 2].map(|()| -character.tangent(random)),
        segments: (count + k) / 3,
    })
}

impl Piece {
    /// Splits the piece at its apex; the segments are shared out by length.
    fn halves(self, character: Character, random: &mut Random) -> [Self; 2] {
        let apex = self.apex();
        let lengths = [[self.from, apex], [apex, self.to]].map(|[a, b]| distance(a, b));
        let weighted = lengths[0] * character.weight(random);
        let share = self.segments as f64 * weighted / (weighted + lengths[1]);
        let first = (share.round() as usize).clamp(1, self.segments - 1);
        // The apices of the halves lie on the other side, towards the base.
        let [at_from, at_to] = self.tangents.map(|tangent| -tangent * INWARDS);
        let mut at_apex = || at_from.signum() * character.tangent(random);
        [
            Self {
                to: apex,
                tangents: [at_from, at_apex()],
                segments: first,
                ..self
            },
            Self {
                from: apex,
                tangents: [at_apex(), at_to],
                segments: self.segments - first,
                ..self
            },
        ]
    }

    fn apex(self) -> [f64; 2] {
        let [s, t] = self.tangents;
        // Where the height above the base, u · s from one end and (1 − u) · t from the other, agrees.
        let along = t / (s + t);
        let above = along * s;
        let [dx, dy] = [0, 1].map(|k| self.to[k] - self.from[k]);
        [
            self.from[0] + along * dx - above * dy,
            self.from[1] + along * dy + above * dx,
        ]
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [dx, dy] = [0, 1].map(|k| b[k] - a[k]);
    (dx * dx + dy * dy).sqrt()
}
