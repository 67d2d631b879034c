// A whole Whitted tracer that writes ray trees: g++ -O1 -std=c++17 tracer.cpp -o tracer && ./tracer X Y [X Y ...] prints one JSON
// tree a pixel, one a line.
//
// The scene is that of scene.json. What the keys mean: docs/trees.md.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

struct Vec { double x, y, z; };
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec operator*(Vec a, double k) { return {a.x * k, a.y * k, a.z * k}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vec a) { return std::sqrt(dot(a, a)); }

struct Material { Vec color; double ambient, diffuse, specular, shininess, reflection, transmission, ior; };
struct Object { const char *name; Material material; bool is_plane; Vec place; double size; };

const int WIDTH = 320, HEIGHT = 240, MAX_DEPTH = 4;
const Vec EYE{0, 1, 6};  // looks along -z, y upwards
const double FOV_Y = 40, PI = 3.14159265358979323846;
const Vec BACKGROUND{0.2, 0.3, 0.5}, LIGHT{-3, 5, 4}, LIGHT_COLOR{1, 0.9, 0.8};
const Material MIRROR{{0.9, 0.9, 0.9}, 0.05, 0.1, 0.5, 60, 0.8, 0, 1};
const Material GLASS{{1, 1, 1}, 0, 0.05, 0, 1, 0.1, 0.9, 1.5};
const Material MATT{{0.8, 0.7, 0.5}, 0.2, 0.8, 0, 1, 0, 0, 1};
const Object OBJECTS[] = {
    {"mirror ball", MIRROR, false, {-1, 1, -1}, 1},
    {"glass ball", GLASS, false, {0.8, 0.7, 1}, 0.7},
    {"floor", MATT, true, {0, 1, 0}, 0},
};
const double EPSILON = 1e-9;  // a ray does not hit the surface that it starts on

// 17 digits read back to the same bits.
std::string json(double x) { char text[32]; std::snprintf(text, sizeof text, "%.17g", x); return text; }
std::string json(Vec v) { return "[" + json(v.x) + "," + json(v.y) + "," + json(v.z) + "]"; }
std::string word(const std::string &text) { return "\"" + text + "\""; }

struct Hit {
    double t; int shape; Vec point, outward, normal; bool entering;
    std::string text() const {
        return "{\"t\":" + json(t) + ",\"point\":" + json(point) + ",\"object\":" + word(OBJECTS[shape].name) +
               ",\"shape\":" + std::to_string(shape) + ",\"geometric_normal\":" + json(outward) +
               ",\"shading_normal\":" + json(normal) + ",\"side\":" + word(entering ? "entering" : "leaving") + "}";
    }
};

// The nearest hit before t_max.
std::optional<Hit> intersect(Vec origin, Vec direction, double t_max = INFINITY) {
    std::optional<Hit> best;
    for (int i = 0; i < 3; i++) {
        const Object &object = OBJECTS[i];
        double t[2] = {NAN, NAN};
        if (object.is_plane) {
            double along = dot(object.place, direction);
            if (along != 0) t[0] = (object.size - dot(object.place, origin)) / along;
        } else {
            Vec f = origin - object.place;
            double a = dot(direction, direction), b = 2 * dot(f, direction), c = dot(f, f) - object.size * object.size;
            double root = std::sqrt(b * b - 4 * a * c);  // NaN where there is none: no comparison with it holds
            t[0] = (-b - root) / (2 * a);
            t[1] = (-b + root) / (2 * a);
        }
        double first = t[0] > EPSILON ? t[0] : t[1];
        if (!(first > EPSILON && first < (best ? best->t : t_max))) continue;
        Vec point = origin + direction * first;
        Vec outward = object.is_plane ? object.place : (point - object.place) * (1 / object.size);
        bool entering = dot(outward, direction) < 0;
        best = Hit{first, i, point, outward, entering ? outward : outward * -1, entering};
    }
    return best;
}

