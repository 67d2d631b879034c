// The diagram of the current node and step, growing with the steps: parts that carry `data-node` of a ray not reached yet
// are hidden.

import { byId, setText, wireTabs } from './dom.js';
import { joinLetters } from './letters.js';

/** How many diagrams are kept. */
const KEPT_DIAGRAMS = 120;

/** Kinds that are about one ray, not about one test. */
const WHOLE_KINDS = ['section', 'surface', 'tree', 'ledger'];

/** Whether the surface that a ray meets reflects or refracts it. */
function sendsRaysOn(ray) {
    return Boolean(ray.reflected ?? ray.refracted);
}

/** The drawing as an element. The parser of pages takes a fifth of the time that the one of XML does. */
function parsed(svg) {
    const template = document.createElement('template');
    template.innerHTML = joinLetters(svg);
    return template.content.querySelector('svg');
}

/** The pane. `onNode(index)` hears which ray was clicked, `onSpace(isOn)` whether the 3D view is to show. */
export class DiagramPane {
    constructor(api, { onNode, onSpace }) {
        this.api = api;
        this.onSpace = onSpace;
        this.host = byId('diagram');
        this.note = byId('diagram-note');
        this.growing = byId('growing');
        this.kept = new Map();
        this.kind = 'step';
        this.choose = wireTabs(byId('view-tabs'), (tab) => this.chooseKind(tab.dataset.kind));
        this.choose('view-step');
        this.listen();
        this.growing.addEventListener('change', () => this.grow());
        this.host.addEventListener('click', (event) => {
            const index = this.player?.byPath.get(event.target.closest('[data-node]')?.dataset.node);
            if (index !== undefined) onNode(index);
        });
    }

