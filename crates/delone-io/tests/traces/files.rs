//! Files of logs: what is written is read, and what is damaged is refused.

use super::steps::{Maker, one_of_each, recording};
use delone::classic::{Algorithm, Input};
use delone::{Event, Log, Point, Sweep, VertexId, Watch};
use delone_io::{Error, LogFormat, Recording, Source, read_log, write_log};
use proptest::prelude::*;

/// Writes a log into a file, and returns the bytes.
fn bytes_of(recording: &Recording, format: LogFormat) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("run").with_extension(format.name());
    let names = write_log(recording, Some(&path), None, &()).expect("can be written");
    assert_eq!(names, std::slice::from_ref(&path));
    std::fs::read(path).expect("written")
}

fn read(bytes: &[u8]) -> Result<Recording, Error> {
    let source = Source::Memory {
        name: "run".to_owned(),
        bytes: bytes.to_vec(),
    };
    read_log(&source, &())
}

fn check_round_trip(recording: &Recording) {
    for format in LogFormat::ALL {
        let bytes = bytes_of(recording, format);
        assert!(LogFormat::is_log(&bytes));
        let back = read(&bytes).unwrap_or_else(|e| panic!("{format}: {e}"));
        assert_eq!(&back, recording, "{format}");
        // Zeros have signs, too.
        assert_eq!(format!("{back:?}"), format!("{recording:?}"), "{format}");
    }
}

/// The log of a real run.
pub fn run(points: Vec<Point>) -> Recording {
    let input = Input::from_points(points);
    let about = Algorithm::Incremental.about();
    let mut log = Log::new(about.name, input.pslg.points.clone());
    let done = Algorithm::Incremental.observe(&input, &mut log);
    done.expect("finite points");
    Recording::new(about, log)
}

fn lattice(n: u32) -> Vec<Point> {
    let place = |i: u32| Point::new(f64::from(i % n), f64::from(i / n) * 0.1);
    (0..n * n).map(place).collect()
}

#[test]
fn every_event_comes_back() {
    for seed in 0..50 {
        check_round_trip(&recording(lattice(2), one_of_each(seed, |_| {})));
    }
}

#[test]
fn runs_come_back() {
    for n in 0..6 {
        check_round_trip(&run(lattice(n)));
    }
    check_round_trip(&Recording::default());
}

