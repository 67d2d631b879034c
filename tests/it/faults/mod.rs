//! The textbook tracer against the real one, and the name of each fault that is planted in it.

use std::collections::BTreeSet;

use raytree::faults::{Fault, Textbook, name_fault, right_tree};
use raytree::scene::{Limits, Loaded, Numerics, Shape};
use raytree::transport::{LeavingPolicy, Options, Tracer};
use raytree::tree::diff::{Field, Tolerances, diff};
use raytree::tree::{Keep, RayTree};

use crate::support::{grid, ray_tree, scenes, small_scene, tracer, tree};

/// Named pixels of the hard scenes of which plain f64 with an epsilon gives another tree than exact verdicts do: rays aimed at
/// edges and corners, and a sphere so far away that the rounding of its points is larger than the epsilon.
const BEYOND_THE_TEXTBOOK: [(&str, &str); 6] = [
    ("hard/box-face-edge-on", "edge missed"),
    ("hard/closed-mesh-room", "seam of the back wall"),
    ("hard/closed-mesh-room", "edge of two walls"),
    ("hard/far-small-sphere", "middle"),
    ("hard/mirrored-cube", "corner"),
    ("hard/mirrored-cube", "edge"),
];

fn right_and_textbook(loaded: &Loaded, [x, y]: [u32; 2]) -> (RayTree, RayTree) {
    let textbook = Textbook::new(&loaded.scene).pixel(x, y);
    (right_tree(loaded, &textbook).unwrap(), textbook)
}

#[test]
fn without_a_fault_the_textbook_agrees_with_the_tracer() {
    let mut apart = Vec::new();
    for (name, loaded) in scenes() {
        for (pixel, place) in &loaded.scene.pixels {
            let (right, textbook) = right_and_textbook(&loaded, *place);
            if !diff(&right, &textbook, &Tolerances::default()).is_same() {
                apart.push((name.clone(), pixel.clone()));
            }
        }
    }
    let wanted: Vec<_> =
        BEYOND_THE_TEXTBOOK.iter().map(|(name, pixel)| (name.to_string(), pixel.to_string())).collect();
    assert_eq!(apart, wanted);
}

/// Pixels that nobody chose, of the scenes whose meshes are small. Of the hard scenes some part, as they are made to.
#[test]
fn without_a_fault_the_textbook_agrees_on_a_grid() {
    let (mut same, mut all) = (0, 0);
    for (name, loaded) in scenes().into_iter().filter(|(name, loaded)| !name.starts_with("hard/") && is_small(loaded)) {
        for place in grid(&loaded.scene, 60) {
            let (right, textbook) = right_and_textbook(&loaded, place);
            let difference = diff(&right, &textbook, &Tolerances::default());
            (same, all) = (same + u32::from(difference.is_same()), all + 1);
            let near = Tolerances::same(raytree::tree::diff::Tolerance::Relative(1e-4));
            let far_apart = !diff(&right, &textbook, &near).is_same();
            assert!(!far_apart, "{name} {place:?}: {}", difference.to_text());
        }
    }
    assert!(all > 1000 && same * 1000 >= all * 999, "{same} of {all}");
}

fn is_small(loaded: &Loaded) -> bool {
    let triangles = |shape: &Shape| if let Shape::Mesh(mesh) = shape { mesh.triangles.len() } else { 0 };
    loaded.scene.objects.iter().all(|object| triangles(&object.shape) < 200)
}

/// A fault planted in the textbook tracer, whose rays come to an end.
fn planted(loaded: &Loaded, fault: Fault, place: [u32; 2]) -> RayTree {
    let limits = Limits { ray_budget: 1000, ..loaded.scene.limits };
    let [x, y] = place;
    Textbook::new(&loaded.scene).with_limits(limits).with(fault).pixel(x, y)
}

