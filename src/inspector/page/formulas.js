// Expressions as MathML, in symbols and with numbers. An expression is a name, a number, or [operation, operands...].

import { makeMath } from './dom.js';
import { brief, exact } from './format.js';

const SUM = 1;
const PRODUCT = 2;
const SIGN = 3;
const TIGHT = 4;

/** Names that have a letter of their own. */
const LETTERS = {
    disc: '\u0394',
    alpha: '\u03b1',
    beta: '\u03b2',
    gamma: '\u03b3',
    theta: '\u03b8',
    eta: '\u03b7',
    lambda: '\u03bb',
    delta: '\u0394',
    epsilon: '\u03b5',
    eps: '\u03b5',
    mu: '\u03bc',
    radius: 'r',
    center: 'c',
    centre: 'c',
};

const SIGNS = {
    '+': ['+', SUM],
    '-': ['\u2212', SUM],
    '*': ['\u00b7', PRODUCT],
    dot: ['\u00b7', PRODUCT],
    cross: ['\u00d7', PRODUCT],
};

function operator(sign, about = {}) {
    return makeMath('mo', { text: sign, ...about });
}

function bracketed(inside, open = '(', close = ')') {
    if (inside.localName === 'mn') {
        inside.textContent = open + inside.textContent + close;
        return inside;
    }
    return makeMath('mrow', {}, operator(open, { stretchy: 'true' }), inside, operator(close, { stretchy: 'true' }));
}

function letter(word, isVector) {
    const text = LETTERS[word] ?? word;
    const about = { text };
    if (isVector) about.class = 'vector';
    else if ([...text].length > 1) about.class = 'word';
    return makeMath('mi', about);
}

/** The symbol of a name: `l_dot_l` is a product, what follows another underscore stands below. */
export function symbol(name, isVector = false) {
    const product = /^(\w+?)_dot_(\w+)$/.exec(name);
    if (product) return makeMath('mrow', {}, letter(product[1], true), operator('\u00b7'), letter(product[2], true));
    const cut = name.indexOf('_');
    if (cut > 0 && cut < name.length - 1) {
        const below = name
            .slice(cut + 1)
            .replaceAll('_', ' ')
            .replace(/^-/, '\u2212');
        return makeMath('msub', {}, letter(name.slice(0, cut), isVector), makeMath('mi', { class: 'word', text: below }));
    }
    const numbered = /^([a-z])(\d)$/.exec(name);
    if (numbered) return makeMath('msub', {}, letter(numbered[1], isVector), makeMath('mn', { text: numbered[2] }));
    return letter(name, isVector);
}

/** A power of ten in the text of a number. */
const POWER = /^(\u2212?)([\d.]+)e(\u2212?\d+)$/;

/** A number: one element where it can be one, since laying out formulas takes longer than all else on the page. */
function numberElement(x, write) {
    const text = write(x);
    const [, sign, mantissa, exponent] = POWER.exec(text) ?? [];
    if (mantissa === undefined) return makeMath('mn', { text });
    const ten = makeMath('msup', {}, makeMath('mn', { text: '10' }), makeMath('mn', { text: exponent }));
    return makeMath('mrow', {}, makeMath('mn', { text: sign + mantissa }), operator('\u00b7'), ten);
}

/** A number, or a vector with commas between its components. */
export function valueElement(value, write) {
    if (!Array.isArray(value)) return numberElement(value, write);
    const texts = value.map(write);
    if (!texts.some((text) => POWER.test(text))) return makeMath('mn', { text: `(${texts.join(',\u2005')})` });
    const row = makeMath('mrow', {}, operator('(', { stretchy: 'false' }));
    value.forEach((x, i) => {
        if (i) row.append(operator(',', { separator: 'true' }));
        row.append(numberElement(x, write));
    });
    row.append(operator(')', { stretchy: 'false' }));
    return row;
}

/**
 * Draws an expression; `leaf` says what stands for a name, `component` for one of its components, `write` how a number is
 * written.
 */
