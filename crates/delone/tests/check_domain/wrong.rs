//! Wrong triangulations, by kind of defect.

use crate::claim::{Claim, RULES, add_square, crossed, flip, lake, misread, point, right};
use delone::check::Defect;
use delone::{DomainRule, Pslg, VertexId};
use delone_testkit::naive::naive_constrained;

#[test]
fn rejects_points_that_are_not_those_of_the_input() {
    let claim = right(&lake(), DomainRule::Carve);
    let moved = misread(claim.clone(), |c| c.points[14].x += 0.25);
    let defects = assert_rejected!(moved, Defect::MovedPoint { .. });
    let text = "point 14 (1.25, 0.5) lies at (1.0, 0.5) in the input";
    assert_eq!(defects.to_string(), text);
    let short = misread(claim.clone(), |c| {
        c.points.pop();
    });
    assert_rejected!(
        short,
        Defect::TooFewPoints {
            given: 16,
            expected: 17
        }
    );
    let shifted = misread(claim, |c| c.points.rotate_left(1));
    assert_rejected!(shifted, Defect::MovedPoint { .. });
}

#[test]
fn rejects_added_vertices_without_reason() {
    let claim = right(&lake(), DomainRule::Carve);
    let again = misread(claim.clone(), |c| c.points.push(c.points[3]));
    assert_rejected!(again, Defect::NotNew { .. });
    // The mesh is right but for the question who asked for the vertex.
    let loose = misread(claim, |c| {
        c.input.points.pop();
    });
    let defects = assert_rejected!(loose, Defect::NeedlessVertex { .. });
    assert_eq!(defects.total(), 1, "{defects}");
    // One in the middle of a segment, and of a second one on the same line.
    let mut input = lake();
    input.points.push(point(0.0, 8.0));
    input.segments.extend([[3, 2].map(VertexId::new)]);
    let mut steiner = right(&input, DomainRule::Carve);
    steiner.numbers();
    steiner.input.points.pop();
    assert_rejected!(steiner, Defect::NeedlessVertex { .. });
    assert_defects!(steiner.verify_chains(), Defect::NeedlessVertex { .. });
}

#[test]
fn rejects_subsegments_that_are_none() {
    let claim = right(&lake(), DomainRule::Carve);
    let with = |ends: [u32; 2]| {
        let ends = ends.map(VertexId::from);
        misread(claim.clone(), |c| c.subsegments.push(ends))
    };
    assert_rejected!(with([0, 99]), Defect::SubsegmentOutOfRange { .. });
    assert_rejected!(with([5, 5]), Defect::EmptySubsegment { .. });
    assert_rejected!(with([1, 0]), Defect::RepeatedSubsegment { .. });
    assert_rejected!(with([0, 9]), Defect::CrossingSubsegments { .. });
    assert_rejected!(with([4, 6]), Defect::VertexOnSubsegment { .. });
    let defects = assert_rejected!(with([0, 4]), Defect::StraySubsegment { .. });
    let text = "subsegment 0 (-8.0, -8.0) – 4 (-5.0, -5.0) is part of no segment";
    assert_eq!(defects.to_string(), text);
    let less = misread(claim.clone(), |c| {
        c.subsegments.pop();
    });
    let defects = assert_rejected!(less, Defect::BrokenChain { .. });
    assert!(defects.to_string().contains("it ends at"), "{defects}");
}

#[test]
fn rejects_crossings_that_are_not_split() {
    let right = right(&crossed(), DomainRule::Hull);
    let mut claim = right.clone();
    claim.points.pop();
    claim.triangles = naive_constrained(&claim.points, &claim.input.segments[..5]);
    claim.subsegments = claim.input.segments.clone();
    assert_rejected!(claim, Defect::CrossingSubsegments { .. });
    // Overlaps from a common end on, to the right and to the left.
    for (a, b) in [([0, 1], [0, 2]), ([1, 2], [0, 2])] {
        let mut input = Pslg::from_points([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]);
        input.segments = [a, b].map(|ends| ends.map(VertexId::new)).to_vec();
        let mut claim = self::right(&input, DomainRule::Hull);
        claim.numbers();
        claim.subsegments = input.segments.clone();
        assert!(claim.verify().is_err());
    }
}

#[test]
fn rejects_segments_that_are_bent() {
    // The middle point lies two units in the last place off the segment.
    let middle = point(1.0, 1.0 + 2.0 * f64::EPSILON);
    let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (0.0, 3.0)]);
    input.points.push(middle);
    input.add_polyline([0u32, 3, 1]);
    let mut claim = right(&input, DomainRule::Hull);
    claim.numbers();
    claim.input.segments = vec![[0, 1].map(VertexId::new)];
    claim.chains = vec![[0, 3, 1].map(VertexId::new).to_vec()];
    let defects = assert_rejected!(claim, Defect::BentChain { .. });
    assert_eq!(
        defects.to_string(),
        "segment 0, 0 (0.0, 0.0) – 1 (2.0, 2.0), is bent to 3 (1.0, 1.0000000000000004), \
         where no other crosses it"
    );
    assert_defects!(claim.verify_chains(), Defect::BentChain { .. });
    // Farther off it is no chain at all.
    let off = point(1.0, 1.0 + 40.0 * f64::EPSILON);
    claim.points[3] = off;
    claim.input.points[3] = off;
    assert_rejected!(claim, Defect::BrokenChain { .. });
}

