//! Certificates and lineage, seen from the shell: they hold, they are the same wherever they are made, and
//! whatever is altered is found.

mod support;

use delone_io::{MeshCertificate, digest_file};
use serde_json::{Value, json};
use support::Folder;

/// Two crossing segments in a square of two regions, a point in one corner twice, and one segment of no length.
const DRAWING: &str = "\
9 2 0 0
0 0 0
1 4 0
2 4 3
3 0 3
4 1 0
5 2.9 3
6 0.5 1.1
7 4 2
8 4 3
8 0
0 0 4
1 4 1
2 1 2
3 2 5
4 5 3
5 3 0
6 4 5
7 6 7
0
2
0 0.2 0.2 7 0.5
1 3.7 0.3 8 -1
";

const CHECK: &str = "check m.ele --domain map.poly --certificate m.certificate.json";

/// A folder with a triangulated drawing and its papers.
fn triangulated() -> Folder {
    let folder = Folder::new();
    folder.write("map.poly", DRAWING);
    let line = "triangulate map.poly --crossings split -o m.ele --certificate";
    folder.run(line, 0);
    folder
}

/// A folder with a refined drawing and its papers.
fn refined() -> Folder {
    let folder = Folder::new();
    folder.write("map.poly", DRAWING);
    let line = "mesh map.poly --crossings split --max-edge 0.8 -o m.ele --certificate";
    folder.run(line, 0);
    folder
}

fn certificate(folder: &Folder) -> Value {
    serde_json::from_str(&folder.read("m.certificate.json")).expect("JSON")
}

/// Writes a certificate with the hashes of the files as they are, and a checksum that is right.
fn seal(folder: &Folder, value: Value) -> bool {
    let Ok(mut read) = serde_json::from_value::<MeshCertificate>(value) else {
        return false;
    };
    let now = |name: &str| digest_file(&folder.path().join(name), &());
    for fact in &mut read.output {
        if let Ok(digest) = now(&fact.name) {
            *fact = digest;
        }
    }
    let lineage = read
        .lineage
        .clone()
        .map(|fact| now(&fact.name).unwrap_or(fact));
    let output = read.output.clone();
    let sealed = read.sealed(output, lineage);
    folder.write(
        "m.certificate.json",
        serde_json::to_string_pretty(&sealed).expect("JSON"),
    );
    true
}

#[test]
fn certificates_hold_for_every_kind_of_mesh() {
    for (input, content, command) in [
        ("p.csv", support::POINTS, "triangulate p.csv -o m.ele"),
        (
            "p.csv",
            support::POINTS,
            "triangulate p.csv -o m.npy --picture m.png",
        ),
        (
            "p.csv",
            support::POINTS,
            "mesh p.csv --max-edge 0.7 -o m.vtu",
        ),
        (
            "p.csv",
            support::POINTS,
            "triangulate p.csv --domain hull -o m.vtu",
        ),
        (
            "d.poly",
            DRAWING,
            "triangulate d.poly --crossings split --domain hull -o m.vtu",
        ),
        (
            "d.poly",
            DRAWING,
            "mesh d.poly --crossings split --domain evenodd -o m.npy",
        ),
        (
            "d.poly",
            DRAWING,
            "mesh d.poly --crossings split --area-per-region -o m.ele --one-based",
        ),
        (
            "d.poly",
            DRAWING,
            "mesh d.poly --crossings split --sizing 0.3+x/10 --quadratic -o m.ele",
        ),
        (
            "d.poly",
            DRAWING,
            "mesh d.poly --crossings split --domain hull --smooth 2 -o m.vtu",
        ),
    ] {
        let folder = Folder::new();
        folder.write(input, content);
        folder.run(&format!("{command} --certificate"), 0);
        let mesh = command
            .split_whitespace()
            .find(|word| word.starts_with("m."));
        let mesh = mesh.expect("an output");
        let line = format!("check {mesh} --domain {input} --certificate m.certificate.json");
        let said = folder.run(&line, 0).stdout;
        assert!(
            said.contains("m.certificate.json holds"),
            "{command}: {said}"
        );
        let json = folder.run(&format!("{line} --json"), 0).json();
        assert_eq!(json["certificate"]["holds"], true, "{command}");
    }
}

