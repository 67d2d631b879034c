// Elements, tabs, and long lists.

/** An element with attributes and children; `on` holds listeners, `class`, `text` and `data` say what they are. */
export function make(tag, about = {}, ...children) {
    return fill(document.createElement(tag), about, children);
}

/** The same in the namespace of SVG. */
export function makeSvg(tag, about = {}, ...children) {
    return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), about, children);
}

/** The same in the namespace of MathML. */
export function makeMath(tag, about = {}, ...children) {
    return fill(document.createElementNS('http://www.w3.org/1998/Math/MathML', tag), about, children);
}

function fill(element, about, children) {
    for (const [key, value] of Object.entries(about)) {
        if (value === undefined || value === false) continue;
        if (key === 'on') for (const [event, listener] of Object.entries(value)) element.addEventListener(event, listener);
        else if (key === 'text') element.textContent = value;
        else if (key === 'data') Object.assign(element.dataset, value);
        else element.setAttribute(key, value === true ? '' : value);
    }
    element.append(...children.filter((child) => child !== undefined));
    return element;
}

/** Writes a text only where it differs: nothing is laid out anew for nothing. */
export function setText(element, text) {
    if (element.textContent !== text) element.textContent = text;
}

/** The element with this id. */
export function byId(id) {
    return document.getElementById(id);
}

/** A box that goes back to its top when `toTop` is called, without asking the browser where it is. */
export function keepTop(host) {
    let isScrolled = false;
    host.addEventListener('scroll', () => (isScrolled = host.scrollTop !== 0), { passive: true });
    return () => {
        if (isScrolled) host.scrollTop = 0;
        isScrolled = false;
    };
}

/** Only the last of many calls runs, once the calls have paused. */
export function whenQuiet(milliseconds, run) {
    let timer;
    return (...rest) => {
        clearTimeout(timer);
        timer = setTimeout(() => run(...rest), milliseconds);
    };
}

/** Resolves after so many milliseconds. */
export function pause(milliseconds) {
    return new Promise((done) => setTimeout(done, milliseconds));
}

/** Runs after the next frame is on the screen. */
export function afterFrame(run) {
    requestAnimationFrame(() => setTimeout(run));
}

/** Tabs by the pattern of the ARIA practices: arrows move, one tab stop. `chosen` hears the id of the panel. */
export function wireTabs(list, chosen) {
    const tabs = [...list.querySelectorAll('[role=tab]')];
    const choose = (tab, focus) => {
        for (const other of tabs) {
            const isIt = other === tab;
            other.setAttribute('aria-selected', String(isIt));
            other.tabIndex = isIt ? 0 : -1;
        }
        const panels = new Set(tabs.map((other) => other.getAttribute('aria-controls')));
        const id = tab.getAttribute('aria-controls');
        if (panels.size > 1) for (const panel of panels) byId(panel).hidden = panel !== id;
        else byId(id).setAttribute('aria-labelledby', tab.id);
        if (focus) tab.focus();
        chosen?.(tab);
    };
    list.addEventListener('click', (event) => {
        const tab = event.target.closest('[role=tab]');
        if (tab) choose(tab, false);
    });
    list.addEventListener('keydown', (event) => {
        const at = tabs.indexOf(document.activeElement);
        const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key];
        if (at < 0 || to === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        choose(tabs[(to + tabs.length) % tabs.length], true);
    });
    return (id) => choose(byId(id), false);
}

/** A list of rows of one height, of which only those in sight are elements. */
export class LongList {
    /** `draw(element, index)` fills a row, which may have shown another before. */
    constructor(host, rowHeight, draw) {
        this.host = host;
        this.rowHeight = rowHeight;
        this.draw = draw;
        this.count = 0;
        this.rows = [];
        this.room = make('div', { class: 'long-room', role: 'presentation' });
        host.append(this.room);
        // Where it is scrolled to and how high it is are remembered: to ask would lay out the page at once.
        this.scrollTop = 0;
        this.viewHeight = 0;
        host.addEventListener(
            'scroll',
            () => {
                if (this.scrolling) return;
                this.scrollTop = host.scrollTop;
                this.place(false);
            },
            { passive: true },
        );
        new ResizeObserver(([entry]) => {
            this.viewHeight = entry.contentRect.height;
            this.scrollTop = host.scrollTop;
            this.place(false);
            if (this.wanted !== undefined) this.reveal(this.wanted);
        }).observe(host);
    }

    /** Shows so many rows, all drawn anew. */
    show(count) {
        this.count = count;
        this.room.style.height = `${count * this.rowHeight}px`;
        if (this.scrollTop > Math.max(0, count * this.rowHeight - this.viewHeight)) this.scrollTo(0);
        this.place(true);
    }

    /** Draws the rows in sight anew. */
    refresh() {
        this.place(true);
    }

    /** The element of a row, if it is in sight. */
    element(index) {
        return this.rows.find((row) => row.index === index)?.element;
    }

    /** Scrolls no farther than needed until the row is in sight. */
    reveal(index) {
        if (index < 0 || index >= this.count) return;
        // Before it has a size: when it has.
        this.wanted = this.viewHeight ? undefined : index;
        const top = index * this.rowHeight;
        const from = this.scrollTop;
        if (top < from) this.scrollTo(top);
        else if (this.viewHeight && top + this.rowHeight > from + this.viewHeight)
            this.scrollTo(top + this.rowHeight - this.viewHeight);
        this.place(false);
    }

    /** Scrolls, with the next frame: a page that is scrolled is laid out at once. */
    scrollTo(top) {
        if (top === this.scrollTop) return;
        this.scrollTop = top;
        this.scrolling ??= requestAnimationFrame(() => {
            this.scrolling = undefined;
            this.host.scrollTop = this.scrollTop;
        });
    }

    place(isAnew) {
        const first = Math.max(0, Math.floor(this.scrollTop / this.rowHeight) - 4);
        const last = Math.min(this.count, Math.ceil((this.scrollTop + this.viewHeight) / this.rowHeight) + 4);
        const wanted = Math.max(0, last - first);
        while (this.rows.length < wanted) {
            const element = make('div', { class: 'long-row' });
            this.room.append(element);
            this.rows.push({ element, index: -1 });
        }
        while (this.rows.length > wanted) this.rows.pop().element.remove();
        const free = new Map(this.rows.map((row) => [row.index, row]));
        const missing = [];
        for (let index = first; index < last; index += 1) if (!free.delete(index)) missing.push(index);
        const spare = [...this.rows].filter((row) => row.index < first || row.index >= last);
        for (const index of missing) spare.pop().index = -2 - index;
        for (const row of this.rows) {
            const isFresh = row.index < -1;
            if (isFresh) row.index = -2 - row.index;
            if (!isFresh && !isAnew) continue;
            row.element.style.transform = `translateY(${row.index * this.rowHeight}px)`;
            this.draw(row.element, row.index);
        }
        if (!missing.length) return;
        // In the document they stand in the order in which they are seen.
        this.rows.sort((a, b) => a.index - b.index);
        this.rows.forEach((row, i) => {
            const there = this.room.children[i];
            if (there !== row.element) this.room.insertBefore(row.element, there);
        });
    }
}
