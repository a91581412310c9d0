//! Pictures of clusters: points coloured by cluster, with the centers.
//!
//! Eight colours serve any number of clusters: neighbours, by the Delaunay triangulation of the centers, get
//! different ones. Six would be enough: whatever part of a planar graph is left, some vertex has at most five
//! neighbours there; such ones are taken away one after the other, and coloured in the opposite order.

use crate::picture::sheet::Sheet;
use crate::picture::{Color, INK, PAPER, Page, View, require_size};
use crate::plot::COLORS;
use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Error, Format, PictureOptions, Target, cancel, png, svg};
use delone::{Phase, Point, VertexId, Watch};
use std::path::PathBuf;

/// Points drawn between two looks at the watch.
const DOTS_PER_POLL: usize = 2048;

/// Most points that an SVG holds one by one.
const MAX_DOTS: usize = 200_000;

/// Clusters that are to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct ClustersView<'a> {
    /// The points.
    pub points: &'a [Point],
    /// The cluster of each point, an index of [`centers`](Self::centers).
    pub assignment: &'a [u32],
    /// The centers of the clusters.
    pub centers: &'a [Point],
}

/// Draws clusters to every target and returns the names of the files written.
///
/// ```
/// use delone_io::{ClustersView, PictureOptions, Target, write_clusters};
/// # let folder = tempfile::tempdir()?;
/// let points = [(0.0, 0.0), (0.0, 1.0), (5.0, 0.0)].map(Into::into);
/// let centers = [(0.0, 0.5), (5.0, 0.0)].map(Into::into);
/// let clusters = ClustersView { points: &points, assignment: &[0, 0, 1], centers: &centers };
/// let target = Target::from_arg(folder.path().join("clusters.svg"), None);
/// let written = write_clusters(&[target], &clusters, &PictureOptions::default(), &())?;
/// assert_eq!(written.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a point has no cluster or no center, a target is no `.svg` or `.png`, writing fails, or the watch cancels.
pub fn write_clusters(
    targets: &[Target],
    clusters: &ClustersView<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    clusters.validate()?;
    let mut staging = Staging::new((clusters.points.len() * targets.len()) as u64, watch);
    for target in targets {
        let format = target.format()?;
        if !format.is_picture() {
            return Err(unsupported(
                target,
                format,
                "show clusters",
                Format::is_picture,
            ));
        }
        staging.write(target.path.as_deref(), |out| {
            require_size(out.file(), options)?;
            let drawing = Drawing::new(clusters, options, watch)?;
            match format {
                Format::Svg => drawing.write_svg(out),
                _ => out.many_bytes(&drawing.pack(out.file(), true)?),
            }
        })?;
    }
    staging.commit()
}

impl ClustersView<'_> {
    fn validate(&self) -> Result<(), Error> {
        let [given, expected] = [self.assignment.len(), self.points.len()];
        if given != expected {
            return Err(Error::BadMesh(format!(
                "{given} clusters given for {expected} points"
            )));
        }
        let limit = self.centers.len();
        let is_wrong = |&cluster: &u32| cluster as usize >= limit;
        match self.assignment.iter().position(is_wrong) {
            Some(i) => Err(Error::BadMesh(format!(
                "point {i} is in cluster {} of {limit} (numbered from 0)",
                self.assignment[i]
            ))),
            None => Ok(()),
        }
    }
}

/// Clusters, with their places on the page and their colours.
struct Drawing<'a> {
    clusters: &'a ClustersView<'a>,
    watch: &'a dyn Watch,
    view: View,
    unit: f32,
    colors: Vec<Color>,
}

impl<'a> Drawing<'a> {
    fn new(
        clusters: &'a ClustersView<'a>,
        options: &PictureOptions,
        watch: &'a dyn Watch,
    ) -> Result<Self, Error> {
        let page = Page::new(options.size as f32, false);
        // Who brings centers of his own may have some beside the points.
        let all = [clusters.points, clusters.centers].concat();
        Ok(Self {
            clusters,
            watch,
            view: View::new(&all, &page),
            unit: page.unit,
            colors: colors(clusters.centers, watch)?,
        })
    }

    /// The share of the room of one of `n` things, in pixels, between two sizes.
    fn radius(&self, n: usize, share: f32, [least, most]: [f32; 2]) -> f32 {
        let spacing = (self.view.area() / n.max(1) as f32).sqrt() / self.unit;
        (spacing * share).clamp(least, most) * self.unit
    }

    /// Gives sheets full of points to `take`, one after the other.
    fn each_sheet(&self, mut take: impl FnMut(&Sheet) -> Result<(), Error>) -> Result<(), Error> {
        let ClustersView {
            points, assignment, ..
        } = self.clusters;
        let radius = self.radius(points.len(), 0.28, [0.6, 5.0]);
        let together = points.chunks(DOTS_PER_POLL);
        for (i, (points, clusters)) in together.zip(assignment.chunks(DOTS_PER_POLL)).enumerate() {
            let [done, total] = [i * DOTS_PER_POLL, self.clusters.points.len()];
            self.watch.progress(Phase::Draw, done as u64, total as u64);
            cancel::check(self.watch, 0)?;
            let mut sheet = Sheet::default();
            for (&p, &cluster) in points.iter().zip(clusters) {
                sheet.disc(self.view.place(p), radius, self.colors[cluster as usize]);
            }
            take(&sheet)?;
        }
        Ok(())
    }

