// Numbers as text.

/** Six digits that matter, a true minus, no zeros at the end. */
export function brief(x, digits = 6) {
    if (typeof x !== 'number') return String(x);
    if (Number.isNaN(x)) return 'NaN';
    if (!Number.isFinite(x)) return x < 0 ? '\u2212\u221e' : '\u221e';
    if (x === 0) return Object.is(x, -0) ? '\u22120' : '0';
    const size = Math.abs(x);
    let text;
    if (size >= 1e-4 && size < 10 ** digits) {
        text = x.toPrecision(digits);
        if (text.includes('e')) text = String(Number(text));
        else if (text.includes('.')) text = text.replace(/\.?0+$/, '');
    } else {
        text = x
            .toExponential(digits - 1)
            .replace(/\.?0+e/, 'e')
            .replace('e+', 'e');
    }
    return text.replace(/-/g, '\u2212');
}

/** All digits: the shortest decimal that reads back to the same bits. `single` for a number of single precision. */
export function exact(x, single = false) {
    if (typeof x !== 'number' || !Number.isFinite(x)) return brief(x);
    if (Object.is(x, -0)) return '\u22120';
    let text = String(x);
    if (single && Math.fround(x) === x) {
        for (let digits = 1; digits <= 9; digits += 1) {
            const shorter = Number(x.toPrecision(digits));
            if (Math.fround(shorter) === x) {
                text = String(shorter);
                break;
            }
        }
    }
    return text.replace(/-/g, '\u2212').replace('e+', 'e');
}

/** A number, or a vector in parentheses. */
export function briefValue(value, digits = 5) {
    if (Array.isArray(value)) return `(${value.map((x) => brief(x, digits)).join(', ')})`;
    return brief(value, digits);
}

/** A colour's three components with four places, as in the sheets. */
export function colorText(color) {
    return color.map((c) => c.toFixed(4)).join('  ');
}

/** `1 ray`, `2 rays`. */
export function counted(count, one, many = `${one}s`) {
    return `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
}
