//! A picture of Voronoi cells: coloured by their areas, with the sites as dots.
//!
//! A cell as large as the mean of all has the middle of the scale; one a quarter, or four times, as large,
//! a fifth of it, or four fifths. Outlines fade out when cells are only a few pixels wide.

use super::sheet::{Anchor, Sheet};
use super::view::{Page, View};
use super::{CLASSES, Color, INK, ITEMS_PER_POLL, legend, require_size, scale};
use crate::{CellsView, Error, PictureOptions, cancel};
use delone::{Phase, VertexId, Watch};

/// Widths of cells, in pixels at the usual size, at which outlines begin to be seen, and are in full.
const FADE: [f32; 2] = [5.0, 24.0];

/// Steps of the scale in the legend.
const STEPS: usize = 60;

/// Everything that is to be drawn, in pixels.
pub(crate) struct CellScene<'a> {
    cells: &'a CellsView<'a>,
    watch: &'a dyn Watch,
    pub file: &'a str,
    pub view: View,
    /// Size of a detail that should look alike at any size of the picture.
    pub unit: f32,
    legend: bool,
    mean_area: f64,
    number: usize,
}

impl<'a> CellScene<'a> {
    /// Lays the picture out. `file` is named in errors.
    pub fn new(
        file: &'a str,
        cells: &'a CellsView<'a>,
        options: &PictureOptions,
        watch: &'a dyn Watch,
    ) -> Result<Self, Error> {
        require_size(file, options)?;
        let corners = cells.parts().flat_map(|(_, part)| part.outline());
        let points: Vec<_> = corners.copied().collect();
        let number = cells.sites().count();
        let areas = cells.sites().map(|v| cells.clipped.measure(v).area);
        // Divided first, so that no sum overflows.
        let mean_area = areas.map(|area| area / number as f64).sum();
        let legend = options.legend && number > 0;
        let page = Page::new(options.size as f32, legend);
        Ok(Self {
            cells,
            watch,
            file,
            view: View::new(&points, &page),
            unit: page.unit,
            legend,
            mean_area,
            number,
        })
    }

    pub fn number(&self) -> usize {
        self.number
    }

    /// Fails if cancelled.
    pub fn check(&self) -> Result<(), Error> {
        cancel::check(self.watch, 0)
    }

    /// Gives each part of a cell, its outline counter-clockwise and its holes clockwise, in pixels, with
    /// its class of colour to `take`.
    pub fn each_part(
        &self,
        mut take: impl FnMut(&[Vec<[f32; 2]>], usize) -> Result<(), Error>,
    ) -> Result<(), Error> {
        for (i, site) in self.cells.sites().enumerate() {
            if i.is_multiple_of(ITEMS_PER_POLL) {
                let total = self.number as u64;
                self.watch.progress(Phase::Draw, i as u64, total);
                self.check()?;
            }
            let class = self.class(site);
            for part in self.cells.clipped.parts(site) {
                let place =
                    |ring: &[delone::Point]| ring.iter().map(|&p| self.view.place(p)).collect();
                let rings: Vec<Vec<_>> = part.rings().map(place).collect();
                take(&rings, class)?;
            }
        }
        Ok(())
    }

    fn class(&self, site: VertexId) -> usize {
        let area = self.cells.clipped.measure(site).area;
        let share = share(area / self.mean_area);
        ((share * CLASSES as f32) as usize).min(CLASSES - 1)
    }

    /// Returns the width and opacity of outlines, if they are to be seen.
    pub fn outline(&self) -> Option<(f32, f32)> {
        let strength = (self.spacing() - FADE[0]) / (FADE[1] - FADE[0]);
        let strength = strength.min(1.0);
        (strength > 0.0).then_some((self.unit * (0.6 + strength), 0.85 * strength))
    }

    /// Returns the sites in pixels and the radius of their dots, if there is room for dots. Sites outside
    /// of the picture are left out.
    pub fn dots(&self) -> Option<(Vec<[f32; 2]>, f32)> {
        let radius = (0.07 * self.spacing()).min(4.5);
        let dots = self.cells.sites().filter_map(|v| {
            let p = self.cells.site(v);
            self.view.holds(p).then(|| self.view.place(p))
        });
        (radius >= 1.3).then(|| (dots.collect(), radius * self.unit))
    }

    /// About how wide a cell is, in pixels of the usual size.
    fn spacing(&self) -> f32 {
        (self.view.area() / self.number.max(1) as f32).sqrt() / self.unit
    }

    /// Lays out the scale of colours beside the drawing, if it is asked for.
    pub fn legend(&self) -> Option<Sheet> {
        self.legend.then(|| {
            let mut sheet = Sheet::default();
            let [corner, extent] = self.view.drawing;
            let unit = self.unit;
            let height = extent[1].min(420.0 * unit);
            let left = corner[0] + extent[0] + 88.0 * unit;
            let top = corner[1] + (extent[1] - height) / 2.0;
            let at = |share: f32| top + height * (1.0 - share);
            for step in (0..STEPS).rev() {
                let color = color_of((step * CLASSES + CLASSES / 2) / STEPS);
                let y = at((step + 1) as f32 / STEPS as f32);
                // Down to the foot, so that the next colour covers it and no seam can show.
                sheet.bar([left, y], [16.0 * unit, at(0.0) - y], color);
            }
            for (text, ratio) in [
                ("1/4", 0.25),
                ("1/2", 0.5),
                ("1", 1.0),
                ("2", 2.0),
                ("4", 4.0),
            ] {
                let y = at(share(ratio));
                let tick = [[left - 8.0 * unit, y], [left - 2.0 * unit, y]];
                sheet.line(tick, 1.6 * unit, INK, 1.0);
                let end = [left - 12.0 * unit, y + 3.5 * legend::TEXT * unit];
                sheet.text(text, end, legend::TEXT * unit, Anchor::End, INK);
            }
            let title = legend::title_baselines(top, unit);
            for (text, y) in ["area over", "its mean"].into_iter().zip(title) {
                let start = [left - 40.0 * unit, y];
                sheet.text(text, start, legend::TEXT * unit, Anchor::Start, INK);
            }
            sheet
        })
    }
}

/// Returns the place on the scale of an area of so many times the mean.
fn share(ratio: f64) -> f32 {
    (ratio / (1.0 + ratio)) as f32
}

/// Returns the colour of a class.
pub(crate) fn color_of(class: usize) -> Color {
    scale((class as f32 + 0.5) / CLASSES as f32)
}
