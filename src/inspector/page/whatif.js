// What if: knobs and the scene's text, both of which change one text; undo; and the difference that a change makes.

import { byId, make, setText, whenQuiet, wireTabs } from './dom.js';
import { brief, colorText, counted } from './format.js';
import { partAt, readSpans, withValue } from './json-edit.js';
import { cssOfLinear } from './palette.js';
import { boundsOf, vec } from './solids.js';

/** Where a shape stands: paths of vectors that move together, or of one number. */
function placesOf(shape) {
    if (shape?.sphere) return [['sphere', 'center']];
    if (shape?.box)
        return [
            ['box', 'min'],
            ['box', 'max'],
        ];
    if (shape?.triangle) return [0, 1, 2].map((i) => ['triangle', 'vertices', i]);
    if (shape?.mesh) return [['mesh', 'transform', 'translate']];
    return [];
}

/** The panels. `onChange({ text, settings })` traces anew and resolves with the problem, if there is one. */
export class WhatIf {
    constructor({ onChange, onNode, canTrace }) {
        this.onChange = onChange;
        this.onNode = onNode;
        this.canTrace = canTrace;
        this.tab = wireTabs(byId('numbers-tabs'), (tab) => {
            byId('digits-label').hidden = tab.id !== 'tab-arithmetic';
        });
        this.picked = {};
        this.makeBars();
        this.makeKnobs();
        this.makeEditor();
        if (!canTrace) byId('tab-whatif').hidden = true;
    }

    /** Begins with a scene as it was given. */
    start(scene) {
        this.first = { text: scene.text, settings: {} };
        this.firstId = scene.id;
        this.history = [this.first];
        this.at = 0;
        this.setScene(scene);
        this.showHistory();
        this.showDifference();
    }

    /** A scene has been traced. */
    setScene(scene) {
        this.scene = scene;
        this.spans = readSpans(scene.text);
        if (this.area.value !== scene.text && this.now.text === scene.text) this.area.value = scene.text;
        this.showProblem();
        this.fillKnobs();
    }

    get now() {
        return this.history[this.at];
    }

    get isChanged() {
        return this.at > 0 && (this.now.text !== this.first.text || Object.keys(this.now.settings).length > 0);
    }

    makeBars() {
        const button = (text, run, title) => make('button', { type: 'button', text, title, on: { click: run } });
        this.undoButtons = [];
        this.redoButtons = [];
        this.firstButtons = [];
        this.changeWords = [];
        const bar = () => {
            const undo = button('Undo', () => this.travel(-1), 'Undo (Ctrl+Z)');
            const redo = button('Redo', () => this.travel(1), 'Redo (Ctrl+Shift+Z)');
            const first = button('Original', () => this.change(this.first, 'original'), 'The scene as it was given');
            const words = make('span', { class: 'count' });
            this.undoButtons.push(undo);
            this.redoButtons.push(redo);
            this.firstButtons.push(first);
            this.changeWords.push(words);
            return make('div', { class: 'change-bar' }, undo, redo, first, words);
        };
        const top = bar();
        this.summary = make('span', { class: 'summary', role: 'status' });
        top.append(make('span', { class: 'spring' }), this.summary);
        byId('whatif').append(top);
        if (this.canTrace) byId('scene-text').append(bar());
        for (const id of ['whatif', 'scene-text']) byId(id).addEventListener('keydown', (event) => this.pressed(event));
    }

    pressed(event) {
        if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
        const key = event.key.toLowerCase();
        if (key !== 'z' && key !== 'y') return;
        event.preventDefault();
        event.stopPropagation();
        this.travel(key === 'y' || event.shiftKey ? 1 : -1);
    }

    travel(by) {
        const to = this.at + by;
        if (to < 0 || to >= this.history.length) return;
        this.at = to;
        this.lastKind = undefined;
        this.area.value = this.now.text;
        this.showHistory();
        this.trace();
    }

