// The dialog with the keys.

import { byId, make } from './dom.js';

const KEYS = [
    [
        'Stepping',
        [
            ['s', 'next step'],
            ['b', 'back one step'],
            ['n', 'over: next step of this call'],
            ['o', 'out of this call'],
            ['g', 'to the start'],
            ['e', 'to the end'],
            ['r', 'run until the chosen event'],
            ['u', 'choose an event'],
        ],
    ],
    [
        'Panes',
        [
            ['1', 'picture: arrows choose a pixel'],
            ['2', 'candidates: arrows choose a test'],
            ['3', 'ray tree: arrows choose a ray'],
            ['4', 'pseudocode'],
            ['5', 'diagram: arrows, + and \u2212 move it; 3D: they turn it'],
            ['6', 'arithmetic and changes'],
            ['x', 'enlarge the pane with the focus'],
            ['Esc', 'back to all panes'],
        ],
    ],
    [
        'Page',
        [
            ['p', 'predict, then reveal'],
            ['d', 'light or dark'],
            ['?', 'these keys'],
        ],
    ],
];

/** Wires the dialog; `areKeysOn()` says whether single keys count. */
export function wireHelp() {
    const dialog = byId('help');
    const close = make('button', { type: 'button', text: 'Close', on: { click: () => dialog.close() } });
    const list = make('div', { class: 'help-keys' });
    for (const [title, keys] of KEYS) {
        list.append(make('h3', { text: title }));
        for (const [key, words] of keys) list.append(make('kbd', { text: key }), make('span', { text: words }));
    }
    const toggle = make('input', { type: 'checkbox', checked: true });
    dialog.append(
        make('div', { class: 'help-head' }, make('h2', { id: 'help-title', text: 'Keys' }), close),
        list,
        make('p', { class: 'check' }, make('label', { class: 'check' }, toggle, 'Single keys work anywhere on the page')),
    );
    byId('help-open').addEventListener('click', () => dialog.showModal());
    dialog.addEventListener('click', (event) => {
        if (event.target === dialog) dialog.close();
    });
    return { open: () => dialog.showModal(), areKeysOn: () => toggle.checked && !dialog.open };
}
