//! Whom the server talks to, and that nothing but its own files can be read.

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raytree::inspector::{Inspector, Limits, Settings, serve};

use super::Site;
use super::client::{self, Answer};

const SCENE: &str = "scenes/first-hit.json";

fn get(site: &Site, path: &str, headers: &str) -> Answer {
    client::ask(site.port, format!("GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n"))
}

#[test]
fn only_its_own_names_are_answered_for() {
    let site = Site::of(SCENE);
    let port = site.port;
    for host in
        [format!("127.0.0.1:{port}"), format!("localhost:{port}"), format!("LOCALHOST:{port}"), format!("[::1]:{port}")]
    {
        assert_eq!(get(&site, "/api/scene", &format!("Host: {host}\r\n")).status, 200, "{host}");
    }
    let other = port ^ 1;
    for host in [
        "127.0.0.1".to_owned(),
        "localhost".to_owned(),
        format!("127.0.0.1:{other}"),
        format!("evil.example:{port}"),
        format!("127.0.0.1.evil.example:{port}"),
        format!("localhost.:{port}"),
        format!("localhost:{port}.evil.example"),
        format!("user@127.0.0.1:{port}"),
        format!("127.0.0.1:{port}, 127.0.0.1:{port}"),
        format!("127.1:{port}"),
        format!("0.0.0.0:{port}"),
        format!("[::ffff:127.0.0.1]:{port}"),
        String::new(),
    ] {
        for path in ["/", "/api/scene", "/page/style.css", "/nowhere"] {
            let answer = get(&site, path, &format!("Host: {host}\r\n"));
            assert_eq!(answer.status, 403, "{host} {path}: {}", answer.text());
            assert!(!answer.text().contains("camera"));
        }
    }
    assert_eq!(get(&site, "/", "").status, 403, "no host");
    let twice = format!("Host: 127.0.0.1:{port}\r\nHost: 127.0.0.1:{port}\r\n");
    assert!(matches!(get(&site, "/", &twice).status, 400 | 403), "two hosts");
    // A whole address in the request line counts as well as the header.
    let own = format!("Host: 127.0.0.1:{port}\r\n");
    assert_eq!(get(&site, &format!("http://127.0.0.1:{port}/api/scene"), &own).status, 200);
    for address in [format!("http://evil.example:{port}/api/scene"), format!("https://127.0.0.1:{port}/api/scene")] {
        assert_eq!(get(&site, &address, &own).status, 403, "{address}");
    }
}

#[test]
fn pages_of_others_get_nothing() {
    let site = Site::of(SCENE);
    let port = site.port;
    let host = format!("Host: 127.0.0.1:{port}\r\n");
    for own in [format!("http://127.0.0.1:{port}"), format!("http://localhost:{port}")] {
        assert_eq!(get(&site, "/api/scene", &format!("{host}Origin: {own}\r\n")).status, 200, "{own}");
    }
    for other in
        ["null", "http://evil.example", "https://127.0.0.1", "http://127.0.0.1", "http://127.0.0.1:1", "file://", ""]
    {
        assert_eq!(get(&site, "/api/scene", &format!("{host}Origin: {other}\r\n")).status, 403, "{other:?}");
    }
    for (from, status) in [("same-origin", 200), ("none", 200), ("cross-site", 403), ("same-site", 403), ("", 403)] {
        assert_eq!(get(&site, "/api/scene", &format!("{host}Sec-Fetch-Site: {from}\r\n")).status, status, "{from}");
    }
    // A link from elsewhere may open the page.
    assert_eq!(get(&site, "/", &format!("{host}Sec-Fetch-Site: cross-site\r\n")).status, 200);
}

