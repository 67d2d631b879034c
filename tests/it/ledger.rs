//! A pixel's tree adds up.

use raytree::tree::{Keep, Ledger};

use crate::support::{grid, scenes, tracer, tree};

#[test]
fn every_scene_balances() {
    for (name, loaded) in scenes() {
        let tracer = tracer::<f64>(&loaded.scene);
        let named = loaded.scene.pixels.iter().map(|(_, pixel)| *pixel);
        for pixel in named.chain(grid(&loaded.scene, 100)) {
            let ledger = Ledger::of(&tree(&tracer, &loaded, pixel, Keep::Outcomes));
            assert!(ledger.balances(), "{name} at {pixel:?}\n{ledger}");
        }
    }
}

#[test]
fn a_wrong_term_does_not_balance() {
    let (_, loaded) = scenes().into_iter().find(|(name, _)| name == "whitted").unwrap();
    let pixel = loaded.scene.pixels[0].1;
    let mut tree = tree(&tracer::<f64>(&loaded.scene), &loaded, pixel, Keep::Outcomes);
    tree.color[1] += 1e-11;
    assert!(!Ledger::of(&tree).balances());
}
