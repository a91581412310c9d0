//! The list of bodies.

use crate::{Meter, paths, readers};

/// Something that is done with any bytes.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Its name.
    pub name: &'static str,
    /// Extensions of the files whose content it is made for.
    pub fed_with: &'static [&'static str],
    /// Bytes before the content that choose what is done.
    pub choices: usize,
    /// Memory that it may take, whatever it is given.
    free: usize,
    /// Memory that it may take more for each byte.
    per_byte: usize,
    run: fn(&[u8]),
}

/// Memory that every reader may take: buffers, tables, a thread or two.
const FREE: usize = 64 << 20;

/// Memory for each byte: of a table `0 0\n` makes a point of two doubles, its line, and what they grow in.
const PER_BYTE: usize = 200;

const fn reader(name: &'static str, fed_with: &'static [&'static str], run: fn(&[u8])) -> Body {
    Body {
        name,
        fed_with,
        choices: 0,
        free: FREE,
        per_byte: PER_BYTE,
        run,
    }
}

/// Curves are flattened, and blocks inserted: up to 2²⁴ points of two doubles, growing, and their segments.
const fn drawing(name: &'static str, fed_with: &'static [&'static str], run: fn(&[u8])) -> Body {
    Body {
        free: 1 << 30,
        ..reader(name, fed_with, run)
    }
}

/// What is packed may be larger by a ratio that the readers state.
const fn packed(
    name: &'static str,
    fed_with: &'static [&'static str],
    run: fn(&[u8]),
    free: usize,
    per_byte: usize,
) -> Body {
    Body {
        free: FREE + free,
        per_byte: PER_BYTE + per_byte,
        ..reader(name, fed_with, run)
    }
}

const fn path(name: &'static str, fed_with: &'static [&'static str], run: fn(&[u8])) -> Body {
    Body {
        choices: 2,
        free: 1 << 30,
        per_byte: 1 << 12,
        ..reader(name, fed_with, run)
    }
}

/// Every one: readers of single files, of files with their neighbours, and the ways of the commands.
pub const BODIES: &[Body] = &[
    reader("read-node", &["node"], |b| readers::read("f.node", b)),
    reader("read-poly", &["poly"], |b| readers::read("f.poly", b)),
    reader("read-table", &["csv", "xyz", "tsv", "txt"], |b| {
        readers::read("f.csv", b)
    }),
    reader("read-xyz", &["xyz", "txt", "csv"], |b| {
        readers::read("f.xyz", b)
    }),
    reader("read-asc", &["asc"], |b| readers::read("f.asc", b)),
    reader("read-npy", &["npy"], |b| readers::read("f.npy", b)),
    reader("read-geojson", &["geojson", "json"], |b| {
        readers::read("f.geojson", b)
    }),
    reader("read-wkt", &["wkt"], |b| readers::read("f.wkt", b)),
    reader("read-shp", &["shp"], |b| readers::read("f.shp", b)),
    packed(
        "read-vtu",
        &["vtu"],
        |b| readers::read("f.vtu", b),
        256 << 20,
        200,
    ),
    reader("read-vtk", &["vtk"], |b| readers::read("f.vtk", b)),
    reader("read-msh", &["msh", "msh2"], |b| readers::read("f.msh", b)),
    reader("read-jigsaw", &["jigsaw"], |b| readers::read("f.jigsaw", b)),
    reader("read-airfoil", &["dat"], |b| readers::read("f.airfoil", b)),
    reader("read-medit", &["mesh"], |b| readers::read("f.mesh", b)),
    reader("read-obj", &["obj"], |b| readers::read("f.obj", b)),
    reader("read-off", &["off"], |b| readers::read("f.off", b)),
    reader("read-ply", &["ply"], |b| readers::read("f.ply", b)),
    drawing("read-dxf", &["dxf"], |b| readers::read("f.dxf", b)),
    drawing("read-svg", &["svg"], |b| readers::read("f.svg", b)),
    packed(
        "read-las",
        &["las"],
        |b| readers::read("f.las", b),
        64 << 20,
        1 << 10,
    ),
    packed(
        "read-laz",
        &["laz"],
        |b| readers::read("f.laz", b),
        256 << 20,
        1 << 10,
    ),
    packed(
        "read-parquet",
        &["parquet"],
        |b| readers::read("f.parquet", b),
        1 << 30,
        1 << 12,
    ),
    reader("read-ele-node", &["ele+node"], |b| {
        readers::read_pair("ele", "node", b)
    }),
    reader("read-poly-node", &["poly+node"], |b| {
        readers::read_pair("poly", "node", b)
    }),
    reader("read-shp-dbf", &["shp+dbf"], |b| {
        readers::read_pair("shp", "dbf", b)
    }),
    reader("read-npy-npy", &["npy+points.npy"], |b| {
        readers::read_pair("npy", "points.npy", b)
    }),
    drawing("read-unknown", &["*"], readers::read_unnamed),
    reader("read-area", &["area"], readers::read_area),
    reader("read-log", &["dlog", "log.json"], readers::read_log),
    reader(
        "read-certificate",
        &["certificate"],
        readers::read_certificate,
    ),
    reader("read-lineage", &["lineage"], readers::read_lineage),
    path("path-points", &["csv", "xyz", "node"], paths::points),
    path("path-domain", &["poly", "geojson", "wkt"], paths::domain),
    path("path-doctor", &["poly", "geojson", "wkt"], paths::doctor),
    path(
        "path-refine",
        &["poly", "geojson", "wkt", "off"],
        paths::refine,
    ),
    path("path-queries", &["csv", "xyz", "node"], paths::queries),
    path("path-convert", &["*"], paths::convert),
];

impl Body {
    /// Returns the one of a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        BODIES.iter().find(|body| body.name == name)
    }

    /// Returns the most bytes of memory that it may take for an input of a length.
    pub fn memory(&self, length: usize) -> usize {
        self.free + self.per_byte * length
    }

    /// Runs it.
    ///
    /// # Panics
    /// If something is wrong, or takes too much memory.
    pub fn run(&self, bytes: &[u8]) {
        let meter = Meter::start();
        (self.run)(bytes);
        let (peak, allowed) = (meter.peak(), self.memory(bytes.len()));
        assert!(
            peak <= allowed,
            "{}: {peak} bytes of memory for {} bytes, at most {allowed} are right",
            self.name,
            bytes.len()
        );
    }
}
