//! From a prepared domain to the canvas and back: scaling, the closing of the hull, and lineage.

use super::canvas::{Canvas, Traits};
use super::lines::{Lines, NO_LINE};
use crate::constrained::{Context, Cuts, Faces, NO_SEGMENT, Prepared};
use crate::{Point, VertexId};

/// Returns the power of two by which coordinates are multiplied, so that squares of lengths and their
/// products neither overflow nor vanish; 1 if that would round a coordinate.
pub(super) fn scale(points: &[Point]) -> f64 {
    let largest = points
        .iter()
        .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    if largest == 0.0 || (1e-30..1e30).contains(&largest) {
        return 1.0;
    }
    let exponent = libm::ilogb(largest).clamp(-1022, 1022);
    let scale = libm::ldexp(1.0, -exponent);
    let is_exact = |c: f64| c * scale / scale == c;
    match points.iter().all(|p| is_exact(p.x) && is_exact(p.y)) {
        true => scale,
        false => 1.0,
    }
}

/// Makes segments of the edges of the convex hull, behind those of the input: counter-clockwise, beginning
/// at the lexicographically smallest vertex.
pub(super) fn close_hull(prepared: &mut Prepared) {
    let Prepared {
        points,
        faces,
        context,
    } = prepared;
    let mesh = &faces.mesh;
    let Some(ghost) = mesh.ghosts().next() else {
        return;
    };
    if mesh.triangles().next().is_none() {
        return;
    }
    let mut hull: Vec<_> = mesh.hull(mesh.hull_edge_of(ghost)).collect();
    // The half-edges of ghosts run clockwise.
    let start = |h| points[mesh.dest(h).index()];
    let smallest = (0..hull.len()).min_by(|&i, &j| start(hull[i]).lex_cmp(&start(hull[j])));
    hull.rotate_left(smallest.unwrap_or(0));
    for h in hull {
        let ends = [mesh.dest(h), mesh.origin(h)];
        let ends = ends.map(|v| context.names.callers[v.index()]);
        context.pslg.segments.push(ends);
        for h in [h, mesh.twin(h)] {
            faces.constrained[h.triangle().index()] |= 1 << h.slot();
        }
    }
}

/// Tells of each vertex whether it was added already, and is on no segment.
pub(super) fn are_sown(prepared: &Prepared) -> Vec<bool> {
    let Context {
        pslg,
        names,
        lineage,
        ..
    } = &prepared.context;
    let first = pslg.points.len() - lineage.steiner.len();
    let is_sown = |v: &VertexId| {
        let steiner = v.index().checked_sub(first).map(|i| lineage.steiner[i]);
        steiner == Some(NO_SEGMENT)
    };
    names.callers.iter().map(is_sown).collect()
}

/// Takes the faces out, and leaves what leads back to the input.
pub(super) fn canvas(prepared: Prepared, scale: f64) -> (Canvas, Context) {
    let Prepared {
        mut points,
        faces,
        context,
    } = prepared;
    if scale != 1.0 {
        for p in &mut points {
            *p = Point::new(p.x * scale, p.y * scale);
        }
    }
    let Faces {
        mesh,
        constrained,
        outside,
        region_of,
    } = faces;
    let traits = constrained.iter().zip(&outside);
    let traits =
        traits.map(|(bits, &outside)| Traits(bits & 0b111 | (u8::from(outside) * Traits::OUTSIDE)));
    let canvas = Canvas {
        points,
        mesh,
        traits: traits.collect(),
        region_of,
        scale,
    };
    (canvas, context)
}

/// Puts faces and lineage together again.
pub(super) fn prepared(canvas: Canvas, lines: &Lines, mut context: Context) -> Prepared {
    let Canvas {
        mut points,
        mesh,
        traits,
        region_of,
        scale,
    } = canvas;
    let num_old = lines.num_old();
    if scale != 1.0 {
        for p in &mut points[num_old..] {
            *p = Point::new(p.x / scale, p.y / scale);
        }
    }
    // Vertices that were sown may have been moved since.
    let first = context.pslg.points.len() - context.lineage.steiner.len();
    for (&at, caller) in points.iter().zip(&context.names.callers) {
        if caller.index() >= first {
            context.pslg.points[caller.index()] = Point::new(at.x / scale, at.y / scale);
        }
    }
    context.pslg.points.extend(&points[num_old..]);
    context
        .names
        .callers
        .extend((num_old..points.len()).map(VertexId::new));
    inherit(lines, &mut context);
    let faces = Faces {
        mesh,
        constrained: traits.iter().map(|t| t.0).collect(),
        outside: traits.iter().map(|t| t.is_outside()).collect(),
        region_of,
    };
    Prepared {
        points,
        faces,
        context,
    }
}

/// Lengthens the chains of segments by the vertices on their lines, and finds the segment of each.
fn inherit(lines: &Lines, context: &mut Context) {
    let Context {
        pslg,
        names,
        lineage,
        ..
    } = context;
    let cuts = Cuts::new(lines.num_old(), lines.iter().map(|(_, line)| line.ends));
    let (chains, segment_of) = cuts.lengthen(
        &pslg.segments,
        &lineage.chains,
        |v| names.positions[v.index()],
        |line, from, chain| match lines.get(line).ends[0] == from[0] {
            true => chain.extend(lines.inside(line)),
            false => chain.extend(lines.inside(line).rev()),
        },
    );
    let of_line = |line: u32| match line {
        NO_LINE => NO_SEGMENT,
        line => segment_of[line as usize],
    };
    lineage.chains = chains;
    lineage.steiner.extend(lines.owners().map(of_line));
}
