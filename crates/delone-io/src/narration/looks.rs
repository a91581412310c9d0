//! Sentences about what is looked at, and found.

use super::parts::{Part, Sentence};
use delone::predicates::{CircleSide, Orientation};
use delone::{Event, Failure, Stage};

/// Tells of an event that changes nothing.
pub(super) fn sentence(event: Event) -> Option<Sentence> {
    use Part::{Edge, Item, Triangle, Vertex};
    match event {
        Event::PointConsidered { vertex } => Sentence::new(
            [
                "It is the turn of point {0}.",
                "Punkt {0} ist an der Reihe.",
            ],
            [Vertex(vertex)],
        ),
        Event::SegmentConsidered { segment } => Sentence::new(
            [
                "It is the turn of segment {0}.",
                "Strecke {0} ist an der Reihe.",
            ],
            [Edge(segment)],
        ),
        Event::TriangleConsidered { triangle } => Sentence::new(
            [
                "It is the turn of triangle {0}.",
                "Dreieck {0} ist an der Reihe.",
            ],
            [Triangle(triangle)],
        ),
        Event::EdgeExamined { edge } => Sentence::new(
            [
                "Is edge {0} locally Delaunay?",
                "Ist Kante {0} lokal Delaunay?",
            ],
            [Edge(edge)],
        ),
        Event::WalkStepped { edge } => Sentence::new(
            [
                "The walk steps over edge {0}.",
                "Der Weg führt über Kante {0}.",
            ],
            [Edge(edge)],
        ),
        Event::TriangleVisited { triangle } => Sentence::new(
            [
                "The search visits triangle {0}.",
                "Die Suche besucht Dreieck {0}.",
            ],
            [Triangle(triangle)],
        ),
        Event::PointLocated {
            vertex,
            at: Some(at),
        } => Sentence::new(
            ["Point {0} is found: {1}.", "Punkt {0} ist gefunden: {1}."],
            [Vertex(vertex), Item(at)],
        ),
        Event::PointLocated { vertex, at: None } => Sentence::new(
            ["Point {0} lies outside.", "Punkt {0} liegt außerhalb."],
            [Vertex(vertex)],
        ),
        Event::RayCast {
            ray: [from, to],
            is_visible,
        } => Sentence::new(ray(is_visible), [Vertex(from), Vertex(to)]),
        Event::OrientationTested {
            line,
            point,
            answer,
        } => Sentence::new(orientation(answer), [Vertex(point), Edge(line)]),
        Event::CircleTested {
            triangle,
            point,
            answer,
            is_inside,
        } => Sentence::new(
            circle(answer, is_inside),
            [Vertex(point), Triangle(triangle)],
        ),
        _ => tested(event)
            .or_else(|| refined(event))
            .or_else(|| covered(event)),
    }
}

/// What algorithms find out about sets and the whole.
fn tested(event: Event) -> Option<Sentence> {
    use Part::{Cut, Edge, Number, Triangle, Vertex};
    match event {
        Event::ConflictsCounted { conflicts } => Sentence::new(
            [
                "Pairs of a triangle and a point in its circle: {0}.",
                "Paare aus einem Dreieck und einem Punkt in seinem Kreis: {0}.",
            ],
            [Number(conflicts)],
        ),
        Event::InsideTested {
            triangle,
            is_inside: true,
            ..
        } => Sentence::new(
            [
                "Triangle {0} belongs to the domain.",
                "Dreieck {0} gehört zum Gebiet.",
            ],
            [Triangle(triangle)],
        ),
        Event::InsideTested {
            triangle,
            is_inside: false,
            ..
        } => Sentence::new(
            [
                "Triangle {0} lies outside of the domain.",
                "Dreieck {0} liegt außerhalb des Gebiets.",
            ],
            [Triangle(triangle)],
        ),
        Event::SetDivided { cut } => Sentence::new(
            [
                "The points are divided at {0}.",
                "Die Punkte werden geteilt bei {0}.",
            ],
            [Cut(cut)],
        ),
        Event::TangentFound { edge } => Sentence::new(
            [
                "The lower common tangent is {0}.",
                "Die untere gemeinsame Tangente ist {0}.",
            ],
            [Edge(edge)],
        ),
        Event::PrintFailed { failure } => failed(failure),
        Event::StageEnded { stage, .. } => Sentence::new(ended(stage), []),
        Event::TakenBack { from } => Sentence::new(
            [
                "This has come to no good end: all from vertex {0} on is taken back.",
                "Das hat kein gutes Ende: Alles ab Punkt {0} wird zurückgenommen.",
            ],
            [Vertex(from)],
        ),
        _ => None,
    }
}

