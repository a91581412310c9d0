//! Animations: whatever a log holds can be drawn, and what is drawn is what was played.

use super::files::run;
use super::steps::{Maker, one_of_each, recording};
use delone::{Event, Point, Scene, Step, VertexId, Watch};
use delone_io::{
    AnimationOptions, AnimationReport, Error, Pace, Recording, ShownSteps, Strip, Target,
    write_animation,
};
use std::collections::HashSet;
use std::mem::discriminant;

/// A picture as it is written.
struct Drawn {
    svg: String,
    gif: Vec<u8>,
    png: Vec<u8>,
    report: AnimationReport,
}

fn draw(recording: &Recording, options: &AnimationOptions) -> Result<Drawn, Error> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = ["a.svg", "a.gif", "a.png"].map(|name| folder.path().join(name));
    let targets = files.clone().map(|file| Target::from_arg(file, None));
    let written = write_animation(&targets, recording, options, &());
    let left = std::fs::read_dir(folder.path()).expect("there").count();
    assert_eq!(left, if written.is_ok() { 3 } else { 0 }, "all or nothing");
    let report = written?;
    assert_eq!(report.files, files);
    let [svg, gif, png] = files.map(|file| std::fs::read(file).expect("written"));
    let svg = String::from_utf8(svg).expect("text");
    Ok(Drawn {
        svg,
        gif,
        png,
        report,
    })
}

/// Small, so that it is quick.
fn small() -> AnimationOptions {
    AnimationOptions {
        size: 100,
        ..AnimationOptions::default()
    }
}

/// The frames of a GIF, each as a browser shows it, and how long it stays, in hundredths of a second.
fn play(gif: &[u8]) -> Vec<(Vec<u8>, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(gif).expect("a GIF");
    let width = usize::from(decoder.width());
    let mut page = vec![0; 4 * width * usize::from(decoder.height())];
    let mut frames = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        for (i, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let (y, x) = (i / usize::from(frame.width), i % usize::from(frame.width));
            let at = (y + usize::from(frame.top)) * width + x + usize::from(frame.left);
            if pixel[3] > 0 {
                page[4 * at..][..4].copy_from_slice(pixel);
            }
        }
        frames.push((page.clone(), frame.delay));
    }
    frames
}

fn check(recording: &Recording, options: &AnimationOptions) -> Drawn {
    let drawn = draw(recording, options).unwrap_or_else(|e| panic!("{e}"));
    let svg = &drawn.svg;
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{svg}");
    let mut reader = quick_xml::Reader::from_str(svg);
    while reader.read_event().expect("well-formed") != quick_xml::events::Event::Eof {}
    assert_eq!(play(&drawn.gif).len(), drawn.report.frames);
    png::Decoder::new(&drawn.png[..])
        .read_info()
        .expect("a PNG");
    drawn
}

fn points(places: &[(f64, f64)]) -> Vec<Point> {
    places.iter().copied().map(Point::from).collect()
}

fn scattered(n: u64) -> Vec<Point> {
    let mut maker = Maker::new(n);
    let mut number = move || maker.below(1000) as f64 / 10.0;
    (0..n).map(|_| Point::new(number(), number())).collect()
}

#[test]
fn every_point_set_moves() {
    let huge = f64::MAX;
    let sets: [&[(f64, f64)]; 8] = [
        &[],
        &[(1.0, 2.0)],
        &[(1.0, 2.0), (1.0, 2.0)],
        &[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)],
        &[(0.0, 0.0), (0.0, 1e-300), (0.0, -3.0), (1.0, 0.0)],
        &[(huge, huge), (-huge, huge), (0.0, -huge), (1e-300, 5e-324)],
        &[(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324)],
        &[(0.0, 0.0), (1e300, 1e-300), (1e-300, 1e300), (1.0, 1.0)],
    ];
    for set in sets {
        check(&run(points(set)), &small());
    }
}

/// A log with events of all kinds that fit the scene.
fn eventful(seed: u64) -> Recording {
    let start = scattered(7);
    let mut events: Vec<_> = run(start.clone())
        .log
        .steps
        .iter()
        .map(|s| s.event)
        .collect();
    let mut scene = Scene::new(start.clone());
    for &event in &events {
        scene.apply(event).expect("a run");
    }
    let triangle = scene.triangles().next().expect("seven points");
    events.extend([
        Event::TriangleDeleted { triangle },
        Event::TriangleCreated { triangle },
    ]);
    let vertex = VertexId::new(start.len());
    let [from, to] = [Point::new(4.0, 2.0), Point::new(5.0, 1.0)];
    for event in [
        Event::VertexCreated { vertex, at: from },
        Event::VertexMoved { vertex, from, to },
    ] {
        scene.apply(event).expect("a vertex that is free");
        events.push(event);
    }
    let mut maker = Maker::new(seed);
    maker.vertices = 9;
    maker.wild = false;
    let mut undone = Vec::new();
    for round in 0..3000 {
        let event = match round % 5 {
            0 => undone.pop().map(Event::reversed),
            1 => flip(&scene, &mut maker),
            _ => Some(maker.event(None)),
        };
        let Some(event) = event else { continue };
        if scene.apply(event).is_ok() && (event.changes_scene() || round % 3 == 0) {
            undone.push(event);
            events.push(event);
        }
    }
    recording(start, events)
}

