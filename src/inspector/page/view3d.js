// The scene in three dimensions: shapes, camera and image plane, the rays up to the current step, the boxes that the
// current ray visited. WebGL2, drawn only when something changed.

import { make } from './dom.js';
import { counted } from './format.js';
import { readSpans } from './json-edit.js';
import { cssColor, DASHES, KINDS, rgbOfHex, srgbBytes } from './palette.js';
import { LINE_FRAGMENT, LINE_VERTEX, PLATE_FRAGMENT, SOLID_FRAGMENT, SOLID_VERTEX } from './shaders.js';
import { boundsOf, boxEdges, trianglesOf, vec } from './solids.js';

/** A colour as the diagrams tint what light passes through. */
function glassy(color) {
    return color.map((c, k) => 0.45 * c + 0.55 * [0.45, 0.72, 0.92][k]);
}

function perspective(fovY, aspect, near, far) {
    const f = 1 / Math.tan(fovY / 2);
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0];
}

function lookingAt(eye, target, up) {
    const z = vec.unit(vec.sub(eye, target));
    const x = vec.unit(vec.cross(up, z));
    const y = vec.cross(z, x);
    return [
        x[0],
        y[0],
        z[0],
        0,
        x[1],
        y[1],
        z[1],
        0,
        x[2],
        y[2],
        z[2],
        0,
        -vec.dot(x, eye),
        -vec.dot(y, eye),
        -vec.dot(z, eye),
        1,
    ];
}

function productOf(a, b) {
    const out = new Float32Array(16);
    for (let c = 0; c < 4; c += 1) {
        for (let r = 0; r < 4; r += 1) {
            for (let k = 0; k < 4; k += 1) out[c * 4 + r] += a[k * 4 + r] * b[c * 4 + k];
        }
    }
    return out;
}

/** The view. `onNode(index)` hears which ray was clicked. Without WebGL2 `isThere` is false. */
export class View3d {
    constructor(host, { onNode, picture }) {
        this.host = host;
        this.onNode = onNode;
        this.picture = picture;
        this.canvas = make('canvas', { tabindex: 0, role: 'application', 'aria-roledescription': '3D view' });
        this.gl = this.canvas.getContext('webgl2', { antialias: true, alpha: false });
        this.isThere = Boolean(this.gl);
        if (!this.isThere) return;
        this.labels = make('div', { 'aria-hidden': 'true' });
        host.append(this.canvas, this.labels, this.bar());
        this.prepare();
        this.listen();
        new ResizeObserver(() => this.redraw()).observe(host);
        this.canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
        this.canvas.addEventListener('webglcontextrestored', () => {
            this.prepare();
            if (this.description) this.setScene(this.description, this.geometry);
        });
    }

    bar() {
        const button = (text, label, run, isWide) => {
            const about = {
                type: 'button',
                title: label,
                'aria-label': isWide ? undefined : label,
                class: isWide ? 'wide-button' : '',
                text,
            };
            return make('button', { ...about, on: { click: run } });
        };
        this.showsBoxes = true;
        const boxes = button(
            'Boxes',
            'Boxes of the hierarchy that this ray visited',
            () => {
                this.showsBoxes = !this.showsBoxes;
                boxes.setAttribute('aria-pressed', String(this.showsBoxes));
                this.show(this.step, this.node, this.isGrowing);
            },
            true,
        );
        boxes.setAttribute('aria-pressed', 'true');
        const eye = button('From the eye', 'Look from the eye of the scene', () => this.lookFromEye(), true);
        const reset = button('Reset', 'The whole scene (0)', () => this.reset(), true);
        return make(
            'div',
            { class: 'space-bar' },
            boxes,
            eye,
            reset,
            button('\u2212', 'Farther (\u2212)', () => this.zoom(1.2)),
            button('+', 'Nearer (+)', () => this.zoom(1 / 1.2)),
        );
    }

