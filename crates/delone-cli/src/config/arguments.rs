//! From the keys and values of a job to a command line.

use super::document::{Document, Section, Setting, nearest};
use crate::cli::Cli;
use crate::exit::Failure;
use clap::CommandFactory;
use std::ffi::OsString;
use toml::de::DeValue;

/// Commands that jobs may have; the first is meant if none is named.
const COMMANDS: [&str; 4] = ["mesh", "triangulate", "convert", "cover"];

/// Keys that are no options.
const OWN: [&str; 2] = ["command", "input"];

/// Options that mean nothing to a job.
const NOT_OF_JOBS: [&str; 6] = ["help", "version", "json", "quiet", "verbose", "jobs"];

/// Returns the command line of a job, with the program in front.
pub fn of(document: &Document<'_>, job: &Section<'_>) -> Result<Vec<OsString>, Failure> {
    let command = command(document, job)?;
    let known = options(command);
    for (key, line) in job.keys() {
        require_known(document, &known, command, key, line)?;
    }
    let of_any: Vec<String> = COMMANDS.into_iter().flat_map(options).collect();
    for (key, line) in document.defaults.keys() {
        require_known(document, &of_any, &listed(" or "), key, line)?;
    }
    // What a job says counts, not what holds for all.
    let defaults = document.defaults.settings();
    let defaults =
        defaults.filter(|(key, _)| known.iter().any(|k| k == key) && job.get(key).is_none());
    let mut line = vec!["delone".to_owned(), command.to_owned()];
    let mut places = [Vec::new(), Vec::new()];
    for (key, setting) in defaults.chain(job.settings()) {
        let values = values(document, key, setting)?;
        match key {
            "command" => {}
            "input" => places[0] = texts(document, setting, values)?,
            "output" if command == "convert" => places[1] = texts(document, setting, values)?,
            _ => line.extend(values.into_iter().filter_map(|value| match value {
                Value::Flag(true) => Some(format!("--{key}")),
                Value::Flag(false) => None,
                Value::Text(text) => Some(format!("--{key}={text}")),
            })),
        }
    }
    let places = places.concat();
    if !places.is_empty() {
        line.push("--".to_owned());
        line.extend(places);
    }
    Ok(line.into_iter().map(OsString::from).collect())
}

/// A value as a command line has it.
enum Value {
    Flag(bool),
    Text(String),
}

fn command(document: &Document<'_>, job: &Section<'_>) -> Result<&'static str, Failure> {
    let setting = job.get("command").or(document.defaults.get("command"));
    let Some(setting) = setting else {
        return Ok(COMMANDS[0]);
    };
    let named = match &setting.value {
        DeValue::String(text) => COMMANDS.into_iter().find(|c| c == text),
        _ => None,
    };
    named.ok_or_else(|| {
        let problem = format!("command must be one of {}", listed(" and "));
        document.malformed(setting.line, &problem)
    })
}

/// Lists the commands that jobs may have, the last behind `and`.
fn listed(and: &str) -> String {
    let [first @ .., last] = COMMANDS;
    [&first.join(", "), and, last].concat()
}

/// Lists the keys that jobs of a command may have.
fn options(command: &str) -> Vec<String> {
    let cli = Cli::command();
    let known = cli
        .find_subcommand(command)
        .map(clap::Command::get_arguments);
    let known = known.into_iter().flatten().filter_map(clap::Arg::get_long);
    let known = known.filter(|long| !NOT_OF_JOBS.contains(long));
    let output = (command == "convert").then_some("output");
    known.chain(OWN).chain(output).map(str::to_owned).collect()
}

fn require_known(
    document: &Document<'_>,
    known: &[String],
    command: &str,
    key: &str,
    line: usize,
) -> Result<(), Failure> {
    if known.iter().any(|name| name == key) {
        return Ok(());
    }
    let nearest = nearest(key, known.iter().map(String::as_str));
    let hint = nearest.map_or_else(
        || format!("; keys are the long options of {command}"),
        |name| format!(", did you mean {name}?"),
    );
    Err(document.malformed(line, &format!("no option {key} of {command}{hint}")))
}

