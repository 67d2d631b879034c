// A whole Whitted tracer that writes ray trees: node tracer.js X Y [X Y ...] prints one JSON tree a pixel, one a line.
//
// The scene is that of scene.json. What the keys mean: docs/trees.md.
"use strict";

const WIDTH = 320, HEIGHT = 240, MAX_DEPTH = 4;
const EYE = [0, 1, 6], FOV_Y = 40; // looks along -z, y upwards
const BACKGROUND = [0.2, 0.3, 0.5];
const LIGHT = [-3, 5, 4], LIGHT_COLOR = [1, 0.9, 0.8];
const MIRROR = { color: [0.9, 0.9, 0.9], ambient: 0.05, diffuse: 0.1, specular: 0.5, shininess: 60, reflection: 0.8 };
const GLASS = { color: [1, 1, 1], diffuse: 0.05, reflection: 0.1, transmission: 0.9, ior: 1.5 };
const FLOOR = { color: [0.8, 0.7, 0.5], ambient: 0.2, diffuse: 0.8 };
const OBJECTS = [
  { name: "mirror ball", material: MIRROR, center: [-1, 1, -1], radius: 1 },
  { name: "glass ball", material: GLASS, center: [0.8, 0.7, 1], radius: 0.7 },
  { name: "floor", material: FLOOR, normal: [0, 1, 0], distance: 0 },
];
const EPSILON = 1e-9; // a ray does not hit the surface that it starts on

const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (a, b) => a.map((x, i) => x * b[i]);
const scale = (a, k) => a.map((x) => x * k);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => scale(a, 1 / Math.sqrt(dot(a, a)));

/** All t at which a ray meets an object, the smaller first. */
function meetings(object, origin, direction) {
  if (object.normal) {
    const along = dot(object.normal, direction);
    return along === 0 ? [] : [(object.distance - dot(object.normal, origin)) / along];
  }
  const f = sub(origin, object.center);
  const a = dot(direction, direction), b = 2 * dot(f, direction), c = dot(f, f) - object.radius ** 2;
  const root = Math.sqrt(b * b - 4 * a * c); // NaN where there is none: no comparison with it holds
  return [(-b - root) / (2 * a), (-b + root) / (2 * a)];
}

/** The nearest hit before tMax as the tree has it, or undefined. */
function intersect(origin, direction, tMax = Infinity) {
  let best;
  OBJECTS.forEach((object, shape) => {
    const t = meetings(object, origin, direction).find((t) => t > EPSILON);
    if (!(t < (best ? best.t : tMax))) return;
    const point = add(origin, scale(direction, t));
    const outward = object.normal ?? scale(sub(point, object.center), 1 / object.radius);
    const entering = dot(outward, direction) < 0;
    best = {
      t, point, object: object.name, shape, geometric_normal: outward,
      shading_normal: entering ? outward : scale(outward, -1), side: entering ? "entering" : "leaving",
    };
  });
  return best;
}

/** Ambient, diffuse and specular light, with a shadow ray. */
function directLight(node, material) {
  const { point, shading_normal: normal } = node.hit;
  const ambient = scale(material.color, material.ambient ?? 0);
  node.local = { ambient, lights: [] };
  const distance = Math.sqrt(dot(sub(LIGHT, point), sub(LIGHT, point)));
  const direction = scale(sub(LIGHT, point), 1 / distance);
  const cosine = dot(normal, direction);
  if (cosine < 0) return ambient;
  const blocker = intersect(point, direction, distance);
  node.shadows = [{
    kind: "shadow", light: "lamp", depth: node.depth, origin: point, direction, t_max: distance,
    outcome: blocker ? "blocked" : "lit", hit: blocker, // JSON.stringify leaves out what is undefined
  }];
  let diffuse = [0, 0, 0], specular = [0, 0, 0];
  if (!blocker) {
    diffuse = scale(mul(material.color, LIGHT_COLOR), material.diffuse * cosine);
    const mirrored = sub(scale(normal, 2 * cosine), direction);
    const shine = Math.max(0, -dot(mirrored, unit(node.direction)));
    specular = scale(LIGHT_COLOR, (material.specular ?? 0) * shine ** (material.shininess ?? 1));
  }
  node.local.lights.push({ light: "lamp", diffuse, specular });
  return add(ambient, add(diffuse, specular));
}

function refract(direction, normal, eta) {
  const cosine = -dot(direction, normal);
  const k = 1 - eta * eta * (1 - cosine * cosine);
  return k < 0 ? undefined : add(scale(direction, eta), scale(normal, eta * cosine - Math.sqrt(k)));
}

function trace(kind, level, weight, origin, direction) {
  const node = { kind, depth: level, weight: [weight, weight, weight], origin, direction };
  if (level > MAX_DEPTH) return { ...node, outcome: "max_depth", radiance: [0, 0, 0] };
  node.hit = intersect(origin, direction);
  if (!node.hit) return { ...node, outcome: "background", radiance: BACKGROUND };
  node.outcome = "hit";
  const material = OBJECTS[node.hit.shape].material;
  const { point, shading_normal: normal } = node.hit;
  let color = directLight(node, material);
  let reflection = material.reflection ?? 0, refracted;
  if (material.transmission) {
    refracted = refract(direction, normal, node.hit.side === "entering" ? 1 / material.ior : material.ior);
    if (!refracted) {
      node.total_reflection = true;
      reflection += material.transmission;
    }
  }
  if (reflection) {
    const reflected = sub(direction, scale(normal, 2 * dot(direction, normal)));
    node.reflected = trace("reflected", level + 1, weight * reflection, point, reflected);
    color = add(color, scale(node.reflected.radiance, reflection));
  }
  if (refracted) {
    node.refracted = trace("refracted", level + 1, weight * material.transmission, point, refracted);
    color = add(color, scale(node.refracted.radiance, material.transmission));
  }
  return { ...node, radiance: color };
}

function count(node) {
  const children = [...(node.shadows ?? []), node.reflected, node.refracted].filter(Boolean);
  return (node.outcome === "max_depth" ? 0 : 1) + children.reduce((sum, child) => sum + count(child), 0);
}

function pixel(x, y) {
  const half = Math.tan((FOV_Y * Math.PI) / 180 / 2);
  const across = ((2 * (x + 0.5)) / WIDTH - 1) * half * (WIDTH / HEIGHT);
  const upwards = (1 - (2 * (y + 0.5)) / HEIGHT) * half;
  const root = trace("camera", 0, 1, EYE, unit([across, upwards, -1]));
  const generator = { name: "tracer.js" };
  return { format: "raytree/1", generator, pixel: [x, y], color: root.radiance, rays: count(root), root };
}

const places = process.argv.slice(2).map(Number);
for (let i = 0; i + 1 < places.length; i += 2) console.log(JSON.stringify(pixel(places[i], places[i + 1])));
