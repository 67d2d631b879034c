//! From the JSON form to the scene: every value checked, every name resolved, every mesh brought in.

use glam::DVec3;

use super::camera::unit;
use super::json::{
    BackgroundFile, CameraFile, LightFile, MaterialFile, MeshFile, MeshNormals, ObjectFile, SceneFile, ShapeFile,
    Weight,
};
use super::{
    Background, Camera, Light, LightKind, Limits, Material, MaterialId, Mesh, Object, Pigment, Resolution, Rgb, Scene,
    Shape, Specular,
    mesh::{self, MeshError},
};
use crate::input::{JsonPath, Located, Problem, nearest, one_of};
use crate::numbers::is_in_range;

/// The largest colour component, weight, and other factor of a colour.
const LARGEST_FACTOR: f64 = 1e6;

type ReadMesh<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// The scene that `file` describes.
pub(super) fn scene(located: Located<'_>, file: &SceneFile, read_mesh: &mut ReadMesh<'_>) -> Result<Scene, Problem> {
    let check = Check { located };
    let root = JsonPath::default();
    let image = check.image(&root.child("image"), file)?;
    let camera = check.camera(&root.child("camera"), &file.camera)?;
    let background = check.background(&root.child("background"), file.background, camera.up_hint(&file.camera))?;
    let limits = check.limits(&root, file)?;

    let mut lights = Vec::with_capacity(file.lights.len());
    for (i, light) in file.lights.iter().enumerate() {
        lights.push(check.light(&root.child("lights").child(i), i, light)?);
    }
    let mut materials = Vec::with_capacity(file.materials.0.len());
    for (name, material) in &file.materials.0 {
        materials.push(check.material(&root.child("materials").child(name.as_str()), name, material)?);
    }
    let mut objects = Vec::with_capacity(file.objects.len());
    for (i, object) in file.objects.iter().enumerate() {
        objects.push(check.object(&root.child("objects").child(i), i, object, &materials, read_mesh)?);
    }
    for (name, pixel) in &file.pixels.0 {
        let path = root.child("pixels").child(name.as_str());
        let like_a_place = name.split_once(',').is_some_and(|(x, y)| {
            let number = |word: &str| word.trim().parse::<i64>().is_ok();
            number(x) && number(y)
        });
        if name.is_empty() || like_a_place {
            let message = format!("`{name}` cannot be the name of a pixel");
            return Err(check.problem(&path, message, "a word or more, which no x,y can be taken for"));
        }
        if pixel[0] >= image.width || pixel[1] >= image.height {
            let help = format!("x is 0 to {}, y is 0 to {}", image.width - 1, image.height - 1);
            return Err(check.problem(&path, format!("pixel {},{} lies outside the image", pixel[0], pixel[1]), help));
        }
    }
    Ok(Scene {
        about: file.about.clone(),
        image,
        camera,
        background,
        limits,
        precision: file.precision,
        numerics: file.numerics,
        lights,
        materials,
        objects,
        pixels: file.pixels.0.clone(),
    })
}

impl Camera {
    /// The unit vector along the `up` that the file gives, which need not be perpendicular to the view.
    fn up_hint(&self, file: &CameraFile) -> DVec3 {
        unit(DVec3::from_array(file.up)).unwrap_or(self.up)
    }
}

/// The checks of single values; each error points at its value.
#[derive(Clone, Copy)]
struct Check<'a> {
    located: Located<'a>,
}

