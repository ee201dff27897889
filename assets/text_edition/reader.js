// SPDX-License-Identifier: MIT
// Judges choices, orders and numbers, copies formulas, enlarges figures that a narrow screen shows small, and lets
// the keyboard scroll what is wider than the page. Without it everything can be read; with it nothing is kept beyond the page.
"use strict";
(() => {
  // In the language of the lesson.
  const words = JSON.parse(document.body.dataset.words);
  const say = (form, good, words, parts) => {
    const output = form.querySelector("output");
    output.className = good ? "good" : "bad";
    const first = document.createElement("p");
    first.textContent = words;
    output.replaceChildren(first, ...parts.map((part) => part.cloneNode(true)));
    first.scrollIntoView({ block: "nearest" });
  };
  const inside = (form, selector) =>
    [...form.querySelectorAll(".answer " + selector)].flatMap((part) =>
      [...part.children].filter((child) => !child.classList.contains("letter")));

  const judgeChoice = (form) => {
    const picked = form.querySelector("input:checked");
    if (!picked) return say(form, false, words.pickOne, []);
    const right = picked.value === form.dataset.answer;
    const reply = inside(form, `.reply[data-choice="${picked.value}"]`);
    say(form, right, right ? words.right : words.notRight, right ? [...reply, ...inside(form, ".because")] : reply);
    if (right) showMoments(form);
  };
  const showMoments = (form) => {
    if (form.querySelector(".answer .moments")) form.querySelector(".answer").open = true;
  };

  const judgeOrder = (form) => {
    const places = [...form.querySelectorAll("select")].map((select) => select.value);
    if (places.some((place) => place === "") || new Set(places).size !== places.length)
      return say(form, false, words.eachAPlace, []);
    const order = places.map((_, i) => String(places.indexOf(String(i + 1)) + 1)).join(" ");
    const right = order === form.dataset.answer;
    say(form, right, right ? words.right : words.notRight, right ? inside(form, ".because") : []);
  };

  // "4.2", "-4,200", "1.2e3", "1.2·10^3", "1.2 × 10³", with the unit of the question or without one.
  const numberOf = (text, unit) => {
    const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let typed = text.trim().replace(/[\u2212\u2013]/g, "-");
    // Points and commas are read on every page: a telephone may offer no other mark than its country's. Only 1,234 has two
    // meanings, of which an English page takes neither.
    const isTwofold = words.decimal === "." && /^[-+]?[1-9]\d{0,2},\d{3}(?!\d)/.test(typed);
    if (!isTwofold) typed = typed.replace(/^([-+]?\d*),(?=\d)/, "$1.");
    typed = typed.replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+/g, (power) => {
      const plain = [...power].map((c) => (c === "⁻" ? "-" : raised.indexOf(c))).join("");
      return /10$/.test(typed.slice(0, typed.indexOf(power))) ? "^" + plain : power;
    });
    const found = /^([-+]?(?:\d+\.?\d*|\.\d+))\s*(?:e([-+]?\d+)|[·×x*]\s*10\s*\^\s*\{?([-+]?\d+)\}?)?\s*(.*)$/i.exec(typed);
    if (!found) return null;
    // "15.3°", "15.3 degrees" and "15,3 Grad" for 15.3 deg, "2 kg m^2" for 2 kg m².
    const bare = (words) => words.replace(/[\s\u00a0·*^{}]/g, "").replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (c) => raised.indexOf(c))
      .replace(/⁻/g, "-").replace(/°|degrees?|Grad/, "deg");
    if (found[4] !== "" && bare(found[4]) !== bare(unit)) return null;
    return Number(found[1] + "e" + (found[2] || found[3] || "0"));
  };
  const judgeNumber = (form) => {
    const { value, within, unit, said } = form.dataset;
    const typed = numberOf(form.querySelector("input").value, unit);
    if (typed === null || !Number.isFinite(typed))
      return say(form, false, unit ? words.aNumberIn.replace("{0}", said) : words.aNumber, []);
    const right = Math.abs(typed - Number(value)) <= Number(within);
    say(form, right, right ? words.right : words.notRight, right ? inside(form, ".because") : []);
  };

  const judges = { choice: judgeChoice, order: judgeOrder, number: judgeNumber };
  for (const form of document.querySelectorAll("form.question")) {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const judge = judges[form.dataset.type];
      if (judge) judge(form);
    });
    const line = form.querySelector(".judge");
    if (line) line.hidden = false;
  }

  if (navigator.clipboard)
    for (const equation of document.querySelectorAll(".equation")) {
      const math = equation.querySelector("math");
      const note = equation.querySelector("annotation");
      const tex = math && (math.dataset.tex || (note && note.textContent.trim()));
      if (!tex) continue;
      const tag = equation.querySelector(".tag");
      const button = document.createElement("button");
      button.type = "button";
      button.className = "tex";
      button.textContent = "TeX";
      // Heard one after the other, buttons differ: an equation without a number is named by its first words.
      const said = math.getAttribute("alttext").split(" "), enough = 6;
      const name = tag ? tag.textContent : said.slice(0, enough).join(" ") + (said.length > enough ? " …" : "");
      button.setAttribute("aria-label", words.copyTexOf.replace("{0}", name));
      button.addEventListener("click", async () => {
        await navigator.clipboard.writeText(tex);
        button.textContent = words.copied;
        setTimeout(() => { button.textContent = "TeX"; }, 2000);
      });
      equation.append(button);
    }

  const asRead = (element) => {
    const copy = element.cloneNode(true);
    for (const math of copy.querySelectorAll("math")) math.replaceWith(math.getAttribute("alttext"));
    return copy.textContent.trim();
  };

  // A figure that is live is enlarged otherwise, and pictures of moments stand as large as they were drawn.
  const figures = [...document.querySelectorAll("figure:not([data-stage])")].filter((figure) => !figure.closest(".moments")).map((figure) => {
    const image = figure.querySelector("img");
    const shown = image.closest("picture") || image;
    const frame = document.createElement("div");
    frame.className = "frame";
    shown.replaceWith(frame);
    frame.append(shown);
    const button = document.createElement("button");
    button.type = "button";
    button.className = "larger";
    frame.after(button);
    const one = { figure, image, frame, button };
    const step = figure.closest(".step"), stage = figure.closest("section");
    const heading = (step && step.querySelector("h3")) || (stage && stage.querySelector("h2"));
    const title = heading ? asRead(heading) : "";
    const name = (text) => {
      button.textContent = text;
      if (title) button.setAttribute("aria-label", `${text}: ${title}`);
    };
    const enlarge = (is_large, at) => {
      figure.classList.toggle("large", is_large);
      name(is_large ? words.smaller : words.larger);
      if (is_large) frame.scrollLeft = at * frame.scrollWidth - frame.clientWidth / 2;
      letScroll();
    };
    one.toggle = (at) => enlarge(!figure.classList.contains("large"), at);
    name(words.larger);
    button.addEventListener("click", () => one.toggle(0.5));
    image.addEventListener("click", (event) => { if (!button.hidden) one.toggle(event.offsetX / image.clientWidth); });
    return one;
  });

  const wide = document.querySelectorAll(".formula, .wide, .long, .frame");
  const letScroll = () => {
    // At less than half of its pixels a figure's type is smaller than that of the text's notes.
    for (const { figure, image, button } of figures) {
      button.hidden = !figure.classList.contains("large") && image.clientWidth >= Number(image.getAttribute("width")) / 2;
      image.classList.toggle("small", !button.hidden);
    }
    for (const part of wide) {
      if (part.scrollWidth > part.clientWidth) {
        part.tabIndex = 0;
        part.setAttribute("role", "group");
        part.setAttribute("aria-label", words.wider);
      } else if (part.hasAttribute("tabindex")) {
        for (const name of ["tabindex", "role", "aria-label"]) part.removeAttribute(name);
      }
    }
  };
  letScroll();

  // Paper is light: what was chosen for a dark screen is chosen again, which browsers do not do by themselves.
  const choices = [...document.querySelectorAll("picture > source")].map((source) => [source, source.media]);
  addEventListener("beforeprint", () => choices.forEach(([source]) => { source.media = "not all"; }));
  addEventListener("afterprint", () => choices.forEach(([source, media]) => { source.media = media; }));

  let waits = 0;
  addEventListener("resize", () => {
    clearTimeout(waits);
    waits = setTimeout(letScroll, 150);
  });
})();
