//! The data of paths: SVG 1.1 and 2, section *Path data*.

use crate::curve::{Arc, Outline};
use crate::{Problem, scan};
use std::f64::consts::TAU;

/// Reads the data of a path: its subpaths, each closed or not.
///
/// # Errors
/// If the data are none, with what was wanted at which character of them.
pub(super) fn parse(data: &[u8]) -> Result<Vec<Outline>, Problem> {
    let mut pen = Pen {
        numbers: Numbers { data, position: 0 },
        done: Vec::new(),
        outline: None,
        at: [0.0; 2],
        start: [0.0; 2],
        control: None,
    };
    pen.run()?;
    Ok(pen.done.into_iter().chain(pen.outline).collect())
}

/// Reads numbers as attributes have them: `1,2`, `1-2`, `.5.5`.
pub(super) struct Numbers<'a> {
    pub data: &'a [u8],
    pub position: usize,
}

impl<'a> Numbers<'a> {
    /// Reads a list of numbers.
    pub fn all(data: &'a [u8]) -> Result<Vec<f64>, Problem> {
        let mut numbers = Numbers { data, position: 0 };
        let mut found = Vec::new();
        while numbers.peek().is_some() {
            found.push(numbers.number()?);
        }
        Ok(found)
    }

    /// Returns the next byte that is no blank and no comma.
    fn peek(&mut self) -> Option<u8> {
        let rest = &self.data[self.position..];
        let is_between = |b: &u8| b.is_ascii_whitespace() || *b == b',';
        self.position += rest.iter().take_while(|b| is_between(b)).count();
        self.data.get(self.position).copied()
    }

    /// Reads a number, which must be finite.
    pub fn number(&mut self) -> Result<f64, Problem> {
        self.peek();
        let rest = &self.data[self.position..];
        let length = number_length(rest);
        let text = &rest[..length.max(1).min(rest.len())];
        let value = scan::number(&rest[..length]).filter(|_| length > 0);
        match value {
            Some(value) if value.is_finite() => {
                self.position += length;
                Ok(value)
            }
            Some(_) => Err(self.expected("a finite number", text)),
            None => Err(self.expected("a number", text)),
        }
    }

    /// Reads a flag of an arc, which need not be set apart.
    fn flag(&mut self) -> Result<bool, Problem> {
        let found = self.peek();
        let text = &self.data[self.position..][..usize::from(found.is_some())];
        match found {
            Some(digit @ (b'0' | b'1')) => {
                self.position += 1;
                Ok(digit == b'1')
            }
            _ => Err(self.expected("a flag, 0 or 1", text)),
        }
    }

    fn expected(&self, what: &str, found: &[u8]) -> Problem {
        let found = match found {
            [] => "its end".to_owned(),
            text => format!("{:?}", scan::show(text)),
        };
        Problem::Other(format!(
            "expected {what} at character {} of the data, found {found}",
            self.position + 1
        ))
    }
}

/// Counts the bytes of the number at the beginning of a text; 0 if there is none.
fn number_length(text: &[u8]) -> usize {
    let digits = |from: usize| {
        let rest = &text[from.min(text.len())..];
        rest.iter().take_while(|b| b.is_ascii_digit()).count()
    };
    let sign = usize::from(matches!(text.first(), Some(b'+' | b'-')));
    let whole = digits(sign);
    let mut end = sign + whole;
    let mut fraction = 0;
    if text.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        // Without digits it is a unit, such as em.
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    end
}

/// Follows the commands.
struct Pen<'a> {
    numbers: Numbers<'a>,
    done: Vec<Outline>,
    /// The subpath that is drawn.
    outline: Option<Outline>,
    at: [f64; 2],
    start: [f64; 2],
    /// The last control point, of a cubic curve if the flag is set, which smooth curves go on from.
    control: Option<(bool, [f64; 2])>,
}

