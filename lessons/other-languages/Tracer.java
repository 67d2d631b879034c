// A whole Whitted tracer that writes ray trees: java Tracer.java X Y [X Y ...] prints one JSON tree a pixel, one a line.
//
// The scene is that of scene.json. What the keys mean: docs/trees.md.
import java.util.Arrays;

class Tracer {
    record Vec(double x, double y, double z) {
        Vec plus(Vec b) { return new Vec(x + b.x, y + b.y, z + b.z); }
        Vec minus(Vec b) { return new Vec(x - b.x, y - b.y, z - b.z); }
        Vec times(Vec b) { return new Vec(x * b.x, y * b.y, z * b.z); }
        Vec times(double k) { return new Vec(x * k, y * k, z * k); }
        double dot(Vec b) { return x * b.x + y * b.y + z * b.z; }
        double length() { return Math.sqrt(dot(this)); }
        // Java prints a double with as many digits as read back to the same bits.
        @Override public String toString() { return "[" + x + "," + y + "," + z + "]"; }
    }

    record Material(Vec color, double ambient, double diffuse, double specular, double shininess, double reflection,
                    double transmission, double ior) {}

    record Shape(String name, Material material, boolean isPlane, Vec place, double size) {}

    static final int WIDTH = 320, HEIGHT = 240, MAX_DEPTH = 4;
    static final Vec EYE = new Vec(0, 1, 6); // looks along -z, y upwards
    static final double FOV_Y = 40;
    static final Vec BACKGROUND = new Vec(0.2, 0.3, 0.5), LIGHT = new Vec(-3, 5, 4), LIGHT_COLOR = new Vec(1, 0.9, 0.8);
    static final Material MIRROR = new Material(new Vec(0.9, 0.9, 0.9), 0.05, 0.1, 0.5, 60, 0.8, 0, 1);
    static final Material GLASS = new Material(new Vec(1, 1, 1), 0, 0.05, 0, 1, 0.1, 0.9, 1.5);
    static final Material MATT = new Material(new Vec(0.8, 0.7, 0.5), 0.2, 0.8, 0, 1, 0, 0, 1);
    static final Shape[] SHAPES = {
        new Shape("mirror ball", MIRROR, false, new Vec(-1, 1, -1), 1),
        new Shape("glass ball", GLASS, false, new Vec(0.8, 0.7, 1), 0.7),
        new Shape("floor", MATT, true, new Vec(0, 1, 0), 0),
    };
    static final double EPSILON = 1e-9; // a ray does not hit the surface that it starts on

    record Hit(double t, int shape, Vec point, Vec outward, Vec normal, boolean entering) {
        @Override public String toString() {
            return "{\"t\":" + t + ",\"point\":" + point + ",\"object\":\"" + SHAPES[shape].name + "\",\"shape\":" + shape
                + ",\"geometric_normal\":" + outward + ",\"shading_normal\":" + normal
                + ",\"side\":\"" + (entering ? "entering" : "leaving") + "\"}";
        }
    }

    /** The nearest hit before tMax, or null. */
    static Hit intersect(Vec origin, Vec direction, double tMax) {
        Hit best = null;
        for (int i = 0; i < SHAPES.length; i++) {
            Shape shape = SHAPES[i];
            double near, far = Double.NaN;
            if (shape.isPlane) {
                // Infinite or NaN along the plane: no hit either way.
                near = (shape.size - shape.place.dot(origin)) / shape.place.dot(direction);
            } else {
                Vec f = origin.minus(shape.place);
                double a = direction.dot(direction), b = 2 * f.dot(direction), c = f.dot(f) - shape.size * shape.size;
                double root = Math.sqrt(b * b - 4 * a * c); // NaN where there is none: no comparison with it holds
                near = (-b - root) / (2 * a);
                far = (-b + root) / (2 * a);
            }
            double t = near > EPSILON ? near : far;
            if (!(t > EPSILON && t < (best == null ? tMax : best.t))) continue;
            Vec point = origin.plus(direction.times(t));
            Vec outward = shape.isPlane ? shape.place : point.minus(shape.place).times(1 / shape.size);
            boolean entering = outward.dot(direction) < 0;
            best = new Hit(t, i, point, outward, entering ? outward : outward.times(-1), entering);
        }
        return best;
    }

    static int rays;

