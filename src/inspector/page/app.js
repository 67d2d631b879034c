// The page: one selection (pixel, step, ray) that all panes show, the address that holds it, and the keys.

import { openApi } from './api.js';
import { CodePane } from './code-pane.js';
import { Controls, EVENTS } from './controls.js';
import { DiagramPane } from './diagram-pane.js';
import { byId, make, makeSvg, pause, setText, whenQuiet } from './dom.js';
import { wireHelp } from './help.js';
import { NumbersPane } from './numbers-pane.js';
import { Player } from './player.js';
import { Predictor } from './predict.js';
import { RenderPane } from './render-pane.js';
import { TestsPane } from './tests-pane.js';
import { TreePane } from './tree-pane.js';
import { View3d } from './view3d.js';
import { WhatIf } from './whatif.js';

/** Milliseconds that a recording waits for the diagram drawn beside it. */
const TOGETHER = 40;

const SUN =
    'M8 1v2M8 13v2M1 8h2M13 8h2M3 3l1.4 1.4M11.6 11.6 13 13M13 3l-1.4 1.4M4.4 11.6 3 13' + 'M11 8a3 3 0 1 1-6 0 3 3 0 0 1 6 0z';
const MOON = 'M13 9.5A5.5 5.5 0 0 1 6.5 3a5.5 5.5 0 1 0 6.5 6.5z';

class Inspector {
    constructor() {
        this.api = openApi();
        this.render = new RenderPane({
            onPixel: (x, y, isPassing, isArrow) => this.wishPixel(x, y, isPassing, isArrow),
            onOverlay: (kind) => this.showOverlay(kind),
        });
        this.tree = new TreePane({ onNode: (node) => this.chooseNode(node) });
        this.tests = new TestsPane({ onTest: (node, test) => this.chooseTest(node, test) });
        this.code = new CodePane({ onStep: (step) => this.goTo(step) });
        this.numbers = new NumbersPane();
        this.diagram = new DiagramPane(this.api, {
            onNode: (node) => this.chooseNode(node),
            onSpace: (isOn) => this.showSpace(isOn),
        });
        this.controls = new Controls({
            onMove: (how) => this.move(how),
            onStep: (step) => this.goTo(step),
            onUntil: (event, argument) => this.runUntil(event, argument),
        });
        this.predictor = new Predictor({
            onReveal: (step) => this.goTo(step),
            onNext: () => this.move('into'),
            onSwitch: () => this.player && this.present(),
        });
        this.whatIf = new WhatIf({
            canTrace: this.api.canTrace,
            onChange: (wanted) => this.retrace(wanted),
            onNode: (node) => this.chooseNode(node),
        });
        this.help = wireHelp();
        this.saveAddress = whenQuiet(150, () => this.writeAddress());
        byId('growing').addEventListener('change', () => this.showSpaceStep());
        this.addEnlarging();
        this.wireTheme();
        document.addEventListener('keydown', (event) => this.pressed(event));
        addEventListener('hashchange', () => this.openAddress());
    }

    async start() {
        try {
            const scene = await this.api.scene();
            this.whatIf.start(scene);
            this.setScene(scene);
            this.startRender();
            if (!this.api.canTrace) this.render.markKept(this.api.pixels());
            await this.openAddress(true);
        } catch (error) {
            this.wall(error);
        }
    }

    wall(error) {
        const retry = make('button', { type: 'button', text: 'Try again', on: { click: () => location.reload() } });
        document.body.append(
            make(
                'div',
                { class: 'wall', role: 'alert' },
                make('strong', { text: 'The server does not answer.' }),
                make('span', { text: String(error.message) }),
                make('span', {}, retry),
            ),
        );
    }

    setScene(scene, keepsPicture) {
        this.scene = scene;
        this.geometry = undefined;
        setText(byId('scene-name'), scene.file);
        byId('scene-name').title = scene.about ?? scene.file;
        document.title = `${scene.file.split('/').pop()} \u2013 raytree`;
        const { numerics, precision, max_depth: depth } = scene.settings;
        setText(byId('settings'), `${numerics} kernels in ${precision}, max_depth ${depth}`);
        byId('export').hidden = !this.api.canTrace;
        this.render.setScene(scene, keepsPicture);
    }

