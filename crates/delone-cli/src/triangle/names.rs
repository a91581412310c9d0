//! Names of files: what is read, and what is written.

use super::switches::Switches;
use crate::exit::Failure;
use std::path::{Path, PathBuf};

/// The stems of the files that are read and written.
#[derive(Debug, PartialEq)]
pub struct Names {
    input: String,
    output: String,
}

impl Names {
    /// Takes the file that the command line names; its extension may say what kind it is, and is taken
    /// for a switch then.
    pub fn of(file: &str, switches: &mut Switches) -> Result<Self, Failure> {
        let (input, extension) = match file.rsplit_once('.') {
            Some((stem, extension @ ("node" | "poly" | "ele" | "area"))) => (stem, extension),
            _ => (file, ""),
        };
        switches.graph |= extension == "poly";
        switches.mesh |= extension == "ele" || extension == "area";
        switches.own_areas |= extension == "area";
        switches.require_sense()?;
        if input.is_empty() || input.ends_with('/') {
            return Err(Failure::Usage(format!(
                "{file:?} is not the name of a file"
            )));
        }
        let output = match switches.in_place {
            true => input.to_owned(),
            false => next(input),
        };
        let input = input.to_owned();
        Ok(Self { input, output })
    }

    /// Returns the name of a file to be read.
    pub fn input(&self, extension: &str) -> PathBuf {
        format!("{}.{extension}", self.input).into()
    }

    /// Returns what the names of all files to be written begin with.
    pub fn output_stem(&self) -> PathBuf {
        self.output.clone().into()
    }

    /// Returns the name of a file to be written.
    pub fn output(&self, extension: &str) -> PathBuf {
        format!("{}.{extension}", self.output).into()
    }
}

/// Counts the iteration: `a` becomes `a.1`, and `a.1` becomes `a.2`.
fn next(stem: &str) -> String {
    let folder = Path::new(stem).parent().map_or(0, |p| p.as_os_str().len());
    let counted = stem[folder..].rsplit_once('.').and_then(|(name, number)| {
        let is_number = number.bytes().all(|b| b.is_ascii_digit());
        let number: u64 = number.parse().ok().filter(|_| is_number)?;
        Some((name, number.checked_add(1)?))
    });
    match counted {
        Some((name, number)) => format!("{}{name}.{number}", &stem[..folder]),
        None => format!("{stem}.1"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn iterations_are_counted_in_the_last_part_of_the_name() {
        for (stem, expected) in [
            ("a", "a.1"),
            ("a.1", "a.2"),
            ("a.b.9", "a.b.10"),
            ("a.v2", "a.v2.1"),
            ("dir.4/a", "dir.4/a.1"),
            ("dir/a.7", "dir/a.8"),
            ("../a", "../a.1"),
            ("a.+1", "a.+1.1"),
            ("a.", "a..1"),
            ("a.18446744073709551615", "a.18446744073709551615.1"),
        ] {
            assert_eq!(next(stem), expected);
        }
    }

    #[test]
    fn extensions_speak_as_switches_do() {
        let names = |file: &str, switches: &mut Switches| Names::of(file, switches);
        for (file, graph, mesh, own_areas) in [
            ("a.1.node", false, false, false),
            ("a.1.poly", true, false, false),
            ("a.1.ele", false, true, false),
            ("a.1.area", false, true, true),
            ("a.1", false, false, false),
        ] {
            let mut switches = Switches::default();
            let found = names(file, &mut switches).expect(file);
            assert_eq!(found.input("node"), Path::new("a.1.node"));
            assert_eq!(found.output("poly"), Path::new("a.2.poly"));
            let spoken = (switches.graph, switches.mesh, switches.own_areas);
            assert_eq!(spoken, (graph, mesh, own_areas), "{file}");
        }
        let mut in_place = Switches {
            in_place: true,
            ..Switches::default()
        };
        let found = names("a.1", &mut in_place).expect("a name");
        assert_eq!(found.output("ele"), Path::new("a.1.ele"));
        assert!(names("a.ele", &mut in_place).is_err(), "-I with a mesh");
        assert!(names(".node", &mut Switches::default()).is_err());
        assert!(names("dir/.poly", &mut Switches::default()).is_err());
    }
}
