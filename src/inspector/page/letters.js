// The letters of a drawing, each label as one path. As the drawings come, every letter is a `use` of an outline: small to
// send, but a browser builds a tree of its own for each, which takes longer than all else that a click does.

/** Outlines by their names, the same in all drawings: where each begins, and the rest from there. */
const OUTLINES = new Map();

/** A number as drawings have it. */
function hundredths(x) {
    return Math.round(x * 100) / 100;
}

/** An outline of absolute moves, lines and curves with all but its first point relative; nothing for another. */
function relative(outline) {
    if (/[^MLQCZ\d\s.,-]/.test(outline)) return undefined;
    const pieces = [...outline.matchAll(/([MLQCZ])([^MLQCZ]*)/g)];
    let [from, at, start] = [undefined, [0, 0], [0, 0]];
    let rest = '';
    for (const [, command, text] of pieces) {
        const numbers = (text.match(/-?\d*\.?\d+/g) ?? []).map(Number);
        if (command === 'Z') at = start;
        const moved = numbers.map((number, i) => hundredths(number - at[i % 2]));
        if (numbers.length) at = numbers.slice(-2);
        if (command === 'M') start = at;
        if (from) rest += command.toLowerCase() + moved.join(' ');
        else from = at;
    }
    return from && { x: from[0], y: from[1], rest };
}

/** The text of a drawing with each run of letters as one path. */
export function joinLetters(svg) {
    for (const [, name, outline] of svg.matchAll(/<path id="([^"]+)" d="([^"]*)"\/>/g))
        if (!OUTLINES.has(name)) OUTLINES.set(name, relative(outline));
    let isWhole = true;
    const joined = svg.replace(
        /<g transform="([^"]+)">((?:<use href="#[^"]+"(?: x="[^"]+")?(?: y="[^"]+")?\/>)+)<\/g>/g,
        (run, transform, uses) => {
            let outline = '';
            for (const [, name, x, y] of uses.matchAll(/href="#([^"]+)"(?: x="([^"]+)")?(?: y="([^"]+)")?/g)) {
                const letter = OUTLINES.get(name);
                if (!letter) {
                    isWhole = false;
                    return run;
                }
                const [left, up] = [letter.x + Number(x ?? 0), letter.y + Number(y ?? 0)].map(hundredths);
                outline += `M${left} ${up}${letter.rest}`;
            }
            return `<path transform="${transform}" d="${outline}"/>`;
        },
    );
    return isWhole && !joined.includes('<use ') ? joined.replace(/<path id="[^"]+" d="[^"]*"\/>\n?/g, '') : joined;
}
