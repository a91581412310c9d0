//! Other programs on the same drawings and pictures: ezdxf, svgelements and GDAL, as far as they are there.
//!
//! The curves of a file, sampled finely by a peer, and our polylines lie within the flatness of one another.

mod peers;

use delone_io::{
    Constraints, DomainData, MeshView, ReadOptions, Source, Target, WriteOptions, read_domain,
    write_mesh,
};
use std::path::{Path, PathBuf};
use std::process::Command;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/cad")
        .join(name)
}

/// Runs a script of Python, if there are Python and the module; returns what it prints.
fn python(module: &str, script: &str, file: &Path) -> Option<String> {
    let mut python = peers::python(&[module])?;
    Some(peers::said(python.arg("-c").arg(script).arg(file)))
}

/// Prints a line for each curve of a drawing: x and y of many points along it.
const EZDXF: &str = "
import sys, ezdxf
from ezdxf import disassemble
def curve(e):
    kind = e.dxftype()
    if kind in ('LWPOLYLINE', 'POLYLINE'):
        return [p for part in e.virtual_entities() for p in curve(part)]
    if kind == 'LINE':
        return [[e.dxf.start, e.dxf.end]]
    if kind in ('3DFACE', 'SOLID'):
        corners = e.wcs_vertices()
        return [corners + corners[:1]]
    if kind == 'SPLINE':
        # Its own flattening goes beyond the domain of splines that are not clamped.
        spline, d = e.construction_tool(), e.dxf.degree
        low, high = e.knots[d], e.knots[-d - 1]
        return [list(spline.points([low + (high - low) * i / 5000 for i in range(5001)]))]
    return [list(e.flattening(1e-6))] if hasattr(e, 'flattening') else []
doc = ezdxf.readfile(sys.argv[1])
for e in disassemble.recursive_decompose(doc.modelspace()):
    for points in curve(e):
        print(*[repr(float(c)) for v in points for c in (v.x, v.y)])
";

/// The same for a picture, upright. Points are mapped here, as svgelements maps arcs by sheared axes.
const SVGELEMENTS: &str = "
import sys, svgelements as se
for e in se.SVG.parse(sys.argv[1], reify=False).elements():
    if isinstance(e, se.Shape):
        for sub in se.Path(e.d(transformed=False)).as_subpaths():
            points = []
            for s in se.Path(sub).segments():
                n = 2 if isinstance(s, (se.Line, se.Close)) else 1 if isinstance(s, se.Move) else 2000
                points += [s.end] if n == 1 else [s.point(i / (n - 1)) for i in range(n)]
            points = [e.transform.point_in_matrix_space(p) for p in points if p is not None]
            print(*[c for p in points for c in (repr(float(p.x)), repr(-float(p.y)))])
";

type Line = Vec<[f64; 2]>;

fn lines(text: &str) -> Vec<Line> {
    let line = |line: &str| {
        let numbers: Vec<f64> = line
            .split_whitespace()
            .map(|w| w.parse().unwrap())
            .collect();
        numbers.chunks_exact(2).map(|p| [p[0], p[1]]).collect()
    };
    text.lines().filter(|l| !l.is_empty()).map(line).collect()
}

fn ours(domain: &DomainData) -> Vec<Line> {
    let place = |v: delone::VertexId| {
        let p = domain.vertices.points[v.index()];
        [p.x, p.y]
    };
    domain
        .segments
        .iter()
        .map(|ends| ends.map(place).to_vec())
        .collect()
}

/// The largest distance of points along some lines, ends and middles, from the others, and where it is.
fn farthest(from: &[Line], to: &[Line]) -> (f64, [f64; 2]) {
    let distance = |p: [f64; 2]| {
        let to_segment = |s: &[[f64; 2]]| {
            let d = [s[1][0] - s[0][0], s[1][1] - s[0][1]];
            let square = (d[0] * d[0] + d[1] * d[1]).max(1e-300);
            let along = ((p[0] - s[0][0]) * d[0] + (p[1] - s[0][1]) * d[1]) / square;
            let along = along.clamp(0.0, 1.0);
            (p[0] - s[0][0] - along * d[0]).hypot(p[1] - s[0][1] - along * d[1])
        };
        let segments = to.iter().flat_map(|line| line.windows(2));
        segments.map(to_segment).fold(f64::INFINITY, f64::min)
    };
    let middles = from.iter().flat_map(|line| line.windows(2));
    let middles = middles.map(|s| [0, 1].map(|k| 0.5 * (s[0][k] + s[1][k])));
    let ends = from.iter().flatten().copied();
    let all = ends.chain(middles).map(|p| (distance(p), p));
    all.max_by(|a, b| a.0.total_cmp(&b.0)).expect("some points")
}

