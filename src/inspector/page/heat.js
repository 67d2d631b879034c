// Heat maps over the picture, and their legend.

import { make } from './dom.js';
import { brief } from './format.js';
import { cssColor, heatStops, rgbOfHex, STAGES } from './palette.js';

/** What the overlays count. */
const UNITS = { rays: 'rays', depth: 'levels', tests: 'tests', time: '\u00b5s' };

/** An overlay that fills in as its rows come. */
export class HeatMap {
    constructor(canvas, legend) {
        this.canvas = canvas;
        this.legend = legend;
        this.clear();
    }

    /** Begins an empty overlay of a kind. */
    start(kind, width, height) {
        this.kind = kind;
        this.width = width;
        this.values = new Float32Array(width * height).fill(NaN);
        this.most = 0;
        this.canvas.width = width;
        this.canvas.height = height;
        this.canvas.hidden = false;
        this.context = this.canvas.getContext('2d');
    }

    /** No overlay. */
    clear() {
        this.kind = '';
        this.values = undefined;
        this.canvas.hidden = true;
        this.legend.replaceChildren(make('span', { text: 'Click, drag or press arrow keys to choose a pixel.' }));
    }

    /** Takes rows, whose values may be in nanoseconds, and draws. */
    rows(y, rows, values) {
        this.values.set(this.kind === 'time' ? values.map((x) => x / 1000) : values, y * this.width);
        cancelAnimationFrame(this.frame);
        this.frame = requestAnimationFrame(() => this.draw());
    }

    /** The value of a pixel, in words. */
    words(x, y) {
        const value = this.values?.[y * this.width + x];
        if (value === undefined || Number.isNaN(value)) return '';
        if (this.kind === 'stage') return value < 0 ? 'nothing hit' : `decided ${STAGES[value][1]}`;
        return `${brief(value, 4)} ${UNITS[this.kind]}`;
    }

    draw() {
        if (!this.values) return;
        const known = this.values.filter((x) => !Number.isNaN(x));
        const image = this.context.createImageData(this.width, this.values.length / this.width);
        const pixels = new Uint32Array(image.data.buffer);
        if (this.kind === 'stage') this.drawStages(pixels);
        else this.drawHeat(pixels, known.sort());
        this.context.putImageData(image, 0, 0);
    }

    drawStages(pixels) {
        const packed = STAGES.map((_, i) => packedColor(rgbOfHex(cssColor(`stage-${i}`)).map((c) => c * 255)));
        const ground = packedColor(rgbOfHex(cssColor('panel')).map((c) => c * 255));
        this.values.forEach((x, i) => {
            if (!Number.isNaN(x)) pixels[i] = x < 0 ? ground : packed[x];
        });
        const counts = STAGES.map((_, i) => this.values.reduce((sum, x) => sum + (x === i), 0));
        this.legend.replaceChildren();
        STAGES.forEach(([word], i) => {
            const square = make('i', { title: `${counts[i]} pixels` });
            square.style.background = cssColor(`stage-${i}`);
            this.legend.append(square, make('span', { text: word.replace('_', '-') }));
        });
    }

    drawHeat(pixels, sorted) {
        // A few slow pixels would leave everything else cold.
        const at = this.kind === 'time' ? Math.floor((sorted.length - 1) * 0.99) : sorted.length - 1;
        this.most = Math.max(sorted[at] ?? 0, 1e-9);
        const colors = ramp(256).map(packedColor);
        this.values.forEach((x, i) => {
            if (!Number.isNaN(x)) pixels[i] = colors[Math.max(0, Math.min(255, Math.round((x / this.most) * 255)))];
        });
        const strip = make('canvas', { width: 256, height: 1, 'aria-hidden': 'true' });
        const image = new ImageData(256, 1);
        new Uint32Array(image.data.buffer).set(colors);
        strip.getContext('2d').putImageData(image, 0, 0);
        const most = `${brief(this.most, 3)}${this.kind === 'time' ? ' or more' : ''} ${UNITS[this.kind]}`;
        this.legend.replaceChildren(make('span', { text: '0' }), strip, make('span', { text: most }));
    }
}

function packedColor([r, g, b]) {
    return (0xff000000 | (Math.round(b) << 16) | (Math.round(g) << 8) | Math.round(r)) >>> 0;
}

/** The heat colours in so many steps. */
function ramp(count) {
    const stops = heatStops();
    return Array.from({ length: count }, (_, i) => {
        const at = (i / (count - 1)) * (stops.length - 1);
        const below = Math.min(Math.floor(at), stops.length - 2);
        return stops[below].map((c, k) => c + (stops[below + 1][k] - c) * (at - below));
    });
}
