// A recording to step through: the tree as a list of nodes, the call stack as a fold of the steps, events to run to.

/** The children of a ray in the order in which they were traced. */
function childrenOf(node) {
    return [...(node.shadows ?? []), node.reflected, node.refracted].filter(Boolean);
}

/** A recording with what can be asked of it at each step. */
export class Player {
    constructor(recording) {
        this.recording = recording;
        this.steps = recording.steps;
        this.pseudocode = recording.pseudocode;
        this.forms = recording.forms ?? {};
        this.listNodes();
        this.foldFrames();
        this.findPlaces();
    }

    listNodes() {
        this.nodes = [];
        const open = [{ ray: this.recording.tree.root, parent: -1, level: 1 }];
        while (open.length) {
            const { ray, parent, level } = open.pop();
            const index = this.nodes.length;
            const told = this.recording.nodes[index];
            const children = childrenOf(ray);
            this.nodes.push({ ...told, values: told?.values ?? {}, index, ray, parent, level, children: [] });
            if (parent >= 0) this.nodes[parent].children.push(index);
            for (const child of children.reverse()) open.push({ ray: child, parent: index, level: level + 1 });
        }
        this.byPath = new Map(this.nodes.map((node) => [node.path, node.index]));
    }

    /** Which frame each step runs in, and how deep the stack is there. */
    foldFrames() {
        const count = this.steps.length;
        this.frames = [];
        this.frameOf = new Int32Array(count);
        this.depthOf = new Int32Array(count);
        let current = -1;
        for (let k = 0; k < count; k += 1) {
            const step = this.steps[k];
            if (step.call !== undefined) {
                const depth = current < 0 ? 1 : this.frames[current].depth + 1;
                this.frames.push({ procedure: step.call, node: step.node, parent: current, depth, sets: [], start: k });
                current = this.frames.length - 1;
            }
            this.frameOf[k] = current;
            this.depthOf[k] = current < 0 ? 0 : this.frames[current].depth;
            if (step.set && current >= 0) this.frames[current].sets.push(k);
            if (step.return && current >= 0) {
                this.frames[current].end = k;
                current = this.frames[current].parent;
            }
        }
    }

    /** Where each node begins, ends, and has its verdict; where each of its tests stands. */
    findPlaces() {
        const count = this.nodes.length;
        this.firstStep = new Int32Array(count).fill(-1);
        this.lastStep = new Int32Array(count).fill(-1);
        this.verdictStep = new Int32Array(count).fill(-1);
        this.decidedStep = new Int32Array(count).fill(-1);
        this.testSteps = Array.from({ length: count }, () => new Map());
        this.steps.forEach((step, k) => {
            const n = step.node;
            if (this.firstStep[n] < 0) this.firstStep[n] = k;
            this.lastStep[n] = k;
            if (step.test === undefined) return;
            if (!this.testSteps[n].has(step.test)) this.testSteps[n].set(step.test, []);
            this.testSteps[n].get(step.test).push(k);
            this.decidedStep[n] = k;
            const test = this.nodes[n].ray.tests?.[step.test];
            if (test?.shape?.verdict === 'best' && step.arithmetic) this.verdictStep[n] = k;
        });
    }

    /** The step to show for a node: its winning test, else its last test, else where it begins. -1 if it never runs. */
    placeOf(node) {
        for (const places of [this.verdictStep, this.decidedStep, this.firstStep]) if (places[node] >= 0) return places[node];
        return -1;
    }

    /** Whether a node has been reached. Untraced ones are reached with the parent's last step before the next node. */
    isReached(node, step) {
        const first = this.firstStep[node];
        if (first >= 0) return first <= step;
        const parent = this.nodes[node].parent;
        return parent >= 0 && this.lastStep[parent] <= step;
    }

    /** Whether a node's ray has been intersected with everything. */
    isDecided(node, step) {
        const last = this.decidedStep[node];
        if (last < 0) return this.isReached(node, step);
        return last <= step;
    }

    /** The `t` of the best hit of a node among its tests up to a step. */
    bestSoFar(node, step) {
        let best;
        for (const [test, places] of this.testSteps[node]) {
            const shape = this.nodes[node].ray.tests?.[test]?.shape;
            if (places[0] <= step && shape?.verdict === 'best') best = shape.t;
        }
        return best;
    }

    /** Whether a node has returned its colour. */
    isFinished(node, step) {
        return this.lastStep[node] >= 0 ? this.lastStep[node] <= step : this.isReached(node, step);
    }

    /** The frames at a step, the newest first, each with its variables and the step it stands at. */
    stackAt(step) {
        const stack = [];
        let below = step;
        for (let f = this.frameOf[step]; f >= 0; f = this.frames[f].parent) {
            const frame = this.frames[f];
            const variables = new Map();
            const fresh = new Set();
            for (const k of frame.sets) {
                if (k > step) break;
                for (const [name, value] of Object.entries(this.steps[k].set)) {
                    variables.set(name, value);
                    if (k === step) fresh.add(name);
                }
            }
            let at = below;
            while (at > frame.start && this.frameOf[at] !== f) at -= 1;
            stack.push({ ...frame, index: f, variables, fresh, at, line: this.steps[at].line });
            below = frame.start - 1;
        }
        return stack;
    }

    into(step) {
        return Math.min(step + 1, this.steps.length - 1);
    }

    back(step) {
        return Math.max(step - 1, 0);
    }

    /** The next step that is no deeper; where there is none, this one. */
    over(step) {
        return this.forward(step, (k) => this.depthOf[k] <= this.depthOf[step]);
    }

    /** The first step after the current frame has been left; where there is none, this one. */
    out(step) {
        return this.forward(step, (k) => this.depthOf[k] < this.depthOf[step]);
    }

    forward(step, isThere) {
        for (let k = step + 1; k < this.steps.length; k += 1) if (isThere(k)) return k;
        return step;
    }

    /** The values that a step's formula is worked out with: its own, and those of its ray. */
    valuesAt(step) {
        const { arithmetic, node } = this.steps[step];
        const special = { Infinity, '-Infinity': -Infinity, NaN };
        const read = (x) => (Array.isArray(x) ? x.map(read) : (special[x] ?? x));
        return Object.fromEntries(
            Object.entries({ ...this.nodes[node].values, ...arithmetic.values }).map(([name, x]) => [name, read(x)]),
        );
    }

    /** The next step where an event holds, or -1. */
    until(step, event, argument) {
        for (let k = step + 1; k < this.steps.length; k += 1) if (this.holds(k, event, argument)) return k;
        return -1;
    }

    /** Whether an event holds at a step. */
    holds(k, event, argument) {
        const step = this.steps[k];
        const ray = this.nodes[step.node].ray;
        const test = step.test === undefined ? undefined : ray.tests?.[step.test];
        switch (event) {
            case 'depth':
                return step.call === 'Trace' && ray.depth === argument;
            case 'weight':
                return (
                    (step.call === 'Reflected' || step.call === 'Refracted') &&
                    ray.weight !== undefined &&
                    Math.max(...ray.weight) < argument
                );
            case 't':
                return test?.shape?.verdict === 'best' && test.shape.t < argument;
            case 'object':
                return (test?.shape ?? test?.bounds)?.object === argument;
            default:
                return step.events?.includes(event) ?? false;
        }
    }

    /** The names of the objects that anything was tested against. */
    objectNames() {
        const names = new Set();
        for (const { ray } of this.nodes)
            for (const test of ray.tests ?? []) if (test.shape?.object) names.add(test.shape.object);
        return [...names];
    }
}
