//! Voronoi cells as files hold them.

use delone::voronoi::{Clipped, Domain, Voronoi};
use delone::{Point, Pslg, VertexId};
use delone_io::{
    Attribute, CellsView, Error, PictureOptions, PointSet, ReadOptions, Source, Target,
    WriteOptions, read_domain, write_cells,
};
use std::fs;
use std::path::Path;

/// Four sites, one of them twice, in a frame with a hole: two cells are cut in parts.
fn sample() -> (Voronoi, Domain, PointSet) {
    let points: Vec<Point> = [(1.0, 1.0), (7.0, 1.0), (4.0, 7.0), (1.0, 1.0), (4.0, 20.0)]
        .map(Point::from)
        .to_vec();
    let t = delone::triangulate(points.iter().copied()).expect("finite points");
    let voronoi = Voronoi::new(&t, &()).expect("nobody cancels");
    let rings = [
        (0.0, 0.0),
        (8.0, 0.0),
        (8.0, 8.0),
        (0.0, 8.0),
        (0.5, 1.5),
        (1.5, 1.5),
        (1.0, 2.5),
    ];
    let mut frame = Pslg::from_points(rings);
    frame.add_ring([0, 1, 2, 3]);
    frame.add_ring([4, 5, 6]);
    let domain = Domain::polygon(frame, &()).expect("rings");
    let data = PointSet {
        attributes: vec![Attribute {
            name: "depth \"m\"".to_owned(),
            values: vec![1.5, f64::NAN, 2.0, 3.0, 4.0],
        }],
        markers: Some(vec![7, 8, 9, 7, 0]),
        points,
        ..PointSet::default()
    };
    (voronoi, domain, data)
}

fn write(clipped: &Clipped<'_>, data: &PointSet, path: &Path, options: &WriteOptions) {
    let cells = CellsView::new(clipped).with_data(data);
    let targets = [Target::from_arg(path, None)];
    let written = write_cells(&targets, &cells, options, &()).expect("a folder");
    assert_eq!(written, [path]);
}

#[test]
fn geojson_has_a_feature_for_each_cell() {
    let (voronoi, domain, data) = sample();
    let clipped = voronoi.clip(&domain, &()).expect("nobody cancels");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cells.geojson");
    let options = WriteOptions {
        one_based: true,
        ..WriteOptions::default()
    };
    write(&clipped, &data, &path, &options);
    let text = fs::read_to_string(&path).expect("a file");
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let features = json["features"].as_array().expect("features");
    // The far site has no cell here, the duplicate none of its own.
    assert_eq!(features.len(), 3);
    for (feature, v) in features.iter().zip([0, 1, 2]) {
        let properties = &feature["properties"];
        assert_eq!(properties["site"], v + 1);
        let area = clipped.measure(VertexId::new(v)).area;
        assert_eq!(properties["area"].as_f64(), Some(area));
        assert_eq!(
            properties["marker"],
            data.markers.as_ref().expect("some")[v]
        );
        let depth = Some(data.attributes[0].values[v]).filter(|depth| depth.is_finite());
        assert_eq!(properties["depth \"m\""].as_f64(), depth);
    }
    assert_eq!(
        features[0]["geometry"]["coordinates"]
            .as_array()
            .map(Vec::len),
        Some(2)
    );
    // Read again, the polygons cover the domain.
    let source = Source::from_arg(&path);
    let mut read = read_domain(&source, &ReadOptions::default(), &()).expect("GeoJSON");
    let again = Domain::polygon(read.take_pslg(), &()).expect("rings");
    assert!((again.measure().area - domain.measure().area).abs() < 1e-12);
}

/// A swallowtail: the two tips are the parts of one cell.
#[test]
fn geojson_has_several_polygons_for_a_cell_in_parts() {
    let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0)]).expect("finite points");
    let voronoi = Voronoi::new(&t, &()).expect("nobody cancels");
    let corners = [(0.0, 0.0), (3.0, 0.0), (1.0, 1.0), (3.0, 2.0), (0.0, 2.0)];
    let mut zigzag = Pslg::from_points(corners);
    zigzag.add_ring(0..5);
    let domain = Domain::polygon(zigzag, &()).expect("a ring");
    let clipped = voronoi.clip(&domain, &()).expect("nobody cancels");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cells.json");
    write(
        &clipped,
        &PointSet {
            points: vec![Point::default(); 2],
            ..PointSet::default()
        },
        &path,
        &WriteOptions::default(),
    );
    let text = fs::read_to_string(&path).expect("a file");
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let kinds = [0, 1].map(|i| json["features"][i]["geometry"]["type"].clone());
    assert_eq!(kinds, ["Polygon", "MultiPolygon"]);
}

