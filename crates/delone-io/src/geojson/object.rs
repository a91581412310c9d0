//! The objects of GeoJSON: members in any order, checked against the type at the end.

use super::tree::{Pulse, Tree, TreeSeed};
use crate::Problem;
use crate::shapes::Shapes;
use delone::Watch;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// What has been read so far.
pub(super) struct Reader<'w> {
    shapes: Shapes,
    pulse: Pulse<'w>,
    /// Index of the feature that is being read, if the file is a collection.
    feature: Option<usize>,
}

impl<'w> Reader<'w> {
    pub fn new(watch: &'w dyn Watch) -> Self {
        Self {
            shapes: Shapes::default(),
            pulse: Pulse::new(watch),
            feature: None,
        }
    }

    /// Returns the index of the feature that is being read.
    pub fn feature(&self) -> Option<usize> {
        self.feature
    }

    /// Returns what is filled, and what looks at the watch, for readers of other objects.
    pub fn parts(&mut self) -> (&mut Shapes, &Pulse<'w>) {
        (&mut self.shapes, &self.pulse)
    }

    pub fn into_shapes(self) -> Shapes {
        self.shapes
    }
}

/// Where an object stands, hence what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// It is the whole file.
    Root,
    /// It is one of a collection of features.
    Feature,
    /// It is the geometry of a feature, or one of a collection of geometries.
    Geometry,
}

/// The types of objects.
const KINDS: [(&str, Kind); 9] = [
    ("FeatureCollection", Kind::FeatureCollection),
    ("Feature", Kind::Feature),
    ("GeometryCollection", Kind::GeometryCollection),
    ("Point", Kind::Point),
    ("MultiPoint", Kind::MultiPoint),
    ("LineString", Kind::LineString),
    ("MultiLineString", Kind::MultiLineString),
    ("Polygon", Kind::Polygon),
    ("MultiPolygon", Kind::MultiPolygon),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    FeatureCollection,
    Feature,
    GeometryCollection,
    Point,
    MultiPoint,
    LineString,
    MultiLineString,
    Polygon,
    MultiPolygon,
}

impl Kind {
    fn from_name(name: &str) -> Result<Self, Problem> {
        let known = KINDS.iter().find(|(known, _)| *known == name);
        known
            .map(|&(_, kind)| kind)
            .ok_or_else(|| Problem::Other(format!("type {name:?} is none of GeoJSON's")))
    }

    /// Returns the member that an object of this type has, and no other has.
    fn member(self) -> &'static str {
        match self {
            Self::FeatureCollection => "features",
            Self::Feature => "geometry",
            Self::GeometryCollection => "geometries",
            _ => "coordinates",
        }
    }

    fn fits(self, role: Role) -> bool {
        match self {
            Self::FeatureCollection => role == Role::Root,
            Self::Feature => role != Role::Geometry,
            _ => role != Role::Feature,
        }
    }
}

/// Reads an object and adds its geometries.
pub(super) struct ObjectSeed<'r, 'w> {
    pub reader: &'r mut Reader<'w>,
    pub role: Role,
}

/// The members of an object that matter.
#[derive(Default)]
struct Members {
    kind: Option<Kind>,
    coordinates: Option<Tree>,
    /// The marker among the properties.
    marker: Option<i32>,
    /// The one of [`Kind::member`]'s names that was there.
    content: Option<&'static str>,
}

impl Members {
    /// Notes the one member that holds what the object is about.
    fn note(&mut self, name: &'static str) -> Result<(), Problem> {
        match self.content.replace(name) {
            None => Ok(()),
            Some(other) => Err(Problem::Other(format!(
                "an object with the members {other:?} and {name:?}"
            ))),
        }
    }
}

impl<'de> DeserializeSeed<'de> for ObjectSeed<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for ObjectSeed<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    /// A feature may have the geometry null.
    fn visit_unit<E: Error>(self) -> Result<(), E> {
        match self.role {
            Role::Geometry => Ok(()),
            _ => Err(E::custom("null where an object should be")),
        }
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<(), A::Error> {
        let mut members = Members::default();
        while let Some(key) = map.next_key::<String>()? {
            self.member(&key, &mut members, &mut map)?;
        }
        self.end(members).map_err(A::Error::custom)
    }
}

