// The page of `raytree inspect`, driven as a person would: by mouse, and by keyboard alone.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, describe, test } from 'node:test';
import { browse, openPage, program, run, serve, shows, stepShown, stepsInAll } from './support.mjs';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

let browser;
let server;

before(async () => {
    assert.ok(program, 'build raytree first');
    browser = await browse();
    server = await serve('scenes/whitted.json');
});

after(async () => {
    await browser?.close();
    server?.stop();
});

/** Opens a page, runs, and holds that nothing went wrong in the console. */
async function onPage(work, options, address = server.address) {
    const page = await openPage(browser, address, options);
    try {
        await work(page);
        assert.deepEqual(
            page.problems.filter((problem) => !page.expected?.some((words) => problem.includes(words))),
            [],
        );
    } finally {
        await page.context().close();
    }
}

/** Clicks the middle of a pixel of a 640 x 480 picture. */
async function clickPixel(page, x, y) {
    const box = await page.locator('#render').boundingBox();
    await shows(page, () => page.mouse.click(box.x + ((x + 0.5) / 640) * box.width, box.y + ((y + 0.5) / 480) * box.height));
}

async function serious(page) {
    if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document));
    const found = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
    return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`);
}

describe('by mouse', () => {
    test('a click chooses a pixel, and every pane shows it', () =>
        onPage(async (page) => {
            await clickPixel(page, 519, 340);
            assert.match(await page.textContent('#pixel-words'), /519,340 \u201cshadow edge\u201d/);
            assert.equal(await page.inputValue('#named-pixels'), '519,340');
            assert.ok((await page.locator('[role=treeitem]').count()) >= 1);
            assert.ok((await page.locator('#arithmetic math').count()) > 3);
            assert.match(await page.getAttribute('#diagram svg', 'aria-label'), /\w{4}/);
            assert.ok((await page.locator('#code-lines .current').count()) === 1);
            assert.ok((await page.locator('#stack .frame').count()) >= 2);
            await page.waitForFunction(() => location.hash.includes('pixel=519,340'));
        }));

    test('dragging chooses the pixel under the pointer at last', () =>
        onPage(async (page) => {
            const box = await page.locator('#render').boundingBox();
            await page.mouse.move(box.x + 20, box.y + 20);
            await page.mouse.down();
            await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 12 });
            await page.mouse.up();
            await page.waitForFunction(() => /pixel=3(19|20),2(39|40)&/.test(location.hash));
        }));

    test('a ray of the tree, a test, a frame of the stack lead to their step', () =>
        onPage(async (page) => {
            await shows(page, () =>
                page
                    .getByRole('treeitem', { name: /^reflected, background/ })
                    .first()
                    .click(),
            );
            assert.match(await page.textContent('#stack .top-frame'), /Intersect|Trace/);
            await shows(page, () => page.locator('#tests-list .long-row').nth(1).click());
            assert.match(await page.textContent('#arithmetic .headline'), /^Test 2 of/);
            await shows(page, () => page.locator('#stack .frame button').last().click());
            assert.match(await page.textContent('#stack .top-frame'), /RayTrace/);
        }));

    test('the slider, the named pixels and the overlays', () =>
        onPage(async (page) => {
            await shows(page, () => page.locator('#slider').fill('40'));
            assert.equal(await stepShown(page), 41);
            await shows(page, () => page.selectOption('#named-pixels', { label: 'mirrored floor' }));
            assert.match(await page.textContent('#pixel-words'), /415,245/);
            for (const [kind, words] of [
                ['rays', /rays/],
                ['depth', /levels/],
                ['tests', /tests/],
                ['stage', /filter/],
                ['time', /\u00b5s/],
            ]) {
                await page.selectOption('#overlay', kind);
                await page.waitForFunction(
                    (source) => new RegExp(source).test(document.getElementById('legend').textContent),
                    words.source,
                );
            }
            await page.selectOption('#overlay', '');
            assert.match(await page.textContent('#legend'), /^Click/);
        }));

    test('the view in three dimensions shows more rays with every step', () =>
        onPage(async (page) => {
            await page.click('#view-3d');
            await page.waitForSelector('#space canvas');
            const count = async () => Number(/(\d+) of/.exec(await page.getAttribute('#space canvas', 'aria-label'))[1]);
            await shows(page, () => page.click('#go-start'));
            const few = await count();
            await shows(page, () => page.click('#go-end'));
            assert.ok((await count()) > few);
            const box = await page.locator('#space canvas').boundingBox();
            await page.mouse.move(box.x + 100, box.y + 100);
            await page.mouse.down();
            await page.mouse.move(box.x + 160, box.y + 120, { steps: 4 });
            await page.mouse.up();
            await page.mouse.wheel(0, -200);
            const painted = await page.evaluate(
                () =>
                    new Promise((done) =>
                        requestAnimationFrame(() =>
                            requestAnimationFrame(() => {
                                const canvas = document.querySelector('#space canvas');
                                const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
                                createImageBitmap(canvas).then((bitmap) => {
                                    copy.drawImage(bitmap, 0, 0);
                                    done(
                                        new Set(
                                            new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer),
                                        ).size,
                                    );
                                });
                            }),
                        ),
                    ),
            );
            assert.ok(painted > 0);
        }));

    test('the section grows with the steps', () =>
        onPage(async (page) => {
            await page.click('#view-section');
            await shows(page, () => page.click('#go-end'));
            const seen = () =>
                page
                    .locator('#diagram [data-node]')
                    .evaluateAll(
                        (all) =>
                            new Set(
                                all
                                    .filter((part) => getComputedStyle(part).visibility !== 'hidden')
                                    .map((part) => part.dataset.node),
                            ).size,
                    );
            const all = await seen();
            assert.ok(all > 3, `${all} rays have parts of their own`);
            await shows(page, () => page.click('#go-start'));
            assert.ok((await seen()) < all);
            await page.uncheck('#growing');
            assert.equal(await seen(), all);
        }));

    test('what if: a knob, the difference, undo and redo', () =>
        onPage(async (page) => {
            await page.click('#tab-whatif');
            await shows(page, () => page.locator('#knob-ior').fill('1.2'));
            await page.waitForSelector('.outcome li');
            assert.match(await page.textContent('.summary'), /\d+ differences/);
            assert.match(await page.textContent('.outcome'), /root hit\.ior: \(1, 1\.5\) \u2192 \(1, 1\.2\)/);
            await page.click('#tab-text');
            assert.match(await page.inputValue('#scene-area'), /"ior": 1\.2,/);
            await shows(page, () => page.getByRole('button', { name: 'Undo' }).click());
            assert.match(await page.inputValue('#scene-area'), /"ior": 1\.5,/);
            await shows(page, () => page.getByRole('button', { name: 'Redo' }).click());
            assert.match(await page.inputValue('#scene-area'), /"ior": 1\.2,/);
            await page.click('#tab-whatif');
            await shows(page, () => page.selectOption('#knob-precision', 'f32'));
            assert.match(await page.textContent('#settings'), /in f32/);
            await shows(page, () => page.locator('#knob-max_depth').fill('1'));
            assert.match(await page.textContent('#settings'), /max_depth 1/);
            await shows(page, () => page.locator('#knob-light-x').fill('2'));
            await shows(page, () => page.locator('#knob-object-y').fill('1'));
            await page.click('#tab-text');
            assert.match(await page.inputValue('#scene-area'), /"position": \[2, 7, 5\]/);
            assert.match(await page.inputValue('#scene-area'), /"center": \[-0\.25, 1, 1\.2\]/);
            await shows(page, () => page.getByRole('button', { name: 'Original' }).click());
            assert.match(await page.inputValue('#scene-area'), /"position": \[-3, 7, 5\]/);
            assert.match(await page.textContent('#settings'), /f64, max_depth 5/);
        }));
});

describe('by keyboard alone', () => {
    test('a pixel, the tree, all steps to the end and back', () =>
        onPage(async (page) => {
            await page.keyboard.press('1');
            await shows(page, () => page.keyboard.press('ArrowRight'));
            assert.match(await page.textContent('#pixel-words'), /389,190/);
            await shows(page, () => page.keyboard.press('Shift+ArrowDown'));
            assert.match(await page.textContent('#pixel-words'), /389,200/);
            await page.keyboard.press('3');
            const chosen = () => page.locator('#tree-list .chosen').getAttribute('title');
            await shows(page, () => page.keyboard.press('Home'));
            assert.match(await chosen(), /^camera ray, hits/);
            await shows(page, () => page.keyboard.press('ArrowDown'));
            assert.match(await chosen(), /^(reflected|refracted|shadow) ray/);
            await shows(page, () => page.keyboard.press('Home'));
            const rows = await page.locator('#tree-list [role=treeitem]').count();
            await page.keyboard.press('ArrowLeft');
            assert.equal(await page.locator('#tree-list [role=treeitem]').count(), 1);
            await page.keyboard.press('ArrowRight');
            assert.equal(await page.locator('#tree-list [role=treeitem]').count(), rows);
            await shows(page, () => page.keyboard.press('g'));
            assert.equal(await stepShown(page), 1);
            const count = await stepsInAll(page);
            for (let step = 2; step <= count; step += 1) {
                await page.keyboard.press('s');
                assert.equal(await stepShown(page), step);
            }
            for (let step = count - 1; step >= 1; step -= 1) await page.keyboard.press('b');
            assert.equal(await stepShown(page), 1);
            await page.keyboard.press('e');
            assert.equal(await stepShown(page), count);
            await page.keyboard.press('s');
            assert.equal(await stepShown(page), count);
        }));

    test('over and out keep the stack', () =>
        onPage(async (page) => {
            const frames = () => page.locator('#stack .frame').count();
            await shows(page, () => page.keyboard.press('g'));
            await page.keyboard.press('s');
            await page.keyboard.press('n');
            assert.equal(await frames(), 1);
            await page.keyboard.press('s');
            await page.keyboard.press('s');
            await page.keyboard.press('s');
            assert.equal(await frames(), 3);
            await page.keyboard.press('o');
            assert.equal(await frames(), 2);
        }));

    test('run to total internal reflection', async () => {
        const other = await serve('scenes/total-internal-reflection.json');
        try {
            await onPage(
                async (page) => {
                    await shows(page, () => page.keyboard.press('g'));
                    await page.keyboard.press('u');
                    await page.keyboard.type('total');
                    await shows(page, () => page.keyboard.press('Tab').then(() => page.keyboard.press('Enter')));
                    assert.match(await page.textContent('#status'), /total/i);
                    const at = await stepShown(page);
                    await page.keyboard.press('r');
                    await page.waitForFunction(() => /No later step/.test(document.getElementById('status').textContent));
                    assert.equal(await stepShown(page), at);
                },
                {},
                `${other.address}#pixel=367,300`,
            );
        } finally {
            other.stop();
        }
    });

    test('the scene is edited, broken, mended, undone', () =>
        onPage(async (page) => {
            page.expected = ['422'];
            await page.keyboard.press('6');
            await page.keyboard.press('Shift+Tab');
            await page.keyboard.press('Shift+Tab');
            for (let i = 0; i < 6 && (await page.evaluate(() => document.activeElement.id)) !== 'tab-arithmetic'; i += 1)
                await page.keyboard.press('Shift+Tab');
            await page.keyboard.press('End');
            assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-text');
            for (let i = 0; i < 6 && (await page.evaluate(() => document.activeElement.id)) !== 'scene-area'; i += 1)
                await page.keyboard.press('Tab');
            await page.keyboard.press('Control+Home');
            await page.evaluate(() => {
                const area = document.getElementById('scene-area');
                const at = area.value.indexOf('"ior": 1.5') + 7;
                area.setSelectionRange(at, at + 3);
            });
            await shows(page, () => page.keyboard.type('1.3'));
            await page.keyboard.press('ArrowRight');
            await page.keyboard.press('ArrowLeft');
            await page.keyboard.press('Backspace');
            await page.keyboard.press('Backspace');
            await page.keyboard.press('Backspace');
            await page.keyboard.type('"glass"');
            await page.waitForSelector('.problem.bad');
            assert.match(await page.textContent('#scene-problem'), /line \d+, column \d+/);
            assert.equal(await page.textContent('.editor mark'), '"glass"');
            assert.equal(await page.getAttribute('#scene-area', 'aria-invalid'), 'true');
            await shows(page, async () => {
                for (let i = 0; i < 7; i += 1) await page.keyboard.press('Backspace');
                await page.keyboard.type('1.4');
            });
            await page.waitForSelector('.problem:not(.bad)');
            assert.equal(await page.locator('.editor mark').count(), 0);
            for (let i = 0; i < 8; i += 1) {
                await page.keyboard.press('Control+z');
                await page.waitForTimeout(60);
            }
            await page.waitForFunction(() => document.getElementById('scene-area').value.includes('"ior": 1.5'));
            await page.waitForFunction(() => /as given/.test(document.querySelector('#scene-text .count').textContent));
        }));

    test('predict, then reveal, with a score', () =>
        onPage(async (page) => {
            await shows(page, () => page.keyboard.press('g'));
            await page.keyboard.press('p');
            let asked = 0;
            for (let i = 0; i < 60 && asked < 3; i += 1) {
                const before = await stepShown(page);
                await page.keyboard.press('s');
                if (!(await page.isVisible('#question'))) continue;
                asked += 1;
                assert.equal(await stepShown(page), before, 'the step is not shown before the answer');
                await page.keyboard.press('1');
                assert.equal(await stepShown(page), before + 1);
                assert.match(await page.textContent('#score'), new RegExp(`^\\d of ${asked} right$`));
                await page.keyboard.press('Escape');
            }
            assert.equal(asked, 3);
        }));

    test('help, theme, a large pane', () =>
        onPage(async (page) => {
            await page.keyboard.press('?');
            assert.ok(await page.isVisible('#help[open]'));
            await page.keyboard.press('Escape');
            assert.ok(!(await page.isVisible('#help[open]')));
            await page.keyboard.press('5');
            await page.keyboard.press('x');
            assert.equal(await page.locator('#view.large').count(), 1);
            await page.keyboard.press('Escape');
            assert.equal(await page.locator('.large').count(), 0);
            const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
            const first = await theme();
            await page.keyboard.press('d');
            assert.notEqual(await theme(), first);
        }));
});