// Ambient, diffuse and specular light; adds `local` and the shadow ray to the node.
Vec direct_light(const Hit &hit, const Material &m, Vec direction, int level, std::string &node, int &rays) {
    Vec ambient = m.color * m.ambient, diffuse{0, 0, 0}, specular{0, 0, 0};
    node += ",\"local\":{\"ambient\":" + json(ambient) + ",\"lights\":[";
    double distance = length(LIGHT - hit.point);
    Vec way = (LIGHT - hit.point) * (1 / distance);
    double cosine = dot(hit.normal, way);
    if (cosine < 0) { node += "]}"; return ambient; }
    std::optional<Hit> blocker = intersect(hit.point, way, distance);
    rays++;
    if (!blocker) {
        diffuse = m.color * LIGHT_COLOR * (m.diffuse * cosine);
        Vec mirrored = hit.normal * (2 * cosine) - way;
        double shine = std::fmax(0, -dot(mirrored, direction * (1 / length(direction))));
        specular = LIGHT_COLOR * (m.specular * std::pow(shine, m.shininess));
    }
    node += "{\"light\":\"lamp\",\"diffuse\":" + json(diffuse) + ",\"specular\":" + json(specular) + "}]}";
    node += ",\"shadows\":[{\"kind\":\"shadow\",\"light\":\"lamp\",\"depth\":" + std::to_string(level) + ",\"origin\":" +
            json(hit.point) + ",\"direction\":" + json(way) + ",\"t_max\":" + json(distance) + ",\"outcome\":" +
            word(blocker ? "blocked" : "lit") + (blocker ? ",\"hit\":" + blocker->text() : "") + "}]";
    return ambient + diffuse + specular;
}

// Nothing at total reflection.
std::optional<Vec> refract(Vec direction, Vec normal, double eta) {
    double cosine = -dot(direction, normal), k = 1 - eta * eta * (1 - cosine * cosine);
    if (k < 0) return std::nullopt;
    return direction * eta + normal * (eta * cosine - std::sqrt(k));
}

struct Traced { Vec radiance; std::string text; };

Traced trace(const char *kind, int level, double weight, Vec origin, Vec direction, int &rays) {
    std::string node = "{\"kind\":" + word(kind) + ",\"depth\":" + std::to_string(level) + ",\"weight\":" +
                       json(Vec{weight, weight, weight}) + ",\"origin\":" + json(origin) + ",\"direction\":" + json(direction);
    auto ends = [&](const char *outcome, Vec radiance) -> Traced {
        return {radiance, node + ",\"outcome\":" + word(outcome) + ",\"radiance\":" + json(radiance) + "}"};
    };
    if (level > MAX_DEPTH) return ends("max_depth", {0, 0, 0});
    rays++;
    std::optional<Hit> hit = intersect(origin, direction);
    if (!hit) return ends("background", BACKGROUND);
    const Material &m = OBJECTS[hit->shape].material;
    node += ",\"outcome\":\"hit\",\"hit\":" + hit->text();
    Vec color = direct_light(*hit, m, direction, level, node, rays);
    double reflection = m.reflection;
    std::optional<Vec> through;
    if (m.transmission > 0) {
        through = refract(direction, hit->normal, hit->entering ? 1 / m.ior : m.ior);
        if (!through) {
            node += ",\"total_reflection\":true";
            reflection += m.transmission;
        }
    }
    if (reflection > 0) {
        Vec back = direction - hit->normal * (2 * dot(direction, hit->normal));
        Traced child = trace("reflected", level + 1, weight * reflection, hit->point, back, rays);
        color = color + child.radiance * reflection;
        node += ",\"reflected\":" + child.text;
    }
    if (through) {
        Traced child = trace("refracted", level + 1, weight * m.transmission, hit->point, *through, rays);
        color = color + child.radiance * m.transmission;
        node += ",\"refracted\":" + child.text;
    }
    return {color, node + ",\"radiance\":" + json(color) + "}"};
}

int main(int count, char **words) {
    for (int i = 1; i + 1 < count; i += 2) {
        int x = std::atoi(words[i]), y = std::atoi(words[i + 1]), rays = 0;
        double half = std::tan(FOV_Y * PI / 180 / 2);
        Vec direction{(2 * (x + 0.5) / WIDTH - 1) * half * WIDTH / HEIGHT, (1 - 2 * (y + 0.5) / HEIGHT) * half, -1};
        Traced root = trace("camera", 0, 1, EYE, direction * (1 / length(direction)), rays);
        std::printf("{\"format\":\"raytree/1\",\"generator\":{\"name\":\"tracer.cpp\"},\"pixel\":[%d,%d],\"color\":%s,\"rays\":%d,"
                    "\"root\":%s}\n", x, y, json(root.radiance).c_str(), rays, root.text.c_str());
    }
}
