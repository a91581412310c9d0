//! The printed sweep: where it fails, it says so.

use crate::polygons::{doubled_area, doubled_areas, ring, simple_polygon};
use crate::suite::run;
use delone::classic::{Algorithm, Input};
use delone::{DomainRule, Event, Failure};
use delone_testkit::generate::Random;

#[test]
fn where_it_fails_on_random_polygons_it_says_so() {
    let mut random = Random::new(600);
    let (mut failed, mut lost, mut spikes) = (0, 0, 0);
    for _ in 0..600 {
        let n = 5 + random.below(10);
        let corners = simple_polygon(n, 41, &mut random);
        let mut input = Input::from_pslg(ring(&corners));
        input.domain = DomainRule::EvenOdd;
        let (output, log) = run(Algorithm::PrintedSweep, &input);
        let told = log.steps.iter().filter_map(|step| match step.event {
            Event::PrintFailed { failure } => Some(failure),
            _ => None,
        });
        assert_eq!(told.collect::<Vec<_>>(), output.failures);
        let has = |test: fn(&Failure) -> bool| usize::from(output.failures.iter().any(test));
        failed += has(|_| true);
        lost += has(|f| matches!(f, Failure::SegmentLost(_)));
        spikes += has(|f| matches!(f, Failure::SeesOne(_)));
        if output.failures.is_empty() {
            let area = doubled_areas(&corners, &output.triangles);
            assert_eq!(area, doubled_area(&corners), "{corners:?}");
        }
    }
    // About one in nine; the exact numbers depend on the polygons drawn.
    assert!((40..120).contains(&failed), "{failed} of 600 fail");
    assert!(
        lost > 30 && spikes > 30,
        "{lost} lose segments, {spikes} have spikes"
    );
}