    /** A change. Those of the same kind in quick succession are undone together. */
    change(next, kind) {
        const merges = kind === this.lastKind && kind !== 'original' && performance.now() - this.lastTime < 900 && this.at > 0;
        this.lastKind = kind;
        this.lastTime = performance.now();
        if (next.text === this.now.text && JSON.stringify(next.settings) === JSON.stringify(this.now.settings)) return;
        this.history.length = this.at + (merges ? 0 : 1);
        this.history.push(next);
        if (this.history.length > 200) this.history.splice(1, 1);
        this.at = this.history.length - 1;
        if (this.area.value !== next.text) this.area.value = next.text;
        this.showHistory();
        this.trace();
    }

    /** Traces what stands now; while that runs, only the newest change waits. */
    async trace() {
        if (this.isTracing) {
            this.isWaiting = true;
            return;
        }
        this.isTracing = true;
        do {
            this.isWaiting = false;
            const problem = await this.onChange(this.now);
            if (!this.isWaiting) this.showProblem(problem);
        } while (this.isWaiting);
        this.isTracing = false;
    }

    showHistory() {
        for (const button of this.undoButtons) button.disabled = this.at === 0;
        for (const button of this.redoButtons) button.disabled = this.at === this.history.length - 1;
        for (const button of this.firstButtons) button.disabled = !this.isChanged;
        for (const words of this.changeWords) setText(words, this.isChanged ? 'changed' : 'as given');
    }

    // Knobs

    makeKnobs() {
        const grid = make('div', { class: 'knobs' });
        this.rows = {};
        const pair = (key, label, sub, about, run) => {
            const range = make('input', { type: 'range', ...about, 'aria-label': `${label} ${sub}`.trim(), id: `knob-${key}` });
            const number = make('input', { type: 'number', step: 'any', 'aria-label': `${label} ${sub}, value`.trim() });
            range.addEventListener('input', () => {
                number.value = range.value;
                run(Number(range.value));
            });
            number.addEventListener('change', () => {
                if (number.value !== '' && Number.isFinite(Number(number.value))) run(Number(number.value));
            });
            this.rows[key] = { range, number };
            return [range, number];
        };
        const name = (text) => make('span', { class: 'knob-name', text });
        const select = (key, label, run) => {
            const element = make('select', {
                'aria-label': label,
                id: `knob-${key}`,
                on: { change: () => run(element.value) },
            });
            this.rows[key] = { select: element };
            return element;
        };
        const setting = (key, values) => {
            const element = select(key, key, (value) =>
                this.change({ ...this.now, settings: { ...this.now.settings, [key]: value } }, key),
            );
            element.append(...values.map((value) => make('option', { value, text: value })));
            return element;
        };
        const blank = () => make('span');
        grid.append(
            name('tracing'),
            make(
                'span',
                { class: 'whole' },
                make('label', {}, 'numerics ', setting('numerics', ['lecture', 'robust', 'certified'])),
                make('label', {}, 'precision ', setting('precision', ['f32', 'f64'])),
            ),
        );
        grid.append(
            name('max_depth'),
            blank(),
            ...pair('max_depth', 'max_depth', '', { min: 0, max: 12, step: 1 }, (value) => {
                const depth = Math.max(0, Math.min(64, Math.round(value)));
                this.change({ ...this.now, settings: { ...this.now.settings, max_depth: depth } }, 'max_depth');
            }),
        );
        grid.append(
            name('index of refraction'),
            select('material', 'Material', (value) => this.pickPart('material', value)),
        );
        grid.append(
            ...pair('ior', 'index of refraction', '', { min: 1, max: 3, step: 0.01 }, (value) => {
                this.edit(['materials', this.picked.material, 'ior'], Math.max(1e-3, value), 'ior');
            }),
        );
        for (const [key, label] of [
            ['light', 'light'],
            ['object', 'object'],
        ]) {
            const triple = make('div', { class: 'triple' });
            const pairs = ['x', 'y', 'z'].map((axis, k) =>
                pair(`${key}-${axis}`, label, axis, { min: -10, max: 10, step: 0.01 }, (value) => this.move(key, k, value)),
            );
            pairs.forEach(([, number], k) => triple.append(make('label', {}, 'xyz'[k], number)));
            pairs.forEach(([range]) => triple.append(range));
            grid.append(
                name(label),
                select(key, label, (value) => this.pickPart(key, value)),
                triple,
            );
        }
        this.outcome = make('div', { class: 'outcome' });
        byId('whatif').append(grid, this.outcome);
    }

