//! Why a triangle is as it is, in two or three sentences, in English and German.

use super::causes::Rule;
use super::explain::{Corner, Explanation, Shortfall, Why};
use delone::{Quality, VertexId};
use delone_io::narration::Language;
use delone_io::words::measure;

/// Says what a triangle is like, why its youngest corner is there, and how it keeps to what was asked for, if
/// anything was.
pub(super) fn say(told: &Explanation, asked: Option<&Quality>, language: Language) -> String {
    let speaker = Speaker { language };
    let end = match (&told.unmet, asked) {
        (Some(unmet), _) => speaker.unmet(unmet, asked),
        (None, Some(_)) => speaker.word([
            "It keeps to all that was asked for.",
            "Es hält alles ein, was verlangt war.",
        ]),
        (None, None) => speaker.circle(told.is_delaunay),
    };
    format!("{} {} {end}", speaker.shape(told), speaker.youngest(told))
}

struct Speaker {
    language: Language,
}

impl Speaker {
    fn word(&self, words: [&str; 2]) -> String {
        words[self.language as usize].to_owned()
    }

    /// Fills places `{0}`, `{1}` … of a text.
    fn fill(&self, texts: [&str; 2], parts: &[String]) -> String {
        let mut text = self.word(texts);
        for (i, part) in parts.iter().enumerate() {
            text = text.replace(&format!("{{{i}}}"), part);
        }
        text
    }

    fn number(&self, number: f64) -> String {
        let text = measure(number);
        let text = match text.contains('.') && !text.contains('e') {
            true => text.trim_end_matches('0').trim_end_matches('.'),
            false => &text,
        };
        self.with_comma(text.to_owned())
    }

