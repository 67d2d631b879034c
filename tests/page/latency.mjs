// How long the page takes, in a real browser: from a click on a pixel to tree, arithmetic and diagram on the screen, a step, and
// the first complete picture, from opening the address. Prints a table. `node latency.mjs [CLICKS [WORD]]`: only scenes with that word in their name;
// RAYTREE names the program.

import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { cpus, platform, tmpdir, totalmem } from 'node:os';
import { join } from 'node:path';
import { browse, openPage, program, root, serve } from './support.mjs';

const clicks = Number(process.argv[2] ?? 30);
const word = process.argv[3] ?? '';

/** A torus with bumps of at least 70,000 triangles, and a scene around it. */
async function writeLargeMesh(folder) {
    const [across, around] = [300, 118];
    const lines = [];
    for (let i = 0; i < across; i += 1) {
        for (let j = 0; j < around; j += 1) {
            const [u, v] = [(i / across) * 2 * Math.PI, (j / around) * 2 * Math.PI];
            const r = 0.4 + 0.03 * Math.sin(14 * u) * Math.sin(9 * v);
            lines.push(
                `v ${(1 + r * Math.cos(v)) * Math.cos(u)} ${r * Math.sin(v) + 0.6} ${(1 + r * Math.cos(v)) * Math.sin(u)}`,
            );
        }
    }
    for (let i = 0; i < across; i += 1) {
        for (let j = 0; j < around; j += 1) {
            const at = (a, b) => (a % across) * around + (b % around) + 1;
            lines.push(
                `f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j)}`,
                `f ${at(i + 1, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)}`,
            );
        }
    }
    await writeFile(join(folder, 'torus.obj'), `${lines.join('\n')}\n`);
    const scene = {
        image: { width: 640, height: 480 },
        camera: { eye: [0, 2.4, 4], look_at: [0, 0.5, 0], up: [0, 1, 0], fov_y_degrees: 40 },
        background: [0.2, 0.4, 0.7],
        max_depth: 5,
        lights: [{ name: 'lamp', point: { position: [-3, 6, 4], color: [1, 1, 1] } }],
        materials: {
            shiny: { color: [0.8, 0.5, 0.2], ambient: 0.1, diffuse: 0.6, reflection: 0.4 },
            floor: { color: [0.7, 0.7, 0.7], ambient: 0.2, diffuse: 0.8 },
        },
        objects: [
            { name: 'torus', material: 'shiny', shape: { mesh: { file: 'torus.obj' } } },
            { name: 'floor', material: 'floor', shape: { plane: { normal: [0, 1, 0], distance: 0 } } },
        ],
    };
    const file = join(folder, 'torus-70000.json');
    await writeFile(file, JSON.stringify(scene));
    return file;
}

/** The share `p` of the sorted numbers. */
function quantile(numbers, p) {
    const sorted = [...numbers].sort((a, b) => a - b);
    return sorted[Math.min(sorted.length - 1, Math.ceil(p * sorted.length) - 1)];
}

/** Clicks on pixels all over the picture: milliseconds from the pointer's event to the frame after everything is on the page. */
async function measureClicks(page, count) {
    return page.evaluate(async (wanted) => {
        const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        const stage = document.getElementById('stage');
        stage.setPointerCapture = () => {};
        const times = [];
        for (let i = 0; i < wanted; i += 1) {
            const box = document.getElementById('render').getBoundingClientRect();
            // A sequence that fills the square evenly.
            const [u, v] = [(0.5 + i * 0.7548776662466927) % 1, (0.5 + i * 0.5698402909980532) % 1];
            const at = {
                clientX: box.left + box.width * u,
                clientY: box.top + box.height * v,
                button: 0,
                bubbles: true,
                pointerId: 1,
            };
            // A person takes longer between two clicks than the page needs to fetch what the next step will want.
            await new Promise((done) => setTimeout(done, 150));
            await nextFrame();
            const shown = new Promise((done) => document.addEventListener('raytree-shown', done, { once: true }));
            const start = performance.now();
            stage.dispatchEvent(new PointerEvent('pointerdown', at));
            stage.dispatchEvent(new PointerEvent('pointerup', at));
            await shown;
            await nextFrame();
            times.push(performance.now() - start);
        }
        return times;
    }, count);
}

