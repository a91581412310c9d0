//! What a step does, in a sentence: for whoever watches a run, in English or German.
//!
//! `changes.rs` and `looks.rs` are the table: a sentence in both languages for every kind of event, with places for
//! what it is about. Vertices are named by their numbers, edges and triangles by those of their corners. The few
//! words beside a drawing, which shows what they are about, are those of animations.

mod changes;
mod looks;
mod parts;

use delone::Event;
use parts::Sentence;
use std::str::FromStr;

/// A language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// `en`.
    #[default]
    English,
    /// `de`.
    German,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Returns its two letters.
    pub const fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }
}

impl FromStr for Language {
    type Err = String;

    /// Takes the two letters, also with a country behind them: `de-AT`.
    fn from_str(text: &str) -> Result<Self, String> {
        let code = text.split('-').next().unwrap_or("").to_ascii_lowercase();
        let known = Self::ALL.into_iter().find(|l| l.code() == code);
        known.ok_or_else(|| format!("no language is called {text:?}; there are en and de"))
    }
}

/// Says what happens, or is looked at, in a sentence; empty for events that nobody has put into words yet.
///
/// ```
/// use delone::{Event, VertexId};
/// use delone_io::narration::{Language, narrate};
///
/// let [a, b, c, d] = [0, 1, 2, 3].map(VertexId::new);
/// let flip = Event::EdgeFlipped { from: [a, b], to: [c, d] };
/// assert_eq!(narrate(flip, Language::English), "Edge 0–1 is flipped: 2–3 takes its place.");
/// assert_eq!(narrate(flip, Language::German), "Kante 0–1 wird gekippt: 2–3 tritt an ihre Stelle.");
/// ```
pub fn narrate(event: Event, language: Language) -> String {
    sentence(event).map_or_else(String::new, |sentence| sentence.say(language))
}

fn sentence(event: Event) -> Option<Sentence> {
    changes::sentence(event).or_else(|| looks::sentence(event))
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::classic::{Algorithm, Input};
    use delone::{Angle, DomainRule, Log, Quality};

    fn run(algorithm: Algorithm) -> Log {
        let points = (0..40).map(|i| (f64::from(i * 37 % 41), f64::from(i * i % 23)));
        let mut input = Input::from_points(points);
        if algorithm.refines() {
            let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 3.0)];
            input = Input::from_points(corners);
            input.pslg.add_ring([0, 1, 2, 3]);
            input.domain = DomainRule::Carve;
            input.quality = Quality {
                min_angle: Some(Angle::degrees(20.0)),
                max_edge: Some(1.0),
                ..Quality::default()
            };
        }
        let mut log = Log::new(algorithm.about().name, input.pslg.points.clone());
        algorithm.observe(&input, &mut log).expect("a run");
        log
    }

    #[test]
    fn every_step_of_every_algorithm_has_a_sentence_in_every_language() {
        for &algorithm in Algorithm::ALL {
            for step in run(algorithm).steps {
                for language in Language::ALL {
                    let said = narrate(step.event, language);
                    assert!(said.ends_with(['.', '?']), "{:?}: {said}", step.event);
                    assert!(!said.contains(['{', '}']), "{:?}: {said}", step.event);
                }
            }
        }
    }

    #[test]
    fn languages_say_the_same_of_the_same() {
        for &algorithm in Algorithm::ALL {
            for step in run(algorithm).steps {
                let sentence = sentence(step.event).expect("a sentence");
                let places = |text: &str| {
                    let all = (0..9).map(|i| format!("{{{i}}}"));
                    all.map(|place| text.contains(&place)).collect::<Vec<_>>()
                };
                let [english, german] = sentence.texts.map(places);
                assert_eq!(english, german, "{:?}", sentence.texts);
                let used = english.iter().filter(|&&is_used| is_used).count();
                assert_eq!(used, sentence.parts.len(), "{:?}", sentence.texts);
            }
        }
    }

    #[test]
    fn languages_are_known_by_their_letters() {
        assert_eq!("de-AT".parse(), Ok(Language::German));
        assert_eq!("EN".parse(), Ok(Language::English));
        "fr".parse::<Language>().unwrap_err();
    }
}
