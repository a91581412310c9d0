//! Reading: the parser walks over the text once, and every geometry is added as it ends.

use super::bare::{self, ArraySeed};
use super::object::{ObjectSeed, Reader, Role};
use crate::{DomainData, Error, Place, Problem, scan};
use delone::{Phase, Watch};
use serde::de::DeserializeSeed;

/// Tells whether the bytes begin like a JSON object, or an array of numbers.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let text = scan::without_mark(head).trim_ascii_start();
    text.starts_with(b"{") || bare::sniff(text)
}

/// Reads a domain.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let text = scan::without_mark(bytes);
    let malformed = |place, problem| Error::Malformed {
        file: file.to_owned(),
        place,
        problem,
    };
    if text.trim_ascii().is_empty() {
        return Err(malformed(Place::File, Problem::Empty));
    }
    let mut reader = Reader::new(watch);
    let mut parser = serde_json::Deserializer::from_slice(text);
    let outcome = if text.trim_ascii_start().starts_with(b"[") {
        let (shapes, pulse) = reader.parts();
        ArraySeed { shapes, pulse }.deserialize(&mut parser)
    } else {
        let seed = ObjectSeed {
            reader: &mut reader,
            role: Role::Root,
        };
        seed.deserialize(&mut parser)
    };
    let outcome = outcome.and_then(|()| parser.end());
    if let Err(error) = outcome {
        if watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let place = Place::Column(error.line() as u64, error.column() as u64);
        let problem = Problem::Other(explain(&error, reader.feature()));
        return Err(malformed(place, problem));
    }
    watch.progress(Phase::Read, text.len() as u64, text.len() as u64);
    Ok(reader.into_shapes().finish())
}

/// Says what is wrong, with the feature it is in, without the place, which goes elsewhere.
fn explain(error: &serde_json::Error, feature: Option<usize>) -> String {
    let text = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let text = text.strip_suffix(&place).unwrap_or(&text);
    match feature {
        Some(feature) => format!("feature {feature}: {text}"),
        None => text.to_owned(),
    }
}
