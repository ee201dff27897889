// SPDX-License-Identifier: MIT
// Figures that move. A figure is a picture until it is pressed; then one canvas with WebGL2, the only one of
// the page, takes its place, and polhode's own code (app/web/live_api.h) draws and judges. Where that cannot
// be, the picture stays, and the page says why. Nothing is fetched: script, code and lesson are in the page, or,
// where pages of a site share them, script and code in a file beside it.
// The address keeps what is shown, "#stage/step.2?t=1.5&omega=0,3,0.1": a link is a scenario.
"use strict";
const polhodeLive = (() => {
  const kReadoutsEvery_ms = 120, kWordsEvery_ms = 400, kQuietFor_ms = 700, kLinkEvery_ms = 500;
  const kSlowFrame_ms = 45, kReach = { mouse: 12, pen: 14, touch: 24 };  // css px
  const dark = matchMedia("(prefers-color-scheme: dark)");
  // Slides are of one theme, whatever their reader prefers.
  const scheme = document.querySelector("meta[name=color-scheme]")?.content;
  const theme = () => (scheme ? scheme === "dark" : dark.matches) ? 1 : 0;
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  // Those of base/words/live_words.h in the page's language, and a text with `parts` in the place of {0}, {1}, ….
  const words = JSON.parse(document.getElementById("polhode.words").textContent);
  const filled = (text, ...parts) => text.replace(/\{(\d)\}/g, (_, i) => parts[i]);

  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
      if (typeof value === "function") element.addEventListener(key, value);
      else if (value !== false) element.setAttribute(key, value === true ? "" : value);
    element.append(...children);
    return element;
  };
  const number = (value, digits = 4) =>
    !Number.isFinite(value) ? "–" : String(Number(value.toPrecision(digits))).replace("-", "\u2212").replace(".", words.decimal);

  /// What this browser lacks; empty: nothing.
  const missing = () =>
    !document.getElementById("polhode.wasm") && !document.getElementById("polhode.file") ? words.noProgram
    : typeof WebAssembly !== "object" || typeof DecompressionStream !== "function"
      ? words.tooOld
    : typeof WebGL2RenderingContext === "undefined" ? words.noWebGl
    : "";

  /// What live_file of app/publish/live/live_program.h gives, once it has run.
  const held = {};
  const hold = (texts) => Object.assign(held, texts);
  const runFile = (name) => new Promise((done, failed) => document.head.append(make("script", {
    src: name, load: done, error: () => failed(new Error(filled(words.noFile, name))) })));
  /// What that header calls packed_for_page.
  const unpacked = async (id) => {
    const text = held[id] ?? document.getElementById(id).textContent, packed = new Uint8Array(text.length * 13 >> 4);
    const digit = (i) => (text[i] === "~" ? 27 : text.charCodeAt(i) - 33);
    let bits = 0, size = 0;
    for (let i = 0, count = 0; i < text.length; i += 2) {
      const pair = i + 1 < text.length;
      bits = pair ? bits << 13 | digit(i) * 93 + digit(i + 1) : bits << 6 | digit(i);
      for (count += pair ? 13 : 6; count >= 8; count -= 8) packed[size++] = bits >> count - 8;
    }
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  };
  let file = null, wasm = null, lesson = null, script = null;
  /// Defines createPolhode. The page's policy knows it by its hash.
  const runScript = async () => document.head.append(make("script", {}, new TextDecoder().decode(await unpacked("polhode.js"))));
  const unpack = async () => {
    const beside = document.getElementById("polhode.file")?.dataset.name;
    if (beside) await (file ??= runFile(beside).catch((error) => { file = null; throw error; }));
    wasm ??= unpacked("polhode.wasm");
    lesson ??= unpacked("polhode.lesson");
    await (script ??= runScript());
  };
  /// Begins with what takes a while, for somebody who is about to press; newProgram says what fails.
  const prepare = () => { if (!missing()) unpack().catch(() => {}); };
  /// The program, as it is packed in the page, with a memory of its own; the page's lesson is open.
  const newProgram = async () => {
    await unpack();
    const module = await createPolhode({ wasmBinary: await wasm, print() {}, printErr() {} });
    const types = (list) => list.map((value) => (typeof value === "string" ? "string" : "number"));
    const call = (name, ...list) => module.ccall("polhode_" + name, "number", types(list), list);
    const said = (name) => module.ccall("polhode_" + name, "string", [], []);
    // A lesson is long, and ccall puts texts onto the stack.
    const text = await lesson, place = module._malloc(text.length + 1);
    module.HEAPU8.set(text, place);
    module.HEAPU8[place + text.length] = 0;
    const opened = call("open_lesson", place, document.title);
    module._free(place);
    if (!opened) throw new Error(said("message"));
    return {
      call, message: () => said("message"), state: () => JSON.parse(said("state")),
      words: () => JSON.parse(said("words")), choices: () => JSON.parse(said("choices")),
    };
  };

  /// The canvas, and what a hand does to it. `host` is told what happens: drawn(state), edited(), failed(why).
  class View {
    constructor(program) {
      View.present = this;  // for the browser's console, and for tests
      this.program = program;
      this.canvas = make("canvas", { id: "polhode.canvas", role: "img", "aria-label": words.canvas });
      this.box = make("div", { class: "live-view", tabindex: "0", role: "group" }, this.canvas);
      this.turns(true);
      this.pointers = new Map();
      [this.frame, this.last, this.slow] = [0, null, 1];
      this.listen();
      new ResizeObserver(() => this.wake()).observe(this.box);
      new IntersectionObserver((all) => { this.seen = all.at(-1).isIntersecting; this.wake(); }).observe(this.box);
      document.addEventListener("visibilitychange", () => { this.last = null; this.wake(); });
      dark.addEventListener("change", () => { this.program.call("set_theme", theme()); this.wake(); });
    }

    /// A diagram is flat: nothing of it can be turned, and nothing says so.
    turns(can) {
      this.flat = !can;
      this.box.setAttribute("aria-label", can ? words.figure : words.flatFigure);
      this.box.toggleAttribute("data-flat", !can);
    }
    /// Into the document, where `host` is told of it. False: it cannot be drawn here, and `host` was told.
    begin(host, where) {
      this.host?.left?.();
      this.host = host;
      where(this.box);
      if (!this.attached) {
        this.program.call("set_theme", theme());
        if (!this.program.call("attach", "canvas[id='polhode.canvas']")) {
          this.end(filled(words.noWebGlNow, this.program.message()));
          return false;
        }
        this.attached = true;
      }
      return true;
    }
    end(why = "") {
      const host = this.host;
      this.host = null;
      cancelAnimationFrame(this.frame);
      this.frame = 0;
      this.box.remove();
      host?.left?.();
      if (why) host?.failed(why.replace(/\.$/, ""));
    }
    lose() {
      this.program.call("detach");
      this.attached = false;
      const fresh = this.canvas.cloneNode();
      this.canvas.replaceWith(fresh);
      this.canvas = fresh;
      this.hear();
      this.end(words.graphicsLost);
    }

    wake() { if (this.host && !this.frame) this.frame = requestAnimationFrame((now) => this.draw(now)); }
    draw(now) {
      this.frame = 0;
      if (!this.host || !this.seen || !this.box.clientWidth || document.hidden) { this.last = null; return; }
      const began = performance.now();
      const goesOn = this.program.call("advance", this.last === null ? 0 : Math.min((now - this.last) / 1000, 0.1));
      this.last = goesOn ? now : null;
      const moves = goesOn || this.pointers.size > 0;
      const ratio = this.ratio = Math.min(devicePixelRatio || 1, 2);
      const width = Math.max(64, Math.round(this.box.clientWidth * ratio));
      const height = this.host.height?.(width) ?? this.program.call("height_for", width);
      if (this.canvas.width !== width) this.canvas.width = width;
      if (this.canvas.height !== height) this.canvas.height = height;
      this.program.call("draw", width, height, 0, moves ? this.slow : 1);
      const took = performance.now() - began;
      if (moves) this.slow = took > kSlowFrame_ms ? 0.5 : took < kSlowFrame_ms / 4 ? 1 : this.slow;
      this.tell(now);
      if (goesOn) this.wake();
    }
    /// Numbers often, words rarely, and what a screen reader says only when it has become quiet.
    tell(now) {
      const due = (name, every) => now - (this[name] ?? -Infinity) >= every && ((this[name] = now), true);
      clearTimeout(this.later);
      this.later = setTimeout(() => this.host && this.settle(), kQuietFor_ms);
      if (due("told", kReadoutsEvery_ms)) this.host.drawn(this.program.state());
      if (due("worded", kWordsEvery_ms)) this.word();
    }
    word() {
      this.words = this.program.words() ?? this.words;
      if (!this.words) return;
      this.canvas.setAttribute("aria-label", this.words.alt);
      this.host.worded?.(this.words);
    }
    settle() {
      const state = this.program.state();
      this.host.drawn(state);
      this.word();
      if (this.words) this.host.settled?.(state, this.words);
    }
    edit(act) {
      this.program.call("begin_change");
      const done = act();
      this.host.refused?.(done === 0 ? this.program.message() : "");
      this.touch();
    }
    touch() { this.host?.edited?.(); this.wake(); }

    hear() {
      const at = (event) => {
        const box = this.canvas.getBoundingClientRect();
        return [(event.clientX - box.left) * this.ratio, (event.clientY - box.top) * this.ratio];
      };
      const pointer = (kind, event) =>
        this.program.call("pointer", kind, ...at(event), (kReach[event.pointerType] ?? 12) * this.ratio);
      const middle = () => {
        const [a, b] = [...this.pointers.values()];
        return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, apart: Math.hypot(a[0] - b[0], a[1] - b[1]) };
      };
      const hear = (name, act, options) => this.canvas.addEventListener(name, act, options);
      hear("pointerdown", (event) => {
        if (event.button !== 0) return;
        this.canvas.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, at(event));
        if (this.pointers.size === 1) {
          this.program.call("begin_change");
          this.canvas.dataset.held = pointer(0, event);
        } else {
          pointer(2, event);
          this.pinch = this.pointers.size === 2 ? middle() : null;
        }
        this.wake();
      });
      hear("pointermove", (event) => {
        if (!this.pointers.has(event.pointerId)) {
          this.canvas.dataset.over = pointer(1, event);
          return;
        }
        this.pointers.set(event.pointerId, at(event));
        if (this.pointers.size === 1) {
          if (!this.pinch) pointer(1, event);
          this.host.refused?.(this.program.message());
        } else if (this.pinch && this.pointers.size === 2 && !this.flat) {
          const now = middle(), height = this.canvas.height;
          this.program.call("zoom", Math.log(now.apart / this.pinch.apart) / Math.log(1.1));
          this.program.call("turn", (now.x - this.pinch.x) / height, (now.y - this.pinch.y) / height);
          this.pinch = now;
        }
        this.touch();
      });
      const up = (event) => {
        if (!this.pointers.delete(event.pointerId) || this.pointers.size > 0) return;
        if (!this.pinch) pointer(2, event);
        this.pinch = null;
        this.canvas.dataset.held = "0";
        this.touch();
      };
      hear("pointerup", up);
      hear("pointercancel", up);
      hear("dblclick", (event) => { pointer(3, event); this.touch(); });
      hear("webglcontextlost", (event) => { event.preventDefault(); this.lose(); });
    }
    listen() {
      this.hear();
      // A wheel alone scrolls the page; with Ctrl, as a pad's two fingers come, it zooms.
      this.box.addEventListener("wheel", (event) => {
        if (!event.ctrlKey || this.flat) return;
        event.preventDefault();
        this.program.call("zoom", -event.deltaY / (event.deltaMode ? 3 : 50));
        this.touch();
      }, { passive: false });
      this.box.addEventListener("keydown", (event) => {
        if (event.target !== this.box || event.ctrlKey && event.key !== "z" || event.altKey || event.metaKey) return;
        const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
        const zooms = { "+": 1, "=": 1, "-": -1 };
        const keys = { " ": "Space", "r": "R", "z": "Ctrl+Z", "[": "[", "]": "]", "{": "{", "}": "}" };
        if (event.key === "Escape" && this.host.close) return this.host.close();
        if (this.flat && (turns[event.key] || zooms[event.key])) return;
        if (turns[event.key]) this.program.call("turn", ...turns[event.key].map((way) => way / 24));
        else if (zooms[event.key]) this.program.call("zoom", zooms[event.key]);
        else if (keys[event.key] && (event.key !== "z" || event.ctrlKey)) this.program.call("key", keys[event.key]);
        else return;
        event.preventDefault();
        this.touch();
      });
    }
  }

  /// A slider with its name and value. `shown` says a value in words.
  const slider = (name, shown, moved, { min = 0, max = 1, step = "any" } = {}) => {
    const input = make("input", { type: "range", min, max, step, input: () => moved(Number(input.value)) });
    const value = make("span", { class: "live-value" });
    const line = make("label", { class: "live-slider" }, make("span", { class: "live-name" }, name), input, value);
    return {
      line, input,
      put(from, to, at) {
        if (Number(input.max) !== to) input.max = to;
        if (Number(input.min) !== from) input.min = from;
        if (document.activeElement !== input || Number(input.value) !== at) input.value = at;
        value.textContent = shown(at);
        input.setAttribute("aria-valuetext", shown(at));
      },
    };
  };
  const button = (text, act, label = false) => make("button", { type: "button", click: act, "aria-label": label }, text);

  // What an address keeps: of the motion what is not the lesson's, the camera, and t.
  const linked = (state) => {
    const parts = ["t=" + state.t];
    if (state.playing) parts.push("play");
    if (state.changed) {
      parts.push("omega=" + state.omega0.join(), "I=" + state.moments.join());
      // A hand that has taken ω left the body where it was.
      if (state.attitude0) parts.push("q=" + state.attitude0.join());
      if (state.method.control !== "none" || state.method.name !== "exact")
        parts.push("method=" + state.method.name, "h=" + (state.method.step ?? state.method.tolerance ?? 0));
      if (state.vary.length) parts.push("vary=" + state.vary.map((one) => one.value).join());
      parts.push("camera=" + [state.camera.azimuth, state.camera.elevation, state.camera.zoom].join());
    }
    return parts.join("&");
  };
  const apply = (program, query) => {
    const wanted = new URLSearchParams(query);
    const list = (name) => (wanted.get(name) ?? "").split(",").filter((one) => one !== "").map(Number);
    const finite = (values, count) => values.length === count && values.every(Number.isFinite);
    const had = program.state();
    const refused = [];
    const put = (name, ...values) => { if (!program.call(name, ...values)) refused.push(program.message()); };
    const I = list("I"), omega = list("omega"), q = list("q"), camera = list("camera");
    if (finite(I, 3) && I.some((one, i) => one !== had.moments[i])) put("set_moments", ...I);
    list("vary").forEach((value, i) => { if (i < had.vary.length) put("vary", i, value); });
    if (finite(omega, 3)) put("set_omega", ...omega);
    if (finite(q, 4)) put("set_attitude", ...q);
    if (wanted.get("method")) put("set_method", wanted.get("method"), Number(wanted.get("h")) || 0);
    if (finite(camera, 3)) put("set_camera", ...camera);
    if (wanted.has("t") && Number.isFinite(Number(wanted.get("t")))) put("set_time", Number(wanted.get("t")));
    if (wanted.has("play") && !still.matches) program.call("set_playing", 1);
    return refused.join(" ");
  };
  let keeping = 0;
  const keep = (id, state) => {
    clearTimeout(keeping);
    keeping = setTimeout(() => history.replaceState(null, "", "#" + id + "?" + linked(state)), kLinkEvery_ms);
  };
  const copyLink = async (id, state, say) => {
    history.replaceState(null, "", "#" + id + "?" + linked(state));
    try {
      await navigator.clipboard.writeText(location.href);
      say(words.copied);
    } catch {
      say(words.inAddress);
    }
  };

  return { words, filled, make, number, missing, hold, prepare, newProgram, View, slider, button, linked, apply, keep, copyLink, still };
})();