/// Where each fault shows, and in what: scene, pixel, node, field.
const SHOWN: [(Fault, &str, &str, &str, Field); 31] = [
    (Fault::RowsFlipped, "box", "top face", "root", Field::Direction),
    (Fault::FovHalvedTwice, "box", "top face", "root", Field::Direction),
    (Fault::DegreesAsRadians, "box", "top face", "root", Field::Direction),
    (Fault::PixelCorner, "checker", "floor", "root", Field::Direction),
    (Fault::AspectIgnored, "checker", "floor", "root", Field::Direction),
    (Fault::EntryWhenInside, "glass-ball", "straight through", "root.refracted", Field::Outcome),
    (Fault::ParallelogramForTriangle, "gradient-background", "top", "root.reflected", Field::Outcome),
    (Fault::BarycentricsPermuted, "gem", "table", "root", Field::Barycentrics),
    (Fault::WindingReversed, "gem", "table", "root", Field::GeometricNormal),
    (Fault::SlabsUnsorted, "box", "top face", "root", Field::Outcome),
    (Fault::BoxBehind, "fresnel", "constant rim", "root.shadows[0]", Field::Outcome),
    (Fault::LastHitWins, "first-hit", "near before middle", "root", Field::Shape),
    (Fault::HitAtOrigin, "checker", "floor", "root.shadows[0]", Field::Outcome),
    (Fault::NormalNotUnit, "checker", "ball", "root", Field::GeometricNormal),
    (Fault::NormalNotFlipped, "glass-ball", "straight through", "root.refracted", Field::ShadingNormal),
    (Fault::NoShadowRays, "box", "top face", "root", Field::Shadows),
    (Fault::ShadowPastLight, "coloured-weights", "blue in gold", "root.shadows[0]", Field::Direction),
    (Fault::ShadowUnbounded, "plane", "left wall", "root.shadows[0]", Field::Outcome),
    (Fault::LightVectorNotUnit, "fresnel", "constant rim", "root", Field::Diffuse),
    (Fault::LightFromBehind, "fresnel", "exact rim", "root", Field::Shadows),
    (Fault::LightColorIgnored, "shadows-of-several-lights", "all three lights", "root", Field::Diffuse),
    (Fault::AmbientPerLight, "shadows-of-several-lights", "all three lights", "root", Field::Ambient),
    (Fault::HighlightAway, "glass-ball", "highlight", "root", Field::Specular),
    (Fault::ReflectSign, "first-tree", "mirrored sky", "root.reflected", Field::Direction),
    (Fault::EtaInverted, "glass-ball", "straight through", "root.refracted", Field::Direction),
    (Fault::TotalReflectionDropped, "total-internal-reflection", "critical angle", "root", Field::TotalReflection),
    (Fault::TotalReflectionThrough, "total-internal-reflection", "critical angle", "root", Field::TotalReflection),
    (Fault::FresnelSwapped, "glass-ball", "straight through", "root.reflected", Field::Weight),
    (
        Fault::LevelNotPassed,
        "glass-ball",
        "straight through",
        "root.refracted.reflected.reflected.reflected",
        Field::Outcome,
    ),
    (
        Fault::LevelOneTooMany,
        "glass-ball",
        "straight through",
        "root.refracted.reflected.reflected.reflected",
        Field::Outcome,
    ),
    (Fault::ColorBeforeWeight, "first-tree", "mirrored sky", "root", Field::Radiance),
];

#[test]
fn each_fault_gets_its_name() {
    let scenes = scenes();
    let mut named_ones: BTreeSet<Fault> = BTreeSet::new();
    for (fault, scene, pixel, path, field) in SHOWN {
        let (_, loaded) = scenes.iter().find(|(name, _)| name == scene).unwrap();
        let (_, place) = loaded.scene.pixels.iter().find(|(name, _)| name == pixel).unwrap();
        let named = name_fault(loaded, &planted(loaded, fault, *place), &Tolerances::default());
        let named = named.unwrap_or_else(|| panic!("{fault} has no name"));
        assert_eq!(named.faults, [fault], "{scene}, {pixel}");
        assert_eq!((named.path.to_string().as_str(), named.field), (path, field), "{fault}");
        let told = named.to_text("B");
        assert!(told.contains(fault.title()) && told.contains(fault.why()), "{told}");
        named_ones.insert(fault);
    }

    // A ray whose direction is not of length 1, and glass with Schlick's formula seen from inside.
    let ball = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, -4], "radius": 1 } } }"#;
    let around = r#"{ "material": "m", "shape": { "sphere": { "center": [0, 0, 1.2], "radius": 2 } } }"#;
    let schlick = r#""m": { "reflection": 1, "transmission": 1, "ior": 1.5, "fresnel": "schlick" }"#;
    for (fault, material, object, direction, path, field) in [
        (Fault::QuadraticPrecedence, r#""m": { "ambient": 1 }"#, ball, [0.0, 0.0, -2.0], "root", Field::T),
        (Fault::SchlickWrongSide, schlick, around, [0.6, 0.0, -0.8], "root", Field::Fresnel),
    ] {
        let loaded = small_scene(material, object, "");
        let wrong = Textbook::new(&loaded.scene).with(fault).ray([0.0; 3], direction);
        let named = name_fault(&loaded, &wrong, &Tolerances::default()).unwrap();
        assert_eq!(
            (named.faults.as_slice(), named.path.to_string().as_str(), named.field),
            (&[fault][..], path, field)
        );
        let right = ray_tree(&loaded, [0.0; 3], direction);
        assert_eq!(name_fault(&loaded, &right, &Tolerances::default()), None);
        named_ones.insert(fault);
    }
    assert_eq!(named_ones, Fault::ALL.into_iter().collect(), "every fault of the catalogue");
    let names: BTreeSet<&str> = Fault::ALL.into_iter().map(Fault::name).collect();
    assert_eq!(names.len(), Fault::ALL.len());
}