#[test]
fn the_sample_and_its_lineage() {
    let folder = Folder::new();
    folder.run("mesh -o m.ele --certificate=c.json --lineage l.csv", 0);
    folder.run("sample lake -o lake.poly", 0);
    folder.run("check m.ele --domain lake.poly --certificate c.json", 0);
    folder.run("triangulate -o t.vtu --lineage t.csv", 0);
    assert!(!folder.names().contains(&"t.certificate.json".to_owned()));
    assert!(
        folder
            .read("t.csv")
            .starts_with("element,number,origin,feature,at,")
    );
}

#[test]
fn lineage_names_the_features() {
    let folder = triangulated();
    let table = folder.read("m.lineage.csv");
    for row in [
        "vertex,0,input,0,,,,,,",
        "vertex,8,duplicate,2,,,,,,",
        "edge,0,segment,0,0,1,,,0,4",
        "triangle,0,region,",
    ] {
        assert!(table.contains(row), "{row}: {table}");
    }
    let crossing = table
        .lines()
        .find(|row| row.starts_with("vertex,9,crossing,6,"));
    let cells: Vec<&str> = crossing.expect("one crossing").split(',').collect();
    let [t, u] = [4, 7].map(|cell| cells[cell].parse::<f64>().expect("a weight"));
    // (1, 0) to (2.9, 3) and (0.5, 1.1) to (4, 2): where 1 + 1.9 t = 0.5 + 3.5 u and 3 t = 1.1 + 0.9 u.
    assert!((1.0 + 1.9 * t - 0.5 - 3.5 * u).abs() < 1e-14, "{t} {u}");
    assert!((3.0 * t - 1.1 - 0.9 * u).abs() < 1e-14, "{t} {u}");
    assert_eq!((1.0 - t) + t, 1.0);
}

/// The corners of the triangle in which a free vertex lies, and their weights.
type Corners = Vec<(usize, f64)>;

/// The rows of free vertices, each with its corners.
fn free_rows(table: &str) -> Vec<(usize, Corners)> {
    let mut free: Vec<(usize, Corners)> = Vec::new();
    for line in table.lines().filter(|line| line.contains(",free,")) {
        let cells: Vec<&str> = line.split(',').collect();
        let vertex = cells[1].parse().expect("a vertex");
        let corner = cells[3].parse().expect("a corner");
        let weight = cells[4].parse().expect("a weight");
        match free.last_mut().filter(|last| last.0 == vertex) {
            Some((_, corners)) => corners.push((corner, weight)),
            None => free.push((vertex, vec![(corner, weight)])),
        }
    }
    free
}

/// The points of `m.node`.
fn places(folder: &Folder) -> Vec<[f64; 2]> {
    let text = folder.read("m.node");
    let rows = text.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split_whitespace().collect();
        [1, 2].map(|k| cells[k].parse::<f64>().expect("a coordinate"))
    });
    rows.collect()
}

#[test]
fn free_vertices_are_mixed_from_the_corners_of_the_input() {
    let folder = refined();
    let points = places(&folder);
    let free = free_rows(&folder.read("m.lineage.csv"));
    assert!(free.len() > 5, "{}", free.len());
    for (v, corners) in &free {
        assert!((2..=3).contains(&corners.len()), "{v}: {corners:?}");
        // Nine points, the second of two equal ones, and one crossing.
        let is_corner = |c: usize| c < 8 || c == 9;
        assert!(corners.iter().all(|&(c, w)| is_corner(c) && w > 0.0));
        assert_eq!(corners.iter().map(|(_, w)| w).sum::<f64>(), 1.0, "{v}");
        for k in [0, 1] {
            let sum: f64 = corners.iter().map(|&(c, w)| w * points[c][k]).sum();
            assert!(
                (sum - points[*v][k]).abs() < 6.0 * 4.0 * f64::EPSILON,
                "{v}"
            );
        }
    }
    // The same from a square whose diagonal some of them are on: two rows, which halve it.
    folder.write("map.csv", "x,y\n0,0\n1,0\n1,1\n0,1\n");
    folder.run("mesh map.csv --max-edge 0.5 -o m.ele --certificate", 0);
    let free = free_rows(&folder.read("m.lineage.csv"));
    let on_edge = free.iter().filter(|(_, corners)| corners.len() == 2);
    assert!(on_edge.clone().count() > 0 && on_edge.count() < free.len());
    let check = "check m.ele --domain map.csv --certificate m.certificate.json";
    assert!(folder.run(check, 0).stdout.contains(" holds"));
}