    /// The centers, in rings.
    fn centers(&self) -> Sheet {
        let centers = self.clusters.centers;
        let radius = self.radius(centers.len(), 0.12, [1.8, 10.0]);
        let mut sheet = Sheet::default();
        for (&center, &color) in centers.iter().zip(&self.colors) {
            for (share, color) in [(1.0, INK), (0.8, PAPER), (0.5, color)] {
                sheet.disc(self.view.place(center), share * radius, color);
            }
        }
        sheet
    }

    fn write_svg(&self, out: &mut Output<'_>) -> Result<(), Error> {
        let [width, height] = self.view.page;
        let [points, centers] = [self.clusters.points.len(), self.clusters.centers.len()];
        out.text(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
             <title>{points} points in {centers} clusters</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
            PAPER.hex()
        ))?;
        let ink = INK.hex();
        if points > MAX_DOTS {
            let image = self.pack(out.file(), false)?;
            svg::write_pixels(out, self.view.page, &image)?;
        } else {
            self.each_sheet(|sheet| svg::write_sheet(out, sheet, &ink))?;
        }
        svg::write_sheet(out, &self.centers(), &ink)?;
        out.text(format_args!("</svg>\n"))
    }

    /// Draws pixels, and packs them.
    fn pack(&self, file: &str, shows_centers: bool) -> Result<Vec<u8>, Error> {
        let mut page = png::empty_page(self.view.page);
        self.each_sheet(|sheet| {
            png::draw_sheet(&mut page, sheet);
            Ok(())
        })?;
        if shows_centers {
            png::draw_sheet(&mut page, &self.centers());
        }
        png::pack(&page, file, || cancel::check(self.watch, 0))
    }
}

/// Chooses colours: for each center one that no neighbour has, beginning with another each time.
fn colors(centers: &[Point], watch: &dyn Watch) -> Result<Vec<Color>, Error> {
    // Where centers cannot be triangulated, they get colours in turn.
    let edges = match delone::Delaunay::new()
        .watch(watch)
        .triangulate(centers.iter().copied())
    {
        Ok(t) => t.edges().collect::<Vec<_>>(),
        Err(delone::Error::Cancelled) => return Err(Error::Cancelled),
        Err(_) => Vec::new(),
    };
    let mut neighbors = vec![Vec::new(); centers.len()];
    for [a, b] in edges
        .into_iter()
        .map(|edge: [VertexId; 2]| edge.map(VertexId::index))
    {
        neighbors[a].push(b);
        neighbors[b].push(a);
    }
    let mut chosen: Vec<Option<usize>> = vec![None; centers.len()];
    for i in taken_away(&neighbors).into_iter().rev() {
        let mut turns = (0..COLORS.len()).map(|k| (i + k) % COLORS.len());
        let is_free = |color: &usize| neighbors[i].iter().all(|&n| chosen[n] != Some(*color));
        chosen[i] = turns.find(is_free);
    }
    let color = |color: Option<usize>| COLORS[color.unwrap_or(0)];
    Ok(chosen.into_iter().map(color).collect())
}

/// Lists the vertices of a planar graph so that each has at most five neighbours among those after it.
fn taken_away(neighbors: &[Vec<usize>]) -> Vec<usize> {
    const FEW: usize = 5;
    let mut left: Vec<usize> = neighbors.iter().map(Vec::len).collect();
    let mut order: Vec<usize> = (0..left.len()).filter(|&i| left[i] <= FEW).collect();
    let mut next = 0;
    while let Some(&i) = order.get(next) {
        next += 1;
        for &n in &neighbors[i] {
            left[n] -= 1;
            // Who had few before is in the list already.
            if left[n] == FEW {
                order.push(n);
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_have_different_colors() {
        let centers: Vec<_> = (0..400)
            .map(|i| Point::new(f64::from(i * 37 % 101), f64::from(i * 53 % 97)))
            .collect();
        let colors = colors(&centers, &()).expect("not cancelled");
        let t = delone::triangulate(centers).expect("finite");
        assert!(
            t.edges()
                .all(|[a, b]| colors[a.index()] != colors[b.index()])
        );
    }

    #[test]
    fn points_without_cluster_are_refused() {
        let points = [Point::new(0.0, 0.0)];
        for (assignment, words) in [(&[][..], "0 clusters given"), (&[1], "in cluster 1 of 1")] {
            let clusters = ClustersView {
                points: &points,
                assignment,
                centers: &points,
            };
            let error = write_clusters(&[], &clusters, &PictureOptions::default(), &());
            let error = error.expect_err("no such cluster").to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
