use super::super::tests::{LARGE, page};
use super::*;
use std::path::PathBuf;

const PORT: u16 = 8000;

fn house(lent: Vec<Lent>) -> House {
    House {
        page: page(),
        lent,
        port: PORT,
    }
}

fn get(target: &str) -> Asked<'_> {
    Asked {
        is_read: true,
        target,
        hosts: vec!["127.0.0.1:8000"],
        takes_gzip: true,
    }
}

fn value(answer: &Answer<'_>, name: &str) -> Option<&'static str> {
    let found = answer.head.iter().find(|(known, _)| *known == name);
    found.map(|(_, value)| *value)
}

fn bytes(answer: Answer<'_>) -> Vec<u8> {
    match answer.body {
        Body::Bytes(bytes) => bytes.into_owned(),
        Body::File(mut file, _) => {
            let mut bytes = Vec::new();
            std::io::Read::read_to_end(&mut file, &mut bytes).expect("a file");
            bytes
        }
    }
}

#[test]
fn the_page_is_fresh_and_its_hashed_parts_are_kept() {
    let house = house(Vec::new());
    for (target, cache) in [
        ("/", "no-cache"),
        ("/?lang=de", "no-cache"),
        ("/guide/", "no-cache"),
        ("/guide/index.html", "no-cache"),
        ("/index.html", "no-cache"),
        (
            "/assets/index-abcd1234.js",
            "public, max-age=31536000, immutable",
        ),
        (
            "/assets/index%2Dabcd1234.js",
            "public, max-age=31536000, immutable",
        ),
    ] {
        let answer = house.answer(&get(target));
        assert_eq!(answer.status, 200, "{target}");
        assert_eq!(value(&answer, "Cache-Control"), Some(cache), "{target}");
        assert_eq!(value(&answer, "Content-Encoding"), Some("gzip"));
    }
}

#[test]
fn who_takes_no_gzip_gets_the_same_unpacked() {
    let house = house(Vec::new());
    let asked = Asked {
        takes_gzip: false,
        ..get("/assets/index-abcd1234.js")
    };
    let answer = house.answer(&asked);
    assert_eq!(value(&answer, "Content-Encoding"), None);
    assert_eq!(value(&answer, "Vary"), Some("Accept-Encoding"));
    assert_eq!(
        value(&answer, "Content-Type"),
        Some("text/javascript; charset=utf-8")
    );
    assert_eq!(bytes(answer), LARGE.repeat(10_000).into_bytes());
}

#[test]
fn only_who_calls_this_machine_by_its_name_is_answered() {
    let house = house(Vec::new());
    let statuses = |hosts: &[&'static str]| {
        let hosts = hosts.to_vec();
        house.answer(&Asked { hosts, ..get("/") }).status
    };
    for good in ["127.0.0.1:8000", "localhost:8000", "LocalHost:8000"] {
        assert_eq!(statuses(&[good]), 200, "{good}");
    }
    for bad in [
        "",
        "127.0.0.1",
        "127.0.0.1:8001",
        "127.0.0.1:",
        "127.0.0.1:8000:8000",
        "127.0.0.1.evil.example:8000",
        "evil.example:8000",
        "evil.example",
        "[::1]:8000",
        "127.0.0.1:99999999999",
    ] {
        assert_eq!(statuses(&[bad]), 403, "{bad}");
    }
    assert_eq!(statuses(&[]), 403);
    assert_eq!(statuses(&["127.0.0.1:8000", "evil.example"]), 403);
}

#[test]
fn the_usual_port_need_not_be_named() {
    let house = House {
        port: 80,
        ..house(Vec::new())
    };
    let hosts = vec!["127.0.0.1"];
    assert_eq!(house.answer(&Asked { hosts, ..get("/") }).status, 200);
}

#[test]
fn no_path_leads_out() {
    let house = house(vec![Lent::from(PathBuf::from("points.csv"))]);
    for (target, status) in [
        ("/nothing", 404),
        ("/../Cargo.toml", 404),
        ("/..%2FCargo.toml", 404),
        ("/%2e%2e/Cargo.toml", 404),
        ("//etc/passwd", 404),
        ("/open/", 404),
        ("/open/../Cargo.toml", 404),
        ("/open/%2Fetc%2Fpasswd", 404),
        ("/open/Cargo.toml", 404),
        ("/INDEX.HTML", 404),
        ("/index.html/", 404),
        ("/guide", 404),
        ("/guide//", 404),
        ("/%00", 404),
        ("/%ff", 400),
        ("/%", 404),
        ("", 400),
        ("*", 400),
        ("http://127.0.0.1:8000/", 400),
    ] {
        let answer = house.answer(&get(target));
        assert_eq!(answer.status, status, "{target}");
        assert_eq!(value(&answer, "Content-Security-Policy"), Some(POLICY));
    }
}

#[test]
fn nothing_is_taken_but_questions() {
    let house = house(Vec::new());
    let asked = Asked {
        is_read: false,
        ..get("/")
    };
    let answer = house.answer(&asked);
    assert_eq!(
        (answer.status, value(&answer, "Allow")),
        (405, Some("GET, HEAD"))
    );
}

#[test]
fn lent_files_are_bytes_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a b.html");
    std::fs::write(&path, "<p>first").expect("a file");
    let stream = Lent {
        name: "input.csv".to_owned(),
        content: Content::Bytes(b"0,0\n".to_vec()),
    };
    let house = house(vec![Lent::from(path.clone()), stream]);
    let answer = house.answer(&get("/open/a%20b.html"));
    assert_eq!(
        value(&answer, "Content-Type"),
        Some("application/octet-stream")
    );
    assert_eq!(value(&answer, "X-Content-Type-Options"), Some("nosniff"));
    assert_eq!(bytes(answer), b"<p>first");
    assert_eq!(bytes(house.answer(&get("/open/input.csv"))), b"0,0\n");

    std::fs::write(&path, "second").expect("a file");
    assert_eq!(bytes(house.answer(&get("/open/a%20b.html"))), b"second");
    std::fs::remove_file(&path).expect("a file");
    assert_eq!(house.answer(&get("/open/a%20b.html")).status, 404);
}

#[test]
fn encodings_are_weighed() {
    for (accepted, expected) in [
        ("gzip, deflate, br, zstd", true),
        ("br;q=1.0, GZIP;q=0.5", true),
        ("gzip;q=0", false),
        ("gzip;q=0.000", false),
        ("gzip;q=x", false),
        ("x-gzip", false),
        ("identity", false),
        ("", false),
    ] {
        assert_eq!(takes_gzip(accepted), expected, "{accepted}");
    }
}