impl<'w> ObjectSeed<'_, 'w> {
    /// Reads the value of one member.
    fn member<'de, A: MapAccess<'de>>(
        &mut self,
        key: &str,
        members: &mut Members,
        map: &mut A,
    ) -> Result<(), A::Error> {
        let mut note = |name| members.note(name).map_err(A::Error::custom);
        match key {
            "type" => {
                let name = map.next_value::<String>()?;
                members.kind = Some(Kind::from_name(&name).map_err(A::Error::custom)?);
            }
            "coordinates" => {
                note("coordinates")?;
                members.coordinates = Some(map.next_value_seed(TreeSeed(&self.reader.pulse))?);
            }
            "geometry" => {
                note("geometry")?;
                map.next_value_seed(self.within(Role::Geometry))?;
            }
            "geometries" => {
                note("geometries")?;
                map.next_value_seed(ListSeed(self.within(Role::Geometry)))?;
            }
            "features" => {
                note("features")?;
                map.next_value_seed(ListSeed(self.within(Role::Feature)))?;
            }
            "properties" => members.marker = map.next_value_seed(PropertiesSeed)?,
            _ => drop(map.next_value::<IgnoredAny>()?),
        }
        Ok(())
    }

    /// Makes the seed of an object within this one.
    fn within(&mut self, role: Role) -> ObjectSeed<'_, 'w> {
        let reader = &mut *self.reader;
        ObjectSeed { reader, role }
    }

    /// Checks that the members go together, and adds the geometry.
    fn end(self, members: Members) -> Result<(), Problem> {
        let problem = |text: String| Err(Problem::Other(text));
        let Some(kind) = members.kind else {
            return problem("an object without the member \"type\"".to_owned());
        };
        if !kind.fits(self.role) {
            return problem(format!("a {kind:?} does not belong here"));
        }
        match members.content {
            Some(name) if name != kind.member() => {
                return problem(format!("a {kind:?} has no member {name:?}"));
            }
            None if kind != Kind::Feature => {
                let name = kind.member();
                return problem(format!("a {kind:?} needs the member {name:?}"));
            }
            _ => {}
        }
        let shapes = &mut self.reader.shapes;
        if let Some(coordinates) = members.coordinates {
            add(shapes, kind, coordinates)?;
        }
        let is_whole = self.role == Role::Root && kind != Kind::FeatureCollection;
        if kind == Kind::Feature || is_whole {
            shapes.end_feature(members.marker);
        }
        Ok(())
    }
}

/// Adds a geometry.
fn add(shapes: &mut Shapes, kind: Kind, coordinates: Tree) -> Result<(), Problem> {
    match kind {
        Kind::Point => match coordinates {
            Tree::List(list) if list.is_empty() => Ok(()),
            position => shapes.point(position.into_position()?),
        },
        Kind::MultiPoint => {
            let mut points = coordinates.into_line()?.into_iter();
            points.try_for_each(|position| shapes.point(position))
        }
        Kind::LineString => shapes.line(&coordinates.into_line()?),
        Kind::MultiLineString => {
            let mut lines = coordinates.into_list()?.into_iter();
            lines.try_for_each(|line| shapes.line(&line.into_line()?))
        }
        Kind::Polygon => add_polygon(shapes, coordinates),
        Kind::MultiPolygon => {
            let mut polygons = coordinates.into_list()?.into_iter();
            polygons.try_for_each(|polygon| add_polygon(shapes, polygon))
        }
        Kind::FeatureCollection | Kind::Feature | Kind::GeometryCollection => Ok(()),
    }
}

fn add_polygon(shapes: &mut Shapes, rings: Tree) -> Result<(), Problem> {
    let rings = rings.into_list()?.into_iter().map(Tree::into_line);
    let rings: Vec<_> = rings.collect::<Result<_, _>>()?;
    shapes.polygon(rings.iter().map(Vec::as_slice))
}

/// Reads an array of objects.
struct ListSeed<'r, 'w>(ObjectSeed<'r, 'w>);

impl<'de> DeserializeSeed<'de> for ListSeed<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for ListSeed<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of objects")
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut seq: A) -> Result<(), A::Error> {
        let role = self.0.role;
        for index in 0.. {
            self.0.reader.pulse.beat().map_err(A::Error::custom)?;
            if role == Role::Feature {
                self.0.reader.feature = Some(index);
            }
            if seq.next_element_seed(self.0.within(role))?.is_none() {
                break;
            }
        }
        if role == Role::Feature {
            self.0.reader.feature = None;
        }
        Ok(())
    }
}

/// Reads properties and returns the marker among them.
struct PropertiesSeed;

impl<'de> DeserializeSeed<'de> for PropertiesSeed {
    type Value = Option<i32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<i32>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for PropertiesSeed {
    type Value = Option<i32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object or null")
    }

    fn visit_unit<E>(self) -> Result<Option<i32>, E> {
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Option<i32>, A::Error> {
        let mut marker = None;
        while let Some(key) = map.next_key::<String>()? {
            if key == "marker" {
                let value = map.next_value::<serde_json::Value>()?;
                marker = value.as_i64().and_then(|value| i32::try_from(value).ok());
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(marker)
    }
}
