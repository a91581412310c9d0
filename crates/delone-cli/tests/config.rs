//! Jobs from a file, completions, manual pages.

mod support;

use support::Folder;

const JOBS: &str = r#"
[defaults]            # for every job that knows these options
min-angle = 30
out-dir = "meshes"
to = "vtu"

[[job]]
input = "lake.poly"
max-edge = 0.5
sizing = "0.2 + 0.1*x"

[[job]]
command = "triangulate"
input = ["coast*.poly"]
picture = "{}.png"
"#;

fn jobs() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("work")).expect("a folder");
    folder.run("sample lake -o work/lake.poly", 0);
    folder.run("sample coast -n 50 -o work/coast1.poly", 0);
    folder.run("sample coast -n 60 -o work/coast2.poly", 0);
    folder.write("work/job.toml", JOBS);
    folder
}

#[test]
fn jobs_do_what_their_commands_do_and_paths_begin_at_the_file() {
    let folder = jobs();
    folder
        .run("run work/job.toml", 0)
        .says(&["lake.poly", "3 files, all done"]);
    let line = "mesh work/lake.poly --min-angle 30 --max-edge 0.5 --sizing 0.2+0.1*x -o lake.vtu";
    folder.run(line, 0);
    assert_eq!(
        folder.bytes("lake.vtu"),
        folder.bytes("work/meshes/lake.vtu")
    );
    for name in ["coast1.vtu", "coast2.vtu", "coast1.png", "coast2.png"] {
        assert!(
            folder.path().join("work/meshes").join(name).is_file(),
            "{name}"
        );
    }
    let json = folder.run("run work/job.toml --json --jobs 1", 0).stdout;
    assert_eq!(json.lines().count(), 3);
    let first: serde_json::Value =
        serde_json::from_str(json.lines().next().expect("a line")).expect("an object");
    assert_eq!(first["file"], "lake.poly");
    assert_eq!(first["asked"]["max_edge"], 0.5);
}

#[test]
fn a_dry_run_prints_commands_that_do_the_same() {
    let folder = jobs();
    let printed = folder.run("run work/job.toml --dry-run", 0).stdout;
    assert_eq!(
        printed,
        "delone mesh --min-angle=30 --out-dir=meshes --to=vtu --max-edge=0.5 '--sizing=0.2 + 0.1*x' -- lake.poly\n\
         delone triangulate --out-dir=meshes --to=vtu '--picture={}.png' -- 'coast*.poly'\n"
    );
    assert!(!folder.path().join("work/meshes").exists());
}

#[test]
fn what_is_wrong_is_told_with_its_line_before_anything_is_done() {
    let folder = jobs();
    for (from, to, code, expected) in [
        (
            "max-edge",
            "max-egde",
            3,
            "work/job.toml:9: no option max-egde of mesh, did you mean max-edge?",
        ),
        (
            "max-edge = 0.5",
            "max-edge = \"long\"",
            2,
            "work/job.toml:9: invalid value 'long' for '--max-edge <LENGTH>': a positive number",
        ),
        (
            "max-edge = 0.5",
            "strategy = \"thesis\"",
            2,
            "work/job.toml:9: --strategy thesis knows",
        ),
        ("[[job]]", "[[jobs]]", 3, "did you mean job?"),
        (
            "\"triangulate\"",
            "\"check\"",
            3,
            "work/job.toml:13: command must be one of",
        ),
        (
            "out-dir = \"meshes\"",
            "output = \"m.vtu\"",
            2,
            "one name will not do",
        ),
        (
            "lake.poly",
            "coast1.poly",
            2,
            "would be written for both coast1.poly",
        ),
        ("\"lake.poly\"", "\"lake.poly", 3, "work/job.toml:8: "),
    ] {
        folder.write("work/job.toml", JOBS.replace(from, to));
        folder.run("run work/job.toml", code).says(&[expected]);
        assert!(!folder.path().join("work/meshes").exists(), "{to}");
    }
    folder.write("work/job.toml", b"[[job]]\n\xff");
    folder
        .run("run work/job.toml", 3)
        .says(&["job.toml:2: this is not UTF-8"]);
    folder
        .run("run nowhere.toml", 3)
        .says(&["cannot read nowhere.toml"]);
}