#[test]
fn a_post_says_that_it_means_it() {
    let site = Site::of(SCENE);
    let body = serde_json::json!({ "text": std::fs::read_to_string(SCENE).unwrap(), "settings": {} }).to_string();
    let post = |headers: &str| {
        let head =
            format!("POST /api/scenes HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Length: {}\r\n", site.port, body.len());
        client::ask(site.port, format!("{head}{headers}Connection: close\r\n\r\n{body}")).status
    };
    assert_eq!(post("X-Raytree: 1\r\nContent-Type: application/json\r\n"), 200);
    assert_eq!(post("X-Raytree: 1\r\nContent-Type: application/json; charset=utf-8\r\n"), 200);
    assert_eq!(post("Content-Type: application/json\r\n"), 403);
    assert_eq!(post("X-Raytree: 2\r\nContent-Type: application/json\r\n"), 403);
    assert_eq!(post("X-Raytree: 1\r\n"), 415);
    assert_eq!(post("X-Raytree: 1\r\nContent-Type: text/plain\r\n"), 415);
    assert_eq!(post("X-Raytree: 1\r\nContent-Type: application/jsonx\r\n"), 415);
    // A browser asks first whether a page of another may send this; nobody says yes.
    let ask = format!(
        "OPTIONS /api/scenes HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nOrigin: http://evil.example\r\n\
         Access-Control-Request-Method: POST\r\nAccess-Control-Request-Headers: x-raytree\r\nConnection: close\r\n\r\n",
        site.port
    );
    let answer = client::ask(site.port, ask);
    assert_eq!(answer.status, 403);
    assert!(!answer.head.to_ascii_lowercase().contains("access-control"));
}

#[test]
fn every_answer_is_sealed() {
    let site = Site::of(SCENE);
    let id = site.id();
    let paths = ["/", "/page/style.css", "/api/scene", "/nowhere", "/api/scenes/x/render"].map(str::to_owned);
    for path in paths.into_iter().chain([format!("/api/scenes/{id}/render")]) {
        let answer = site.get(&path);
        let policy = answer.header("content-security-policy").unwrap();
        assert!(policy.starts_with("default-src 'none'; script-src 'self'; style-src 'self';"), "{path}");
        assert!(!policy.contains("unsafe") && policy.contains("frame-ancestors 'none'"), "{path}");
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"), "{path}");
        assert_eq!(answer.header("referrer-policy"), Some("no-referrer"), "{path}");
        assert_eq!(answer.header("cache-control"), Some("no-store"), "{path}");
    }
}

#[test]
fn no_path_leads_out() {
    let site = Site::of(SCENE);
    for path in [
        "/page/",
        "/page/..",
        "/page/../index.html",
        "/page/..%2findex.html",
        "/page/%2e%2e/%2e%2e/etc/passwd",
        "/page/..%252f..%252fetc%252fpasswd",
        "/page/..%5c..%5cCargo.toml",
        "/page/%c0%ae%c0%ae/Cargo.toml",
        "/page//etc/passwd",
        "/page/%2fetc%2fpasswd",
        "/page/etc/passwd",
        "//etc/passwd",
        "/../Cargo.toml",
        "/Cargo.toml",
        "/src/inspector/page/index.html",
        "/page/style.css/",
        "/page/STYLE.CSS",
        "/page/style.css%00",
        "/page/%00",
        "/page/README.md",
        "/scenes/whitted.json",
        "/api",
        "/api/",
        "/api/scenes/",
        "/api/scenes/../scene",
        "/api/scenes/%2e%2e/geometry",
        "*",
    ] {
        let answer = site.get(path);
        assert!(matches!(answer.status, 400 | 404 | 405), "{path}: {}", answer.status);
        assert!(!answer.text().contains("root:") && !answer.text().contains("[package]"), "{path}");
    }
    for method in ["PUT", "DELETE", "PATCH", "TRACE", "BREW"] {
        let request = format!("{method} / HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n\r\n", site.port);
        assert_eq!(client::ask(site.port, request).status, 405, "{method}");
    }
}

#[test]
fn only_on_the_loopback_address() {
    let text = std::fs::read_to_string(SCENE).unwrap();
    let inspector = Inspector::new(SCENE, &text, Settings::default(), &mut |_| Err("none".into())).unwrap();
    let listener = TcpListener::bind("0.0.0.0:0").unwrap();
    let served = serve(listener, Arc::new(inspector), Limits::default(), &AtomicBool::new(false));
    assert!(served.unwrap_err().to_string().contains("loopback"));
}
