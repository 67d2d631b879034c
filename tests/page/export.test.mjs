// The exported page: one file that opens without server and network.

import assert from 'node:assert/strict';
import { mkdtemp, rm, stat } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { browse, openPage, run, serve, shows, stepShown, stepsInAll } from './support.mjs';

let browser;
let folder;

before(async () => {
    browser = await browse();
    folder = await mkdtemp(join(tmpdir(), 'raytree-page-'));
});

after(async () => {
    await browser?.close();
    await rm(folder, { recursive: true });
});

/** Opens a file with the network off, and holds that nothing is missed. */
async function offline(file, hash, work) {
    const page = await openPage(browser, pathToFileURL(file).href + hash, { offline: true });
    const asked = [];
    page.on('request', (request) => asked.push(request.url()));
    try {
        await work(page);
        assert.deepEqual(page.problems, []);
        assert.deepEqual(
            asked.filter((url) => !url.startsWith('data:') && !url.startsWith('blob:')),
            [],
        );
    } finally {
        await page.context().close();
    }
}

describe('an exported page', () => {
    test('from the button, opened without a network, steps to the end and back', async () => {
        const server = await serve('scenes/whitted.json');
        const file = join(folder, 'button.html');
        let recorded;
        try {
            const page = await openPage(browser, `${server.address}#pixel=100,100`);
            recorded = await stepsInAll(page);
            const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export')]);
            assert.match(download.suggestedFilename(), /\.html$/);
            await download.saveAs(file);
            assert.deepEqual(page.problems, []);
            await page.context().close();
        } finally {
            server.stop();
        }
        assert.ok((await stat(file)).size > 100_000);
        await offline(file, '#pixel=100,100', async (page) => {
            assert.match(await page.textContent('#pixel-words'), /100,100/);
            assert.equal(await stepsInAll(page), recorded);
        });
        await offline(file, '', async (page) => {
            assert.match(await page.textContent('#pixel-words'), /388,190 \u201cglass edge\u201d/);
            await page.waitForFunction(() => window.rendered);
            await shows(page, () => page.keyboard.press('g'));
            const count = await stepsInAll(page);
            for (let step = 2; step <= count; step += 1) await page.keyboard.press('s');
            assert.equal(await stepShown(page), count);
            for (let step = 2; step <= count; step += 1) await page.keyboard.press('b');
            assert.equal(await stepShown(page), 1);
            for (const id of ['view-section', 'view-tree', 'view-ledger', 'view-surface']) {
                await shows(page, () => page.click(`#${id}`).then(() => page.keyboard.press('s')));
                assert.ok((await page.locator('#diagram svg').count()) === 1, id);
            }
            assert.ok((await page.locator('#diagram svg path[transform][d]').count()) > 5, 'letters are drawn');
            await page.click('#view-3d');
            await page.waitForSelector('#space canvas');
            await page.selectOption('#overlay', 'tests');
            await page.waitForFunction(() => /tests/.test(document.getElementById('legend').textContent));
            await shows(page, () => page.selectOption('#named-pixels', { label: 'shadow edge' }));
            assert.match(await page.textContent('#pixel-words'), /519,340/);
            await page.keyboard.press('1');
            await shows(page, () => page.keyboard.press('ArrowUp'));
            assert.match(await page.textContent('#pixel-words'), /\u201cmirrored/);
            assert.ok(!(await page.isVisible('#tab-whatif')));
            assert.ok(!(await page.isVisible('#export')));
            await page.keyboard.press('d');
            await page.click('#view-section');
            await page.waitForSelector('#diagram svg');
            await page.keyboard.press('p');
            await page.keyboard.press('g');
            for (let i = 0; i < 40 && !(await page.isVisible('#question')); i += 1) await page.keyboard.press('s');
            await page.keyboard.press('1');
            assert.match(await page.textContent('#score'), /of 1 right/);
        });
    });

    test('from the command, with a mesh', async () => {
        const file = join(folder, 'mesh.html');
        await run('inspect', 'scenes/mesh.json', '--export', file, '--pixel', '300,200');
        await offline(file, '', async (page) => {
            assert.match(await page.textContent('#pixel-words'), /300,200/);
            await shows(page, () => page.keyboard.press('e'));
            assert.equal(await stepShown(page), await stepsInAll(page));
        });
    });
});
