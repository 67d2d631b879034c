//! Ten thousand requests that nobody should send, to the program as people run it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use super::client::{self, Answer};

/// A little randomness from a fixed seed. Source: Vigna, splitmix64.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    fn of<T: Copy>(&mut self, among: &[T]) -> T {
        among[self.below(among.len())]
    }

    fn bytes(&mut self, most: usize) -> Vec<u8> {
        let count = self.below(most);
        (0..count).map(|_| self.next() as u8).collect()
    }

    /// A number as text, some of them no numbers of any machine.
    fn number(&mut self) -> String {
        match self.below(6) {
            0 => self.below(12).to_string(),
            1 => self.next().to_string(),
            2 => format!("-{}", self.below(9)),
            3 => "1e9".to_owned(),
            4 => "9".repeat(40),
            _ => self.of(&["", "NaN", "0x1", "%00", "1.5", "٣"]).to_owned(),
        }
    }

    /// The text with some of its bytes changed, taken out, or doubled.
    fn damaged(&mut self, text: &[u8]) -> Vec<u8> {
        let mut text = text.to_vec();
        for _ in 0..self.below(4) + 1 {
            let at = self.below(text.len().max(1)).min(text.len().saturating_sub(1));
            match self.below(4) {
                0 if !text.is_empty() => text[at] = self.next() as u8,
                1 if !text.is_empty() => text[at] ^= 1 << self.below(8),
                2 if !text.is_empty() => drop(text.remove(at)),
                _ => text.truncate(at),
            }
        }
        text
    }
}

/// A server that ends with the test.
struct Served {
    child: Child,
    port: u16,
}

impl Served {
    fn start(scene: &str) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_raytree"))
            .args(["inspect", scene])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let port = line.strip_prefix("http://127.0.0.1:").and_then(|rest| rest.strip_suffix("/\n"));
        Self { child, port: port.unwrap_or_else(|| panic!("{line}")).parse().unwrap() }
    }

    /// Memory in use in KiB, where the system says so.
    fn memory(&self) -> Option<u64> {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).ok()?;
        let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
        line.split_whitespace().nth(1)?.parse().ok()
    }

    fn good(&self, path: &str) -> Answer {
        let request = format!("GET {path} HTTP/1.1\r\nHost: localhost:{}\r\nConnection: close\r\n\r\n", self.port);
        let answer = client::ask(self.port, request);
        assert_eq!(answer.status, 200, "{path}");
        answer
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.child.kill().ok();
        self.child.wait().ok();
    }
}

/// Sends bytes, says that no more will come, and reads what comes back.
fn send(port: u16, bytes: &[u8]) -> Vec<u8> {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    stream.set_write_timeout(Some(Duration::from_secs(30))).unwrap();
    stream.write_all(bytes).ok();
    stream.shutdown(Shutdown::Write).ok();
    let mut told = Vec::new();
    if let Err(error) = stream.read_to_end(&mut told) {
        assert!(error.kind() != std::io::ErrorKind::WouldBlock, "no end: {:?}", String::from_utf8_lossy(bytes));
    }
    told
}

