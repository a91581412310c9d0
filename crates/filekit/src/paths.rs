//! The ways of the commands: what is read, built, proven, written and read again.
//!
//! The first two bytes choose; the rest is a file of one of a few formats.

use crate::readers::{check_domain, check_mesh, check_points, memory};
use delone::check::{Verdict, verify};
use delone::doctor::Doctor;
use delone::{
    Angle, Budget, ConstrainedDelaunay, DomainRule, Point, Pslg, Quality, Refinement,
    SegmentPolicy, VertexId,
};
use delone_io::{
    DomainData, Error, Format, Inherited, MemoryFile, MeshData, MeshView, PictureOptions, PointSet,
    ReadOptions, Source, Target, WriteOptions, in_memory, read_domain, read_mesh, read_points,
    write_domain, write_mesh, write_points,
};
use std::collections::BTreeSet;
use std::sync::Arc;

/// More points than that are left alone: the next case is more worth than this one.
const MOST: usize = 2000;

/// Takes the choices off.
fn chosen(bytes: &[u8]) -> Option<([usize; 2], &[u8])> {
    let (choices, rest) = bytes.split_first_chunk::<2>()?;
    Some((choices.map(usize::from), rest))
}

/// Makes a file of the format that the content seems to have, if it is among these; else of the first.
fn file(formats: &[Format], bytes: &[u8]) -> (Source, Format) {
    let found = Format::detect(None, bytes).filter(|format| formats.contains(format));
    let format = found.unwrap_or(formats[0]);
    (memory(&format!("f.{format}"), bytes), format)
}

/// What points and domains are made of here; a `.poly` whose points are broken looks like a `.node`.
const OF_POINTS: &[Format] = &[Format::Table, Format::Node, Format::Npy];
const OF_DOMAINS: &[Format] = &[Format::Poly, Format::GeoJson, Format::Wkt, Format::Off];

/// Says what small pictures are: they are not looked at.
fn writing() -> WriteOptions {
    WriteOptions {
        picture: PictureOptions {
            size: 16,
            ..PictureOptions::default()
        },
        ..WriteOptions::default()
    }
}

fn points_of(bytes: &[u8]) -> Option<PointSet> {
    let set = read_points(&file(OF_POINTS, bytes).0, &ReadOptions::default(), &()).ok()?;
    (set.points.len() <= MOST).then_some(set)
}

fn domain_of(bytes: &[u8]) -> Option<DomainData> {
    let (source, format) = file(OF_DOMAINS, bytes);
    let domain = match format {
        Format::Off => border(read_mesh(&source, &ReadOptions::default(), &()).ok()?),
        _ => read_domain(&source, &ReadOptions::default(), &()).ok()?,
    };
    let size = domain.vertices.points.len().max(domain.segments.len());
    // As many crossings are possible as there are pairs.
    (size <= MOST / 10).then_some(domain)
}

/// Makes a domain of what the triangles of a mesh cover.
fn border(mesh: MeshData) -> DomainData {
    let sides = |&[a, b, c]: &[VertexId; 3]| [[a, b], [b, c], [c, a]];
    let sides = mesh.triangles.iter().flat_map(sides);
    let mut edges: Vec<_> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    let same = edges.chunk_by(|a, b| a == b);
    let odd = same.filter(|same| same.len() % 2 == 1);
    DomainData {
        segments: odd.map(|same| same[0]).collect(),
        usual_rule: DomainRule::EvenOdd,
        ..DomainData::from(mesh.vertices)
    }
}

/// Points become a mesh that is proven right, written in a format and read back.
pub fn points(bytes: &[u8]) {
    let Some(([_, target], rest)) = chosen(bytes) else {
        return;
    };
    let Some(set) = points_of(rest) else {
        return;
    };
    let Ok(built) = delone::triangulate(set.points.iter().copied()) else {
        return;
    };
    let verdict = verify(&set.points, built.triangles(), &()).expect("finite points");
    assert!(matches!(verdict, Verdict::Right(_)), "{verdict:?}");
    write_everywhere(&MeshView::from(&built).with_data(&set), target);
}

/// A domain becomes a mesh that inherits its markers, is written in a format and read back.
pub fn domain(bytes: &[u8]) {
    let Some(([_, target], rest)) = chosen(bytes) else {
        return;
    };
    let Some(mut domain) = domain_of(rest) else {
        return;
    };
    let rule = domain.usual_rule;
    let built = ConstrainedDelaunay::new()
        .domain(rule)
        .crossings(policy(target))
        .triangulate(domain.take_pslg());
    let Ok(built) = built else {
        return;
    };
    let inherited = Inherited::new(&built, domain, &()).expect("of its own domain");
    write_everywhere(&MeshView::constrained(&built, &inherited), target);
}

