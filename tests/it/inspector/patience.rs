//! Work that nobody waits for, clients that are slow, and clients at the same time.

use std::io::{Read, Write};
use std::time::{Duration, Instant};

use raytree::inspector::Limits;

use super::client::{self, connect};
use super::{NO_SETTINGS, Site, endless, soon};

#[test]
fn work_ends_when_the_client_goes() {
    let site = Site::of("scenes/first-hit.json");
    let id = site.posted(&endless(), &NO_SETTINGS);
    for what in ["render", "overlay?kind=rays", "overlay?kind=time"] {
        let mut stream = connect(site.port);
        let request = format!("GET /api/scenes/{id}/{what} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", site.port);
        stream.write_all(request.as_bytes()).unwrap();
        soon("work", || site.inspector.running() > 0);
        std::thread::sleep(Duration::from_millis(50));
        assert!(site.inspector.running() > 0, "{what} goes on");
        drop(stream);
        soon("the end of the work", || site.inspector.running() == 0);
    }
}

#[test]
fn a_server_that_is_stopped_stops_its_work() {
    let site = Site::of("scenes/first-hit.json");
    let id = site.posted(&endless(), &NO_SETTINGS);
    let mut stream = connect(site.port);
    let request = format!("GET /api/scenes/{id}/render HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", site.port);
    stream.write_all(request.as_bytes()).unwrap();
    soon("work", || site.inspector.running() > 0);
    let inspector = site.inspector.clone();
    let start = Instant::now();
    drop(site);
    assert!(start.elapsed() < Duration::from_secs(10));
    soon("the end of the work", || inspector.running() == 0);
}

#[test]
fn clients_do_not_wait_for_each_other() {
    let site = Site::of("scenes/first-hit.json");
    let slow = site.posted(&endless(), &NO_SETTINGS);
    let mut streams = Vec::new();
    for _ in 0..3 {
        let mut stream = connect(site.port);
        let request = format!("GET /api/scenes/{slow}/render HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", site.port);
        stream.write_all(request.as_bytes()).unwrap();
        streams.push(stream);
    }
    soon("their work", || site.inspector.running() >= 3);
    let id = site.id();
    let render = site.good(&format!("/api/scenes/{id}/render")).body;
    std::thread::scope(|scope| {
        for i in 0..4 {
            let (site, id, render) = (&site, &id, &render);
            scope.spawn(move || {
                assert_eq!(site.good(&format!("/api/scenes/{id}/recording?x={i}&y=7")).json()["tree"]["pixel"][0], i);
                let again = site.good(&format!("/api/scenes/{id}/render")).body;
                assert_eq!(again.len() / 1000, render.len() / 1000);
            });
        }
    });
    drop(streams);
    soon("the end of the work", || site.inspector.running() == 0);
}

#[test]
fn a_client_that_takes_nothing_costs_nothing() {
    let limits = Limits { answer: Duration::from_millis(300), ..Limits::default() };
    let site = Site::with("scenes/first-hit.json", limits);
    let text = std::fs::read_to_string("scenes/first-hit.json").unwrap();
    let mut large: serde_json::Value = serde_json::from_str(&text).unwrap();
    large["image"] = serde_json::json!({ "width": 4096, "height": 4096 });
    large.as_object_mut().unwrap().remove("pixels");
    let id = site.posted(&large.to_string(), &NO_SETTINGS);
    let mut stream = connect(site.port);
    let request = format!("GET /api/scenes/{id}/render HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", site.port);
    stream.write_all(request.as_bytes()).unwrap();
    soon("work", || site.inspector.running() > 0);
    // Sockets hold some megabytes; the picture has 64 of them.
    let idle = || {
        std::thread::sleep(Duration::from_millis(400));
        site.inspector.running() == 0
    };
    soon("rest", || idle() && idle());
    let mut taken = Vec::new();
    stream.read_to_end(&mut taken).ok();
    assert!(taken.len() < 4096 * 4096 * 4, "the connection was ended");
}

#[test]
fn slow_heads_and_bodies_are_cut_off() {
    let short = Duration::from_millis(300);
    let site = Site::with("scenes/first-hit.json", Limits { head: short, body: short, ..Limits::default() });
    let start = Instant::now();
    // A letter at a time, each well in time.
    let mut stream = connect(site.port);
    let head = format!("GET /api/scene HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nX-Padding: {}", site.port, "x".repeat(10_000));
    let sent = head.bytes().take_while(|byte| {
        std::thread::sleep(Duration::from_millis(10));
        stream.write_all(&[*byte]).is_ok()
    });
    assert!(sent.count() < 1000, "it was cut off");
    assert!(start.elapsed() < Duration::from_secs(10));
    let mut stream = connect(site.port);
    let head = format!(
        "POST /api/scenes HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nX-Raytree: 1\r\nContent-Type: application/json\r\n\
         Content-Length: 1000\r\nConnection: close\r\n\r\n{{\"text\": ",
        site.port
    );
    stream.write_all(head.as_bytes()).unwrap();
    let mut bytes = Vec::new();
    stream.read_to_end(&mut bytes).ok();
    assert!(String::from_utf8_lossy(&bytes).starts_with("HTTP/1.1 408"), "{}", String::from_utf8_lossy(&bytes));
    site.good("/api/scene");
}

#[test]
fn those_who_say_nothing_make_room() {
    let site = Site::with("scenes/first-hit.json", Limits { connections: 8, ..Limits::default() });
    let mut silent = Vec::new();
    for i in 0..40 {
        let mut stream = connect(site.port);
        if i % 2 == 0 {
            stream.write_all(b"GET / HT").unwrap();
        }
        silent.push(stream);
        if i % 8 == 7 {
            let start = Instant::now();
            site.good("/api/scene");
            assert!(start.elapsed() < Duration::from_secs(5));
        }
    }
}

#[test]
fn bodies_have_a_limit() {
    let site = Site::of("scenes/first-hit.json");
    let post = |length: usize, body: &[u8], encoding: &str| {
        let length = if encoding.is_empty() { format!("Content-Length: {length}\r\n") } else { encoding.to_owned() };
        let head = format!(
            "POST /api/scenes HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nX-Raytree: 1\r\nContent-Type: application/json\r\n\
             {length}Connection: close\r\n\r\n",
            site.port
        );
        client::raw(site.port, &[head.as_bytes(), body].concat())
    };
    let status = |bytes: &[u8]| String::from_utf8_lossy(&bytes[..bytes.len().min(12)]).into_owned();
    assert_eq!(status(&post((1 << 20) + 1, b"", "")), "HTTP/1.1 413");
    assert_eq!(status(&post(1 << 40, b"", "")), "HTTP/1.1 413");
    // Spaces are JSON as well: the largest body is read and found to be no scene.
    assert_eq!(status(&post(1 << 20, &vec![b' '; 1 << 20], "")), "HTTP/1.1 400");
    let chunk = [format!("{:x}\r\n", (1 << 20) + 1).into_bytes(), vec![b' '; (1 << 20) + 1], b"\r\n0\r\n\r\n".to_vec()]
        .concat();
    let told = status(&post(0, &chunk, "Transfer-Encoding: chunked\r\n"));
    // The connection may end before all was sent, and what was told be lost with it.
    assert!(told == "HTTP/1.1 413" || told.is_empty(), "{told}");
    site.good("/api/scene");
}
