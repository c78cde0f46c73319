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
            let module = await (await fetch(url)).arrayBuffer();
            // Some servers unpack it themselves.
            if (new Uint8Array(module, 0, 1)[0] === 0x1f) {
                const unpacked = new Blob([module]).stream().pipeThrough(new DecompressionStream("gzip"));
                module = await new Response(unpacked).arrayBuffer();
            }
            return (await WebAssembly.instantiate(module, {})).instance.exports;
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

        // One question at a time, whichever step of the page asks.
        answer(request) {
            const asked = (this.last ?? Promise.resolve()).then(() => this.ask(request));
            this.last = asked.catch(() => {});
            return asked;
        }

        ask(request) {
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
        // What absorbs has two numbers, and a slider one.
        if (parameter.k) return undefined;
        const ends = kind === "number" || kind === "count" ? [min, max] : parameter.domain.n;
        if (!ends || typeof ends[0] !== "number" || typeof value !== "number") return undefined;
        let [from, to] = ends;
        const logarithmic = (scale === "logarithmic" || kind !== "number") && from > 0 && value > 0;
        if (logarithmic && to / from > wide) [from, to] = [Math.max(from, value / reach), Math.min(to, value * reach)];
        if (!logarithmic && to - from > wide * Math.max(Math.abs(value), 1)) {
            [from, to] = [Math.max(from, value - reach * (Math.abs(value) || 1)), Math.min(to, value + reach * (Math.abs(value) || 1))];
        }
        // In the unit that it is written in: 550nm, 45deg.
        const [, written, suffix] = /^([-+.0-9e]*)(.*)$/.exec(parameter.text);
        const factor = Number(written) && value ? Number(written) / value : 1;
        return {
            // Of a text that is a number in that unit; where else the slider stands says nothing.
            place: (text) => {
                const x = Number(text.endsWith(suffix) ? text.slice(0, text.length - suffix.length) : text) / factor;
                const place = logarithmic ? Math.log(x / from) / Math.log(to / from) : (x - from) / (to - from);
                return Number.isFinite(place) ? steps * place : undefined;
            },
            text: (place) => {
                const t = place / steps;
                const x = logarithmic ? from * (to / from) ** t : from + (to - from) * t;
                if (kind === "count") return String(Math.round(x < 100 ? x : Number(x.toPrecision(2))));
                // A rounded end may lie outside.
                const round = Number((x * factor).toPrecision(4));
                const clipped = Math.min(Math.max(round, ends[0] * factor), ends[1] * factor);
                return factor === 1 ? String(clipped) : `${clipped}${suffix}`;
            },
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
            if (this.figures.length === 0) return;
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
            let typed, slider;
            const follow = (text) => {
                const place = way?.place(text);
                if (place !== undefined) slider.value = place;
                slider?.setAttribute("aria-valuetext", text);
            };
            if (kind === "choice") {
                typed = element("select", { id }, ...words.map((word) => element("option", { value: word }, word)));
                typed.addEventListener("change", () => set(typed.value));
            } else {
                typed = element("input", { id, type: "text", size: 10, autocomplete: "off", spellcheck: "false" });
                typed.addEventListener("change", () => {
                    follow(typed.value);
                    set(typed.value);
                });
                if (names) {
                    const list = `${id}-names`;
                    typed.setAttribute("list", list);
                    row.append(element("datalist", { id: list }, ...names.map((name) => element("option", { value: name }))));
                }
            }
            const way = kind === "choice" ? undefined : walk(parameter);
            if (way) {
                slider = element("input", { type: "range", min: 0, max: steps, "aria-label": parameter.says });
                slider.addEventListener("input", () => {
                    typed.value = way.text(Number(slider.value));
                    slider.setAttribute("aria-valuetext", typed.value);
                    set(typed.value);
                });
                row.append(slider);
            }
            row.append(typed);
            const show = (text) => {
                typed.value = text;
                follow(text);
            };
            show(parameter.text);
            return { row, show, parameter };
        }

        set(parameter, text) {
            if (text === parameter.text) this.changed.delete(parameter.name);
            else this.changed.set(parameter.name, text);
            this.draw();
            // Browsers take a new address now and then, not with every move of a slider.
            clearTimeout(this.linking);
            this.linking = setTimeout(() => this.link(), 300);
        }

        // The page's address has the setting of the step that was touched last.
        link() {
            const isOurs = new URLSearchParams(location.search).get("at") === this.address;
            const query = new URLSearchParams([["at", this.address], ...this.changed]);
            if (this.changed.size) history.replaceState(null, "", `?${query}${location.hash}`);
            else if (isOurs) history.replaceState(null, "", location.pathname + location.hash);
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
            this.draw();
            this.link();
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