#[track_caller]
fn agree(name: &str, module: &str, script: &str, at_least: usize) {
    let path = data(name);
    let Some(said) = python(module, script, &path) else {
        return;
    };
    let theirs = lines(&said);
    assert!(theirs.len() >= at_least, "{} curves", theirs.len());
    for flatness in [0.1, 1e-3] {
        let options = ReadOptions {
            flatness: Some(flatness),
            ..ReadOptions::default()
        };
        let domain = read_domain(&Source::Path(path.clone()), &options, &()).unwrap();
        let ours = ours(&domain);
        let bound = flatness + 2e-5;
        let ((there, at), (back, from)) = (farthest(&theirs, &ours), farthest(&ours, &theirs));
        assert!(
            there <= bound,
            "{name}: {there} from theirs to ours at {at:?}"
        );
        assert!(
            back <= bound,
            "{name}: {back} from ours to theirs at {from:?}"
        );
        assert!(
            there.max(back) > 0.02 * flatness,
            "{name}: far finer than asked"
        );
    }
}

#[test]
fn ezdxf_draws_the_same_curves() {
    agree("curves.dxf", "ezdxf", EZDXF, 10);
}

#[test]
fn ezdxf_inserts_the_same_blocks() {
    agree("plate-r12.dxf", "ezdxf", EZDXF, 6);
    agree("plate-binary.dxf", "ezdxf", EZDXF, 6);
}

#[test]
fn svgelements_draws_the_same_shapes() {
    agree("shapes.svg", "svgelements", SVGELEMENTS, 11);
}

/// Writes a mesh with constrained edges, heights and a loose point.
fn written(folder: &Path) -> PathBuf {
    let points = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 3.0],
        [0.0, 3.0],
        [1.0 / 3.0, 1.0],
    ];
    let triangulation = delone::triangulate(points).unwrap();
    let mut all: Vec<_> = points.map(delone::Point::from).to_vec();
    all.push([9.0, 1e-7].into());
    let edges = vec![[0, 1], [1, 2]]
        .into_iter()
        .map(|e: [usize; 2]| e.map(delone::VertexId::new));
    let constraints = Constraints {
        edges: edges.collect(),
        markers: Some(vec![1, 7]),
        ..Constraints::default()
    };
    let triangles = triangulation.triangles().to_vec();
    let mesh = MeshView::new(&all, &triangles).with_constraints(&constraints);
    let path = folder.join("mesh.dxf");
    let target = Target::from_arg(&path, None);
    write_mesh(&[target], &mesh, &WriteOptions::default(), &()).unwrap();
    path
}

const AUDIT: &str = "
import sys, ezdxf, collections
doc = ezdxf.readfile(sys.argv[1])
print(len(doc.audit().errors), len(doc.audit().fixes), doc.acad_release)
kinds = collections.Counter((e.dxftype(), e.dxf.layer) for e in doc.modelspace())
for (kind, layer), n in sorted(kinds.items()):
    print(kind, layer, n, layer in doc.layers)
face = doc.modelspace().query('3DFACE')
print(min(v.x for f in face for v in f.wcs_vertices() if v.x > 0) == 1 / 3)
";

#[test]
fn ezdxf_finds_no_fault_in_ours() {
    let folder = tempfile::tempdir().unwrap();
    let Some(said) = python("ezdxf", AUDIT, &written(folder.path())) else {
        return;
    };
    let expected = "0 0 R12\n3DFACE TRIANGLES 4 True\nLINE SEGMENTS_1 1 True\nLINE SEGMENTS_7 1 True\n\
                    POINT POINTS 1 True\nTrue\n";
    assert_eq!(said, expected);
}

#[test]
fn gdal_reads_ours() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path());
    let output = Command::new("ogrinfo")
        .args(["-ro", "-al"])
        .arg(&path)
        .output();
    let Ok(output) = output else {
        eprintln!("skipped: no ogrinfo of GDAL");
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let count = |text: &str| said.matches(text).count();
    assert_eq!(count("POLYGON "), 4, "{said}");
    assert_eq!(count("LINESTRING "), 2, "{said}");
    assert_eq!(count("  POINT Z"), 1, "{said}");
    assert_eq!(count("Layer (String) = SEGMENTS_7"), 1);
}
