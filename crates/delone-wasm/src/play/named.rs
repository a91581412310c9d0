//! What an event names: vertices, edges and triangles, whatever it says of them.

use delone::{Event, Failure, Item, VertexId};

/// No event names more.
const MOST: usize = 3;

/// Lists what an event names. Places that are no vertices are not among it.
pub(super) fn items(event: &Event) -> impl Iterator<Item = Item> {
    changed(event).into_iter().flatten()
}

/// Tells whether an item is a vertex or has it as an end or a corner.
pub(super) fn has_vertex(item: Item, v: VertexId) -> bool {
    match item {
        Item::Vertex(w) => w == v,
        Item::Edge(ends) => ends.contains(&v),
        Item::Triangle(corners) => corners.contains(&v),
    }
}

/// Tells whether an item is an edge, whichever way it runs.
pub(super) fn is_edge(item: Item, [a, b]: [VertexId; 2]) -> bool {
    item == Item::Edge([a, b]) || item == Item::Edge([b, a])
}

type Items = [Option<Item>; MOST];

fn one(item: Item) -> Items {
    [Some(item), None, None]
}

fn two(first: Item, second: Item) -> Items {
    [Some(first), Some(second), None]
}

fn changed(event: &Event) -> Items {
    use Item::{Edge, Triangle, Vertex};
    match *event {
        Event::VertexCreated { vertex, .. }
        | Event::VertexDeleted { vertex, .. }
        | Event::VertexMoved { vertex, .. }
        | Event::FrontEntered { vertex, .. }
        | Event::FrontLeft { vertex, .. } => one(Vertex(vertex)),
        Event::EdgeCreated { edge }
        | Event::EdgeDeleted { edge }
        | Event::EdgeLocked { edge }
        | Event::EdgeUnlocked { edge } => one(Edge(edge)),
        Event::TriangleCreated { triangle } | Event::TriangleDeleted { triangle } => {
            one(Triangle(triangle))
        }
        Event::EdgeFlipped { from, to } => two(Edge(from), Edge(to)),
        Event::Pushed { item, .. } | Event::Popped { item, .. } => one(item),
        Event::DatumReassigned { datum, from, to } => {
            [Some(Vertex(datum)), from.map(Triangle), to.map(Triangle)]
        }
        _ => looked_at(event),
    }
}

fn looked_at(event: &Event) -> Items {
    use Item::{Edge, Triangle, Vertex};
    match *event {
        Event::PointConsidered { vertex } => one(Vertex(vertex)),
        Event::SegmentConsidered { segment: edge }
        | Event::EdgeExamined { edge }
        | Event::WalkStepped { edge }
        | Event::RayCast { ray: edge, .. }
        | Event::TangentFound { edge } => one(Edge(edge)),
        Event::TriangleConsidered { triangle }
        | Event::TriangleVisited { triangle }
        | Event::InsideTested { triangle, .. } => one(Triangle(triangle)),
        Event::PointLocated { vertex, at } => [Some(Vertex(vertex)), at, None],
        Event::OrientationTested { line, point, .. } => two(Edge(line), Vertex(point)),
        Event::CircleTested {
            triangle, point, ..
        } => two(Triangle(triangle), Vertex(point)),
        _ => judged(event),
    }
}

fn judged(event: &Event) -> Items {
    use Item::{Edge, Triangle, Vertex};
    match *event {
        Event::Encroached { segment, by } => two(Edge(segment), Vertex(by)),
        Event::SegmentSplit { edge, vertex } => two(Edge(edge), Vertex(vertex)),
        Event::CircumcenterProposed { triangle, .. }
        | Event::CoverRejected { triangle, .. }
        | Event::DivisionFailed { triangle } => one(Triangle(triangle)),
        Event::CircumcenterRejected { triangle, edge } => two(Triangle(triangle), Edge(edge)),
        Event::OuterReduced { edge } => [edge.map(Edge), None, None],
        Event::TakenBack { from } => one(Vertex(from)),
        Event::PrintFailed { failure } => match failure {
            Failure::SeesNothing(v) | Failure::SeesOne(v) | Failure::SeesSeveralRuns(v) => {
                one(Vertex(v))
            }
            Failure::SegmentLost(segment) => one(Edge(segment)),
            Failure::Overlaps(triangle) => one(Triangle(triangle)),
            _ => [None; MOST],
        },
        _ => [None; MOST],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use crate::play::Player;
    use delone::classic::Algorithm;
    use serde_json::Value;

    /// Lists the whole numbers of an event as it is written, but those that are no vertices.
    fn written(value: &Value, vertices: &mut Vec<u64>) {
        const OTHERS: [&str; 9] = [
            "place",
            "after",
            "cluster",
            "clusters",
            "conflicts",
            "crossings",
            "triangles",
            "data",
            "counts",
        ];
        match value {
            Value::Number(number) => vertices.extend(number.as_u64()),
            Value::Array(list) => list.iter().for_each(|value| written(value, vertices)),
            Value::Object(fields) => {
                let fields = fields.iter().filter(|(key, _)| !OTHERS.contains(&&key[..]));
                fields.for_each(|(_, value)| written(value, vertices));
            }
            _ => {}
        }
    }

    #[test]
    fn every_vertex_that_an_event_writes_is_named() {
        for algorithm in Algorithm::ALL {
            let name = algorithm.about().name;
            let preset = match name {
                "thesis" | "sweep" | "printed-sweep" => "thesis",
                _ => "uniform",
            };
            let drawing = Drawing::preset(preset, 30, 1).expect("a preset");
            let player = Player::run(name, &drawing, None, None).expect(name);
            for step in player.steps() {
                let mut expected = Vec::new();
                let value = serde_json::to_value(step.event).expect("JSON");
                written(&value, &mut expected);
                let named = items(&step.event).flat_map(|item| match item {
                    Item::Vertex(v) => vec![v],
                    Item::Edge(ends) => ends.to_vec(),
                    Item::Triangle(corners) => corners.to_vec(),
                });
                let mut named: Vec<u64> = named.map(|v| v.index() as u64).collect();
                named.sort_unstable();
                expected.sort_unstable();
                assert_eq!(named, expected, "{name}: {value}");
            }
        }
    }
}
