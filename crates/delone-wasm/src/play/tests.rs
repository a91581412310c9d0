//! Every algorithm, played from one end to the other and back.

use super::*;

fn drawing(algorithm: &str) -> Drawing {
    let preset = match algorithm {
        "thesis" | "sweep" | "edge-flip" | "segment-walk" => "thesis",
        _ => "uniform",
    };
    Drawing::preset(preset, 30, 1).expect("a preset")
}

#[test]
fn every_algorithm_plays_to_the_end_and_back() {
    for algorithm in Algorithm::ALL {
        let name = algorithm.about().name;
        let mut player = Player::run(name, &drawing(name), None, None).expect(name);
        let first = player.points();
        for position in 0..=player.length() {
            player.seek(position).expect("a step that fits");
            let step = player.step();
            assert_eq!(step == "null", position == 0, "{name}");
            assert!(!step.contains(r#""kind":"other""#), "{name}: {step}");
            let said = player.narration("de").expect("German");
            assert_eq!(said.is_empty(), position == 0, "{name}: {step}");
            assert!(usize::from(player.line()) <= algorithm.about().code.len());
        }
        assert_eq!(player.edges().len(), 2 * player.locked().len());
        player.seek(0).expect("the beginning");
        assert_eq!(
            (player.points(), player.edges().len()),
            (first, 0),
            "{name}"
        );
    }
}

#[test]
fn the_result_is_that_of_the_library() {
    let drawing = drawing("incremental");
    let mut player = Player::run("incremental", &drawing, None, None).expect("a run");
    player.seek(u32::MAX).expect("the end");
    let mesh = crate::mesh::Mesh::triangulate(&drawing, None).expect("a mesh");
    assert_eq!(player.hash(), mesh.hash());
    assert!(player.tally().contains(r#""circleTests":"#));
}

#[test]
fn kinds_name_events_as_logs_do() {
    for algorithm in Algorithm::ALL {
        let name = algorithm.about().name;
        let player = Player::run(name, &drawing(name), None, None).expect(name);
        for step in player.steps() {
            let kind = seeking::kind(&step.event);
            let written = json::write(&step.event);
            assert!(written.starts_with(&format!(r#"{{"{kind}":"#)), "{written}");
        }
    }
}

#[test]
fn steps_are_found_by_kind_in_both_directions() {
    let player = Player::run("flip-list", &drawing("flip-list"), None, None).expect("a run");
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(next) = player.next("flip", at).expect("a kind") {
        found.push(next);
        at = next;
    }
    assert!(!found.is_empty());
    let mut back = Vec::new();
    let mut at = player.length() + 1;
    while let Some(previous) = player.previous("edge-flipped", at).expect("a kind") {
        back.push(previous);
        at = previous;
    }
    back.reverse();
    assert_eq!(found, back);
    assert_eq!(
        player.next("result", 0).expect("a kind"),
        Some(player.length())
    );
    assert_eq!(player.next("flip", u32::MAX).expect("a kind"), None);
    player.next("flop", 0).expect_err("no such kind");
    player.waiting("somewhere").expect_err("no such queue");
}

#[test]
fn runs_are_saved_and_read_again() {
    let player = Player::run("sweep", &drawing("sweep"), None, None).expect("a run");
    for name in ["run.dlog", "run.json"] {
        let files = player.save(name, None).expect("a log");
        let again = Player::from_log(name, &files[0].bytes()).expect("a run");
        assert_eq!(again.recording, player.recording);
    }
    let options = r#"{"size": 100, "seconds": 1, "maxFrames": 10, "frames": 4}"#.to_owned();
    for name in ["run.svg", "run.gif", "run.png"] {
        let files = player.save(name, Some(options.clone())).expect(name);
        assert!(!files[0].bytes().is_empty(), "{name}");
    }
}

#[test]
fn what_is_not_there_is_refused() {
    let drawing = drawing("sweep");
    let unknown = Player::run("quicksort", &drawing, None, None)
        .err()
        .expect("unknown");
    assert!(unknown.to_string().contains("greedy-flips"));
    let options = Some(r#"{"sede": 1}"#.to_owned());
    assert!(Player::run("sweep", &drawing, options, None).is_err());
    assert!(Player::from_log("a.dlog", b"nonsense").is_err());
}

/// A run that tells of itself at least twice, and a listener that says stop at the second time.
#[test]
fn a_run_stops_when_it_is_told_to() {
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
    let drawing = Drawing::preset("uniform", 3000, 1).expect("points");
    let record = |most: usize| {
        let (calls, last) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let listener = |steps| {
            assert!(steps > last.swap(steps, Relaxed));
            calls.fetch_add(1, Relaxed) + 1 < most
        };
        let options = run::Options::default();
        let run = run::record("divide-and-conquer", &drawing, &options, &listener);
        (run, calls.into_inner())
    };
    let (run, calls) = record(usize::MAX);
    let (recording, times) = run.expect("a run");
    let steps = recording.log.steps.len();
    assert!(
        calls > 2 && calls == steps >> 14,
        "{calls} calls in {steps} steps"
    );
    assert!(times.at(steps) > 0.0);
    let (run, calls) = record(2);
    assert_eq!(run.expect_err("cancelled").to_string(), "cancelled");
    assert_eq!(calls, 2);
}

#[test]
fn whatever_there_is_can_be_asked_about() {
    let nothing = Drawing::new(&[], &[], &[]).expect("nothing");
    let preset = |name| Drawing::preset(name, 20, 1).expect(name);
    let drawings = ["uniform", "grid", "cocircular", "collinear"].map(preset);
    for drawing in drawings.iter().chain([&nothing]) {
        for algorithm in Algorithm::ALL {
            let name = algorithm.about().name;
            let Ok(mut player) = Player::run(name, drawing, None, None) else {
                continue;
            };
            for position in [0, player.length() / 2, player.length()] {
                player.seek(position).expect("a step that fits");
                let counts = player.angles().iter().sum::<u32>() as usize;
                assert_eq!(counts, player.triangles().len() / 3, "{name}");
                assert!(player.illegal().len() <= 2 * player.edges().len());
                let looker = player.looker();
                let nearest = looker.nearest(0.3, 0.4).expect("a place");
                assert_eq!(nearest == "null", player.points().is_empty(), "{name}");
                looker.cells(None).expect("cells");
                let steps = format!(r#""steps":{position},"#);
                assert!(player.tally_at(position).contains(&steps), "{name}");
                assert_eq!(
                    player.position_at("steps", position.into()).expect("steps"),
                    position
                );
            }
            let end = player.search(r#"[{"kind": "result"}]"#, 0, false);
            let last = Some(player.length()).filter(|&length| length > 0);
            assert_eq!(end.expect("a kind"), last, "{name}");
        }
    }
}
