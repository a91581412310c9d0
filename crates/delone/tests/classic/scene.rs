//! Scenes: every event and its reverse, misfits, and seeking in the logs of real runs.

use crate::suite::run;
use delone::classic::{Algorithm, Input, Takes};
use delone::{Cut, Event, Item, Point, Queue, Scene, Sweep, VertexId, hash_triangles};
use delone_testkit::generate::{Kind, Random};
use proptest::prelude::*;

fn v<const N: usize>(numbers: [usize; N]) -> [VertexId; N] {
    numbers.map(VertexId::new)
}

/// Two triangles on a square, one of whose vertices is still to come.
fn square() -> (Vec<Event>, Scene) {
    let at = Point::new(1.0, 1.0);
    let [vertex] = v([3]);
    let edges = [[0, 1], [1, 2], [2, 0], [1, 3], [3, 2]].map(v);
    let triangles = [[0, 1, 2], [1, 3, 2]].map(v);
    let mut events = vec![Event::VertexCreated { vertex, at }];
    events.extend(edges.map(|edge| Event::EdgeCreated { edge }));
    events.extend(triangles.map(|triangle| Event::TriangleCreated { triangle }));
    (events, Scene::new([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]))
}

/// Every event that changes a scene, in an order in which they can happen.
fn all_changes() -> (Vec<Event>, Scene) {
    let (mut events, scene) = square();
    let (queue, item) = (Queue::Suspects, Item::Edge(v([1, 2])));
    let [vertex, other] = v([0, 1]);
    let enter = |place, vertex, after| Event::FrontEntered {
        place,
        vertex,
        after,
    };
    let [first, second] = [Point::new(0.5, 0.5), Point::new(0.25, 0.75)];
    let circle = Sweep::Circle {
        center: first,
        radius: 1.0,
    };
    events.extend([
        Event::EdgeFlipped {
            from: v([1, 2]),
            to: v([0, 3]),
        },
        Event::EdgeLocked { edge: v([0, 3]) },
        enter(7, vertex, None),
        enter(4, other, Some(7)),
        enter(5, vertex, Some(7)),
        Event::FrontLeft {
            place: 7,
            vertex,
            after: None,
        },
        Event::SweptTo {
            from: None,
            to: Some(Sweep::Vertical(0.5)),
        },
        Event::SweptTo {
            from: Some(Sweep::Vertical(0.5)),
            to: Some(circle),
        },
        Event::Pushed { queue, item },
        Event::Pushed { queue, item },
        Event::Popped { queue, item },
        Event::DatumReassigned {
            datum: vertex,
            from: None,
            to: Some(v([0, 1, 3])),
        },
        Event::DatumReassigned {
            datum: vertex,
            from: Some(v([0, 1, 3])),
            to: Some(v([0, 3, 2])),
        },
        Event::ClusterMoved {
            cluster: 0,
            from: None,
            to: Some(first),
        },
        Event::ClusterSplit {
            clusters: [0, 1],
            cut: Cut::Vertical(0.5),
        },
        Event::ClusterMoved {
            cluster: 0,
            from: Some(first),
            to: Some(second),
        },
        Event::EdgeUnlocked { edge: v([0, 3]) },
        Event::TriangleDeleted {
            triangle: v([0, 1, 3]),
        },
        Event::TriangleDeleted {
            triangle: v([3, 2, 0]),
        },
        Event::EdgeDeleted { edge: v([3, 2]) },
        Event::EdgeDeleted { edge: v([3, 1]) },
        Event::EdgeDeleted { edge: v([3, 0]) },
        Event::VertexMoved {
            vertex: VertexId::new(3),
            from: Point::new(1.0, 1.0),
            to: second,
        },
        Event::CoverRejected {
            triangle: v([0, 1, 2]),
            data: 2,
        },
        Event::OuterReduced {
            edge: Some(v([0, 1])),
        },
        Event::OuterReduced { edge: None },
        Event::CoverAccepted { triangles: 1 },
        Event::PlaceTried {
            at: first,
            counts: [3, 4, 0, 0],
        },
        Event::DivisionFailed {
            triangle: v([0, 1, 2]),
        },
        Event::VertexDeleted {
            vertex: VertexId::new(3),
            at: second,
        },
    ]);
    (events, scene)
}

#[test]
fn every_change_has_a_reverse_that_undoes_it() {
    let (events, mut scene) = all_changes();
    let mut scenes = vec![scene.clone()];
    for &event in &events {
        assert_eq!(event.reversed().reversed(), event);
        scene.apply(event).expect("in order");
        let changes = scene != scenes[scenes.len() - 1];
        assert_eq!(changes, event.changes_scene(), "{event:?}");
        scenes.push(scene.clone());
    }
    for event in events.into_iter().rev() {
        assert!(Some(&scene) == scenes.last());
        scene.revert(event).expect("in reverse order");
        scenes.pop();
    }
    assert!(Some(&scene) == scenes.last());
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let (events, mut scene) = all_changes();
    let mut refused = 0;
    for i in 0..events.len() {
        for event in events.iter().flat_map(|e| [*e, e.reversed()]) {
            let before = scene.clone();
            if scene.apply(event).is_err() {
                refused += 1;
                assert!(
                    scene == before,
                    "{event:?} was refused and has changed something"
                );
            } else {
                scene.revert(event).expect("just applied");
                assert!(scene == before, "{event:?} is not undone");
            }
        }
        scene.apply(events[i]).expect("in order");
    }
    assert!(refused > events.len());
}