    // Data

    /** Runs with the scene's id, which the server may have forgotten: then the text is sent again. */
    async withScene(run) {
        try {
            return await run(this.scene);
        } catch (error) {
            if (error.status !== 404 || !this.api.canTrace) throw error;
            const { text, settings } = this.whatIf.now;
            const scene = await this.api.trace(text, settings);
            this.scene = { ...this.scene, id: scene.id };
            return run(this.scene);
        }
    }

    async startRender() {
        this.renderStop?.abort();
        this.renderStop = new AbortController();
        const { signal } = this.renderStop;
        try {
            await this.withScene((scene) =>
                this.api.render(
                    scene,
                    (y, rows, bytes) => {
                        if (!signal.aborted) this.render.rows(y, rows, bytes);
                    },
                    signal,
                ),
            );
            if (!signal.aborted) {
                document.dispatchEvent(new CustomEvent('raytree-rendered'));
                this.space?.pictureChanged();
            }
        } catch (error) {
            if (!signal.aborted) this.say(`The picture stopped: ${error.message}`);
        }
    }

    async showOverlay(kind) {
        this.overlayStop?.abort();
        this.overlayStop = new AbortController();
        const { signal } = this.overlayStop;
        this.render.heat.clear();
        this.render.magnify();
        if (!kind) return;
        const { width, height } = this.scene.image;
        this.render.heat.start(kind, width, height);
        try {
            await this.withScene((scene) =>
                this.api.overlay(
                    scene,
                    kind,
                    (y, rows, values) => {
                        if (!signal.aborted) this.render.heat.rows(y, rows, values);
                    },
                    signal,
                ),
            );
            this.render.magnify();
        } catch (error) {
            if (!signal.aborted) this.say(error.message);
        }
    }

    /** Chooses a pixel; in an exported page the one that is kept and lies nearest. */
    wishPixel(x, y, isPassing, isArrow) {
        const pixel = this.api.keepsPixel(x, y) ? [x, y] : this.api.nearestKept([x, y], this.pixel, isArrow);
        if (this.api.canTrace || pixel.join() !== this.pixel.join()) this.choosePixel(...pixel, { isPassing });
    }

    /** Chooses a pixel: one recording is under way at a time, and only the newest wish waits. */
    async choosePixel(x, y, { isPassing, step, node, keepsPlace } = {}) {
        this.wish = { x, y, isPassing, step, node, keepsPlace };
        this.render.choose(x, y, !this.isFetching);
        if (this.isFetching) return;
        this.isFetching = true;
        try {
            while (this.wish) {
                const wish = this.wish;
                this.wish = undefined;
                if (wish.step === undefined && wish.node === undefined && !wish.keepsPlace) this.guessDiagram(wish);
                const recording = await this.withScene((scene) => this.api.recording(scene.id, wish.x, wish.y));
                // All panes change in one frame, unless the diagram takes much longer than the recording.
                await Promise.race([this.diagram.guessed?.done, pause(TOGETHER)]);
                await this.showRecording(recording, wish);
            }
        } catch (error) {
            this.wish = undefined;
            if (this.pixel) this.render.choose(...this.pixel);
            this.say(error.message);
            if (!this.player) throw error;
        } finally {
            this.isFetching = false;
        }
    }

    /** Has the diagram drawn while the recording is made: the camera ray shows the same step as the last one did. */
    guessDiagram({ x, y }) {
        if (!this.player) return;
        const place = { 0: 'start', [this.player.steps.length - 1]: 'end' }[this.step];
        this.diagram.guess(this.scene.id, [x, y], place);
    }

