//! `delone theatre`: a page that the program serves, if one was built into it; and what is said if not.
#![cfg(unix)]

mod support;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use support::{Folder, POINTS};

/// Whether the program was built with a page. What needs one is tested without it, too: by the unit tests of the room.
const HAS_PAGE: bool = cfg!(has_page);

/// A program that serves the page.
struct Theatre {
    child: Child,
    address: String,
}

impl Theatre {
    /// Opens it, writes to its standard input, and waits for the address.
    fn open(folder: &Folder, line: &str, stdin: &str) -> Self {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("delone"));
        command
            .current_dir(folder.path())
            .args(["theatre", "--no-open"])
            .args(line.split_whitespace())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        // Whoever runs the tests may have the signal ignored, as jobs in the background do.
        // SAFETY: between fork and exec nothing but `signal` is called, which is allowed there.
        unsafe { command.pre_exec(heed_ctrl_c) };
        let mut child = command.spawn().expect("the program starts");
        let mut input = child.stdin.take().expect("a pipe");
        input.write_all(stdin.as_bytes()).expect("it takes bytes");
        drop(input);
        let stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let address = stdout.lines().next().expect("a line").expect("UTF-8");
        Self { child, address }
    }

    fn port(&self) -> u16 {
        let rest = self.address.strip_prefix("http://127.0.0.1:");
        let (port, _) = rest.and_then(|rest| rest.split_once('/')).expect("a port");
        port.parse().expect("a number")
    }

    /// Gets something, and returns head and body.
    fn get(&self, target: &str) -> (String, Vec<u8>) {
        let port = self.port();
        let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("it listens");
        let patience = Some(Duration::from_secs(20));
        stream.set_read_timeout(patience).expect("a timeout");
        let request =
            format!("GET {target} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n");
        stream
            .write_all(request.as_bytes())
            .expect("it takes bytes");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("an answer");
        let end = answer.windows(4).position(|window| window == b"\r\n\r\n");
        let (head, body) = answer.split_at(end.expect("a head") + 4);
        (String::from_utf8_lossy(head).into_owned(), body.to_vec())
    }

    /// Sends a signal and returns the exit code.
    fn end(mut self, signal: libc::c_int) -> Option<i32> {
        let id = libc::pid_t::try_from(self.child.id()).expect("a process id");
        // SAFETY: the child has not been waited for, so the id is still its own.
        assert_eq!(unsafe { libc::kill(id, signal) }, 0);
        self.child.wait().expect("the program ends").code()
    }
}

fn heed_ctrl_c() -> std::io::Result<()> {
    for signal in [libc::SIGINT, libc::SIGTERM] {
        // SAFETY: the default action needs no handler.
        unsafe { libc::signal(signal, libc::SIG_DFL) };
    }
    Ok(())
}

#[test]
fn without_a_page_it_says_how_to_build_one() {
    if HAS_PAGE {
        return;
    }
    let output = Folder::new().run("theatre --no-open", 4);
    assert_eq!(output.stdout, "");
    output.says(&["without the page", "delone-web-build -- --open", "Node.js"]);
}

#[test]
fn the_page_is_served_until_ctrl_c() {
    if !HAS_PAGE {
        return;
    }
    let theatre = Theatre::open(&Folder::new(), "", "");
    let (head, body) = theatre.get("/");
    assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
    assert!(
        head.contains("Content-Type: text/html; charset=utf-8\r\n"),
        "{head}"
    );
    let page = String::from_utf8_lossy(&body).to_lowercase();
    assert!(page.starts_with("<!doctype html>"), "{page}");
    assert!(theatre.get("/nothing").0.starts_with("HTTP/1.1 404 "));
    assert_eq!(theatre.end(libc::SIGINT), Some(0));

    // To be terminated is not the usual way, and has its own code.
    let theatre = Theatre::open(&Folder::new(), "", "");
    assert_eq!(theatre.end(libc::SIGTERM), Some(143));
}

#[test]
fn files_and_streams_are_lent_to_the_page() {
    if !HAS_PAGE {
        return;
    }
    let folder = Folder::new();
    folder.write("p,q.csv", POINTS);
    let theatre = Theatre::open(&folder, "p,q.csv", "");
    assert!(
        theatre.address.ends_with("/#open=open/p%2Cq.csv"),
        "{}",
        theatre.address
    );
    assert_eq!(theatre.get("/open/p%2Cq.csv").1, POINTS.as_bytes());
    assert_eq!(theatre.end(libc::SIGINT), Some(0));

    let theatre = Theatre::open(&folder, "-", POINTS);
    assert!(
        theatre.address.ends_with("/#open=open/input.csv"),
        "{}",
        theatre.address
    );
    assert_eq!(theatre.get("/open/input.csv").1, POINTS.as_bytes());
    assert_eq!(theatre.end(libc::SIGINT), Some(0));
}

#[test]
fn what_cannot_be_read_is_said_before_anything_is_served() {
    if !HAS_PAGE {
        return;
    }
    let folder = Folder::new();
    folder.write("word.csv", "x,y\n0,0\n1,zero\n");
    for (name, word) in [("nowhere.poly", "nowhere.poly"), ("word.csv", "word.csv:3")] {
        let output = folder.run(&format!("theatre --no-open {name}"), 3);
        assert_eq!(output.stdout, "");
        output.says(&[word]);
    }
}

#[test]
fn ports_are_numbers_of_sixteen_bits() {
    let folder = Folder::new();
    folder
        .run("theatre --no-open --port 65536", 2)
        .says(&["--port", "65536"]);
}