/// What refinement looks at.
fn refined(event: Event) -> Option<Sentence> {
    use Part::{Edge, Point, Triangle, Vertex};
    match event {
        Event::Encroached { segment, by } => Sentence::new(
            [
                "Vertex {0} lies too close to segment {1}.",
                "Punkt {0} liegt zu nahe an Strecke {1}.",
            ],
            [Vertex(by), Edge(segment)],
        ),
        Event::SegmentSplit { edge, vertex } => Sentence::new(
            [
                "Edge {0} is divided at vertex {1}.",
                "Kante {0} wird in Punkt {1} geteilt.",
            ],
            [Edge(edge), Vertex(vertex)],
        ),
        Event::CircumcenterProposed { triangle, at } => Sentence::new(
            [
                "Triangle {0} is to be opened by a vertex in its circle, at {1}.",
                "Dreieck {0} soll durch einen Punkt in seinem Umkreis geöffnet werden, bei {1}.",
            ],
            [Triangle(triangle), Point(at)],
        ),
        Event::CircumcenterRejected { triangle, edge } => Sentence::new(
            [
                "The vertex in the circle of {0} is rejected: edge {1} is divided instead.",
                "Der Punkt im Umkreis von {0} wird verworfen: Stattdessen wird Kante {1} geteilt.",
            ],
            [Triangle(triangle), Edge(edge)],
        ),
        _ => None,
    }
}

/// What algorithms that cover data look at.
fn covered(event: Event) -> Option<Sentence> {
    use Part::{Counts, Cut, Edge, Number, Point, Triangle};
    match event {
        Event::ClusterSplit {
            clusters: [old, new],
            cut,
        } => Sentence::new(
            [
                "Cluster {0} falls into two, {1} is new: cut at {2}.",
                "Cluster {0} zerfällt in zwei, {1} ist neu: geteilt bei {2}.",
            ],
            [Number(old.into()), Number(new.into()), Cut(cut)],
        ),
        Event::CoverAccepted { triangles } => Sentence::new(
            [
                "Each of {0} triangles holds enough data.",
                "Jedes von {0} Dreiecken enthält genug Daten.",
            ],
            [Number(triangles.into())],
        ),
        Event::CoverRejected { triangle, data } => Sentence::new(
            [
                "Triangle {0} holds too few data: {1}.",
                "Dreieck {0} enthält zu wenige Daten: {1}.",
            ],
            [Triangle(triangle), Number(data.into())],
        ),
        Event::OuterReduced { edge: Some(edge) } => Sentence::new(
            [
                "Edge {0} of the outer polygon shrinks to a point.",
                "Kante {0} des äußeren Polygons schrumpft auf einen Punkt.",
            ],
            [Edge(edge)],
        ),
        Event::OuterReduced { edge: None } => Sentence::new(
            [
                "The outer polygon becomes a triangle.",
                "Das äußere Polygon wird zum Dreieck.",
            ],
            [],
        ),
        Event::PlaceTried { at, counts } => Sentence::new(
            [
                "A vertex is tried at {0}: the triangles would hold {1} data.",
                "Ein Punkt wird bei {0} versucht: Die Dreiecke enthielten {1} Daten.",
            ],
            [Point(at), Counts(counts)],
        ),
        Event::DivisionFailed { triangle } => Sentence::new(
            [
                "No vertex divides triangle {0}.",
                "Kein Punkt teilt Dreieck {0}.",
            ],
            [Triangle(triangle)],
        ),
        _ => None,
    }
}

fn ray(is_visible: bool) -> [&'static str; 2] {
    match is_visible {
        true => ["Vertex {0} sees vertex {1}.", "Punkt {0} sieht Punkt {1}."],
        false => [
            "Vertex {0} does not see vertex {1}.",
            "Punkt {0} sieht Punkt {1} nicht.",
        ],
    }
}

fn orientation(answer: Orientation) -> [&'static str; 2] {
    match answer {
        Orientation::Left => [
            "Vertex {0} lies to the left of {1}.",
            "Punkt {0} liegt links von {1}.",
        ],
        Orientation::Right => [
            "Vertex {0} lies to the right of {1}.",
            "Punkt {0} liegt rechts von {1}.",
        ],
        Orientation::Collinear => [
            "Vertex {0} lies on the line {1}.",
            "Punkt {0} liegt auf der Geraden {1}.",
        ],
    }
}

