// The pseudocode with the current line, and the call stack with its variables.

import { byId, make, setText } from './dom.js';
import { briefValue } from './format.js';

/** A variable in few words. Rays and hits are objects of numbers and vectors. */
export function variableText(value, digits = 4) {
    if (Array.isArray(value) && value.every((x) => typeof x === 'number')) return briefValue(value, digits);
    if (Array.isArray(value)) return value.map((x) => variableText(x, digits)).join(', ');
    if (value === null) return 'none';
    if (typeof value === 'object') return Object.entries(value).map(([key, x]) => `${key} ${variableText(x, digits)}`).join('  ');
    if (typeof value === 'number') return briefValue(value, digits + 1);
    return String(value);
}

/** The pane. `onStep(k)` hears which step to go to. */
export class CodePane {
    constructor({ onStep }) {
        this.onStep = onStep;
        this.host = byId('code-lines');
        this.stack = byId('stack');
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
    }

    /** Shows a step. */
    show(step) {
        const stack = this.player.stackAt(step);
        const line = this.player.steps[step].line;
        for (const element of this.active) {
            element.classList.remove('current', 'active');
            element.removeAttribute('aria-current');
        }
        this.active = stack.slice(1).map((frame) => this.lines[frame.line]).filter(Boolean);
        for (const element of this.active) element.classList.add('active');
        const current = this.lines[line];
        if (current) {
            current.classList.add('current');
            current.setAttribute('aria-current', 'step');
            this.active.push(current);
            this.keepInSight(current);
        }
        this.showStack(stack);
    }

    keepInSight(element) {
        const height = this.host.clientHeight;
        const top = element.offsetTop - this.host.offsetTop;
        const margin = Math.min(60, height / 4);
        if (top - margin < this.host.scrollTop) this.host.scrollTop = top - margin;
        else if (top + 20 + margin > this.host.scrollTop + height) this.host.scrollTop = top + 20 + margin - height;
    }

    showStack(stack) {
        while (this.stack.children.length > stack.length) this.stack.lastChild.remove();
        while (this.stack.children.length < stack.length) this.stack.append(this.newFrame());
        stack.forEach((frame, i) => this.fillFrame(this.stack.children[i], frame, i === 0));
        this.stack.scrollTop = 0;
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