/** Steps with the keyboard's key: milliseconds of script and layout, and until the frame after the diagram is there. */
async function measureSteps(page, count) {
    return page.evaluate(async (wanted) => {
        const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        const press = (key) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
        press('g');
        await new Promise((done) => setTimeout(done, 300));
        const [work, all] = [[], []];
        for (let i = 0; i < wanted; i += 1) {
            await nextFrame();
            // A person takes longer between two steps than the page needs to fetch the next diagram.
            await new Promise((done) => setTimeout(done, 60));
            const shown = new Promise((done) => document.addEventListener('raytree-shown', done, { once: true }));
            const start = performance.now();
            press('s');
            document.body.getBoundingClientRect();
            work.push(performance.now() - start);
            await Promise.race([shown, new Promise((done) => setTimeout(done, 500))]);
            all.push(performance.now() - start);
        }
        return { work, all };
    }, count);
}

/** One line of the table. */
function print(row) {
    const number = (x, width, digits = 1) => x.toFixed(digits).padStart(width);
    console.log(
        `${row.scene.padEnd(38)} ${row.pixels.padStart(9)} ${number(row.picture, 9, 0)} ${number(row.median, 10)} ` +
            `${number(row.p95, 10)} ${number(row.ratio, 9, 2)} ${number(row.step, 9)} ${number(row.stepShown, 13)}`,
    );
}

const machine = `${cpus()[0].model.trim()}, ${cpus().length} cores, ${Math.round(totalmem() / 2 ** 30)} GiB, ${platform()}`;
console.log(
    `${program.includes('release') ? 'release' : 'debug'} build, headless Chromium without a graphics card, ${machine}`,
);
console.log(
    `${clicks} clicks a scene; milliseconds; the limit is 50 a click (100 for the mesh of 70,000 triangles), 16 a step`,
);
console.log(
    'scene                                     pixels   picture  click p50  click p95  of limit  step p95  with diagram',
);

const folder = await mkdtemp(join(tmpdir(), 'raytree-latency-'));
const browser = await browse({ webgl: false });
const rows = [];
try {
    const scenes = (await readdir(join(root, 'scenes')))
        .filter((name) => name.endsWith('.json') && !name.includes('schema'))
        .sort();
    const files = [...scenes.map((name) => join('scenes', name)), await writeLargeMesh(folder)].filter((file) =>
        file.includes(word),
    );
    for (const file of files) {
        const server = await serve(file);
        try {
            const page = await openPage(browser, server.address);
            await page.waitForFunction(() => window.rendered, null, { timeout: 60000 });
            const picture = await page.evaluate(() => window.rendered);
            const { width, height } = JSON.parse(
                await readFile(file.startsWith('scenes') ? join(root, file) : file, 'utf8'),
            ).image;
            await measureClicks(page, 5);
            const times = await measureClicks(page, clicks);
            const steps = await measureSteps(page, 40);
            const limit = file.includes('70000') ? 100 : 50;
            const row = {
                scene: file.split('/').pop(),
                pixels: `${width}x${height}`,
                picture,
                median: quantile(times, 0.5),
                p95: quantile(times, 0.95),
                ratio: quantile(times, 0.95) / limit,
                step: quantile(steps.work, 0.95),
                stepShown: quantile(steps.all, 0.95),
            };
            rows.push(row);
            print(row);
            await page.context().close();
        } finally {
            server.stop();
        }
    }
} finally {
    await browser.close();
    await rm(folder, { recursive: true });
}

const worst = rows.filter((row) => row.ratio > 1 || row.step > 16);
if (worst.length) console.log(`over the limit: ${worst.map((row) => row.scene).join(', ')}`);