    pickPart(key, value) {
        this.picked[key] = value;
        this.ranges = undefined;
        this.fillKnobs();
    }

    edit(path, value, kind) {
        this.change({ ...this.now, text: withValue(this.now.text, path, value) }, kind);
    }

    /** The paths of the vectors that a light or object stands at. */
    pathsOf(key) {
        if (key === 'light') {
            const i = Number(this.picked.light);
            const light = this.spans?.value?.lights?.[i];
            if (light?.point) return [['lights', i, 'point', 'position']];
            if (light?.directional?.direction) return [['lights', i, 'directional', 'direction']];
            return [];
        }
        const i = Number(this.picked.object);
        return placesOf(this.spans?.value?.objects?.[i]?.shape).map((path) => ['objects', i, 'shape', ...path]);
    }

    planePath() {
        const i = Number(this.picked.object);
        return this.spans?.value?.objects?.[i]?.shape?.plane ? ['objects', i, 'shape', 'plane', 'distance'] : undefined;
    }

    /** Moves a light or object along an axis, to where its first vector has this component. */
    move(key, k, value) {
        let { text } = this.now;
        const spans = readSpans(text);
        const plane = key === 'object' && this.planePath();
        if (plane) {
            text = withValue(text, plane, value);
        } else {
            const paths = this.pathsOf(key);
            if (!paths.length) return;
            const by = value - (partAt(spans, paths[0])?.value?.[k] ?? 0);
            for (const path of paths) {
                const vector = [...(partAt(spans, path)?.value ?? [0, 0, 0])];
                vector[k] = Number((vector[k] + by).toPrecision(12));
                if (path.includes('transform') && !partAt(spans, path.slice(0, -1))) {
                    text = withValue(text, path.slice(0, -1), { translate: vector });
                } else {
                    text = withValue(text, path, vector);
                }
            }
        }
        this.change({ ...this.now, text }, `${key}-${k}`);
    }

    fillKnobs() {
        const file = this.spans?.value;
        if (!file || !this.canTrace) return;
        const { settings } = this.scene;
        this.rows.numerics.select.value = settings.numerics;
        this.rows.precision.select.value = settings.precision;
        this.setPair('max_depth', settings.max_depth);
        const options = (key, entries) => {
            const { select } = this.rows[key];
            const wanted = JSON.stringify(entries);
            if (select.dataset.entries !== wanted) {
                select.dataset.entries = wanted;
                select.replaceChildren(...entries.map(([value, text]) => make('option', { value, text })));
            }
            if (!entries.some(([value]) => String(value) === this.picked[key]))
                this.picked[key] = String(entries[0]?.[0] ?? '');
            select.value = this.picked[key];
            select.disabled = entries.length === 0;
        };
        const materials = Object.entries(file.materials ?? {}).filter(([, material]) => material.ior !== undefined);
        options(
            'material',
            materials.map(([name]) => [name, name]),
        );
        options(
            'light',
            (file.lights ?? []).map((light, i) => [i, light.name ?? `light ${i}`]),
        );
        options(
            'object',
            (file.objects ?? []).map((object, i) => [i, object.name ?? `object ${i}`]),
        );
        this.setPair('ior', file.materials?.[this.picked.material]?.ior);
        if (!this.ranges) this.setRanges();
        for (const key of ['light', 'object']) {
            const plane = key === 'object' && this.planePath();
            const paths = this.pathsOf(key);
            const vector = paths.length ? (partAt(this.spans, paths[0])?.value ?? [0, 0, 0]) : [];
            ['x', 'y', 'z'].forEach((axis, k) => {
                this.setPair(`${key}-${axis}`, plane ? (k === 1 ? partAt(this.spans, plane)?.value : undefined) : vector[k]);
            });
        }
    }