#[test]
fn rejects_wrong_lineage() {
    let claim = right(&crossed(), DomainRule::Hull);
    let wrong = |change: fn(&mut Vec<Vec<VertexId>>)| {
        let claim = misread(claim.clone(), |c| change(&mut c.chains));
        assert!(claim.verify().is_ok());
        assert_defects!(claim.verify_chains(), Defect::BrokenChain { .. })
    };
    wrong(|chains| chains.rotate_left(1));
    wrong(|chains| chains[4].reverse());
    wrong(|chains| {
        chains[4].remove(1);
    });
    wrong(|chains| {
        chains[4].pop();
    });
    wrong(|chains| chains[4].clear());
    wrong(|chains| chains[4][0] = 1.into());
    wrong(|chains| chains[4][1] = 77.into());
    wrong(|chains| {
        let last = chains[4][1];
        chains[4].push(last);
    });
    // Both ends are right, but the way between them is another segment's.
    let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (2.0, 1.0)]);
    input.add_ring([0, 1, 2]);
    let mut claim = right(&input, DomainRule::Carve);
    claim.numbers();
    claim.chains[0] = [0, 2, 1].map(VertexId::new).to_vec();
    assert_defects!(claim.verify_chains(), Defect::BrokenChain { .. });
}

#[test]
fn rejects_a_forgotten_island_and_a_filled_pond() {
    let claim = right(&lake(), DomainRule::EvenOdd);
    let on_island = |c: &Claim, t: &[VertexId; 3]| {
        t.iter()
            .all(|v| c.points[v.index()].x.abs().max(c.points[v.index()].y.abs()) <= 2.0)
    };
    let forgotten = misread(claim.clone(), |c| {
        c.triangles = c
            .triangles
            .iter()
            .copied()
            .filter(|t| !on_island(c, t))
            .collect();
    });
    assert_rejected!(
        forgotten,
        Defect::Uncovered { .. },
        Defect::MissingPoint { .. }
    );
    let filled = misread(right(&lake(), DomainRule::Carve), |c| {
        c.rule = DomainRule::EvenOdd
    });
    assert_rejected!(filled, Defect::OutsideDomain { .. });
    let kept = misread(right(&lake(), DomainRule::Hull), |c| {
        c.rule = DomainRule::Carve
    });
    assert_rejected!(kept, Defect::OutsideDomain { .. }, Defect::OpenEdge { .. });
    let carved = misread(right(&lake(), DomainRule::Carve), |c| {
        c.rule = DomainRule::Hull
    });
    assert_rejected!(
        carved,
        Defect::Uncovered { .. },
        Defect::MissingPoint { .. }
    );
}

#[test]
fn rejects_triangles_in_a_hole() {
    for rule in RULES {
        let seed = point(6.0, 0.25);
        let mut claim = right(&lake(), rule);
        claim.input.holes.push(seed);
        let defects = assert_rejected!(claim, Defect::FilledHole { hole: 0, .. });
        assert!(
            defects
                .to_string()
                .contains("lies in hole 0 of seed (6.0, 0.25)")
        );
        let mut carved = right(&claim.input, rule);
        carved.numbers();
        carved.input.holes.clear();
        assert_rejected!(carved, Defect::Uncovered { .. });
    }
}

#[test]
fn rejects_gaps_and_sheets() {
    let claim = right(&lake(), DomainRule::Carve);
    let at_pond = |t: &[VertexId; 3]| {
        t.iter()
            .all(|v| (8..12).contains(&v.index()) || v.index() == 14)
    };
    let t = claim
        .triangles
        .iter()
        .position(at_pond)
        .expect("a triangle in the pond");
    let gap = misread(claim.clone(), |c| {
        c.triangles.remove(t);
    });
    assert_rejected!(gap, Defect::OpenEdge { .. });
    let twice = misread(claim.clone(), |c| c.triangles.push(c.triangles[t]));
    assert_rejected!(twice, Defect::CrowdedEdge { .. });
    let turned = misread(claim.clone(), |c| c.triangles[t].reverse());
    assert_rejected!(turned, Defect::Clockwise { .. });
    let flipped = misread(claim, |c| flip(c, t).expect("an edge"));
    assert!(flipped.verify().is_err());
}

#[test]
fn rejects_a_flip_that_only_the_perturbation_forbids() {
    let mut input = Pslg::default();
    add_square(&mut input, [0.0, 0.0], 1.0);
    let mut claim = right(&input, DomainRule::Carve);
    claim.numbers();
    claim.triangles = vec![[0, 1, 2], [0, 2, 3]]
        .into_iter()
        .map(|t| t.map(VertexId::new))
        .collect();
    let defects = assert_rejected!(claim, Defect::NotLocallyDelaunay { .. });
    assert_eq!(defects.total(), 1);
    // A segment exempts the diagonal.
    input.add_segment(0, 2);
    claim.input.add_segment(0, 2);
    claim.subsegments.push([0, 2].map(VertexId::new));
    claim.verify().expect("the diagonal is constrained");
}
