//! Parts of the three algorithms, each used alone.

use delone::predicates::{Orientation, orient2d};
use delone::scattered::{Cover, DataTriangulation, cluster_centers, outer_polygon};
use delone::{Event, Log, Point, Step};
use delone_testkit::data::{DataKind, data};

#[test]
fn flips_alone_enlarge_angles_and_leave_enough_data() {
    let mut flips = 0;
    for seed in 0..10 {
        let data = data(DataKind::Uniform, 300, seed);
        let options = Cover::new(4);
        let rough = options
            .clone()
            .optimizes(false)
            .cover(data.iter().copied())
            .unwrap();
        let mut log = Log::new("flips", data);
        let flipped = options.flip(&rough, &mut log).unwrap();
        let angle = |cover: &DataTriangulation| {
            let verdict = cover.verify(&()).unwrap().into_result().expect("a cover");
            verdict.min_angle
        };
        assert!(angle(&flipped) >= angle(&rough));
        let is_flip = |step: &Step| matches!(step.event, Event::EdgeFlipped { .. });
        flips += log.steps.iter().filter(|step| is_flip(step)).count();
        let again = options.flip(&flipped, &mut ()).unwrap();
        assert_eq!(
            again.triangles(),
            flipped.triangles(),
            "nothing is left to flip"
        );
        log.last_scene().expect("a log that can be played");
        assert_eq!(flipped.triangles().len(), rough.triangles().len());
    }
    assert!(flips > 20, "{flips} flips");
}

/// The text's moves of the point are told, and where they end in doubles, it goes there.
#[test]
fn points_move_step_by_step_if_asked() {
    let mut moves = 0;
    for seed in 0..20 {
        let data = data(DataKind::Uniform, 200, seed);
        let mut log = Log::new("c", data.clone());
        let options = Cover::new(6).divides_edges(false).stepwise(true);
        let watched = options.observe(data.iter().copied(), &mut log).unwrap();
        assert_eq!(watched, options.cover(data).unwrap());
        watched.verify(&()).unwrap().into_result().expect("a cover");
        let tried = log.steps.windows(2).filter(|pair| {
            let is_place = |event: Event| matches!(event, Event::PlaceTried { .. });
            is_place(pair[0].event) && is_place(pair[1].event)
        });
        moves += tried.count();
    }
    assert!(moves > 20, "{moves} moves");
}

#[test]
fn polygons_and_centers_can_be_had_alone() {
    let data = data(DataKind::Clusters, 500, 3);
    let polygon = outer_polygon(data.iter().copied(), 1.1).unwrap();
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        assert!(
            data.iter()
                .all(|p| orient2d(*a, *b, *p) != Orientation::Right)
        );
    }
    let centers = cluster_centers(data.iter().copied(), 7).unwrap();
    assert_eq!(centers.len(), 7);
    assert_eq!(
        cluster_centers([(1.0, 2.0); 5], 7).unwrap(),
        [Point::new(1.0, 2.0)]
    );
    assert_eq!(cluster_centers([(1.0, 2.0)], 0).unwrap(), []);
}
