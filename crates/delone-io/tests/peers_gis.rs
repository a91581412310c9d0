//! Files exchanged with pandas, Polars, DuckDB, GeoPandas, Shapely and GDAL.
//!
//! Runs only where `DELONE_PYTHON` names a Python that has them; each that is missing is said and passed over.

#![cfg(feature = "parquet")]

mod peers;

use delone::{Point, VertexId};
use delone_io::{
    Attribute, Constraints, MeshData, MeshView, PointSet, ReadOptions, Source, Target,
    WriteOptions, read_domain, read_points, write_mesh,
};
use std::path::Path;

/// Runs a script in a folder; `None` if there is no Python, or it lacks one of these modules.
fn python(folder: &Path, modules: &[&str], script: &str) -> Option<()> {
    let mut python = peers::python(modules)?;
    peers::said(python.current_dir(folder).args(["-c", script]));
    Some(())
}

/// Numbers that are easily spoiled: the n-th of a row.
fn number(n: usize) -> f64 {
    [0.1, -0.0, 1.0 / 3.0, 1e300, 5e-324, -123_456_789.125][n % 6] * (1 + n / 6) as f64
}

fn mesh() -> MeshData {
    let n = 1000;
    let values = |step: usize| (0..n).map(|i| number(i + step)).collect::<Vec<_>>();
    let mut heights = values(3);
    heights[17] = f64::NAN;
    let ids = |v: [usize; 3]| v.map(VertexId::new);
    MeshData {
        vertices: PointSet {
            points: values(0)
                .into_iter()
                .zip(values(1))
                .map(|(x, y)| Point::new(x, y))
                .collect(),
            attributes: vec![Attribute {
                name: "z".to_owned(),
                values: heights,
            }],
            markers: Some((0..n as i32).map(|i| i * 7 - 3000).collect()),
            ..PointSet::default()
        },
        triangles: (0..n - 2).map(|i| ids([i, i + 1, i + 2])).collect(),
        constraints: Some(Constraints {
            edges: vec![[0, 1].map(VertexId::new), [5, 4].map(VertexId::new)],
            markers: Some(vec![3, -4]),
            ..Constraints::default()
        }),
        ..MeshData::default()
    }
}