#[test]
fn certificates_are_the_same_for_any_threads_and_folders() {
    let one = refined();
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("sub")).expect("a folder");
    folder.write("sub/map.poly", DRAWING);
    let line = "mesh ./sub/map.poly --crossings split --max-edge 0.8 -o sub/m.ele --certificate --threads 3";
    folder.run(line, 0);
    for name in ["m.certificate.json", "m.lineage.csv"] {
        assert_eq!(folder.read(&format!("sub/{name}")), one.read(name));
    }
}

/// Visits the places of all leaves.
fn leaves(value: &Value, place: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) if !fields.is_empty() => {
            for (key, value) in fields {
                leaves(value, &format!("{place}/{key}"), found);
            }
        }
        Value::Array(entries) if !entries.is_empty() => {
            for (i, value) in entries.iter().enumerate() {
                leaves(value, &format!("{place}/{i}"), found);
            }
        }
        _ => found.push(place.to_owned()),
    }
}

/// Makes something else of a leaf, of the same kind if there is one.
fn altered(leaf: &Value) -> Value {
    match leaf {
        Value::Null => json!("x"),
        Value::Bool(is) => json!(!is),
        Value::Number(n) if n.is_u64() => json!(n.as_u64().expect("a number") + 1),
        Value::Number(n) => json!(n.as_f64().expect("a number").next_up()),
        Value::String(text) => match text.chars().last() {
            Some('0') => json!(format!("{}1", &text[..text.len() - 1])),
            _ => json!(format!("{}0", &text[..text.len() - 1])),
        },
        Value::Array(_) => json!([1]),
        Value::Object(_) => json!({"x": 1}),
    }
}

#[test]
fn every_altered_field_is_found() {
    let folder = refined();
    folder.run(CHECK, 0);
    let whole = certificate(&folder);
    let mut places = Vec::new();
    leaves(&whole, "", &mut places);
    assert!(places.len() > 60, "{}", places.len());
    for place in &places {
        let mut forged = whole.clone();
        let leaf = forged.pointer_mut(place).expect("a leaf");
        *leaf = altered(leaf);
        folder.write("m.certificate.json", forged.to_string());
        let assert = folder.command(CHECK).assert().failure();
        let said = support::Output::of(assert);
        assert!(!said.stdout.contains(" holds"), "{place}");
        // Whoever makes a new checksum, too, is found where files tell otherwise.
        let is_word = place.starts_with("/made_by") || place.starts_with("/asked");
        let is_hash = place.starts_with("/output") || place.starts_with("/lineage");
        if !is_word && !is_hash && place != "/checksum" && seal(&folder, forged) {
            let assert = folder.command(CHECK).assert().failure();
            let said = support::Output::of(assert);
            assert!(
                !said.stdout.contains("checksum"),
                "{place}: {}",
                said.stdout
            );
        }
    }
    let mut weaker = whole.clone();
    weaker["asked"]["min_angle_degrees"] = json!(24.0);
    assert!(seal(&folder, weaker));
    let said = folder.run(CHECK, 1).stdout;
    assert!(said.contains("reached.asked_tangent"), "{said}");
}

/// Alters a file, makes the certificate name its new hash, and requires that the check finds what it should.
fn expect_found(folder: &Folder, name: &str, alter: impl Fn(&str) -> String, words: &str) {
    let (before, papers) = (folder.read(name), certificate(folder));
    let after = alter(&before);
    assert_ne!(before, after, "{name}");
    folder.write(name, &after);
    let hashed = folder.run(CHECK, 1).stdout;
    assert!(hashed.contains("NOT hold"), "{hashed}");
    assert!(seal(folder, papers.clone()));
    let said = folder.run(CHECK, 1).stdout;
    assert!(said.contains(words), "{words}: {said}");
    folder.write(name, before);
    assert!(seal(folder, papers));
    folder.run(CHECK, 0);
}

