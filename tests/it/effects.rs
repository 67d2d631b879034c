//! Only the effects a scene calls for: what nobody asked for ran zero times and left the bytes alone.

use raytree::scene::effects::{Asker, Effect, EffectSet, census};
use raytree::tree::{Cost, Costs};

use crate::support::{grid, scenes, small_scene, tracer};

#[test]
fn what_was_not_called_for_does_not_run() {
    for (name, loaded) in scenes() {
        let called: EffectSet = census(&loaded.scene).into_iter().map(|(effect, _)| effect).collect();
        let free = tracer::<f64>(&loaded.scene);
        let masked = tracer::<f64>(&loaded.scene).with_masked(called.complement());
        let mut costs = Costs::default();
        for [x, y] in grid(&loaded.scene, 300) {
            let (color, cost) = masked.pixel(x, y, &Cost);
            assert_eq!(color, free.pixel_color(x, y), "{name} at {x},{y}");
            costs += cost;
        }
        for (effect, count) in [
            (Effect::Shadows, costs.shadow),
            (Effect::Reflection, costs.reflected),
            (Effect::Refraction, costs.refracted),
        ] {
            assert!(called.contains(effect) || count == 0, "{name}: {count} rays of {effect}, which nobody called for");
        }
    }
}

/// Each effect alone, in the smallest scene that calls for it; and that its mask does what it says.
#[test]
fn a_mask_panics_exactly_where_the_effect_runs() {
    let light = r#", "lights": [{ "point": { "position": [0, 5, 5], "color": [1, 1, 1] } }]"#;
    let ball = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, -3], "radius": 1 } } }"#;
    let cases = [
        (Effect::Ambient, r#""ambient": 1"#, ""),
        (Effect::Diffuse, r#""diffuse": 1"#, light),
        (Effect::Specular, r#""specular": 1, "shininess": 9"#, light),
        (Effect::Shadows, r#""diffuse": 1"#, light),
        (Effect::Reflection, r#""reflection": 1"#, ""),
        (Effect::Refraction, r#""transmission": 1, "ior": 1.5"#, ""),
        (Effect::Fresnel, r#""transmission": 1, "ior": 1.5, "fresnel": "exact""#, ""),
        (Effect::Fresnel, r#""reflection": 1, "ior": 1.5, "fresnel": "schlick""#, ""),
        (Effect::Checker, r#""ambient": 1, "checker": { "colors": [[0, 0, 0], [1, 1, 1]], "size": 1 }"#, ""),
        (Effect::Gradient, "", r#", "background": { "gradient": { "bottom": [0, 0, 0], "top": [1, 1, 1] } }"#),
        (Effect::MinWeight, r#""reflection": 0.5"#, r#", "min_weight": 0.1"#),
    ];
    for (effect, material, more) in cases {
        let loaded = small_scene(&format!(r#""m": {{ {material} }}"#), ball, more);
        let called = census(&loaded.scene);
        assert!(called.iter().any(|(e, _)| *e == effect), "{effect} is not in the census of its own scene");
        let run = |mask: EffectSet| {
            let tracer = tracer::<f64>(&loaded.scene).with_masked(mask);
            std::panic::catch_unwind(|| {
                for [x, y] in [[0, 0], [1, 1], [2, 1], [3, 2]] {
                    tracer.pixel_color(x, y);
                }
            })
        };
        let called: EffectSet = called.into_iter().map(|(effect, _)| effect).collect();
        assert!(run(called.complement()).is_ok(), "the scene of {effect} runs more than it called for");
        assert_eq!(run([effect].into_iter().collect()).is_err(), cfg!(debug_assertions), "the mask of {effect}");
    }
}

#[test]
fn the_census_names_who_asked() {
    let loaded = small_scene(
        r#""a": { "diffuse": 1 }, "b": { "reflection": [0, 0, 0.5] }, "c": { "reflection": 0, "specular": 0, "shininess": 3 }"#,
        r#"{ "material": "a", "shape": { "sphere": { "center": [0, 0, -3], "radius": 1 } } },
           { "material": "b", "shape": { "sphere": { "center": [3, 0, -3], "radius": 1 } } },
           { "material": "c", "shape": { "sphere": { "center": [6, 0, -3], "radius": 1 } } }"#,
        "",
    );
    // No light: nobody gets a shadow ray. A weight of zero asks for nothing.
    let asked = |index| vec![Asker::Object(raytree::scene::ObjectId(index))];
    assert_eq!(census(&loaded.scene), [(Effect::Reflection, asked(1))]);
}