fn circle(answer: CircleSide, is_inside: bool) -> [&'static str; 2] {
    match (answer, is_inside) {
        (CircleSide::Inside, _) => [
            "Vertex {0} lies inside the circle of {1}.",
            "Punkt {0} liegt im Umkreis von {1}.",
        ],
        (CircleSide::Outside, _) => [
            "Vertex {0} lies outside the circle of {1}.",
            "Punkt {0} liegt außerhalb des Umkreises von {1}.",
        ],
        (CircleSide::On, true) => [
            "Vertex {0} lies on the circle of {1}: a tie, which counts as inside.",
            "Punkt {0} liegt auf dem Umkreis von {1}: ein Patt, das als innen zählt.",
        ],
        (CircleSide::On, false) => [
            "Vertex {0} lies on the circle of {1}: a tie, which counts as outside.",
            "Punkt {0} liegt auf dem Umkreis von {1}: ein Patt, das als außen zählt.",
        ],
    }
}

fn failed(failure: Failure) -> Option<Sentence> {
    use Part::{Edge, Triangle, Vertex};
    match failure {
        Failure::SeesNothing(v) => Sentence::new(
            [
                "The print fails: vertex {0} sees nothing of the front, and is left out.",
                "Der Druck versagt: Punkt {0} sieht nichts von der Front und bleibt weg.",
            ],
            [Vertex(v)],
        ),
        Failure::SeesOne(v) => Sentence::new(
            [
                "The print fails: vertex {0} sees one vertex only, a spike.",
                "Der Druck versagt: Punkt {0} sieht nur einen Punkt, ein Stachel.",
            ],
            [Vertex(v)],
        ),
        Failure::SeesSeveralRuns(v) => Sentence::new(
            [
                "The print fails: vertex {0} sees several runs of the front.",
                "Der Druck versagt: Punkt {0} sieht mehrere Stücke der Front.",
            ],
            [Vertex(v)],
        ),
        Failure::SegmentLost(segment) => Sentence::new(
            [
                "The print fails: segment {0} is lost.",
                "Der Druck versagt: Strecke {0} geht verloren.",
            ],
            [Edge(segment)],
        ),
        Failure::Overlaps(triangle) => Sentence::new(
            [
                "The print fails: triangle {0} lies upon others, and is left out.",
                "Der Druck versagt: Dreieck {0} liegt auf anderen und bleibt weg.",
            ],
            [Triangle(triangle)],
        ),
        _ => Sentence::new(["The print fails.", "Der Druck versagt."], []),
    }
}

fn ended(stage: Stage) -> [&'static str; 2] {
    match stage {
        Stage::Triangulation => [
            "Done: the points are triangulated.",
            "Fertig: Die Punkte sind trianguliert.",
        ],
        Stage::SplitEdges => [
            "Done: segments are divided.",
            "Fertig: Die Strecken sind geteilt.",
        ],
        Stage::Sweep => ["Done: the sweep.", "Fertig: der Sweep."],
        Stage::StripHelpers => [
            "Done: helper points are removed.",
            "Fertig: Die Hilfspunkte sind entfernt.",
        ],
        Stage::InsertSegments => [
            "Done: segments are inserted.",
            "Fertig: Die Strecken sind eingefügt.",
        ],
        Stage::InsideTest => [
            "Done: the domain is cut out.",
            "Fertig: Das Gebiet ist ausgeschnitten.",
        ],
        Stage::Flips => ["Done: flips.", "Fertig: Es ist genug gekippt."],
        Stage::Lattice => [
            "Done: a lattice of vertices is sown.",
            "Fertig: Ein Gitter von Punkten ist gesät.",
        ],
        Stage::Refinement => [
            "Done: nothing bad is left that can be made better.",
            "Fertig: Nichts Schlechtes ist übrig, das sich bessern ließe.",
        ],
        Stage::Smoothing => [
            "Done: vertices have moved to better places.",
            "Fertig: Die Punkte sind an bessere Stellen gerückt.",
        ],
        Stage::ShortenEdges => [
            "Done: long edges are bisected.",
            "Fertig: Lange Kanten sind halbiert.",
        ],
        Stage::OpenTriangles => [
            "Done: skinny triangles are opened.",
            "Fertig: Spitze Dreiecke sind geöffnet.",
        ],
        Stage::Repair => ["Done: repairs.", "Fertig: die Reparatur."],
        Stage::OuterPolygon => [
            "Done: the outer polygon surrounds the data.",
            "Fertig: Das äußere Polygon umschließt die Daten.",
        ],
        Stage::Clusters => [
            "Done: centers of clusters are added.",
            "Fertig: Die Mitten der Cluster sind hinzugefügt.",
        ],
        Stage::DivideEdges => [
            "Done: vertices are put on edges.",
            "Fertig: Auf die Kanten sind Punkte gesetzt.",
        ],
        Stage::DivideTriangles => [
            "Done: vertices are put into triangles.",
            "Fertig: In die Dreiecke sind Punkte gesetzt.",
        ],
        _ => ["Done: a stage.", "Fertig: ein Abschnitt."],
    }
}