fn without_line(text: &str, begin: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with(begin));
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn altered_meshes_are_found_though_their_hashes_are_forged() {
    for folder in [triangulated(), refined()] {
        // One unit in the last place.
        let moved = |text: &str| text.replacen("2.9 3", "2.9000000000000004 3", 1);
        expect_found(&folder, "m.node", moved, "2.9000000000000004");
        // A lost segment.
        let lost = |text: &str| {
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            let header = lines.iter().position(|l| l.split_whitespace().count() == 2);
            let header = header.expect("the count of segments");
            let count = lines[header].split_whitespace().next().expect("a count");
            let fewer = count.parse::<usize>().expect("a count") - 1;
            lines[header] = format!("{fewer} 1");
            lines.remove(header + 1 + fewer);
            lines.join("\n") + "\n"
        };
        expect_found(&folder, "m.poly", lost, "NOT hold");
        // Two triangles about another diagonal: each with a corner of the other.
        expect_found(&folder, "m.ele", flipped, "NOT hold");
    }
}

/// Flips the first edge that two triangles have.
fn flipped(text: &str) -> String {
    let mut rows: Vec<Vec<String>> = text
        .lines()
        .map(|line| line.split_whitespace().map(str::to_owned).collect())
        .collect();
    let num = rows[0][0].parse::<usize>().expect("a count");
    for i in 1..=num {
        for j in i + 1..=num {
            let lone = |a: &[String], b: &[String]| (1..4).find(|&k| !b[1..4].contains(&a[k]));
            let shared = (1..4)
                .filter(|&k| rows[j][1..4].contains(&rows[i][k]))
                .count();
            if shared != 2 {
                continue;
            }
            let [k, l] = [lone(&rows[i], &rows[j]), lone(&rows[j], &rows[i])];
            let (k, l) = (k.expect("an apex"), l.expect("an apex"));
            let (p, q) = (rows[i][k].clone(), rows[j][l].clone());
            let a = rows[i][1 + k % 3].clone();
            let b = rows[i][1 + (k + 1) % 3].clone();
            rows[i][1..4].clone_from_slice(&[p.clone(), a, q.clone()]);
            rows[j][1..4].clone_from_slice(&[q, b, p]);
            return rows.iter().map(|row| row.join(" ") + "\n").collect();
        }
    }
    unreachable!("no two triangles share an edge")
}