    prepare() {
        const { gl } = this;
        const compiled = (vertex, fragment) => {
            const program = gl.createProgram();
            for (const [type, source] of [
                [gl.VERTEX_SHADER, vertex],
                [gl.FRAGMENT_SHADER, fragment],
            ]) {
                const shader = gl.createShader(type);
                gl.shaderSource(shader, source);
                gl.compileShader(shader);
                gl.attachShader(program, shader);
            }
            gl.linkProgram(program);
            const at = (name) => gl.getUniformLocation(program, name);
            return { program, at };
        };
        this.solidProgram = compiled(SOLID_VERTEX, SOLID_FRAGMENT);
        this.lineProgram = compiled(LINE_VERTEX, LINE_FRAGMENT);
        this.plateProgram = compiled(SOLID_VERTEX, PLATE_FRAGMENT);
        this.lineArray = gl.createVertexArray();
        gl.bindVertexArray(this.lineArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]), gl.STATIC_DRAW);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
        this.lineBuffer = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, this.lineBuffer);
        [
            [1, 3, 0],
            [2, 3, 12],
            [3, 4, 24],
            [4, 2, 40],
        ].forEach(([place, count, offset]) => {
            gl.enableVertexAttribArray(place);
            gl.vertexAttribPointer(place, count, gl.FLOAT, false, 48, offset);
            gl.vertexAttribDivisor(place, 1);
        });
        this.solids = [];
        this.texture = gl.createTexture();
    }

    arrayOf(data) {
        const { gl } = this;
        const array = gl.createVertexArray();
        const buffer = gl.createBuffer();
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
        for (const [place, offset] of [
            [0, 0],
            [1, 12],
        ]) {
            gl.enableVertexAttribArray(place);
            gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, offset);
        }
        return { array, buffer, count: data.length / 6 };
    }

    /** Takes a scene and its shapes. The view stays where it is if the scene has the same file. */
    setScene(description, geometry) {
        if (!this.isThere) return;
        const isOther = this.description?.file !== description.file;
        Object.assign(this, { description, geometry });
        const { gl } = this;
        for (const solid of this.solids) {
            gl.deleteBuffer(solid.buffer);
            gl.deleteVertexArray(solid.array);
        }
        const [min, max] = boundsOf(description);
        this.middle = vec.times(vec.add(min, max), 0.5);
        this.radius = Math.max(1e-6, vec.length(vec.sub(max, min)) / 2);
        const { eye, forward, corners } = description.camera;
        this.far = Math.max(this.radius, vec.length(vec.sub(eye, this.middle)));
        const materials = readSpans(description.text)?.value?.materials ?? {};
        const shown = (linear) => srgbBytes(linear).map((c) => c / 255);
        this.solids = geometry.objects.map((shape, i) => {
            const checker = materials[description.objects[i]?.material]?.checker;
            const isPlane = shape.kind === 'plane';
            const reach = this.far * 1.6;
            return {
                ...this.arrayOf(trianglesOf(shape, this.middle, reach)),
                color: shape.transparent ? [...glassy(shown(shape.color)), 0.26] : [...shown(shape.color), 1],
                second: checker ? shown(checker.colors[1]) : [0, 0, 0],
                checkerSize: checker?.size ?? 0,
                fadeFrom: isPlane ? reach : 0,
            };
        });
        this.plateAway = Math.min(0.35 * vec.length(vec.sub(eye, this.middle)) || 1, this.radius * 1.2);
        this.plateCorners = corners.map((corner) => vec.add(eye, vec.times(vec.sub(corner, eye), this.plateAway)));
        const at = [
            [0, 0, 0],
            [1, 0, 0],
            [1, 1, 0],
            [0, 1, 0],
        ];
        const plate = [0, 1, 2, 0, 2, 3].flatMap((i) => [...this.plateCorners[i], ...at[i]]);
        if (this.plate) gl.deleteVertexArray(this.plate.array);
        this.plate = this.arrayOf(new Float32Array(plate));
        this.forward = forward;
        if (isOther) this.reset();
        this.pictureChanged();
    }

    /** The picture on the image plane has changed. */
    pictureChanged() {
        if (!this.isThere || !this.description) return;
        const { gl } = this;
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, this.picture);
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        this.redraw();
    }

    /** Shows everything from the side and a little above. */
    reset() {
        const { eye, right } = this.description.camera;
        const toEye = vec.sub(eye, this.middle);
        this.target = vec.add(this.middle, vec.times(toEye, 0.3));
        const away = vec.unit(vec.add(vec.add(vec.times(right, 1), vec.times(vec.unit(toEye), 0.75)), [0, 0.55, 0]));
        this.yaw = Math.atan2(away[0], away[2]);
        this.pitch = Math.asin(Math.max(-1, Math.min(1, away[1])));
        this.distance = 1.35 * Math.max(vec.length(toEye), this.radius * 1.4);
        this.redraw();
    }

    lookFromEye() {
        const { eye, forward } = this.description.camera;
        this.distance = Math.max(vec.dot(vec.sub(this.middle, eye), forward), this.radius * 0.2);
        this.target = vec.add(eye, vec.times(forward, this.distance));
        this.yaw = Math.atan2(-forward[0], -forward[2]);
        this.pitch = Math.asin(Math.max(-1, Math.min(1, -forward[1])));
        this.distance *= 1.02;
        this.redraw();
    }

    zoom(by) {
        this.distance = Math.max(this.radius * 0.02, Math.min(this.far * 12, this.distance * by));
        this.redraw();
    }

    orbit(x, y) {
        this.yaw -= x;
        this.pitch = Math.max(-1.5, Math.min(1.5, this.pitch + y));
        this.redraw();
    }

    pan(x, y) {
        const { right, up } = this.axes();
        const scale = this.distance * 0.9;
        this.target = vec.add(this.target, vec.add(vec.times(right, -x * scale), vec.times(up, y * scale)));
        this.redraw();
    }

    axes() {
        const back = [
            Math.cos(this.pitch) * Math.sin(this.yaw),
            Math.sin(this.pitch),
            Math.cos(this.pitch) * Math.cos(this.yaw),
        ];
        const right = vec.unit(vec.cross([0, 1, 0], back));
        return { back, right, up: vec.cross(back, right) };
    }

    listen() {
        const down = new Map();
        let moved = 0;
        this.canvas.addEventListener('pointerdown', (event) => {
            this.canvas.setPointerCapture(event.pointerId);
            down.set(event.pointerId, [event.clientX, event.clientY]);
            if (down.size === 1) moved = 0;
        });
        this.canvas.addEventListener('pointermove', (event) => {
            const before = down.get(event.pointerId);
            if (!before) return;
            const now = [event.clientX, event.clientY];
            const [x, y] = [now[0] - before[0], now[1] - before[1]];
            moved += Math.abs(x) + Math.abs(y);
            const height = this.canvas.clientHeight;
            if (down.size === 2) {
                const other = [...down].find(([id]) => id !== event.pointerId)[1];
                const gap = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
                this.zoom(gap(before) / Math.max(1, gap(now)));
                this.pan(x / height / 2, y / height / 2);
            } else if (event.shiftKey || event.buttons & 6) {
                this.pan(x / height, y / height);
            } else {
                this.orbit((x / height) * 4, (y / height) * 4);
            }
            down.set(event.pointerId, now);
        });
        for (const name of ['pointerup', 'pointercancel']) {
            this.canvas.addEventListener(name, (event) => {
                if (down.delete(event.pointerId) && moved < 5 && name === 'pointerup') this.pick(event);
            });
        }
        this.canvas.addEventListener('contextmenu', (event) => event.preventDefault());
        this.canvas.addEventListener(
            'wheel',
            (event) => {
                event.preventDefault();
                this.zoom(Math.exp(event.deltaY * 0.001));
            },
            { passive: false },
        );
        this.canvas.addEventListener('keydown', (event) => this.pressed(event));
    }

    pressed(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const move = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (move && event.shiftKey) this.pan(move[0] * 0.05, move[1] * 0.05);
        else if (move) this.orbit(-move[0] * 0.12, move[1] * 0.12);
        else if (event.key === '+' || event.key === '=') this.zoom(1 / 1.15);
        else if (event.key === '-') this.zoom(1.15);
        else if (event.key === '0') this.reset();
        else return;
        event.preventDefault();
        event.stopPropagation();
    }

    setPlayer(player) {
        this.player = player;
    }

    /** Shows the rays up to a step, or all. */
    show(step, node, isGrowing) {
        Object.assign(this, { step, node, isGrowing });
        if (!this.isThere || !this.description || !this.player || this.host.hidden) return;
        this.lines = [];
        this.rays = [];
        this.addCamera();
        let shown = 0;
        const endless = this.far * 3;
        this.player.nodes.forEach(({ ray, index }) => {
            if (isGrowing && !this.player.isReached(index, step)) return;
            if (ray.outcome === 'max_depth' || ray.outcome === 'below_min_weight' || ray.outcome === 'ray_budget') return;
            shown += 1;
            const isDecided = !isGrowing || this.player.isDecided(index, step);
            const scale = 1 / (vec.length(ray.direction) || 1);
            const end = ray.t_max ?? endless * scale;
            const t = Math.min(
                isDecided ? (ray.hit?.t ?? end) : (this.player.bestSoFar(index, step) ?? end),
                endless * scale * 4,
            );
            const to = vec.add(ray.origin, vec.times(ray.direction, t));
            const isChosen = index === node;
            const color = rgbOfHex(cssColor(ray.kind));
            const alpha = isChosen ? 1 : 0.75;
            const width = isChosen ? 3.6 : 2;
            this.rays.push({ index, from: ray.origin, to });
            this.line(ray.origin, to, [...color, alpha], width, KINDS.indexOf(ray.kind));
            if (t < endless * scale) this.arrow(ray.origin, to, [...color, alpha], width);
        });
        if (this.showsBoxes) this.addBoxes();
        const tests = this.player.nodes[node].ray.tests?.length ?? 0;
        const objects = counted(this.description.objects.length, 'object');
        const words =
            `${objects}, ${shown} of ${counted(this.player.nodes.length, 'ray')} shown, ` +
            `${counted(tests, 'test')} of the chosen ray. Arrow keys turn, with Shift move, plus and minus zoom, 0 shows all.`;
        this.canvas.setAttribute('aria-label', `The scene in three dimensions: ${words}`);
        this.redraw();
    }

    line(from, to, color, width, dash = 0) {
        this.lines.push(...from, ...to, ...color, width * devicePixelRatio, dash);
    }

    /** A head in the middle of a ray, so that its way shows from everywhere. */
    arrow(from, to, color, width) {
        const along = vec.sub(to, from);
        const length = vec.length(along);
        const size = Math.min(length * 0.12, this.radius * 0.05);
        const tip = vec.add(from, vec.times(along, 0.55));
        const unit = vec.unit(along);
        const side = vec.unit(vec.cross(unit, Math.abs(unit[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
        const base = vec.sub(tip, vec.times(unit, size));
        for (const way of [0.45, -0.45]) this.line(vec.add(base, vec.times(side, size * way)), tip, color, width);
    }

    addCamera() {
        const { eye } = this.description.camera;
        const ink = [...rgbOfHex(cssColor('axis')), 0.9];
        this.plateCorners.forEach((corner, i) => {
            this.line(eye, corner, ink, 1);
            this.line(corner, this.plateCorners[(i + 1) % 4], ink, 1.4);
        });
        const amber = [...rgbOfHex(cssColor('shadow')), 1];
        for (const { position } of this.description.lights) {
            if (!position) continue;
            const size = this.radius * 0.06;
            for (const way of [
                [1, 0, 0],
                [0, 1, 0],
                [0, 0, 1],
            ]) {
                this.line(vec.sub(position, vec.times(way, size)), vec.add(position, vec.times(way, size)), amber, 2);
            }
        }
    }

    addBoxes() {
        const { ray, index } = this.player.nodes[this.node];
        const { step } = this;
        const entered = rgbOfHex(cssColor('purple'));
        const passed = rgbOfHex(cssColor('axis'));
        const current = this.player.steps[step].node === index ? this.player.steps[step].test : undefined;
        const places = this.player.testSteps[index];
        (ray.tests ?? []).forEach(({ bounds }, test) => {
            if (!bounds || (this.isGrowing && !(places.get(test)?.[0] <= step))) return;
            const isCurrent = test === current;
            const isIn = bounds.verdict === 'entered';
            const color = isIn ? [...entered, isCurrent ? 1 : 0.55] : [...passed, isCurrent ? 1 : 0.35];
            for (const [a, b] of boxEdges(bounds.min, bounds.max)) this.line(a, b, color, isCurrent ? 2.4 : 1);
        });
    }

    redraw() {
        if (!this.isThere || !this.description || !this.lines || this.host.hidden) return;
        cancelAnimationFrame(this.frame);
        this.frame = requestAnimationFrame(() => this.draw());
    }

    draw() {
        const { gl, canvas } = this;
        const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) =>
            Math.max(1, Math.round(x * devicePixelRatio)),
        );
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
        const { back } = this.axes();
        const eye = vec.add(this.target, vec.times(back, this.distance));
        const reach = this.distance + this.far * 12;
        const toEye = lookingAt(eye, this.target, [0, 1, 0]);
        this.toClip = productOf(perspective(0.7, width / height, Math.max(this.distance * 0.01, reach * 1e-5), reach), toEye);
        gl.viewport(0, 0, width, height);
        gl.clearColor(...rgbOfHex(cssColor('background')), 1);
        gl.depthMask(true);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        this.drawSolids(eye, (solid) => solid.color[3] === 1 && !solid.fadeFrom);
        this.drawPlate();
        gl.depthMask(false);
        this.drawSolids(eye, (solid) => solid.fadeFrom > 0);
        // Glass before the rays: they are what one wants to see inside it.
        this.drawSolids(eye, (solid) => solid.color[3] < 1 && !solid.fadeFrom);
        gl.bindVertexArray(this.lineArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.lineBuffer);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(this.lines), gl.DYNAMIC_DRAW);
        gl.depthFunc(gl.GREATER);
        this.drawLines(width, height, 0.22);
        gl.depthFunc(gl.LEQUAL);
        this.drawLines(width, height, 1);
        gl.depthMask(true);
        this.placeLabels(width, height);
    }

    drawSolids(eye, which) {
        const { gl } = this;
        const { program, at } = this.solidProgram;
        gl.useProgram(program);
        gl.uniformMatrix4fv(at('toClip'), false, this.toClip);
        gl.uniform3fv(at('eye'), eye);
        gl.uniform3fv(at('middle'), this.middle);
        for (const solid of this.solids.filter(which)) {
            gl.uniform4fv(at('color'), solid.color);
            gl.uniform3fv(at('second'), solid.second);
            gl.uniform1f(at('checkerSize'), solid.checkerSize);
            gl.uniform1f(at('fadeFrom'), solid.fadeFrom);
            gl.bindVertexArray(solid.array);
            gl.drawArrays(gl.TRIANGLES, 0, solid.count);
        }
    }

    drawPlate() {
        const { gl } = this;
        const { program, at } = this.plateProgram;
        gl.useProgram(program);
        gl.uniformMatrix4fv(at('toClip'), false, this.toClip);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.bindVertexArray(this.plate.array);
        gl.drawArrays(gl.TRIANGLES, 0, this.plate.count);
    }

    drawLines(width, height, strength) {
        const { gl } = this;
        const { program, at } = this.lineProgram;
        gl.useProgram(program);
        gl.uniformMatrix4fv(at('toClip'), false, this.toClip);
        gl.uniform2f(at('size'), width, height);
        gl.uniform1f(at('strength'), strength);
        const patterns = KINDS.flatMap((kind) => [0, 1, 2, 3].map((i) => DASHES[kind][i] ?? 0));
        gl.uniform4fv(at('dashes'), patterns);
        gl.bindVertexArray(this.lineArray);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.lines.length / 12);
    }

    /** Where a point is on the canvas, in CSS pixels; nothing behind the view. */
    onScreen(p) {
        const m = this.toClip;
        const clip = [0, 1, 2, 3].map((r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
        if (clip[3] < 1e-3) return undefined;
        return [
            (clip[0] / clip[3] + 1) * 0.5 * this.canvas.clientWidth,
            (1 - clip[1] / clip[3]) * 0.5 * this.canvas.clientHeight,
        ];
    }

    placeLabels() {
        const { camera, lights } = this.description;
        const wanted = [
            ['eye', camera.eye],
            ...lights.filter((light) => light.position).map((light) => [light.name, light.position]),
        ];
        while (this.labels.children.length > wanted.length) this.labels.lastChild.remove();
        while (this.labels.children.length < wanted.length) this.labels.append(make('span', { class: 'space-label' }));
        wanted.forEach(([text, place], i) => {
            const label = this.labels.children[i];
            const at = this.onScreen(place);
            if (label.textContent !== text) label.textContent = text;
            label.hidden = !at;
            if (at) label.style.transform = `translate(${Math.round(at[0] + 7)}px, ${Math.round(at[1] - 18)}px)`;
        });
    }

    /** Chooses the ray nearest to a click. */
    pick(event) {
        const box = this.canvas.getBoundingClientRect();
        const [x, y] = [event.clientX - box.left, event.clientY - box.top];
        let best = { away: 9 };
        for (const { index, from, to } of this.rays ?? []) {
            const [a, b] = [this.onScreen(from), this.onScreen(to)];
            if (!a || !b) continue;
            const along = [b[0] - a[0], b[1] - a[1]];
            const length = along[0] ** 2 + along[1] ** 2 || 1;
            const s = Math.max(0, Math.min(1, ((x - a[0]) * along[0] + (y - a[1]) * along[1]) / length));
            const away = Math.hypot(a[0] + s * along[0] - x, a[1] + s * along[1] - y);
            if (away < best.away) best = { away, index };
        }
        if (best.index !== undefined) this.onNode(best.index);
    }
}
