//! What is lost on writing, said before it is.

use delone_io::{Attribute, DomainData, Format, MeshView, PointSet, Precision, Target, Trait};

/// What there is to be written, by what a format may have no place for.
pub(super) struct Held<'a> {
    attributes: &'a [Attribute],
    markers: bool,
    segments: bool,
    segment_markers: bool,
    holes: bool,
    regions: bool,
    triangle_regions: bool,
    triangle_attributes: &'a [Attribute],
    /// Whether there are triangles, which show holes and regions themselves.
    is_mesh: bool,
}

impl<'a> Held<'a> {
    pub fn by_points(points: &'a PointSet) -> Self {
        Self {
            attributes: &points.attributes,
            markers: points.markers.is_some(),
            segments: false,
            segment_markers: false,
            holes: false,
            regions: false,
            triangle_regions: false,
            triangle_attributes: &[],
            is_mesh: false,
        }
    }

    pub fn by_domain(domain: &'a DomainData) -> Self {
        Self {
            segments: !domain.segments.is_empty(),
            segment_markers: domain.segment_markers.is_some(),
            holes: !domain.holes.is_empty(),
            regions: !domain.regions.is_empty(),
            ..Self::by_points(&domain.vertices)
        }
    }

    pub fn by_mesh(mesh: &MeshView<'a>) -> Self {
        let constraints = mesh.constraints;
        let segments = constraints.is_some_and(|c| !c.edges.is_empty());
        let regions = constraints.and_then(|c| c.region_of.as_ref());
        Self {
            attributes: mesh.attributes,
            markers: mesh.markers.is_some(),
            segments,
            segment_markers: segments && constraints.is_some_and(|c| c.markers.is_some()),
            holes: false,
            regions: false,
            triangle_regions: regions.is_some_and(|of| of.iter().any(Option::is_some)),
            triangle_attributes: mesh.triangle_attributes,
            is_mesh: true,
        }
    }

    /// Says in words what a target has no place for, if it is a stream `alone`, without the files of its family.
    pub fn losses(&self, target: &Target, alone: bool, ascii: bool) -> Vec<String> {
        let Ok(format) = target.format() else {
            return Vec::new();
        };
        let Some(keeps) = format.keeps() else {
            return Vec::new();
        };
        let precision = keeps.coordinates;
        // Nobody takes a picture, or a file of edges, for the data.
        let is_shown = precision == Precision::Picture;
        if is_shown || matches!(format, Format::Edge | Format::Neigh) {
            return Vec::new();
        }
        let of_file = |what| !alone || !self.is_mesh || is_in_file(format, what);
        let lost = self.all_without(|what| keeps.keeps(what) && of_file(what));
        let mut notes = Vec::new();
        if !lost.is_empty() {
            let lost = lost.join(", ");
            notes.push(format!(
                "{target}: left out, for {format} has no place: {lost}"
            ));
        }
        // Text has room for every digit.
        if precision == Precision::Floats && !ascii {
            notes.push(format!(
                "{target}: coordinates are rounded to 32 bits, as {format} has them"
            ));
        }
        notes
    }

    /// Names all that is there and not kept.
    fn all_without(&self, keeps: impl Fn(Trait) -> bool) -> Vec<String> {
        let mut lost = Vec::new();
        let mut lose = |is_there: bool, what: Trait, words: &str| {
            if is_there && !keeps(what) {
                lost.push(words.to_owned());
            }
        };
        lose(self.markers, Trait::PointMarkers, "boundary markers");
        for Attribute { name, .. } in self.attributes {
            let what = if name == "z" {
                Trait::Z
            } else {
                Trait::PointAttributes
            };
            lose(true, what, &format!("attribute {name}"));
        }
        lose(self.segments, Trait::Segments, "segments");
        let are_kept = keeps(Trait::Segments);
        lose(
            self.segment_markers && are_kept,
            Trait::SegmentMarkers,
            "markers of segments",
        );
        lose(self.holes, Trait::Holes, "holes");
        lose(self.regions, Trait::Regions, "regions");
        // The attribute of its region tells it, too.
        let told = keeps(Trait::TriangleAttributes) && !self.triangle_attributes.is_empty();
        lose(
            self.triangle_regions && !told,
            Trait::TriangleRegions,
            "regions of triangles",
        );
        for Attribute { name, .. } in self.triangle_attributes {
            let is_region = name == "region" && keeps(Trait::TriangleRegions);
            lose(
                !is_region,
                Trait::TriangleAttributes,
                &format!("attribute {name} of triangles"),
            );
        }
        lost
    }
}

/// Tells whether the one file of a family that goes to a stream has something.
fn is_in_file(format: Format, what: Trait) -> bool {
    let of_points = [Trait::Z, Trait::PointAttributes, Trait::PointMarkers];
    match format {
        Format::Node => of_points.contains(&what),
        Format::Ele => what == Trait::TriangleAttributes,
        Format::Npy | Format::Parquet => false,
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::{Point, VertexId};
    use delone_io::{Constraints, MeshData};

    fn notes(name: &str, held: &Held<'_>) -> Vec<String> {
        held.losses(&Target::from_arg(name, None), false, false)
    }

    #[test]
    fn what_has_no_place_is_named() {
        let one = |name: &str| Attribute {
            name: name.to_owned(),
            values: vec![1.0; 3],
        };
        let set = PointSet {
            points: vec![Point::new(0.0, 0.0); 3],
            attributes: ["z", "heat"].map(one).to_vec(),
            markers: Some(vec![1; 3]),
            ..PointSet::default()
        };
        let points = Held::by_points(&set);
        assert!(notes("a.ply", &points).is_empty());
        assert!(notes("a.csv", &points).is_empty());
        assert_eq!(
            notes("a.off", &points),
            ["a.off: left out, for off has no place: boundary markers, attribute heat"]
        );
        let domain = DomainData {
            segments: vec![[0, 1].map(VertexId::new)],
            holes: vec![Point::new(0.0, 0.0)],
            ..DomainData::from(set.clone())
        };
        assert_eq!(
            notes("a.obj", &Held::by_domain(&domain)),
            ["a.obj: left out, for obj has no place: boundary markers, attribute heat, holes"]
        );
        let graph = Constraints {
            edges: domain.segments.clone(),
            markers: Some(vec![7]),
            region_of: Some(vec![Some(0)]),
            ..Constraints::default()
        };
        let mesh = MeshData {
            vertices: PointSet {
                points: set.points,
                ..PointSet::default()
            },
            triangles: vec![[0, 1, 2].map(VertexId::new)],
            triangle_attributes: vec![one("kind")],
            constraints: Some(graph),
            quadratic: false,
        };
        let mesh = MeshView::from(&mesh);
        let mesh = Held::by_mesh(&mesh);
        assert!(notes("a.ele", &mesh).is_empty());
        assert!(notes("a.svg", &mesh).is_empty());
        assert_eq!(
            notes("a.stl", &mesh),
            [
                "a.stl: left out, for stl has no place: segments, regions of triangles, attribute kind of triangles",
                "a.stl: coordinates are rounded to 32 bits, as stl has them"
            ]
        );
        let stream = Target::from_arg("-", Some(Format::Npy));
        assert_eq!(
            mesh.losses(&stream, true, false),
            [
                "-: left out, for npy has no place: segments, regions of triangles, attribute kind of triangles"
            ]
        );
    }
}
