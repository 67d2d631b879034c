// What if: knobs and the scene's text, both of which change one text; and undo.

import { Difference } from './difference.js';
import { byId, make, setText, wireTabs } from './dom.js';
import { partAt, readSpans, withValue } from './json-edit.js';
import { SceneEditor } from './scene-editor.js';
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
        this.canTrace = canTrace;
        this.tab = wireTabs(byId('numbers-tabs'), (tab) => {
            byId('digits-label').hidden = tab.id !== 'tab-arithmetic';
        });
        this.picked = {};
        this.makeBars();
        this.makeKnobs();
        this.makeEditor();
        this.difference = new Difference({ summary: this.summary, outcome: this.outcome, onNode });
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
        if (this.now.text === scene.text) this.editor.text = scene.text;
        this.editor.showProblem();
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
        this.editor.text = this.now.text;
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
        this.editor.text = next.text;
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
            if (!this.isWaiting) this.editor.showProblem(problem);
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

    /** Shows the difference to the scene as it was given; `difference` is absent where nothing is changed. */
    showDifference(difference, player) {
        if (this.canTrace) this.difference.show(difference, player);
    }

    makeEditor() {
        this.editor = new SceneEditor({
            host: byId('scene-text'),
            isReadOnly: !this.canTrace,
            onText: (text) => this.change({ ...this.now, text }, 'text'),
            onKey: (event) => this.pressed(event),
        });
    }
}
