//! Drawings to begin with: those of `delone sample`, by the same names.

use crate::Trouble;
use delone::Region;
use delone_io::DomainData;
use delone_samples::{Distribution, Domain, Scene};
use serde::Serialize;

/// More points or segments would fill the memory of a page.
const MOST: u32 = 2_000_000;

/// Segments that cross each other nearly all: so many make half a million crossings.
const MOST_CROSSING: u32 = 2_000;

/// What there is to say of a preset.
#[derive(Serialize)]
pub(super) struct Preset {
    name: &'static str,
    about: &'static str,
    kind: &'static str,
    /// Whether there may be any number of points or segments.
    sized: bool,
}

/// Lists all presets.
pub(super) fn list() -> Vec<Preset> {
    let preset = |kind, sized| {
        move |(name, about)| Preset {
            name,
            about,
            kind,
            sized,
        }
    };
    let points = Distribution::ALL.map(|d| (d.name(), d.about()));
    let scenes = Scene::ALL.map(|s| (s.name(), s.about()));
    let domains = Domain::ALL.map(|d| (d.name(), d.about()));
    let points = points.into_iter().map(preset("points", true));
    let scenes = scenes.into_iter().map(preset("scene", false));
    let domains = domains.into_iter().map(preset("domain", true));
    points.chain(scenes).chain(domains).collect()
}

/// Draws the preset of a name.
pub(super) fn draw(name: &str, count: u32, seed: u32) -> Result<DomainData, Trouble> {
    if let Ok(points) = name.parse::<Distribution>() {
        let points = points.points(limited(count, MOST)?, seed.into());
        return Ok(DomainData::from_rows(points, Vec::new(), Vec::new())?);
    }
    if let Ok(scene) = name.parse::<Scene>() {
        return scenery(scene);
    }
    let Ok(domain) = name.parse::<Domain>() else {
        let known: Vec<_> = list().iter().map(|preset| preset.name).collect();
        let known = known.join(", ");
        let message = format!("no preset is called {name:?}; there are {known}");
        return Err(Trouble::asked(message));
    };
    let most = match domain {
        Domain::CrossingSegments => MOST_CROSSING,
        _ => MOST,
    };
    let drawing = domain.draw(limited(count, most)?, seed.into());
    let (points, segments) = (drawing.points, drawing.segments);
    Ok(DomainData::from_rows(points, segments, drawing.holes)?)
}

fn scenery(scene: Scene) -> Result<DomainData, Trouble> {
    let sheet = scene.draw();
    let region = |(at, attribute): ([f64; 2], f64)| Region {
        at: at.into(),
        attribute,
        max_area: None,
    };
    Ok(DomainData {
        segment_markers: (!sheet.markers.is_empty()).then_some(sheet.markers),
        regions: sheet.regions.into_iter().map(region).collect(),
        ..DomainData::from_rows(sheet.points, sheet.segments, sheet.holes)?
    })
}

fn limited(count: u32, most: u32) -> Result<usize, Trouble> {
    match count <= most {
        true => Ok(count as usize),
        false => Err(Trouble::asked(format!(
            "{count} are too many: at most {most} fit here"
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_can_be_drawn() {
        for preset in list() {
            let drawn = draw(preset.name, 50, 1).expect(preset.name);
            assert!(!drawn.vertices.points.is_empty(), "{}", preset.name);
        }
        let unknown = draw("pond", 50, 1).expect_err("no such preset").to_string();
        assert!(unknown.contains("pond") && unknown.contains("lake"));
        draw("uniform", u32::MAX, 1).expect_err("too many");
    }
}
