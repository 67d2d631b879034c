//! Lesson 06, the camera: the cases, the known mistakes, the hints.

use std::process::ExitCode;

use glam::{DVec2, DVec3, dvec2, dvec3};
use raytree::lessons::{
    Answer, Camera, Case, ClassicFault, Fault, Lesson, Pixel, Procedures, Ray, Task, pictures, pixels, random_cases,
    shown,
};

/// The student's functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Student {
    pub(crate) half_height: fn(f64) -> f64,
    pub(crate) on_image: fn(u32, u32, u32, u32) -> DVec2,
    pub(crate) image_point: fn(&Camera, DVec2) -> DVec3,
    pub(crate) compute_ray: fn(&Camera, u32, u32) -> Ray,
}

pub(crate) fn run(student: Student) -> ExitCode {
    raytree::commands::lesson::run(&lesson(student))
}

pub(crate) fn lesson(student: Student) -> Lesson {
    let procedures = Procedures { compute_ray: student.compute_ray, ..Procedures::GIVEN };
    Lesson {
        number: 6,
        title: "camera",
        stages: vec![
            half_height().stage(move |fov| half((student.half_height)(*fov))),
            on_image().stage(move |[x, y, width, height]| place((student.on_image)(*x, *y, *width, *height))),
            image_point().stage(move |(camera, at)| point((student.image_point)(camera, *at))),
            compute_ray().stage(move |pixel| pixel.answer(procedures)),
        ],
        notice: "Now see where your rays go: raytree diagram scenes/first-hit.json \"near before middle\" --kind \
                 section -o section.png",
    }
}

fn half(height: f64) -> Answer {
    Answer::of("half height", height)
}

fn place(at: DVec2) -> Answer {
    Answer::of("x", at.x).and("y", at.y)
}

fn point(p: DVec3) -> Answer {
    Answer::of("p", p)
}

fn tan_of_half(degrees: f64) -> f64 {
    (degrees.to_radians() / 2.0).tan()
}

fn half_height() -> Task<f64> {
    const FAULTS: &[Fault<f64>] = &[
        Fault {
            id: "half-degrees-as-radians",
            name: "the field of view is taken for radians",
            why: "tan wants radians: fov_y_degrees.to_radians(), which is degrees times pi / 180.",
            answer: |fov| half((fov / 2.0).tan()),
        },
        Fault {
            id: "half-twice",
            name: "the field of view is halved twice",
            why: "Half the angle is enough: from the middle of the image to its upper edge.",
            answer: |fov| half(tan_of_half(fov / 2.0)),
        },
        Fault {
            id: "half-not-halved",
            name: "the field of view is not halved",
            why: "It goes from the lower to the upper edge. The right-angled triangle with half the height in it has \
                  half the angle.",
            answer: |fov| half(tan_of_half(2.0 * fov)),
        },
        Fault {
            id: "half-of-tangent",
            name: "the tangent is halved, not the angle",
            why: "tan(x) / 2 is not tan(x / 2): halve the angle first.",
            answer: |fov| half(tan_of_half(2.0 * fov) / 2.0),
        },
        Fault {
            id: "half-whole",
            name: "this is the whole height, not half of it",
            why: "tan(fov / 2) is the way from the middle to the upper edge.",
            answer: |fov| half(2.0 * tan_of_half(*fov)),
        },
        Fault {
            id: "half-sine",
            name: "the sine is taken for the tangent",
            why: "The side at the angle has length 1, the longest side is longer: opposite over adjacent, the tangent.",
            answer: |fov| half((fov.to_radians() / 2.0).sin()),
        },
        Fault {
            id: "half-no-tangent",
            name: "the angle itself is taken for its tangent",
            why: "On a flat image equal angles do not have equal lengths.",
            answer: |fov| half(fov.to_radians() / 2.0),
        },
    ];
    let mut cases = vec![
        Case::new("90 degrees", 90.0),
        Case::new("60 degrees", 60.0),
        Case::new("a narrow view", 10.0),
        Case::new("a wide view", 130.0),
    ];
    cases.extend(random_cases(601, 40, |random| Some(5.0 + random.below(300) as f64 / 2.0)));
    Task {
        name: "half the height",
        function: "half_height",
        points: 2,
        after: &[],
        cases,
        given: |fov| vec![format!("fov_y_degrees = {}", shown(*fov))],
        truth: |fov| half(tan_of_half(*fov)),
        faults: FAULTS,
        picture: |fov, what, _| pictures::field_of_view(*fov, what),
        hints: &[
            "Look from the side: the eye, the middle of the image plane, its upper edge. That is a right-angled \
             triangle. Which angle is at the eye, and which side has length 1?",
            "Opposite over adjacent is the tangent: half the height over 1 is the tangent of half the field of view.",
            "(fov_y_degrees.to_radians() / 2.0).tan()",
        ],
    }
}

