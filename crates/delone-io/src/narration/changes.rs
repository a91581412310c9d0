//! Sentences about what changes the scene.

use super::parts::{Part, Sentence};
use delone::{Event, Queue};

/// Tells of an event that changes something.
pub(super) fn sentence(event: Event) -> Option<Sentence> {
    use Part::{Edge, Number, Sweep, Triangle, Vertex};
    match event {
        Event::VertexCreated { vertex, at } => Sentence::new(
            [
                "Vertex {0} is added at {1}.",
                "Punkt {0} kommt bei {1} hinzu.",
            ],
            [Vertex(vertex), Part::Point(at)],
        ),
        Event::VertexDeleted { vertex, .. } => Sentence::new(
            ["Vertex {0} is removed.", "Punkt {0} wird entfernt."],
            [Vertex(vertex)],
        ),
        Event::VertexMoved { vertex, to, .. } => Sentence::new(
            ["Vertex {0} moves to {1}.", "Punkt {0} wandert nach {1}."],
            [Vertex(vertex), Part::Point(to)],
        ),
        Event::EdgeCreated { edge } => Sentence::new(
            ["Edge {0} is created.", "Kante {0} entsteht."],
            [Edge(edge)],
        ),
        Event::EdgeDeleted { edge } => Sentence::new(
            ["Edge {0} is deleted.", "Kante {0} wird gelöscht."],
            [Edge(edge)],
        ),
        Event::EdgeLocked { edge } => Sentence::new(
            [
                "Edge {0} becomes a constraint: it must stay.",
                "Kante {0} wird fest: Sie muss bleiben.",
            ],
            [Edge(edge)],
        ),
        Event::EdgeUnlocked { edge } => Sentence::new(
            [
                "Edge {0} is no constraint any more.",
                "Kante {0} ist nicht mehr fest.",
            ],
            [Edge(edge)],
        ),
        Event::TriangleCreated { triangle } => Sentence::new(
            ["Triangle {0} is created.", "Dreieck {0} entsteht."],
            [Triangle(triangle)],
        ),
        Event::TriangleDeleted { triangle } => Sentence::new(
            ["Triangle {0} is deleted.", "Dreieck {0} wird gelöscht."],
            [Triangle(triangle)],
        ),
        Event::EdgeFlipped { from, to } => Sentence::new(
            [
                "Edge {0} is flipped: {1} takes its place.",
                "Kante {0} wird gekippt: {1} tritt an ihre Stelle.",
            ],
            [Edge(from), Edge(to)],
        ),
        Event::FrontEntered { vertex, .. } => Sentence::new(
            [
                "Vertex {0} enters the front.",
                "Punkt {0} kommt in die Front.",
            ],
            [Vertex(vertex)],
        ),
        Event::FrontLeft { vertex, .. } => Sentence::new(
            [
                "Vertex {0} leaves the front.",
                "Punkt {0} verlässt die Front.",
            ],
            [Vertex(vertex)],
        ),
        Event::SweptTo { to: Some(to), .. } => Sentence::new(
            ["The sweep goes on to {0}.", "Der Sweep rückt vor bis {0}."],
            [Sweep(to)],
        ),
        Event::SweptTo { to: None, .. } => {
            Sentence::new(["The sweep is over.", "Der Sweep ist zu Ende."], [])
        }
        Event::Pushed { queue, item } => Sentence::new(pushed(queue), [Part::Item(item)]),
        Event::Popped { queue, item } => Sentence::new(popped(queue), [Part::Item(item)]),
        Event::DatumReassigned {
            datum,
            to: Some(to),
            ..
        } => Sentence::new(
            [
                "Datum {0} now counts for triangle {1}.",
                "Datenpunkt {0} zählt nun zu Dreieck {1}.",
            ],
            [Vertex(datum), Triangle(to)],
        ),
        Event::DatumReassigned {
            datum, to: None, ..
        } => Sentence::new(
            [
                "Datum {0} counts for no triangle now.",
                "Datenpunkt {0} zählt nun zu keinem Dreieck.",
            ],
            [Vertex(datum)],
        ),
        Event::ClusterMoved {
            cluster,
            to: Some(to),
            ..
        } => Sentence::new(
            [
                "The center of cluster {0} is now {1}.",
                "Die Mitte von Cluster {0} ist nun {1}.",
            ],
            [Number(cluster.into()), Part::Point(to)],
        ),
        Event::ClusterMoved {
            cluster, to: None, ..
        } => Sentence::new(
            ["Cluster {0} disappears.", "Cluster {0} verschwindet."],
            [Number(cluster.into())],
        ),
        _ => None,
    }
}

fn pushed(queue: Queue) -> [&'static str; 2] {
    match queue {
        Queue::Suspects => ["Now {0} is suspect.", "Nun ist verdächtig: {0}."],
        Queue::Search => ["The search will come to {0}.", "Die Suche merkt sich: {0}."],
        Queue::Cavity => [
            "In conflict with the new point: {0}.",
            "Im Konflikt mit dem neuen Punkt: {0}.",
        ],
        Queue::Events => [
            "An event is expected: {0}.",
            "Ein Ereignis wird erwartet: {0}.",
        ],
        Queue::Crossings => [
            "The segment is crossed by {0}.",
            "Die Strecke wird gekreuzt: {0}.",
        ],
        _ => ["Begins to wait: {0}.", "Wartet nun: {0}."],
    }
}

fn popped(queue: Queue) -> [&'static str; 2] {
    match queue {
        Queue::Suspects => ["The next suspect is {0}.", "Als Nächstes verdächtig: {0}."],
        Queue::Search => [
            "The search goes on with {0}.",
            "Die Suche geht weiter: {0}.",
        ],
        Queue::Cavity => [
            "The next in conflict is {0}.",
            "Als Nächstes im Konflikt: {0}.",
        ],
        Queue::Events => [
            "An expected event is due: {0}.",
            "Ein erwartetes Ereignis ist an der Reihe: {0}.",
        ],
        Queue::Crossings => ["The next to cross is {0}.", "Als Nächstes kreuzt: {0}."],
        _ => ["Waits no more: {0}.", "Wartet nicht mehr: {0}."],
    }
}
