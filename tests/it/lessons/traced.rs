//! The lecture's program in real scenes, as lessons 06 to 10 run it.

use raytree::lessons::{
    Case, ClassicFault, Hit, Pixel, Procedures, Program, Ray, Rgb, ShadowRay, Stage, Task, pictures, pixels,
};

use crate::diagrams::check_labels;
use crate::support::scene_files;

const GIVEN: Procedures = Procedures::GIVEN;

/// The nearest of all objects, as a student would look for it.
fn nearest(program: &Program, ray: &Ray) -> Option<Hit> {
    program.objects().filter_map(|object| object.intersect(ray)).min_by(|a, b| a.t.total_cmp(&b.t))
}

fn is_blocked(program: &Program, shadow_ray: &ShadowRay) -> bool {
    program.objects().any(|object| object.intersect(&shadow_ray.ray).is_some_and(|hit| hit.t < shadow_ray.t_max))
}

/// The scenes that need no mesh.
fn scenes() -> Vec<(String, Vec<Case<Pixel>>)> {
    let read = |file: String| (std::fs::read_to_string(&file).unwrap(), file);
    let scenes = scene_files().into_iter().map(read).filter(|(text, _)| !text.contains("\"mesh\""));
    scenes.map(|(text, file)| (file.clone(), pixels(&file, &text))).collect()
}

/// The given procedures, and those that students write of the same kind, make the trees of the real tracer.
#[test]
fn what_is_given_is_the_real_tracer() {
    // A search object by object does not know what is met together. A ray that is rounded otherwise meets a needle or not, and
    // nobody tells a program the weights of its rays.
    let [touching, beyond] = [["touching", "coincident"], ["needle", "min-weight"]];
    let is_of = |words: &[&str], file: &str| words.iter().any(|word| file.contains(word));
    let mut compared = 0;
    for (file, cases) in scenes().into_iter().filter(|(file, _)| !is_of(&beyond, file)) {
        let by_hand = Procedures { intersect: nearest, is_blocked, ..GIVEN };
        let touches = is_of(&touching, &file);
        for procedures in [Some(GIVEN), (!touches).then_some(by_hand)].into_iter().flatten() {
            for Case { name, input } in &cases {
                let [right, own] = [input.truth(), input.answer(procedures)];
                assert!(own.agrees(&right), "{name}: {:?}", right.told_beside(&own));
                compared += 1;
            }
        }
    }
    assert!(compared > 3000, "{compared}");
}

fn task(procedures: Procedures) -> Stage {
    let text = std::fs::read_to_string("scenes/mirror.json").unwrap();
    let task = Task {
        name: "colour: the whole tree",
        function: "shade",
        points: 1,
        after: &[],
        cases: pixels("scenes/mirror.json", &text),
        given: Pixel::given,
        truth: Pixel::truth,
        faults: &[],
        picture: pictures::renders,
        hints: &["none"],
    };
    task.stage(move |pixel| pixel.answer(procedures))
}

/// A recursion that never ends by itself.
fn endless(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let direction = ray.direction - 2.0 * ray.direction.dot(hit.normal) * hit.normal;
    let reflected = Ray { origin: hit.point, direction };
    program.local_color(ray, hit) + 0.5 * program.trace_reflected(level, &reflected)
}

fn around(program: &Program, level: u32, ray: &Ray) -> Rgb {
    match nearest(program, ray) {
        Some(hit) => around_surface(program, level, ray, &hit),
        None => program.background(ray),
    }
}

/// A recursion beside the program.
fn around_surface(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
    let back = Ray { origin: hit.point + 1e-3 * hit.normal, direction: -hit.normal };
    program.local_color(ray, hit) + around(program, level, &back)
}

#[test]
fn a_recursion_without_an_end_is_told_in_a_line() {
    let checked = task(Procedures { shade: endless, ..GIVEN }).run();
    check_labels("endless", &checked.picture);
    let told = checked.failure.unwrap().to_text("shade", 52);
    assert!(told.contains("expected  root"), "{told}");
    let checked = task(Procedures { trace: around, ..GIVEN }).run();
    check_labels("around", &checked.picture);
    let told = checked.failure.unwrap().to_text("trace", 52);
    let line = told.lines().find(|line| line.contains("a panic at tests/it/lessons/traced.rs:")).unwrap();
    assert!(line.contains("this does not end") && line.contains("level + 1"), "{told}");
}

/// What the program is asked outside of the recursion, and what is no ray, have answers.
#[test]
fn odd_rays_are_harmless() {
    fn odd(program: &Program, level: u32, _: &Ray) -> Rgb {
        for wild in [f64::NAN, f64::INFINITY, 0.0, 1e300] {
            let ray = Ray { origin: glam::DVec3::splat(wild), direction: glam::DVec3::new(wild, 0.0, wild) };
            assert!(program.intersect(&ray).is_none());
            assert!(program.objects().all(|object| object.intersect(&ray).is_none()));
            if level < 2 {
                program.trace_refracted(level + 1, &ray);
            }
        }
        Rgb::splat(f64::NAN)
    }
    let stage = task(Procedures { trace: odd, ..GIVEN });
    let checked = stage.run();
    check_labels("odd", &checked.picture);
    assert!(checked.failure.unwrap().broken.is_none());
}

#[test]
fn a_classic_fault_gives_the_tree_of_a_program_that_has_it() {
    fn one_too_many(program: &Program, level: u32, ray: &Ray, hit: &Hit) -> Rgb {
        let mut color = program.local_color(ray, hit);
        if let Some(weight) = hit.material.reflection.filter(|_| level <= program.max_level()) {
            let direction = ray.direction - 2.0 * ray.direction.dot(hit.normal) * hit.normal;
            color += weight * program.trace_reflected(level + 1, &Ray { origin: hit.point, direction });
        }
        color
    }
    let file = "scenes/hall-of-mirrors.json";
    let mut parted = 0;
    for Case { name, input } in pixels(file, &std::fs::read_to_string(file).unwrap()) {
        let own = input.answer(Procedures { shade: one_too_many, ..GIVEN });
        let fault = input.with_fault(ClassicFault::LevelOneTooMany);
        assert!(own.agrees(&fault), "{name}: {:?}", fault.told_beside(&own));
        parted += usize::from(!own.agrees(&input.truth()));
    }
    assert!(parted >= 1, "{parted}");
}
