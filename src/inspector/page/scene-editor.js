// The scene's text, with its problem underlined in place.

import { byId, make, whenQuiet } from './dom.js';

/** The editor, in `host`. `onText(text)` hears a change once the typing pauses, `onKey(event)` every key. */
export class SceneEditor {
    constructor({ host, isReadOnly, onText, onKey }) {
        this.isReadOnly = isReadOnly;
        this.area = make('textarea', {
            spellcheck: 'false',
            autocapitalize: 'off',
            autocomplete: 'off',
            wrap: 'off',
            'aria-label': 'The text of the scene',
            'aria-describedby': 'scene-problem',
            id: 'scene-area',
            readonly: isReadOnly,
        });
        this.shadow = make('pre', { 'aria-hidden': 'true' });
        this.problem = make('div', { class: 'problem', id: 'scene-problem', role: 'status' });
        host.append(make('div', { class: 'editor' }, this.shadow, this.area), this.problem);
        const typed = whenQuiet(180, () => onText(this.area.value));
        this.area.addEventListener('input', () => {
            this.underline();
            typed();
        });
        this.area.addEventListener('scroll', () => this.follow(), { passive: true });
        this.area.addEventListener('keydown', (event) => {
            // Tab leaves the editor, as everywhere; Escape has nothing to close.
            if (event.key !== 'Escape') event.stopPropagation();
            onKey(event);
        });
    }

    set text(text) {
        if (this.area.value !== text) this.area.value = text;
    }

    follow() {
        this.shadow.scrollTop = this.area.scrollTop;
        this.shadow.scrollLeft = this.area.scrollLeft;
    }

    /** Underlines a problem in its place; none: nothing. */
    underline(problem) {
        this.shadow.replaceChildren();
        if (problem?.line === undefined) return;
        const text = this.area.value;
        const lines = text.split('\n');
        let from = 0;
        for (let i = 0; i < problem.line - 1 && i < lines.length; i += 1) from += lines[i].length + 1;
        // Columns count characters, a string's length counts UTF-16.
        const line = [...(lines[problem.line - 1] ?? '')];
        const column = Math.max(0, (problem.column ?? 1) - 1);
        from += line.slice(0, column).join('').length;
        let to = Math.min(text.length, from + Math.max(1, problem.length ?? 1));
        if (text.slice(from, to).trim() === '' && from > 0) {
            from -= 1;
            to = from + 1;
        }
        this.problemAt = from;
        this.shadow.append(text.slice(0, from), make('mark', { text: text.slice(from, to) || ' ' }), text.slice(to) + '\n');
        this.follow();
    }

    showProblem(problem) {
        const isBad = problem !== undefined;
        this.problem.classList.toggle('bad', isBad);
        this.area.setAttribute('aria-invalid', String(isBad));
        byId('tab-text').classList.toggle('has-problem', isBad);
        this.underline(problem);
        if (!isBad) {
            const words = this.isReadOnly ? 'Changes need raytree inspect, which traces anew.' : 'No problem found.';
            this.problem.replaceChildren(make('span', { class: 'count', text: words }));
            return;
        }
        const place = problem.line === undefined ? '' : `line ${problem.line}, column ${problem.column}: `;
        const go = make('button', { type: 'button', text: 'Show', on: { click: () => this.goToProblem() } });
        this.problem.replaceChildren(
            make('strong', { text: `${place}${problem.message}` }),
            make('div', { text: problem.help ?? '' }),
        );
        if (problem.line !== undefined) this.problem.firstChild.after(' ', go);
    }

    goToProblem() {
        this.area.focus();
        this.area.setSelectionRange(this.problemAt, this.problemAt);
        const line = this.area.value.slice(0, this.problemAt).split('\n').length;
        this.area.scrollTop = Math.max(0, (line - 4) * 18);
        this.follow();
    }
}