    /** Ambient, diffuse and specular light; adds `local` and the shadow ray to the node. */
    static Vec directLight(Hit hit, Material m, Vec direction, int level, StringBuilder node) {
        Vec ambient = m.color.times(m.ambient), diffuse = new Vec(0, 0, 0), specular = new Vec(0, 0, 0);
        node.append(",\"local\":{\"ambient\":" + ambient + ",\"lights\":[");
        double distance = LIGHT.minus(hit.point).length();
        Vec way = LIGHT.minus(hit.point).times(1 / distance);
        double cosine = hit.normal.dot(way);
        if (cosine < 0) {
            node.append("]}");
            return ambient;
        }
        Hit blocker = intersect(hit.point, way, distance);
        rays++;
        if (blocker == null) {
            diffuse = m.color.times(LIGHT_COLOR).times(m.diffuse * cosine);
            Vec mirrored = hit.normal.times(2 * cosine).minus(way);
            double shine = Math.max(0, -mirrored.dot(direction.times(1 / direction.length())));
            specular = LIGHT_COLOR.times(m.specular * Math.pow(shine, m.shininess));
        }
        node.append("{\"light\":\"lamp\",\"diffuse\":" + diffuse + ",\"specular\":" + specular + "}]}");
        node.append(",\"shadows\":[{\"kind\":\"shadow\",\"light\":\"lamp\",\"depth\":" + level + ",\"origin\":" + hit.point
            + ",\"direction\":" + way + ",\"t_max\":" + distance
            + (blocker == null ? ",\"outcome\":\"lit\"" : ",\"outcome\":\"blocked\",\"hit\":" + blocker) + "}]");
        return ambient.plus(diffuse).plus(specular);
    }

    /** Null at total reflection. */
    static Vec refract(Vec direction, Vec normal, double eta) {
        double cosine = -direction.dot(normal), k = 1 - eta * eta * (1 - cosine * cosine);
        return k < 0 ? null : direction.times(eta).plus(normal.times(eta * cosine - Math.sqrt(k)));
    }

    record Traced(Vec radiance, String text) {}

    static Traced end(StringBuilder node, String outcome, Vec radiance) {
        return new Traced(radiance, node + ",\"outcome\":\"" + outcome + "\",\"radiance\":" + radiance + "}");
    }

    static Traced trace(String kind, int level, double weight, Vec origin, Vec direction) {
        StringBuilder node = new StringBuilder("{\"kind\":\"" + kind + "\",\"depth\":" + level + ",\"weight\":"
            + new Vec(weight, weight, weight) + ",\"origin\":" + origin + ",\"direction\":" + direction);
        if (level > MAX_DEPTH) return end(node, "max_depth", new Vec(0, 0, 0));
        rays++;
        Hit hit = intersect(origin, direction, Double.POSITIVE_INFINITY);
        if (hit == null) return end(node, "background", BACKGROUND);
        Material m = SHAPES[hit.shape].material;
        node.append(",\"outcome\":\"hit\",\"hit\":" + hit);
        Vec color = directLight(hit, m, direction, level, node);
        double reflection = m.reflection;
        Vec through = null;
        if (m.transmission > 0) {
            through = refract(direction, hit.normal, hit.entering ? 1 / m.ior : m.ior);
            if (through == null) {
                node.append(",\"total_reflection\":true");
                reflection += m.transmission;
            }
        }
        if (reflection > 0) {
            Vec back = direction.minus(hit.normal.times(2 * direction.dot(hit.normal)));
            Traced child = trace("reflected", level + 1, weight * reflection, hit.point, back);
            color = color.plus(child.radiance.times(reflection));
            node.append(",\"reflected\":" + child.text);
        }
        if (through != null) {
            Traced child = trace("refracted", level + 1, weight * m.transmission, hit.point, through);
            color = color.plus(child.radiance.times(m.transmission));
            node.append(",\"refracted\":" + child.text);
        }
        return new Traced(color, node + ",\"radiance\":" + color + "}");
    }

    public static void main(String[] words) {
        int[] places = Arrays.stream(words).mapToInt(Integer::parseInt).toArray();
        for (int i = 0; i + 1 < places.length; i += 2) {
            int x = places[i], y = places[i + 1];
            double half = Math.tan(Math.toRadians(FOV_Y) / 2);
            double across = (2 * (x + 0.5) / WIDTH - 1) * half * WIDTH / HEIGHT;
            Vec direction = new Vec(across, (1 - 2 * (y + 0.5) / HEIGHT) * half, -1);
            rays = 0;
            Traced root = trace("camera", 0, 1, EYE, direction.times(1 / direction.length()));
            System.out.println("{\"format\":\"raytree/1\",\"generator\":{\"name\":\"Tracer.java\"},\"pixel\":[" + x + "," + y
                + "],\"color\":" + root.radiance + ",\"rays\":" + rays + ",\"root\":" + root.text + "}");
        }
    }
}
