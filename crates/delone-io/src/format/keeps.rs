//! What survives when something is written: the other half of what can be done with each format.
//!
//! The table is a promise about [`write_mesh`](crate::write_mesh), [`write_domain`](crate::write_domain) and
//! [`write_points`](crate::write_points), as far as the format has them: what is kept, a reader finds again. The test
//! `keeps` writes all there is and looks.

use super::Format;

/// What a format keeps of points, domains and meshes that are written in it.
///
/// Coordinates are kept in any case, see [`Precision`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keeps {
    kept: u16,
    /// How coordinates are kept.
    pub coordinates: Precision,
}

/// How coordinates are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Precision {
    /// As doubles.
    Doubles,
    /// As decimals that read back as the same doubles.
    Decimals,
    /// As floats of 32 bits: 7 digits.
    Floats,
    /// Rounded to what a picture shows.
    Picture,
}

impl Precision {
    /// Tells whether the same doubles are read back.
    pub const fn is_exact(self) -> bool {
        matches!(self, Self::Doubles | Self::Decimals)
    }

    /// Says it in a word or two.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Doubles => "f64",
            Self::Decimals => "decimals",
            Self::Floats => "f32",
            Self::Picture => "rounded",
        }
    }
}

/// Something that a format may keep or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Trait {
    /// The third coordinate of points, the attribute `z`.
    Z,
    /// Other attributes of points.
    PointAttributes,
    /// Boundary markers of points, as such or as a column of numbers.
    PointMarkers,
    /// Segments, of a mesh the constrained edges.
    Segments,
    /// Markers of segments.
    SegmentMarkers,
    /// Points that name holes.
    Holes,
    /// Points that name regions.
    Regions,
    /// The region of each triangle.
    TriangleRegions,
    /// Attributes of triangles.
    TriangleAttributes,
    /// Triangles of six nodes.
    SixNodes,
}

impl Trait {
    /// Every one.
    pub const ALL: [Self; 10] = [
        Self::Z,
        Self::PointAttributes,
        Self::PointMarkers,
        Self::Segments,
        Self::SegmentMarkers,
        Self::Holes,
        Self::Regions,
        Self::TriangleRegions,
        Self::TriangleAttributes,
        Self::SixNodes,
    ];

    /// Says in words what it is.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Z => "z",
            Self::PointAttributes => "attributes of points",
            Self::PointMarkers => "markers of points",
            Self::Segments => "segments",
            Self::SegmentMarkers => "markers of segments",
            Self::Holes => "holes",
            Self::Regions => "regions",
            Self::TriangleRegions => "regions of triangles",
            Self::TriangleAttributes => "attributes of triangles",
            Self::SixNodes => "six nodes",
        }
    }

    const fn bit(self) -> u16 {
        1 << self as u16
    }
}

impl Keeps {
    const fn new(kept: &[Trait], coordinates: Precision) -> Self {
        let mut bits = 0;
        let mut i = 0;
        while i < kept.len() {
            bits |= kept[i].bit();
            i += 1;
        }
        Self {
            kept: bits,
            coordinates,
        }
    }

    /// Tells whether something survives.
    pub const fn keeps(self, what: Trait) -> bool {
        self.kept & what.bit() != 0
    }
}

impl Format {
    /// Tells what survives when the format is written, in all files that it consists of; `None` if it holds neither
    /// points, domains nor meshes, or is only read.
    pub const fn keeps(self) -> Option<Keeps> {
        if !(self.writes_points() || self.writes_segments() || self.writes_mesh()) {
            return None;
        }
        Some(of(self))
    }
}

const fn of(format: Format) -> Keeps {
    use Precision::{Decimals, Doubles, Floats, Picture};
    use Trait::*;
    match format {
        // The whole family, with the .poly that goes with constrained meshes.
        Format::Node | Format::Ele | Format::Edge | Format::Neigh | Format::Poly => Keeps::new(
            &[
                Z,
                PointAttributes,
                PointMarkers,
                Segments,
                SegmentMarkers,
                Holes,
                Regions,
                TriangleAttributes,
                SixNodes,
            ],
            Decimals,
        ),
        Format::Npy => Keeps::new(
            &[Z, PointAttributes, PointMarkers, Segments, SegmentMarkers],
            Doubles,
        ),
        Format::Table => Keeps::new(&[Z, PointAttributes, PointMarkers], Decimals),
        Format::Parquet => Keeps::new(
            &[
                Z,
                PointAttributes,
                PointMarkers,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                TriangleAttributes,
            ],
            Doubles,
        ),
        Format::GeoJson => Keeps::new(
            &[
                Z,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                TriangleAttributes,
            ],
            Decimals,
        ),
        Format::Vtu | Format::Vtk => Keeps::new(
            &[
                Z,
                PointAttributes,
                PointMarkers,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                TriangleAttributes,
                SixNodes,
            ],
            Doubles,
        ),
        Format::Msh | Format::Msh2 => Keeps::new(
            &[
                Z,
                PointAttributes,
                PointMarkers,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                TriangleAttributes,
                SixNodes,
            ],
            Decimals,
        ),
        Format::Medit => Keeps::new(
            &[
                PointMarkers,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                SixNodes,
            ],
            Decimals,
        ),
        Format::Obj => Keeps::new(&[Z, Segments, SegmentMarkers, TriangleRegions], Decimals),
        Format::Off => Keeps::new(&[Z], Decimals),
        Format::Ply => Keeps::new(
            &[
                Z,
                PointAttributes,
                PointMarkers,
                Segments,
                SegmentMarkers,
                TriangleRegions,
                TriangleAttributes,
            ],
            Doubles,
        ),
        Format::Stl => Keeps::new(&[Z], Floats),
        Format::Dxf => Keeps::new(&[Z, Segments, SegmentMarkers, TriangleRegions], Decimals),
        Format::Tikz | Format::Svg | Format::Png => Keeps::new(&[Segments], Picture),
        // Neither points, domains nor meshes are written in these.
        Format::Wkt
        | Format::Shp
        | Format::Las
        | Format::Jigsaw
        | Format::Airfoil
        | Format::Gif
        | Format::Html => Keeps::new(&[], Picture),
    }
}
