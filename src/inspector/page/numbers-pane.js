// The arithmetic of the current step: the formula in symbols, with this ray's numbers, each value, and the verdict.

import { afterFrame, byId, keepTop, make } from './dom.js';
import { drawInput, drawLine, namesIn } from './formulas.js';
import { testName } from './tests-pane.js';

/** The least height of a line, in pixels. */
const LINE = 26;

/** The pane. What lies below its lower edge is made after the frame that shows the rest: formulas are slow to lay out. */
export class NumbersPane {
    constructor() {
        this.host = byId('arithmetic');
        this.toTop = keepTop(this.host);
        this.inSight = 1;
        new ResizeObserver(([entry]) => (this.inSight = Math.ceil(entry.contentRect.height / LINE) + 1)).observe(this.host);
        this.allDigits = byId('digits');
        this.allDigits.addEventListener('change', () => this.show(this.step));
    }

    setPlayer(player) {
        this.player = player;
    }

    /** Shows a step. */
    show(step) {
        this.step = step;
        const { node, test, verdict, arithmetic, line } = this.player.steps[step];
        const { ray, path } = this.player.nodes[node];
        const parts = [];
        const record = test === undefined ? undefined : ray.tests?.[test];
        const where = record
            ? `Test ${test + 1} of ${ray.tests.length}: ${testName(record)}`
            : (this.player.pseudocode[line]?.procedure ?? '');
        const head = make(
            'p',
            { class: 'headline' },
            make('strong', { text: where }),
            make('span', { class: 'where', text: path }),
        );
        if (verdict) {
            const sign = make('span', {
                class: `sign ${verdict.ok ? 'good' : 'bad'}`,
                text: verdict.ok ? '\u2713' : '\u2715',
                'aria-hidden': 'true',
            });
            head.append(make('span', { class: 'verdict' }, sign, make('span', { text: verdict.words })));
        }
        parts.push(head);
        const form = arithmetic && this.player.forms[arithmetic.form];
        const formula = form ? this.formula(form, this.player.valuesAt(step), arithmetic) : [].values();
        if (!form && !verdict) parts.push(make('p', { class: 'form-title', text: 'Nothing is computed in this step.' }));
        while (parts.length < this.inSight) {
            const { value, done } = formula.next();
            if (done) break;
            parts.push(value);
        }
        this.host.replaceChildren(...parts);
        this.toTop();
        this.rest = formula;
        afterFrame(() => {
            if (this.rest === formula) this.host.append(...formula);
        });
    }

    /** The parts of a formula, each made when it is asked for. */
    *formula(form, values, arithmetic) {
        const options = { allDigits: this.allDigits.checked, single: form.precision === 'f32' };
        const computed = new Set(form.lines.map((line) => line.name));
        const needed = new Set();
        for (const line of form.lines) if (line.expression !== undefined) namesIn(line.expression, needed);
        const inputs = make('div', { class: 'inputs' });
        for (const name of Object.keys(values)) {
            if (!computed.has(name) && needed.has(name)) inputs.append(drawInput(name, values[name], options));
        }
        yield make('p', { class: 'form-title', text: form.title });
        if (inputs.childElementCount) yield inputs;
        for (const line of form.lines) {
            const isOpen = values[line.name] === undefined;
            const about = {
                class: `formula-line${isOpen ? ' open' : ''}`,
                title: isOpen ? 'not computed: it was decided before' : undefined,
            };
            yield make('div', about, ...drawLine(line, values, options));
        }
        if (arithmetic.note) yield make('p', { class: 'source', text: arithmetic.note });
        if (form.source) yield make('p', { class: 'source', text: form.source });
    }
}