function drawExpression(expression, needed, leaf, write, component) {
    if (typeof expression === 'string') return leaf(expression, needed);
    if (typeof expression === 'number') {
        const drawn = numberElement(expression, write);
        return expression < 0 && needed > SUM ? bracketed(drawn) : drawn;
    }
    const [name, ...operands] = expression;
    const draw = (operand, at) => drawExpression(operand, at, leaf, write, component);
    const isOfVectors = name === 'dot' || name === 'cross';
    if (SIGNS[name] && operands.length === 2) {
        const [sign, binding] = SIGNS[name];
        const [a, b] = operands;
        const into = (operand) => {
            const isProductOfVectors = Array.isArray(operand) && (operand[0] === 'dot' || operand[0] === 'cross');
            return isOfVectors || (isProductOfVectors && binding === PRODUCT) ? TIGHT : binding;
        };
        const row = makeMath('mrow', {}, draw(a, into(a)), operator(sign), draw(b, Math.max(into(b), binding + 1)));
        return binding < needed ? bracketed(row) : row;
    }
    switch (name) {
        case '/':
            return makeMath('mfrac', {}, draw(operands[0], 0), draw(operands[1], 0));
        case 'neg': {
            const row = makeMath('mrow', {}, operator('\u2212', { form: 'prefix' }), draw(operands[0], TIGHT));
            return needed >= SIGN ? bracketed(row) : row;
        }
        case 'sqrt':
            return makeMath('msqrt', {}, draw(operands[0], 0));
        case 'abs':
            return bracketed(draw(operands[0], 0), '|', '|');
        case 'pow':
            return makeMath('msup', {}, draw(operands[0], TIGHT), draw(operands[1], 0));
        case 'x':
        case 'y':
        case 'z':
            return (
                component(operands[0], name, needed) ??
                makeMath('msub', {}, draw(operands[0], TIGHT), makeMath('mi', { text: name }))
            );
        case 'if<': {
            const [a, b, yes, no] = operands.map((operand) => draw(operand, 0));
            const words = (text) => makeMath('mtext', { text });
            const condition = makeMath('mrow', {}, words('if\u00a0'), a, operator('<'), b);
            const row = (...cells) => makeMath('mtr', {}, ...cells.map((cell) => makeMath('mtd', {}, cell)));
            const table = makeMath('mtable', { class: 'cases' }, row(yes, condition), row(no, words('otherwise')));
            return makeMath('mrow', {}, operator('{', { stretchy: 'true', form: 'prefix' }), table);
        }
        default: {
            const row = makeMath('mrow', {});
            operands.forEach((operand, i) => {
                if (i) row.append(operator(',', { separator: 'true' }));
                row.append(draw(operand, 0));
            });
            return makeMath(
                'mrow',
                {},
                makeMath('mi', { class: 'word', text: name === 'f32' ? 'single' : name }),
                bracketed(row),
            );
        }
    }
}

function sameTree(a, b) {
    return (
        a === b || (Array.isArray(a) && Array.isArray(b) && a.length === b.length && a.every((part, i) => sameTree(part, b[i])))
    );
}

/** One line of a form as up to three pieces: name and symbols, numbers, value. `values` may lack what never came to be. */
export function drawLine(line, values, options) {
    const write = options.allDigits ? (x) => exact(x, options.single) : (x) => brief(x, 5);
    const isVector = (name) => Array.isArray(values[name]);
    const symbolOfPart = (name, axis) => {
        if (typeof name !== 'string' || name.includes('_')) return undefined;
        return makeMath('msub', {}, letter(name, false), makeMath('mi', { text: axis }));
    };
    const numberOfPart = (name, axis, needed) => {
        const x = values[name]?.['xyz'.indexOf(axis)];
        if (typeof x !== 'number') return undefined;
        const drawn = numberElement(x, write);
        return needed > SUM && (x < 0 || Object.is(x, -0)) ? bracketed(drawn) : drawn;
    };
    const inSymbols = (name) => symbol(name, isVector(name));
    const inNumbers = (name, needed) => {
        const value = values[name];
        if (value === undefined) return symbol(name);
        const drawn = valueElement(value, write);
        return typeof value === 'number' && (value < 0 || Object.is(value, -0)) && needed > SUM ? bracketed(drawn) : drawn;
    };
    const piece = (className, ...parts) => makeMath('math', { class: className }, makeMath('mrow', {}, ...parts));
    const pieces = [];
    const product = /^(\w+?)_dot_(\w+)$/.exec(line.name);
    if (product && sameTree(line.expression, ['dot', product[1], product[2]])) {
        // The symbol says already what is computed.
        pieces.push(piece('in-symbols', symbol(line.name)));
        if (values[line.name] !== undefined) {
            pieces.push(piece('in-numbers', operator('='), drawExpression(line.expression, 0, inNumbers, write, numberOfPart)));
        }
    } else if (line.expression !== undefined) {
        const drawn = drawExpression(line.expression, 0, inSymbols, write, symbolOfPart);
        pieces.push(piece('in-symbols', symbol(line.name, isVector(line.name)), operator('='), drawn));
        const isPlain = typeof line.expression === 'string' || typeof line.expression === 'number';
        if (!isPlain && values[line.name] !== undefined) {
            pieces.push(piece('in-numbers', operator('='), drawExpression(line.expression, 0, inNumbers, write, numberOfPart)));
        }
    } else {
        pieces.push(piece('in-symbols', symbol(line.name, isVector(line.name))));
    }
    if (values[line.name] !== undefined && !sameTree(line.expression, values[line.name])) {
        pieces.push(piece('in-value', operator('='), valueElement(values[line.name], write)));
    }
    return pieces;
}

/** A value by its name: `o = (0, 1, 5)`. */
export function drawInput(name, value, options) {
    const write = options.allDigits ? (x) => exact(x, options.single) : (x) => brief(x, 5);
    return makeMath('math', {}, symbol(name, Array.isArray(value)), operator('='), valueElement(value, write));
}

/** The names that an expression needs. */
export function namesIn(expression, into = new Set()) {
    if (typeof expression === 'string') into.add(expression);
    else if (Array.isArray(expression)) for (const operand of expression.slice(1)) namesIn(operand, into);
    return into;
}
