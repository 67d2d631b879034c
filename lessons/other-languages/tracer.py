"""A whole Whitted tracer that writes ray trees: python3 tracer.py X Y [X Y ...] prints one JSON tree a pixel, one a line.

The scene is that of scene.json. What the keys mean: docs/trees.md.
"""
import json
import math
import sys

WIDTH, HEIGHT, MAX_DEPTH = 320, 240, 4
EYE, FOV_Y = (0, 1, 6), 40  # looks along -z, y upwards
BACKGROUND = (0.2, 0.3, 0.5)
LIGHT, LIGHT_COLOR = (-3, 5, 4), (1, 0.9, 0.8)
MIRROR = dict(color=(0.9, 0.9, 0.9), ambient=0.05, diffuse=0.1, specular=0.5, shininess=60, reflection=0.8)
GLASS = dict(color=(1, 1, 1), diffuse=0.05, reflection=0.1, transmission=0.9, ior=1.5)
FLOOR = dict(color=(0.8, 0.7, 0.5), ambient=0.2, diffuse=0.8)
OBJECTS = [
    ("mirror ball", MIRROR, ("sphere", (-1, 1, -1), 1)),
    ("glass ball", GLASS, ("sphere", (0.8, 0.7, 1), 0.7)),
    ("floor", FLOOR, ("plane", (0, 1, 0), 0)),
]
EPSILON = 1e-9  # a ray does not hit the surface that it starts on


def add(a, b): return tuple(x + y for x, y in zip(a, b))
def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def mul(a, b): return tuple(x * y for x, y in zip(a, b))
def scale(a, k): return tuple(x * k for x in a)
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return scale(a, 1 / math.sqrt(dot(a, a)))


def intersect(origin, direction, t_max=math.inf):
    """The nearest hit before t_max: t, the object's number, the point, the outward normal; or None."""
    best = None
    for i, (_, _, (kind, place, size)) in enumerate(OBJECTS):
        if kind == "sphere":
            f = sub(origin, place)
            a, b, c = dot(direction, direction), 2 * dot(f, direction), dot(f, f) - size * size
            d = b * b - 4 * a * c
            ts = [] if d < 0 else [(-b - math.sqrt(d)) / (2 * a), (-b + math.sqrt(d)) / (2 * a)]
        else:
            along = dot(place, direction)
            ts = [] if along == 0 else [(size - dot(place, origin)) / along]
        t = next((t for t in ts if t > EPSILON), None)
        if t is not None and t < (best[0] if best else t_max):
            point = add(origin, scale(direction, t))
            best = (t, i, point, scale(sub(point, place), 1 / size) if kind == "sphere" else place)
    return best


def hit_record(hit, direction):
    t, i, point, outward = hit
    entering = dot(outward, direction) < 0
    return {
        "t": t, "point": point, "object": OBJECTS[i][0], "shape": i, "geometric_normal": outward,
        "shading_normal": outward if entering else scale(outward, -1), "side": "entering" if entering else "leaving",
    }


def direct_light(node, material, direction):
    """Ambient, diffuse and specular light, with a shadow ray."""
    hit = node["hit"]
    point, normal = hit["point"], hit["shading_normal"]
    ambient = scale(material["color"], material.get("ambient", 0))
    node["local"] = {"ambient": ambient, "lights": []}
    way = sub(LIGHT, point)
    distance = math.sqrt(dot(way, way))
    way = scale(way, 1 / distance)
    cosine = dot(normal, way)
    if cosine < 0:
        return ambient
    shadow = {"kind": "shadow", "light": "lamp", "depth": node["depth"], "origin": point, "direction": way, "t_max": distance}
    node["shadows"] = [shadow]
    blocker = intersect(point, way, distance)
    shadow["outcome"] = "blocked" if blocker else "lit"
    diffuse = specular = (0, 0, 0)
    if blocker:
        shadow["hit"] = hit_record(blocker, way)
    else:
        diffuse = scale(mul(material["color"], LIGHT_COLOR), material["diffuse"] * cosine)
        mirrored = sub(scale(normal, 2 * cosine), way)
        shine = max(0, -dot(mirrored, unit(direction)))
        specular = scale(LIGHT_COLOR, material.get("specular", 0) * shine ** material.get("shininess", 1))
    node["local"]["lights"].append({"light": "lamp", "diffuse": diffuse, "specular": specular})
    return add(ambient, add(diffuse, specular))


def refract(direction, normal, eta):
    cosine = -dot(direction, normal)
    k = 1 - eta * eta * (1 - cosine * cosine)
    return None if k < 0 else add(scale(direction, eta), scale(normal, eta * cosine - math.sqrt(k)))


def trace(kind, level, weight, origin, direction):
    node = {"kind": kind, "depth": level, "weight": (weight,) * 3, "origin": origin, "direction": direction}
    if level > MAX_DEPTH:
        return node | {"outcome": "max_depth", "radiance": (0, 0, 0)}
    hit = intersect(origin, direction)
    if not hit:
        return node | {"outcome": "background", "radiance": BACKGROUND}
    material = OBJECTS[hit[1]][1]
    node |= {"outcome": "hit", "hit": hit_record(hit, direction)}
    point, normal = hit[2], node["hit"]["shading_normal"]
    color = direct_light(node, material, direction)
    reflection, refracted = material.get("reflection", 0), None
    if "transmission" in material:
        entering = node["hit"]["side"] == "entering"
        refracted = refract(direction, normal, 1 / material["ior"] if entering else material["ior"])
        if refracted is None:
            node["total_reflection"] = True
            reflection += material["transmission"]
    if reflection:
        reflected = sub(direction, scale(normal, 2 * dot(direction, normal)))
        node["reflected"] = trace("reflected", level + 1, weight * reflection, point, reflected)
        color = add(color, scale(node["reflected"]["radiance"], reflection))
    if refracted:
        through = material["transmission"]
        node["refracted"] = trace("refracted", level + 1, weight * through, point, refracted)
        color = add(color, scale(node["refracted"]["radiance"], through))
    return node | {"radiance": color}


def count(node):
    children = node.get("shadows", []) + [node[key] for key in ("reflected", "refracted") if key in node]
    return (node["outcome"] != "max_depth") + sum(count(child) for child in children)


def pixel(x, y):
    half = math.tan(math.radians(FOV_Y) / 2)
    across = (2 * (x + 0.5) / WIDTH - 1) * half * WIDTH / HEIGHT
    upwards = (1 - 2 * (y + 0.5) / HEIGHT) * half
    root = trace("camera", 0, 1, EYE, unit((across, upwards, -1)))
    return {
        "format": "raytree/1", "generator": {"name": "tracer.py"}, "pixel": [x, y],
        "color": root["radiance"], "rays": count(root), "root": root,
    }


places = [int(word) for word in sys.argv[1:]]
for x, y in zip(places[::2], places[1::2]):
    print(json.dumps(pixel(x, y)))
