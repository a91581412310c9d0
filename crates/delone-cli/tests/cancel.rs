//! Ctrl-C and its kin: exit code 128 and the signal, soon, and nothing half-written.
#![cfg(unix)]

mod support;

use std::io::Write;
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use support::Folder;

/// What is promised is 100 ms; machines that test are busy.
const SOON: Duration = Duration::from_millis(if cfg!(debug_assertions) { 600 } else { 400 });

fn start(folder: &Folder, line: &str, stdin: Stdio) -> Child {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("delone"));
    command
        .current_dir(folder.path())
        .args(line.split_whitespace())
        .stdin(stdin)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    // Whoever runs the tests may have signals ignored, as jobs in the background do.
    // SAFETY: between fork and exec nothing but `signal` is called, which is allowed there.
    unsafe { command.pre_exec(heed_signals) };
    command.spawn().expect("the program starts")
}

fn heed_signals() -> std::io::Result<()> {
    for signal in [libc::SIGINT, libc::SIGTERM, libc::SIGHUP] {
        // SAFETY: the default action needs no handler.
        unsafe { libc::signal(signal, libc::SIG_DFL) };
    }
    Ok(())
}

fn send(child: &mut Child, signal: libc::c_int) {
    let id = libc::pid_t::try_from(child.id()).expect("a process id");
    // SAFETY: the child has not been waited for, so the id is still its own.
    assert_eq!(unsafe { libc::kill(id, signal) }, 0);
}

/// Sends Ctrl-C after a while and returns how the program ended, and how long it took to; with `--nocapture` it is read.
fn interrupt(child: &mut Child, after: Duration) -> (ExitStatus, Duration) {
    sleep(after);
    send(child, libc::SIGINT);
    let start = Instant::now();
    let status = child.wait().expect("the program ends");
    let time = start.elapsed();
    if status.code() == Some(130) {
        println!("heard {} ms after {after:?}", time.as_millis());
    }
    (status, time)
}

#[test]
fn ctrl_c_ends_every_phase_soon_and_leaves_no_file() {
    let folder = Folder::new();
    folder.run("sample uniform -n 1000000 -o points.csv", 0);
    let line = "triangulate points.csv -o mesh.ele -o mesh.vtu --picture mesh.svg --threads 2";
    interrupt_again_and_again(&folder, line, "points.csv");
}

#[test]
fn ctrl_c_ends_the_phases_of_a_domain_soon_and_leaves_no_file() {
    let folder = Folder::new();
    folder.run("sample tangle -n 100000 -o tangle.poly", 0);
    let line =
        "triangulate tangle.poly --crossings split --domain hull -o mesh.ele -o mesh.geojson";
    interrupt_again_and_again(&folder, line, "tangle.poly");
    interrupt_again_and_again(&folder, "doctor tangle.poly", "tangle.poly");
}

#[test]
fn ctrl_c_ends_refinement_soon_and_leaves_no_file() {
    let folder = Folder::new();
    folder.run("sample coast -n 100000 -o coast.poly", 0);
    let line = "mesh coast.poly --min-angle 33 --max-area 1e-7 -o mesh.vtu --report mesh.html";
    interrupt_again_and_again(&folder, line, "coast.poly");
}

#[test]
fn ctrl_c_ends_a_cover_soon_and_leaves_no_file() {
    let folder = Folder::new();
    folder.run("sample uniform -n 300000 -o points.npy", 0);
    let line =
        "cover points.npy -d 3 -o cover.ele -o cover.vtu --picture cover.png --data-out held.csv";
    interrupt_again_and_again(&folder, line, "points.npy");
}

