//! A file of jobs: what it holds, and on which line.

use crate::exit::Failure;
use std::collections::BTreeMap;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys that a file may have.
const SECTIONS: [&str; 2] = ["defaults", "job"];

/// A file of jobs.
pub struct Document<'a> {
    /// The name of the file.
    pub name: String,
    /// What holds for every job that knows it.
    pub defaults: Section<'a>,
    jobs: Vec<Section<'a>>,
}

/// The options of a job, or of all.
#[derive(Default)]
pub struct Section<'a> {
    /// The line on which it begins.
    pub line: usize,
    options: BTreeMap<String, Setting<'a>>,
}

/// What a key is set to.
pub struct Setting<'a> {
    /// The line of the key.
    pub line: usize,
    /// The value.
    pub value: DeValue<'a>,
}

impl<'a> Document<'a> {
    /// Reads a file of jobs.
    ///
    /// *Errors*: it is not TOML, or holds something else.
    pub fn parse(name: &str, text: &'a str) -> Result<Self, Failure> {
        // Of bytes: nobody promises that an error begins where a letter does.
        let line = |at: usize| {
            1 + text.as_bytes()[..at]
                .iter()
                .filter(|&&b| b == b'\n')
                .count()
        };
        let malformed = |at: usize, problem: String| {
            Failure::BadInput(format!("{name}:{}: {problem}", line(at.min(text.len()))))
        };
        let table = DeTable::parse(text).map_err(|error| {
            let at = error.span().map_or(0, |span| span.start);
            malformed(at, error.message().to_owned())
        })?;
        let mut document = Self {
            name: name.to_owned(),
            defaults: Section::default(),
            jobs: Vec::new(),
        };
        for (key, value) in table.into_inner() {
            let at = key.span().start;
            let what = key.into_inner();
            let section = |value: Spanned<DeValue<'a>>, at: usize| match value.into_inner() {
                DeValue::Table(table) => Ok(Section::of(table, line(at), line)),
                _ => Err(malformed(at, format!("{what} must be a table of options"))),
            };
            match (&*what, value.into_inner()) {
                ("defaults", defaults) => {
                    let value = Spanned::new(0..0, defaults);
                    document.defaults = section(value, at)?;
                }
                ("job", DeValue::Array(jobs)) => {
                    for job in jobs {
                        let at = job.span().start;
                        document.jobs.push(section(job, at)?);
                    }
                }
                ("job", _) => {
                    return Err(malformed(
                        at,
                        "write [[job]], for there may be several".to_owned(),
                    ));
                }
                (other, _) => {
                    let nearest = nearest(other, SECTIONS.iter().copied());
                    let hint = nearest.map_or_else(String::new, |n| format!(", did you mean {n}?"));
                    let problem = format!("{other} is neither [defaults] nor [[job]]{hint}");
                    return Err(malformed(at, problem));
                }
            }
        }
        if document.jobs.is_empty() {
            let lacking = format!("{name}: there is no [[job]]");
            return Err(Failure::BadInput(lacking));
        }
        Ok(document)
    }

    /// Lists the jobs, in their order.
    pub fn jobs(&self) -> impl Iterator<Item = &Section<'a>> {
        self.jobs.iter()
    }

    /// Says that something is wrong on a line.
    pub fn malformed(&self, line: usize, problem: &str) -> Failure {
        Failure::BadInput(format!("{}:{line}: {problem}", self.name))
    }
}

impl<'a> Section<'a> {
    fn of(table: DeTable<'a>, begins: usize, line: impl Fn(usize) -> usize) -> Self {
        let options = table.into_iter().map(|(key, value)| {
            let setting = Setting {
                line: line(key.span().start),
                value: value.into_inner(),
            };
            (key.into_inner().into_owned(), setting)
        });
        Self {
            line: begins,
            options: options.collect(),
        }
    }

    /// Returns what a key is set to.
    pub fn get(&self, key: &str) -> Option<&Setting<'a>> {
        self.options.get(key)
    }

    /// Lists keys and settings.
    pub fn settings(&self) -> impl Iterator<Item = (&str, &Setting<'a>)> {
        self.options
            .iter()
            .map(|(key, setting)| (&key[..], setting))
    }

    /// Lists the keys, with their lines.
    pub fn keys(&self) -> impl Iterator<Item = (&str, usize)> {
        self.settings().map(|(key, setting)| (key, setting.line))
    }
}