type Grid = [u32; 4];

fn on_image() -> Task<Grid> {
    /// With the middles of pixels moved by some share of a pixel.
    fn moved(case: &Grid, by: f64) -> DVec2 {
        let [x, y, width, height] = case.map(f64::from);
        dvec2(2.0 * (x + by) / width - 1.0, 1.0 - 2.0 * (y + by) / height)
    }
    const FAULTS: &[Fault<Grid>] = &[
        Fault {
            id: "image-corner",
            name: "this is the corner of the pixel, not its middle",
            why: "Pixel x goes from x to x + 1. Its middle is x + 0.5.",
            answer: |case| place(moved(case, 0.0)),
        },
        Fault {
            id: "image-corner-across",
            name: "x is that of the left edge of the pixel, only y is that of its middle",
            why: "Pixel x goes from x to x + 1. Its middle is x + 0.5, as y + 0.5 is downwards.",
            answer: |case| place(dvec2(moved(case, 0.0).x, moved(case, 0.5).y)),
        },
        Fault {
            id: "image-corner-down",
            name: "y is that of the upper edge of the pixel, only x is that of its middle",
            why: "Pixel y goes from y to y + 1. Its middle is y + 0.5, as x + 0.5 is across.",
            answer: |case| place(dvec2(moved(case, 0.5).x, moved(case, 0.0).y)),
        },
        Fault {
            id: "image-rows-flipped",
            name: "the rows are counted from the bottom",
            why: "Pixel (0, 0) is at the top left and y runs down, on the image plane it runs up: 1 - 2 (y + 0.5) / height.",
            answer: |case| place(moved(case, 0.5) * dvec2(1.0, -1.0)),
        },
        Fault {
            id: "image-columns-flipped",
            name: "the columns are counted from the right",
            why: "Pixel (0, 0) is at the left, where x is -1.",
            answer: |case| place(moved(case, 0.5) * dvec2(-1.0, 1.0)),
        },
        Fault {
            id: "image-exchanged",
            name: "x is divided by the height, y by the width",
            why: "x runs across all columns, of which there are width.",
            answer: |[x, y, width, height]| {
                let at = moved(&[*x, *y, *height, *width], 0.5);
                place(at)
            },
        },
        Fault {
            id: "image-from-zero",
            name: "the image goes from 0 to 1, not from -1 to 1",
            why: "Its middle has to be 0, where the eye looks: multiply by 2 and take 1 away.",
            answer: |case| {
                let at = moved(case, 0.5);
                place(dvec2((at.x + 1.0) / 2.0, (at.y + 1.0) / 2.0))
            },
        },
        Fault {
            id: "image-half-size",
            name: "the image goes from -0.5 to 0.5, not from -1 to 1",
            why: "Multiply by 2 before 1 is taken away.",
            answer: |case| place(moved(case, 0.5) / 2.0),
        },
        Fault {
            id: "image-ends-on-middles",
            name: "the first and the last pixel lie on the edges of the image: it is divided by width - 1",
            why: "Between the edges there are width pixels, and the edges are half a pixel beyond the outermost middles.",
            answer: |[x, y, width, height]| {
                let share = |x: u32, of: u32| f64::from(x) / (f64::from(of) - 1.0);
                place(dvec2(2.0 * share(*x, *width) - 1.0, 1.0 - 2.0 * share(*y, *height)))
            },
        },
    ];
    let mut cases = vec![
        Case::new("top left of 4 x 2", [0, 0, 4, 2]),
        Case::new("top right of 4 x 2", [3, 0, 4, 2]),
        Case::new("bottom left of 4 x 2", [0, 1, 4, 2]),
        Case::new("the middle of 5 x 3", [2, 1, 5, 3]),
        Case::new("one pixel alone", [0, 0, 1, 1]),
    ];
    cases.extend(random_cases(602, 40, |random| {
        let (width, height) = (2 + random.below(11), 2 + random.below(9));
        Some([random.below(width), random.below(height), width, height].map(|n| n as u32))
    }));
    Task {
        name: "the middle of a pixel",
        function: "on_image",
        points: 2,
        after: &[],
        cases,
        given: |[x, y, width, height]| vec![format!("pixel ({x}, {y})"), format!("width = {width}, height = {height}")],
        truth: |case| place(moved(case, 0.5)),
        faults: FAULTS,
        picture: |case, what, _| pictures::pixel_grid(*case, what),
        hints: &[
            "In units of pixels the middle of pixel x is at x + 0.5, and the image ends at width. Which share of the \
             width is that? f64::from(x) makes a number of x.",
            "A share s from 0 to 1 becomes a place from -1 to 1 as 2 s - 1. Downwards it becomes 1 - 2 s.",
        ],
    }
}

