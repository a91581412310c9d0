//! Pictures: any mesh gives one, of the right size, and cancelling leaves nothing.

use delone::{DomainRule, Point, Pslg, Region, VertexId, triangulate};
use delone_io::{
    Constraints, Counts, DomainData, Error, Format, MeshView, PictureOptions, Target, WriteOptions,
    write_domain, write_mesh,
};
use std::path::Path;

fn options(size: u32) -> WriteOptions {
    WriteOptions {
        picture: PictureOptions {
            size,
            ..PictureOptions::default()
        },
        ..WriteOptions::default()
    }
}

/// Draws a triangulation of points as PNG and SVG, and returns both.
fn draw(points: &[(f64, f64)], size: u32) -> (Vec<u8>, String) {
    let folder = tempfile::tempdir().expect("folder");
    let t = triangulate(points.iter().copied().map(Point::from).collect::<Vec<_>>())
        .expect("finite points");
    let files = ["a.png", "a.svg"].map(|name| folder.path().join(name));
    let targets = files.clone().map(|file| Target::from_arg(file, None));
    write_mesh(&targets, &MeshView::from(&t), &options(size), &()).expect("pictures");
    let read = |file: &Path| std::fs::read(file).expect("written");
    (
        read(&files[0]),
        String::from_utf8(read(&files[1])).expect("text"),
    )
}

/// Decodes a PNG to its size and its pixels.
fn decode(png: &[u8]) -> ([u32; 2], Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(png).read_info().expect("a picture");
    let mut bytes = vec![0; reader.output_buffer_size()];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    let pixels = bytes.as_chunks::<3>().0.to_vec();
    ([info.width, info.height], pixels)
}

#[test]
fn the_hull_of_slivers_is_drawn() {
    let (_, svg) = draw(&[(0.0, 0.0), (1000.0, 0.0), (500.0, 0.5)], 400);
    assert!(svg.contains("stroke-opacity"), "{svg}");
}

#[test]
fn every_point_set_can_be_drawn() {
    let huge = f64::MAX;
    let sets: [&[(f64, f64)]; 9] = [
        &[],
        &[(1.0, 2.0)],
        &[(1.0, 2.0), (1.0, 2.0)],
        &[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)],
        &[(0.0, 0.0), (0.0, 1e-300), (0.0, -3.0)],
        &[(huge, huge), (-huge, huge), (0.0, -huge), (1e-300, 5e-324)],
        &[(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324)],
        &[
            (500_000.1, 5_500_000.1),
            (500_000.2, 5_500_000.1),
            (500_000.1, 5_500_000.2),
        ],
        &[(0.0, 0.0), (1e300, 1e-300), (1e-300, 1e300)],
    ];
    for set in sets {
        let (png, svg) = draw(set, 200);
        let ([width, height], pixels) = decode(&png);
        assert!(width.max(height) <= 201, "{width} x {height}");
        let inked = pixels.iter().any(|&p| p != [255; 3]);
        assert_eq!(inked, !set.is_empty(), "{set:?}");
        assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}

#[test]
fn a_triangle_has_the_colour_of_its_angle_and_lies_where_it_should() {
    // The right angle is at the lower left, y up.
    let ([width, height], pixels) = decode(&draw(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)], 400).0);
    let at = |x: f64, y: f64| {
        pixels[((y * f64::from(height)) as u32 * width + (x * f64::from(width)) as u32) as usize]
    };
    let [r, g, b] = at(0.2, 0.7);
    assert!(g > r && g > b, "45° is green, found {:?}", [r, g, b]);
    assert_eq!(at(0.6, 0.2), [255; 3]);
}

#[test]
fn svg_of_many_triangles_is_a_picture_of_pixels() {
    let grid: Vec<_> = (0..120_000)
        .map(|i| (f64::from(i % 400), f64::from(i / 400)))
        .collect();
    let (_, svg) = draw(&grid, 300);
    assert!(svg.contains("data:image/png;base64,"));
    assert!(svg.len() < 2_000_000, "{} bytes", svg.len());
}

#[test]
fn sizes_out_of_range_are_refused() {
    let t = triangulate([(0.0, 0.0)]).expect("finite points");
    let folder = tempfile::tempdir().expect("folder");
    let target = Target::from_arg(folder.path().join("picture"), Some(Format::Png));
    let outcome = write_mesh(&[target], &MeshView::from(&t), &options(1 << 20), &());
    assert!(matches!(outcome, Err(Error::Picture { .. })), "{outcome:?}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0);
}

/// Two triangles in regions of their own, a hole beside them and a line beyond it.
fn regions() -> (Vec<Point>, Vec<[VertexId; 3]>, Constraints) {
    let points = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (0.0, 4.0),
        (8.0, 0.0),
        (8.0, 4.0),
    ];
    let triangles = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::new));
    let region = |at| Region {
        at: Point::from(at),
        attribute: 1e9,
        max_area: None,
    };
    let constraints = Constraints {
        edges: [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [4, 5]]
            .map(|e| e.map(VertexId::new))
            .to_vec(),
        regions: vec![region((3.0, 1.0)), region((1.0, 3.0))],
        region_of: Some(vec![Some(0), Some(1)]),
        crossings: 5..6,
        ..Constraints::default()
    };
    (
        points.map(Point::from).to_vec(),
        triangles.to_vec(),
        constraints,
    )
}

