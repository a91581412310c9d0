//! `delone check`, seen from the shell: right meshes, and every way to be wrong.

mod support;

use support::{Folder, POINTS, TRIANGLES, hash_by_hand};

/// A folder with `mesh.node` and `mesh.ele`, the latter with these triangles.
fn mesh(triangles: &[[usize; 3]]) -> Folder {
    let folder = Folder::new();
    let rows: Vec<&str> = POINTS.lines().skip(1).collect();
    let mut node = format!("{} 2 0 0\n", rows.len());
    for (i, row) in rows.iter().enumerate() {
        node.push_str(&format!("{i} {}\n", row.replace(',', " ")));
    }
    let mut ele = format!("{} 3 0\n", triangles.len());
    for (i, [a, b, c]) in triangles.iter().enumerate() {
        ele.push_str(&format!("{i} {a} {b} {c}\n"));
    }
    folder.write("mesh.node", node);
    folder.write("mesh.ele", ele);
    folder
}

#[test]
fn a_right_mesh_gets_a_certificate() {
    let folder = mesh(&TRIANGLES);
    let output = folder.run("check mesh.ele", 0);
    for words in [
        "right",
        "5 vertices",
        "1 duplicate",
        "Proven",
        &hash_by_hand(),
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
    let json = folder.run("check mesh.ele --json", 0).json();
    assert_eq!(json["right"], true);
    assert_eq!(json["hash"], hash_by_hand());
    assert_eq!(json["edges"], 8);
    assert_eq!(json["defects"]["total"], 0);
    assert_eq!(folder.run("-q check mesh.ele", 0).stdout, "");
}

#[test]
fn a_wrong_mesh_is_1_and_the_defects_are_named() {
    let [a, b, c, d] = TRIANGLES;
    for (triangles, words) in [
        (vec![a, b, c], "not convex"),
        (vec![a, b, c, [0, 3, 4]], "clockwise"),
        (vec![a, b, c, d, d], "triangle"),
        (vec![a, [1, 2, 3], [1, 3, 4], d], "Delaunay"),
        (vec![[0, 1, 2], [2, 3, 0]], "point 4"),
    ] {
        let folder = mesh(&triangles);
        let output = folder.run("check mesh.ele", 1);
        assert!(output.stdout.contains("wrong"), "{}", output.stdout);
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
        let json = folder.run("check mesh.ele --json", 1).json();
        assert_eq!(json["right"], false);
        assert!(json["hash"].is_null());
        assert!(json["defects"]["total"].as_u64() > Some(0));
    }
}

#[test]
fn several_meshes_are_checked_and_one_wrong_one_decides() {
    let folder = mesh(&TRIANGLES[..3]);
    folder.write("points.csv", POINTS);
    folder.run("triangulate points.csv -o good.vtu", 0);
    let output = folder.run("check good.vtu mesh.node mesh.ele --json", 1);
    let verdicts: Vec<bool> = output
        .stdout
        .lines()
        .map(|l| l.contains("\"right\":true"))
        .collect();
    assert_eq!(verdicts, [true, false]);
}

#[test]
fn points_of_another_file_must_all_be_there() {
    let folder = mesh(&TRIANGLES);
    folder.write("same.csv", "x,y\n1,1\n0,3\n4,3\n4,0\n0,0\n");
    folder.run("check mesh.ele --points same.csv", 0);
    folder.write("more.csv", "x,y\n1,1\n0,3\n4,3\n4,0\n0,0\n2,2\n");
    let output = folder.run("check mesh.ele --points more.csv", 1);
    assert!(
        output.stdout.contains("point 5 (2.0, 2.0) of more.csv"),
        "{}",
        output.stdout
    );
}

#[test]
fn a_file_that_cannot_be_read_does_not_hide_the_others() {
    let folder = mesh(&TRIANGLES[..3]);
    folder.write("points.csv", POINTS);
    folder.run("triangulate points.csv -o good.vtu", 0);
    let output = folder.run("check mesh.ele missing.ele good.vtu --json", 3);
    assert_eq!(output.stdout.lines().count(), 2, "{}", output.stdout);
    output.says(&["missing"]);
    assert_eq!(output.stderr.lines().count(), 1, "{}", output.stderr);
    folder.run("check missing.ele mesh.ele", 3);
}

/// A square with a hole, and a loose point outside.
const HOLED: &str = "\
9 2 0 0
0 0 0
1 4 0
2 4 4
3 0 4
4 1 1
5 3 1
6 3 3
7 1 3
8 9 9
8 0
0 0 1
1 1 2
2 2 3
3 3 0
4 4 5
5 5 6
6 6 7
7 7 4
1
0 2 2
";

#[test]
fn the_mesh_of_a_domain_gets_a_certificate() {
    let folder = Folder::new();
    folder.write("holed.poly", HOLED);
    folder.run("triangulate holed.poly -o m.ele", 0);
    let output = folder.run("check m.ele --domain holed.poly", 0);
    for words in [
        "right",
        "constrained",
        "holed.poly (carve)",
        "1 hole",
        "Proven",
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
    let json = folder
        .run("check m.ele --domain holed.poly --json", 0)
        .json();
    assert_eq!(json["right"], true);
    for (key, value) in [("added", 0), ("carved", 1), ("components", 1), ("holes", 1)] {
        assert_eq!(json["domain"][key], value, "{key}");
    }
    assert_eq!(json["domain"]["file"], "holed.poly");
    assert_eq!(json["domain"]["rule"], "carve");
    let built = folder.run("triangulate holed.poly --json", 0).json();
    assert_eq!(json["hash"], built["hash"]);
}

#[test]
fn a_mesh_is_right_under_its_own_rule_only() {
    let folder = Folder::new();
    folder.write("holed.poly", HOLED);
    let rules = ["hull", "carve", "evenodd"];
    for built in rules {
        folder.run(
            &format!("triangulate holed.poly --domain {built} -o m.ele"),
            0,
        );
        for checked in rules {
            // With the seed in the hole both leave the same.
            let agree = (built == "hull") == (checked == "hull");
            let line = format!("check m.ele --domain holed.poly --rule {checked}");
            let output = folder.run(&line, if agree { 0 } else { 1 });
            assert_eq!(output.stdout.contains("wrong"), !agree, "{built} {checked}");
        }
    }
}

#[test]
fn a_mesh_of_another_domain_is_wrong() {
    let folder = Folder::new();
    folder.write("holed.poly", HOLED);
    folder.run("triangulate holed.poly -o m.ele", 0);
    for (change, to) in [
        ("\n8 9 9", "\n8 9 8"),
        ("\n1\n0 2 2", "\n0"),
        ("7 7 4", "7 7 5"),
    ] {
        folder.write("other.poly", HOLED.replace(change, to));
        let json = folder
            .run("check m.ele --domain other.poly --json", 1)
            .json();
        assert_eq!(json["right"], false, "{change}");
        assert_eq!(json["domain"]["file"], "other.poly");
        assert!(json["domain"]["holes"].is_null());
    }
    // Without the domain it is no triangulation of its points, and that is explained.
    let output = folder.run("check m.ele", 1);
    assert!(output.stdout.contains("--domain"), "{}", output.stdout);
}

#[test]
fn a_bad_domain_is_3() {
    let folder = Folder::new();
    folder.write("holed.poly", HOLED);
    folder.run("triangulate holed.poly -o m.ele", 0);
    folder
        .run("check m.ele --domain nowhere.poly", 3)
        .says(&["nowhere.poly"]);
    folder.write("seed.poly", HOLED.replace("0 2 2", "0 2 1"));
    folder
        .run("check m.ele --domain seed.poly", 3)
        .says(&["seed.poly: the point of hole 0 at (2, 1) lies on segment 4"]);
}

/// A square, and the same with the middles of its sides and its centre.
fn squares() -> Folder {
    let folder = Folder::new();
    folder.write(
        "coarse.poly",
        "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n1\n0 1 1 7 1\n",
    );
    folder.write(
        "fine.poly",
        "9 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 2 0\n5 4 2\n6 2 4\n7 0 2\n8 2 2\n\
         8 0\n0 0 4\n1 4 1\n2 1 5\n3 5 2\n4 2 6\n5 6 3\n6 3 7\n7 7 0\n0\n",
    );
    folder
}

#[test]
fn a_refined_mesh_is_right_if_it_is_said_to_be_refined() {
    let folder = squares();
    folder.run("triangulate fine.poly -o m.ele -o m.vtu", 0);
    for file in ["m.ele", "m.vtu"] {
        let line = format!("check {file} --domain coarse.poly");
        let output = folder.run(&line, 1);
        assert!(
            output.stdout.contains("no two segments cross"),
            "{}",
            output.stdout
        );
        let output = folder.run(&format!("{line} --refined"), 0);
        for words in [
            "a refined constrained",
            "5 Steiner points",
            "Steiner point that",
        ] {
            assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
        }
        let json = folder.run(&format!("{line} --refined --json"), 0).json();
        assert_eq!(json["domain"]["steiner"], 5);
        assert_eq!(json["domain"]["steiner_on_segments"], 4);
        assert_eq!(json["domain"]["added"], 0);
        assert!(json["bounds"].is_null());
    }
    // The middle of a side leaves it.
    let is_moved = |line: &&str| line.split_whitespace().next() == Some("4");
    let node = folder.read("m.node");
    let line = node.lines().skip(1).find(is_moved).expect("vertex 4");
    let mut words: Vec<&str> = line.split_whitespace().collect();
    words[2] = "-0.5";
    folder.write("m.node", node.replace(line, &words.join(" ")));
    let output = folder.run("check m.ele --domain coarse.poly --refined", 1);
    assert!(output.stdout.contains("wrong"), "{}", output.stdout);
}

#[test]
fn a_bound_that_is_missed_is_1_unless_something_excuses_it() {
    let folder = squares();
    folder.run("triangulate fine.poly -o m.ele", 0);
    for (bound, unmet) in [
        ("--min-angle 45", 0),
        ("--min-angle 46", 8),
        ("--max-edge 2.9", 0),
        ("--max-edge 2.8", 8),
        ("--max-area 2", 0),
        ("--max-area 1.9", 8),
        ("--area-per-region", 8),
        ("--sizing 2.9", 0),
        ("--sizing 2.6+0.1*x", 4),
        ("--sizing 9 --sizing distance:segments,at=2.8,growth=0", 8),
        ("--conforming", 0),
    ] {
        let line = format!("check m.ele --domain coarse.poly {bound}");
        let output = folder.run(&line, i32::from(unmet > 0));
        let words = if unmet > 0 {
            "nothing excuses it"
        } else {
            "bounds met"
        };
        assert!(output.stdout.contains(words), "{}", output.stdout);
        let json = folder
            .run(&format!("{line} --json"), i32::from(unmet > 0))
            .json();
        assert_eq!(json["right"], true);
        assert_eq!(json["bounds"]["met"], unmet == 0, "{bound}");
        assert_eq!(json["bounds"]["unexcused"], unmet, "{bound}");
    }
    let quiet = folder.run("-q check m.ele --domain coarse.poly --min-angle 46", 1);
    assert!(quiet.stdout.contains("bounds NOT met"), "{}", quiet.stdout);
}

#[test]
fn sizes_of_a_mesh_are_checked_as_they_were_asked_for() {
    let folder = squares();
    let sizing = "--sizing 0.1+0.3*hypot(x,y) --sizing distance:points,at=0.2,growth=0.5";
    folder.run(&format!("mesh coarse.poly {sizing} -o s.ele"), 0);
    let check = |sizing: &str, code| {
        let line = format!("check s.ele --domain coarse.poly --min-angle 25 {sizing} --json");
        folder.run(&line, code).json()["bounds"].clone()
    };
    assert_eq!(check(sizing, 0)["unmet"], 0);
    let smaller = sizing.replace("0.3", "0.15");
    assert_ne!(check(&smaller, 1)["unexcused"], 0);
}

#[test]
fn what_had_to_stay_must_have_stayed_and_excuses() {
    let folder = squares();
    folder.run("triangulate fine.poly -o m.ele", 0);
    for which in ["", "=outer", "=all"] {
        let line = format!("check m.ele --domain coarse.poly --keep-boundary{which}");
        let output = folder.run(&line, 1);
        let words = "vertex 4 (2.0, 0.0) was added on a segment that had to stay";
        assert!(output.stdout.contains(words), "{}", output.stdout);
    }
    folder.run("triangulate coarse.poly -o c.ele", 0);
    let line = "check c.ele --domain coarse.poly --max-edge 1 --keep-boundary=outer --json";
    let json = folder.run(line, 0).json();
    assert_eq!(json["bounds"]["unmet_by_reason"]["locked_boundary"], 2);
}

#[test]
fn an_angle_of_the_input_is_an_excuse() {
    let folder = Folder::new();
    folder.write(
        "wedge.poly",
        "3 2 0 0\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n",
    );
    folder.run("triangulate wedge.poly -o m.ele", 0);
    let output = folder.run("check m.ele --domain wedge.poly --min-angle 20", 0);
    for words in [
        "bounds met; 1 triangle beyond them excused by small angles",
        "excused by the 14.04° between segments 0 and 2 at vertex 0",
        "count from 0",
    ] {
        assert!(output.stdout.contains(words), "{words}: {}", output.stdout);
    }
}

#[test]
fn bare_points_can_be_refined_too() {
    let folder = Folder::new();
    folder.write("coarse.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
    folder.write(
        "fine.csv",
        "x,y\n0,0\n4,0\n4,4\n0,4\n2,0\n4,2\n2,4\n0,2\n2,2\n",
    );
    folder.run("triangulate fine.csv -o m.npy", 0);
    folder.run("check m.npy --domain coarse.csv", 1);
    let json = folder
        .run("check m.npy --domain coarse.csv --min-angle 45 --json", 0)
        .json();
    assert_eq!(json["domain"]["steiner_on_segments"], 4);
}

#[test]
fn bounds_need_a_domain_and_must_make_sense() {
    let folder = squares();
    folder.run("triangulate fine.poly -o m.ele", 0);
    for bound in [
        "--refined",
        "--min-angle 20",
        "--keep-boundary",
        "--conforming",
        "--sizing 1",
    ] {
        folder
            .run(&format!("check m.ele {bound}"), 2)
            .says(&["--domain"]);
    }
    folder
        .run("check m.ele --domain coarse.poly --min-angle 60", 2)
        .says(&["below 60"]);
    folder
        .run("check m.ele --domain coarse.poly --sizing 1-x", 3)
        .says(&["--sizing `1-x` is -3", "sizes must be positive"]);
    folder
        .run("check m.ele --domain coarse.poly --max-area NaN", 2)
        .says(&["--max-area", "a positive number is needed"]);
}
