// SPDX-License-Identifier: MIT
// The sandbox: choose a body, throw it, see it beside Poinsot's construction, and let methods compute it.
"use strict";
(() => {
  const { make, number, button, slider } = polhodeLive;
  const part = (id) => document.getElementById(id);
  const kTurn = 2 * Math.PI, kDegree = Math.PI / 180;
  const kTurnsCompared = 20, kSettled_ms = 500, kMeasured_ms = 8, kNarrow = 640;

  // What may be thrown. `ways`: what a spin about axes 1, 2, 3 is like in the hand.
  const kBodies = [
    { name: "phone", words: "Phone", ways: ["like a drill", "end over end", "like a wheel"], icon: "M8 2h8v20H8z M11 19.5h2" },
    { name: "book", words: "Book", ways: ["about its spine", "end over end", "flat, like a wheel"], icon: "M5 3h14v18H5z M8.5 3v18" },
    { name: "racket", words: "Tennis racket", ways: ["about the handle", "end over end", "flat, like a wheel"], icon: "M12 2c4 0 5 3.5 5 6s-2.5 5.5-5 5.5S7 10.500 7 8s1-6 5-6z M12 13.500V22" },
    { name: "t-handle", words: "T-handle", ways: [], icon: "M4 5h16v3H4z M10.500 8v12h3V8" },
    { name: "box", words: "Box", ways: ["about its length", "about its width", "about its height"], icon: "M4 8l8-4 8 4v9l-8 4-8-4z M4 8l8 4 8-4 M12 12v9" },
    { name: "disc", words: "Plate", ways: ["about a diameter", "about a diameter", "like a frisbee"], icon: "M3 12c0-2.500 4-4 9-4s9 1.500 9 4-4 4-9 4-9-1.500-9-4z" },
    { name: "cylinder", words: "Can", ways: ["end over end", "end over end", "like a drill"], icon: "M6 5c0-1.500 12-1.500 12 0v14c0 1.500-12 1.500-12 0z M6 5c0 1.500 12 1.500 12 0" },
    { name: "sphere", words: "Ball", ways: ["any axis is like any other", "any axis is like any other", "any axis is like any other"], icon: "M12 3a9 9 0 1 0 .01 0z" },
  ];
  const kMethods = [
    { name: "explicit-euler", words: "explicit Euler" },
    { name: "explicit-midpoint", words: "explicit midpoint" },
    { name: "implicit-midpoint", words: "implicit midpoint" },
    { name: "rk4", words: "Runge–Kutta 4" },
    { name: "moser-veselov-6", words: "Moser–Veselov 6" },
    { name: "exact", words: "exact" },
  ];
  const kExact = kMethods.length - 1;

  let program = null, view = null, state = null, meter = null;
  // What is thrown, as the controls have it: axis and askew follow the hand where it drags ω.
  const thrown = { axis: 1, turns: 1, askew: 1, signs: [1, 1, 1] };
  const computed = { method: kExact, steps: 24 };

  const start = async () => {
    const lacks = polhodeLive.missing();
    if (lacks) return host.failed(lacks);
    try {
      program = await polhodeLive.newProgram();
    } catch (error) {
      return host.failed("the program does not start (" + error.message + ")");
    }
    if (!program.call("show", 1, 1)) return host.failed(program.message());
    view = new polhodeLive.View(program);
    if (!view.begin(host, (box) => part("figure").querySelector(".live-place").prepend(box))) return;
    part("figure").classList.add("is-live");
    for (const hidden of document.querySelectorAll("[hidden]")) hidden.hidden = false;
    follow();
    if (!location.hash.includes("?") && !polhodeLive.still.matches) program.call("set_playing", 1);
    view.wake();
  };

  const omega = () => {
    const size = thrown.turns * kTurn, angle = thrown.askew * kDegree;
    return thrown.signs.map((sign, i) => sign * size * (i === thrown.axis ? Math.cos(angle) : Math.sin(angle) / Math.SQRT2));
  };
  const useMethod = () => {
    const exact = computed.method === kExact;
    if (exact && state.method.name === "exact") return 1;
    const done = program.call("set_method", exact ? "" : kMethods[computed.method].name, exact ? 0 : 1 / (thrown.turns * computed.steps));
    return done && program.call("show_overlay", "ghost", exact ? 0 : 1);
  };
  const throwIt = (w = omega()) => {
    view.edit(() => program.call("set_omega", ...w) && useMethod());
    measureSoon();
  };
  const compute = () => {
    view.edit(useMethod);
    measureSoon();
  };
  /// The controls, from a motion that came by a link or by the hand.
  const read = (now) => {
    const size = Math.hypot(...now.omega0);
    if (!(size > 0)) return;
    const along = now.omega0.map(Math.abs);
    thrown.axis = along.indexOf(Math.max(...along));
    thrown.turns = size / kTurn;
    thrown.signs = now.omega0.map((one) => (one < 0 ? -1 : 1));
    thrown.askew = Math.acos(Math.min(1, along[thrown.axis] / size)) / kDegree;
    const found = kMethods.findIndex((one) => one.name === now.method.name);
    computed.method = found < 0 ? kExact : found;
    if (now.method.step) computed.steps = Math.min(512, Math.max(4, Math.round(kTurn / (size * now.method.step))));
  };

  // ---- controls -------------------------------------------------------------------------------------------
  const drawn = (name, attributes, ...children) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
  };
  const icon = (path) => drawn("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, drawn("path", { d: path }));
  const pick = (group, value, words, chosen, picture) => {
    const input = make("input", { type: "radio", name: group, value, change: () => chosen(value) });
    return make("label", { class: "pick" }, input, ...(picture ? [picture] : []), words);
  };
  const take = (name) => {
    view.edit(() => program.call("set_body", name));
    measureSoon();
  };
  const bodies = make("div", { class: "picks" }, ...kBodies.map((one) => pick("body", one.name, one.words, take, icon(one.icon))));
  const axes = make("div", { class: "picks" }, ...[0, 1, 2].map((i) =>
    pick("axis", String(i), "axis " + (i + 1), (value) => { thrown.axis = Number(value); throwIt(); })));
  const way = make("p", { class: "live-hint" });
  const fast = slider("how fast", (value) => number(Math.exp(value), 3) + " turns/s",
    (value) => {
      const more = Math.exp(value) / thrown.turns;
      thrown.turns = Math.exp(value);
      throwIt(state.omega0.map((one) => one * more));
    });
  const askew = slider("how askew", (value) => number(value, 2) + "°", (value) => { thrown.askew = value; throwIt(); });
  const moments = [1, 2, 3].map((i) => make("input", { type: "number", min: 0, step: "any", "aria-label": "Moment I" + i + ", kg m²", change: () => own() }));
  const own = () => {
    view.edit(() => program.call("set_moments", ...moments.map((one) => Number(one.value))));
    measureSoon();
  };
  const note = make("p", { class: "live-note", role: "status" });
  part("throw.controls").append(
    make("fieldset", {}, make("legend", {}, "What?"), bodies),
    make("fieldset", {}, make("legend", {}, "About which of its axes?"), axes, way),
    fast.line, askew.line,
    make("p", { class: "live-hint" }, "Or take the tip of ω in the picture and put it elsewhere: the energy stays, the throw is another."),
    make("details", {}, make("summary", {}, "A body of your own"),
      make("p", { class: "live-hint" }, "Its principal moments of inertia, kg m²; none may be larger than the other two together."),
      make("div", { class: "own" }, ...moments)),
    note);

  const play = button("Pause", () => { program.call("set_playing", state.playing ? 0 : 1); view.touch(); });
  play.className = "first";
  const time = slider("t", (t) => t.toFixed(2) + " s", (t) => { program.call("set_playing", 0); view.edit(() => program.call("set_time", t)); });
  time.line.classList.add("live-time");
  const speed = make("select", { "aria-label": "Speed", change: () => { program.call("set_speed", Number(speed.value)); view.touch(); } },
    ...[["1", "real time"], ["0.5", "½ speed"], ["0.25", "¼ speed"], ["0.0625", "1/16 speed"]].map(([value, words]) => make("option", { value }, words)));
  const turned = (x, y) => () => { program.call("turn", x / 24, y / 24); view.touch(); };
  const zoomed = (by) => () => { program.call("zoom", by); view.touch(); };
  document.querySelector(".bar").append(play,
    button("Throw again", () => { program.call("set_time", 0); program.call("set_playing", 1); view.touch(); }), time.line, speed,
    button("◂", turned(-1, 0), "Turn to the left"), button("▸", turned(1, 0), "Turn to the right"),
    button("▴", turned(0, -1), "Turn up"), button("▾", turned(0, 1), "Turn down"),
    button("+", zoomed(1), "Nearer"), button("−", zoomed(-1), "Farther"),
    button("Copy link", () => polhodeLive.copyLink(state.body, program.state(), (words) => { note.textContent = words; })));

  const method = slider("method", (i) => kMethods[i].words, (i) => { computed.method = Math.round(i); compute(); }, { step: 1 });
  const steps = slider("steps", (value) => Math.round(2 ** value) + " a turn", (value) => { computed.steps = Math.round(2 ** value); compute(); });
  const off = make("p", { class: "verdict-line" });
  const rows = make("tbody");
  const table = make("table", { class: "trade" },
    make("caption", {}, "What each method costs here, on this device, and how far the body is turned wrongly after " + kTurnsCompared + " turns"),
    make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "method"), make("th", { scope: "col" }, "1 min of motion"), make("th", { scope: "col" }, "wrong by"))), rows);
  const chart = drawn("svg", { viewBox: "0 0 320 190", class: "chart", "aria-hidden": "true" });
  part("throw.method").append(
    make("p", { class: "live-hint" }, "The motion is exact: a formula, by Jacobi’s elliptic functions. A computer that does not know it goes step by step. The exact body is the pale one."),
    method.line, steps.line, off, chart, table);

  const captions = [...document.querySelectorAll("figcaption span")];
  const ofExact = captions.map((one) => [...one.childNodes]), ofComputed = [
    ["The body as the method computes it, and the exact one, pale. L should stand still."],
    ["What the method computes, in Poinsot’s picture: where it errs, ω leaves the plane."]];

  // ---- what the view tells --------------------------------------------------------------------------------
  const kinds = (I) => {
    const close = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(a, b);
    if (close(I[0], I[1]) && close(I[1], I[2])) return ["like every other", "like every other", "like every other"];
    const sorted = [...I].sort((a, b) => a - b);
    return I.map((one, i) => I.some((other, j) => j !== i && close(one, other)) ? "one of two alike"
      : one === sorted[0] ? "least moment" : one === sorted[2] ? "greatest moment" : "middle moment");
  };
  const verdict = (now) => {
    const kind = kinds(now.moments)[thrown.axis];
    const apart = now.period && Number.isFinite(now.period) ? number(now.period, 3) + " s" : "";
    if (kind === "like every other") return "All axes are alike: ω stands still, and the body just spins.";
    if (now.flips.length && apart) return "It turns over twice every " + apart + ": a spin about the axis of the middle moment does not stay.";
    if (kind === "middle moment") return thrown.askew < 0.005 ? "Exactly about the middle axis it would spin on for ever, like a pencil on its tip." : "It sways widely about its middle axis.";
    if (kind.startsWith("one of")) return "Two moments are equal: the third axis goes steadily round L, and no spin turns over.";
    return "The axis of the " + kind + ": ω goes round it" + (apart ? " every " + apart : "") + ", and the body only wobbles.";
  };
  const host = {
    /// Wide, with the bar below it still in view; on a phone both pictures side by side, and room for controls.
    height: (width) => Math.round(view.box.clientWidth < kNarrow ? 0.72 * width : Math.min(0.46 * width, 0.6 * innerHeight * width / view.box.clientWidth)),
    drawn(now) {
      if (!now) return;
      const another = !state || now.omega0.join() !== state.omega0.join() || now.body !== state.body;
      state = now;
      if (another) { read(now); this.show(); }
      play.textContent = now.playing ? "Pause" : "Play";
      time.put(now.from, now.to, now.t);
      off.textContent = computed.method === kExact ? "Exact at any t, without a step on the way."
        : now.error ? "At t = " + number(now.t, 3) + " s the body is turned wrongly by " + number(now.error.attitude / kDegree, 3) + "°. T has changed by " + number(now.drift.T * 100, 2) + " %, |L| by " + number(now.drift.L * 100, 2) + " %."
        : "";
    },
    show() {
      for (const input of bodies.querySelectorAll("input")) input.checked = input.value === state.body;
      for (const input of axes.querySelectorAll("input")) input.checked = input.value === String(thrown.axis);
      const kind = kinds(state.moments)[thrown.axis];
      const like = kBodies.find((one) => one.name === state.body)?.ways[thrown.axis];
      way.textContent = (like ? like[0].toUpperCase() + like.slice(1) + ": " : "") + "axis " + (thrown.axis + 1) + ", " + kind + ", " + number(state.moments[thrown.axis], 3) + " kg m².";
      fast.put(Math.log(0.1), Math.log(5), Math.log(thrown.turns));
      askew.put(0, 54.7, thrown.askew);
      method.put(0, kExact, computed.method);
      steps.put(2, 9, Math.log2(computed.steps));
      steps.input.disabled = computed.method === kExact;
      moments.forEach((input, i) => { if (document.activeElement !== input) input.value = state.moments[i]; });
      part("throw.verdict").textContent = verdict(state);
      captions.forEach((one, i) => one.replaceChildren(...(computed.method === kExact ? ofExact : ofComputed)[i]));
      table.querySelectorAll("tr").forEach((row) => { row.toggleAttribute("aria-current", false); });
      rows.children[computed.method]?.setAttribute("aria-current", "true");
      for (const point of chart.querySelectorAll("circle")) point.classList.toggle("now", point.dataset.method === String(computed.method));
    },
    worded(words) {
      part("throw.numbers").replaceChildren(...words.readouts.map((one) => make("div", {}, make("dt", {}, one.name), make("dd", {}, one.value.replace(/-(?=\d)/g, "\u2212")))));
    },
    settled(now, words) {
      if (!this.touched) return;
      polhodeLive.keep(now.body, now);
      const said = part("throw.verdict").textContent + " " + words.readouts.map((one) => one.name + " " + one.value).join("; ");
      if (!now.playing && part("throw.said").textContent !== said) part("throw.said").textContent = said;
    },
    edited() { this.touched = true; this.drawn(program.state()); this.show(); },
    refused(why) { note.textContent = why; },
    failed(why) {
      part("figure").classList.remove("is-live");
      part("figure").querySelector(".live-why").textContent = "This stays a picture: " + why + ".";
    },
  };

  // ---- what methods cost: measured by a second program, so that the picture goes on -------------------------
  let soon = 0;
  const measureSoon = () => { clearTimeout(soon); soon = setTimeout(() => measure(state), kSettled_ms); };
  const pause = () => new Promise((done) => setTimeout(done));
  const measure = async (of) => {
    if (!meter) {
      meter = await polhodeLive.newProgram();
      meter.call("show", 1, 1);
    }
    const size = Math.hypot(...of.omega0), long = kTurnsCompared * kTurn / size;
    const made = [];
    for (const [i, one] of kMethods.entries()) {
      await pause();
      if (state !== of && state.omega0.join() + state.moments.join() !== of.omega0.join() + of.moments.join()) return;
      meter.call("reset");
      meter.call("set_moments", ...of.moments);
      meter.call("set_omega", ...of.omega0);
      if (i === kExact) break;
      meter.call("set_method", one.name, kTurn / (size * computed.steps));
      const began = performance.now();
      let reached = 0;
      while (performance.now() - began < kMeasured_ms && meter.call("set_time", reached + long)) reached += long;
      const took = performance.now() - began;
      // Where a method breaks down on the way, time stays where it was.
      const wrong = meter.call("set_time", long) ? meter.state().error?.attitude : NaN;
      made.push({ cost: reached > 0 ? took * 60 / reached : NaN, wrong: wrong ?? NaN });
    }
    const cells = (one) => [Number.isFinite(one.cost) ? number(one.cost, 2) + " ms" : "–", Number.isFinite(one.wrong) ? number(one.wrong / kDegree, 2) + "°" : "breaks down"];
    rows.replaceChildren(...kMethods.map((one, i) => make("tr", {}, make("th", { scope: "row" }, one.words),
      ...(i === kExact ? ["any t at once", "0°"] : cells(made[i])).map((words) => make("td", {}, words)))));
    plot(made);
    host.show();
  };
  /// Error against cost, a decade of each as long as any other: the table as a picture.
  const plot = (made) => {
    const range = (values) => {
      const logs = values.filter((one) => one > 0 && Number.isFinite(one)).map(Math.log10);
      return [Math.floor(Math.min(...logs)), Math.max(Math.ceil(Math.max(...logs)), Math.floor(Math.min(...logs)) + 1)];
    };
    const [x0, x1] = range(made.map((one) => one.cost)), [y0, y1] = range(made.map((one) => one.wrong / kDegree));
    const x = (cost) => 46 + (Math.log10(cost) - x0) / (x1 - x0) * 250, y = (wrong) => 150 - (Math.log10(wrong) - y0) / (y1 - y0) * 130;
    const words = (at, across, up, end) => drawn("text", { x: across, y: up, "text-anchor": end }, at);
    const power = (n) => (n >= -2 && n <= 3 ? String(10 ** n) : "10" + [...String(n)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join(""));
    const parts = [drawn("path", { class: "axis", d: "M46 20V150H300" }),
      words("wrong by, °", 4, 10, "start"), words("ms for a minute of motion", 300, 184, "end")];
    for (let n = x0; n <= x1; ++n) parts.push(drawn("path", { d: "M" + x(10 ** n) + " 20V150" }), words(power(n), x(10 ** n), 166, "middle"));
    const every = Math.ceil((y1 - y0) / 5);
    for (let n = y0; n <= y1; n += every) parts.push(drawn("path", { d: "M46 " + y(10 ** n) + "H300" }), words(power(n), 40, y(10 ** n) + 4, "end"));
    made.forEach(({ cost, wrong }, i) => {
      if (!(cost > 0) || !(wrong > 0)) return;
      const at = { cx: x(cost), cy: y(wrong / kDegree) };
      parts.push(drawn("circle", { ...at, r: 5, "data-method": i }),
        words(kMethods[i].words, Math.min(Math.max(at.cx, 92), 258), at.cy + (i % 2 ? -10 : 18), "middle"));
    });
    chart.replaceChildren(...parts);
  };

  /// "#book?t=1&omega=…" of a link.
  const follow = () => {
    const [name, query] = decodeURIComponent(location.hash.slice(1)).split("?");
    program.call("reset");
    if (kBodies.some((one) => one.name === name)) program.call("set_body", name);
    host.refused(query ? polhodeLive.apply(program, query) : "");
    state = null;
    host.drawn(program.state());
    if (computed.method !== kExact) program.call("show_overlay", "ghost", 1);
    host.show();
    measureSoon();
    view.wake();
  };
  addEventListener("hashchange", () => { if (view?.host) follow(); });
  start();
})();