/// Finds the name that one may have meant.
pub fn nearest<'n>(word: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    /// Words that have less in common than this are different ones.
    const ALIKE: f64 = 0.75;
    let likeness = |name| (strsim::jaro_winkler(word, name), name);
    let alike = names
        .map(likeness)
        .filter(|(likeness, _)| *likeness >= ALIKE);
    let best = alike.max_by(|(a, _), (b, _)| a.total_cmp(b));
    best.map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(text: &str) -> String {
        match Document::parse("f.toml", text) {
            Ok(_) => "none".to_owned(),
            Err(failure) => failure.to_string(),
        }
    }

    #[test]
    fn what_is_no_file_of_jobs_is_told_by_line() {
        for (text, expected) in [
            ("", "f.toml: there is no [[job]]"),
            ("[defaults]\na = 1\n", "f.toml: there is no [[job]]"),
            (
                "\n[job]\n",
                "f.toml:2: write [[job]], for there may be several",
            ),
            (
                "[default]\n[[job]]\n",
                "f.toml:1: default is neither [defaults] nor [[job]], did you mean defaults?",
            ),
            (
                "defaults = 1\n[[job]]\n",
                "f.toml:1: defaults must be a table of options",
            ),
            ("job = [1]\n", "f.toml:1: job must be a table of options"),
        ] {
            assert_eq!(problem(text), expected, "{text}");
        }
        assert!(problem("[[job]]\na = = 1\n").starts_with("f.toml:2: "));
    }

    #[test]
    fn noise_is_refused_and_nesting_is_bounded() {
        for text in [
            "\u{0}",
            "[[job]]\na = \"",
            &"[".repeat(100_000),
            &"a.".repeat(100_000),
        ] {
            assert!(
                problem(text).starts_with("f.toml:"),
                "{}",
                &text[..text.len().min(20)]
            );
        }
        let deep = format!("a = {}", "[".repeat(100_000));
        assert!(problem(&deep).starts_with("f.toml:1"));
    }

    #[test]
    fn lines_are_those_of_keys() {
        let text = "# jobs\n[defaults]\nto = \"vtu\"\n\n[[job]]\ninput = \"a\"\n\n[[job]]\ninput = \"b\"\n";
        let document = Document::parse("f", text).expect("jobs");
        let lines: Vec<_> = document
            .jobs()
            .map(|job| (job.line, job.get("input").map(|s| s.line)))
            .collect();
        assert_eq!(lines, [(5, Some(6)), (8, Some(9))]);
        assert_eq!(document.defaults.keys().collect::<Vec<_>>(), [("to", 3)]);
    }

    #[test]
    fn noise_never_panics() {
        const WORDS: &[&str] = &[
            "[[job]]\n",
            "[job]",
            "[defaults]\n",
            "defaults",
            "job",
            "command = \"mesh\"\n",
            "input",
            " = ",
            "\"a\"",
            "'b'",
            "[",
            "]",
            "{",
            "}",
            ",",
            "\n",
            ".",
            "1e999",
            "0x7fffffffffffffff",
            "-9999999999999999999",
            "true",
            "2024-13-99",
            "\u{e4}",
            "\u{1f600}",
            "\"",
            "\"\"\"",
            "\\",
            "#",
            "nan",
            "min-angle = 30\n",
        ];
        let mut state = 1_u64;
        for _ in 0..20_000 {
            let mut text = String::new();
            for _ in 0..12 {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                text += WORDS[(state >> 33) as usize % WORDS.len()];
            }
            let told = problem(&text);
            assert!(
                told == "none" || told.starts_with("f.toml:"),
                "{text:?}: {told}"
            );
        }
        for nested in ["a = [", "a = {b=", "[a.", "a.", "[["] {
            assert!(problem(&nested.repeat(1 << 16)).starts_with("f.toml:"));
            assert!(problem(&format!("a = {}", "[".repeat(1 << 16))).starts_with("f.toml:"));
        }
    }
}
