// Figures that answer. A step's setting stands on its page as JSON; its figures are drawn again by the lecture's own code,
// which a module brings when the first control is touched. Without modules the figures stay as they are.
"use strict";

(() => {
    const root = typeof path_to_root === "string" ? path_to_root : "";
    const wide = 1e4; // a range of more than this is walked about its value
    const reach = 30; // so far to either side
    const steps = 1000;

    // A chapter's module (bindings/web): text in, SVG or a fault's text out. It works beside the page, which stays at hand.
    const work = async () => {
        let loading;
        const load = async (url) => {
            const packed = (await fetch(url)).body.pipeThrough(new DecompressionStream("gzip"));
            const module = new Response(packed, { headers: { "Content-Type": "application/wasm" } });
            return (await WebAssembly.instantiateStreaming(module, {})).instance.exports;
        };
        self.onmessage = async ({ data: { url, request } }) => {
            try {
                const lesson = await (loading ??= load(url));
                const bytes = new TextEncoder().encode(request);
                const at = lesson.lesson_request(bytes.length);
                new Uint8Array(lesson.memory.buffer, at, bytes.length).set(bytes);
                const failed = lesson.lesson_answer();
                const text = new Uint8Array(lesson.memory.buffer, lesson.lesson_text(), lesson.lesson_length());
                self.postMessage({ failed, text: new TextDecoder().decode(text) });
            } catch (error) {
                self.postMessage({ broken: String(error) });
            }
        };
    };

    class Module {
        constructor(chapter) {
            this.url = new URL(`${root}modules/${chapter}.wasm.gz`, location.href).href;
        }

        // One question at a time.
        answer(request) {
            this.worker ??= new Worker(URL.createObjectURL(new Blob([`(${work})()`], { type: "text/javascript" })));
            return new Promise((done, broken) => {
                const end = (why) => {
                    // What has panicked, or was never whole, is of no use any more.
                    this.worker.terminate();
                    this.worker = undefined;
                    broken(new Error(why));
                };
                this.worker.onmessage = ({ data }) => (data.broken === undefined ? done(data) : end(data.broken));
                this.worker.onerror = () => end("no worker");
                this.worker.postMessage({ url: this.url, request });
            });
        }
    }

    const modules = new Map();
    const moduleOf = (chapter) => {
        if (!modules.has(chapter)) modules.set(chapter, new Module(chapter));
        return modules.get(chapter);
    };

    const element = (name, attributes, ...inner) => {
        const made = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
        made.append(...inner);
        return made;
    };

    // What a slider walks: from its place to what is typed.
    const walk = (parameter) => {
        const { kind, min, max, scale } = parameter.domain;
        const value = parameter.value ?? parameter.n;
        const ends = kind === "number" || kind === "count" ? [min, max] : parameter.domain.n;
        if (!ends || typeof ends[0] !== "number" || typeof value !== "number") return undefined;
        let [from, to] = ends;
        const logarithmic = (scale === "logarithmic" || kind.endsWith("medium")) && from > 0 && value > 0;
        if (logarithmic && to / from > wide) [from, to] = [Math.max(from, value / reach), Math.min(to, value * reach)];
        if (!logarithmic && to - from > wide * Math.max(Math.abs(value), 1)) {
            [from, to] = [Math.max(from, value - reach * (Math.abs(value) || 1)), Math.min(to, value + reach * (Math.abs(value) || 1))];
        }
        // In the unit that it is written in: 550nm, 45deg.
        const [, written, suffix] = /^([-+.0-9e]*)(.*)$/.exec(parameter.text);
        const factor = Number(written) && value ? Number(written) / value : 1;
        return {
            place: (x) => steps * (logarithmic ? Math.log(x / from) / Math.log(to / from) : (x - from) / (to - from)),
            text: (place) => {
                const t = place / steps;
                const x = logarithmic ? from * (to / from) ** t : from + (to - from) * t;
                if (kind === "count") return String(Math.round(x));
                // A rounded end may lie outside.
                const round = Number((x * factor).toPrecision(4));
                const clipped = Math.min(Math.max(round, ends[0] * factor), ends[1] * factor);
                return factor === 1 ? String(clipped) : `${clipped}${suffix}`;
            },
            value,
        };
    };

    // A step: its setting, its figures, and the controls above the first of them.
    class Step {
        constructor(script) {
            this.address = script.dataset.step;
            this.chapter = this.address.split("/")[0];
            this.parameters = JSON.parse(script.textContent);
            const own = [...document.querySelectorAll("figure.plot")];
            this.figures = own.filter((figure) => figure.id.startsWith(`${this.address}/`) && figure.id.split("/").length === 3);
            this.changed = new Map();
            this.round = 0;
        }

        show() {
            if (this.figures.length === 0 || this.parameters.length === 0) return;
            this.status = element("p", { class: "live-status", role: "status" });
            const reset = element("button", { type: "button" }, "as it was");
            reset.addEventListener("click", () => this.reset());
            this.controls = this.parameters.map((parameter, at) => this.control(parameter, at));
            const form = element("form", { class: "live", "aria-label": "What the figures are drawn at" }, ...this.controls.map((control) => control.row), reset, this.status);
            form.addEventListener("submit", (event) => event.preventDefault());
            this.figures[0].before(form);
            this.restore();
        }

        control(parameter, at) {
            const id = `live-${this.address}-${at}`;
            const { kind, words, names } = parameter.domain;
            const row = element("div", { class: "live-row" }, element("label", { for: id }, parameter.says));
            const set = (text) => this.set(parameter, text);
            let typed;
            if (kind === "choice") {
                typed = element("select", { id }, ...words.map((word) => element("option", { value: word }, word)));
                typed.addEventListener("change", () => set(typed.value));
            } else {
                typed = element("input", { id, type: "text", size: 10, autocomplete: "off", spellcheck: "false" });
                typed.addEventListener("change", () => set(typed.value));
                if (names) {
                    const list = `${id}-names`;
                    typed.setAttribute("list", list);
                    row.append(element("datalist", { id: list }, ...names.map((name) => element("option", { value: name }))));
                }
            }
            const way = kind === "choice" ? undefined : walk(parameter);
            let slider;
            if (way) {
                slider = element("input", { type: "range", min: 0, max: steps, "aria-label": parameter.says });
                slider.addEventListener("input", () => {
                    typed.value = way.text(Number(slider.value));
                    set(typed.value);
                });
                row.append(slider);
            }
            row.append(typed);
            const show = (text) => {
                typed.value = text;
                if (slider && text === parameter.text) slider.value = way.place(way.value);
            };
            show(parameter.text);
            return { row, show, parameter };
        }

        set(parameter, text) {
            if (text === parameter.text) this.changed.delete(parameter.name);
            else this.changed.set(parameter.name, text);
            const hash = new URLSearchParams([["at", this.address], ...this.changed]);
            history.replaceState(null, "", this.changed.size ? `?${hash}` : location.pathname);
            this.draw();
        }

        // A link carries a step's setting.
        restore() {
            const asked = new URLSearchParams(location.search);
            if (asked.get("at") !== this.address) return;
            for (const { parameter, show } of this.controls) {
                const text = asked.get(parameter.name);
                if (text === null) continue;
                this.changed.set(parameter.name, text);
                show(text);
            }
            if (this.changed.size) this.draw();
        }

        reset() {
            this.changed.clear();
            this.controls.forEach(({ show, parameter }) => show(parameter.text));
            history.replaceState(null, "", location.pathname);
            this.draw();
        }

        // Draws once more when a change has come meanwhile: what is shown last is what was asked for last.
        async draw() {
            this.round += 1;
            if (this.drawing) return;
            this.drawing = true;
            try {
                for (let round = -1; round !== this.round; ) {
                    round = this.round;
                    await this.drawOnce();
                }
            } catch {
                this.status.textContent = "The figures cannot be drawn again here; they stay as the book has them.";
            } finally {
                this.drawing = false;
            }
        }

        async drawOnce() {
            const lines = [...this.changed].map(([name, text]) => `${name}=${text.replaceAll("\n", " ")}`);
            this.figures.forEach((figure) => figure.classList.add("drawing"));
            let fault = "";
            try {
                for (const figure of this.figures) {
                    const { failed, text } = await moduleOf(this.chapter).answer([figure.id, ...lines].join("\n"));
                    if (failed) {
                        fault = text;
                        break;
                    }
                    const drawn = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
                    figure.querySelector("svg").replaceWith(document.importNode(drawn, true));
                }
            } finally {
                this.figures.forEach((figure) => figure.classList.remove("drawing"));
            }
            this.status.textContent = fault;
        }
    }

    // What scrolls by itself can be scrolled by keys.
    const reachable = () => {
        for (const wide of document.querySelectorAll("main table, main figure, main .formula, main pre, main .derivation li")) {
            if (wide.scrollWidth > wide.clientWidth) wide.tabIndex = 0;
        }
    };
    addEventListener("load", reachable);
    addEventListener("resize", reachable);
    document.addEventListener("toggle", reachable, true);

    document.querySelectorAll("script.lesson-setting").forEach((script) => new Step(script).show());
})();
