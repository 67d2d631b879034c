//! The player's laws, and the stack that is a fold.

use raytree::steps::{Player, Procedure, Recording, Variable};

use super::for_each_recording;
use crate::support::{ray_tree, scene, small_scene};

#[test]
fn the_steps_fold_to_an_empty_stack_and_the_colour_of_the_tree() {
    for_each_recording(|what, _, recording| {
        let mut depth = 0_usize;
        let mut open = Vec::new();
        let mut nodes = Vec::new();
        for step in &recording.steps {
            if let Some(procedure) = step.call {
                open.push((procedure, step.node));
                if procedure == Procedure::Trace {
                    nodes.push(step.node);
                }
            }
            depth = open.len();
            assert!(depth > 0, "{what}: {step:?}");
            let (procedure, _) = open[depth - 1];
            // A line is carried out in the frame of its own procedure.
            assert_eq!(raytree::steps::PSEUDOCODE[step.line].procedure, procedure, "{what}: {step:?}");
            if step.returns {
                open.pop();
            }
        }
        assert!(open.is_empty() && depth == 1, "{what}: {open:?}");
        let depths = recording.depths();
        assert_eq!((depths[0], depths[depths.len() - 1]), (1, 1), "{what}");
        // Every ray of the tree is traced once, in order, but shadow rays, which are only intersected.
        let traced: Vec<usize> = (0..recording.nodes.len())
            .filter(|&i| recording.nodes[i].ray.weight.is_some() && recording.nodes[i].ray.outcome.is_traced())
            .collect();
        assert_eq!(nodes, traced, "{what}");
        let last = recording.stack(recording.steps.len() - 1);
        let color = last[0].variables.iter().find(|(name, _)| *name == "color");
        let Some((_, Variable::Vector(color))) = color else { panic!("{what}: {last:?}") };
        assert_eq!(color.map(f64::to_bits), recording.tree.color.map(f64::to_bits), "{what}");
        // No part of the colour was made up.
        assert!(
            recording
                .steps
                .iter()
                .all(|step| { step.finding.as_ref().is_none_or(|finding| !finding.words.contains("another colour")) })
        );
    });
}

#[test]
fn the_sum_of_contributions_is_the_colour() {
    for_each_recording(|what, _, recording| {
        let mut sum = [0.0; 3];
        for node in &recording.nodes {
            for k in 0..3 {
                sum[k] += node.contribution[k];
            }
        }
        let off = (0..3).map(|k| (sum[k] - recording.tree.color[k]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9, "{what}: {sum:?} {:?}", recording.tree.color);
        assert_eq!(recording.nodes.len(), recording.tree.nodes().len());
        for (node, (path, ray)) in recording.nodes.iter().zip(recording.tree.nodes()) {
            assert!(node.path == path && std::ptr::eq(node.ray, ray), "{what}");
            let parent = node.parent.map(|parent| recording.nodes[parent].path.clone());
            assert_eq!(parent, path.parent(), "{what}");
        }
    });
}

#[test]
fn moves_keep_their_laws() {
    for_each_recording(|what, _, recording| {
        let depths = recording.depths();
        let last = depths.len() - 1;
        let mut player = Player::new(recording);
        assert!(!player.step_back() && player.at() == 0, "{what}");
        // Every third step, or a mesh would take long.
        for at in (0..=last).step_by(3) {
            player.to(at);
            // Back undoes into.
            assert_eq!(player.step_into(), at < last, "{what}");
            if at < last {
                assert!(player.step_back());
            }
            assert_eq!(player.at(), at, "{what}");
            // Over: the next step that is no deeper, and none such was left out.
            if player.step_over() {
                assert!(depths[player.at()] <= depths[at], "{what}");
                assert!(depths[at + 1..player.at()].iter().all(|&depth| depth > depths[at]), "{what}");
            } else {
                assert!(player.at() == at && depths[at + 1..].iter().all(|&depth| depth > depths[at]), "{what}");
            }
            // Out: the frame is gone.
            player.to(at);
            if player.step_out() {
                assert_eq!(depths[player.at()], depths[at] - 1, "{what}");
                let (before, after) = (recording.stack(at), recording.stack(player.at()));
                assert_eq!(after.len() + 1, before.len(), "{what}");
                let frames = |stack: &[raytree::steps::Frame]| -> Vec<_> {
                    stack.iter().map(|frame| (frame.procedure, frame.node)).collect()
                };
                assert_eq!(frames(&after), frames(&before[..after.len()]), "{what}");
            } else {
                assert!(player.at() == at && depths[at] == 1, "{what}");
            }
            assert_eq!(recording.stack(at).len(), depths[at], "{what}");
        }
        player.end();
        assert_eq!(player.at(), last);
        assert!(!player.step_into() && !player.end() && !player.step_over() && !player.step_out(), "{what}");
        assert!(player.start() && player.at() == 0, "{what}");
    });
}

#[test]
fn a_ray_of_no_pixel_and_a_tree_without_tests() {
    let loaded = small_scene(
        r#""m": { "reflection": 1 }"#,
        r#"{ "material": "m", "shape": { "plane": { "normal": [0, 0, 1], "distance": -1 } } }"#,
        "",
    );
    let tree = ray_tree(&loaded, [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
    let recording = Recording::of(&loaded.scene, &tree);
    assert_eq!(recording.steps[0].call, Some(Procedure::Trace));
    let last = recording.stack(recording.steps.len() - 1);
    assert_eq!(last.len(), 1);
    assert!(recording.steps.iter().all(|step| step.test.is_none()));
}

#[test]
fn a_tree_of_another_scene_is_played_without_formulas_that_do_not_hold() {
    let ball = |x: f64| {
        scene(&format!(
            r#"{{
                "image": {{ "width": 4, "height": 3 }},
                "camera": {{ "eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov_y_degrees": 60 }},
                "materials": {{ "m": {{ "reflection": 1, "ambient": 0.5, "color": [1, 1, 1] }} }},
                "objects": [ {{ "material": "m", "shape": {{ "sphere": {{ "center": [{x}, 0, -3], "radius": 2 }} }} }} ]
            }}"#
        ))
    };
    let (here, there) = (ball(0.0), ball(0.25));
    let tree = super::tree_of(&here, [1, 1], Default::default(), raytree::numbers::Precision::F64);
    let played = |scene| Recording::of(scene, &tree).steps.iter().filter(|step| step.arithmetic.is_some()).count();
    assert!(played(&there.scene) < played(&here.scene));
    // Nor does a scene without that object, or a tree without anything.
    let empty = small_scene(r#""m": {}"#, "", "");
    assert!(played(&empty.scene) < played(&there.scene));
}