/// Commands on a million points, but for those that other tests interrupt, and when.
const OTHERS: [(&str, u64); 22] = [
    ("mesh p.npy -o m.ele", 900),
    ("convert p.npy p.svg", 500),
    ("convert p.npy p.vtu", 60),
    ("check m.vtu", 700),
    ("info p.npy", 300),
    ("nearest p.npy p.npy -o n.csv", 900),
    ("voronoi p.npy -o v.geojson", 1500),
    ("voronoi p.npy --lloyd 3 -o v.vtu", 1500),
    ("voronoi p.npy -o p.v.node", 900),
    ("interpolate z.npy --cell 0.0005 -o i.asc", 1200),
    ("interpolate z.npy p.npy --method natural -o i.csv", 1200),
    ("contour z.npy --interval 0.1 -o c.geojson", 1200),
    ("graph p.npy --kind mst -o g.csv", 900),
    ("graph p.npy --kind tour -o g.geojson", 1500),
    ("graph p.npy --kind alpha -o g.csv", 900),
    ("cluster p.npy -n 400 -o k.csv", 900),
    ("sample uniform -n 20000000 -o s.csv", 500),
    ("sample coast -n 3000000 -o s.poly", 900),
    ("race incremental sweep -n 1000000 --seconds 100", 900),
    ("algorithms run incremental p.npy -o a.ele", 900),
    ("triangle -q30a0.0000001Q p.node", 1500),
    ("convert p.npy z.npy --out-dir out --to csv", 300),
];

#[test]
fn ctrl_c_ends_every_other_command_soon_and_leaves_no_file() {
    let folder = Folder::new();
    folder.run("sample uniform -n 1000000 -o p.npy", 0);
    folder.run("convert p.npy p.node", 0);
    folder.run("triangulate p.npy -o m.vtu", 0);
    folder.write("z.npy", with_heights(1_000_000));
    let given = ["m.vtu", "p.node", "p.npy", "z.npy"];
    let mut cancelled = 0;
    for (line, millis) in OTHERS {
        let mut child = start(&folder, line, Stdio::null());
        let (status, time) = interrupt(&mut child, Duration::from_millis(millis));
        if status.code() == Some(130) {
            assert!(time < SOON, "{line}: took {time:?}");
            cancelled += 1;
        } else {
            assert_eq!(status.code(), Some(0), "{line}");
        }
        for name in folder.names() {
            let path = folder.path().join(&name);
            if path.is_dir() {
                // Files that were done by then stay; half of one does not.
                let half = std::fs::read_dir(&path).expect("a folder").filter(|entry| {
                    let name = entry.as_ref().expect("an entry").file_name();
                    !["p.csv", "z.csv"].iter().any(|known| name == *known)
                });
                assert_eq!(half.count(), 0, "{line}");
                std::fs::remove_dir_all(path).expect("it goes");
            } else if !given.contains(&&name[..]) {
                assert_eq!(status.code(), Some(0), "{line} left {name}");
                std::fs::remove_file(path).expect("it goes");
            }
        }
    }
    assert!(
        cancelled > 10,
        "only {cancelled} were slow enough to interrupt"
    );
}

#[test]
fn ctrl_c_ends_a_batch_and_leaves_whole_files_only() {
    let folder = Folder::new();
    folder.run("sample uniform -n 300000 -o a.csv", 0);
    for name in ["b", "c", "d", "e", "f"] {
        let copy = folder.path().join(format!("{name}.csv"));
        std::fs::copy(folder.path().join("a.csv"), copy).expect("a copy");
    }
    folder.run("triangulate a.csv -o whole.vtu", 0);
    let whole = folder.bytes("whole.vtu");
    let mut cancelled = 0;
    for millis in [50, 400, 1200] {
        let line = "triangulate a.csv b.csv c.csv d.csv e.csv f.csv --out-dir out --to vtu";
        let mut child = start(&folder, line, Stdio::null());
        let (status, time) = interrupt(&mut child, Duration::from_millis(millis));
        if status.code() == Some(130) {
            assert!(time < SOON, "took {time:?} after {millis} ms");
            cancelled += 1;
        }
        let out = folder.path().join("out");
        for entry in std::fs::read_dir(&out).into_iter().flatten() {
            let path = entry.expect("an entry").path();
            let is_whole = std::fs::read(&path).expect("a file") == whole;
            assert!(is_whole, "{} after {millis} ms", path.display());
        }
        drop(std::fs::remove_dir_all(out));
    }
    assert!(cancelled > 0, "never fast enough to interrupt");
}

