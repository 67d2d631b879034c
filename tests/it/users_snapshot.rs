//! What a renderer's own tests look like with this crate: its rays as a tree, the text as a snapshot. The README shows
//! this file.

// [the example]
use raytree::tree::{HitRecord, Kind, Outcome, RayNode, RayTree, Show};

#[test]
fn my_renderer_hits_the_ball() {
    let (t, point, normal) = (4.0, [0.0, 0.0, -1.0], [0.0, 0.0, -1.0]); // what my renderer found
    let mut root = RayNode::new(Kind::Camera, 0, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], Outcome::Hit);
    root.hit = Some(HitRecord { object: Some("ball".into()), ..HitRecord::new(t, point, 0, normal) }); // 0: the ball's index
    insta::assert_snapshot!(RayTree::new([1.0, 0.0, 0.0], root).to_text(Show::default()));
}
// [the example]
