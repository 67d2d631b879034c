// The ray tree as an ARIA tree, of which only the rows in sight exist.

import { byId, LongList, make, setText } from './dom.js';
import { brief, counted } from './format.js';
import { cssOfLinear, lineSample } from './palette.js';

/** How bright a linear colour is. */
function luminance([r, g, b]) {
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** A node's name without what the row says beside it. */
function shortName(name) {
    return name
        .replace(/ at t [^,]*/, '')
        .replace(' ray, hits ', ' \u2192 ')
        .replace(' ray', '');
}

/** The pane. `onNode(index)` hears every node that is chosen. */
export class TreePane {
    constructor({ onNode }) {
        this.onNode = onNode;
        this.host = byId('tree-list');
        this.count = byId('tree-count');
        this.rows = [];
        this.list = new LongList(this.host, 24, (element, i) => this.draw(element, i));
        this.host.addEventListener('click', (event) => this.clicked(event));
        this.host.addEventListener('keydown', (event) => this.pressed(event));
    }

    /** Shows a recording's tree. */
    setPlayer(player) {
        this.player = player;
        // A tree of thousands opens on its first levels.
        const open = player.nodes.length > 3000 ? 5 : Infinity;
        this.closed = new Set(
            player.nodes.filter((node) => node.level >= open && node.children.length).map((node) => node.index),
        );
        this.total = Math.max(1e-12, ...player.nodes.map((node) => (node.contribution ? luminance(node.contribution) : 0)));
        setText(this.count, counted(player.recording.tree.rays, 'ray'));
        this.list.scrollTo(0);
        this.listRows();
    }

    /** Which rows there are: nodes whose ancestors are all open. In predict mode only those that have been reached. */
    listRows() {
        this.rows = [];
        const open = [0];
        while (open.length) {
            const index = open.pop();
            if (this.hidesLater && !this.player.isReached(index, this.step)) continue;
            this.rows.push(index);
            if (!this.closed.has(index)) for (const child of [...this.player.nodes[index].children].reverse()) open.push(child);
        }
        this.places = new Map(this.rows.map((index, row) => [index, row]));
        this.list.show(this.rows.length);
    }

    /** Shows a step and the chosen node. */
    show(step, node, hidesLater) {
        const isHidingChanged = hidesLater !== this.hidesLater;
        this.step = step;
        this.node = node;
        this.hidesLater = hidesLater;
        let opened = false;
        for (let above = this.player.nodes[node].parent; above >= 0; above = this.player.nodes[above].parent) {
            opened = this.closed.delete(above) || opened;
        }
        if (opened || isHidingChanged || hidesLater) this.listRows();
        const row = this.places.get(node) ?? -1;
        this.list.reveal(row);
        this.list.refresh();
        if (row >= 0) this.host.setAttribute('aria-activedescendant', `tree-${node}`);
        else this.host.removeAttribute('aria-activedescendant');
    }

    draw(element, row) {
        const index = this.rows[row];
        const node = this.player.nodes[index];
        const { ray } = node;
        const isReached = this.player.isReached(index, this.step);
        const isFinished = this.player.isFinished(index, this.step);
        const isDecided = this.player.isDecided(index, this.step);
        if (element.dataset.node !== String(index) || element.player !== this.player) this.build(element, node);
        element.className = `long-row${index === this.node ? ' chosen' : ''}${isReached ? '' : ' later'}`;
        element.setAttribute('aria-selected', String(index === this.node));
        const siblings = node.parent < 0 ? [0] : this.player.nodes[node.parent].children;
        element.setAttribute('aria-setsize', siblings.length);
        element.setAttribute('aria-posinset', siblings.indexOf(index) + 1);
        if (node.children.length) element.setAttribute('aria-expanded', String(!this.closed.has(index)));
        else element.removeAttribute('aria-expanded');
        const parts = element.parts;
        setText(parts.twisty, node.children.length ? (this.closed.has(index) ? '\u25b8' : '\u25be') : '');
        const hides = this.hidesLater && !isDecided;
        setText(parts.name, hides ? ray.kind : shortName(node.name));
        const t = ray.hit?.t;
        const weight = ray.weight === undefined ? '' : `w ${brief(Math.max(...ray.weight), 3)}`;
        setText(parts.t, hides || t === undefined ? '' : `t ${brief(t, 3)}`);
        setText(parts.weight, weight);
        const showsColor = ray.radiance && (isFinished || !this.hidesLater);
        parts.bar.style.background = showsColor ? cssOfLinear(ray.radiance) : '';
        const share = node.contribution && showsColor ? luminance(node.contribution) / this.total : 0;
        parts.bar.style.width = share > 0 ? `${Math.max(2, Math.round(Math.min(1, share) * 30))}px` : '0';
        parts.room.classList.toggle('none', !ray.radiance);
        const contribution = node.contribution?.map((c) => brief(c, 3)).join(', ');
        const more = [!hides && contribution && `contributes ${contribution}`, !isReached && 'not reached yet'].filter(Boolean);
        setText(parts.more, more.join(', '));
        element.title = [hides ? ray.kind : node.name, ...more].join('\n');
    }

    build(element, node) {
        element.dataset.node = node.index;
        element.player = this.player;
        element.id = `tree-${node.index}`;
        element.setAttribute('role', 'treeitem');
        element.setAttribute('aria-level', node.level);
        element.style.paddingLeft = `${4 + Math.min(node.level - 1, 14) * 10}px`;
        const parts = {
            twisty: make('span', { class: 'twisty', 'aria-hidden': 'true' }),
            name: make('span', { class: 'fill' }),
            t: make('span', { class: 'number' }),
            weight: make('span', { class: 'number' }),
            bar: make('span', { class: 'share' }),
            more: make('span', { class: 'unseen' }),
        };
        parts.room = make('span', { class: 'share-room' }, parts.bar);
        element.replaceChildren(
            parts.twisty,
            lineSample(node.ray.kind),
            parts.name,
            parts.t,
            parts.weight,
            parts.room,
            parts.more,
        );
        element.parts = parts;
    }

    toggle(index, open) {
        const isOpen = !this.closed.has(index);
        if (!this.player.nodes[index].children.length || isOpen === open) return;
        if (open) this.closed.delete(index);
        else this.closed.add(index);
        this.listRows();
    }

    clicked(event) {
        const row = event.target.closest('.long-row');
        if (!row) return;
        const index = Number(row.dataset.node);
        if (event.target.closest('.twisty')) this.toggle(index, this.closed.has(index));
        else this.onNode(index);
    }

    pressed(event) {
        if (event.ctrlKey || event.metaKey || event.altKey || !this.player) return;
        const row = this.places.get(this.node) ?? 0;
        const node = this.player.nodes[this.rows[row]];
        const go = (to) => {
            if (to >= 0 && to < this.rows.length) this.onNode(this.rows[to]);
        };
        const isOpen = node.children.length > 0 && !this.closed.has(node.index);
        const page = Math.max(1, Math.floor(this.list.viewHeight / 24) - 1);
        switch (event.key) {
            case 'ArrowDown':
                go(row + 1);
                break;
            case 'ArrowUp':
                go(row - 1);
                break;
            case 'PageDown':
                go(Math.min(row + page, this.rows.length - 1));
                break;
            case 'PageUp':
                go(Math.max(row - page, 0));
                break;
            case 'Home':
                go(0);
                break;
            case 'End':
                go(this.rows.length - 1);
                break;
            case 'ArrowRight':
                if (!isOpen) this.toggle(node.index, true);
                else go(row + 1);
                break;
            case 'ArrowLeft':
                if (isOpen) this.toggle(node.index, false);
                else if (node.parent >= 0) go(this.places.get(node.parent));
                break;
            case '*':
                for (const sibling of this.player.nodes[node.parent]?.children ?? [0]) this.closed.delete(sibling);
                this.listRows();
                break;
            case 'Enter':
                this.onNode(node.index);
                break;
            default:
                return;
        }
        event.preventDefault();
        event.stopPropagation();
    }
}