impl Pen<'_> {
    fn run(&mut self) -> Result<(), Problem> {
        let mut command = None;
        while let Some(byte) = self.numbers.peek() {
            let previous: Option<u8> = command;
            let next = match (byte, previous) {
                (byte, _) if byte.is_ascii_alphabetic() => {
                    self.numbers.position += 1;
                    byte
                }
                // Without a command, the last one goes on, and a move goes on as lines.
                (_, Some(b'M')) => b'L',
                (_, Some(b'm')) => b'l',
                (_, Some(last)) if !last.eq_ignore_ascii_case(&b'z') => last,
                _ => return Err(self.numbers.expected("a command", &[byte])),
            };
            if previous.is_none() && !next.eq_ignore_ascii_case(&b'm') {
                self.numbers.position -= 1;
                return Err(self
                    .numbers
                    .expected("M or m, which begin a path,", &[byte]));
            }
            self.command(next)?;
            command = Some(next);
        }
        Ok(())
    }

    fn command(&mut self, command: u8) -> Result<(), Problem> {
        let base = match command.is_ascii_lowercase() {
            true => self.at,
            false => [0.0; 2],
        };
        let before = self.control.take();
        match command.to_ascii_uppercase() {
            b'M' => self.move_to(base)?,
            b'L' => {
                let to = self.point(base)?;
                self.line(to);
            }
            b'H' => {
                let x = base[0] + self.numbers.number()?;
                self.line([x, self.at[1]]);
            }
            b'V' => {
                let y = base[1] + self.numbers.number()?;
                self.line([self.at[0], y]);
            }
            b'C' => {
                let [a, b, to] = [self.point(base)?, self.point(base)?, self.point(base)?];
                self.curve(&[a, b], to);
            }
            b'S' => {
                let a = self.mirrored(before.filter(|(is_cubic, _)| *is_cubic));
                let [b, to] = [self.point(base)?, self.point(base)?];
                self.curve(&[a, b], to);
            }
            b'Q' => {
                let [a, to] = [self.point(base)?, self.point(base)?];
                self.curve(&[a], to);
            }
            b'T' => {
                let a = self.mirrored(before.filter(|(is_cubic, _)| !*is_cubic));
                let to = self.point(base)?;
                self.curve(&[a], to);
            }
            b'A' => self.arc(base)?,
            b'Z' => self.close(),
            _ => {
                self.numbers.position -= 1;
                let found = [command];
                return Err(self
                    .numbers
                    .expected("one of the commands MLHVCSQTAZ", &found));
            }
        }
        Ok(())
    }

    fn point(&mut self, base: [f64; 2]) -> Result<[f64; 2], Problem> {
        Ok([
            base[0] + self.numbers.number()?,
            base[1] + self.numbers.number()?,
        ])
    }

    fn move_to(&mut self, base: [f64; 2]) -> Result<(), Problem> {
        self.at = self.point(base)?;
        self.start = self.at;
        self.done.extend(self.outline.take());
        self.outline = Some(Outline::new(flat(self.at)));
        Ok(())
    }

    fn close(&mut self) {
        if let Some(mut outline) = self.outline.take() {
            outline.is_closed = true;
            self.done.push(outline);
        }
        self.at = self.start;
    }

    /// Returns the subpath that is drawn; after a close, a new one begins where the last did.
    fn outline(&mut self) -> &mut Outline {
        let start = self.start;
        self.outline
            .get_or_insert_with(|| Outline::new(flat(start)))
    }

    fn line(&mut self, to: [f64; 2]) {
        self.outline().line(flat(to));
        self.at = to;
    }

    fn curve(&mut self, between: &[[f64; 2]], to: [f64; 2]) {
        let last = between[between.len() - 1];
        let between: Vec<_> = between.iter().copied().map(flat).collect();
        self.outline().bezier(&between, flat(to));
        self.control = Some((between.len() == 2, last));
        self.at = to;
    }

    /// Returns the control point on the other side of where the pen is.
    fn mirrored(&self, control: Option<(bool, [f64; 2])>) -> [f64; 2] {
        control.map_or(self.at, |(_, c)| [0, 1].map(|k| 2.0 * self.at[k] - c[k]))
    }

    fn arc(&mut self, base: [f64; 2]) -> Result<(), Problem> {
        let radii = [self.numbers.number()?.abs(), self.numbers.number()?.abs()];
        let degrees = self.numbers.number()?;
        let flags = [self.numbers.flag()?, self.numbers.flag()?];
        let to = self.point(base)?;
        match arc(self.at, to, radii, degrees, flags) {
            Some(arc) => {
                self.outline().arc(arc, flat(to));
                self.at = to;
            }
            None => self.line(to),
        }
        Ok(())
    }
}

fn flat([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Makes an arc from its ends: SVG's implementation notes on elliptical arcs. None if it is a line.
fn arc(
    from: [f64; 2],
    to: [f64; 2],
    [rx, ry]: [f64; 2],
    degrees: f64,
    [is_large, is_positive]: [bool; 2],
) -> Option<Arc> {
    if rx == 0.0 || ry == 0.0 || from == to {
        return None;
    }
    let [cos, sin] = crate::curve::unit(degrees);
    let half = [0, 1].map(|k| 0.5 * from[k] - 0.5 * to[k]);
    // In the coordinates in which the ellipse is the unit circle, around the middle of the ends.
    let [x, y] = [
        (cos * half[0] + sin * half[1]) / rx,
        (cos * half[1] - sin * half[0]) / ry,
    ];
    let square = x * x + y * y;
    // Radii that are too small grow until the arc is half of the ellipse.
    let grown = square.sqrt().max(1.0);
    let [x, y] = [x / grown, y / grown];
    let square = x * x + y * y;
    let distance = ((1.0 - square).max(0.0) / square).sqrt();
    let side = if is_large == is_positive {
        -distance
    } else {
        distance
    };
    let center = [side * y, -side * x];
    let [first, last] = [
        [x - center[0], y - center[1]],
        [-x - center[0], -y - center[1]],
    ];
    let angle = |[x, y]: [f64; 2]| libm::atan2(y, x);
    let mut sweep = (angle(last) - angle(first)).rem_euclid(TAU);
    if !is_positive {
        sweep -= TAU;
    }
    let [rx, ry] = [rx * grown, ry * grown];
    let [u, v] = [[rx * cos, rx * sin], [-ry * sin, ry * cos]];
    let middle = [0, 1].map(|k| 0.5 * from[k] + 0.5 * to[k]);
    let place = [0, 1].map(|k| middle[k] + u[k] * center[0] + v[k] * center[1]);
    Some(Arc {
        center: flat(place),
        u: flat(u),
        v: flat(v),
        start: angle(first),
        sweep,
    })
}
