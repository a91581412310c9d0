use super::super::tests::{LARGE, page};
use super::*;
use std::io::Write;
use std::net::TcpStream;
use std::time::Duration;

/// Serves a page, and returns the port.
fn serve() -> u16 {
    let door = Door::open(0).expect("a free port");
    let port = door.port();
    let house = House {
        page: page(),
        lent: Vec::new(),
        port,
    };
    // It serves until the tests end.
    door.serve(house).expect("a server");
    port
}

/// Sends bytes, and returns all that comes until the other side hangs up.
fn exchange(port: u16, sent: &[u8]) -> Vec<u8> {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("the server listens");
    stream
        .set_read_timeout(Some(Duration::from_secs(20)))
        .expect("a timeout");
    stream.write_all(sent).expect("it takes bytes");
    let mut received = Vec::new();
    // A refusal may end in a reset; what came before counts.
    drop(stream.read_to_end(&mut received));
    received
}

fn ask(port: u16, method: &str, more: &str) -> (String, Vec<u8>) {
    let target = "/assets/index-abcd1234.js";
    let sent = format!(
        "{method} {target} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n{more}\r\n"
    );
    let received = exchange(port, sent.as_bytes());
    let end = received.windows(4).position(|window| window == b"\r\n\r\n");
    let (head, body) = received.split_at(end.expect("a head") + 4);
    (String::from_utf8_lossy(head).into_owned(), body.to_vec())
}

#[test]
fn a_file_comes_whole_with_its_length() {
    let port = serve();
    let (head, body) = ask(port, "GET", "");
    let expected = LARGE.repeat(10_000).into_bytes();
    assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
    assert!(
        head.contains(&format!("Content-Length: {}\r\n", expected.len())),
        "{head}"
    );
    assert!(head.contains("wasm-unsafe-eval"), "{head}");
    assert_eq!(body, expected);

    let (head, body) = ask(port, "GET", "Accept-Encoding: br, gzip\r\n");
    assert!(head.contains("Content-Encoding: gzip\r\n"), "{head}");
    assert_eq!(body, page()[1].gzip);
}

#[test]
fn who_asks_for_the_head_gets_no_more() {
    let (head, body) = ask(serve(), "HEAD", "");
    assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
    let length = LARGE.len() * 10_000;
    assert!(
        head.contains(&format!("Content-Length: {length}\r\n")),
        "{head}"
    );
    assert_eq!(body, b"");
}

#[test]
fn many_are_answered_at_once() {
    let port = serve();
    // One that has connected and says nothing holds nobody up.
    let _silent = TcpStream::connect(("127.0.0.1", port)).expect("the server listens");
    let ask = || ask(port, "GET", "").1.len();
    let lengths = thread::scope(|scope| {
        let threads: Vec<_> = (0..20).map(|_| scope.spawn(ask)).collect();
        let lengths = threads.into_iter().map(|t| t.join().expect("an answer"));
        lengths.collect::<Vec<_>>()
    });
    assert_eq!(lengths, [LARGE.len() * 10_000; 20]);
}

#[test]
fn odd_requests_are_refused_and_the_next_is_answered() {
    let port = serve();
    let host = format!("Host: 127.0.0.1:{port}\r\nConnection: close");
    for (sent, status) in [
        (
            format!("POST / HTTP/1.1\r\n{host}\r\nContent-Length: 3\r\n\r\nabc"),
            "405",
        ),
        (format!("BREW / HTTP/1.1\r\n{host}\r\n\r\n"), "405"),
        (
            "GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n".to_owned(),
            "403",
        ),
        ("GET / HTTP/1.0\r\n\r\n".to_owned(), "403"),
        (format!("GET /%ff%00 HTTP/1.1\r\n{host}\r\n\r\n"), "400"),
        (format!("GET http://a/ HTTP/1.1\r\n{host}\r\n\r\n"), "400"),
        ("\r\n\r\n".to_owned(), "400"),
        ("\u{0}\u{1}\u{2} nonsense\r\n\r\n".to_owned(), "400"),
        (
            format!("GET / HTTP/1.1\r\n{host}\r\nContent-Length: -1\r\n\r\n"),
            "",
        ),
        (format!("GET / HTTP/9.9\r\n{host}\r\n\r\n"), ""),
        (
            format!("GET /{} HTTP/1.1\r\n{host}\r\n\r\n", "x".repeat(100_000)),
            "404",
        ),
    ] {
        let received = exchange(port, sent.as_bytes());
        let received = String::from_utf8_lossy(&received).into_owned();
        let first = received.lines().next().unwrap_or_default().to_owned();
        let sent: String = sent.chars().take(60).collect();
        assert!(first.contains(status), "{sent:?}: {first:?}");
        assert!(
            ask(port, "GET", "").0.starts_with("HTTP/1.1 200 "),
            "{sent:?}"
        );
    }
}

#[test]
fn two_cannot_listen_on_one_port() {
    let door = Door::open(0).expect("a free port");
    assert!(Door::open(door.port()).is_err());
}