    /// Three digits behind the point tell whether an angle is below its bound.
    fn degrees(&self, angle: f64) -> String {
        let text = format!("{angle:.3}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        self.with_comma(format!("{text}°"))
    }

    fn with_comma(&self, number: String) -> String {
        match self.language {
            Language::German => number.replace('.', ","),
            Language::English => number,
        }
    }

    fn shape(&self, told: &Explanation) -> String {
        let smallest = (0..3).min_by(|&i, &j| told.angles[i].total_cmp(&told.angles[j]));
        let k = smallest.unwrap_or(0);
        let longest = told.edges.into_iter().fold(0.0, f64::max);
        self.fill(
            [
                "The smallest angle of this triangle is {0}, at vertex {1}, and its longest edge measures {2}.",
                "Der kleinste Winkel dieses Dreiecks ist {0}, in Punkt {1}, und seine längste Kante misst {2}.",
            ],
            &[
                self.degrees(told.angles[k]),
                told.corners[k].to_string(),
                self.number(longest),
            ],
        )
    }

    /// Tells of the corner that came last: only with it could there be this triangle.
    fn youngest(&self, told: &Explanation) -> String {
        let added = told.vertices.iter().filter(|v| v.origin != "input");
        let Some(corner) = added.max_by_key(|v| v.vertex) else {
            return self.word([
                "All its corners are points of the input.",
                "Alle seine Ecken sind Punkte der Eingabe.",
            ]);
        };
        let number = corner.vertex.to_string();
        let edge = self.edge(corner);
        let Some(why) = &corner.cause else {
            return self.fill(origin(corner), &[number, edge, crossing(corner)]);
        };
        let by = why
            .by
            .map(|by| self.fill(["vertex {0}", "Punkt {0}"], &[by.to_string()]));
        let by = by.unwrap_or_else(|| self.word(["a vertex", "ein Punkt"]));
        let triangle = why.triangle.map_or_else(String::new, joined);
        self.fill(cause(why), &[number, edge, by, triangle])
    }

    /// Names what a vertex divides.
    fn edge(&self, corner: &Corner) -> String {
        if let Some(k) = corner.segment {
            return self.fill(["segment {0}", "Strecke {0}"], &[k.to_string()]);
        }
        if corner.origin == "onSegment" {
            return self.word(["an edge of the hull", "eine Kante der Hülle"]);
        }
        let ends = corner.cause.as_ref().and_then(|why| why.divided);
        self.fill(
            ["edge {0}", "Kante {0}"],
            &[ends.map_or_else(String::new, joined)],
        )
    }

    fn unmet(&self, unmet: &Shortfall, asked: Option<&Quality>) -> String {
        let angle = asked.and_then(|asked| asked.min_angle);
        let lack = match (&unmet.broken[..], angle) {
            ("angle", Some(angle)) => self.fill(
                [
                    "It falls short of the {0} asked for",
                    "Es bleibt unter den verlangten {0}",
                ],
                &[self.degrees(angle.to_degrees())],
            ),
            _ => self.word([
                "It is not as good as was asked for",
                "Es ist nicht so gut wie verlangt",
            ]),
        };
        let [s, t] = unmet.segments.unwrap_or_default();
        let why = self.fill(
            reason(unmet),
            &[
                s.to_string(),
                t.to_string(),
                unmet.corner.unwrap_or_default().to_string(),
                self.degrees(unmet.angle.unwrap_or_default()),
            ],
        );
        format!("{lack}: {why}.")
    }

    fn circle(&self, is_delaunay: bool) -> String {
        match is_delaunay {
            true => self.word([
                "No vertex lies within its circumcircle.",
                "In seinem Umkreis liegt kein Punkt.",
            ]),
            false => self.word([
                "There are vertices within its circumcircle, but segments hide them.",
                "In seinem Umkreis liegen Punkte, aber Strecken verdecken sie.",
            ]),
        }
    }
}

/// Why a vertex is there: {0} is its number, {1} the edge that it divides, {2} who lay too close, {3} the triangle that
/// had to go.
fn cause(why: &Why) -> [&'static str; 2] {
    match (why.kind, why.triangle.is_some(), why.divided.is_some()) {
        (Rule::Circumcenter, ..) => [
            "Vertex {0} was put within the circumcircle of triangle {3}, which had too small an angle, and vanished.",
            "Punkt {0} kam in den Umkreis des Dreiecks {3}, das einen zu kleinen Winkel hatte und dadurch verschwand.",
        ],
        (Rule::RejectedCircumcenter, ..) => [
            "Vertex {0} divides {1}, because triangle {3} had to go, and its circumcenter could not be used.",
            "Punkt {0} teilt {1}, weil Dreieck {3} weichen sollte und sein Umkreismittelpunkt nicht zu brauchen war.",
        ],
        (Rule::Encroachment, ..) => [
            "Vertex {0} divides {1}, because {2} lay too close to it.",
            "Punkt {0} teilt {1}, denn {2} lag zu nahe daran.",
        ],
        (Rule::Size, true, true) => [
            "Vertex {0} divides {1}, because triangle {3} was larger than asked for.",
            "Punkt {0} teilt {1}, denn Dreieck {3} war größer als verlangt.",
        ],
        (Rule::Size, true, false) => [
            "Vertex {0} was added because triangle {3} was larger than asked for.",
            "Punkt {0} kam hinzu, weil Dreieck {3} größer als verlangt war.",
        ],
        (Rule::Size, false, _) => [
            "Vertex {0} divides {1}, which was longer than asked for.",
            "Punkt {0} teilt {1}: Sie war länger als verlangt.",
        ],
        (Rule::Lattice, ..) => [
            "Vertex {0} was sown as part of an even lattice.",
            "Punkt {0} wurde als Teil eines gleichmäßigen Gitters gesät.",
        ],
    }
}

/// Where a vertex comes from, if nobody knows why: {2} are the segments that cross there.
fn origin(corner: &Corner) -> [&'static str; 2] {
    match corner.origin {
        "crossing" => [
            "Vertex {0} lies where segments {2} cross.",
            "In Punkt {0} kreuzen sich die Strecken {2}.",
        ],
        "onSegment" => [
            "Vertex {0} was added on {1}.",
            "Punkt {0} kam auf {1} hinzu.",
        ],
        _ => [
            "Vertex {0} was added in between.",
            "Punkt {0} kam dazwischen hinzu.",
        ],
    }
}

fn joined<const N: usize>(vertices: [VertexId; N]) -> String {
    vertices.map(|v| v.index().to_string()).join("–")
}

fn crossing(corner: &Corner) -> String {
    let [s, t] = corner.segments.unwrap_or_default();
    format!("{s}, {t}")
}

/// Why a triangle was left: {0} and {1} are the segments that meet at {2} at {3}.
fn reason(unmet: &Shortfall) -> [&'static str; 2] {
    match unmet.reason {
        "smallInputAngle" if unmet.segments.is_none() => [
            "the domain has a corner of only {3} at vertex {2}, and no mesh can change that",
            "Das Gebiet hat in Punkt {2} eine Ecke von nur {3}, und das kann kein Netz ändern",
        ],
        "smallInputAngle" => [
            "segments {0} and {1} meet at vertex {2} at only {3}, and no mesh can change that",
            "Die Strecken {0} und {1} treffen sich in Punkt {2} unter nur {3}, und das kann kein Netz ändern",
        ],
        "lockedBoundary" => [
            "a segment there must not be divided",
            "Eine Strecke dort darf nicht geteilt werden",
        ],
        "precision" => [
            "coordinates have no room for another vertex there",
            "Zwischen den Koordinaten ist dort kein Platz für einen weiteren Punkt",
        ],
        "gradation" => [
            "another vertex would be far closer to others than the features of the input are",
            "Ein weiterer Punkt läge anderen viel näher, als es die Merkmale der Eingabe sind",
        ],
        "stopped" => [
            "the work stopped before its turn",
            "Die Arbeit endete, bevor es an der Reihe war",
        ],
        _ => ["it was left as it is", "Es wurde so gelassen"],
    }
}