#[test]
fn vtu_has_polygons_and_triangles() {
    let (voronoi, domain, data) = sample();
    let clipped = voronoi.clip(&domain, &()).expect("nobody cancels");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cells.vtu");
    write(&clipped, &data, &path, &WriteOptions::default());
    let text = fs::read_to_string(&path).expect("a file");
    let [types, ends, sites] = ["types", "offsets", "site"].map(|name| array(&text, name));
    let ends: Vec<u64> = ends
        .as_chunks()
        .0
        .iter()
        .map(|&b| u64::from_le_bytes(b))
        .collect();
    let sites: Vec<i32> = sites
        .as_chunks()
        .0
        .iter()
        .map(|&b| i32::from_le_bytes(b))
        .collect();
    // The cell with the hole in triangles, the others as polygons.
    let triangles = types.iter().filter(|&&kind| kind == 5).count();
    assert!(triangles > 5 && types.ends_with(&[7, 7]));
    assert_eq!((ends.len(), sites.len()), (types.len(), types.len()));
    assert!(sites[..triangles].iter().all(|&site| site == 0));
    assert_eq!(sites[triangles..], [1, 2]);
    // Their areas are those of the cells.
    let points: Vec<f64> = array(&text, "Points")
        .as_chunks()
        .0
        .iter()
        .map(|&b| f64::from_le_bytes(b))
        .collect();
    let nodes: Vec<u64> = array(&text, "connectivity")
        .as_chunks()
        .0
        .iter()
        .map(|&b| u64::from_le_bytes(b))
        .collect();
    let at = |node: u64| [0, 1].map(|k| points[3 * node as usize + k]);
    let mut areas = [0.0; 3];
    let mut first = 0;
    for (&end, &site) in ends.iter().zip(&sites) {
        let ring = &nodes[first..end as usize];
        let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
        let crosses = pairs.map(|(&a, &b)| at(a)[0] * at(b)[1] - at(a)[1] * at(b)[0]);
        areas[site as usize] += 0.5 * crosses.sum::<f64>();
        first = end as usize;
    }
    for (v, area) in areas.into_iter().enumerate() {
        let expected = clipped.measure(VertexId::new(v)).area;
        assert!((area - expected).abs() < 1e-12, "{area} {expected}");
    }
}

/// Decodes an array of a VTU file.
fn array(text: &str, name: &str) -> Vec<u8> {
    use base64::prelude::{BASE64_STANDARD, Engine};
    let (_, rest) = text
        .split_once(&format!("Name=\"{name}\""))
        .expect("the array");
    let (_, rest) = rest.split_once(">\n").expect("its content");
    let (content, _) = rest.split_once('\n').expect("its end");
    BASE64_STANDARD.decode(content).expect("base64")[8..].to_vec()
}

#[test]
fn pictures_show_cells_and_sites() {
    let (voronoi, domain, data) = sample();
    let clipped = voronoi.clip(&domain, &()).expect("nobody cancels");
    let folder = tempfile::tempdir().expect("a folder");
    let options = WriteOptions {
        picture: PictureOptions {
            size: 400,
            legend: false,
        },
        ..WriteOptions::default()
    };
    let path = folder.path().join("cells.png");
    write(&clipped, &data, &path, &options);
    let decoder = png::Decoder::new(std::io::BufReader::new(
        fs::File::open(&path).expect("a file"),
    ));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size()];
    let info = reader.next_frame(&mut pixels).expect("a PNG");
    assert_eq!((info.width, info.height), (400, 400));
    let margin = 56.0 * 400.0 / 1600.0;
    let pixel = |x: f64, y: f64| {
        let per_unit = (400.0 - 2.0 * margin) / 8.0;
        let [x, y] = [margin + x * per_unit, margin + (8.0 - y) * per_unit].map(|c| c as usize);
        let at = 3 * (y * 400 + x);
        [pixels[at], pixels[at + 1], pixels[at + 2]]
    };
    assert_eq!(pixel(1.0, 1.9), [255; 3], "in the hole");
    assert_eq!(pixel(1.0, 1.0), pixel(7.0, 1.0), "dots");
    let [left, top] = [pixel(2.5, 0.5), pixel(3.0, 7.0)];
    assert!(left != top && left != [255; 3] && top != [255; 3]);

    let path = folder.path().join("cells.svg");
    write(&clipped, &data, &path, &options);
    let text = fs::read_to_string(&path).expect("a file");
    assert!(text.contains("<title>3 Voronoi cells</title>"));
    // One path for each colour, and one for the dots.
    assert_eq!(text.matches("<path").count(), 4);
}

#[test]
fn what_cannot_be_written_is_said() {
    let (voronoi, domain, mut data) = sample();
    let clipped = voronoi.clip(&domain, &()).expect("nobody cancels");
    let folder = tempfile::tempdir().expect("a folder");
    let target = |name: &str| [Target::from_arg(folder.path().join(name), None)];
    let options = WriteOptions::default();
    let cells = CellsView::new(&clipped).with_data(&data);
    let refused = write_cells(&target("cells.ele"), &cells, &options, &());
    let Err(Error::Unsupported { instead, .. }) = refused else {
        panic!("{refused:?}");
    };
    assert_eq!(instead, "geojson, vtu, svg, png");
    data.markers = Some(vec![1]);
    let cells = CellsView::new(&clipped).with_data(&data);
    let refused = write_cells(&target("cells.vtu"), &cells, &options, &());
    assert!(matches!(refused, Err(Error::BadMesh(_))), "{refused:?}");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