/// An array of points with heights, as NumPy writes it.
fn with_heights(count: usize) -> Vec<u8> {
    let shape = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({count}, 3), }}");
    let header = format!("{shape:<117}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(
        u16::try_from(header.len())
            .expect("a short header")
            .to_le_bytes(),
    );
    bytes.extend(header.as_bytes());
    let mut state = 1_u64;
    for _ in 0..3 * count {
        // Knuth's linear congruence; the upper bits are good enough for points.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        bytes.extend(((state >> 11) as f64 / (1_u64 << 53) as f64).to_le_bytes());
    }
    bytes
}

/// Interrupts a command after various times; only its input must be there then.
fn interrupt_again_and_again(folder: &Folder, line: &str, input: &str) {
    let mut cancelled = 0;
    for millis in [30, 120, 300, 700, 1500] {
        let mut child = start(folder, line, Stdio::null());
        let (status, time) = interrupt(&mut child, Duration::from_millis(millis));
        if matches!(status.code(), Some(0 | 5)) {
            // A machine so fast that everything was done by then.
            continue;
        }
        assert_eq!(status.code(), Some(130), "after {millis} ms");
        assert!(time < SOON, "took {time:?} after {millis} ms");
        assert_eq!(folder.names(), [input], "after {millis} ms");
        cancelled += 1;
    }
    assert!(cancelled > 0, "never fast enough to interrupt");
}

#[test]
fn ctrl_c_ends_a_wait_for_standard_input() {
    let folder = Folder::new();
    let mut child = start(&folder, "triangulate -", Stdio::piped());
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin.write_all(b"0,0\n").expect("the program reads");
    let (status, time) = interrupt(&mut child, Duration::from_millis(150));
    drop(stdin);
    assert_eq!(status.code(), Some(130));
    assert!(time < SOON, "took {time:?}");
}

#[test]
fn an_old_file_survives_a_cancelled_run() {
    let folder = Folder::new();
    folder.run("sample uniform -n 1000000 -o points.npy", 0);
    folder.write("mesh.vtu", "old");
    let mut child = start(&folder, "triangulate points.npy -o mesh.vtu", Stdio::null());
    let (status, _) = interrupt(&mut child, Duration::from_millis(100));
    if status.code() == Some(130) {
        assert_eq!(folder.read("mesh.vtu"), "old");
    }
    assert_eq!(folder.names(), ["mesh.vtu", "points.npy"]);
}

#[test]
fn other_signals_have_their_own_exit_codes() {
    let folder = Folder::new();
    for (signal, code) in [(libc::SIGTERM, 143), (libc::SIGHUP, 129)] {
        let mut child = start(&folder, "triangulate -", Stdio::piped());
        sleep(Duration::from_millis(150));
        send(&mut child, signal);
        // The pipe stays open until the program has ended.
        let stdin = child.stdin.take();
        let status = child.wait().expect("the program ends");
        drop(stdin);
        assert_eq!(status.code(), Some(code));
    }
}

#[test]
fn signals_that_were_ignored_from_the_start_stay_ignored() {
    let folder = Folder::new();
    let mut child = Command::new("sh")
        .args([
            "-c",
            "trap '' HUP INT; exec \"$0\" -q triangulate - -o mesh.vtu",
        ])
        .arg(assert_cmd::cargo::cargo_bin("delone"))
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .spawn()
        .expect("the shell starts");
    sleep(Duration::from_millis(150));
    send(&mut child, libc::SIGHUP);
    send(&mut child, libc::SIGINT);
    sleep(Duration::from_millis(150));
    let mut stdin = child.stdin.take().expect("a pipe");
    stdin
        .write_all(support::POINTS.as_bytes())
        .expect("the program reads");
    drop(stdin);
    let status = child.wait().expect("the program ends");
    assert_eq!(status.code(), Some(0));
    assert_eq!(folder.names(), ["mesh.vtu"]);
}