fn values(
    document: &Document<'_>,
    key: &str,
    setting: &Setting<'_>,
) -> Result<Vec<Value>, Failure> {
    let value = |value: &DeValue<'_>| match value {
        DeValue::Boolean(flag) => Some(Value::Flag(*flag)),
        DeValue::String(text) => Some(Value::Text(text.to_string())),
        DeValue::Integer(number) => integer(number.as_str(), number.radix()).map(Value::Text),
        DeValue::Float(number) => Some(Value::Text(number.as_str().to_owned())),
        _ => None,
    };
    let all = match &setting.value {
        DeValue::Array(all) => all.iter().map(|one| value(one.get_ref())).collect(),
        one => value(one).map(|one| vec![one]),
    };
    let refused = || {
        let problem = format!("{key} must be a text, a number, true, false, or a list of these");
        document.malformed(setting.line, &problem)
    };
    all.ok_or_else(refused)
}

/// Writes an integer with base 10, whatever its base in the file.
fn integer(digits: &str, radix: u32) -> Option<String> {
    match radix {
        10 => Some(digits.to_owned()),
        _ => i128::from_str_radix(digits, radix)
            .ok()
            .map(|n| n.to_string()),
    }
}

fn texts(
    document: &Document<'_>,
    setting: &Setting<'_>,
    values: Vec<Value>,
) -> Result<Vec<String>, Failure> {
    let text = |value| match value {
        Value::Text(text) => Some(text),
        Value::Flag(_) => None,
    };
    let texts: Option<Vec<String>> = values.into_iter().map(text).collect();
    texts.ok_or_else(|| document.malformed(setting.line, "a name of a file is needed"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<String> {
        let document = Document::parse("f.toml", text).expect("jobs");
        let line = |job| match of(&document, job) {
            Ok(line) => line.join(" ".as_ref()).into_string().expect("UTF-8"),
            Err(failure) => failure.to_string(),
        };
        document.jobs().map(line).collect()
    }

    #[test]
    fn keys_become_long_options() {
        let text = r#"
            [defaults]
            min-angle = 30
            conforming = true
            to = "vtu"
            [[job]]
            input = "a.poly"
            max-edge = 5e-2
            [[job]]
            command = "convert"
            input = ["-b.poly", "c.poly"]
            output = "{}.vtu"
            [[job]]
            input = "a.poly"
            conforming = false
            keep-boundary = true
            min-angle = 0x14
            output = ["a.vtu", "a.ele"]
            [[job]]
            command = "cover"
            input = ["s.csv", "t.csv"]
            data-per-triangle = 10
            no-edges = true
            output = "{}.vtu"
        "#;
        assert_eq!(
            lines(text),
            [
                "delone mesh --conforming --min-angle=30 --to=vtu --max-edge=5e-2 -- a.poly",
                "delone convert --to=vtu -- -b.poly c.poly {}.vtu",
                "delone mesh --to=vtu --keep-boundary --min-angle=20 --output=a.vtu --output=a.ele -- a.poly",
                "delone cover --to=vtu --data-per-triangle=10 --no-edges --output={}.vtu -- s.csv t.csv",
            ]
        );
    }

    #[test]
    fn what_is_no_option_is_refused_with_its_line_and_the_name_that_was_meant() {
        for (text, expected) in [
            (
                "[[job]]\nmax-egde = 1\n",
                "f.toml:2: no option max-egde of mesh, did you mean max-edge?",
            ),
            (
                "[[job]]\ncommand = \"convert\"\nsmooth = 1\n",
                "f.toml:3: no option smooth of convert; keys are the long options of convert",
            ),
            (
                "[defaults]\nxyz = 1\n[[job]]\n",
                "f.toml:2: no option xyz of mesh, triangulate, convert or cover",
            ),
            (
                "[[job]]\ncommand = \"cover\"\nmin-angle = 20\n",
                "f.toml:3: no option min-angle of cover",
            ),
            ("[[job]]\njson = true\n", "f.toml:2: no option json of mesh"),
            (
                "[[job]]\ncommand = \"check\"\n",
                "f.toml:2: command must be one of mesh, triangulate, convert and cover",
            ),
            (
                "[[job]]\ninput = true\n",
                "f.toml:2: a name of a file is needed",
            ),
            (
                "[[job]]\nsizing = { a = 1 }\n",
                "f.toml:2: sizing must be a text, a number",
            ),
            (
                "[[job]]\nsizing = 1979-05-27\n",
                "f.toml:2: sizing must be a text, a number",
            ),
        ] {
            let said = &lines(text)[0];
            assert!(said.starts_with(expected), "{said}");
        }
    }
}