    async showRecording(recording, { x, y, isPassing, step, node, keepsPlace }) {
        const before = this.player && {
            step: this.step,
            last: this.player.steps.length - 1,
            path: this.player.nodes[this.node].path,
        };
        const player = new Player(recording);
        this.player = player;
        this.pixel = [x, y];
        this.predictor.reset();
        this.render.choose(x, y);
        this.render.showColor(recording.tree.color, recording.tree.rays);
        for (const pane of [this.tree, this.tests, this.code, this.numbers, this.controls]) pane.setPlayer(player);
        this.diagram.setPlayer(player, this.scene.id, this.pixel);
        this.space?.setPlayer(player);
        const kept = this.api.pixels?.() ?? [...this.scene.pixels.map((pixel) => [pixel.x, pixel.y])];
        const pixels = kept.some(([a, b]) => a === x && b === y) ? kept : [...kept, this.pixel];
        if (this.api.canTrace) byId('export').href = this.api.exportAddress(this.scene.id, pixels);
        // At the start and at the end one stays there; elsewhere the camera ray's winning test is shown.
        let place = player.placeOf(0);
        if (before && before.step === 0) place = 0;
        else if (before && before.step === before.last) place = player.steps.length - 1;
        if (keepsPlace && before) {
            const same = player.byPath.get(before.path);
            if (same !== undefined && player.placeOf(same) >= 0) place = player.placeOf(same);
        }
        const named = node === undefined ? undefined : player.byPath.get(node);
        if (named !== undefined && step === undefined && player.placeOf(named) >= 0) place = player.placeOf(named);
        if (step !== undefined && step >= 1 && step <= player.steps.length) place = step - 1;
        this.step = Math.max(0, place);
        this.node =
            named !== undefined && (step !== undefined || player.placeOf(named) < 0) ? named : player.steps[this.step].node;
        this.isPushing = !isPassing;
        await this.present();
    }

    /** Traces a changed scene; resolves with the problem, if it has one. */
    async retrace({ text, settings }) {
        let scene;
        try {
            scene = await this.api.trace(text, settings);
        } catch (error) {
            if (error.problem) return error.problem;
            this.say(error.message);
            return { message: error.message };
        }
        this.setScene(scene, true);
        this.whatIf.setScene(scene);
        const { width, height } = scene.image;
        const [x, y] = this.pixel.map((v, k) => Math.min(v, [width, height][k] - 1));
        await this.choosePixel(x, y, { isPassing: true, keepsPlace: true });
        this.startRender();
        if (byId('overlay').value) this.showOverlay(byId('overlay').value);
        if (this.diagram.kind === '3d') this.showSpace(true);
        await this.compare();
        return undefined;
    }

    async compare() {
        if (!this.whatIf.isChanged) {
            this.whatIf.showDifference(undefined, this.player);
            return;
        }
        try {
            const difference = await this.api.difference(this.scene.id, this.whatIf.firstId, ...this.pixel);
            this.whatIf.showDifference(difference, this.player);
        } catch (error) {
            this.say(`No difference: ${error.message}`);
        }
    }

    // The selection

    goTo(step) {
        this.step = Math.max(0, Math.min(this.player.steps.length - 1, step));
        this.node = this.player.steps[this.step].node;
        this.present();
    }

    chooseNode(node) {
        const place = this.player.placeOf(node);
        if (place >= 0 && !(this.predictor.isOn && !this.player.isReached(node, this.step))) this.step = place;
        this.node = node;
        this.present();
    }

    chooseTest(node, test) {
        const places = this.player.testSteps[node].get(test);
        if (places) this.goTo(places[places.length - 1]);
    }

    move(how) {
        if (!this.player || this.predictor.isOpen) {
            this.predictor.card.querySelector('button:not(:disabled)')?.focus();
            return;
        }
        const last = this.player.steps.length - 1;
        const to = { start: () => 0, end: () => last }[how]?.() ?? this.player[how](this.step);
        const isForward = how === 'into' || how === 'over' || how === 'out';
        if (isForward && to !== this.step && this.predictor.wantsToAsk(this.player.steps, to)) {
            this.predictor.ask(to, this.player.steps[to].question);
            return;
        }
        this.goTo(to);
    }

    runUntil(event, argument) {
        const to = this.player.until(this.step, event, argument);
        if (to < 0) {
            const words = EVENTS.find(([name]) => name === event)[1];
            this.say(`No later step: ${words}${argument === undefined ? '' : ` ${argument}`}. Still at step ${this.step + 1}.`);
            return;
        }
        this.goTo(to);
    }

