// Colours, dashes and words by what they stand for: those of the diagrams (src/pictures/theme.rs). The colours themselves
// are custom properties in style.css.

import { makeSvg } from './dom.js';

/** Pen down and pen up in widths of the line, by kind of ray. */
export const DASHES = { camera: [], reflected: [5, 4], refracted: [5.5, 3.2, 0.01, 3.2], shadow: [0.01, 2.6] };

/** The kinds in the order of legends. */
export const KINDS = ['camera', 'reflected', 'refracted', 'shadow'];

/** The words for the stages of a certificate. */
export const STAGES = [
    ['filter', 'by the filter'],
    ['integer', 'by integers'],
    ['double_double', 'by double-doubles'],
    ['expansion', 'by expansions'],
];

/** Custom properties by their names: light and dark. To ask for one would have the page styled at once. */
const COLORS = new Map();

/** What a custom property says in the theme that shows. Each is written `light-dark(LIGHT, DARK)`. */
export function cssColor(name) {
    if (!COLORS.has(name)) {
        const both = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`);
        COLORS.set(name, both.match(/#\w+/g));
    }
    return COLORS.get(name)[document.documentElement.dataset.theme === 'dark' ? 1 : 0];
}

/** `#rrggbb` as numbers from 0 to 1. */
export function rgbOfHex(hex) {
    return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}

/** The colours of a heat map, cold to hot, as numbers from 0 to 255. */
export function heatStops() {
    return [0, 1, 2, 3, 4, 5].map((i) => rgbOfHex(cssColor(`heat-${i}`)).map((c) => c * 255));
}

/** A short piece of the line of a kind of ray. */
export function lineSample(kind) {
    const width = 2;
    const line = makeSvg('line', { x1: 2, y1: 5, x2: 24, y2: 5, class: `line-sample ray-${kind}` });
    if (DASHES[kind]?.length) line.setAttribute('stroke-dasharray', DASHES[kind].map((d) => d * width * 0.8).join(' '));
    return makeSvg('svg', { class: 'sample', width: 26, height: 10, viewBox: '0 0 26 10', 'aria-hidden': 'true' }, line);
}

/** A linear colour as the bytes of sRGB, clamped. */
export function srgbBytes(linear) {
    return linear.map((x) => {
        const c = Math.min(1, Math.max(0, x));
        return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
    });
}

/** A linear colour as CSS. */
export function cssOfLinear(linear) {
    return `rgb(${srgbBytes(linear).join(' ')})`;
}