describe('what holds everywhere', () => {
    for (const colorScheme of ['light', 'dark']) {
        test(`axe finds nothing serious, ${colorScheme}`, () =>
            onPage(
                async (page) => {
                    const found = [];
                    const look = async (where) =>
                        found.push(...(await serious(page)).map((violation) => `${where}: ${violation}`));
                    await look('first');
                    for (const id of ['view-section', 'view-tree', 'view-ledger', 'view-3d', 'tab-whatif', 'tab-text']) {
                        await page.click(`#${id}`);
                        await page.waitForTimeout(150);
                        await look(id);
                    }
                    await page.keyboard.press('Escape');
                    await page.focus('#slider');
                    await page.keyboard.press('g');
                    await page.keyboard.press('p');
                    for (let i = 0; i < 40 && !(await page.isVisible('#question')); i += 1) await page.keyboard.press('s');
                    await look('question');
                    await page.keyboard.press('1');
                    await look('answer');
                    await page.keyboard.press('Escape');
                    await page.click('#help-open');
                    await look('help');
                    assert.deepEqual(found, []);
                },
                { colorScheme },
            ));
    }

    test('the address reopens pixel, ray and step', () =>
        onPage(async (page) => {
            await clickPixel(page, 395, 205);
            await shows(page, () => page.locator('#slider').fill('99'));
            await page.waitForFunction(() => location.hash.endsWith('step=100'));
            const address = page.url();
            await onPage(
                async (again) => {
                    assert.equal(await stepShown(again), 100);
                    assert.equal(await again.textContent('#stack'), await page.textContent('#stack'));
                    assert.match(await again.textContent('#pixel-words'), /395,205/);
                },
                {},
                address,
            );
            await page.goBack();
            await page.waitForFunction(() => /388,190/.test(document.getElementById('pixel-words').textContent));
        }));

    test('reduced motion is respected', () =>
        onPage(
            async (page) => {
                const durations = await page.evaluate(() => {
                    const all = [...document.querySelectorAll('*')].map((element) => getComputedStyle(element));
                    return all.filter((style) => style.transitionDuration !== '0s' || style.animationName !== 'none').length;
                });
                assert.equal(durations, 0);
            },
            { reducedMotion: 'reduce' },
        ));

    test('nothing sticks out, from a tablet to a large screen', async () => {
        for (const viewport of [
            { width: 1024, height: 768 },
            { width: 1280, height: 720 },
            { width: 1920, height: 1080 },
        ]) {
            await onPage(
                async (page) => {
                    const wide = await page.evaluate(() => [
                        document.documentElement.scrollWidth,
                        document.querySelector('main').scrollWidth,
                    ]);
                    assert.ok(
                        wide.every((width) => width <= viewport.width),
                        `${wide}`,
                    );
                    const boxes = await page
                        .locator('.pane')
                        .evaluateAll((panes) => panes.map((pane) => pane.getBoundingClientRect().toJSON()));
                    for (const [i, a] of boxes.entries()) {
                        for (const b of boxes.slice(i + 1)) {
                            const apart =
                                a.right <= b.left + 0.5 ||
                                b.right <= a.left + 0.5 ||
                                a.bottom <= b.top + 0.5 ||
                                b.bottom <= a.top + 0.5;
                            assert.ok(apart, `panes overlap at ${viewport.width} x ${viewport.height}`);
                        }
                    }
                },
                { viewport },
            );
        }
    });

    test('the panes stay where they are while one steps', () =>
        onPage(async (page) => {
            const places = () =>
                page
                    .locator('.pane, .player')
                    .evaluateAll((all) => all.map((e) => Object.values(e.getBoundingClientRect().toJSON()).join()).join('\n'));
            await page.keyboard.press('g');
            const first = await places();
            for (let i = 0; i < 60; i += 1) {
                await page.keyboard.press('s');
                assert.equal(await places(), first);
            }
        }));

    test('without WebGL2 the section takes the place of the view in three dimensions', () =>
        onPage(async (page) => {
            await page.evaluate(() => {
                HTMLCanvasElement.prototype.getContext = ((old) =>
                    function context(kind, ...rest) {
                        return kind === 'webgl2' ? null : old.call(this, kind, ...rest);
                    })(HTMLCanvasElement.prototype.getContext);
            });
            await page.click('#view-3d');
            await page.waitForFunction(() => document.getElementById('view-section').getAttribute('aria-selected') === 'true');
            await page.waitForSelector('#diagram svg');
        }));

    test('the steps are those of raytree step', async () => {
        const recording = JSON.parse(await run('step', 'scenes/whitted.json', 'glass edge', '--json'));
        await onPage(async (page) => {
            const fetched = await page.evaluate(async () => {
                const scene = await (await fetch('/api/scene')).json();
                return (await fetch(`/api/scenes/${scene.id}/recording?x=388&y=190`)).json();
            });
            assert.deepEqual(fetched, recording);
            assert.equal(await stepsInAll(page), recording.steps.length);
            await shows(page, () => page.keyboard.press('g'));
            for (const [k, step] of recording.steps.entries()) {
                if (k) await page.keyboard.press('s');
                const told = await page.evaluate(() => [
                    [...document.querySelectorAll('#code-lines li')].findIndex((line) => line.classList.contains('current')),
                    document.querySelector('#arithmetic .verdict span:last-child')?.textContent,
                    document.querySelector('#tree-list .chosen').dataset.node,
                ]);
                assert.deepEqual(told, [step.line, step.verdict?.words, String(step.node)], `step ${k + 1}`);
            }
        });
    });
});
