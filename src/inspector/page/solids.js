// Triangles of the shapes of a scene: positions and normals, three vertices a triangle.

/** Sum, difference, multiple, products of vectors of three. */
export const vec = {
    add: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
    sub: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
    times: (a, s) => [a[0] * s, a[1] * s, a[2] * s],
    dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
    cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
    length: (a) => Math.hypot(...a),
    unit: (a) => {
        const length = Math.hypot(...a) || 1;
        return [a[0] / length, a[1] / length, a[2] / length];
    },
};

function sphereTriangles({ center, radius }) {
    const [across, down] = [48, 24];
    const point = (i, j) => {
        const [u, v] = [(i / across) * 2 * Math.PI, (j / down) * Math.PI];
        return [Math.sin(v) * Math.cos(u), Math.cos(v), Math.sin(v) * Math.sin(u)];
    };
    const data = [];
    const put = (n) => data.push(center[0] + radius * n[0], center[1] + radius * n[1], center[2] + radius * n[2], ...n);
    for (let j = 0; j < down; j += 1) {
        for (let i = 0; i < across; i += 1) {
            const [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            for (const n of [a, b, c, a, c, d]) put(n);
        }
    }
    return new Float32Array(data);
}

function boxTriangles({ min, max }) {
    const data = [];
    for (let axis = 0; axis < 3; axis += 1) {
        for (const side of [0, 1]) {
            const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            const corner = (a, b) => {
                const p = [0, 0, 0];
                p[axis] = (side ? max : min)[axis];
                p[u] = (a ? max : min)[u];
                p[v] = (b ? max : min)[v];
                return p;
            };
            const normal = [0, 0, 0];
            normal[axis] = side ? 1 : -1;
            const [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            for (const p of [a, b, c, a, c, d]) data.push(...p, ...normal);
        }
    }
    return new Float32Array(data);
}

/** Two unit vectors in the plane across a unit normal. */
function acrossNormal(normal) {
    const other = Math.abs(normal[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const u = vec.unit(vec.cross(normal, other));
    return [u, vec.cross(normal, u)];
}

function planeTriangles({ normal, distance }, middle, reach) {
    const foot = vec.add(middle, vec.times(normal, distance - vec.dot(normal, middle)));
    const [u, v] = acrossNormal(normal);
    const data = [];
    const corner = (a, b) => vec.add(foot, vec.add(vec.times(u, a * reach), vec.times(v, b * reach)));
    const [a, b, c, d] = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
    for (const p of [a, b, c, a, c, d]) data.push(...p, ...normal);
    return new Float32Array(data);
}

function decoded(base64, Type) {
    return new Type(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
}

function meshTriangles({ positions, indices }) {
    const [p, index] = [decoded(positions, Float32Array), decoded(indices, Uint32Array)];
    const data = new Float32Array(index.length * 6);
    for (let i = 0; i < index.length; i += 3) {
        const corners = [0, 1, 2].map((k) => [p[index[i + k] * 3], p[index[i + k] * 3 + 1], p[index[i + k] * 3 + 2]]);
        const normal = vec.unit(vec.cross(vec.sub(corners[1], corners[0]), vec.sub(corners[2], corners[0])));
        corners.forEach((corner, k) => {
            data.set(corner, (i + k) * 6);
            data.set(normal, (i + k) * 6 + 3);
        });
    }
    return data;
}

/** Triangles of one shape. Planes are endless: they get a square of half-width `reach` around `middle`. */
export function trianglesOf(shape, middle, reach) {
    switch (shape.kind) {
        case 'sphere':
            return sphereTriangles(shape);
        case 'box':
            return boxTriangles(shape);
        case 'plane':
            return planeTriangles(shape, middle, reach);
        default:
            return meshTriangles(shape);
    }
}

/** The corners of the box around all that is bounded, `[min, max]`. */
export function boundsOf(description) {
    const min = [Infinity, Infinity, Infinity];
    const max = [-Infinity, -Infinity, -Infinity];
    const take = (p) => {
        for (let k = 0; k < 3; k += 1) {
            min[k] = Math.min(min[k], p[k]);
            max[k] = Math.max(max[k], p[k]);
        }
    };
    for (const { shape } of description.objects) {
        if (shape.kind === 'sphere') for (const s of [-1, 1]) take(shape.center.map((c) => c + s * shape.radius));
        else if (shape.kind === 'triangle') shape.vertices.forEach(take);
        else if (shape.min) [shape.min, shape.max].forEach(take);
    }
    if (!Number.isFinite(min[0])) {
        const { eye, forward } = description.camera;
        take(eye);
        take(vec.add(eye, vec.times(forward, 6)));
    }
    return [min, max];
}

/** The twelve edges of a box as pairs of points. */
export function boxEdges(min, max) {
    const corner = (i) => [(i & 1 ? max : min)[0], (i & 2 ? max : min)[1], (i & 4 ? max : min)[2]];
    const edges = [];
    for (let i = 0; i < 8; i += 1) for (const bit of [1, 2, 4]) if (!(i & bit)) edges.push([corner(i), corner(i | bit)]);
    return edges;
}
