// Starts the real program and a real browser.

import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

/** The repository. */
export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');

const target = process.env.CARGO_TARGET_DIR ?? join(root, 'target');

/** The program: `RAYTREE`, else what was built last in release, else in debug. */
export const program =
    process.env.RAYTREE ?? ['release', 'debug'].map((kind) => join(target, kind, 'raytree')).find(existsSync);

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';

const FLAGS = [
    '--headless',
    '--no-sandbox',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
];

/** WebGL2 without a graphics card; everything else is then drawn that way too, which is slow. */
const SOFTWARE_WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Runs the program to its end; resolves with what it printed. */
export function run(...args) {
    return new Promise((resolve, reject) => {
        const child = spawn(program, args, { cwd: root });
        const out = [];
        const errors = [];
        child.stdout.on('data', (data) => out.push(data));
        child.stderr.on('data', (data) => errors.push(data));
        child.on('error', reject);
        child.on('close', (code) => {
            if (code === 0) resolve(Buffer.concat(out).toString());
            else reject(new Error(`raytree ${args.join(' ')} ended with ${code}: ${Buffer.concat(errors)}`));
        });
    });
}

/** Serves a scene; resolves with the address and a way to stop. */
export function serve(scene, ...more) {
    return new Promise((resolve, reject) => {
        const child = spawn(program, ['inspect', scene, ...more], { cwd: root, stdio: ['ignore', 'pipe', 'pipe'] });
        let said = '';
        const look = (data) => {
            said += data;
            const address = /http:\/\/\S+/.exec(said)?.[0];
            if (address && said.includes('\n')) resolve({ address, stop: () => child.kill() });
        };
        child.stdout.on('data', look);
        child.stderr.on('data', look);
        child.on('error', reject);
        child.on('exit', (code) => reject(new Error(`raytree inspect ended with ${code}: ${said}`)));
    });
}

/** A browser; with WebGL2, or without, as if there were no graphics card. */
export function browse({ webgl = true } = {}) {
    return chromium.launch({ executablePath: CHROMIUM, args: [...FLAGS, ...(webgl ? SOFTWARE_WEBGL : ['--disable-gpu'])] });
}

/** A page that keeps every error it meets in `page.problems`. */
export async function openPage(browser, address, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
    const page = await context.newPage();
    page.problems = [];
    page.on('console', (message) => {
        if (message.type() === 'error' || message.type() === 'warning')
            page.problems.push(`${message.text()} (${message.location().url})`);
    });
    page.on('pageerror', (error) => page.problems.push(String(error)));
    await page.addInitScript(() => {
        window.shown = [];
        document.addEventListener('raytree-shown', (event) => window.shown.push(event.detail));
        // Milliseconds from opening the address to the frame that shows the whole picture.
        const isRendered = () => (window.rendered = performance.now());
        document.addEventListener('raytree-rendered', () => requestAnimationFrame(() => setTimeout(isRendered)));
    });
    await page.goto(address);
    await page.waitForFunction(() => window.shown.length > 0);
    return page;
}

/** Waits until the page shows what `change` led to. */
export async function shows(page, change) {
    const before = await page.evaluate(() => window.shown.length);
    await change();
    await page.waitForFunction((count) => window.shown.length > count, before);
}

/** The step that the page says it shows, from 1. */
export async function stepShown(page) {
    return Number(/step (\d+)/.exec(await page.textContent('#step-count'))[1]);
}

/** How many steps there are. */
export async function stepsInAll(page) {
    return Number(/of (\d+)/.exec(await page.textContent('#step-count'))[1]);
}