    /** Wheel, drag and keys move and enlarge the drawing; a double click shows all of it. */
    listen() {
        let from;
        this.host.addEventListener(
            'wheel',
            (event) => {
                event.preventDefault();
                this.zoom(Math.exp(event.deltaY * 0.0015), event.clientX, event.clientY);
            },
            { passive: false },
        );
        this.host.addEventListener('pointerdown', (event) => {
            from = [event.clientX, event.clientY];
        });
        this.host.addEventListener('pointermove', (event) => {
            if (!from || !event.buttons) return;
            this.pan(event.clientX - from[0], event.clientY - from[1]);
            from = [event.clientX, event.clientY];
        });
        this.host.addEventListener('dblclick', () => this.showAll());
        byId('view-body').addEventListener('keydown', (event) => {
            if (this.kind === '3d' || event.ctrlKey || event.metaKey || event.altKey) return;
            const move = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }[event.key];
            if (move) this.pan(...move);
            else if (event.key === '+' || event.key === '=') this.zoom(1 / 1.25);
            else if (event.key === '-') this.zoom(1.25);
            else if (event.key === '0') this.showAll();
            else return;
            event.preventDefault();
            event.stopPropagation();
        });
    }

    get drawing() {
        return this.host.querySelector('svg');
    }

    zoom(by, x, y) {
        const { drawing } = this;
        if (!drawing) return;
        const box = drawing.viewBox.baseVal;
        const all = drawing.all;
        const width = Math.min(all.width, Math.max(all.width / 16, box.width * by));
        const scale = width / box.width;
        const at = new DOMPoint(x ?? 0, y ?? 0).matrixTransform(drawing.getScreenCTM().inverse());
        if (x === undefined) Object.assign(at, { x: box.x + box.width / 2, y: box.y + box.height / 2 });
        this.place(at.x - (at.x - box.x) * scale, at.y - (at.y - box.y) * scale, width, box.height * scale);
    }

    pan(x, y) {
        const { drawing } = this;
        if (!drawing) return;
        const box = drawing.viewBox.baseVal;
        const scale = drawing.getScreenCTM().a;
        this.place(box.x - x / scale, box.y - y / scale, box.width, box.height);
    }

    place(x, y, width, height) {
        const { all } = this.drawing;
        const inside = (at, size, from, length) => Math.min(Math.max(at, from), from + length - size);
        const left = inside(x, width, all.x, all.width);
        const top = inside(y, height, all.y, all.height);
        this.drawing.setAttribute('viewBox', `${left} ${top} ${width} ${height}`);
    }

    showAll() {
        const { all } = this.drawing ?? {};
        if (all) this.place(all.x, all.y, all.width, all.height);
    }

    setPlayer(player, sceneId, pixel) {
        Object.assign(this, { player, sceneId, pixel });
    }

    chooseKind(kind) {
        this.kind = kind;
        byId('space').hidden = kind !== '3d';
        this.host.hidden = kind === '3d';
        this.note.hidden = true;
        this.shownKey = undefined;
        this.onSpace(kind === '3d');
        if (this.player && this.step !== undefined) this.show(this.step, this.node, this.forced);
    }

    /** What is asked of the server for a step and node; nothing where no drawing applies. */
    wanted(step, node) {
        const theme = document.documentElement.dataset.theme;
        const { nodes, steps } = this.player;
        if (this.kind === 'surface') return this.ofSurface(node, theme);
        if (WHOLE_KINDS.includes(this.kind)) {
            const isOfTree = this.kind === 'tree' || this.kind === 'ledger';
            return { kind: this.kind, node: isOfTree ? 'root' : nodes[node].path, theme };
        }
        // A step without a diagram of its own leaves the last one of its ray.
        for (let k = step; k >= 0 && steps[k].node === node; k -= 1) {
            const { diagram } = steps[k];
            if (!diagram) continue;
            const of = diagram.node ?? node;
            if (diagram.kind === 'surface' && !sendsRaysOn(nodes[of].ray)) break;
            const about = { kind: diagram.kind, node: nodes[of].path };
            if (diagram.shape !== undefined) about.shape = diagram.shape;
            if (diagram.primitive !== undefined) about.primitive = diagram.primitive;
            return { ...about, theme };
        }
        return { kind: 'section', node: nodes[node].path, theme };
    }

    /**
     * Asks for what the camera ray of a pixel will show, before its recording is there: `place` is `start` or `end`, or nothing
     * for the step that decides.
     */
    guess(sceneId, pixel, place) {
        if (this.kind === '3d' || this.kind === 'surface' || !this.api.canTrace) return;
        const theme = document.documentElement.dataset.theme;
        const ofStep = { start: 'section', end: 'tree' }[place] ?? 'verdict';
        const kind = this.kind === 'step' ? ofStep : this.kind;
        this.guessed = { of: `${sceneId} ${pixel}`, done: this.fetchGuess(sceneId, pixel, { kind, node: 'root', theme }) };
    }

    async fetchGuess(sceneId, pixel, wish) {
        const known = wish.kind !== 'verdict' && this.kept.has(this.keyOf(wish, sceneId, pixel));
        if (known) return;
        try {
            const { about, svg } = await this.api.diagramAndKind(sceneId, ...pixel, wish);
            this.keep(this.keyOf(about, sceneId, pixel), { root: parsed(svg) });
        } catch {
            // It is asked for again by those who want it, who say what is wrong.
        }
    }

    /** The surface that a ray meets, or, if that sends no ray on, the one that it comes from. */
    ofSurface(node, theme) {
        for (let at = node; at >= 0; at = this.player.nodes[at].parent) {
            if (sendsRaysOn(this.player.nodes[at].ray)) return { kind: 'surface', node: this.player.nodes[at].path, theme };
        }
        return undefined;
    }

    /** Shows the diagram of a step; resolves when it is on the page. */
    async show(step, node, forced) {
        Object.assign(this, { step, node, forced });
        this.growing.disabled = Boolean(forced);
        if (this.kind === '3d') return;
        const about = this.wanted(step, node);
        const key = this.keyOf(about);
        if (!about) this.keep(key, { why: 'no surface on the way of this ray sends a ray on' });
        if (key === this.shownKey) {
            this.grow();
            return;
        }
        this.wantedKey = key;
        if (!this.kept.has(key) && this.guessed?.of === `${this.sceneId} ${this.pixel}`) {
            const { done } = this.guessed;
            this.guessed = undefined;
            await done;
            if (this.wantedKey !== key) return;
        }
        const kept = this.kept.get(key);
        if (kept) {
            this.put(key, kept);
            return;
        }
        clearTimeout(this.waiting);
        this.waiting = setTimeout(() => this.host.classList.add('waiting'), 200);
        const got = await this.fetch(key, about);
        if (this.wantedKey !== key) return;
        clearTimeout(this.waiting);
        this.host.classList.remove('waiting');
        if (got) this.put(key, got);
    }

    keyOf(about, sceneId = this.sceneId, pixel = this.pixel) {
        return `${sceneId} ${pixel} ${JSON.stringify(about)}`;
    }

    async fetch(key, about) {
        try {
            const svg = await this.api.diagram(this.sceneId, ...this.pixel, about);
            this.keep(key, { root: parsed(svg) });
        } catch (error) {
            if (error.status === undefined || error.status === 404) this.keep(key, { why: error.message }, true);
            else this.keep(key, { why: error.message });
        }
        return this.kept.get(key) ?? this.failed;
    }

    keep(key, diagram, isPassing) {
        if (isPassing && this.api.canTrace) {
            this.failed = diagram;
            return;
        }
        this.kept.set(key, diagram);
        if (this.kept.size > KEPT_DIAGRAMS) this.kept.delete(this.kept.keys().next().value);
    }

    put(key, { root, why }) {
        clearTimeout(this.waiting);
        this.host.classList.remove('waiting');
        this.shownKey = key;
        this.note.hidden = !why;
        setText(this.note, why ? `No diagram here: ${why}` : '');
        if (!root) {
            this.host.replaceChildren();
            this.parts = [];
            return;
        }
        root.removeAttribute('width');
        root.removeAttribute('height');
        this.host.replaceChildren(root);
        const { x, y, width, height } = root.viewBox.baseVal;
        root.all = { x, y, width, height };
        root.setAttribute('role', 'img');
        // The drawing is one picture with one description: what is written in it is no element of its own.
        for (const part of root.querySelectorAll('g[aria-label]')) part.removeAttribute('aria-label');
        const title = root.querySelector('title')?.textContent ?? 'Diagram';
        const words = root.querySelector('desc')?.textContent ?? '';
        root.setAttribute('aria-label', `${title}. ${words}`);
        this.parts = [...root.querySelectorAll('[data-node]')].map((element) => [
            element,
            this.player.byPath.get(element.dataset.node),
        ]);
        this.grow();
    }

    /** Hides the rays that have not been reached. */
    grow() {
        if (!this.parts || this.kind === '3d') return;
        const isGrowing = this.growing.checked || this.forced;
        for (const [element, index] of this.parts) {
            const isHidden = isGrowing && index !== undefined && !this.player.isReached(index, this.step);
            element.classList.toggle('not-yet', isHidden);
        }
    }

    /** Fetches what the next step will want. */
    async prefetch(step, node) {
        if (this.kind === '3d') return;
        const about = this.wanted(step, node);
        const key = this.keyOf(about);
        if (!about || this.kept.has(key) || this.fetching === key) return;
        this.fetching = key;
        await this.fetch(key, about);
        this.fetching = undefined;
    }
}