#[test]
fn covers_are_jobs_too() {
    let folder = Folder::new();
    for (name, n) in [("a", 60), ("b", 80)] {
        folder.run(&format!("sample gauss -n {n} -o {name}.csv"), 0);
    }
    let jobs = "[defaults]\nmin-angle = 30\n\n[[job]]\ncommand = \"cover\"\ninput = \"?.csv\"\ndegree = 1\n\
                output = \"{}.vtu\"\ndata-out = \"{}-held.csv\"\n";
    folder.write("job.toml", jobs);
    let said = folder.run("run job.toml --json", 0).stdout;
    assert_eq!(said.lines().count(), 2, "{said}");
    let first = said.lines().next().expect("a line");
    let first: serde_json::Value = serde_json::from_str(first).expect("an object");
    assert_eq!(
        (&first["file"], &first["least"]),
        (&"a.csv".into(), &3.into())
    );
    folder.run(
        "cover a.csv --degree 1 -o alone.vtu --data-out alone.csv",
        0,
    );
    assert_eq!(folder.bytes("a.vtu"), folder.bytes("alone.vtu"));
    assert_eq!(folder.bytes("a-held.csv"), folder.bytes("alone.csv"));
    // What a job needs and has not is told with its place.
    folder.write("job.toml", "[[job]]\ncommand = \"cover\"\ndegree = 1\n");
    folder
        .run("run job.toml", 2)
        .says(&["job.toml:1: ", "<POINTS>"]);
    // Nobody writes the polygon that another covers.
    let jobs = "[[job]]\ncommand = \"cover\"\ninput = \"a.csv\"\ndomain = \"d.geojson\"\noutput = \"c.vtu\"\n\n\
                [[job]]\ncommand = \"convert\"\ninput = \"d.poly\"\noutput = \"d.geojson\"\n";
    folder.write("job.toml", jobs);
    folder
        .run("run job.toml", 2)
        .says(&["d.geojson would be written for d.poly, but it is an input"]);
}

#[test]
fn a_file_of_jobs_may_come_through_a_pipe() {
    let folder = Folder::with_points();
    let mut command = folder.command("run -");
    let jobs = "[[job]]\ncommand = \"convert\"\ninput = \"points.csv\"\noutput = \"p.npy\"\n";
    command.write_stdin(jobs).assert().code(0);
    assert_eq!(folder.names(), ["p.npy", "points.csv"]);
}

#[test]
fn the_example_of_the_help_is_a_file_of_jobs() {
    let folder = Folder::new();
    let help = folder.run("run --help", 0).stdout;
    let (_, example) = help.split_once("A file of jobs:\n").expect("an example");
    let (example, _) = example.split_once("\nKeys are").expect("its end");
    folder.write("job.toml", example);
    let printed = folder.run("run job.toml --dry-run", 0).stdout;
    assert_eq!(printed.lines().count(), 3, "{printed}");
}

#[test]
fn every_shell_is_told_of_every_command() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = folder.run(&format!("completions {shell}"), 0).stdout;
        for word in ["triangulate", "min-angle", "out-dir", "algorithms"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
        folder.write(shell, script);
    }
    folder.run("completions cmd", 2);
}

#[cfg(unix)]
#[test]
fn bash_understands_its_completions() {
    let folder = Folder::new();
    folder.write("delone.bash", folder.run("completions bash", 0).stdout);
    let bash = |script: &str| {
        let mut bash = std::process::Command::new("bash");
        bash.current_dir(folder.path())
            .args(["-c", script])
            .output()
    };
    let asked = "source delone.bash; COMP_WORDS=(delone mesh --max-e); COMP_CWORD=2; \
                 _delone delone --max-e mesh; printf '%s\\n' \"${COMPREPLY[@]}\"";
    let Ok(answer) = bash(asked) else {
        eprintln!("no bash here: not tested");
        return;
    };
    let words = String::from_utf8_lossy(&answer.stdout).into_owned();
    assert_eq!(words.trim(), "--max-edge", "{answer:?}");
}

#[test]
fn manual_pages_have_the_shape_that_readers_expect() {
    let folder = Folder::new();
    folder.run("man --out-dir pages", 0).says(&["pages"]);
    let entries = std::fs::read_dir(folder.path().join("pages")).expect("a folder");
    let names: Vec<String> = entries
        .map(|e| {
            e.expect("an entry")
                .file_name()
                .into_string()
                .expect("UTF-8")
        })
        .collect();
    assert!(names.len() > 20, "{names:?}");
    for name in ["delone.1", "delone-mesh.1", "delone-algorithms-run.1"] {
        assert!(names.iter().any(|n| n == name), "{name}: {names:?}");
    }
    for name in &names {
        let page = folder.read(&format!("pages/{name}"));
        for section in [".TH ", ".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION"] {
            assert!(page.contains(section), "{name}: {section}");
        }
        assert!(page.is_ascii(), "{name}");
    }
    assert_eq!(
        folder.run("man mesh", 0).stdout.trim(),
        folder.read("pages/delone-mesh.1").trim()
    );
    folder.run("man nosuch", 2).says(&["no command nosuch"]);
}

#[cfg(unix)]
#[test]
fn groff_has_nothing_to_complain_about() {
    let folder = Folder::new();
    folder.run("man --out-dir pages", 0);
    let groff = |page: &std::path::Path| {
        let mut groff = std::process::Command::new("groff");
        groff
            .args(["-man", "-Tutf8", "-ww", "-z"])
            .arg(page)
            .output()
    };
    let entries = std::fs::read_dir(folder.path().join("pages")).expect("a folder");
    for entry in entries {
        let page = entry.expect("an entry").path();
        let Ok(output) = groff(&page) else {
            eprintln!("no groff here: not tested");
            return;
        };
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(said, "", "{}", page.display());
    }
}
