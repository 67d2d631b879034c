// Everything the current ray was tested against: what was accepted, what was rejected, and why.

import { byId, LongList, make, setText } from './dom.js';
import { brief, counted } from './format.js';

const SIGNS_OF = {
    entered: ['\u2193', '', 'entered'],
    best: ['\u2713', 'good', 'best so far'],
    rejected: ['\u2715', 'bad', 'rejected'],
};

/** What a test was of, in words. */
export function testName(test) {
    const about = test.bounds ?? test.shape;
    const part = about.primitive === undefined ? '' : `, triangle ${about.primitive}`;
    const object = about.object === undefined ? '' : `${about.object}${part}`;
    if (test.shape) return object || `shape ${about.shape}`;
    const node = about.node === undefined ? 'box' : `box ${about.node}`;
    return object ? `${node} around ${object}` : node;
}

/** The pane. `onTest(node, test)` hears which test is chosen. */
export class TestsPane {
    constructor({ onTest }) {
        this.onTest = onTest;
        this.host = byId('tests-list');
        this.count = byId('tests-count');
        this.rows = [];
        this.list = new LongList(this.host, 24, (element, i) => this.draw(element, i));
        this.host.addEventListener('click', (event) => {
            const row = event.target.closest('.long-row');
            if (row) this.onTest(this.node, Number(row.dataset.test));
        });
        this.host.addEventListener('keydown', (event) => this.pressed(event));
        this.onlyShapes = byId('tests-shapes');
        this.onlyShapes.addEventListener('change', () => {
            this.node = -1;
            this.show(this.shown.step, this.shown.node, this.shown.hidesLater);
        });
    }

    setPlayer(player) {
        this.player = player;
        this.node = -1;
    }

    /** Shows the tests of a node up to a step. */
    show(step, node, hidesLater) {
        this.shown = { step, node, hidesLater };
        const tests = this.player.nodes[node].ray.tests ?? [];
        const decided = this.player.testSteps[node];
        const current = this.player.steps[step].node === node ? this.player.steps[step].test : undefined;
        let reached = -1;
        for (const [test, places] of decided) if (places[0] <= step && test > reached) reached = test;
        const isSame = this.node === node && this.tests === tests && this.hid === hidesLater && !hidesLater;
        Object.assign(this, { node, tests, current, reached, hid: hidesLater });
        if (!isSame) {
            this.rows = [];
            tests.forEach((test, i) => {
                if (this.onlyShapes.checked && !test.shape) return;
                if (hidesLater && i > reached) return;
                this.rows.push(i);
            });
            this.places = new Map(this.rows.map((test, row) => [test, row]));
            const shapes = tests.filter((test) => test.shape).length;
            const told = `${counted(tests.length - shapes, 'box', 'boxes')}, ${counted(shapes, 'shape')}`;
            setText(this.count, hidesLater ? '' : told);
            this.list.show(this.rows.length);
        }
        this.list.reveal(this.places.get(current) ?? -1);
        this.list.refresh();
        const row = this.places.get(current);
        if (row === undefined) this.host.removeAttribute('aria-activedescendant');
        else this.host.setAttribute('aria-activedescendant', `test-${current}`);
    }

    draw(element, row) {
        const i = this.rows[row];
        const test = this.tests[i];
        if (test === undefined) return;
        const about = test.bounds ?? test.shape;
        const isLater = i > this.reached;
        if (!element.parts) {
            element.parts = {
                sign: make('span', { 'aria-hidden': 'true' }),
                name: make('span', { class: 'fill' }),
                why: make('span', { class: 'number why' }),
                t: make('span', { class: 'number' }),
                more: make('span', { class: 'unseen' }),
            };
            element.setAttribute('role', 'option');
            element.append(...Object.values(element.parts));
        }
        element.dataset.test = i;
        element.id = `test-${i}`;
        element.className = `long-row${i === this.current ? ' chosen' : ''}${isLater ? ' later' : ''}`;
        element.setAttribute('aria-selected', String(i === this.current));
        element.setAttribute('aria-posinset', row + 1);
        element.setAttribute('aria-setsize', this.rows.length);
        const [sign, tone, word] = SIGNS_OF[about.verdict];
        const { parts } = element;
        parts.sign.className = `sign ${isLater ? '' : tone}`;
        setText(parts.sign, sign);
        setText(parts.name, testName(test));
        setText(parts.why, about.reason ?? (about.verdict === 'best' ? 'best so far' : ''));
        const t = test.shape ? about.t : about.t_in;
        setText(parts.t, t === undefined || about.reason === 't_in > t_out' ? '' : `t ${brief(t, 4)}`);
        element.title = `${testName(test)}: ${about.reason ?? word}`;
        setText(parts.more, about.reason ? 'rejected' : about.verdict === 'best' ? '' : word);
    }

    pressed(event) {
        if (event.ctrlKey || event.metaKey || event.altKey || !this.rows.length) return;
        const row = this.places.get(this.current) ?? (event.key === 'ArrowUp' ? this.rows.length : -1);
        const last = this.rows.length - 1;
        const page = Math.max(1, Math.floor(this.list.viewHeight / 24) - 1);
        const to = { ArrowDown: row + 1, ArrowUp: row - 1, Home: 0, End: last, PageDown: row + page, PageUp: row - page }[
            event.key
        ];
        if (to === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        this.onTest(this.node, this.rows[Math.max(0, Math.min(last, to))]);
    }
}
