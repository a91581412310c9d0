//! Programs of others read what is written here, and write what is read: meshio, numpy-stl, laspy, GDAL, LaTeX.
//!
//! Python is the one that `DELONE_PYTHON` names; whatever is absent is skipped, with a message.

mod peers;

use delone::{DomainRule, Point};
use delone_io::{
    Attribute, MeshView, PointSet, ReadOptions, Source, Target, WriteOptions, read_points,
    write_mesh,
};
use std::path::Path;
use std::process::Command;

/// Runs a script of Python that needs some modules; `None` if they are absent.
fn python(script: &str, modules: &[&str], folder: &Path) -> Option<String> {
    let mut python = peers::python(modules)?;
    let code = format!("import {}\n{script}", modules.join(", "));
    Some(peers::said(python.current_dir(folder).args(["-c", &code])))
}

/// Runs a program and returns what it prints; `None` if it is absent.
fn program(name: &str, arguments: &[&str], folder: &Path) -> Option<String> {
    let mut command = Command::new(name);
    command.args(arguments).current_dir(folder);
    let is_there = Command::new(name).arg("--version").output().is_ok();
    if !is_there {
        eprintln!("skipped: no {name}");
    }
    is_there.then(|| peers::said(&mut command))
}

/// A hill over 400 places, its triangles and a square of segments.
fn hill() -> (Vec<Point>, Vec<Attribute>) {
    let points: Vec<_> = (0..400)
        .map(|i| {
            Point::new(
                f64::from(i % 20) + 0.01 * f64::from(i * i % 7),
                f64::from(i / 20),
            )
        })
        .collect();
    let height = |p: &Point| (0.3 * p.x).sin() + 0.1 * p.y;
    let z = Attribute {
        name: "z".to_owned(),
        values: points.iter().map(height).collect(),
    };
    (points, vec![z])
}

fn write_hill(path: &Path, options: &WriteOptions, quadratic: bool) -> usize {
    let (points, attributes) = hill();
    let set = PointSet {
        points: points.clone(),
        attributes,
        ..PointSet::default()
    };
    let graph = delone::Pslg {
        segments: [[0, 19], [19, 399], [399, 380], [380, 0]]
            .map(|s: [u32; 2]| s.map(delone::VertexId::from))
            .to_vec(),
        ..delone::Pslg::from_points(points)
    };
    let mut domain = delone_io::DomainData::from(graph);
    domain.vertices.attributes = set.attributes;
    let builder = delone::ConstrainedDelaunay::new().domain(DomainRule::Hull);
    let result = builder.triangulate(domain.take_pslg()).expect("a domain");
    let inherited = delone_io::Inherited::new(&result, domain, &()).expect("inherited");
    let mesh = MeshView::constrained(&result, &inherited);
    let mesh = if quadratic { mesh.quadratic() } else { mesh };
    write_mesh(&[Target::from_arg(path, None)], &mesh, options, &()).expect("written");
    mesh.triangles.len()
}

#[test]
fn meshio_reads_medit() {
    let folder = tempfile::tempdir().expect("folder");
    let count = write_hill(
        &folder.path().join("m.mesh"),
        &WriteOptions::default(),
        false,
    );
    let script = "m = meshio.read('m.mesh')\n\
         t, e = m.cells_dict['triangle'], m.cells_dict['line']\n\
         a, b, c = (m.points[t[:, k], :2] for k in range(3))\n\
         u, v = b - a, c - a\n\
         area = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]).sum() / 2\n\
         marked = m.cell_data_dict['medit:ref']['line']\n\
         print(len(t), len(e), marked.max(), area)";
    let Some(found) = python(script, &["meshio"], folder.path()) else {
        return;
    };
    let numbers: Vec<f64> = found
        .split_whitespace()
        .map(|w| w.parse().expect("number"))
        .collect();
    assert_eq!(numbers[0], count as f64);
    assert!(numbers[1] >= 4.0 && numbers[2] == 1.0, "{found}");
    assert!(numbers[3] > 350.0 && numbers[3] < 370.0, "{found}");
}

/// meshio does not know elements of six nodes in this format; Gmsh does.
#[test]
fn gmsh_reads_medit_of_six_nodes() {
    let folder = tempfile::tempdir().expect("folder");
    let count = write_hill(
        &folder.path().join("m.mesh"),
        &WriteOptions::default(),
        true,
    );
    let script = "import numpy as np\n\
         gmsh.initialize()\n\
         gmsh.option.setNumber('General.Terminal', 0)\n\
         gmsh.open('m.mesh')\n\
         tags, places, _ = gmsh.model.mesh.getNodes()\n\
         place = dict(zip(tags.tolist(), places.reshape(-1, 3)))\n\
         found = {}\n\
         for kind, nodes in [(9, 6), (8, 3)]:\n\
         \x20   _, cells = gmsh.model.mesh.getElementsByType(kind)\n\
         \x20   cells = cells.reshape(-1, nodes)\n\
         \x20   found[kind] = len(cells)\n\
         \x20   corners = nodes // 2 if nodes == 6 else 2\n\
         \x20   for cell in cells.tolist():\n\
         \x20       p = [place[v] for v in cell]\n\
         \x20       for k in range(nodes - corners):\n\
         \x20           assert np.allclose(p[corners + k], (p[k] + p[(k + 1) % corners]) / 2)\n\
         print(found[9], found[8])";
    let Some(found) = python(script, &["gmsh"], folder.path()) else {
        return;
    };
    let (triangles, lines) = found.trim().split_once(' ').expect("two numbers");
    assert_eq!(triangles, count.to_string());
    assert!(lines.parse::<usize>().expect("lines") >= 4, "{found}");
}

