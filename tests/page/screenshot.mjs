// The screenshots of the README: `node screenshot.mjs` writes docs/inspector/inspector-light.png and inspector-dark.png.

import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { browse, openPage, root, serve, shows } from './support.mjs';

const folder = join(root, 'docs', 'inspector');
await mkdir(folder, { recursive: true });
const browser = await browse();
const server = await serve('scenes/whitted.json');
try {
    for (const colorScheme of ['light', 'dark']) {
        const page = await openPage(browser, `${server.address}#pixel=395,205`, {
            colorScheme,
            viewport: { width: 1440, height: 900 },
        });
        await page.waitForFunction(() => window.rendered);
        // A ray inside the glass ball, at the test that it hits.
        await shows(page, () =>
            page
                .getByRole('treeitem', { name: /^refracted/ })
                .first()
                .click(),
        );
        await page.click('#view-3d');
        await page.waitForSelector('#space canvas');
        await page.waitForTimeout(600);
        await page.screenshot({ path: join(folder, `inspector-${colorScheme}.png`) });
        await page.context().close();
    }
} finally {
    server.stop();
    await browser.close();
}