#[test]
fn what_is_not_finite_only_bytes_can_hold() {
    let swept = |y| Event::SweptTo {
        from: None,
        to: Some(Sweep::Horizontal(y)),
    };
    for to in [f64::INFINITY, f64::NEG_INFINITY, -0.0] {
        let recording = recording(Vec::new(), [swept(1.0), swept(to)]);
        let back = read(&bytes_of(&recording, LogFormat::Binary)).expect("just written");
        assert_eq!(back, recording);
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("run.json");
    let steps = recording(Vec::new(), [swept(1.0), swept(f64::NAN)]);
    let points = recording(vec![Point::default(), Point::new(0.0, f64::INFINITY)], []);
    for (bad, culprit) in [(steps, "step 1"), (points, "point 1")] {
        let error = write_log(&bad, Some(&path), None, &()).expect_err("not finite");
        assert!(error.to_string().contains(culprit), "{error}");
    }
    let left = std::fs::read_dir(folder.path()).expect("there").count();
    assert_eq!(left, 0, "no file is left");
}

#[test]
fn a_line_is_a_step_and_circles_can_be_drawn() {
    let corners = [(0.0, 0.0), (6.0, 0.0), (0.0, 8.0)].map(Point::from);
    let test = Event::CircleTested {
        triangle: [0, 1, 2].map(VertexId::new),
        point: VertexId::new(2),
        answer: delone::predicates::CircleSide::On,
        is_inside: false,
    };
    let flat = Event::CircleTested {
        triangle: [0, 1, 1].map(VertexId::new),
        point: VertexId::new(9),
        answer: delone::predicates::CircleSide::Outside,
        is_inside: false,
    };
    let text = bytes_of(&recording(corners.into(), [test, flat]), LogFormat::Json);
    let text = String::from_utf8(text).expect("text");
    let line = |n: usize| text.lines().nth(n).expect("a line");
    assert_eq!(line(0), r#"{"format":"delone-log","version":1,"#);
    assert_eq!(line(11), "[6.0,0.0],");
    assert_eq!(
        line(15),
        r#"{"line":1,"circle-tested":{"triangle":[0,1,2],"point":2,"answer":"on","is_inside":false},"circle":[3.0,4.0,5.0]},"#
    );
    assert!(!line(16).contains("\"circle\":"), "three points on a line");
}

#[test]
fn bytes_take_a_tenth_of_text() {
    let recording = run(lattice(20));
    let [text, bytes] = LogFormat::ALL.map(|format| bytes_of(&recording, format).len());
    let steps = recording.log.steps.len();
    println!("{steps} steps: {text} bytes of text, {bytes} bytes");
    assert!(bytes * 8 < text && bytes < 12 * steps, "{bytes} {text}");
}

#[test]
fn the_content_tells_the_format_whatever_the_name_says() {
    let recording = run(lattice(2));
    for format in LogFormat::ALL {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("run.txt");
        let error = write_log(&recording, Some(&path), None, &()).expect_err("txt is no log");
        assert!(error.to_string().contains("json, dlog"), "{error}");
        write_log(&recording, Some(&path), Some(format), &()).expect("can be written");
        let back = read_log(&Source::from_arg(&path), &()).expect("just written");
        assert_eq!(back, recording);
    }
    assert_eq!(".DLOG".parse(), Ok(LogFormat::Binary));
    "gif".parse::<LogFormat>().expect_err("no log");
    for bytes in [&b""[..], b"3 2 0 0\n", b"\x89PNG\r\n\x1a\n"] {
        let error = read(bytes).expect_err("no log").to_string();
        assert!(error.contains("run: unknown format"), "{error}");
    }
}

/// What an error must say of a text in which one piece was replaced by another; LINE is where that was.
const SPOILED: &[(&str, &str, &str)] = &[
    (
        r#""version":1"#,
        r#""version":2"#,
        "run: version 2 of the format; this program reads version 1",
    ),
    (
        r#""delone-log""#,
        r#""FeatureCollection""#,
        "run: format is \"FeatureCollection\"",
    ),
    (r#""format":"delone-log","#, "", "missing field `format`"),
    (
        "edge-created",
        "edge-cremated",
        "run:LINE:41: the step names no event that is known",
    ),
    ("[0,1]", "[0,-1]", "run:LINE:"),
    ("[0,1]", "[0]", "run:LINE:"),
    ("[0.0,0.0]", "[0.0]", "run:LINE:"),
    (r#""line":1"#, r#""line":70000"#, "run:LINE:"),
    (r#""line":1,"#, "", "run:LINE:"),
    ("\"steps\":[\n", "\"steps\":[,\n", "run:LINE:10:"),
];

#[test]
fn spoiled_text_is_refused_with_its_line() {
    let text = bytes_of(&run(lattice(2)), LogFormat::Json);
    let text = String::from_utf8(text).expect("text");
    for &(old, new, expected) in SPOILED {
        assert!(text.contains(old), "{old} is not in {text}");
        let (before, _) = text.split_once(old).expect("just found");
        let line = 1 + before.matches('\n').count();
        let expected = expected.replace("LINE", &line.to_string());
        let spoiled = text.replacen(old, new, 1);
        let error = read(spoiled.as_bytes()).expect_err(&expected).to_string();
        assert!(error.contains(&expected), "{error:?} lacks {expected:?}");
    }
}

#[test]
fn every_end_too_early_is_refused() {
    let recording = run(lattice(2));
    for format in LogFormat::ALL {
        let bytes = bytes_of(&recording, format);
        let length = if format == LogFormat::Json {
            bytes.len() - 1
        } else {
            bytes.len()
        };
        for end in 0..length {
            let error = read(&bytes[..end]).expect_err("truncated").to_string();
            assert!(
                end < 8 || error.contains("run at byte") || error.contains("run:"),
                "{error}"
            );
        }
    }
}

#[test]
fn every_changed_byte_of_a_dlog_is_noticed() {
    let bytes = bytes_of(&run(lattice(3)), LogFormat::Binary);
    for at in 0..bytes.len() {
        for change in [1, 0x20, 0x80, 0xff] {
            let mut spoiled = bytes.clone();
            spoiled[at] ^= change;
            read(&spoiled).expect_err("a byte was changed");
        }
    }
    let longer = [&bytes[..], b"\0"].concat();
    let error = read(&longer).expect_err("too long").to_string();
    assert!(error.contains("5 bytes after the last step"), "{error}");
}

#[test]
fn what_a_dlog_declares_is_not_believed() {
    let head = b"\x89DLOG\r\n\x1a".to_vec();
    let most = [0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01];
    let mut texts = head.clone();
    texts.push(1);
    let cases = [
        ([&head[..], &[2]].concat(), "version 2 of the format"),
        ([&head[..], &most].concat(), "version 18446744073709551615"),
        ([&head[..], &[0xff; 11]].concat(), "larger than 64 bits"),
        (
            [&texts[..], &most].concat(),
            "at byte 9: algorithm: the file ends 18446744073709551615 bytes early",
        ),
        ([&texts[..], &[1, 0xff]].concat(), "not UTF-8"),
        (
            [&texts[..], &[0, 0, 0], &most].concat(),
            "line of code 0 of 18446744073709551615",
        ),
        (
            [&texts[..], &[0, 0, 0, 0], &most].concat(),
            "point 0 of 18446744073709551615",
        ),
        (
            [&texts[..], &[0, 0, 0, 0, 0], &most].concat(),
            "step 0 of 18446744073709551615",
        ),
        (
            [&texts[..], &[0, 0, 0, 0, 0, 1, 1, 1]].concat(),
            "name 1 of 0 that are known",
        ),
        (
            [&texts[..], &[0, 0, 0, 0, 0, 1, 1, 0, 1, b'x']].concat(),
            "unknown variant `x`",
        ),
    ];
    for (bytes, expected) in cases {
        let error = read(&bytes).expect_err(expected).to_string();
        assert!(error.contains(expected), "{error:?} lacks {expected:?}");
    }
}

/// Returns the code of the documentation that follows a heading.
fn documented(heading: &str) -> String {
    let page = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../docs/algorithms/log-format.md"
    );
    let page = std::fs::read_to_string(page).expect("the page");
    let (_, after) = page.split_once(heading).expect(heading);
    let (_, code) = after.split_once("```").expect("code");
    let (code, _) = code.split_once("```").expect("its end");
    let (_, code) = code.split_once('\n').expect("lines");
    code.to_owned()
}

#[test]
fn the_documented_example_is_what_is_written() {
    let text = documented("## Text");
    let recording = read(text.as_bytes()).expect("the example");
    let written = bytes_of(&recording, LogFormat::Json);
    assert_eq!(String::from_utf8_lossy(&written), text);
    recording.log.last_scene().expect("can be played");
    let rows = bytes_of(&recording, LogFormat::Binary);
    let rows = rows.chunks(24).map(|row| {
        let digits: Vec<_> = row.iter().map(|byte| format!("{byte:02x}")).collect();
        digits.join(" ") + "\n"
    });
    let documented = documented("### The same example");
    assert_eq!(rows.collect::<String>(), documented);
}

#[test]
fn cancelling_leaves_no_file() {
    struct Cancelled;
    impl Watch for Cancelled {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    for format in LogFormat::ALL {
        let path = folder.path().join(format.name());
        let error = write_log(&run(lattice(3)), Some(&path), Some(format), &Cancelled);
        assert!(matches!(error, Err(Error::Cancelled)));
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_steps_come_back(seed: u64, steps in 0..60_usize) {
        let mut maker = Maker::new(seed);
        let events: Vec<_> = (0..steps).map(|_| maker.event(None)).collect();
        let points = (0..3).map(|_| Point::new(maker.number(), maker.number())).collect();
        check_round_trip(&recording(points, events));
    }

    #[test]
    fn any_run_comes_back(places in prop::collection::vec((0..6_u8, -1e9..1e9_f64), 0..20)) {
        check_round_trip(&run(places.iter().map(|&(x, y)| Point::new(x.into(), y)).collect()));
    }

    #[test]
    fn spoiled_files_never_panic(
        spots in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        cut: prop::sample::Index,
    ) {
        let recording = run(lattice(3));
        for format in LogFormat::ALL {
            let mut bytes = bytes_of(&recording, format);
            for (at, byte) in &spots {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            drop(read(&bytes));
            drop(read(&bytes[..cut.index(bytes.len())]));
        }
    }
}
