// Where a value stands in a JSON text, and the text with another value there. Everything else keeps its form.

/** Reads a JSON text into `{ start, end, value, parts }`, `parts` by key or index; undefined where it is not JSON. */
export function readSpans(text) {
    let at = 0;
    const space = () => {
        while (at < text.length && ' \t\r\n'.includes(text[at])) at += 1;
    };
    const fail = () => {
        throw new SyntaxError(`at ${at}`);
    };
    const string = () => {
        const start = at;
        if (text[at] !== '"') fail();
        for (at += 1; at < text.length && text[at] !== '"'; at += 1) if (text[at] === '\\') at += 1;
        if (at >= text.length) fail();
        at += 1;
        return JSON.parse(text.slice(start, at));
    };
    const many = (close, one) => {
        at += 1;
        space();
        while (text[at] !== close) {
            one();
            space();
            if (text[at] === ',') at += 1;
            else if (text[at] !== close) fail();
            space();
        }
        at += 1;
    };
    const value = () => {
        space();
        const start = at;
        if (text[at] === '{') {
            const parts = {};
            const entries = {};
            many('}', () => {
                const key = string();
                space();
                if (text[at] !== ':') fail();
                at += 1;
                parts[key] = value();
                entries[key] = parts[key].value;
            });
            return { start, end: at, value: entries, parts };
        }
        if (text[at] === '[') {
            const parts = [];
            many(']', () => parts.push(value()));
            return { start, end: at, value: parts.map((part) => part.value), parts };
        }
        if (text[at] === '"') return { value: string(), start, end: at };
        const word = /^[-+.\w]+/.exec(text.slice(at, at + 40))?.[0];
        if (!word) fail();
        at += word.length;
        return { start, end: at, value: JSON.parse(word) };
    };
    try {
        const all = value();
        space();
        return at === text.length ? all : undefined;
    } catch {
        return undefined;
    }
}

/** The part of what `readSpans` gave at a path of keys and indices. */
export function partAt(spans, path) {
    return path.reduce((part, key) => part?.parts?.[key], spans);
}

/** The text with `value` at a path that exists. A new key goes to the end of an object that exists. */
export function withValue(text, path, value) {
    const spans = readSpans(text);
    const part = partAt(spans, path);
    const written = Array.isArray(value) ? `[${value.map((x) => JSON.stringify(x)).join(', ')}]` : JSON.stringify(value);
    if (part) return text.slice(0, part.start) + written + text.slice(part.end);
    const object = partAt(spans, path.slice(0, -1));
    if (!object) return text;
    const inside = text.slice(object.start, object.end - 1).trimEnd();
    const comma = inside.length > 1 ? ', ' : ' ';
    const key = JSON.stringify(path[path.length - 1]);
    return `${text.slice(0, object.start)}${inside}${comma}${key}: ${written} ${text.slice(object.end - 1)}`;
}
