// The letters of a drawing, each label as one path. As the drawings come, every letter is a `use` of an outline: small to
// send, but a browser builds a tree of its own for each, which takes longer than all else that a click does.

/** Outlines by their names, the same in all drawings: `[command, numbers...]` a piece; nothing if it cannot be moved. */
const OUTLINES = new Map();

/** The pieces of an outline of absolute moves, lines and curves. */
function piecesOf(outline) {
    if (/[^MLQCZ\d\s.,-]/.test(outline)) return undefined;
    return [...outline.matchAll(/([MLQCZ])([^MLQCZ]*)/g)].map(([, command, numbers]) => [
        command,
        ...(numbers.match(/-?\d*\.?\d+/g) ?? []).map(Number),
    ]);
}

/** An outline moved to a place. */
function moved(pieces, x, y) {
    let text = '';
    for (const [command, ...numbers] of pieces) {
        text += command;
        for (let i = 0; i < numbers.length; i += 1)
            text += `${i ? ' ' : ''}${Math.round((numbers[i] + (i % 2 ? y : x)) * 100) / 100}`;
    }
    return text;
}

/** The text of a drawing with each run of letters as one path. */
export function joinLetters(svg) {
    for (const [, name, outline] of svg.matchAll(/<path id="([^"]+)" d="([^"]*)"\/>/g))
        if (!OUTLINES.has(name)) OUTLINES.set(name, piecesOf(outline));
    let isWhole = true;
    const joined = svg.replace(
        /<g transform="([^"]+)">((?:<use href="#[^"]+"(?: x="[^"]+")?(?: y="[^"]+")?\/>)+)<\/g>/g,
        (run, transform, uses) => {
            let outline = '';
            for (const [, name, x, y] of uses.matchAll(/href="#([^"]+)"(?: x="([^"]+)")?(?: y="([^"]+)")?/g)) {
                const pieces = OUTLINES.get(name);
                if (!pieces) {
                    isWhole = false;
                    return run;
                }
                outline += moved(pieces, Number(x ?? 0), Number(y ?? 0));
            }
            return `<path transform="${transform}" d="${outline}"/>`;
        },
    );
    return isWhole && !joined.includes('<use ') ? joined.replace(/<path id="[^"]+" d="[^"]*"\/>\n?/g, '') : joined;
}