    /** Sliders reach as far as the scene does around where a thing stands. */
    setRanges() {
        const [min, max] = boundsOf(this.scene);
        const size = Math.max(1e-3, vec.length(vec.sub(max, min)));
        const fine = 10 ** Math.floor(Math.log10(size / 200));
        const reach = 10 ** Math.ceil(Math.log10(size / 3));
        this.ranges = {};
        for (const key of ['light', 'object']) {
            const paths = this.pathsOf(key);
            const plane = key === 'object' && this.planePath();
            const at = plane
                ? Array(3).fill(partAt(this.spans, plane)?.value ?? 0)
                : (partAt(this.spans, paths[0] ?? ['none'])?.value ?? [0, 0, 0]);
            ['x', 'y', 'z'].forEach((axis, k) => {
                const { range } = this.rows[`${key}-${axis}`];
                range.step = fine;
                range.min = Number((Math.round((at[k] - reach) / fine) * fine).toPrecision(8));
                range.max = Number((Math.round((at[k] + reach) / fine) * fine).toPrecision(8));
            });
        }
    }

    setPair(key, value) {
        const { range, number } = this.rows[key];
        const isThere = typeof value === 'number';
        range.disabled = !isThere;
        number.disabled = !isThere;
        if (!isThere) {
            number.value = '';
            return;
        }
        if (document.activeElement !== range) range.value = value;
        if (document.activeElement !== number) number.value = Number(value.toPrecision(8));
    }

    // What a change does

    /** Shows the difference to the scene as it was given; `difference` is absent where nothing is changed. */
    showDifference(difference, player) {
        if (!this.canTrace) return;
        if (!difference) {
            this.summary.replaceChildren();
            const words = 'Change something: the pixel is traced anew, and how the two trees differ shows here.';
            this.outcome.replaceChildren(make('p', { class: 'quiet', text: words }));
            return;
        }
        const {
            colors: [before, after],
            divergences,
        } = difference;
        const patch = (color) => {
            const element = make('span', { class: 'patch', title: colorText(color) });
            element.style.background = cssOfLinear(color);
            return element;
        };
        const words = divergences.length === 0 ? 'the same tree' : counted(divergences.length, 'difference');
        this.summary.replaceChildren(
            patch(before),
            make('span', { text: '\u2192', 'aria-label': 'becomes' }),
            patch(after),
            make('span', { text: words }),
        );
        const most = Math.max(...after.map((c, k) => Math.abs(c - before[k])));
        const color =
            most === 0
                ? 'The colour stays the same.'
                : `The colour changes by ${brief(most, 3)} at most, to ${colorText(after)}.`;
        const listed = (all) => {
            const list = make('ul', {}, ...all.slice(0, 60).map((one) => this.divergence(one, player)));
            if (all.length > 60) list.append(make('li', { class: 'quiet', text: `and ${all.length - 60} more` }));
            return list;
        };
        const followers = divergences.filter((one) => one.consequence);
        this.outcome.replaceChildren(make('p', { text: color }), listed(divergences.filter((one) => !one.consequence)));
        if (!followers.length) return;
        const isOpen = this.showsFollowers;
        const rest = make(
            'details',
            { open: isOpen },
            make('summary', { text: `${followers.length} more that follow from these` }),
            listed(followers),
        );
        rest.addEventListener('toggle', () => (this.showsFollowers = rest.open));
        this.outcome.append(rest);
    }

