//! `delone cluster`, seen from the shell.

mod support;

use support::Folder;

/// Two groups far apart in the plane, one of them of two in space, and weights.
fn folder() -> Folder {
    let folder = Folder::new();
    folder.write(
        "towns.csv",
        "x,y,people,z,name\n0,0,1,0,a\n2,0,2,0,b\n0,2,1,9,c\n20,0,1,0,d\n22,0,1,0,e\n",
    );
    folder.write("same.csv", "x,y\n1,1\n1,1\n4,1\n1,1\n");
    folder
}

#[test]
fn rows_get_a_cluster_each() {
    let folder = folder();
    folder
        .run("cluster towns.csv -n 2 -o groups.csv", 0)
        .says(&[
            "5 points, 2 clusters of 2 to 3 points",
            "mean square of distances: 1.467; in the worst cluster 1.778",
            "wrote groups.csv",
        ]);
    assert_eq!(
        folder.read("groups.csv"),
        "x,y,people,z,cluster\n0,0,1,0,0\n2,0,2,0,0\n0,2,1,9,0\n20,0,1,0,1\n22,0,1,0,1\n"
    );
    let piped = folder.run("cluster groups.csv -n 2 -o - --to csv", 0);
    assert!(
        piped
            .stdout
            .starts_with("x,y,people,z,cluster,cluster_found\n")
    );
}

#[test]
fn centers_are_means() {
    let folder = folder();
    folder.run("cluster towns.csv -n 2 --weights people --centers c.csv", 0);
    assert_eq!(
        folder.read("c.csv"),
        "x,y,cluster,points,weight,error\n1,0.5,0,3,4,1.75\n21,0,1,2,2,1\n"
    );
    // Far apart in space are others.
    folder.run(
        "cluster towns.csv -n 3 --more z --centers c.csv -o g.csv",
        0,
    );
    assert_eq!(
        folder.read("c.csv"),
        "x,y,z,cluster,points,weight,error\n1,0,0,0,2,2,1\n21,0,0,1,2,2,1\n0,2,9,2,1,1,0\n"
    );
    folder.run("cluster towns.csv -n 3 --columns x,z --centers c.csv", 0);
    assert!(folder.read("c.csv").contains("\n0,9,2,1,1,0\n"));
}

#[test]
fn an_error_is_enough() {
    let folder = folder();
    let json = folder
        .run("cluster towns.csv --max-error 1.5 --json", 0)
        .json();
    assert_eq!(json["clusters"], 3);
    assert_eq!(json["worst_error"], 1.0);
    assert_eq!(json["history"].as_array().map(Vec::len), Some(3));
    let json = folder
        .run("cluster towns.csv --max-error 1.5 -n 2 --json", 0)
        .json();
    assert_eq!(json["clusters"], 2);
    let json = folder
        .run("cluster towns.csv --max-error 1e9 --json", 0)
        .json();
    assert_eq!(json["clusters"], 1);
    let all = folder.run("cluster towns.csv --max-error 0 --relax 5 --json", 0);
    assert_eq!(all.json()["clusters"], 5);
}

#[test]
fn figures_are_json() {
    let folder = folder();
    let json = folder
        .run("cluster towns.csv -n 2 --weights 1 --more z --json", 0)
        .json();
    for (key, value) in [("points", 5), ("clusters", 2), ("dimension", 3)] {
        assert_eq!(json[key], value, "{key}");
    }
    assert_eq!(json["weights"], "people");
    for phase in ["read", "cluster", "write"] {
        assert!(json["seconds"][phase].is_number(), "{phase}");
    }
    folder.run("cluster towns.csv -n 2 --json -o -", 2);
}

#[test]
fn few_points_are_no_trouble() {
    let folder = folder();
    folder
        .run("cluster same.csv -n 3 -o g.csv", 0)
        .says(&["same.csv: 2 clusters instead of 3: there are no more different points"]);
    assert_eq!(
        folder.read("g.csv"),
        "x,y,cluster\n1,1,0\n1,1,0\n4,1,1\n1,1,0\n"
    );
    folder.write("empty.csv", "x,y\n");
    let json = folder
        .run("cluster empty.csv -n 3 --json --picture p.png", 0)
        .json();
    assert_eq!(json["clusters"], 0);
    assert!(json["worst_error"].is_null());
}

#[test]
fn clusters_are_drawn() {
    let folder = folder();
    let line = "cluster towns.csv -n 2 -o g.node -o g.npy --picture p.svg -o p.png --size 200";
    folder
        .run(line, 0)
        .says(&["wrote g.node, g.npy, p.png and p.svg"]);
    let picture = folder.read("p.svg");
    assert!(picture.contains("5 points in 2 clusters"));
    // Five dots, and three discs for each center.
    assert_eq!(picture.matches("<circle").count(), 5 + 2 * 3);
    assert!(folder.bytes("p.png").starts_with(b"\x89PNG"));
    // Too many for a drawing of dots.
    folder.run("sample uniform -n 200001 -o many.npy", 0);
    folder.run("cluster many.npy -n 3 -o many.svg --size 100", 0);
    let picture = folder.read("many.svg");
    assert!(picture.contains("data:image/png") && picture.len() < 100_000);
}

#[test]
fn nonsense_is_refused() {
    let folder = folder();
    folder.run("cluster towns.csv", 2).says(&["--max-error"]);
    folder.run("cluster towns.csv -n 0", 2);
    folder.run("cluster towns.csv --max-error -1", 2);
    folder
        .run("cluster towns.csv -n 2 -o g.stl", 2)
        .says(&["stl cannot hold points"]);
    folder
        .run("cluster towns.csv -n 2 --weights q", 2)
        .says(&["no column \"q\"", "--weights: people, z"]);
    folder
        .run("cluster towns.csv -n 2 --more name", 3)
        .says(&["which is no number"]);
    folder
        .run("cluster towns.csv -n 2 --weights z", 3)
        .says(&["towns.csv:2: the weight of point 0 is 0"]);
    folder.run("cluster towns.csv -n 2 -o towns.csv", 2);
    folder.run("cluster towns.csv -n 2 -o a.csv --centers a.csv", 2);
    folder.run("cluster towns.csv -n 2 --centers -", 2);
    folder.run("cluster missing.csv -n 2", 3);
}
