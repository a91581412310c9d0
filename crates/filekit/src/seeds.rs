//! Files that are right, to be broken: the fixtures of the readers, and small ones of every kind written here.

use crate::Body;
use crate::readers::{joined, memory};
use delone_io::{
    Attribute, Constraints, Lineage, MeshView, Papers, PointSet, Recording, Target, WriteOptions,
    in_memory, write_certified, write_log, write_mesh, write_points,
};
use std::fs;
use std::path::{Path, PathBuf};

/// Larger files only cost time.
const LARGEST: u64 = 20_000;

/// A file that is right.
#[derive(Clone, Debug)]
pub struct Seed {
    /// Its extension, which says what it is fed to.
    pub kind: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl Seed {
    fn new(kind: &str, bytes: impl Into<Vec<u8>>) -> Self {
        Self {
            kind: kind.to_owned(),
            bytes: bytes.into(),
        }
    }
}

/// Files too small to be kept as such.
const SMALL: &[(&str, &str)] = &[
    ("node", "# c\n3 2 1 1\n1 0 0 .5 1\n2 1 0 .5 0\n3 0 1 .5 1\n"),
    (
        "poly",
        "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 6\n3 3 4 0\n4 4 1 0\n1\n1 .1 .1\n2\n1 .2 .2 3 4\n2 .3 .3 4\n",
    ),
    ("poly", "0 2 0 0\n2 1\n0 0 1 5\n1 1 2 6\n0\n"),
    (
        "csv",
        "x,y,name,z\n1,2,\"a \"\"b\"\", c\",3\n4,5,d,\n0,1,e,7\n",
    ),
    ("csv", "x;y\n1,5;2,5\n2,5;2\n3;1\n"),
    ("xyz", "1 2\t3 # c\r\n4 5 6\r\n0 0 1\r\n"),
    ("tsv", "x\ty\n1\t2\n3\t5\n"),
    (
        "asc",
        "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 5\nNODATA_value -9999\n1 2 3\n4 -9999 6\n",
    ),
    (
        "geojson",
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"marker\":3},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[0,1,7],[0,0]]]}}]}",
    ),
    ("json", "[[0,0],[4,0],[4,4],[0,4]]"),
    ("json", "[[[0,0],[4,0],[4,4]],[[1,1],[2,1],[1,2]]]"),
    (
        "wkt",
        "SRID=4;POLYGON Z((0 0 1,1 0 1,0 1 1,0 0 1));MULTIPOINT(1 2,(3 4)) LINESTRING M EMPTY",
    ),
    (
        "wkt",
        "GEOMETRYCOLLECTION (POINT (1 2), LINESTRING (0 0, 1 1, 2 0), POLYGON ((0 0, 9 0, 9 9, 0 0), (5 2, 6 3, 5 3, 5 2)))",
    ),
    (
        "wkt",
        "010300000001000000040000000000000000000000000000000000000000000000000000400000000000000000000000000000004000000000000000400000000000000000000000000000000000000000",
    ),
    (
        "jigsaw",
        "# c\nMSHID=3;EUCLIDEAN-MESH\nNDIMS=2\nPOINT=3\n0;0;0\n1;0;0\n0;1;0\nEDGE2=3\n0;1;1\n1;2;2\n2;0;3\nTRIA3=1\n0;1;2;0\n",
    ),
    (
        "dat",
        "NACA\n1.0 0.0\n0.5 0.05\n0.0 0.0\n0.5 -0.05\n1.0 0.0\n",
    ),
    (
        "mesh",
        "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 1\n1 0 2\n0 1 3\nEdges\n1\n1 2 4\nTriangles\n1\n1 2 3 5\nEnd\n",
    ),
    (
        "obj",
        "# c\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a\nf 1/1/1 2//2 3 4\nl 1 3\np 2\n",
    ),
    (
        "off",
        "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3 255 0 0\n",
    ),
    (
        "svg",
        "<svg viewBox=\"0 0 9 9\"><g transform=\"rotate(30) scale(2,3)\"><path d=\"M0 0 L5 0 Q6 3 5 5 C1 2 3 4 0 5 A2 3 30 1 0 0 0 Z\"/><rect x=\"1\" y=\"1\" width=\"2\" height=\"3\" rx=\"1\"/><circle cx=\"4\" cy=\"4\" r=\"1\"/></g><use href=\"#a\"/><polygon id=\"a\" points=\"0,0 1,0 0,1\"/></svg>",
    ),
    (
        "dxf",
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\na\n10\n0\n20\n0\n11\n1\n21\n0\n0\nCIRCLE\n8\nb\n10\n5\n20\n5\n40\n2\n0\nENDSEC\n0\nEOF\n",
    ),
    ("area", "3\n1 0.5\n2 -1\n3 2\n"),
    (
        "vtk",
        "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS h double 1\nLOOKUP_TABLE default\n1 2 3\n",
    ),
];

/// Collects all seeds: those of this file, fixtures of the readers, and the small files of other `folders`.
pub fn seeds(folders: &[PathBuf]) -> Vec<Seed> {
    let mut seeds: Vec<_> = SMALL
        .iter()
        .map(|&(kind, text)| Seed::new(kind, text))
        .collect();
    seeds.extend(made());
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let fixtures = ["seeds", "../delone-io/tests/data"].map(|folder| here.join(folder));
    for folder in [&fixtures[..], folders].concat() {
        collect(&folder, &mut seeds);
    }
    seeds.extend(pairs(&seeds));
    seeds
}

/// Reads the small files of a folder and those in it, in the order of their names.
fn collect(folder: &Path, seeds: &mut Vec<Seed>) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = entries.map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect(&path, seeds);
        } else if fs::metadata(&path).is_ok_and(|m| m.len() <= LARGEST)
            && let Some(kind) = path.extension().and_then(|e| e.to_str())
            && let Ok(bytes) = fs::read(&path)
        {
            seeds.push(Seed::new(kind, bytes));
        }
    }
}

