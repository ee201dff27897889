// SPDX-License-Identifier: MIT
// The figures of a reader's page, or of the slides of a deck: each stays its picture until it is pressed. Of a slide the
// figure alone is live, in the slide's place: what the slide's text says was proved and computed for its still.
"use strict";
(() => {
  const { words, filled, make, number, button, slider } = polhodeLive;
  const seconds = (t) => number(t, 4) + " s";
  let program = null, view = null, shown = null;

  const begin = async () => {
    program = await polhodeLive.newProgram();
    view = new polhodeLive.View(program);
  };
  let begun = null;

  class Figure {
    constructor(figure) {
      this.figure = figure;
      [this.stage, this.step] = [figure.dataset.stage, Number(figure.dataset.step)];
      this.id = figure.closest("[id]").id;
      this.picture = figure.querySelector("img");
      this.press = button("", () => this.open(), words.press);
      this.press.className = "live-press";
      for (const name of ["pointerenter", "focus"]) this.press.addEventListener(name, polhodeLive.prepare, { once: true });
      this.press.append(make("span", { "aria-hidden": "true" }, "▶ " + words.live));
      this.place = make("div", { class: "live-place" });
      this.why = make("p", { class: "live-why", role: "status" });
      this.picture.replaceWith(this.place);
      this.place.append(this.picture, this.press);
      this.place.after(this.why);
      // A click on a slide goes on to the next.
      if (!figure.hasAttribute("data-slide")) this.picture.addEventListener("click", () => this.open());
    }

    /// `query`: of an address. `quiet`: it came into view again, and nobody pressed it.
    async open({ query = "", quiet = false } = {}) {
      if (shown === this && !query) return;
      const lacks = polhodeLive.missing();
      if (lacks) return this.failed(lacks);
      this.press.disabled = true;
      this.why.textContent = "";
      try {
        await (begun ??= begin());
      } catch (error) {
        return this.failed(filled(words.doesNotStart, error.message));
      } finally {
        this.press.disabled = false;
      }
      shown?.remember();
      if (!program.call("show_stage", this.stage, this.step)) return this.failed(program.message());
      if (!view.begin(this, (box) => this.place.prepend(box))) return;
      shown = this;
      this.figure.style.setProperty("--ratio", 1000 / program.call("height_for", 1000));
      this.controls();
      this.figure.classList.add("is-live");
      document.documentElement.classList.add("live");
      this.wasLive = true;
      this.refused(polhodeLive.apply(program, query || this.kept || ""));
      if (!query && !this.kept && !quiet && !polhodeLive.still.matches && !this.figure.hasAttribute("data-rest"))
        program.call("set_playing", 1);
      if (!quiet) view.box.focus({ preventScroll: true });
      view.wake();
    }
    remember() {
      const state = program.state();
      if (state) this.kept = polhodeLive.linked({ ...state, playing: false });
    }
    close() {
      this.remember();
      this.wasLive = false;
      view.end();
      this.press.focus({ preventScroll: true });
    }
    left() {
      if (shown === this) shown = null;
      this.figure.classList.remove("is-live");
      document.documentElement.classList.remove("live");
      this.panel?.remove();
      this.step_()?.removeAttribute("data-other");
    }
    failed(why) {
      this.wasLive = false;
      this.why.textContent = filled(words.staysPicture, why);
    }
    step_() { return this.figure.closest(".stage"); }

    controls() {
      this.play = button(words.play, () => {
        program.call("set_playing", this.state?.playing ? 0 : 1);
        view.touch();
      });
      this.time = slider("t", seconds, (t) => { program.call("set_playing", 0); view.edit(() => program.call("set_time", t)); });
      this.time.line.classList.add("live-time");
      const turn = (sign, x, y, label) => button(sign, () => { program.call("turn", x / 24, y / 24); view.touch(); }, label);
      const turns = program.state().in_space;
      view.turns(turns);
      const zoom = (sign, by, label) => button(sign, () => { program.call("zoom", by); view.touch(); }, label);
      this.vary = program.state().vary.map((one, i) =>
        slider(one.number, (value) => number(value, 3) + (one.unit ? " " + one.unit : ""), (value) => view.edit(() => program.call("vary", i, value))));
      const omega = [1, 2, 3].map((i) => slider("ω" + "₁₂₃"[i - 1], (value) => number(value, 3) + " rad/s", (value) => {
        const now = [...this.state.omega0];
        now[i - 1] = value;
        view.edit(() => program.call("set_omega", ...now));
      }));
      this.omega = omega;
      this.numbers = make("dl", { class: "live-numbers" });
      this.note = make("p", { class: "live-note", role: "status" });
      this.said = make("p", { class: "unseen", "aria-live": "polite" });
      this.panel = make("div", { class: "live-panel" },
        make("div", { class: "live-row" }, this.play, this.time.line),
        ...this.vary.map((one) => one.line),
        make("div", { class: "live-row" },
          ...(turns ? [turn("◂", -1, 0, words.left), turn("▸", 1, 0, words.right), turn("▴", 0, -1, words.up), turn("▾", 0, 1, words.down),
            zoom("+", 1, words.nearer), zoom("−", -1, words.farther)] : []),
          button(words.reset, () => view.edit(() => program.call("reset"))),
          button(words.copyLink, () => polhodeLive.copyLink(this.id, program.state(), (said) => { this.note.textContent = said; })),
          button(words.picture, () => this.close())),
        make("details", {}, make("summary", {}, words.anew),
          make("p", { class: "live-hint" }, words.anewHint), ...omega.map((one) => one.line)),
        make("details", {}, make("summary", {}, words.numbers), this.numbers), this.note, this.said);
      this.place.after(this.panel);
    }

    // What the view tells.
    drawn(state) {
      if (!state) return;
      this.state = state;
      this.play.textContent = state.playing ? words.pause : words.play;
      this.time.put(state.from, state.to, state.t);
      state.vary.forEach((one, i) => this.vary[i].put(one.from, one.to, one.value));
      const most = this.most ??= Math.max(...state.omega0.map(Math.abs)) * 1.5 || 3;
      state.omega0.forEach((w, i) => this.omega[i].put(Math.min(-most, w), Math.max(most, w), w));
      // What the text says of the figure it says of its still.
      this.step_()?.toggleAttribute("data-other", state.changed || state.t !== state.still);
      this.figure.toggleAttribute("data-changed", state.changed);
    }
    worded(told) {
      this.numbers.replaceChildren(...told.readouts.map((one) =>
        make("div", {}, make("dt", {}, one.name), make("dd", {}, one.value.replace(/-(?=\d)/g, "\u2212")))));
    }
    settled(state, told) {
      if (!state || state.playing) return;
      const said = "t = " + seconds(state.t) + "; " + told.readouts.map((one) => one.name + " " + one.value).join("; ");
      if (this.touched && said !== this.said.textContent) this.said.textContent = said;
      if (this.touched) polhodeLive.keep(this.id, state);
    }
    edited() { this.touched = true; }
    refused(why) { this.note.textContent = why; }
  }

  const figures = [...document.querySelectorAll("figure[data-stage]")].map((figure) => new Figure(figure));
  // Of those that were pressed, the one in view has the canvas.
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      const figure = figures.find((one) => one.place === target);
      if (isIntersecting && figure.wasLive && shown !== figure && !(shown && view.seen)) figure.open({ quiet: true });
    }
  }, { threshold: 0.4 });
  for (const figure of figures) seen.observe(figure.place);

  /// The figure that an address asks for.
  const follow = () => {
    const [id, query] = location.hash.slice(1).split("?");
    const figure = query && figures.find((one) => one.id === decodeURIComponent(id));
    if (!figure) return;
    figure.figure.closest("[id]").scrollIntoView();
    figure.open({ query });
  };
  addEventListener("hashchange", follow);
  follow();
})();