#[test]
fn regions_have_bands_and_holes_stay_paper() {
    let (points, triangles, constraints) = regions();
    let mesh = MeshView::new(&points, &triangles).with_constraints(&constraints);
    let folder = tempfile::tempdir().expect("folder");
    let files = ["a.png", "a.svg"].map(|name| folder.path().join(name));
    let targets = files.clone().map(|file| Target::from_arg(file, None));
    let options = WriteOptions {
        picture: PictureOptions {
            size: 800,
            legend: false,
        },
        ..WriteOptions::default()
    };
    write_mesh(&targets, &mesh, &options, &()).expect("pictures");
    let ([width, _], pixels) = decode(&std::fs::read(&files[0]).expect("written"));
    // The drawing is 8 wide and 4 high, within a margin of 28 pixels.
    let per_unit = f64::from(width - 56) / 8.0;
    let at = |x: f64, y: f64| {
        let [x, y] = [x, 4.0 - y].map(|v| (28.0 + v * per_unit) as u32);
        pixels[(y * width + x) as usize]
    };
    let inside = 5.0 / per_unit;
    let [r, g, b] = at(2.0, inside);
    assert!(r > g && r > b, "the first region is red at its border");
    let [r, g, b] = at(2.0, 4.0 - inside);
    assert!(b > r && g > r, "the second region is blue at its border");
    assert_eq!(at(2.0, 1.0), at(1.0, 2.0), "within, angles alone count");
    assert_eq!(at(6.0, 2.0), [255; 3], "the hole");
    let [r, g, b] = at(8.0, 2.0);
    assert!(r < 40 && g < 40 && b < 50, "the line beyond");
    let svg = std::fs::read_to_string(&files[1]).expect("written");
    assert_eq!(svg.matches("<clipPath").count(), 2, "{svg}");
}

#[test]
fn the_legend_names_regions_by_their_attributes() {
    let (points, triangles, constraints) = regions();
    let folder = tempfile::tempdir().expect("folder");
    let draw = |mesh: &MeshView<'_>| {
        let file = folder.path().join("a.svg");
        let target = Target::from_arg(&file, None);
        write_mesh(&[target], mesh, &options(400), &()).expect("a picture");
        std::fs::read_to_string(file).expect("written")
    };
    let bare = draw(&MeshView::new(&points, &triangles));
    let full = draw(&MeshView::new(&points, &triangles).with_constraints(&constraints));
    let rectangles = |svg: &str| svg.matches("<rect").count();
    assert_eq!(
        rectangles(&full),
        rectangles(&bare) + 3,
        "a line, two areas"
    );
    assert!(!full.contains("NaN"), "{full}");
}

#[test]
fn a_domain_can_be_drawn_before_it_has_triangles() {
    let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]);
    pslg.add_ring([0u32, 1, 2]);
    let domain = DomainData::from(pslg);
    assert_eq!(domain.usual_rule, DomainRule::Carve);
    let folder = tempfile::tempdir().expect("folder");
    let files = ["a.png", "a.svg"].map(|name| folder.path().join(name));
    let targets = files.clone().map(|file| Target::from_arg(file, None));
    write_domain(&targets, &domain, &options(200), &()).expect("pictures");
    let (_, pixels) = decode(&std::fs::read(&files[0]).expect("written"));
    assert!(pixels.iter().any(|&p| p != [255; 3]));
    let svg = std::fs::read_to_string(&files[1]).expect("written");
    assert!(svg.contains("stroke-width"), "{svg}");
}

/// A square of two triangles, with data on one of its diagonals, and what each triangle is said to hold.
fn draw_counts(held: &[usize]) -> Result<(Vec<[u8; 3]>, String), Error> {
    let points = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)].map(Point::from);
    let triangles = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::new));
    let data: Vec<_> = (1..9)
        .map(|i| Point::new(f64::from(i), 9.0 - f64::from(i)))
        .collect();
    let counts = Counts {
        held,
        range: [2, 5],
        data: &data,
    };
    let mesh = MeshView::new(&points, &triangles).with_counts(&counts);
    let folder = tempfile::tempdir().expect("folder");
    let files = ["a.png", "a.svg"].map(|name| folder.path().join(name));
    let targets = files.clone().map(|file| Target::from_arg(file, None));
    write_mesh(&targets, &mesh, &options(600), &())?;
    let [png, svg] = files.map(|file| std::fs::read(file).expect("written"));
    Ok((decode(&png).1, String::from_utf8(svg).expect("text")))
}

#[test]
fn counts_are_shown_in_place_of_angles() {
    let is_red = |p: &[u8; 3]| p[0] > 200 && p[1] < 90 && p[2] < 80;
    let (few, svg) = draw_counts(&[2, 5]).expect("pictures");
    assert!(!few.iter().any(is_red), "none holds too many");
    assert!(svg.contains("<title>2 triangles that hold 8 data</title>"));
    let (many, svg) = draw_counts(&[2, 6]).expect("pictures");
    let red = many.iter().filter(|p| is_red(p)).count();
    assert!(red > many.len() / 10, "half of the square: {red}");
    assert!(svg.contains("fill=\"#e84"), "{svg}");
    let (same, _) = draw_counts(&[2, 2]).expect("pictures");
    assert_ne!(few, same);
    assert!(few != many, "one more is another colour");
}

#[test]
fn counts_that_do_not_fit_are_refused() {
    for held in [&[][..], &[3], &[3, 4, 5]] {
        let error = draw_counts(held).expect_err("two triangles").to_string();
        assert!(error.contains("for 2"), "{error}");
    }
}
