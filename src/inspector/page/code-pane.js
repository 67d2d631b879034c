// The pseudocode with the current line, and the call stack with its variables.

import { byId, keepTop, make, setText } from './dom.js';
import { briefValue } from './format.js';

/** A variable in few words. Rays and hits are objects of numbers and vectors. */
export function variableText(value, digits = 4) {
    if (Array.isArray(value) && value.every((x) => typeof x === 'number')) return briefValue(value, digits);
    if (Array.isArray(value)) return value.map((x) => variableText(x, digits)).join(', ');
    if (value === null) return 'none';
    if (typeof value === 'object')
        return Object.entries(value)
            .map(([key, x]) => `${key} ${variableText(x, digits)}`)
            .join('  ');
    if (typeof value === 'number') return briefValue(value, digits + 1);
    return String(value);
}

/** The pane. `onStep(k)` hears which step to go to. */
export class CodePane {
    constructor({ onStep }) {
        this.onStep = onStep;
        this.host = byId('code-lines');
        this.stack = byId('stack');
        this.stackToTop = keepTop(this.stack);
        this.scrollTop = 0;
        this.host.addEventListener('scroll', () => (this.scrollTop = this.host.scrollTop), { passive: true });
        new ResizeObserver(() => this.measure()).observe(this.host);
        this.lines = [];
    }

    setPlayer(player) {
        this.player = player;
        const code = player.pseudocode;
        if (this.code && JSON.stringify(this.code) === JSON.stringify(code)) return;
        this.code = code;
        const list = make('ol');
        this.lines = code.map((line, i) => {
            const isFirst = i === 0 || code[i - 1].procedure !== line.procedure;
            const place = make('span', { class: 'place', text: String(i + 1), 'aria-hidden': 'true' });
            const text = make('span', { class: 'text', text: line.text });
            text.style.marginLeft = `${2 * line.indent}ch`;
            return make('li', { class: isFirst ? 'first' : '' }, place, text);
        });
        list.append(...this.lines);
        this.host.replaceChildren(list);
        this.active = [];
        this.measure();
    }

    /** Shows a step. */
    show(step) {
        const stack = this.player.stackAt(step);
        const line = this.player.steps[step].line;
        for (const element of this.active) {
            element.classList.remove('current', 'active');
            element.removeAttribute('aria-current');
        }
        this.active = stack
            .slice(1)
            .map((frame) => this.lines[frame.line])
            .filter(Boolean);
        for (const element of this.active) element.classList.add('active');
        const current = this.lines[line];
        if (current) {
            current.classList.add('current');
            current.setAttribute('aria-current', 'step');
            this.active.push(current);
            this.line = line;
            this.keepInSight(line);
        }
        this.showStack(stack);
    }

    /** Where the lines are, asked once for a size: to ask at every step would lay out the page at once. */
    measure() {
        this.height = this.host.clientHeight;
        this.places = this.lines.map((line) => [line.offsetTop - this.host.offsetTop, line.offsetHeight]);
        if (this.line !== undefined) this.keepInSight(this.line);
    }

    keepInSight(line) {
        if (!this.places?.[line] || !this.height) return;
        const [top, height] = this.places[line];
        const margin = Math.min(60, this.height / 4);
        let to = this.scrollTop;
        if (top - margin < to) to = Math.max(0, top - margin);
        else if (top + height + margin > to + this.height) to = top + height + margin - this.height;
        if (to === this.scrollTop) return;
        this.scrollTop = to;
        this.host.scrollTop = to;
    }

    showStack(stack) {
        while (this.stack.children.length > stack.length) this.stack.lastChild.remove();
        while (this.stack.children.length < stack.length) this.stack.append(this.newFrame());
        stack.forEach((frame, i) => this.fillFrame(this.stack.children[i], frame, i === 0));
        this.stackToTop();
    }

    newFrame() {
        const element = make('div', { class: 'frame' });
        element.button = make('button', { type: 'button' });
        element.where = make('span');
        element.list = make('dl', { class: 'variables' });
        element.append(make('div', { class: 'frame-head' }, element.button, element.where), element.list);
        element.button.addEventListener('click', () => this.onStep(element.at));
        return element;
    }

    fillFrame(element, frame, isTop) {
        element.classList.toggle('top-frame', isTop);
        element.at = frame.at;
        setText(element.button, frame.procedure);
        setText(element.where, this.player.nodes[frame.node].path);
        const list = element.list;
        while (list.children.length > frame.variables.size) list.lastChild.remove();
        while (list.children.length < frame.variables.size) list.append(make('div', {}, make('dt'), make('dd')));
        let i = 0;
        for (const [name, value] of frame.variables) {
            const row = list.children[i];
            const text = variableText(value);
            row.className = isTop && frame.fresh.has(name) ? 'fresh' : '';
            setText(row.firstChild, name);
            setText(row.lastChild, text);
            row.title = `${name} = ${variableText(value, 17)}`;
            i += 1;
        }
    }
}
