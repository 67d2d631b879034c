// Predict, then reveal: a question before a step, and the score.

import { byId, make, setText } from './dom.js';

/** The switch and the card. `onReveal(step)` hears that a step may be shown, `onNext()` that the next is wanted. */
export class Predictor {
    constructor({ onReveal, onNext, onSwitch }) {
        this.card = byId('question');
        this.toggle = byId('predict');
        this.score = byId('score');
        this.onReveal = onReveal;
        this.onNext = onNext;
        this.right = 0;
        this.asked = 0;
        this.toggle.addEventListener('change', () => {
            this.close();
            this.right = 0;
            this.asked = 0;
            this.answered = new Set();
            this.showScore();
            onSwitch(this.isOn);
        });
        this.answered = new Set();
        this.card.addEventListener('keydown', (event) => this.pressed(event));
    }

    get isOn() {
        return this.toggle.checked;
    }

    get isOpen() {
        return !this.card.hidden;
    }

    /** Another recording: its questions are new. */
    reset() {
        this.answered = new Set();
        this.close();
    }

    /** Whether a step is asked about before it is shown. */
    wantsToAsk(steps, step) {
        return this.isOn && steps[step].question !== undefined && !this.answered.has(step);
    }

    /** Asks. */
    ask(step, question) {
        this.step = step;
        this.question = question;
        this.isAnswered = false;
        this.before = document.activeElement;
        this.buttons = question.choices.map((choice, i) =>
            make(
                'button',
                { type: 'button', on: { click: () => this.answer(i) } },
                make('kbd', { text: String(i + 1), 'aria-hidden': 'true' }),
                choice,
            ),
        );
        this.after = make('div', { class: 'after', role: 'status' });
        this.card.replaceChildren(
            make('p', { text: question.ask }),
            make('div', { class: 'choices' }, ...this.buttons),
            this.after,
        );
        this.card.hidden = false;
        this.buttons[0]?.focus();
    }

    answer(choice) {
        if (this.isAnswered) return;
        this.isAnswered = true;
        const { answer, choices } = this.question;
        const isRight = choice === answer;
        this.asked += 1;
        this.right += isRight;
        this.answered.add(this.step);
        this.showScore();
        this.buttons.forEach((button, i) => {
            button.disabled = true;
            if (i === answer) button.classList.add('right');
            else if (i === choice) button.classList.add('wrong');
        });
        this.onReveal(this.step);
        const next = make('button', { type: 'button', text: 'Go on', on: { click: () => this.goOn() } });
        const words = isRight ? 'Right.' : `Not so. It is: ${choices[answer]}.`;
        this.after.append(make('span', { text: words }), next);
        next.focus();
    }

    goOn() {
        this.close();
        this.onNext();
    }

    close() {
        if (this.card.hidden) return;
        this.card.hidden = true;
        if (this.card.contains(document.activeElement) || document.activeElement === document.body) this.before?.focus?.();
    }

    showScore() {
        setText(this.score, this.isOn ? `${this.right} of ${this.asked} right` : '');
    }

    pressed(event) {
        if (event.key === 'Escape') this.close();
        else if (/^[1-9]$/.test(event.key) && !this.isAnswered && this.buttons[event.key - 1]) this.answer(event.key - 1);
        else return;
        event.preventDefault();
        event.stopPropagation();
    }
}
