// Where data comes from: the server of `raytree inspect`, or an exported page's own data. Both have the same methods.

/** What a server said instead of an answer. */
export class ApiProblem extends Error {
    constructor(status, about) {
        super(about.problem?.message ?? about.why ?? `answer ${status}`);
        this.status = status;
        this.problem = about.problem;
    }
}

async function answered(response) {
    if (response.ok) return response;
    let about = {};
    try {
        about = await response.json();
    } catch {
        about = {};
    }
    throw new ApiProblem(response.status, about);
}

function query(parts) {
    return new URLSearchParams(Object.entries(parts).filter(([, value]) => value !== undefined)).toString();
}

/** Bytes of a stream as records: u32le y, u32le rows, then `rowBytes` a row. */
async function readRows(response, rowBytes, onRows) {
    const reader = response.body.getReader();
    let kept = new Uint8Array(0);
    for (;;) {
        const { done, value } = await reader.read();
        if (done) return;
        const bytes = new Uint8Array(kept.length + value.length);
        bytes.set(kept);
        bytes.set(value, kept.length);
        const view = new DataView(bytes.buffer);
        let at = 0;
        while (bytes.length - at >= 8) {
            const y = view.getUint32(at, true);
            const rows = view.getUint32(at + 4, true);
            const end = at + 8 + rows * rowBytes;
            if (bytes.length < end) break;
            onRows(y, rows, bytes.slice(at + 8, end));
            at = end;
        }
        kept = bytes.subarray(at);
    }
}

/** The server. */
class ServerApi {
    canTrace = true;

    async scene() {
        return (await answered(await fetch('/api/scene'))).json();
    }

    async trace(text, settings, signal) {
        const headers = { 'Content-Type': 'application/json', 'X-Raytree': '1' };
        const body = JSON.stringify({ text, settings });
        return (await answered(await fetch('/api/scenes', { method: 'POST', headers, body, signal }))).json();
    }

    async geometry(id) {
        return (await answered(await fetch(`/api/scenes/${id}/geometry`))).json();
    }

    async render(scene, onRows, signal) {
        const response = await answered(await fetch(`/api/scenes/${scene.id}/render`, { signal }));
        await readRows(response, scene.image.width * 4, onRows);
    }

    async overlay(scene, kind, onRows, signal) {
        const response = await answered(await fetch(`/api/scenes/${scene.id}/overlay?kind=${kind}`, { signal }));
        await readRows(response, scene.image.width * 4, (y, rows, bytes) => onRows(y, rows, new Float32Array(bytes.buffer)));
    }

    async recording(id, x, y, signal) {
        return (await answered(await fetch(`/api/scenes/${id}/recording?${query({ x, y })}`, { signal }))).json();
    }

    async diagram(id, x, y, about, signal) {
        return (await answered(await fetch(`/api/scenes/${id}/diagram?${query({ x, y, ...about })}`, { signal }))).text();
    }

    /** A diagram and what it is of: for the kind `verdict` that of the test that decides. */
    async diagramAndKind(id, x, y, wish) {
        const response = await answered(await fetch(`/api/scenes/${id}/diagram?${query({ x, y, ...wish })}`));
        const shown = new URLSearchParams(response.headers.get('x-raytree-diagram') ?? '');
        const about = { kind: shown.get('kind') ?? wish.kind, node: wish.node };
        for (const name of ['shape', 'primitive']) if (shown.has(name)) about[name] = Number(shown.get(name));
        return { about: { ...about, theme: wish.theme }, svg: await response.text() };
    }

    async difference(id, from, x, y, signal) {
        return (await answered(await fetch(`/api/scenes/${id}/difference?${query({ x, y, from })}`, { signal }))).json();
    }

    exportAddress(id, pixels) {
        return `/api/scenes/${id}/export?${pixels.map(([x, y]) => `pixel=${x},${y}`).join('&')}`;
    }

    keepsPixel() {
        return true;
    }
}

function bytesOf(base64) {
    return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}

async function unpacked(block) {
    const stream = new Blob([bytesOf(block)]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The data inside an exported page. */
class KeptApi {
    canTrace = false;

    constructor(kept) {
        this.kept = kept;
        this.blocks = new Map(kept.pixels.map(({ x, y, block }) => [`${x},${y}`, block]));
        this.opened = new Map();
    }

    async scene() {
        return this.kept.scene;
    }

    async geometry() {
        return this.kept.geometry;
    }

    async render(scene, onRows) {
        const image = new Image();
        image.src = this.kept.render;
        await image.decode();
        const { width, height } = scene.image;
        const canvas = new OffscreenCanvas(width, height);
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        onRows(0, height, new Uint8Array(context.getImageData(0, 0, width, height).data.buffer));
    }

    async overlay(scene, kind, onRows) {
        const block = this.kept.overlays?.[kind];
        if (!block) throw new ApiProblem(404, { why: 'This overlay is not kept in this page.' });
        onRows(0, scene.image.height, new Float32Array((await unpacked(block)).buffer));
    }

    async pixel(x, y) {
        const key = `${x},${y}`;
        if (!this.opened.has(key)) {
            const block = this.blocks.get(key);
            if (!block) throw new ApiProblem(404, { why: 'This pixel is not kept in this page.' });
            if (this.opened.size > 20) this.opened.delete(this.opened.keys().next().value);
            this.opened.set(
                key,
                unpacked(block).then((bytes) => JSON.parse(new TextDecoder().decode(bytes))),
            );
        }
        return this.opened.get(key);
    }

    async recording(id, x, y) {
        return (await this.pixel(x, y)).recording;
    }

    async diagram(id, x, y, about) {
        const { diagrams } = await this.pixel(x, y);
        const svg = diagrams?.[query(about)];
        if (!svg) throw new ApiProblem(404, { why: 'This diagram is not kept in this page.' });
        // The outlines of letters are kept once for all drawings.
        this.glyphs ??= unpacked(this.kept.glyphs).then((bytes) => JSON.parse(new TextDecoder().decode(bytes)));
        const glyphs = await this.glyphs;
        return svg.replace(/<path id="([^"]+)"\/>/g, (whole, name) =>
            glyphs[name] ? `<path id="${name}" d="${glyphs[name]}"/>` : whole,
        );
    }

    keepsPixel(x, y) {
        return this.blocks.has(`${x},${y}`);
    }

    /** The kept pixel to go to from one pixel for a wish: the nearest, of an arrow key's that lie its way. */
    nearestKept([x, y], from, isArrow) {
        const [dx, dy] = isArrow ? [x - from[0], y - from[1]] : [0, 0];
        const along = ([a, b]) => (a - from[0]) * Math.sign(dx) + (b - from[1]) * Math.sign(dy);
        const beside = ([a, b]) => Math.abs((a - from[0]) * Math.sign(dy)) + Math.abs((b - from[1]) * Math.sign(dx));
        const away = (pixel) => (isArrow ? along(pixel) + 2 * beside(pixel) : Math.hypot(pixel[0] - x, pixel[1] - y));
        const all = this.pixels().filter((pixel) => !isArrow || along(pixel) > 0);
        return all.reduce((best, pixel) => (away(pixel) < away(best) ? pixel : best), all[0] ?? from);
    }

    /** The kept pixels as `[x, y]`. */
    pixels() {
        return this.kept.pixels.map(({ x, y }) => [x, y]);
    }
}

/** The server, or what is kept in the page. */
export function openApi() {
    const kept = document.getElementById('recordings');
    return kept ? new KeptApi(JSON.parse(kept.textContent)) : new ServerApi();
}