#[test]
fn meshio_and_numpy_read_stl() {
    let folder = tempfile::tempdir().expect("folder");
    for ascii in [false, true] {
        let options = WriteOptions {
            ascii,
            ..WriteOptions::default()
        };
        let count = write_hill(&folder.path().join("s.stl"), &options, false);
        let script = "import numpy as np\n\
             m = meshio.read('s.stl')\n\
             s = stl.mesh.Mesh.from_file('s.stl', calculate_normals=False)\n\
             n = s.normals.copy()\n\
             s.update_normals()\n\
             length = np.linalg.norm(s.normals, axis=1)[:, None]\n\
             assert np.abs(n * length - s.normals).max() < 1e-5\n\
             assert (n[:, 2] > 0).all()\n\
             print(len(m.cells_dict['triangle']), len(s.vectors), len(m.points))";
        let Some(found) = python(script, &["meshio", "stl.mesh"], folder.path()) else {
            return;
        };
        assert_eq!(found.trim(), format!("{count} {count} 400"));
    }
}

#[cfg(feature = "las")]
#[test]
fn clouds_of_laspy_have_exact_coordinates() {
    let folder = tempfile::tempdir().expect("folder");
    let script = "import numpy as np\n\
        from decimal import Decimal\n\
        from fractions import Fraction\n\
        rng = np.random.default_rng(3)\n\
        n = 60000\n\
        for i, (fmt, version, scales, offsets) in enumerate([\n\
        \x20   (0, '1.2', [0.01, 0.001, 0.01], [500000, 5400000, 0]),\n\
        \x20   (3, '1.2', [1e-7, 2.5e-7, 0.1], [-94.66, 31.03, 1e-9]),\n\
        \x20   (6, '1.4', [0.00123456789, 1/3, 1.0], [340280.12345678901, 0.1 + 0.2, -17.5]),\n\
        \x20   (8, '1.4', [100.0, 0.01, 0.01], [0, 123456.789, 1e6])]):\n\
        \x20   h = laspy.LasHeader(point_format=fmt, version=version)\n\
        \x20   h.scales, h.offsets = scales, offsets\n\
        \x20   c = laspy.LasData(h)\n\
        \x20   c.points = laspy.ScaleAwarePointRecord.zeros(n, header=h)\n\
        \x20   raw = rng.integers(-2**31, 2**31, (n, 3)) >> rng.integers(0, 31, (n, 1))\n\
        \x20   c.X, c.Y, c.Z = raw.astype(np.int32).T\n\
        \x20   c.classification = rng.integers(0, 20, n)\n\
        \x20   c.write(f'c{i}.las')\n\
        \x20   c.write(f'c{i}.laz')\n\
        \x20   s = [Fraction(Decimal(repr(float(v)))) for v in scales]\n\
        \x20   o = [Fraction(Decimal(repr(float(v)))) for v in offsets]\n\
        \x20   with open(f'c{i}.csv', 'w') as f:\n\
        \x20       f.write('x,y,z,classification\\n')\n\
        \x20       for r, k in zip(raw[:, :].tolist(), c.classification):\n\
        \x20           f.write(','.join(repr(float(r[j] * s[j] + o[j])) for j in range(3)) + f',{k}\\n')";
    if python(script, &["laspy", "lazrs"], folder.path()).is_none() {
        return;
    }
    for i in 0..4 {
        let read = |extension: &str| {
            let path = folder.path().join(format!("c{i}.{extension}"));
            let set = read_points(&Source::from_arg(path), &ReadOptions::default(), &());
            set.unwrap_or_else(|error| panic!("{error}"))
        };
        let [las, laz, csv] = ["las", "laz", "csv"].map(read);
        assert_eq!(las, laz, "{i}");
        assert!(
            las.points == csv.points && las.attributes == csv.attributes,
            "{i}"
        );
    }
}

#[test]
fn gdal_agrees_about_grids() {
    let folder = tempfile::tempdir().expect("folder");
    let grid = "ncols 4\nnrows 3\nxllcorner 500000.5\nyllcorner 17.25\ncellsize 0.5\nNODATA_value -1\n\
                1 2 3 4\n5 -1 7 8\n9 10 11 12.5\n";
    std::fs::write(folder.path().join("g.asc"), grid).expect("written");
    let arguments = ["-q", "-of", "XYZ", "g.asc", "g.xyz"];
    if program("gdal_translate", &arguments, folder.path()).is_none() {
        return;
    }
    let read = |name: &str| {
        let source = Source::from_arg(folder.path().join(name));
        read_points(&source, &ReadOptions::default(), &()).expect("read")
    };
    let (ours, theirs) = (read("g.asc"), read("g.xyz"));
    // GDAL writes cells without value, too.
    let theirs = theirs.points.iter().zip(&theirs.attributes[0].values);
    let theirs: Vec<_> = theirs.filter(|(_, z)| **z != -1.0).collect();
    let found: Vec<_> = ours.points.iter().zip(&ours.attributes[0].values).collect();
    assert_eq!(found.len(), 11);
    assert_eq!(found, theirs);
}

#[test]
fn latex_draws() {
    let folder = tempfile::tempdir().expect("folder");
    write_hill(
        &folder.path().join("hill.tikz"),
        &WriteOptions::default(),
        false,
    );
    let document = "\\documentclass{article}\n\\usepackage{tikz}\n\\begin{document}\n\\input{hill.tikz}\n\\end{document}\n";
    std::fs::write(folder.path().join("page.tex"), document).expect("written");
    let arguments = ["-interaction=nonstopmode", "-halt-on-error", "page.tex"];
    let Some(log) = program("pdflatex", &arguments, folder.path()) else {
        return;
    };
    assert!(log.contains("Output written on page.pdf"), "{log}");
}