/// On a pixel of each scene: whatever fault shows there is among those that are named.
#[test]
fn a_fault_that_shows_is_among_those_that_are_named() {
    let (mut told, mut alone) = (0, 0);
    for (name, loaded) in scenes().into_iter().filter(|(_, loaded)| is_small(loaded)) {
        let is_within =
            |(pixel, _): &&(String, [u32; 2])| !BEYOND_THE_TEXTBOOK.contains(&(name.as_str(), pixel.as_str()));
        let Some((pixel, place)) = loaded.scene.pixels.iter().find(is_within) else { continue };
        let (right, _) = right_and_textbook(&loaded, *place);
        for fault in Fault::ALL {
            let wrong = planted(&loaded, fault, *place);
            if diff(&right, &wrong, &Tolerances::default()).is_same() {
                assert_eq!(name_fault(&loaded, &wrong, &Tolerances::default()), None, "{name}, {pixel}: {fault}");
                continue;
            }
            let named = name_fault(&loaded, &wrong, &Tolerances::default());
            let faults = named.unwrap_or_else(|| panic!("{name}, {pixel}: {fault} has no name")).faults;
            assert!(faults.contains(&fault), "{name}, {pixel}: {fault} is called {faults:?}");
            (told, alone) = (told + 1, alone + u32::from(faults.len() == 1));
        }
    }
    assert!(told > 250 && alone * 10 > told * 9, "{alone} of {told} by one name");
}

#[test]
fn right_trees_and_trees_with_another_fault_get_no_name() {
    for (name, loaded) in scenes() {
        for (pixel, place) in &loaded.scene.pixels {
            let right = tree(&tracer::<f64>(&loaded.scene), &loaded, *place, Keep::Outcomes);
            assert_eq!(name_fault(&loaded, &right, &Tolerances::default()), None, "{name}, {pixel}");
        }
    }
    let (_, loaded) = scenes().into_iter().find(|(name, _)| name == "glass-ball").unwrap();
    let mut strange = planted(&loaded, Fault::EtaInverted, loaded.scene.pixels[0].1);
    strange.root.weight = Some([0.5; 3]);
    assert_eq!(name_fault(&loaded, &strange, &Tolerances::default()), None);
    strange.pixel = Some([u32::MAX, 0]);
    assert_eq!(name_fault(&loaded, &strange, &Tolerances::default()), None);
}

#[test]
fn faults_that_a_pixel_does_not_tell_apart_are_all_named() {
    let (_, loaded) = scenes().into_iter().find(|(name, _)| name == "checker").unwrap();
    let (_, place) = loaded.scene.pixels.iter().find(|(name, _)| name == "box top").unwrap();
    let named = name_fault(&loaded, &planted(&loaded, Fault::LastHitWins, *place), &Tolerances::default()).unwrap();
    assert_eq!(named.faults, [Fault::SlabsUnsorted, Fault::LastHitWins]);
    assert!(named.to_text("B").starts_with("each of these faults alone gives the whole of B"));
}

/// The real tracer with an epsilon of 0: which rays hit their own surface goes by its rounding, not by the textbook's.
#[test]
fn self_hits_by_somebody_elses_rounding_get_their_name() {
    let mut named_ones = 0;
    for (name, loaded) in
        scenes().into_iter().filter(|(name, _)| ["first-tree", "shadow", "plane"].contains(&name.as_str()))
    {
        let leaving = Some(LeavingPolicy::FixedEpsilon(0.0));
        let options = Options { numerics: Numerics::Robust, leaving, ..Options::of(&loaded.scene) };
        let tracer = Tracer::<f64>::new(&loaded.scene, options).unwrap();
        for place in grid(&loaded.scene, 300) {
            let wrong = tree(&tracer, &loaded, place, Keep::Outcomes);
            let right = right_tree(&loaded, &wrong).unwrap();
            if diff(&right, &wrong, &Tolerances::default()).is_same() {
                continue;
            }
            let named = name_fault(&loaded, &wrong, &Tolerances::default());
            let faults = named.map(|named| named.faults).unwrap_or_default();
            assert!(faults.contains(&Fault::HitAtOrigin), "{name} {place:?}: {faults:?}");
            named_ones += 1;
        }
    }
    assert!(named_ones > 20, "{named_ones}");
}