type CameraAndPlace = (Camera, DVec2);

/// Half the width and half the height.
fn halves(camera: &Camera) -> DVec2 {
    let height = tan_of_half(camera.fov_y_degrees);
    dvec2(height * f64::from(camera.width) / f64::from(camera.height), height)
}

/// A point on the image plane, with half the width and half the height as somebody has them.
fn plane_point(camera: &Camera, at: DVec2, halves: DVec2) -> DVec3 {
    camera.eye + camera.forward + at.x * halves.x * camera.right + at.y * halves.y * camera.up
}

fn image_point() -> Task<CameraAndPlace> {
    const FAULTS: &[Fault<CameraAndPlace>] = &[
        Fault {
            id: "plane-eye-forgotten",
            name: "the eye is missing",
            why: "forward, right and up are ways that lead from the eye. The point is where they lead to: begin with \
                  camera.eye.",
            answer: |(camera, at)| point(plane_point(camera, *at, halves(camera)) - camera.eye),
        },
        Fault {
            id: "plane-forward-forgotten",
            name: "forward is missing: this is a plane through the eye",
            why: "The image plane lies 1 in front of the eye.",
            answer: |(camera, at)| point(plane_point(camera, *at, halves(camera)) - camera.forward),
        },
        Fault {
            id: "plane-behind",
            name: "the plane lies behind the eye",
            why: "camera.forward points into the picture: it is added.",
            answer: |(camera, at)| point(plane_point(camera, *at, halves(camera)) - 2.0 * camera.forward),
        },
        Fault {
            id: "plane-aspect-ignored",
            name: "the aspect ratio is left out: half the width is taken to be half the height",
            why: "The field of view is that of the height. Half the width is half the height times width / height, \
                  else a round ball becomes an egg.",
            answer: |(camera, at)| point(plane_point(camera, *at, DVec2::splat(halves(camera).y))),
        },
        Fault {
            id: "plane-aspect-inverted",
            name: "the aspect ratio is upside down: height / width",
            why: "A picture that is wider than high has a larger half width: width / height.",
            answer: |(camera, at)| {
                let DVec2 { x, y } = halves(camera);
                point(plane_point(camera, *at, dvec2(y * y / x, y)))
            },
        },
        Fault {
            id: "plane-aspect-whole",
            name: "width / height is divided as whole numbers: 3 / 2 is 1",
            why: "Both are u32, and what is left over is dropped. Make numbers of them first: f64::from(camera.width) / \
                  f64::from(camera.height).",
            answer: |(camera, at)| {
                let y = halves(camera).y;
                point(plane_point(camera, *at, dvec2(y * f64::from(camera.width / camera.height), y)))
            },
        },
        Fault {
            id: "plane-aspect-of-height",
            name: "the height is stretched instead of the width",
            why: "The field of view is that of the height, so tan(fov / 2) is half the height as it is.",
            answer: |(camera, at)| {
                let DVec2 { x, y } = halves(camera);
                point(plane_point(camera, *at, dvec2(y, x)))
            },
        },
        Fault {
            id: "plane-field-of-view-ignored",
            name: "the field of view is left out: half the height is taken to be 1",
            why: "That is right for 90 degrees only. Multiply by half_height.",
            answer: |(camera, at)| {
                let DVec2 { x, y } = halves(camera);
                point(plane_point(camera, *at, dvec2(x / y, 1.0)))
            },
        },
        Fault {
            id: "plane-up-and-right",
            name: "right and up are exchanged",
            why: "x goes along camera.right, y along camera.up.",
            answer: |(camera, at)| {
                let turned = Camera { right: camera.up, up: camera.right, ..*camera };
                point(plane_point(&turned, *at, halves(camera)))
            },
        },
        Fault {
            id: "plane-down",
            name: "up points down",
            why: "y is already counted upwards: it is added along camera.up.",
            answer: |(camera, at)| point(plane_point(camera, *at * dvec2(1.0, -1.0), halves(camera))),
        },
    ];
    let camera = Camera {
        eye: DVec3::ZERO,
        forward: -DVec3::Z,
        right: DVec3::X,
        up: DVec3::Y,
        fov_y_degrees: 90.0,
        width: 4,
        height: 2,
    };
    let turned =
        Camera { eye: dvec3(1.0, 2.0, 3.0), forward: DVec3::X, right: DVec3::Z, fov_y_degrees: 60.0, ..camera };
    let mut cases = vec![
        Case::new("the middle of the image", (camera, DVec2::ZERO)),
        Case::new("the middle of pixel (0, 0)", (camera, dvec2(-0.75, 0.5))),
        Case::new("the right edge", (camera, DVec2::X)),
        Case::new("the right edge of 3 x 2", (Camera { width: 3, ..camera }, DVec2::X)),
        Case::new("a camera that looks along x", (turned, dvec2(0.5, 1.0))),
    ];
    cases.extend(random_cases(603, 60, |random| {
        let eye = random.small_integers();
        let (forward, across) = (random.direction(), random.direction());
        let right = forward.cross(across).try_normalize()?;
        let camera = Camera {
            eye,
            forward,
            right,
            up: right.cross(forward),
            fov_y_degrees: 20.0 + random.below(100) as f64,
            width: 1 + random.below(8) as u32,
            height: 1 + random.below(8) as u32,
        };
        Some((camera, dvec2(random.signed(), random.signed())))
    }));
    Task {
        name: "a point on the image plane",
        function: "image_point",
        points: 3,
        after: &["half_height"],
        cases,
        given: |(camera, at)| {
            let named = |name: &str, v: DVec3| format!("{name} = ({})", v.to_array().map(shown).join(", "));
            vec![
                named("eye", camera.eye),
                named("forward", camera.forward),
                named("right", camera.right),
                named("up", camera.up),
                format!("fov_y_degrees = {}", shown(camera.fov_y_degrees)),
                format!("width = {}, height = {}", camera.width, camera.height),
                format!("on_image = ({}, {})", shown(at.x), shown(at.y)),
            ]
        },
        truth: |(camera, at)| point(plane_point(camera, *at, halves(camera))),
        faults: FAULTS,
        picture: |(camera, at), what, _| pictures::image_plane(camera, halves(camera), *at, what),
        hints: &[
            "Begin at the eye and go 1 forward: that is the middle of the image. From there on_image.x times half the \
             width to the right, and on_image.y times half the height upwards.",
            "half the height is half_height(camera.fov_y_degrees). Half the width is that times width / height; divide \
             numbers, not integers: f64::from(camera.width).",
            "camera.eye + camera.forward + on_image.x * half_width * camera.right + on_image.y * half_height * camera.up",
        ],
    }
}

