//! The switches of Triangle.
//!
//! J. R. Shewchuk, *Triangle*, <https://www.cs.cmu.edu/~quake/triangle.switch.html>. Letters are bundled behind one
//! dash or several; numbers follow their letter at once and have digits and a point, no exponent.

use crate::exit::Failure;
use std::ffi::{OsStr, OsString};

/// The smallest angle that `-q` means without a number, in degrees.
const USUAL_ANGLE: f64 = 20.0;

/// What switches ask for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Switches {
    /// `-p`: read a graph.
    pub graph: bool,
    /// `-r`: read a mesh.
    pub mesh: bool,
    /// `-c`: keep the hull, and make segments of its edges.
    pub hull: bool,
    /// `-O`: no holes.
    pub no_holes: bool,
    /// `-q`, in degrees.
    pub min_angle: Option<f64>,
    /// `-a` with a number.
    pub max_area: Option<f64>,
    /// `-a` without.
    pub own_areas: bool,
    /// `-D`: conforming Delaunay.
    pub conforming: bool,
    /// How many `-Y`.
    pub locked: usize,
    /// `-S`: the largest number of Steiner points.
    pub steiner: Option<usize>,
    /// `-A`: write the attributes of regions.
    pub attributes: bool,
    /// `-o2`: six nodes a triangle.
    pub quadratic: bool,
    /// `-j`: leave unused vertices out.
    pub jettison: bool,
    /// `-B`: write no markers.
    pub no_markers: bool,
    /// `-e`.
    pub edges: bool,
    /// `-n`.
    pub neighbors: bool,
    /// `-g`: for Geomview.
    pub off: bool,
    /// `-v`: the Voronoi diagram.
    pub voronoi: bool,
    /// `-P`.
    pub no_poly: bool,
    /// `-N`.
    pub no_node: bool,
    /// `-E`.
    pub no_ele: bool,
    /// `-I`: no iteration numbers.
    pub in_place: bool,
    /// `-Q`.
    pub quiet: bool,
}

impl Switches {
    /// Takes the command line apart into switches and the one file.
    pub fn parse(arguments: &[OsString]) -> Result<(Self, String), Failure> {
        let mut switches = Self::default();
        let mut file = None;
        for argument in arguments {
            let Some(text) = argument.to_str() else {
                let shown = argument.to_string_lossy();
                return Err(usage(format!("{shown:?} is not UTF-8; rename the file")));
            };
            if let Some(bundle) = text.strip_prefix('-') {
                switches.add(bundle)?;
            } else if let Some(first) = file.replace(text.to_owned()) {
                return Err(usage(format!(
                    "one file is read, not both {first} and {text}"
                )));
            }
        }
        switches.require_sense()?;
        let file = file.ok_or_else(|| usage("no file is named".to_owned()))?;
        Ok((switches, file))
    }

    /// Tells whether an argument is a bundle with `-h` in it.
    pub fn ask_for_help(argument: &OsStr) -> bool {
        let bundle = argument.to_str().and_then(|a| a.strip_prefix('-'));
        bundle.is_some_and(|b| !b.starts_with('-') && b.contains('h'))
    }

    /// Tells whether the mesh is to be better than a triangulation.
    pub fn refines(&self) -> bool {
        let sizes = self.max_area.is_some() || self.own_areas;
        sizes || self.min_angle.is_some() || self.conforming
    }

    /// Takes the switches behind one dash.
    fn add(&mut self, bundle: &str) -> Result<(), Failure> {
        if bundle.starts_with('-') {
            return Err(usage(format!(
                "-{bundle}: only switches of Triangle are known here; -Q is for quiet"
            )));
        }
        let mut rest = bundle;
        while let Some(letter) = rest.chars().next() {
            rest = &rest[letter.len_utf8()..];
            let number = match letter {
                'q' | 'a' | 'S' | 'o' => take_number(&mut rest),
                _ => "",
            };
            self.set(letter, number)?;
        }
        Ok(())
    }