fn policy(choice: usize) -> SegmentPolicy {
    match choice & 0x80 {
        0 => SegmentPolicy::Split,
        _ => SegmentPolicy::default(),
    }
}

/// A drawing is examined and repaired; what is settled can be triangulated.
pub fn doctor(bytes: &[u8]) {
    let Some(([_, choice], rest)) = chosen(bytes) else {
        return;
    };
    let Some(mut domain) = domain_of(rest) else {
        return;
    };
    let doctor = Doctor::new()
        .domain(domain.usual_rule)
        .tolerance([0.0, 1e-9, 0.01, 0.5][choice % 4]);
    let rule = domain.usual_rule;
    let pslg = domain.take_pslg();
    let _ = doctor.examine(&pslg);
    if let Ok(repair) = doctor.repair(&pslg) {
        let facts = repair.pslg.facts(10, &());
        assert!(facts.is_ok() || !repair.is_settled, "{facts:?}");
        let _ = triangulated(repair.pslg, rule);
    }
}

fn triangulated(pslg: Pslg, rule: DomainRule) -> Result<(), delone::Error> {
    ConstrainedDelaunay::new().domain(rule).triangulate(pslg)?;
    Ok(())
}

/// A domain, or what a mesh covers, is refined within a budget.
pub fn refine(bytes: &[u8]) {
    let Some(([_, choice], rest)) = chosen(bytes) else {
        return;
    };
    let Some(mut domain) = domain_of(rest) else {
        return;
    };
    let quality = Quality {
        min_angle: Some(Angle::degrees([20.0, 30.0, 0.0, 33.0][choice % 4])),
        max_edge: [None, Some(0.1)][choice / 4 % 2],
        max_area: [None, Some(1e-3)][choice / 8 % 2],
        region_areas: true,
    };
    let budget = Budget {
        vertices: Some(domain.vertices.points.len() + 300),
        time: None,
    };
    let refined = Refinement::new(quality)
        .budget(budget)
        .domain(domain.usual_rule)
        .crossings(policy(choice))
        .mesh(domain.take_pslg());
    if let Ok(refined) = refined {
        let _ = refined.statistics();
        let inherited = Inherited::new(&refined.mesh, domain, &()).expect("of its own domain");
        let view = MeshView::constrained(&refined.mesh, &inherited);
        write_everywhere(&view, choice);
    }
}

/// Points are asked about each other.
pub fn queries(bytes: &[u8]) {
    let Some(([_, choice], rest)) = chosen(bytes) else {
        return;
    };
    let Some(set) = points_of(rest) else {
        return;
    };
    let Ok(built) = delone::triangulate(set.points.iter().copied()) else {
        return;
    };
    let asked = set
        .points
        .get(choice)
        .copied()
        .unwrap_or(Point::new(0.5, 0.5));
    let locator = delone::locate::Locator::new(&built);
    let place = locator.locate(asked).expect("finite");
    assert!(
        set.points.len() <= choice
            || place.triangle(&built).is_some()
            || built.num_triangles() == 0
    );
    let index = delone::nearest::Nearest::new(&built, &()).expect("not cancelled");
    let nearest = index.nearest(asked).expect("finite");
    if let (Some(found), true) = (nearest, choice < set.points.len()) {
        assert_eq!(built.point(found), asked, "a point is nearest to itself");
    }
    let _ = index.k_nearest(asked, choice % 9);
    if let Ok(voronoi) = delone::voronoi::Voronoi::new(&built, &()) {
        let corners = voronoi.cells().flat_map(|cell| cell.corners());
        corners.for_each(|p| assert!(!p.x.is_nan() && !p.y.is_nan()));
    }
}

/// A file of any format is written in any other, as `delone convert` does it.
pub fn convert(bytes: &[u8]) {
    let Some(([_, target], rest)) = chosen(bytes) else {
        return;
    };
    let Some(format) = Format::detect(None, rest) else {
        return;
    };
    let source = memory(&format!("f.{format}"), rest);
    let options = ReadOptions::default();
    if format.reads_mesh()
        && let Ok(mesh) = read_mesh(&source, &options, &())
        && !mesh.triangles.is_empty()
    {
        check_mesh(&mesh);
        if mesh.vertices.points.len() <= MOST {
            write_everywhere(&MeshView::from(&mesh), target);
        }
    } else if format.reads_segments()
        && let Ok(domain) = read_domain(&source, &options, &())
        && !domain.segments.is_empty()
    {
        check_domain(&domain);
        if domain.vertices.points.len() <= MOST {
            write_domain_to(&domain, format_of(target, Format::writes_segments));
        }
    } else if let Ok(points) = read_points(&source, &options, &()) {
        check_points(&points);
        if points.points.len() <= MOST {
            write_points_to(&points, format_of(target, Format::writes_points));
        }
    }
}

