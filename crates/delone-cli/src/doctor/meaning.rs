//! What each kind of trouble is called, what it means, and what to do about it.

use delone::doctor::Kind;

/// The heading for one and for many, and a sentence on what it means and what to do.
pub fn of(kind: Kind) -> [&'static str; 3] {
    match kind {
        Kind::Crossing => [
            "pair of segments that cross",
            "pairs of segments that cross",
            "Refused, unless there is a vertex just there; --repair or --crossings split cuts both.",
        ],
        Kind::SeedOnSegment => [
            "seed on a segment",
            "seeds on segments",
            "Refused, for it is not clear which side is meant; move it off the segment.",
        ],
        Kind::OpenPolygon => [
            "point where a polygon is open",
            "points where polygons are open",
            "Refused; close the polygon, or --repair with a tolerance above the gap.",
        ],
        Kind::Overlap => [
            "pair of segments that overlap",
            "pairs of segments that overlap",
            "They share more than a point and are cut there; perhaps something is drawn twice.",
        ],
        Kind::VertexOnSegment => [
            "point inside a segment",
            "points inside segments",
            "The segment is cut there; if that is not meant, move the point.",
        ],
        Kind::ZeroLength => [
            "segment of no length",
            "segments of no length",
            "They are left out; perhaps points were rounded to the same place.",
        ],
        Kind::NearVertices => [
            "pair of points within the tolerance",
            "pairs of points within the tolerance",
            "Triangles between them become tiny; --repair makes one point of them.",
        ],
        Kind::NearSegment => [
            "point within the tolerance of a segment",
            "points within the tolerance of segments",
            "Triangles between them become flat; --repair lets the segment go through the point.",
        ],
        Kind::UnclosedRing => [
            "line that almost closes",
            "lines that almost close",
            "It encloses nothing until it is closed: --repair with a tolerance of at least the gap.",
        ],
        Kind::SelfTouch => [
            "ring that touches itself",
            "rings that touch themselves",
            "Some programs refuse it; draw two rings instead.",
        ],
        Kind::Misnested => [
            "ring in the wrong place",
            "rings in the wrong place",
            "The first ring of a polygon should lie directly around all others; the inside is by parity.",
        ],
        Kind::Nothing => [
            "domain of nothing",
            "domains of nothing",
            "The segments enclose nothing, or holes take all of it; close the outline, or keep the hull.",
        ],
        Kind::SeedOutside => [
            "seed outside the domain",
            "seeds outside the domain",
            "It stands for nothing; move it inside, or drop it.",
        ],
        Kind::SeedTwice => [
            "region with two seeds",
            "regions with two seeds",
            "The first one counts; close the line between them, or drop one.",
        ],
        Kind::Needle => [
            "corner below 1°",
            "corners below 1°",
            "Triangles there are needles whatever is done; perhaps two lines should be one.",
        ],
        Kind::FarAway => [
            "drawing too far from the origin",
            "drawings too far from the origin",
            "Its extent is but a few steps of rounding; subtract an offset from all coordinates.",
        ],
        Kind::Duplicate => [
            "duplicate point",
            "duplicate points",
            "They are merged; nothing needs to be done.",
        ],
        Kind::Repeated => [
            "repeated segment",
            "repeated segments",
            "They are one edge; under even-odd, a border that is there twice counts twice.",
        ],
        Kind::OpenEnd => [
            "open end",
            "open ends",
            "A line ends in nothing, as breaklines do; an outline should not.",
        ],
        Kind::LoosePoint => [
            "loose point",
            "loose points",
            "No segment ends there; they become vertices all the same.",
        ],
        Kind::SharpCorner => [
            "corner below 20°",
            "corners below 20°",
            "Meshes keep these angles, and need small triangles around them.",
        ],
        Kind::Elongated => [
            "drawing that is very long",
            "drawings that are very long",
            "Perhaps the axes have different units.",
        ],
        _ => ["trouble", "troubles", ""],
    }
}