    fn set(&mut self, letter: char, number: &str) -> Result<(), Failure> {
        match letter {
            'p' => self.graph = true,
            'r' => self.mesh = true,
            'c' => self.hull = true,
            'O' => self.no_holes = true,
            'q' => self.min_angle = Some(angle(number)?),
            'a' if number.is_empty() => self.own_areas = true,
            'a' => self.max_area = Some(area(number)?),
            'D' | 'L' => self.conforming = true,
            'Y' => self.locked += 1,
            'S' => self.steiner = Some(count(number)?),
            'A' => self.attributes = true,
            'o' => self.quadratic = is_quadratic(number)?,
            'j' => self.jettison = true,
            'B' => self.no_markers = true,
            'e' => self.edges = true,
            'n' => self.neighbors = true,
            'g' => self.off = true,
            'v' => self.voronoi = true,
            'P' => self.no_poly = true,
            'N' => self.no_node = true,
            'E' => self.no_ele = true,
            'I' => self.in_place = true,
            'Q' => self.quiet = true,
            'i' | 'F' | 'l' | 's' | 'C' | 'X' | 'V' | 'z' => {}
            'u' | 'w' | 'W' => return Err(usage(refusal(letter).to_owned())),
            _ => return Err(usage(format!("-{letter} is no switch of Triangle"))),
        }
        Ok(())
    }

    /// Requires that nothing that is read is overwritten, and that every file can hold what it is to hold.
    pub fn require_sense(&self) -> Result<(), Failure> {
        if self.in_place && self.mesh {
            let clash = "-I and -r would overwrite the mesh that is read; leave -I out";
            return Err(usage(clash.to_owned()));
        }
        if self.off && self.quadratic {
            let clash = "-g and -o2: .off has no place for six nodes a triangle; leave one out";
            return Err(usage(clash.to_owned()));
        }
        Ok(())
    }
}

fn usage(text: String) -> Failure {
    Failure::Usage(text)
}

/// Says what to do instead.
fn refusal(letter: char) -> &'static str {
    match letter {
        'u' => {
            "-u: a test of one's own cannot be built in; `delone mesh --sizing` takes a formula or \
             a file of sizes"
        }
        _ => {
            "-w: weighted triangulations are not written; `delone voronoi FILE --weights COLUMN` makes \
             their power cells"
        }
    }
}

/// Takes digits and points from the front.
fn take_number<'a>(rest: &mut &'a str) -> &'a str {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
    let (number, others) = rest.split_at(end);
    *rest = others;
    number
}

fn angle(number: &str) -> Result<f64, Failure> {
    if number.is_empty() {
        return Ok(USUAL_ANGLE);
    }
    match number.parse() {
        Ok(degrees) if (0.0..60.0).contains(&degrees) => Ok(degrees),
        _ => Err(usage(format!(
            "-q{number}: the smallest angle must be a number of degrees below 60"
        ))),
    }
}

fn area(number: &str) -> Result<f64, Failure> {
    match number.parse() {
        Ok(area) if area > 0.0 && area < f64::INFINITY => Ok(area),
        _ => Err(usage(format!(
            "-a{number}: the largest area must be a positive number"
        ))),
    }
}

fn count(number: &str) -> Result<usize, Failure> {
    if number.is_empty() {
        return Ok(0);
    }
    number
        .parse()
        .map_err(|_| usage(format!("-S{number}: a number of vertices is needed")))
}