/// Draws every step.
fn draw_all(recording: &Recording) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let target = Target::from_arg(folder.path().join("a.svg"), None);
    let options = AnimationOptions {
        max_frames: usize::MAX,
        ..small()
    };
    let report = write_animation(&[target], recording, &options, &()).expect("can be drawn");
    assert_eq!(report.frames, recording.log.steps.len() + 2);
}

/// A flip of some edge between two triangles.
fn flip(scene: &Scene, maker: &mut Maker) -> Option<Event> {
    let edges: Vec<_> = scene.edges().collect();
    let [a, b] = edges[maker.below(edges.len() as u64) as usize];
    let to = [scene.apex([a, b])?, scene.apex([b, a])?];
    let from = [a, b];
    Some(Event::EdgeFlipped { from, to })
}

#[test]
fn every_event_is_drawn() {
    let mut kinds = HashSet::new();
    for seed in 0..4 {
        let recording = eventful(seed);
        kinds.extend(recording.log.steps.iter().map(|s| discriminant(&s.event)));
        let options = AnimationOptions {
            max_frames: 60,
            ..small()
        };
        assert_eq!(check(&recording, &options).report.frames, 60);
        draw_all(&recording);
    }
    let all = one_of_each(0, |_| {});
    let missing = all
        .iter()
        .filter(|event| !kinds.contains(&discriminant(*event)));
    let missing: Vec<_> = missing.collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn what_does_not_fit_is_refused_with_its_step() {
    let [a, b, far] = [0, 1, u32::MAX as usize - 1].map(VertexId::new);
    let create = Event::EdgeCreated { edge: [a, b] };
    let place = Point::default();
    let vertex = |vertex| Event::VertexCreated { vertex, at: place };
    let two = || points(&[(0.0, 0.0), (1.0, 1.0)]);
    for (events, expected) in [
        ([create, create], "step 1 of the log"),
        (
            [create, vertex(far)],
            "its number is not the next that is free",
        ),
        ([vertex(a), create], "step 0 of the log"),
    ] {
        let error = draw(&recording(two(), events), &small()).map(|_| ());
        let error = error.expect_err(expected).to_string();
        assert!(error.contains(expected), "{error}");
    }
    // What is only looked at may be anywhere.
    let looked = [
        Event::PointConsidered { vertex: far },
        Event::CircleTested {
            triangle: [a, b, far],
            point: far,
            answer: delone::predicates::CircleSide::On,
            is_inside: true,
        },
    ];
    check(&recording(two(), looked), &small());
}

#[test]
fn too_many_steps_are_sampled_evenly() {
    let recording = run(scattered(40));
    let steps = recording.log.steps.len();
    let options = AnimationOptions {
        max_frames: 25,
        ..small()
    };
    let report = check(&recording, &options).report;
    // All steps, what there is before them, and the result.
    assert_eq!((report.frames, report.wanted), (25, steps + 2));
    let options = AnimationOptions {
        shown: ShownSteps::Changes,
        ..options
    };
    let report = check(&recording, &options).report;
    assert!(report.wanted < steps && report.frames == 25, "{report:?}");
}

#[test]
fn what_a_run_begins_with_is_no_frame() {
    let mut recording = run(scattered(5));
    let steps = recording.log.steps.len();
    for step in &mut recording.log.steps[..10] {
        step.line = 0;
    }
    assert_eq!(check(&recording, &small()).report.frames, steps - 10 + 2);
    for step in &mut recording.log.steps {
        step.line = 0;
    }
    assert_eq!(check(&recording, &small()).report.frames, 1);
}

#[test]
fn every_flip_moves() {
    let recording = run(scattered(12));
    let is_flip = |s: &&Step| matches!(s.event, Event::EdgeFlipped { .. });
    let flips = recording.log.steps.iter().filter(is_flip).count();
    assert!(flips > 0);
    let svg = check(&recording, &small()).svg;
    assert_eq!(svg.matches("attributeName=\"d\"").count(), flips);
}

#[test]
fn a_thousand_steps_stay_small() {
    let recording = run(scattered(32));
    let steps = recording.log.steps.len();
    assert!(steps > 900, "{steps}");
    let options = AnimationOptions {
        max_frames: 2000,
        ..AnimationOptions::default()
    };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("a.svg");
    let target = Target::from_arg(&path, None);
    write_animation(&[target], &recording, &options, &()).expect("can be drawn");
    let size = std::fs::metadata(path).expect("written").len() as usize;
    println!("{steps} steps: {size} bytes");
    assert!(size < 900 * steps, "{size} bytes for {steps} steps");
}

/// A GIF holds only what changes: played to its end it shows what one of two frames shows.
#[test]
fn frames_add_up() {
    let recording = run(scattered(20));
    let [few, many] = [2, 500].map(|max_frames| {
        let options = AnimationOptions {
            max_frames,
            size: 300,
            ..AnimationOptions::default()
        };
        let frames = play(&check(&recording, &options).gif);
        frames.last().expect("frames").0.clone()
    });
    let differ = few.iter().zip(&many).filter(|(a, b)| a.abs_diff(**b) > 24);
    let differ = differ.count();
    // But for the note that frames are left out, and the palette.
    assert!(differ * 50 < few.len(), "{differ} of {}", few.len());
    assert!(
        few.chunks_exact(4).any(|pixel| pixel[0] < 100),
        "there are lines"
    );
}

#[test]
fn seconds_are_kept() {
    let recording = run(scattered(9));
    for (pace, expected) in [(Pace::InSeconds(3.0), 300), (Pace::InSeconds(0.5), 50)] {
        let drawn = check(&recording, &AnimationOptions { pace, ..small() });
        let delays = play(&drawn.gif)
            .iter()
            .map(|&(_, delay)| u32::from(delay))
            .sum::<u32>();
        assert!(delays.abs_diff(expected) <= 2, "{delays}");
        let seconds = f64::from(expected) / 100.0;
        assert!(drawn.svg.contains(&format!("dur=\"{seconds:.3}s\"")));
    }
}

#[test]
fn a_strip_has_its_frames_at_the_ends_of_stages() {
    let ended = |stage| Event::StageEnded {
        stage,
        min_angle: None,
    };
    let stages = [delone::Stage::Sweep, delone::Stage::Flips].map(ended);
    let events = [
        [Event::PointConsidered {
            vertex: VertexId::new(0),
        }; 2],
        stages,
    ]
    .concat();
    let recording = recording(points(&[(0.0, 0.0)]), events);
    for (frames, at_stages, expected) in
        [(12, true, 2), (1, true, 1), (12, false, 6), (3, false, 3)]
    {
        let strip = Strip { frames, at_stages };
        let folder = tempfile::tempdir().expect("a temporary folder");
        let target = Target::from_arg(folder.path().join("a.png"), None);
        let options = AnimationOptions { strip, ..small() };
        let report = write_animation(&[target], &recording, &options, &()).expect("drawn");
        assert_eq!(report.frames, expected, "{strip:?}");
    }
}

#[test]
fn what_is_out_of_range_is_refused() {
    let strip = |frames| Strip {
        frames,
        at_stages: false,
    };
    let options = || AnimationOptions::default();
    let bad = [
        AnimationOptions {
            size: 63,
            ..options()
        },
        AnimationOptions {
            size: 8193,
            ..options()
        },
        AnimationOptions {
            strip: strip(0),
            ..options()
        },
        AnimationOptions {
            strip: strip(101),
            ..options()
        },
        AnimationOptions {
            pace: Pace::PerSecond(0.0),
            ..options()
        },
        AnimationOptions {
            pace: Pace::PerSecond(f64::NAN),
            ..options()
        },
        AnimationOptions {
            pace: Pace::PerSecond(51.0),
            ..options()
        },
        AnimationOptions {
            pace: Pace::InSeconds(f64::INFINITY),
            ..options()
        },
        AnimationOptions {
            pace: Pace::InSeconds(-1.0),
            ..options()
        },
    ];
    for options in bad {
        let error = draw(&run(scattered(4)), &options).map(|_| ());
        let error = error.expect_err("out of range").to_string();
        assert!(error.contains("must be from"), "{error}");
    }
    let target = Target::from_arg("a.ele", None);
    let error = write_animation(&[target], &run(scattered(4)), &small(), &());
    let error = error.expect_err("no animation").to_string();
    assert!(error.contains("svg, png, gif"), "{error}");
}

#[test]
fn cancelling_leaves_no_animation() {
    struct Cancelled;
    impl Watch for Cancelled {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    for name in ["a.svg", "a.gif", "a.png"] {
        let target = Target::from_arg(folder.path().join(name), None);
        let error = write_animation(&[target], &run(scattered(9)), &small(), &Cancelled);
        assert!(matches!(error, Err(Error::Cancelled)));
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 0);
}
