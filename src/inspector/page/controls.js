// The step buttons, the slider over all steps, and what to run until.

import { byId, make, makeSvg, setText } from './dom.js';
import { cssColor } from './palette.js';

/** Words for the events, and what they take. */
export const EVENTS = [
    ['hit', 'next hit'],
    ['blocked', 'shadow ray blocked'],
    ['tir', 'total internal reflection'],
    ['object', 'test of object', 'object'],
    ['depth', 'depth', 'number', 1],
    ['weight', 'weight below', 'number', 0.1],
    ['t', 't below', 'number', 1],
    ['exact', 'decided exactly'],
    ['nan', 'not a number'],
];

const SHAPES = {
    'go-start': 'M3 3v10M13 3 6 8l7 5z',
    'go-back': 'M12 3 4 8l8 5z',
    'go-into': 'M4 3l8 5-8 5z',
    'go-over': 'M2 10a6 6 0 0 1 11-2M13.5 3.5V8H9M7.5 12.5h1',
    'go-out': 'M8 13V4M4.5 7.5 8 4l3.5 3.5M3 2h10',
    'go-end': 'M13 3v10M3 3l7 5-7 5z',
};

/** The bar. `onMove(how)` hears start, back, into, over, out, end; `onStep(k)` the slider; `onUntil(event, argument)`. */
export class Controls {
    constructor({ onMove, onStep, onUntil }) {
        this.slider = byId('slider');
        this.count = byId('step-count');
        this.timeline = byId('timeline');
        for (const [id, shape] of Object.entries(SHAPES)) {
            const path = makeSvg('path', {
                d: shape,
                fill: /z$/.test(shape) ? 'currentColor' : 'none',
                stroke: 'currentColor',
                'stroke-width': 1.6,
                'stroke-linecap': 'round',
                'stroke-linejoin': 'round',
            });
            byId(id).append(makeSvg('svg', { width: 16, height: 16, viewBox: '0 0 16 16', 'aria-hidden': 'true' }, path));
            byId(id).addEventListener('click', () => onMove(id.slice(3)));
        }
        this.slider.addEventListener('input', () => onStep(Number(this.slider.value)));
        this.event = byId('until-event');
        this.number = byId('until-number');
        this.object = byId('until-object');
        for (const [value, text] of EVENTS) this.event.append(make('option', { value, text }));
        this.event.addEventListener('change', () => this.chooseEvent());
        byId('until').addEventListener('submit', (event) => {
            event.preventDefault();
            onUntil(this.event.value, this.argument());
        });
        new ResizeObserver(([entry]) => {
            this.width = entry.contentRect.width;
            this.drawTimeline();
        }).observe(this.timeline);
    }

    chooseEvent() {
        const [, , takes, start] = EVENTS.find(([value]) => value === this.event.value);
        this.number.hidden = takes !== 'number';
        this.object.hidden = takes !== 'object';
        if (takes === 'number') this.number.value = start;
    }

    argument() {
        if (!this.object.hidden) return this.object.value;
        return this.number.hidden ? undefined : Number(this.number.value);
    }

    setPlayer(player) {
        this.player = player;
        this.slider.max = player.steps.length - 1;
        const before = this.object.value;
        const names = player.objectNames();
        this.object.replaceChildren(...names.map((name) => make('option', { value: name, text: name })));
        if (names.includes(before)) this.object.value = before;
        this.drawTimeline();
    }

    /** Shows a step. */
    show(step, words, hidesLater) {
        if (hidesLater || this.hidesLater) {
            this.hidesLater = hidesLater;
            this.step = step;
            this.drawTimeline();
        }
        const count = this.player.steps.length;
        this.slider.value = step;
        this.slider.setAttribute('aria-valuetext', `step ${step + 1} of ${count}: ${words}`);
        setText(this.count, `step ${step + 1} of ${count}`);
        for (const id of ['go-start', 'go-back']) byId(id).disabled = step === 0;
        for (const id of ['go-into', 'go-over', 'go-out', 'go-end']) byId(id).disabled = step === count - 1;
    }

    /** A band that says for each step what kind of ray is at work, and how deep the recursion is; while one predicts, so far. */
    drawTimeline() {
        if (!this.player || !this.width) return;
        const width = Math.round(this.width * devicePixelRatio);
        const height = Math.round(10 * devicePixelRatio);
        this.timeline.width = width;
        this.timeline.height = height;
        const context = this.timeline.getContext('2d');
        const colors = Object.fromEntries(['camera', 'reflected', 'refracted', 'shadow'].map((kind) => [kind, cssColor(kind)]));
        const { steps, nodes } = this.player;
        let deepest = 1;
        for (const { ray } of nodes) deepest = Math.max(deepest, ray.depth + 1);
        const end = this.hidesLater ? (width * (this.step + 1)) / steps.length : width;
        for (let x = 0; x < end; x += 1) {
            const { ray } = nodes[steps[Math.min(steps.length - 1, Math.floor((x / width) * steps.length))].node];
            const tall = Math.max(2, Math.round((height * (ray.depth + 1)) / (deepest + 1)));
            context.fillStyle = colors[ray.kind];
            context.fillRect(x, height - tall, 1, tall);
        }
    }
}
