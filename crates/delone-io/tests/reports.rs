//! Reports: pages are well-formed and hold what they should, whatever the mesh.

use delone::{
    Angle, Broken, Outcome, Pslg, Quality, Reason, RefinedMesh, Refinement, TriangleId, Unmet,
    VertexId, Watch,
};
use delone_io::{Error, MeshView, PictureOptions, ReportOptions, Target, write_report};
use quick_xml::Reader;
use quick_xml::events::Event;
use std::collections::BTreeMap;
use std::path::Path;

const ASKED: Quality = Quality {
    min_angle: Some(Angle::degrees(20.0)),
    max_edge: Some(0.75),
    max_area: None,
    region_areas: false,
};

/// Triangulates points on their convex hull, and pretends that more was asked for.
fn mesh(points: &[(f64, f64)]) -> RefinedMesh {
    let pslg = Pslg::from_points(points.iter().copied());
    let plain = Refinement::new(Quality::default());
    let mut refined = plain.mesh(pslg).expect("finite points");
    refined.report.asked = ASKED;
    refined
}

/// A grid of `side` by `side` points.
fn grid(side: u32) -> RefinedMesh {
    let points = (0..side * side).map(|i| (f64::from(i % side), f64::from(i / side)));
    mesh(&points.collect::<Vec<_>>())
}

/// Declares `count` triangles unmet, each for the reason that it is given.
fn leave(refined: &mut RefinedMesh, count: usize, reason: impl Fn(usize) -> Reason) {
    refined.report.outcome = Outcome::BudgetExhausted;
    refined.report.unmet = (0..count)
        .map(|t| Unmet {
            triangle: TriangleId::new(t),
            broken: Broken {
                angle: t % 2 == 0,
                edge: true,
                area: false,
            },
            min_angle: Angle::degrees(45.0 - t as f64 / 100.0),
            reason: reason(t),
        })
        .collect();
}

fn options(name: &str) -> ReportOptions<'_> {
    ReportOptions {
        name,
        picture: PictureOptions {
            size: 400,
            ..PictureOptions::default()
        },
        ..ReportOptions::default()
    }
}

/// Writes a report in one format.
fn report(refined: &RefinedMesh, options: &ReportOptions<'_>, extension: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join(format!("page.{extension}"));
    let target = Target::from_arg(&file, None);
    let mesh = MeshView::from(refined.mesh.triangulation());
    let written = write_report(&[target], refined, &mesh, options, &()).expect("a report");
    assert_eq!(written, [file.as_path()]);
    std::fs::read(file).expect("written")
}

fn text(refined: &RefinedMesh, options: &ReportOptions<'_>, extension: &str) -> String {
    String::from_utf8(report(refined, options, extension)).expect("text")
}

/// What an XML parser finds in a page.
#[derive(Default)]
struct Parsed {
    /// How often each element occurs.
    elements: BTreeMap<String, usize>,
    /// All text outside of tags.
    text: String,
    /// Addresses of what the page would load.
    links: Vec<String>,
}

impl Parsed {
    fn count(&self, element: &str) -> usize {
        self.elements.get(element).copied().unwrap_or(0)
    }
}

fn parse(page: &str) -> Parsed {
    let mut reader = Reader::from_str(page);
    reader.config_mut().enable_all_checks(true);
    let mut parsed = Parsed::default();
    let mut depth = 0;
    loop {
        match reader.read_event().expect("well-formed") {
            Event::Eof => break,
            Event::End(_) => depth -= 1,
            Event::Text(text) => parsed.text.push_str(&text.decode().expect("text")),
            Event::GeneralRef(name) => {
                let name = format!("&{};", name.decode().expect("text"));
                let unescaped = quick_xml::escape::unescape(&name).expect("a known entity");
                parsed.text.push_str(&unescaped);
            }
            event @ (Event::Start(_) | Event::Empty(_)) => {
                depth += i32::from(matches!(event, Event::Start(_)));
                let (Event::Start(tag) | Event::Empty(tag)) = event else {
                    unreachable!()
                };
                let name = String::from_utf8_lossy(tag.name().as_ref()).into_owned();
                *parsed.elements.entry(name).or_default() += 1;
                for attribute in tag.attributes() {
                    let attribute = attribute.expect("well-formed");
                    let value = attribute.unescape_value().expect("escaped");
                    if [b"src".as_slice(), b"href"].contains(&attribute.key.as_ref()) {
                        parsed.links.push(value.into_owned());
                    }
                }
            }
            _ => {}
        }
    }
    assert_eq!(depth, 0, "every element is closed");
    parsed
}

