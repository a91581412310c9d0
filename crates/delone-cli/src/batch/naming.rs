//! Names of the outputs of several files, and patterns of their inputs.

use crate::exit::Failure;
use delone_io::Format;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// What stands for the name of each input.
const EACH: &str = "{}";

/// How the outputs of several files are named.
#[derive(Clone, Copy)]
pub struct Naming<'a> {
    /// Where they go; else beside the inputs.
    pub folder: Option<&'a Path>,
    /// Whether there is but one input.
    pub is_alone: bool,
}

impl Naming<'_> {
    /// Names an output for an input; `option` is what names it on the command line.
    ///
    /// *Errors*: of several inputs all would get this name.
    pub fn name(&self, output: &Path, input: &Path, option: &str) -> Result<PathBuf, Failure> {
        if let Some((before, after)) = output.to_str().and_then(|text| text.split_once(EACH)) {
            let stem = match self.folder {
                Some(_) => Path::new(input.file_stem().unwrap_or_default()).to_owned(),
                None => input.with_extension(""),
            };
            // A folder of the input stays in front of what stands before the name.
            let mut name = OsString::from(before);
            name.push(stem.file_name().unwrap_or_default());
            name.push(after);
            let beside = match self.folder {
                None if !has_folder(before) => stem.parent().unwrap_or(Path::new("")),
                None => Path::new(""),
                Some(folder) => folder,
            };
            return Ok(beside.join(name));
        }
        if self.is_alone {
            return Ok(match self.folder {
                Some(folder) if output != Path::new("-") => folder.join(output),
                _ => output.to_owned(),
            });
        }
        let output = output.display();
        Err(Failure::Usage(format!(
            "{option} {output}: several files are read, and one name will not do for all; `{{}}` stands for the name \
             of each, as in {option} {{}}.vtu, or --out-dir DIR --to FORMAT"
        )))
    }

    /// Names all outputs of an option.
    pub fn names(
        &self,
        outputs: &[PathBuf],
        input: &Path,
        option: &str,
    ) -> Result<Vec<PathBuf>, Failure> {
        let names = outputs.iter().map(|o| self.name(o, input, option));
        names.collect()
    }

    /// Names the outputs and the picture of a command for an input. Where no output is named, there is the usual one if
    /// `to` names its format, or if there would be nothing else; `names_more` tells whether there is.
    pub fn outputs(
        &self,
        input: &Path,
        (outputs, picture): (&[PathBuf], Option<&Path>),
        to: Option<Format>,
        names_more: bool,
    ) -> Result<(Vec<PathBuf>, Option<PathBuf>), Failure> {
        let mut outputs = self.names(outputs, input, "-o")?;
        let picture = picture.map(|picture| self.name(picture, input, "--picture"));
        let picture = picture.transpose()?;
        let is_something = names_more || picture.is_some();
        if outputs.is_empty() && (to.is_some() || !is_something) {
            outputs.extend(self.usual(input, to)?);
        }
        Ok((outputs, picture))
    }

    /// Names the output in a folder of results for which no name was given.
    ///
    /// *Errors*: no format is known.
    pub fn usual(&self, input: &Path, format: Option<Format>) -> Result<Option<PathBuf>, Failure> {
        let Some(folder) = self.folder else {
            return Ok(None);
        };
        let Some(format) = format else {
            let folder = folder.display();
            return Err(Failure::Usage(format!(
                "--out-dir {folder}: in which format? add --to vtu, or any that can hold the results, or -o {{}}.vtu"
            )));
        };
        let extension = format
            .extensions()
            .first()
            .unwrap_or(&format.name())
            .to_owned();
        let pattern = PathBuf::from(format!("{EACH}.{extension}"));
        self.name(&pattern, input, "-o").map(Some)
    }
}

fn has_folder(text: &str) -> bool {
    text.contains(std::path::is_separator)
}

/// Replaces patterns by the files that match them, in the order of their names, for shells that do not.
///
/// *Errors*: nothing matches, or the pattern is none.
pub fn expand(inputs: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for input in inputs {
        let pattern = input.to_str().filter(|text| text.contains(['*', '?', '[']));
        // What is there under this very name is no pattern.
        let Some(pattern) = pattern.filter(|_| !input.exists()) else {
            files.push(input.clone());
            continue;
        };
        let matches = glob::glob(pattern)
            .map_err(|error| Failure::Usage(format!("{pattern}: no pattern: {}", error.msg)))?;
        let before = files.len();
        for path in matches {
            let path = path.map_err(|error| Failure::BadInput(error.to_string()))?;
            if path.is_file() {
                files.push(path);
            }
        }
        if files.len() == before {
            return Err(Failure::BadInput(format!("{pattern}: no file matches")));
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(folder: Option<&str>, output: &str, input: &str) -> String {
        let naming = Naming {
            folder: folder.map(Path::new),
            is_alone: false,
        };
        let name = naming.name(Path::new(output), Path::new(input), "-o");
        match name {
            Ok(name) => name.to_str().expect("UTF-8").to_owned(),
            Err(failure) => failure.to_string(),
        }
    }

    #[test]
    fn outputs_are_named_after_inputs() {
        for (folder, output, input, expected) in [
            (Some("out"), "{}.vtu", "maps/a.poly", "out/a.vtu"),
            (Some("out"), "fine-{}.vtu", "a.b.poly", "out/fine-a.b.vtu"),
            (None, "{}.vtu", "maps/a.poly", "maps/a.vtu"),
            (None, "fine-{}.vtu", "maps/a.poly", "maps/fine-a.vtu"),
            (None, "fine/{}.vtu", "maps/a.poly", "fine/a.vtu"),
            (None, "{}.vtu", "a.poly", "a.vtu"),
        ] {
            assert_eq!(named(folder, output, input), expected);
        }
        assert!(named(None, "m.vtu", "a.poly").starts_with("-o m.vtu: several files"));
    }

    #[test]
    fn a_folder_needs_a_format_or_a_name() {
        let naming = Naming {
            folder: Some(Path::new("out")),
            is_alone: true,
        };
        let input = Path::new("maps/a.poly");
        let usual = naming.usual(input, Some(Format::Ele));
        assert_eq!(usual.expect("a name"), Some(PathBuf::from("out/a.ele")));
        let lacking = naming.usual(input, None).expect_err("no format");
        assert!(lacking.to_string().contains("in which format?"));
        let alone = naming.name(Path::new("m.vtu"), input, "-o");
        assert_eq!(alone.expect("a name"), PathBuf::from("out/m.vtu"));
    }
}