#[test]
fn altered_lineage_is_found_though_its_hash_is_forged() {
    let folder = refined();
    let table = folder.read("m.lineage.csv");
    let row = |begin: &str| {
        let row = table.lines().find(|row| row.starts_with(begin));
        row.unwrap_or_else(|| panic!("no {begin}")).to_owned()
    };
    let changed = |from: String, to: String| move |text: &str| text.replacen(&from, &to, 1);
    let expect = |from: &str, to: &str, words: &str| {
        expect_found(
            &folder,
            "m.lineage.csv",
            changed(from.to_owned(), to.to_owned()),
            words,
        );
    };
    expect(
        "vertex,8,duplicate,2",
        "vertex,8,duplicate,1",
        "vertex 8 is said to be",
    );
    expect(
        "vertex,9,crossing,6,",
        "vertex,9,crossing,5,",
        "vertex 9 is said to be",
    );
    expect(
        "vertex,0,input,0,,",
        "vertex,0,free,0,1,",
        "vertex 0 is said to be",
    );
    let triangle = row("triangle,0,region,");
    expect(&triangle, "triangle,0,none,,,,,,,", "regions");
    let on_segment = table
        .lines()
        .find(|row| row.starts_with("vertex,") && row.contains(",segment,"))
        .expect("a Steiner point on a segment");
    let mut cells: Vec<String> = on_segment.split(',').map(str::to_owned).collect();
    let t = cells[4].parse::<f64>().expect("a weight");
    cells[4] = format!("{:?}", t.next_down());
    expect(on_segment, &cells.join(","), "is said to be");
    let edge = row("edge,0,");
    let cells: Vec<&str> = edge.split(',').collect();
    let swapped = format!(
        "edge,0,{},{},{},{},,,{},{}",
        cells[2], cells[3], cells[4], cells[5], cells[9], cells[8]
    );
    expect(&edge, &swapped, "segment 0");
    let (v, corners) = free_rows(&table).remove(0);
    assert_eq!(corners.len(), 3);
    let line =
        |(corner, weight): (usize, f64)| format!("vertex,{v},free,{corner},{weight:?},,,,,\n");
    let rows = |corners: &[(usize, f64)]| -> String { corners.iter().copied().map(line).collect() };
    let of_free = |words: &str, change: &dyn Fn(&mut Corners)| {
        let mut other = corners.clone();
        change(&mut other);
        expect(
            &rows(&corners),
            &rows(&other),
            &format!("vertex {v} {words}"),
        );
    };
    let step = f64::EPSILON;
    // A weight alone; two that still sum to 1, near and far; another triangle; a row too few; none that is right.
    expect(
        &line(corners[0]),
        &line((corners[0].0, corners[0].1 + step)),
        &format!("the weights of vertex {v} are no multiples of 2^-52 that sum to 1"),
    );
    of_free("is said to be", &|c| {
        (c[0].1, c[1].1) = (c[0].1 + step, c[1].1 - step);
    });
    of_free("is at (", &|c| {
        (c[0].1, c[1].1) = (c[0].1 + 64.0 * step, c[1].1 - 64.0 * step);
    });
    let others: Vec<usize> = (0..8)
        .filter(|c| corners.iter().all(|(own, _)| own != c))
        .collect();
    of_free("is at (", &|c| {
        c[0].0 = others[0];
        c.sort_by_key(|&(corner, _)| corner);
    });
    expect(
        &line(corners[2]),
        "",
        &format!("the weights of vertex {v} are no multiples"),
    );
    expect(
        &rows(&corners),
        &line((v, 1.0)),
        &format!("corner {v} of vertex {v} is a Steiner point"),
    );
    expect(
        &rows(&corners),
        &line((0, 1.0)),
        &format!("vertex {v} is at ("),
    );
    // Segment 7 lost: the rows behind it must be numbered as before.
    let rows = table
        .lines()
        .filter(|row| row.starts_with("edge,") && row.contains("segment,7,"));
    let rows: Vec<String> = rows.map(str::to_owned).collect();
    assert!(!rows.is_empty());
    let lost = |text: &str| {
        rows.iter()
            .fold(text.to_owned(), |text, row| without_line(&text, row))
    };
    expect_found(&folder, "m.lineage.csv", lost, "segment 7 is lost");
}

#[test]
fn how_the_input_was_read_is_part_of_the_certificate() {
    let folder = Folder::new();
    folder.write(
        "map.svg",
        "<svg><circle cx='0' cy='0' r='8'/><circle cx='9' cy='1' r='5'/></svg>",
    );
    folder.write("map.csv", "a,b,c\n0,1,2\n5,0,1\n3,4,0\n2,2,7\n");
    for (input, option, listed) in [
        ("map.svg", "--flatness 0.25", "flatness=0.25"),
        ("map.csv", "--columns c,a", "columns=c,a"),
    ] {
        let line = format!("triangulate {input} {option} --domain hull -o m.vtu --certificate");
        let line = match input {
            "map.svg" => format!("{line} --crossings split"),
            _ => line,
        };
        folder.run(&line, 0);
        let made = certificate(&folder);
        assert_eq!(made["input"]["reading"], json!([listed]));
        let check = format!("check m.vtu --domain {input} --certificate m.certificate.json");
        folder.run(&check, 0);
        // Who says otherwise is found out, and nonsense is none.
        let mut changed = made.clone();
        let other = listed.replace("0.25", "0.125").replace("c,a", "a,b");
        changed["input"]["reading"] = json!([other]);
        assert!(seal(&folder, changed.clone()));
        folder.run(&check, 1);
        changed["input"]["reading"] = json!(["output=m.vtu"]);
        assert!(seal(&folder, changed));
        folder
            .run(&check, 3)
            .says(&["the certificate: unexpected argument"]);
    }
    // A certificate without them is as it always was.
    let usual = certificate(&triangulated());
    assert!(usual["input"].get("reading").is_none());
}