fn request(dice: &mut Dice, port: u16, id: &str, scene: &str) -> Vec<u8> {
    let host = match dice.below(8) {
        0 => "evil.example".to_owned(),
        1 => format!("127.0.0.1:{}", dice.next() as u16),
        _ => format!("127.0.0.1:{port}"),
    };
    let id = if dice.below(4) == 0 { dice.of(&["x", "..", "%2e%2e", "0", ""]) } else { id };
    let (x, y) = (dice.number(), dice.number());
    let target = match dice.below(12) {
        0 => "/".to_owned(),
        1 => format!("/page/{}", dice.of(&["..", "../../Cargo.toml", "..%2f..%2fCargo.toml", "%00", "app.js", "a/b"])),
        2 => format!("/{}", "../".repeat(dice.below(30))) + dice.of(&["etc/passwd", "Cargo.toml", "proc/self/environ"]),
        3 => "/api/scene".to_owned(),
        4 => format!("/api/scenes/{id}/recording?x={x}&y={y}"),
        5 => format!(
            "/api/scenes/{id}/diagram?x={x}&y={y}&kind={}&node={}",
            dice.of(&["tree", "box", "", "%ff"]),
            dice.number()
        ),
        6 => format!("/api/scenes/{id}/overlay?kind={}", dice.of(&["rays", "stage", "", "RAYS", "rays&kind=rays"])),
        7 => format!(
            "/api/scenes/{id}/{}",
            dice.of(&["render", "geometry", "export?pixel=x", "difference?x=1", "%2e%2e"])
        ),
        8 => format!("/api/scenes/{id}/diagram?{}", "a=b&".repeat(dice.below(400))),
        9 => "/".repeat(dice.below(9000)),
        10 => format!("http://{host}/api/scene"),
        _ => String::from_utf8_lossy(&dice.bytes(60)).into_owned(),
    };
    let method = dice.of(&["GET", "GET", "GET", "HEAD", "PUT", "OPTIONS", "CONNECT", "get", "", "\u{0}"]);
    match dice.below(10) {
        0 => dice.bytes(300),
        1 => format!("{method} {target} HTTP/{}\r\nHost: {host}\r\n\r\n", dice.of(&["1.0", "2.0", "1.1", "9", ""]))
            .into_bytes(),
        2 => {
            let header = dice.of(&["X", "Host", "Origin", "Cookie", "Range", "Expect", "Upgrade", "\u{1}", ""]);
            let value = "v".repeat(dice.below(40_000));
            format!("GET {target} HTTP/1.1\r\nHost: {host}\r\n{header}: {value}\r\n\r\n").into_bytes()
        }
        3 => {
            let headers: String = (0..dice.below(300)).map(|i| format!("X-{i}: {i}\r\n")).collect();
            format!("GET {target} HTTP/1.1\r\nHost: {host}\r\n{headers}\r\n").into_bytes()
        }
        4..=6 => {
            let text = match dice.below(4) {
                0 => vec![b'['; dice.below(3000)],
                1 => dice.bytes(300),
                _ => dice.damaged(scene.as_bytes()),
            };
            let body = serde_json::json!({ "text": String::from_utf8_lossy(&text), "settings": { "max_depth": dice.below(99) } });
            let mut body = body.to_string().into_bytes();
            if dice.below(3) == 0 {
                body = dice.damaged(&body);
            }
            let length = match dice.below(8) {
                0 => format!("Content-Length: {}\r\n", dice.number()),
                1 => "Transfer-Encoding: chunked\r\n".to_owned(),
                2 => {
                    format!("Content-Length: {0}\r\nContent-Length: {0}\r\nTransfer-Encoding: chunked\r\n", body.len())
                }
                _ => format!("Content-Length: {}\r\n", body.len()),
            };
            let mark = if dice.below(9) == 0 { "" } else { "X-Raytree: 1\r\n" };
            let head = format!(
                "POST /api/scenes HTTP/1.1\r\nHost: {host}\r\n{mark}Content-Type: application/json\r\n{length}\
                 Connection: close\r\n\r\n"
            );
            [head.into_bytes(), body].concat()
        }
        7 => {
            let good = format!("GET {target} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
            dice.damaged(good.as_bytes())
        }
        8 => format!("GET {target} HTTP/1.1\r\nHost: {host}\r\n\r\n").repeat(dice.below(8)).into_bytes(),
        _ => format!("{method} {target} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").into_bytes(),
    }
}

#[test]
fn ten_thousand_hostile_requests() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string("scenes/glass-ball.json").unwrap()).unwrap();
    scene["image"] = serde_json::json!({ "width": 8, "height": 6 });
    scene.as_object_mut().unwrap().remove("pixels");
    let scene = scene.to_string();
    let file = folder.path().join("scene.json");
    std::fs::write(&file, &scene).unwrap();
    let served = Served::start(file.to_str().unwrap());
    let first = served.good("/api/scene");
    let id = first.json()["id"].as_str().unwrap().to_owned();
    let mut dice = Dice(5);
    let mut before = None;
    let (mut answered, mut fine) = (0, 0);
    for i in 0..10_000 {
        if i % 500 == 0 {
            assert_eq!(served.good("/api/scene").body, first.body, "after {i}");
        }
        // By then every buffer and every list has been as full as it gets.
        if i == 2_000 {
            before = served.memory();
        }
        let bytes = request(&mut dice, served.port, &id, &scene);
        let told = send(served.port, &bytes);
        let text = String::from_utf8_lossy(&told);
        for secret in ["root:x:", "[package]", "PATH="] {
            assert!(!text.contains(secret), "{:?}", String::from_utf8_lossy(&bytes));
        }
        if let Some(status) = text.strip_prefix("HTTP/1.").and_then(|rest| rest.get(2..5)) {
            assert!(!status.starts_with('5'), "{status}: {:?}", String::from_utf8_lossy(&bytes));
            answered += 1;
            fine += u32::from(status == "200");
        }
    }
    assert!(answered > 5_000 && fine > 200, "{answered} answers, {fine} of them fine");
    if let (Some(before), Some(after)) = (before, served.memory()) {
        // What an allocator keeps varies; a request that left 10 KiB behind would add 80 MiB.
        assert!(after < before + 16 * 1024, "{before} KiB became {after} KiB");
    }
    served.good("/");
}

#[test]
fn ctrl_c_ends_it_with_the_code_for_that() {
    let mut served = Served::start("scenes/first-hit.json");
    served.good("/");
    let asked = Command::new("kill").args(["-INT", &served.child.id().to_string()]).status();
    if !asked.is_ok_and(|status| status.success()) {
        return; // A system without such a signal.
    }
    assert_eq!(served.child.wait().unwrap().code(), Some(130));
    let mut told = String::new();
    served.child.stderr.take().unwrap().read_to_string(&mut told).unwrap();
    assert_eq!(told, "interrupted\n");
}

#[test]
fn what_cannot_be_served_is_one_message() {
    let run = |args: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_raytree")).arg("inspect").args(args).output().unwrap();
        assert!(output.stdout.is_empty(), "{args:?}");
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, told) = run(&["nowhere.json"]);
    assert!(code == Some(2) && told.contains("there is no such file"), "{told}");
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let (code, told) = run(&["scenes/first-hit.json", "--port", &port]);
    assert!(code == Some(2) && told.contains("cannot be listened on"), "{told}");
    let (code, told) = run(&["scenes/first-hit.json", "--port", "65536"]);
    assert!(code == Some(2) && told.contains("65535"), "{told}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bad.json");
    std::fs::write(&file, "{").unwrap();
    let (code, told) = run(&[file.to_str().unwrap()]);
    assert!(code == Some(2) && told.contains("this is not JSON"), "{told}");
}
