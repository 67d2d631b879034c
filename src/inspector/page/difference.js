// What a change does: the colour before and after, and where the two trees part.

import { make } from './dom.js';
import { brief, colorText, counted } from './format.js';
import { cssOfLinear } from './palette.js';

/** The list, in `outcome`, and its summary. `onNode(index)` hears which ray was clicked. */
export class Difference {
    constructor({ summary, outcome, onNode }) {
        this.summary = summary;
        this.outcome = outcome;
        this.onNode = onNode;
    }

    /** Shows the difference to the scene as it was given; `difference` is absent where nothing is changed. */
    show(difference, player) {
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
}
