// The picture, filled in as its rows come; the chosen pixel and the magnifier.

import { byId, make, setText } from './dom.js';
import { colorText, counted } from './format.js';
import { HeatMap } from './heat.js';
import { cssOfLinear } from './palette.js';

/** Pixels across the magnifier. */
const ACROSS = 11;
/** Milliseconds that a chosen pixel waits for what there is to show of it. */
const SOON = 30;

/** The pane. `onPixel(x, y, isPassing, isArrow)` hears every pixel that is chosen; `onOverlay(kind)` every overlay. */
export class RenderPane {
    constructor({ onPixel, onOverlay }) {
        this.onPixel = onPixel;
        this.stage = byId('stage');
        this.canvas = byId('render');
        this.cross = byId('cross');
        this.heat = new HeatMap(byId('heat'), byId('legend'));
        this.magnifier = byId('magnifier').getContext('2d');
        this.words = byId('pixel-words');
        this.names = byId('named-pixels');
        this.makeWords();
        this.listen();
        byId('overlay').addEventListener('change', (event) => onOverlay(event.target.value));
    }

    makeWords() {
        this.title = make('strong');
        this.colorSwatch = make('span', { class: 'swatch' });
        this.rgb = make('span', { class: 'rgb' });
        this.counts = make('span', { class: 'quiet' });
        this.measured = make('span', { class: 'quiet' });
        this.words.append(this.title, make('span', {}, this.colorSwatch, this.rgb), this.counts, this.measured);
    }

    /** Shows another scene, whose picture is still to come. */
    setScene(scene, keepsPicture) {
        this.scene = scene;
        const { width, height } = scene.image;
        if (!keepsPicture || this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        this.context = this.canvas.getContext('2d', { willReadFrequently: true });
        this.stage.style.aspectRatio = `${width} / ${height}`;
        this.stage.style.width = `min(100cqw, 42vh * ${width / height})`;
        this.names.replaceChildren(make('option', { value: '', text: 'pixels by name' }));
        for (const { name, x, y } of scene.pixels) this.names.append(make('option', { value: `${x},${y}`, text: name }));
    }

    /** Marks pixels that can be chosen, where not all can. */
    markKept(pixels) {
        const { width, height } = this.scene.image;
        if (pixels.length > 400) return;
        for (const [x, y] of pixels) {
            const mark = make('span', { class: 'kept', 'aria-hidden': 'true' });
            mark.style.left = `${((x + 0.5) / width) * 100}%`;
            mark.style.top = `${((y + 0.5) / height) * 100}%`;
            this.cross.before(mark);
        }
        setText(byId('stage-help'), 'Arrow keys choose the next pixel that is kept in this page; a click chooses the nearest.');
    }

    /** Takes rows of sRGB. */
    rows(y, rows, bytes) {
        const width = this.canvas.width;
        this.context.putImageData(
            new ImageData(new Uint8ClampedArray(bytes.buffer, bytes.byteOffset, bytes.length), width, rows),
            0,
            y,
        );
        cancelAnimationFrame(this.frame);
        this.frame = requestAnimationFrame(() => this.magnify());
    }

    /** Marks the chosen pixel: at once, or with what there is to show of it if that comes soon, in one frame. */
    choose(x, y, waits) {
        this.pixel = [x, y];
        clearTimeout(this.marking);
        if (waits) this.marking = setTimeout(() => this.mark(), SOON);
        else this.mark();
    }

    mark() {
        const [x, y] = this.pixel;
        const { width, height } = this.scene.image;
        this.cross.style.left = `${((x + 0.5) / width) * 100}%`;
        this.cross.style.top = `${((y + 0.5) / height) * 100}%`;
        const named = this.scene.pixels.find((pixel) => pixel.x === x && pixel.y === y);
        const value = named ? `${x},${y}` : '';
        if (this.names.value !== value) this.names.value = value;
        setText(this.title, named ? `${x},${y} \u201c${named.name}\u201d` : `${x},${y}`);
        this.magnify();
    }

    /** Shows the colour of the chosen pixel; none before it is known. */
    showColor(color, rays) {
        if (color) {
            this.colorSwatch.style.background = cssOfLinear(color);
            setText(this.rgb, colorText(color));
            setText(this.counts, counted(rays, 'ray'));
        } else {
            this.colorSwatch.style.background = '';
            setText(this.rgb, '?');
            setText(this.counts, '');
        }
    }

    magnify() {
        if (!this.pixel) return;
        const [x, y] = this.pixel;
        const size = this.magnifier.canvas.width;
        const half = Math.floor(ACROSS / 2);
        const cell = size / ACROSS;
        this.magnifier.imageSmoothingEnabled = false;
        this.magnifier.clearRect(0, 0, size, size);
        const { width, height } = this.canvas;
        // Only what lies inside the picture: drawImage would stretch the rest.
        const [left, top] = [Math.max(0, x - half), Math.max(0, y - half)];
        const [right, bottom] = [Math.min(width, x + half + 1), Math.min(height, y + half + 1)];
        const place = [(left - x + half) * cell, (top - y + half) * cell, (right - left) * cell, (bottom - top) * cell];
        this.magnifier.drawImage(this.canvas, left, top, right - left, bottom - top, ...place);
        for (const [width, color] of [
            [3, '#000'],
            [1.5, '#fff'],
        ]) {
            this.magnifier.lineWidth = width;
            this.magnifier.strokeStyle = color;
            this.magnifier.strokeRect(half * cell - 0.5, half * cell - 0.5, cell + 1, cell + 1);
        }
        setText(this.measured, this.heat.words(x, y));
    }

    listen() {
        const at = (event) => {
            const box = this.canvas.getBoundingClientRect();
            const { width, height } = this.scene.image;
            const clamp = (v, most) => Math.max(0, Math.min(most - 1, Math.floor(v)));
            return [
                clamp(((event.clientX - box.left) / box.width) * width, width),
                clamp(((event.clientY - box.top) / box.height) * height, height),
            ];
        };
        let isDown = false;
        this.stage.addEventListener('pointerdown', (event) => {
            if (event.button !== 0 || !this.scene) return;
            isDown = true;
            this.stage.setPointerCapture(event.pointerId);
            this.onPixel(...at(event));
        });
        this.stage.addEventListener('pointermove', (event) => {
            if (!isDown) return;
            const [x, y] = at(event);
            if (x !== this.pixel[0] || y !== this.pixel[1]) this.onPixel(x, y, true);
        });
        for (const name of ['pointerup', 'pointercancel']) this.stage.addEventListener(name, () => (isDown = false));
        this.stage.addEventListener('keydown', (event) => {
            const far = event.shiftKey ? 10 : 1;
            const move = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] }[event.key];
            if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
            event.preventDefault();
            event.stopPropagation();
            const { width, height } = this.scene.image;
            const [x, y] = [this.pixel[0] + move[0], this.pixel[1] + move[1]];
            this.onPixel(Math.max(0, Math.min(width - 1, x)), Math.max(0, Math.min(height - 1, y)), event.repeat, true);
        });
        this.names.addEventListener('change', () => {
            if (this.names.value) this.onPixel(...this.names.value.split(',').map(Number));
        });
    }
}