impl Check<'_> {
    fn problem(&self, path: &JsonPath, message: impl Into<String>, help: impl Into<String>) -> Problem {
        self.located.problem(path, message, help)
    }

    /// A stored coordinate: zero, or a multiple of 2^-178 of magnitude at most 2^128, so that exact arithmetic stays
    /// exact.
    fn coordinate(&self, path: &JsonPath, x: f64) -> Result<f64, Problem> {
        if is_in_range(x) {
            return Ok(x);
        }
        let (message, help) = match x.abs() > 1.0 {
            true => (format!("{x:e} is too large for exact verdicts"), "at most 2^128 (3.4e38) in magnitude"),
            false => (
                format!("{x:e} is too fine for exact verdicts"),
                "0, or a multiple of 2^-178; from 1.2e-38 up every number is one",
            ),
        };
        Err(self.problem(path, message, help))
    }

    fn point(&self, path: &JsonPath, p: [f64; 3]) -> Result<DVec3, Problem> {
        for (i, x) in p.into_iter().enumerate() {
            self.coordinate(&path.child(i), x)?;
        }
        Ok(DVec3::from_array(p))
    }

    fn direction(&self, path: &JsonPath, d: [f64; 3], what: &str) -> Result<DVec3, Problem> {
        let vector = self.point(path, d)?;
        unit(vector).ok_or_else(|| {
            let help = "a vector of any length but zero, its largest component at least 2^-126 (1.2e-38)";
            self.problem(path, format!("{what} is zero, or too short to have a direction"), help)
        })
    }

    fn within(&self, path: &JsonPath, x: f64, least: f64, most: f64, what: &str) -> Result<f64, Problem> {
        if (least..=most).contains(&x) {
            return Ok(x);
        }
        self.fail_range(path, x, what, &format!("between {least} and {most}"))
    }

    fn fail_range<T>(&self, path: &JsonPath, x: f64, what: &str, range: &str) -> Result<T, Problem> {
        Err(self.problem(path, format!("{what} of {x:?} is out of range"), format!("{what} is {range}")))
    }

    fn rgb(&self, path: &JsonPath, color: [f64; 3]) -> Result<Rgb, Problem> {
        for (i, x) in color.into_iter().enumerate() {
            self.within(&path.child(i), x, 0.0, LARGEST_FACTOR, "a colour component")?;
        }
        Ok(Rgb::from_array(color))
    }

    /// A weight; one that is zero asks for nothing, like an absent one.
    fn weight(&self, path: &JsonPath, weight: Option<Weight>, most: f64) -> Result<Option<Rgb>, Problem> {
        let rgb = match weight {
            None => return Ok(None),
            Some(Weight::Gray(x)) => Rgb::splat(self.within(path, x, 0.0, most, "a weight")?),
            Some(Weight::Rgb(rgb)) => {
                for (i, x) in rgb.into_iter().enumerate() {
                    self.within(&path.child(i), x, 0.0, most, "a weight")?;
                }
                Rgb::from_array(rgb)
            }
        };
        Ok((rgb != Rgb::ZERO).then_some(rgb))
    }

    fn image(&self, path: &JsonPath, file: &SceneFile) -> Result<Resolution, Problem> {
        let image = Resolution { width: file.image.width, height: file.image.height };
        for (key, extent) in [("width", image.width), ("height", image.height)] {
            if extent == 0 {
                return Err(self.problem(&path.child(key), "the image has no area", format!("`{key}` is 1 or larger")));
            }
        }
        if u64::from(image.width) * u64::from(image.height) > Resolution::MOST_PIXELS {
            let message = format!("an image of {} x {} pixels is too large", image.width, image.height);
            return Err(self.problem(path, message, format!("at most {} pixels in all", Resolution::MOST_PIXELS)));
        }
        Ok(image)
    }

    fn camera(&self, path: &JsonPath, file: &CameraFile) -> Result<Camera, Problem> {
        let eye = self.point(&path.child("eye"), file.eye)?;
        let look_at = self.point(&path.child("look_at"), file.look_at)?;
        let up = self.direction(&path.child("up"), file.up, "`up`")?;
        let fov = file.fov_y_degrees;
        if !(fov > 0.0 && fov < 180.0) {
            return self.fail_range(
                &path.child("fov_y_degrees"),
                fov,
                "the field of view",
                "between 0 and 180 degrees",
            );
        }
        if unit(look_at - eye).is_none() {
            let help = "two points at least 2^-126 (1.2e-38) apart";
            return Err(self.problem(&path.child("look_at"), "`look_at` is where `eye` is", help));
        }
        Camera::look_at(eye, look_at, up, fov * (std::f64::consts::PI / 180.0)).ok_or_else(|| {
            let help = "any direction that is not along the line from `eye` to `look_at`";
            self.problem(&path.child("up"), "`up` is parallel to the view", help)
        })
    }

    fn background(&self, path: &JsonPath, file: Option<BackgroundFile>, up: DVec3) -> Result<Background, Problem> {
        match file {
            None => Ok(Background::Constant(Rgb::ZERO)),
            Some(BackgroundFile::Constant(color)) => Ok(Background::Constant(self.rgb(path, color)?)),
            Some(BackgroundFile::Gradient { gradient }) => {
                let path = path.child("gradient");
                let bottom = self.rgb(&path.child("bottom"), gradient.bottom)?;
                let top = self.rgb(&path.child("top"), gradient.top)?;
                Ok(Background::Gradient { bottom, top, up })
            }
        }
    }

    fn limits(&self, root: &JsonPath, file: &SceneFile) -> Result<Limits, Problem> {
        let max_depth = file.max_depth.unwrap_or(Limits::DEFAULT_DEPTH);
        if max_depth > Limits::DEEPEST {
            let help = format!("`max_depth` is 0 to {}", Limits::DEEPEST);
            return Err(self.problem(&root.child("max_depth"), format!("a depth of {max_depth} is too deep"), help));
        }
        if let Some(least) = file.min_weight {
            self.within(&root.child("min_weight"), least, 0.0, LARGEST_FACTOR, "`min_weight`")?;
        }
        let ray_budget = file.ray_budget.unwrap_or(Limits::DEFAULT_BUDGET);
        if ray_budget == 0 {
            return Err(self.problem(
                &root.child("ray_budget"),
                "no ray may be traced at all",
                "a budget is 1 or larger",
            ));
        }
        Ok(Limits { max_depth, min_weight: file.min_weight, ray_budget })
    }

    fn light(&self, path: &JsonPath, index: usize, file: &LightFile) -> Result<Light, Problem> {
        let name = file.name.clone().unwrap_or_else(|| format!("light {index}"));
        let (kind, color, path) = match (file.point, file.directional) {
            (Some(point), None) => {
                let path = path.child("point");
                (LightKind::Point { position: self.point(&path.child("position"), point.position)? }, point.color, path)
            }
            (None, Some(sun)) => {
                let path = path.child("directional");
                let direction = self.direction(&path.child("direction"), sun.direction, "`direction`")?;
                (LightKind::Directional { direction }, sun.color, path)
            }
            (Some(_), Some(_)) => {
                return Err(self.problem(path, "a light of two kinds", "either `point` or `directional`, not both"));
            }
            (None, None) => {
                let help = "add `point` with `position` and `color`, or `directional` with `direction` and `color`";
                return Err(self.problem(path, "a light of no kind", help));
            }
        };
        Ok(Light { name, kind, color: self.rgb(&path.child("color"), color)? })
    }

    fn material(&self, path: &JsonPath, name: &str, file: &MaterialFile) -> Result<Material, Problem> {
        let pigment = match (file.color, file.checker) {
            (Some(_), Some(_)) => {
                let help = "keep one of the two: the checker's colours stand in `checker.colors`";
                return Err(self.problem(&path.child("checker"), "`color` together with `checker`", help));
            }
            (None, Some(checker)) => {
                let path = path.child("checker");
                let size = checker.size;
                if !(size > 0.0 && is_in_range(size)) {
                    return self.fail_range(&path.child("size"), size, "the size of a cell", "larger than 0");
                }
                let mut colors = [Rgb::ZERO; 2];
                for (i, color) in checker.colors.into_iter().enumerate() {
                    colors[i] = self.rgb(&path.child("colors").child(i), color)?;
                }
                Pigment::Checker { colors, size }
            }
            (color, None) => Pigment::Constant(self.rgb(&path.child("color"), color.unwrap_or([1.0; 3]))?),
        };
        for (key, given, needed, value) in [
            ("specular", file.specular.is_some(), "shininess", file.shininess),
            ("transmission", file.transmission.is_some(), "ior", file.ior),
            ("fresnel", file.fresnel.is_some(), "ior", file.ior),
        ] {
            if given && value.is_none() {
                let help = format!("add `{needed}` to this material, or take `{key}` out");
                return Err(self.problem(&path.child(key), format!("`{key}` without `{needed}`"), help));
            }
        }
        let shininess = self.within(
            &path.child("shininess"),
            file.shininess.unwrap_or_default(),
            0.0,
            LARGEST_FACTOR,
            "`shininess`",
        )?;
        if let Some(ior) = file.ior
            && !(1e-6..=1e6).contains(&ior)
        {
            let range = "between 1e-6 and 1e6; that of glass is 1.5";
            return self.fail_range(&path.child("ior"), ior, "an index of refraction", range);
        }
        let specular = self.weight(&path.child("specular"), file.specular, LARGEST_FACTOR)?;
        let material = Material {
            name: name.to_owned(),
            pigment,
            ambient: self.weight(&path.child("ambient"), file.ambient, LARGEST_FACTOR)?,
            diffuse: self.weight(&path.child("diffuse"), file.diffuse, LARGEST_FACTOR)?,
            specular: specular.map(|strength| Specular { strength, shininess }),
            // The weights of 64 levels multiply: their product has to stay finite.
            reflection: self.weight(&path.child("reflection"), file.reflection, 1000.0)?,
            transmission: self.weight(&path.child("transmission"), file.transmission, 1000.0)?,
            ior: file.ior,
            fresnel: file.fresnel,
        };
        Ok(material)
    }

    fn object(
        &self,
        path: &JsonPath,
        index: usize,
        file: &ObjectFile,
        materials: &[Material],
        read_mesh: &mut ReadMesh<'_>,
    ) -> Result<Object, Problem> {
        let Some(material) = materials.iter().position(|m| m.name == file.material) else {
            let known = one_of(materials.iter().map(|m| m.name.as_str()));
            let help = match nearest(&file.material, materials.iter().map(|m| m.name.as_str())) {
                Some(near) => format!("did you mean `{near}`? There is {known}"),
                None => format!("there is {known}"),
            };
            let message = format!("there is no material `{}`", file.material);
            return Err(self.problem(&path.child("material"), message, help));
        };
        let shape = self.shape(&path.child("shape"), &file.shape, read_mesh)?;
        let name = file.name.clone().unwrap_or_else(|| format!("{} {index}", shape.kind()));
        Ok(Object { name, material: MaterialId(material as u32), shape })
    }

    fn shape(&self, path: &JsonPath, file: &ShapeFile, read_mesh: &mut ReadMesh<'_>) -> Result<Shape, Problem> {
        let ShapeFile { sphere, plane, aabb, triangle, mesh } = file;
        match (sphere, plane, aabb, triangle, mesh) {
            (Some(sphere), None, None, None, None) => {
                let path = path.child("sphere");
                let center = self.point(&path.child("center"), sphere.center)?;
                let radius = self.coordinate(&path.child("radius"), sphere.radius)?;
                if radius < 0.0 {
                    return self.fail_range(&path.child("radius"), radius, "a radius", "0 or larger");
                }
                Ok(Shape::Sphere { center, radius })
            }
            (None, Some(plane), None, None, None) => {
                let path = path.child("plane");
                let normal = self.direction(&path.child("normal"), plane.normal, "the normal")?;
                Ok(Shape::Plane { normal, distance: self.coordinate(&path.child("distance"), plane.distance)? })
            }
            (None, None, Some(aabb), None, None) => {
                let path = path.child("box");
                let min = self.point(&path.child("min"), aabb.min)?;
                let max = self.point(&path.child("max"), aabb.max)?;
                for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
                    if min[i] > max[i] {
                        let message = format!("`min` exceeds `max` along {axis}: {:?} > {:?}", min[i], max[i]);
                        return Err(self.problem(&path.child("min").child(i), message, "swap the two"));
                    }
                }
                Ok(Shape::Box { min, max })
            }
            (None, None, None, Some(triangle), None) => {
                let path = path.child("triangle").child("vertices");
                let mut vertices = [DVec3::ZERO; 3];
                for (i, vertex) in triangle.vertices.into_iter().enumerate() {
                    vertices[i] = self.point(&path.child(i), vertex)?;
                }
                Ok(Shape::Triangle { vertices })
            }
            (None, None, None, None, Some(mesh)) => Ok(Shape::Mesh(self.mesh(&path.child("mesh"), mesh, read_mesh)?)),
            (None, None, None, None, None) => {
                let help = "add one of `sphere`, `plane`, `box`, `triangle` or `mesh`";
                Err(self.problem(path, "a shape of no kind", help))
            }
            _ => Err(self.problem(path, "a shape of several kinds", "one shape an object: make two objects of them")),
        }
    }

    fn mesh(&self, path: &JsonPath, file: &MeshFile, read_mesh: &mut ReadMesh<'_>) -> Result<Mesh, Problem> {
        let path_of_file = path.child("file");
        let name = file.file.as_str();
        if !mesh::has_known_ending(name) {
            let message = format!("`{name}` is neither an OBJ nor a PLY file");
            return Err(self.problem(&path_of_file, message, "a path that ends in .obj or .ply"));
        }
        let bytes = read_mesh(name).map_err(|why| {
            let help = "the path of a readable file, relative to the scene";
            self.problem(&path_of_file, format!("the mesh `{name}` cannot be read: {why}"), help)
        })?;
        let mut data = mesh::parse_mesh(name, &bytes).map_err(|error| in_mesh_file(name, &bytes, error))?;
        if let Some(transform) = &file.transform {
            let moved = transform.apply(&data);
            data = moved.map_err(|error| self.problem(&path.child("transform"), error.message, error.help))?;
        }
        let corner = |i: u32| DVec3::from_array(data.positions[i as usize]);
        let triangles = data.faces.iter().map(|face| face.map(corner)).collect();
        let corner_normals = match file.normals {
            None | Some(MeshNormals::Flat) => None,
            Some(MeshNormals::Smooth) => {
                let normals = data.corner_normals.clone().unwrap_or_else(|| mesh::smooth_normals(&data));
                Some(normals.into_iter().map(|face| face.map(DVec3::from_array)).collect())
            }
        };
        Ok(Mesh { triangles, corner_normals, closed: mesh::solidity(&data) == mesh::Solidity::Solid })
    }
}

/// A mesh's error as a problem of the mesh file.
fn in_mesh_file(name: &str, bytes: &[u8], error: MeshError) -> Problem {
    let mut message = error.message;
    if let Some(offset) = error.byte_offset {
        message = format!("byte {offset}: {message}");
    }
    let problem = Problem::new(name, message, error.help);
    let Some(line) = error.line else { return problem };
    // A binary file's header is text; the line is looked up in it.
    let text = String::from_utf8_lossy(bytes);
    let start: usize = text.split_inclusive('\n').take(line as usize - 1).map(str::len).sum();
    let column = error.column.unwrap_or(1) as usize;
    let offset: usize = text[start..].chars().take(column - 1).map(char::len_utf8).sum();
    let rest = &text[start + offset..];
    let word = rest.find(char::is_whitespace).unwrap_or(rest.len());
    problem.at(&text, start + offset..start + offset + word)
}