/// Joins files that belong together.
fn pairs(seeds: &[Seed]) -> Vec<Seed> {
    let first = |kind: &str| seeds.iter().find(|seed| seed.kind == kind);
    let kinds = [
        ["ele", "node"],
        ["poly", "node"],
        ["shp", "dbf"],
        ["npy", "points.npy"],
    ];
    let mut joint = Vec::new();
    for [a, b] in kinds {
        if let (Some(head), Some(tail)) = (first(a), first(b)) {
            joint.push(Seed::new(
                &format!("{a}+{b}"),
                joined(&head.bytes, &tail.bytes),
            ));
        }
    }
    // Indices into points that are elsewhere.
    let poly = b"0 2 0 0\n2 1\n1 1 2 5\n2 2 3 6\n0\n";
    joint.push(Seed::new("poly+node", joined(poly, SMALL[0].1.as_bytes())));
    joint
}

/// Writes a mesh, and points, in every format that this library writes.
fn made() -> Vec<Seed> {
    let points =
        [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.5, 1.0)].map(delone::Point::from);
    let set = PointSet {
        points: points.to_vec(),
        attributes: vec![Attribute {
            name: "z".to_owned(),
            values: vec![1.0, 2.0, 3.0, 4.0, 0.1],
        }],
        markers: Some(vec![1, 2, 3, 4, 5]),
        ..PointSet::default()
    };
    let built = delone::triangulate(points).expect("finite");
    let constraints = Constraints {
        edges: vec![[0, 1].map(delone::VertexId::new)],
        markers: Some(vec![9]),
        ..Constraints::default()
    };
    let mesh = MeshView::from(&built)
        .with_data(&set)
        .with_constraints(&constraints);
    let mut seeds = Vec::new();
    for ascii in [false, true] {
        let options = WriteOptions {
            ascii,
            ..WriteOptions::default()
        };
        let names = [
            "f.ele",
            "f.npy",
            "f.geojson",
            "f.vtu",
            "f.vtk",
            "f.msh",
            "f.msh2",
            "f.mesh",
            "f.obj",
            "f.off",
            "f.ply",
            "f.dxf",
            "f.parquet",
        ];
        let targets = names.map(|name| Target::from_arg(name, None));
        let work = || write_mesh(&targets, &mesh, &options, &());
        let (_, mut files) = in_memory(work).expect("a mesh is written");
        let targets =
            ["g.node", "g.npy", "g.csv", "g.parquet"].map(|name| Target::from_arg(name, None));
        let work = || write_points(&targets, &set, &options, &());
        files.extend(in_memory(work).expect("points are written").1);
        seeds.extend(files.into_iter().filter_map(|file| {
            let name = file.name.to_str()?;
            Some(Seed::new(name.split_once('.')?.1, file.bytes))
        }));
    }
    seeds.extend(logs());
    seeds.extend(lineage_in_columns());
    seeds
}

/// Writes the table of lineage that is there as text in the other format.
fn lineage_in_columns() -> Option<Seed> {
    let source = memory("f.csv", include_bytes!("../seeds/square.lineage"));
    let lineage = Lineage::read(&source, 100, &()).ok()?;
    let papers = Papers {
        lineage: Some((Path::new("f.parquet"), &lineage)),
        certificate: None,
    };
    let (mesh, options) = (MeshView::new(&[], &[]), WriteOptions::default());
    let write = || write_certified(&[], &mesh, &options, &papers, &());
    let (_, files) = in_memory(write).ok()?;
    Some(Seed::new("lineage", files.into_iter().next()?.bytes))
}

/// Records a run in both formats.
fn logs() -> Vec<Seed> {
    use delone::classic::{Algorithm, Input};
    let input = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(delone::Point::from);
    let algorithm = Algorithm::Incremental;
    let mut log = delone::Log::new(algorithm.about().name, input);
    if algorithm
        .observe(&Input::from_points(input), &mut log)
        .is_err()
    {
        return Vec::new();
    }
    let recording = Recording::new(algorithm.about(), log);
    let both = [("dlog", "f.dlog"), ("log.json", "f.json")];
    let seed = |(kind, name): (&str, &str)| {
        let write = || write_log(&recording, Some(name.as_ref()), None, &());
        let (_, files) = in_memory(write).ok()?;
        Some(Seed::new(kind, files.into_iter().next()?.bytes))
    };
    both.into_iter().filter_map(seed).collect()
}

impl Body {
    /// Tells whether a seed is meant for this.
    pub fn takes(&self, seed: &Seed) -> bool {
        self.fed_with.contains(&"*") && !seed.kind.contains('+')
            || self.fed_with.contains(&&*seed.kind)
    }

    /// Makes an input of a seed: choices before the content.
    pub fn input(&self, seed: &Seed, choices: u64) -> Vec<u8> {
        let mut input = choices.to_le_bytes()[..self.choices].to_vec();
        input.extend(&seed.bytes);
        input
    }
}