#[test]
fn our_meshes_are_read_by_others() {
    let folder = tempfile::tempdir().expect("folder");
    let target = Target::from_arg(folder.path().join("m.parquet"), None);
    let mesh = mesh();
    write_mesh(
        &[target],
        &MeshView::from(&mesh),
        &WriteOptions::default(),
        &(),
    )
    .expect("written");
    // Python says the numbers in its own words, which are as exact.
    let script = "
import struct
base = [0.1, -0.0, 1 / 3, 1e300, 5e-324, -123456789.125]
number = lambda n: base[n % 6] * (1 + n // 6)
bits = lambda values: [struct.pack('<d', v) for v in values]
def check(points, triangles, segments):
    x, y, z, marker = points
    n = 1000
    assert bits(x) == bits(number(i) for i in range(n))
    assert bits(y) == bits(number(i + 1) for i in range(n))
    assert z[17] is None or z[17] != z[17]
    z[17] = 0.0
    assert bits(z) == bits(0.0 if i == 17 else number(i + 3) for i in range(n))
    assert marker == [7 * i - 3000 for i in range(n)]
    assert triangles == [list(range(k, n - 2 + k)) for k in range(3)]
    assert segments == [[0, 5], [1, 4], [3, -4]]
names = ['m.points.parquet', 'm.parquet', 'm.segments.parquet']
";
    let readers = [
        (
            "pandas",
            "import pandas\ncheck(*([list(t[c]) for c in t] for t in map(pandas.read_parquet, names)))",
        ),
        (
            "polars",
            "import polars\ncheck(*([c.to_list() for c in t] for t in map(polars.read_parquet, names)))",
        ),
        (
            "duckdb",
            "import duckdb\ncheck(*([list(c) for c in zip(*duckdb.sql(f\"from '{t}'\").fetchall())] for t in names))",
        ),
        (
            "pyarrow",
            "import pyarrow.parquet as q\nt = q.read_table(names[1])\nassert str(t.schema.field('a').type) == 'int32'\nassert not t.schema.field('a').nullable",
        ),
        (
            "fastparquet",
            "import fastparquet\ncheck(*([list(t[c]) for c in t] for t in (fastparquet.ParquetFile(n).to_pandas() for n in names)))",
        ),
    ];
    for (module, reader) in readers {
        let read = python(folder.path(), &[module], &format!("{script}\n{reader}\n"));
        if read.is_some() {
            eprintln!("read by {module}");
        }
    }
}

#[test]
fn tables_of_others_are_read_by_us() {
    let folder = tempfile::tempdir().expect("folder");
    let script = "
import numpy, pandas
rng = numpy.random.default_rng(5)
n = 30000
t = pandas.DataFrame({'x': rng.normal(size=n), 'y': rng.normal(size=n) * 1e6, 'v': rng.integers(0, 9, n)})
t['w'] = t['x'].astype('float32')
t.loc[5, 'w'] = None
t.to_csv('t.csv', index=False)
for version in ['1.0', '2.4', '2.6']:
    for page in ['1.0', '2.0']:
        t.to_parquet(f'pandas-{version}-{page}.parquet', version=version, data_page_version=page, row_group_size=7000)
t.to_parquet('split.parquet', use_dictionary=False, column_encoding={'x': 'BYTE_STREAM_SPLIT', 'v': 'DELTA_BINARY_PACKED'}, compression='gzip')
try:
    import polars
    polars.from_pandas(t).write_parquet('polars.parquet')
except ImportError: pass
try:
    import duckdb
    duckdb.sql(\"COPY t TO 'duckdb.parquet' (PARQUET_VERSION v2)\")
except ImportError: pass
try:
    t.to_parquet('fast.parquet', engine='fastparquet')
except ImportError: pass
";
    let Some(()) = python(folder.path(), &["pandas", "pyarrow"], script) else {
        return;
    };
    let read = |path: &Path| {
        read_points(&Source::from_arg(path), &ReadOptions::default(), &())
            .unwrap_or_else(|error| panic!("{error}"))
    };
    let expected = read(&folder.path().join("t.csv"));
    let mut count = 0;
    for entry in std::fs::read_dir(folder.path()).expect("folder") {
        let path = entry.expect("entry").path();
        if path.extension().is_some_and(|e| e == "parquet") {
            let set = read(&path);
            let name = path.display();
            assert!(set.points == expected.points, "{name}");
            assert!(set.attributes[0] == expected.attributes[0], "{name}");
            let close =
                |a: &f64, b: &f64| (a - b).abs() <= 1e-6 * b.abs() || a.is_nan() && b.is_nan();
            let [ours, theirs] = [&set, &expected].map(|set| &set.attributes[1].values);
            assert!(ours.iter().zip(theirs).all(|(a, b)| close(a, b)), "{name}");
            count += 1;
        }
    }
    assert!(count >= 7, "{count}");
}

#[test]
fn layers_of_geopandas_and_gdal_are_the_same_in_every_format() {
    let folder = tempfile::tempdir().expect("folder");
    let script = "
import geopandas, numpy
from shapely import Point, Polygon, LineString, MultiLineString, MultiPoint, get_parts, voronoi_polygons, to_wkb, set_srid
rng = numpy.random.default_rng(7)
points = [Point(x, y) for x, y in rng.normal(size=(200, 2))]
cells = [cell for cell in get_parts(voronoi_polygons(MultiPoint(points[:40])))]
rings = [p.buffer(0.3, 3).difference(p.buffer(0.1, 2)) for p in points[:30]]
lines = [LineString(rng.normal(size=(k, 2))) for k in range(2, 30)]
lines.append(MultiLineString([rng.normal(size=(3, 2)), rng.normal(size=(4, 2))]))
for name, layer in [('points', points), ('cells', cells), ('rings', rings), ('lines', lines)]:
    frame = geopandas.GeoDataFrame({'nr': range(len(layer))}, geometry=layer)
    frame.to_parquet(f'{name}.parquet')
    frame.to_file(f'{name}.shp')
    open(f'{name}.geojson', 'w').write(frame.to_json())
    with open(f'{name}.wkt', 'w') as out:
        out.write('\\n'.join(to_wkb(set_srid(g, 3857), hex=True, include_srid=True) for g in frame.geometry))
geopandas.GeoDataFrame(geometry=points).to_parquet('native.parquet', geometry_encoding='geoarrow')
";
    let Some(()) = python(folder.path(), &["geopandas", "pyogrio", "shapely"], script) else {
        return;
    };
    let read = |name: String| {
        let source = Source::from_arg(folder.path().join(name));
        read_domain(&source, &ReadOptions::default(), &()).unwrap_or_else(|error| panic!("{error}"))
    };
    for name in ["points", "cells", "rings", "lines"] {
        let expected = read(format!("{name}.parquet"));
        assert!(expected.vertices.points.len() > 150, "{name}");
        for extension in ["geojson", "wkt"] {
            let same = read(format!("{name}.{extension}"));
            assert!(
                same.vertices.points == expected.vertices.points,
                "{name}.{extension}"
            );
            assert_eq!(same.segments, expected.segments);
            assert_eq!(same.polygons, expected.polygons);
            assert_eq!(
                same.segment_markers.is_some(),
                expected.segment_markers.is_some()
            );
        }
        // A shapefile has outlines clockwise, and may begin a ring elsewhere.
        let shapes = read(format!("{name}.shp"));
        let places = |set: &PointSet| {
            let mut places: Vec<_> = set
                .points
                .iter()
                .map(|p| [p.x.to_bits(), p.y.to_bits()])
                .collect();
            places.sort_unstable();
            places
        };
        assert!(
            places(&shapes.vertices) == places(&expected.vertices),
            "{name}.shp"
        );
        assert_eq!(shapes.segments.len(), expected.segments.len(), "{name}.shp");
        assert_eq!(shapes.polygons.len(), expected.polygons.len(), "{name}.shp");
    }
    let native = read("native.parquet".to_owned());
    assert!(native.vertices.points == read("points.parquet".to_owned()).vertices.points);
}
