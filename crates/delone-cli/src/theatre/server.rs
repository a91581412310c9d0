//! The server: listens on this machine alone, and hands each request to the [`House`], several at once.

use super::answer::{Answer, Asked, Body, House, takes_gzip};
use std::io::{self, Cursor, Read};
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::thread;
use tiny_http::{Header, Method, Request, Response, Server};

/// How many requests are answered at once: browsers ask for six.
const THREADS: usize = 8;

/// A place where this listens already, and nobody answers yet.
pub struct Door {
    listener: TcpListener,
    port: u16,
}

impl Door {
    /// Listens on a port of this machine, whose other side is nobody but this machine; 0 stands for any that is free.
    pub fn open(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = listener.local_addr()?.port();
        Ok(Self { listener, port })
    }

    /// Returns the port.
    pub fn port(&self) -> u16 {
        self.port
    }

    /// Answers requests from now on, in threads of its own.
    pub fn serve(self, house: House) -> io::Result<Service> {
        let server = Server::from_listener(self.listener, None).map_err(io::Error::other)?;
        let (server, house) = (Arc::new(server), Arc::new(house));
        let start = |number| {
            let (server, house) = (Arc::clone(&server), Arc::clone(&house));
            let named = thread::Builder::new().name(format!("theatre-{number}"));
            named.spawn(move || answer_all(&server, &house))
        };
        let threads = (0..THREADS).map(start).collect::<io::Result<_>>()?;
        Ok(Service { threads })
    }
}

/// A server at work.
pub struct Service {
    threads: Vec<thread::JoinHandle<io::Error>>,
}

impl Service {
    /// Waits until the server cannot go on, which is not to be expected, and returns why.
    pub fn wait(self) -> io::Error {
        let ended = self.threads.into_iter().map(thread::JoinHandle::join);
        let why = ended.filter_map(Result::ok).next();
        why.unwrap_or_else(|| io::Error::other("bug: the threads of the server have panicked"))
    }
}

/// Answers one request after the other, as long as there can be any.
fn answer_all(server: &Server, house: &House) -> io::Error {
    loop {
        let request = match server.recv() {
            Ok(request) => request,
            Err(error) => return error,
        };
        let answer = house.answer(&asked(&request));
        // Whoever asked may have gone; that is no trouble of anybody else.
        drop(request.respond(response(answer)));
    }
}

fn asked(request: &Request) -> Asked<'_> {
    let values = |name: &'static str| {
        let headers = request.headers().iter();
        let named = headers.filter(move |header| header.field.equiv(name));
        named.map(|header| header.value.as_str())
    };
    Asked {
        is_read: matches!(request.method(), Method::Get | Method::Head),
        target: request.url(),
        hosts: values("Host").collect(),
        takes_gzip: values("Accept-Encoding").any(takes_gzip),
    }
}

fn response(answer: Answer<'_>) -> Response<Box<dyn Read + '_>> {
    let (length, body): (u64, Box<dyn Read + '_>) = match answer.body {
        Body::Bytes(bytes) => (bytes.len() as u64, Box::new(Cursor::new(bytes))),
        Body::File(file, length) => (length, Box::new(file.take(length))),
    };
    let head = answer.head.iter().map(|(name, value)| {
        Header::from_bytes(*name, *value).expect("bug: a constant is no header")
    });
    // Where lengths are known, nothing needs to be sent in chunks.
    Response::new(
        answer.status.into(),
        head.collect(),
        body,
        usize::try_from(length).ok(),
        None,
    )
    .with_chunked_threshold(usize::MAX)
}

#[cfg(test)]
mod tests;
