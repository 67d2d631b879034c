//! The server of the step-through page, asked over sockets as a stranger would; and the page as one file.

mod client;
mod endpoints;
mod export;
mod guard;
mod hostile;
mod patience;
mod scenes;

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use client::Answer;
use raytree::inspector::{Inspector, Limits, PANE, Settings, serve};
use raytree::pictures::diagrams::{Input, Kind};
use raytree::scene::Scene;
use raytree::tree::{NodePath, RayTree};

/// The input of a diagram of a node, as the page has it.
fn input<'a>(scene: &'a Scene, tree: &'a RayTree, path: NodePath, kind: Kind) -> Input<'a> {
    let input = Input::new(scene, tree, path).unwrap();
    if kind.is_of_the_whole_tree() { input } else { input.on_page(PANE.x, PANE.y) }
}

/// A server that ends with the test.
struct Site {
    port: u16,
    inspector: Arc<Inspector>,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Site {
    /// Of a scene file, with limits.
    fn with(file: &str, limits: Limits) -> Self {
        let text = std::fs::read_to_string(file).unwrap();
        let mut meshes = raytree::scene::meshes_beside(file);
        let inspector = Arc::new(Inspector::new(file, &text, Settings::default(), &mut meshes).unwrap());
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        let stop = Arc::new(AtomicBool::new(false));
        let thread = std::thread::spawn({
            let (inspector, stop) = (inspector.clone(), stop.clone());
            move || serve(listener, inspector, limits, &stop).unwrap()
        });
        Self { port, inspector, stop, thread: Some(thread) }
    }

    /// Of a scene file.
    fn of(file: &str) -> Self {
        Self::with(file, Limits::default())
    }

    /// What `GET` gives.
    fn get(&self, path: &str) -> Answer {
        client::ask(
            self.port,
            format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n\r\n", self.port),
        )
    }

    /// What a good `GET` gives.
    fn good(&self, path: &str) -> Answer {
        let answer = self.get(path);
        assert_eq!(answer.status, 200, "{path}: {}", answer.text());
        answer
    }

    /// What posting a scene's text with settings gives.
    fn post(&self, text: &str, settings: &serde_json::Value) -> Answer {
        let body = match settings {
            &NO_SETTINGS => serde_json::json!({ "text": text }),
            settings => serde_json::json!({ "text": text, "settings": settings }),
        };
        let body = body.to_string();
        let head = format!(
            "POST /api/scenes HTTP/1.1\r\nHost: localhost:{}\r\nX-Raytree: 1\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n",
            self.port,
            body.len()
        );
        client::ask(self.port, head + &body)
    }

    /// The id of the scene that was given.
    fn id(&self) -> String {
        self.good("/api/scene").json()["id"].as_str().unwrap().to_owned()
    }

    /// The id of a posted scene.
    fn posted(&self, text: &str, settings: &serde_json::Value) -> String {
        let answer = self.post(text, settings);
        assert_eq!(answer.status, 200, "{}", answer.text());
        answer.json()["id"].as_str().unwrap().to_owned()
    }
}

impl Drop for Site {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            let ended = thread.join();
            assert!(ended.is_ok() || std::thread::panicking());
        }
    }
}

/// Waits until something holds.
fn soon(what: &str, holds: impl Fn() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < Duration::from_secs(20), "{what} does not come");
        std::thread::sleep(Duration::from_millis(5));
    }
}

const NO_SETTINGS: serde_json::Value = serde_json::Value::Null;

/// A scene of which every pixel takes practically for ever.
fn endless() -> String {
    let mirrors = crate::support::FACING_MIRRORS;
    format!(
        r#"{{ "image": {{ "width": 64, "height": 48 }},
        "camera": {{ "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 60 }},
        "max_depth": 64, "ray_budget": 1000000000000,
        "materials": {{ "m": {{ "reflection": 1, "transmission": 1, "ior": 1.5 }} }},
        "objects": [ {mirrors}, {{ "material": "m", "shape": {{ "box": {{ "min": [-5, -5, -0.5], "max": [5, 5, -0.25] }} }} }} ] }}"#
    )
}