    divergence({ path, kind, field, light, a, b }, player) {
        const index = player.byPath.get(path);
        const go = make('button', {
            type: 'button',
            text: path,
            title: `${kind} ray`,
            on: { click: () => this.onNode(index) },
        });
        go.disabled = index === undefined;
        const show = (value) => {
            if (value === undefined) return 'nothing';
            if (Array.isArray(value)) return `(${value.map((x) => brief(x, 4)).join(', ')})`;
            return typeof value === 'number' ? brief(value) : String(value);
        };
        const words = ` ${field.replaceAll('_', ' ')}${light ? ` of ${light}` : ''}: ${show(a)} \u2192 ${show(b)}`;
        return make('li', {}, go, words);
    }

    // The text

    makeEditor() {
        this.area = make('textarea', {
            spellcheck: 'false',
            autocapitalize: 'off',
            autocomplete: 'off',
            wrap: 'off',
            'aria-label': 'The text of the scene',
            'aria-describedby': 'scene-problem',
            id: 'scene-area',
            readonly: !this.canTrace,
        });
        this.shadow = make('pre', { 'aria-hidden': 'true' });
        this.problem = make('div', { class: 'problem', id: 'scene-problem', role: 'status' });
        byId('scene-text').append(make('div', { class: 'editor' }, this.shadow, this.area), this.problem);
        const typed = whenQuiet(180, () => this.change({ ...this.now, text: this.area.value }, 'text'));
        this.area.addEventListener('input', () => {
            this.underline();
            typed();
        });
        this.area.addEventListener('scroll', () => this.follow(), { passive: true });
        this.area.addEventListener('keydown', (event) => {
            // Tab leaves the editor, as everywhere; Escape has nothing to close.
            if (event.key !== 'Escape') event.stopPropagation();
            this.pressed(event);
        });
    }

    follow() {
        this.shadow.scrollTop = this.area.scrollTop;
        this.shadow.scrollLeft = this.area.scrollLeft;
    }

    /** Underlines a problem in its place; none: nothing. */
    underline(problem) {
        this.shadow.replaceChildren();
        if (problem?.line === undefined) return;
        const text = this.area.value;
        const lines = text.split('\n');
        let from = 0;
        for (let i = 0; i < problem.line - 1 && i < lines.length; i += 1) from += lines[i].length + 1;
        // Columns count characters, a string's length counts UTF-16.
        const line = [...(lines[problem.line - 1] ?? '')];
        const column = Math.max(0, (problem.column ?? 1) - 1);
        from += line.slice(0, column).join('').length;
        let to = Math.min(text.length, from + Math.max(1, problem.length ?? 1));
        if (text.slice(from, to).trim() === '' && from > 0) {
            from -= 1;
            to = from + 1;
        }
        this.problemAt = from;
        this.shadow.append(text.slice(0, from), make('mark', { text: text.slice(from, to) || ' ' }), text.slice(to) + '\n');
        this.follow();
    }

    showProblem(problem) {
        const isBad = problem !== undefined;
        this.problem.classList.toggle('bad', isBad);
        this.area.setAttribute('aria-invalid', String(isBad));
        byId('tab-text').classList.toggle('has-problem', isBad);
        this.underline(problem);
        if (!isBad) {
            const words = this.canTrace ? 'No problem found.' : 'Changes need raytree inspect, which traces anew.';
            this.problem.replaceChildren(make('span', { class: 'count', text: words }));
            return;
        }
        const place = problem.line === undefined ? '' : `line ${problem.line}, column ${problem.column}: `;
        const go = make('button', { type: 'button', text: 'Show', on: { click: () => this.goToProblem() } });
        this.problem.replaceChildren(
            make('strong', { text: `${place}${problem.message}` }),
            make('div', { text: problem.help ?? '' }),
        );
        if (problem.line !== undefined) this.problem.firstChild.after(' ', go);
    }

    goToProblem() {
        this.area.focus();
        this.area.setSelectionRange(this.problemAt, this.problemAt);
        const line = this.area.value.slice(0, this.problemAt).split('\n').length;
        this.area.scrollTop = Math.max(0, (line - 4) * 18);
        this.follow();
    }
}