fn is_quadratic(number: &str) -> Result<bool, Failure> {
    match number {
        "2" => Ok(true),
        "1" => Ok(false),
        _ => Err(usage(format!(
            "-o{number}: triangles have order 1 (three nodes) or 2 (six)"
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<(Switches, String), String> {
        let words: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        Switches::parse(&words).map_err(|failure| failure.to_string())
    }

    #[test]
    fn switches_are_bundled_or_not_before_or_behind_the_file() {
        let expected = Switches {
            graph: true,
            min_angle: Some(30.5),
            max_area: Some(0.1),
            own_areas: true,
            conforming: true,
            ..Switches::default()
        };
        for line in ["-pq30.5a.1aD f", "-p -q30.5 -aDa0.1 f", "f -Dapa0.1 -q30.5"] {
            assert_eq!(
                parse(line),
                Ok((expected.clone(), "f".to_owned())),
                "{line}"
            );
        }
    }

    #[test]
    fn numbers_left_out_have_their_meaning() {
        let (switches, _) = parse("-qSYYaL f").expect("switches");
        assert_eq!(switches.min_angle, Some(20.0));
        assert_eq!((switches.steiner, switches.locked), (Some(0), 2));
        assert_eq!((switches.own_areas, switches.max_area), (true, None));
        assert!(switches.conforming && switches.refines());
        let (switches, _) = parse("-S12o2 f").expect("switches");
        assert_eq!((switches.steiner, switches.quadratic), (Some(12), true));
        assert!(!switches.refines());
    }

    #[test]
    fn every_switch_that_only_chooses_an_algorithm_is_accepted() {
        let (switches, _) = parse("-iFlsCXVVVz f").expect("switches");
        assert_eq!(switches, Switches::default());
        let (switches, _) = parse("-cOAjBengvPNEIQ f").expect("switches");
        let all = [
            switches.hull,
            switches.no_holes,
            switches.attributes,
            switches.jettison,
            switches.no_markers,
            switches.edges,
            switches.neighbors,
            switches.off,
            switches.voronoi,
            switches.no_poly,
            switches.no_node,
            switches.no_ele,
            switches.in_place,
            switches.quiet,
        ];
        assert_eq!(all, [true; 14]);
    }

    #[test]
    fn every_letter_is_understood_or_refused_with_a_sentence() {
        let understood = "aABcCDeEFghiIjlLnNoOpPqQrsSvVXYz";
        let refused = "uwW";
        for letter in ('a'..='z').chain('A'..='Z') {
            let number = if letter == 'o' { "2" } else { "" };
            let said = parse(&format!("-{letter}{number} f"));
            let is_known = understood.contains(letter) && letter != 'h';
            assert_eq!(said.is_ok(), is_known, "-{letter}: {said:?}");
            let Err(said) = said else { continue };
            let is_refused = refused.contains(letter);
            assert_eq!(said.contains("`delone "), is_refused, "{said}");
            let is_unknown = said == format!("-{letter} is no switch of Triangle");
            assert!(is_refused || is_unknown || letter == 'h', "{said}");
        }
        assert!(Switches::ask_for_help(OsStr::new("-ph")));
    }

    #[test]
    fn what_makes_no_sense_is_refused_by_name() {
        for (line, expected) in [
            ("-pq60 f", "-q60: the smallest angle"),
            ("-q3.0.1 f", "-q3.0.1: the smallest angle"),
            ("-a0 f", "-a0: the largest area must be a positive"),
            ("-a. f", "-a.: the largest area"),
            ("-S1.5 f", "-S1.5: a number of vertices"),
            ("-o3 f", "-o3: triangles have order 1"),
            ("-o f", "-o: triangles have order 1"),
            ("-pG f", "-G is no switch of Triangle"),
            ("-p° f", "-° is no switch"),
            ("-pu f", "delone mesh --sizing"),
            ("-w f", "delone voronoi"),
            ("-pgo2 f", "-g and -o2"),
            ("-rI f", "-I and -r"),
            ("-p", "no file is named"),
            ("-p f g", "not both f and g"),
            ("--json f", "--json: only switches of Triangle"),
        ] {
            let error = parse(line).expect_err(line);
            assert!(error.contains(expected), "{line}: {error}");
        }
    }
}