#[test]
fn a_vertex_moves_only_while_nothing_hangs_on_it() {
    let mut scene = Scene::new([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let [from, to] = [Point::new(1.0, 0.0), Point::new(2.0, 0.0)];
    let there = Event::VertexMoved {
        vertex: VertexId::new(1),
        from,
        to,
    };
    for edge in [[0, 1], [1, 0], [1, 2]].map(v) {
        scene.apply(Event::EdgeCreated { edge }).expect("two ends");
        scene.apply(there).expect_err("the edge would move");
        scene.apply(Event::EdgeDeleted { edge }).expect("an edge");
    }
    scene
        .apply(there.reversed())
        .expect_err("it lies elsewhere");
    scene.apply(there).expect("free");
    assert_eq!(scene.point(VertexId::new(1)), Some(to));
    scene.revert(there).expect("still free");
    assert_eq!(scene.point(VertexId::new(1)), Some(from));
}

#[test]
fn a_vertex_goes_only_while_nothing_hangs_on_it() {
    let mut scene = Scene::new([(0.0, 0.0), (1.0, 0.0)]);
    let last = Event::VertexDeleted {
        vertex: VertexId::new(1),
        at: Point::new(1.0, 0.0),
    };
    let [edge] = [[0, 1]].map(v);
    scene.apply(Event::EdgeCreated { edge }).expect("two ends");
    let before = scene.clone();
    scene.apply(last).expect_err("the edge would have one end");
    assert!(scene == before);
    scene.apply(Event::EdgeDeleted { edge }).expect("an edge");
    scene.apply(last).expect("free");
}

/// So that a log which is no algorithm's cannot ask for more memory than it has steps.
#[test]
fn vertices_come_and_go_in_their_order() {
    let mut scene = Scene::new([(0.0, 0.0), (1.0, 0.0)]);
    let at = Point::new(2.0, 0.0);
    let before = scene.clone();
    for number in [0, 1, 3, u32::MAX as usize - 1] {
        let vertex = VertexId::new(number);
        let refused = scene.apply(Event::VertexCreated { vertex, at });
        refused.expect_err("the next one is 2");
    }
    let first = Event::VertexDeleted {
        vertex: VertexId::new(0),
        at: Point::new(0.0, 0.0),
    };
    scene.apply(first).expect_err("the last one is 1");
    assert!(scene == before);
}

#[test]
fn a_flip_is_that_of_the_mesh() {
    let (events, mut scene) = square();
    for event in events {
        scene.apply(event).expect("in order");
    }
    let before = scene.clone();
    let [from, to] = [v([1, 2]), v([3, 0])];
    let flip = Event::EdgeFlipped { from, to };
    scene.apply(flip).expect("two triangles");
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(Point::from);
    let corners = [[0, 1, 3], [0, 3, 2]].map(|t| t.map(|i: usize| points[i]));
    assert_eq!(scene.hash(), hash_triangles(corners));
    scene.revert(flip).expect("flipped before");
    assert!(scene == before);
    scene
        .apply(Event::EdgeLocked { edge: from })
        .expect("an edge");
    scene.apply(flip).expect_err("it is locked");
}

#[test]
fn a_circle_is_drawn_only_of_a_triangle() {
    let scene = Scene::new([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0), (4.0, 0.0)]);
    assert_eq!(
        scene.circle(v([0, 1, 2])),
        Some((Point::new(1.0, 1.0), 2f64.sqrt()))
    );
    assert_eq!(scene.circle(v([0, 1, 3])), None);
    assert_eq!(scene.circle(v([0, 1, 9])), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Whoever seeks in a log, however he goes there, sees the same.
    #[test]
    fn seeking_is_the_same_from_everywhere(
        kind in 0..Kind::ALL.len(),
        n in 0..25usize,
        algorithm in 0..Algorithm::ALL.len(),
        seed in any::<u64>(),
    ) {
        let algorithm = Algorithm::ALL[algorithm];
        let about = algorithm.about();
        prop_assume!(about.takes != Takes::Data);
        prop_assume!(about.takes != Takes::Domain || !about.is_delaunay);
        let input = Input::from_points(Kind::ALL[kind].points(n, seed));
        let (_, log) = run(algorithm, &input);
        let mut random = Random::new(seed);
        let (mut scene, mut at) = (log.first_scene(), 0);
        for _ in 0..6 {
            let goal = random.below(log.steps.len() + 1);
            while at < goal {
                scene.apply(log.steps[at].event).expect("forwards");
                at += 1;
            }
            while at > goal {
                at -= 1;
                scene.revert(log.steps[at].event).expect("backwards");
            }
            let mut straight = log.first_scene();
            for step in &log.steps[..goal] {
                straight.apply(step.event).expect("forwards");
            }
            prop_assert!(scene == straight, "{} at step {goal}", about.name);
        }
    }
}