fn assert_well_formed(page: &str) -> Parsed {
    for shape in page.split(" d=\"").skip(1) {
        let path = shape.split('"').next().unwrap_or_default();
        let is_drawn = |c: char| c.is_ascii_digit() || "MLCzlh .-".contains(c);
        assert!(path.chars().all(is_drawn), "{path}");
    }
    let parsed = parse(page);
    assert!(!parsed.text.contains("NaN"), "{}", parsed.text);
    let is_inside = |link: &String| link.starts_with('#') || link.starts_with("data:");
    assert!(parsed.links.iter().all(is_inside), "loads nothing");
    assert_eq!(parsed.count("script") + parsed.count("link"), 0);
    parsed
}

#[test]
fn the_page_says_what_was_asked_and_reached() {
    let details = [("hash", "0123".to_owned())];
    let options = ReportOptions {
        details: &details,
        ..options("grid.poly")
    };
    let page = assert_well_formed(&text(&grid(5), &options, "html"));
    for words in [
        "grid.poly",
        "Asked: no angle below 20° and no edge longer than 0.75.",
        "Complete: every triangle meets the bounds.",
        "at least 20°",
        "at most 0.75",
        "45°",
        "32",
        "hash",
        "0123",
    ] {
        assert!(page.text.contains(words), "{words} in {}", page.text);
    }
    assert_eq!(page.count("svg"), 5, "the mesh and four charts");
    assert!(!page.text.contains("Unmet triangles"), "there are none");
}

#[test]
fn names_are_escaped() {
    let name = "<script>alert('&amp;')</script> \"ü\" & co";
    let page = assert_well_formed(&text(&grid(3), &options(name), "html"));
    assert!(page.text.contains(name), "{}", page.text);
    let picture = assert_well_formed(&text(&grid(3), &options(name), "svg"));
    assert!(picture.text.contains(name), "{}", picture.text);
}

#[test]
fn unmet_triangles_are_grouped_and_the_worst_enlarged() {
    let mut refined = grid(6);
    leave(&mut refined, 50, |t| match t {
        0..3 => Reason::Stopped,
        _ => Reason::SmallInputAngle {
            vertex: VertexId::new(6),
            segments: [2, 11],
            angle: Angle::degrees(1.5),
        },
    });
    let options = ReportOptions {
        base: 1,
        ..options("corner.poly")
    };
    let page = assert_well_formed(&text(&refined, &options, "html"));
    for words in [
        "Stopped when the budget was used up",
        "50 triangles do not meet the bounds, 3 of them without excuse",
        "50, 47 excused",
        "The work stopped before their turn: 3 triangles",
        "Two segments of the input meet at a small angle: 47 triangles, excused",
        "the hull's edge from 3 to 4 and the hull's edge from 35 to 34 meet at vertex 7 at 1.5°",
        "edge 1.414 above 0.75",
        "… and 26 more triangles",
    ] {
        assert!(page.text.contains(words), "{words} in {}", page.text);
    }
    assert_eq!(page.count("figcaption"), 24);
    let stopped = page.text.matches("before its turn").count();
    assert_eq!(stopped, 0, "the headline says so already");
    let [first, second] = ["The work stopped", "Two segments"].map(|w| page.text.find(w));
    assert!(first < second, "without excuse first");
}

#[test]
fn excused_triangles_do_not_make_a_mesh_bad() {
    let mut refined = grid(3);
    leave(&mut refined, 1, |_| Reason::Precision);
    refined.report.outcome = Outcome::Complete;
    let page = text(&refined, &options("a"), "html");
    assert!(page.contains("class=\"outcome good\""));
    assert!(page.contains("1 triangle cannot meet the bounds, all others do"));
    leave(&mut refined, 1, |_| Reason::Gradation);
    let page = text(&refined, &options("a"), "html");
    assert!(page.contains("class=\"outcome bad\""));
}

#[test]
fn large_meshes_are_a_picture_of_pixels() {
    let page = text(&grid(110), &options("large"), "html");
    let parsed = assert_well_formed(&page);
    assert_eq!((parsed.count("img"), parsed.count("svg")), (1, 4));
    assert!(page.len() < 1_000_000, "{} bytes", page.len());
}