/// Chooses among the formats that can do something.
fn format_of(choice: usize, can: fn(Format) -> bool) -> Format {
    let formats: Vec<_> = Format::ALL.into_iter().filter(|&f| can(f)).collect();
    formats[choice % formats.len()]
}

/// Writes into memory; what is refused is refused with a reason.
fn written(
    format: Format,
    write: impl FnOnce(&[Target], &WriteOptions) -> Result<Vec<std::path::PathBuf>, Error>,
) -> Option<Source> {
    let name = format!("f.{format}");
    let targets = [Target::from_arg(&name, Some(format))];
    let (_, files): (_, Vec<MemoryFile>) = in_memory(|| write(&targets, &writing())).ok()?;
    let opened = files.iter().position(|f| f.name.as_os_str() == &*name)?;
    let files = Arc::from(files);
    Some(Source::Together { files, opened })
}

fn write_everywhere(mesh: &MeshView<'_>, choice: usize) {
    let format = format_of(choice, Format::writes_mesh);
    let source = written(format, |targets, options| {
        write_mesh(targets, mesh, options, &())
    });
    let (Some(source), true) = (source, format.reads_mesh()) else {
        return;
    };
    if mesh.triangles.is_empty() {
        return;
    }
    let read = read_mesh(&source, &ReadOptions::default(), &());
    let read = read.unwrap_or_else(|error| panic!("{format} was written and is refused: {error}"));
    check_mesh(&read);
    let least = match format {
        // A triangle that belongs to several groups is there several times, and is one.
        Format::Msh | Format::Msh2 => distinct(mesh.triangles),
        _ => mesh.triangles.len(),
    };
    let found = read.triangles.len();
    assert!(
        (least..=mesh.triangles.len()).contains(&found),
        "{format}: {} triangles became {found}",
        mesh.triangles.len()
    );
    assert_same(format, mesh.points, &read.vertices.points);
}

/// Counts triangles, those of the same three corners once.
fn distinct(triangles: &[[VertexId; 3]]) -> usize {
    let sorted = triangles.iter().map(|&corners| {
        let mut corners = corners;
        corners.sort_unstable();
        corners
    });
    sorted.collect::<BTreeSet<_>>().len()
}

fn write_domain_to(domain: &DomainData, format: Format) {
    let write =
        |targets: &[Target], options: &WriteOptions| write_domain(targets, domain, options, &());
    let (Some(source), true) = (written(format, write), format.reads_segments()) else {
        return;
    };
    let read = read_domain(&source, &ReadOptions::default(), &());
    let read = read.unwrap_or_else(|error| panic!("{format} was written and is refused: {error}"));
    check_domain(&read);
    assert_same(format, &domain.vertices.points, &read.vertices.points);
}

fn write_points_to(points: &PointSet, format: Format) {
    let write =
        |targets: &[Target], options: &WriteOptions| write_points(targets, points, options, &());
    let (Some(source), true) = (written(format, write), format.reads_points()) else {
        return;
    };
    // Files without points are refused, and pictures have none.
    if points.points.is_empty() || format.is_picture() {
        return;
    }
    let read = read_points(&source, &ReadOptions::default(), &());
    let read = read.unwrap_or_else(|error| panic!("{format} was written and is refused: {error}"));
    check_points(&read);
    assert_same(format, &points.points, &read.points);
}

/// Compares the places: what is read was written, bit for bit, but for the sign of zero.
fn assert_same(format: Format, written: &[Point], read: &[Point]) {
    if !format
        .keeps()
        .is_some_and(|keeps| keeps.coordinates.is_exact())
    {
        return;
    }
    let places = |points: &[Point]| -> BTreeSet<[u64; 2]> {
        let place = |p: &Point| [p.x + 0.0, p.y + 0.0].map(f64::to_bits);
        points.iter().map(place).collect()
    };
    let (written, read) = (places(written), places(read));
    // Drawings of triangles or segments do not hold points that nothing touches.
    let is_fine = match format {
        Format::GeoJson | Format::Dxf | Format::Poly => read.is_subset(&written),
        _ => read == written,
    };
    assert!(
        is_fine,
        "{format}: {} places became {}",
        written.len(),
        read.len()
    );
}