    /** Shows the selection in all panes; resolves when the diagram is there too. */
    async present() {
        const { step, node, player } = this;
        const hidesLater = this.predictor.isOn;
        // Asked for first: the server draws while the panes are filled.
        const drawn = this.diagram.show(step, node, hidesLater);
        this.controls.show(step, this.words(), hidesLater);
        this.code.show(step);
        this.tree.show(step, node, hidesLater);
        this.tests.show(step, node, hidesLater);
        this.numbers.show(step);
        this.showSpaceStep();
        this.status();
        this.saveAddress();
        const mark = { pixel: this.pixel, step };
        await drawn;
        if (this.step !== step || this.player !== player) return;
        document.dispatchEvent(new CustomEvent('raytree-shown', { detail: mark }));
        this.prefetchSoon ??= whenQuiet(30, () => {
            const next = this.player.into(this.step);
            this.diagram.prefetch(next, this.player.steps[next].node);
        });
        this.prefetchSoon();
    }

    words() {
        const { node, line, verdict } = this.player.steps[this.step];
        const code = this.player.pseudocode[line];
        return [code?.procedure, this.nodeName(node), verdict?.words].filter(Boolean).join(', ');
    }

    /** What a ray is and what became of it; while one predicts, only what is known already. */
    nodeName(node) {
        const { name, ray } = this.player.nodes[node];
        return this.predictor.isOn && !this.player.isDecided(node, this.step) ? `${ray.kind} ray` : name;
    }

    status() {
        const { node, line, verdict } = this.player.steps[this.step];
        const parts = [make('b', { text: this.player.pseudocode[line]?.procedure ?? '' }), `  ${this.nodeName(node)}`];
        if (verdict)
            parts.push('  \u2013  ', make('span', { class: verdict.ok ? 'good-word' : 'bad-word', text: verdict.words }));
        byId('status').replaceChildren(...parts);
    }

    say(words) {
        byId('status').replaceChildren(make('b', { text: words }));
    }

    // The address

    writeAddress() {
        const path = this.player.nodes[this.node].path;
        const hash = `#pixel=${this.pixel.join(',')}&node=${path}&step=${this.step + 1}`;
        if (location.hash === hash) return;
        this.ownHash = hash;
        const isNewPixel = this.isPushing && location.hash && !location.hash.startsWith(`#pixel=${this.pixel.join(',')}&`);
        this.isPushing = false;
        if (isNewPixel) history.pushState(null, '', hash);
        else history.replaceState(null, '', hash);
    }

    /** Opens what the address says; at first something else if it says nothing. */
    async openAddress(isFirst) {
        if (!isFirst && location.hash === this.ownHash) return;
        const said = new URLSearchParams(location.hash.slice(1));
        const { width, height } = this.scene.image;
        const at = /^(\d+),(\d+)$/.exec(said.get('pixel') ?? '');
        let pixel = at ? [Number(at[1]), Number(at[2])] : undefined;
        if (pixel && !(pixel[0] < width && pixel[1] < height)) pixel = undefined;
        const kept = this.api.pixels?.();
        if (pixel && kept && !this.api.keepsPixel(...pixel)) pixel = undefined;
        if (!pixel && !isFirst) return;
        const named = this.scene.pixels.map((one) => [one.x, one.y]).find((one) => this.api.keepsPixel(...one));
        const first = named ?? kept?.[0] ?? [width >> 1, height >> 1];
        const step = pixel && said.get('step') ? Number(said.get('step')) : undefined;
        const node = pixel ? (said.get('node') ?? undefined) : undefined;
        await this.choosePixel(...(pixel ?? first), { isPassing: true, step, node });
    }

    // 3D

    async showSpace(isOn) {
        if (!isOn || !this.scene) return;
        const host = byId('space');
        if (!this.space) {
            this.space = new View3d(host, { onNode: (node) => this.chooseNode(node), picture: byId('render') });
            this.space.setPlayer(this.player);
        }
        if (!this.space.isThere) {
            this.space = undefined;
            byId('view-3d').disabled = true;
            byId('view-3d').title = 'This browser has no WebGL2';
            this.diagram.choose('view-section');
            this.say('This browser has no WebGL2: here is the section instead.');
            return;
        }
        if (!this.geometry) this.geometry = await this.withScene((scene) => this.api.geometry(scene.id));
        if (this.space.geometry !== this.geometry) this.space.setScene(this.scene, this.geometry);
        this.showSpaceStep();
    }