fn compute_ray() -> Task<Pixel> {
    /// The right way from the eye to the image plane.
    fn way(camera: &Camera, x: u32, y: u32) -> DVec3 {
        let share = |x: u32, of: u32| (f64::from(x) + 0.5) / f64::from(of);
        let at = dvec2(2.0 * share(x, camera.width) - 1.0, 1.0 - 2.0 * share(y, camera.height));
        plane_point(camera, at, halves(camera)) - camera.eye
    }
    /// What the program makes of rays like these.
    fn with(pixel: &Pixel, compute_ray: fn(&Camera, u32, u32) -> Ray) -> Answer {
        pixel.answer(Procedures { compute_ray, ..Procedures::GIVEN })
    }
    const FAULTS: &[Fault<Pixel>] = &[
        Fault {
            id: "camera-rows-flipped",
            name: "the rows of the picture are counted from the bottom",
            why: "Pixel (0, 0) is at the top left and y runs down, while camera.up points up.",
            answer: |pixel| pixel.with_fault(ClassicFault::RowsFlipped),
        },
        Fault {
            id: "camera-fov-halved-twice",
            name: "the field of view is halved twice",
            why: "Half the height of the image plane is the tangent of half the angle. half_height halves it already.",
            answer: |pixel| pixel.with_fault(ClassicFault::FovHalvedTwice),
        },
        Fault {
            id: "camera-degrees-as-radians",
            name: "the field of view is taken for radians",
            why: "tan wants radians: fov_y_degrees.to_radians().",
            answer: |pixel| pixel.with_fault(ClassicFault::DegreesAsRadians),
        },
        Fault {
            id: "camera-aspect-ignored",
            name: "the aspect ratio is left out",
            why: "The field of view is that of the height. Half the width is half the height times width / height, \
                  else a round ball becomes an egg.",
            answer: |pixel| pixel.with_fault(ClassicFault::AspectIgnored),
        },
        Fault {
            id: "camera-pixel-corner",
            name: "the ray goes through the corner of the pixel",
            why: "The middle of pixel (x, y) is at x + 0.5 and y + 0.5. Without the halves the whole picture is moved by \
                  half a pixel: hardly to be seen, and yet another ray.",
            answer: |pixel| pixel.with_fault(ClassicFault::PixelCorner),
        },
        Fault {
            id: "camera-point-as-direction",
            name: "the direction is the point on the image plane itself: the eye is not taken away",
            why: "A direction leads from one point to another: image point - eye. Only for an eye at the origin of the \
                  world are both the same.",
            answer: |pixel| {
                with(pixel, |camera, x, y| Ray {
                    origin: camera.eye,
                    direction: (way(camera, x, y) + camera.eye).normalize(),
                })
            },
        },
        Fault {
            id: "camera-direction-not-unit",
            name: "the direction does not have length 1",
            why: "The way to the image plane is longer than 1 beside the middle of the image: normalize() it.",
            answer: |pixel| with(pixel, |camera, x, y| Ray { origin: camera.eye, direction: way(camera, x, y) }),
        },
        Fault {
            id: "camera-backwards",
            name: "the ray goes away from the picture",
            why: "From the eye to the image plane is image point - eye, not the other way round.",
            answer: |pixel| {
                with(pixel, |camera, x, y| Ray { origin: camera.eye, direction: -way(camera, x, y).normalize() })
            },
        },
        Fault {
            id: "camera-starts-on-plane",
            name: "the ray starts on the image plane, not in the eye",
            why: "All rays of a picture start in one point, the eye. What lies between the eye and the image plane is \
                  seen as well.",
            answer: |pixel| {
                with(pixel, |camera, x, y| {
                    let way = way(camera, x, y);
                    Ray { origin: camera.eye + way, direction: way.normalize() }
                })
            },
        },
        Fault {
            id: "camera-mirrored",
            name: "left and right are exchanged",
            why: "Pixel 0 is at the left, camera.right leads to the right: x has to be negative there.",
            answer: |pixel| {
                with(pixel, |camera, x, y| Ray {
                    origin: camera.eye,
                    direction: way(camera, camera.width - 1 - x, y).normalize(),
                })
            },
        },
    ];
    let mut cases = pixels("scenes/first-hit.json", include_str!("../../scenes/first-hit.json"));
    cases.extend(pixels("scenes/shadow.json", include_str!("../../scenes/shadow.json")));
    Task {
        name: "the ray, and the picture",
        function: "compute_ray",
        points: 3,
        after: &["on_image", "image_point"],
        cases,
        given: Pixel::given,
        truth: Pixel::truth,
        faults: FAULTS,
        picture: pictures::renders,
        hints: &[
            "on_image gives the place of the pixel, image_point the point in the world. The ray goes from the eye to \
             that point.",
            "A direction is end minus beginning, and here it has length 1: (point - camera.eye).normalize().",
        ],
    }
}
