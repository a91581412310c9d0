//! What an argument of `--sizing` may say.

use super::expression::Expression;
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// One field.
#[derive(Clone, Debug)]
pub enum Spec {
    /// An expression of x and y, and its text.
    Expression(String, Expression),
    /// Sizes in a column of a file of points, or of the vertices of a mesh.
    Column {
        /// The file.
        file: PathBuf,
        /// The name of the column.
        column: String,
    },
    /// Sizes that grow with the distance from features.
    Distance {
        /// What the features are.
        features: Features,
        /// Size there.
        at: f64,
        /// By how much sizes grow over a distance of one.
        growth: f64,
        /// Largest size, if any.
        max: Option<f64>,
    },
}

/// What distances are measured from.
#[derive(Clone, Debug, PartialEq)]
pub enum Features {
    /// The points of the input.
    Points,
    /// The segments of the input.
    Segments,
    /// The segments and loose points of a file.
    File(PathBuf),
}

impl fmt::Display for Features {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Points => f.write_str("distance:points"),
            Self::Segments => f.write_str("distance:segments"),
            Self::File(file) => write!(f, "distance:{}", file.display()),
        }
    }
}

impl fmt::Display for Spec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expression(text, _) => f.write_str(text),
            Self::Column { file, column } => write!(f, "{}:{column}", file.display()),
            Self::Distance {
                features,
                at,
                growth,
                max,
            } => {
                write!(f, "{features},at={at},growth={growth}")?;
                max.map_or(Ok(()), |max| write!(f, ",max={max}"))
            }
        }
    }
}

impl Spec {
    /// Writes it with the name of its file, but without the folder.
    pub fn name(&self) -> String {
        let without_folder =
            |file: &Path| file.file_name().map_or_else(PathBuf::new, PathBuf::from);
        self.clone().with_file(without_folder).to_string()
    }

    /// Looks for its file in `folder`.
    pub fn within(self, folder: &Path) -> Self {
        self.with_file(|file| folder.join(file))
    }

    fn with_file(mut self, change: impl Fn(&Path) -> PathBuf) -> Self {
        match &mut self {
            Self::Column { file, .. }
            | Self::Distance {
                features: Features::File(file),
                ..
            } => *file = change(file),
            _ => {}
        }
        self
    }

    /// Returns the file that is read, if one is.
    pub fn file(&self) -> Option<&Path> {
        match self {
            Self::Column { file, .. } => Some(file),
            Self::Distance {
                features: Features::File(file),
                ..
            } => Some(file),
            _ => None,
        }
    }
}

impl FromStr for Spec {
    type Err = String;

    /// Tells the kinds apart by the colon, which no expression has.
    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(rest) = text.strip_prefix("distance:") {
            return distance(rest);
        }
        // The last one, for the sake of drives: `C:\sizes.csv:size`.
        if let Some((file, column)) = text.rsplit_once(':') {
            if file.is_empty() || column.is_empty() {
                return Err("FILE:COLUMN needs both, as in `sizes.csv:size`".to_owned());
            }
            let [file, column] = [file, column].map(str::to_owned);
            return Ok(Self::Column {
                file: file.into(),
                column,
            });
        }
        let expression =
            Expression::parse(text).map_err(|error| match Path::new(text).exists() {
                true => format!("which of its columns holds the sizes? `{text}:COLUMN`"),
                false => error,
            })?;
        Ok(Self::Expression(text.to_owned(), expression))
    }
}

/// Reads `WHAT,at=SIZE,growth=RATE,max=SIZE`; only the name of a file may have commas of its own.
fn distance(text: &str) -> Result<Spec, String> {
    let mut what = text;
    let mut numbers = [("at", None), ("growth", None), ("max", None)];
    while let Some((rest, option)) = what.rsplit_once(',') {
        let Some((key, value)) = option.split_once('=') else {
            break;
        };
        let known = numbers.iter_mut().find(|(name, _)| *name == key.trim());
        let (name, number) =
            known.ok_or_else(|| format!("no {key}; there are at, growth and max"))?;
        if number.is_some() {
            return Err(format!("{name} is given twice"));
        }
        let given = value.trim().parse::<f64>();
        *number = Some(given.map_err(|_| format!("{name} is {value:?}, it must be a number"))?);
        what = rest;
    }
    let [at, growth, max] = numbers.map(|(_, number)| number);
    let features = match what {
        "" => return Err("distance from what? segments, points, or a file".to_owned()),
        "points" => Features::Points,
        "segments" => Features::Segments,
        file => Features::File(file.into()),
    };
    let (Some(at), Some(growth)) = (at, growth) else {
        let example = format!("distance:{what},at=0.01,growth=0.2");
        return Err(format!("both at and growth are needed, as in `{example}`"));
    };
    Ok(Spec::Distance {
        features,
        at,
        growth,
        max,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(text: &str) -> String {
        text.parse::<Spec>().unwrap_err()
    }

    #[test]
    fn the_colon_tells_the_kinds_apart() {
        let expression = "0.1 + x".parse::<Spec>().unwrap();
        assert!(matches!(&expression, Spec::Expression(text, _) if text == "0.1 + x"));
        assert_eq!(expression.file(), None);
        for (text, name, of) in [
            ("a.csv:size", "a.csv", "size"),
            (r"C:\a.csv:h", r"C:\a.csv", "h"),
        ] {
            let spec = text.parse::<Spec>().unwrap();
            assert_eq!(spec.file(), Some(Path::new(name)));
            assert!(matches!(spec, Spec::Column { column, .. } if column == of));
        }
        assert!(refusal("a.csv:").contains("needs both"));
        assert!(refusal(":h").contains("needs both"));
    }

    #[test]
    fn a_file_without_column_is_told_so() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let name = file.path().to_str().unwrap();
        assert!(refusal(name).contains(&format!("`{name}:COLUMN`")));
    }

    #[test]
    fn distances_have_options_in_any_order() {
        let spec = "distance:a,b.poly,max=2, growth=0.2,at=1e-2"
            .parse()
            .unwrap();
        let Spec::Distance {
            features,
            at,
            growth,
            max,
        } = spec
        else {
            panic!("a distance");
        };
        assert_eq!(features, Features::File("a,b.poly".into()));
        assert_eq!((at, growth, max), (0.01, 0.2, Some(2.0)));
        for (what, expected) in [
            ("points", Features::Points),
            ("segments", Features::Segments),
        ] {
            let spec: Spec = format!("distance:{what},at=1,growth=0").parse().unwrap();
            assert_eq!(spec.file(), None);
            let is_expected =
                matches!(spec, Spec::Distance { features, max: None, .. } if features == expected);
            assert!(is_expected, "{what}");
        }
    }

    #[test]
    fn distances_need_both_numbers() {
        for (text, said) in [
            ("distance:segments", "both at and growth"),
            ("distance:segments,at=1", "both at and growth"),
            ("distance:segments,at=1,growth=x", "growth is \"x\""),
            ("distance:segments,at=1,at=2", "at is given twice"),
            (
                "distance:segments,at=1,grow=2",
                "no grow; there are at, growth and max",
            ),
            ("distance:,at=1,growth=2", "distance from what?"),
        ] {
            assert!(refusal(text).contains(said), "{text}: {}", refusal(text));
        }
    }
}