    showSpaceStep() {
        if (!this.space || !this.player || this.diagram.kind !== '3d') return;
        this.space.show(this.step, this.node, byId('growing').checked || this.predictor.isOn);
    }

    // The frame

    addEnlarging() {
        for (const pane of document.querySelectorAll('.pane')) {
            const path = makeSvg('path', {
                d: 'M2 6V2h4M14 10v4h-4M2 2l5 5M14 14l-5-5',
                fill: 'none',
                stroke: 'currentColor',
                'stroke-width': 1.5,
            });
            const icon = makeSvg('svg', { width: 14, height: 14, viewBox: '0 0 16 16', 'aria-hidden': 'true' }, path);
            const button = make(
                'button',
                {
                    type: 'button',
                    class: 'enlarge',
                    'aria-pressed': 'false',
                    title: 'Enlarge (x)',
                    'aria-label': 'Enlarge this pane',
                },
                icon,
            );
            button.addEventListener('click', () => this.enlarge(pane));
            pane.querySelector('.pane-head').append(button);
        }
    }

    enlarge(pane) {
        for (const other of document.querySelectorAll('.pane')) {
            const isLarge = other === pane && !other.classList.contains('large');
            other.classList.toggle('large', isLarge);
            other.querySelector('.enlarge').setAttribute('aria-pressed', String(isLarge));
        }
    }

    wireTheme() {
        const dark = matchMedia('(prefers-color-scheme: dark)');
        const button = byId('theme');
        const apply = (theme) => {
            document.documentElement.dataset.theme = theme;
            button.setAttribute('aria-pressed', String(theme === 'dark'));
            const d = theme === 'dark' ? SUN : MOON;
            const path = makeSvg('path', {
                d,
                fill: 'none',
                stroke: 'currentColor',
                'stroke-width': 1.5,
                'stroke-linecap': 'round',
                'stroke-linejoin': 'round',
            });
            button.replaceChildren(
                makeSvg('svg', { width: 16, height: 16, viewBox: '0 0 16 16', 'aria-hidden': 'true' }, path),
            );
            if (!this.player) return;
            this.controls.drawTimeline();
            this.render.heat.draw();
            this.present();
        };
        let isChosen = false;
        try {
            const kept = localStorage.getItem('raytree-theme');
            isChosen = kept === 'dark' || kept === 'light';
            apply(isChosen ? kept : dark.matches ? 'dark' : 'light');
        } catch {
            apply(dark.matches ? 'dark' : 'light');
        }
        dark.addEventListener('change', () => !isChosen && apply(dark.matches ? 'dark' : 'light'));
        this.switchTheme = () => {
            isChosen = true;
            const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
            try {
                localStorage.setItem('raytree-theme', theme);
            } catch {
                // A page without storage forgets.
            }
            apply(theme);
        };
        button.addEventListener('click', this.switchTheme);
    }

    pressed(event) {
        if (event.ctrlKey || event.metaKey || event.altKey || !this.player) return;
        if (event.key === 'Escape') {
            this.enlarge(undefined);
            return;
        }
        const isTyping = event.target.closest('textarea, select, input[type="number"]');
        if (isTyping || !this.help.areKeysOn()) return;
        const focus = (id) => () => byId(id).focus();
        const run = {
            s: () => this.move('into'),
            b: () => this.move('back'),
            n: () => this.move('over'),
            o: () => this.move('out'),
            g: () => this.move('start'),
            e: () => this.move('end'),
            r: () => byId('until').requestSubmit(),
            u: focus('until-event'),
            1: focus('stage'),
            2: focus('tests-list'),
            3: focus('tree-list'),
            4: focus('code-lines'),
            6: focus('arithmetic'),
            5: () => (this.diagram.kind === '3d' ? this.space.canvas : byId('view-body')).focus(),
            p: () => byId('predict').click(),
            d: this.switchTheme,
            '?': this.help.open,
            x: () => this.enlarge(document.activeElement.closest('.pane') ?? byId('view')),
        }[event.key];
        if (!run) return;
        event.preventDefault();
        run();
    }
}

new Inspector().start();
