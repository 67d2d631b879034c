//! Writes the committed meshes: `cargo run --example generate-meshes`.

use std::path::Path;

mod shapes;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/meshes");
    for (name, bytes) in shapes::all() {
        std::fs::write(folder.join(name), &bytes)?;
        println!("{name}: {} bytes", bytes.len());
    }
    Ok(())
}