#[test]
fn every_mesh_has_a_report() {
    let huge = f64::MAX;
    let sets: [&[(f64, f64)]; 7] = [
        &[],
        &[(1.0, 2.0)],
        &[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)],
        &[(huge, huge), (-huge, huge), (0.0, -huge), (1e-300, 5e-324)],
        &[(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324)],
        &[(0.0, 0.0), (1e300, 1e-300), (1e-300, 1e300)],
        &[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1e12, -1e12)],
    ];
    for set in sets {
        let mut refined = mesh(set);
        let count = refined.mesh.triangulation().num_triangles();
        leave(&mut refined, count, |_| Reason::Precision);
        let page = assert_well_formed(&text(&refined, &options("set"), "html"));
        assert_eq!(page.count("figcaption"), count.min(24), "{set:?}");
        assert_well_formed(&text(&refined, &options("set"), "svg"));
        assert!(!report(&refined, &options("set"), "png").is_empty());
    }
}

/// Decodes a PNG to its size and its pixels.
fn decode(png: &[u8]) -> ([u32; 2], Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(png).read_info().expect("a picture");
    let mut bytes = vec![0; reader.output_buffer_size()];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    let pixels = bytes.as_chunks::<3>().0.to_vec();
    ([info.width, info.height], pixels)
}

/// Tells whether a pixel is of the red that marks bounds.
fn is_red([r, g, b]: [u8; 3]) -> bool {
    let [r, g, b] = [r, g, b].map(i32::from);
    r > 180 && r > g + 50 && r > b + 50
}

#[test]
fn the_picture_has_panels_with_the_bounds_marked() {
    let refined = grid(9);
    let ([width, height], pixels) = decode(&report(&refined, &options("grid"), "png"));
    assert!(
        width > 350 && height > 450,
        "{width} x {height}: picture and panels"
    );
    let red: Vec<u32> = (0..height)
        .filter(|y| (0..width).any(|x| is_red(pixels[(y * width + x) as usize])))
        .collect();
    assert!(red.len() > 40, "the bound of angles is a line: {red:?}");
    assert!(red[0] > height / 2, "below the mesh");
    let svg = text(&refined, &options("grid"), "svg");
    assert_well_formed(&svg);
    assert!(
        svg.contains("smallest angle: 45°."),
        "for those who cannot see it"
    );
}

#[test]
fn tall_pictures_have_their_panels_beside_them() {
    let refined = mesh(&[(0.0, 0.0), (1.0, 0.0), (0.0, 9.0), (1.0, 9.0)]);
    let ([width, height], _) = decode(&report(&refined, &options("tall"), "png"));
    assert!(width < height, "{width} x {height}");
    assert!(height < 480, "{height}: nothing below the picture");
}

struct Cancelled;

impl Watch for Cancelled {
    fn is_cancelled(&self) -> bool {
        true
    }
}

fn refused(file: &Path, refined: &RefinedMesh, mesh: &MeshView<'_>, watch: &dyn Watch) -> Error {
    let target = Target::from_arg(file, None);
    let outcome = write_report(&[target], refined, mesh, &options("a"), watch);
    assert!(!file.exists());
    outcome.expect_err("must be refused")
}

#[test]
fn what_cannot_be_reported_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("folder");
    let refined = grid(3);
    let mesh = MeshView::from(refined.mesh.triangulation());
    let at = |name: &str| folder.path().join(name);
    let unsupported = refused(&at("a.vtu"), &refined, &mesh, &()).to_string();
    assert!(
        unsupported.contains("vtu cannot hold a report"),
        "{unsupported}"
    );
    assert!(
        unsupported.ends_with("use one of svg, png, html"),
        "{unsupported}"
    );
    let unknown = refused(&at("a.doc"), &refined, &mesh, &()).to_string();
    assert!(unknown.ends_with("one of svg, png, html"), "{unknown}");
    let other = MeshView::new(mesh.points, &mesh.triangles[1..]);
    let mismatch = refused(&at("a.html"), &refined, &other, &());
    assert!(matches!(mismatch, Error::BadMesh(_)), "{mismatch}");
    for name in ["a.html", "a.svg", "a.png"] {
        let cancelled = refused(&at(name), &refined, &mesh, &Cancelled);
        assert!(matches!(cancelled, Error::Cancelled), "{cancelled}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0);
}