#[test]
fn lineage_may_be_a_table_of_columns() {
    let folder = refined();
    let line =
        "mesh map.poly --crossings split --max-edge 0.8 -o m.ele --certificate --lineage m.parquet";
    let text = folder.bytes("m.lineage.csv");
    folder.run(line, 0);
    assert!(folder.bytes("m.parquet").starts_with(b"PAR1"));
    let named = certificate(&folder);
    assert_eq!(named["lineage"]["name"], "m.parquet");
    assert!(folder.run(CHECK, 0).stdout.contains(" holds"));
    // It holds what the text does.
    let segments = 8;
    let read = |name: &str, bytes: Vec<u8>| {
        let name = name.to_owned();
        let source = delone_io::Source::Memory { name, bytes };
        delone_io::Lineage::read(&source, segments, &()).expect("a table of lineage")
    };
    let columns = read("m.parquet", folder.bytes("m.parquet"));
    assert_eq!(columns, read("m.csv", text));
    // Damage is told.
    let mut cut = folder.bytes("m.parquet");
    cut.truncate(cut.len() / 2);
    folder.write("m.parquet", cut);
    folder.run(CHECK, 3).says(&["m.parquet", "truncated"]);
}

#[test]
fn malformed_papers_are_bad_input_with_their_line() {
    let folder = triangulated();
    let papers = folder.read("m.certificate.json");
    folder.write(
        "m.certificate.json",
        "{\n  \"certificate\": 1,\n  \"x\": 2\n}\n",
    );
    folder
        .run(CHECK, 3)
        .says(&["m.certificate.json:3:", "not a certificate"]);
    for cut in [0, 1, 40, papers.len() / 2] {
        folder.write("m.certificate.json", &papers[..cut]);
        folder.run(CHECK, 3);
    }
    folder.write("m.certificate.json", papers);
    let table = folder.read("m.lineage.csv");
    folder.write(
        "m.lineage.csv",
        table.replacen("vertex,1,input,1,", "vertex,1,input,x,", 1),
    );
    folder
        .run(CHECK, 3)
        .says(&["m.lineage.csv:3: feature is \"x\""]);
}

#[test]
fn papers_need_files_and_come_with_them_or_not_at_all() {
    let folder = Folder::with_points();
    let run = |line: &str, code| folder.run(line, code);
    run("triangulate points.csv -o - --to ele --certificate", 2).says(&["standard output"]);
    run("triangulate points.csv --picture p.png --certificate", 2).says(&["read back"]);
    run("triangulate points.csv -o m.ele --lineage m.json", 2).says(&["lineage"]);
    std::fs::create_dir(folder.path().join("c.json")).expect("a folder");
    run("triangulate points.csv -o m.ele --certificate=c.json", 4).says(&["folder"]);
    run(
        "triangulate points.csv -o m.ele --certificate=points.csv",
        2,
    )
    .says(&["is the input"]);
    assert_eq!(folder.names(), ["c.json", "points.csv"]);
    run("triangulate points.csv -o m.ele --certificate", 0);
    let certificate = "check m.ele --domain points.csv --certificate m.certificate.json";
    run(&format!("{certificate} --min-angle 20"), 2).says(&["leave out"]);
    folder.write("other.csv", "x,y\n0,0\n1,0\n0,1\n");
    run(
        "check m.ele --domain other.csv --certificate m.certificate.json",
        1,
    );
}

#[test]
fn certificates_hold_on_the_corpus() {
    let Some(shared) = std::env::var_os("DELONE_SHARED") else {
        eprintln!("skipped: set DELONE_SHARED to the folder that holds the shared data/");
        return;
    };
    let data = std::path::PathBuf::from(shared).join("data/triangle");
    for name in ["A", "box", "double_hex", "face"] {
        let folder = Folder::new();
        let drawing = std::fs::read(data.join(name).with_extension("poly"));
        folder.write("map.poly", drawing.expect("a file of the corpus"));
        for command in ["triangulate", "mesh"] {
            folder.run(&format!("{command} map.poly -o m.ele --certificate"), 0);
            let said = folder.run(CHECK, 0).stdout;
            assert!(said.contains(" holds"), "{name}: {said}");
        }
    }
}
