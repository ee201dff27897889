// SPDX-License-Identifier: MIT
// Looks for words among the headings and equations of the page, which are all there without it.
"use strict";
(() => {
  const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  const said = JSON.parse(document.body.dataset.words);
  // A formula as one types it: "dl/dt=n" of dL/dt = N, "domega/dt". Left out is what may be: brackets, signs of products,
  // the marks of scripts.
  const names = { "ω": "omega", "θ": "theta", "φ": "phi", "ϕ": "phi", "ψ": "psi", "α": "alpha", "β": "beta", "λ": "lambda", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau", "−": "-", "×": "x" };
  const typed = (text) => plain(text.normalize("NFKD")).replace(/./gu, (c) => names[c] || c).replace(/[\s*∗·⋅^_(){}[\]→ˆ˙¨\u2061-\u2064]/g, "");
  const lineOf = (node) => {
    if (node.nodeName === "annotation") return "";
    const parts = [...node.children].map(lineOf);
    if (node.nodeName === "mfrac") return parts.join("/");
    if (node.nodeName === "msqrt") return "sqrt" + parts.join("");
    return parts.length > 0 ? parts.join("") : node.textContent;
  };
  const form = document.getElementById("search");
  const sought = document.getElementById("sought");
  const found = document.getElementById("found");
  const parts = [...document.querySelectorAll("#all details")].map((details) => ({
    details,
    entries: [...details.querySelectorAll("li")].map((item) => ({
      item,
      text: plain(item.dataset.words),
      formulas: [...item.querySelectorAll("math")].map((math) => typed(lineOf(math))),
    })),
  }));

  // The keyboard scrolls what is wider than the page, where it is seen.
  const letScroll = () => {
    for (const part of document.querySelectorAll(".long")) {
      if (part.scrollWidth > part.clientWidth && part.clientWidth > 0) {
        part.tabIndex = 0;
        part.setAttribute("role", "group");
        part.setAttribute("aria-label", said.wider);
      } else {
        for (const name of ["tabindex", "role", "aria-label"]) part.removeAttribute(name);
      }
    }
  };

  const show = () => {
    const formula = typed(sought.value);
    const isFormula = formula.length > 1 && /[^\p{L}]/u.test(formula);
    const words = plain(sought.value).split(/\s+/).filter((word) => word !== "");
    const isSearching = words.length > 0;
    document.documentElement.classList.toggle("searching", isSearching);
    let count = 0;
    for (const { details, entries } of parts) {
      let here = 0;
      for (const { item, text, formulas } of entries) {
        item.hidden = !words.every((word) => text.includes(word)) && !(isFormula && formulas.some((one) => one.includes(formula)));
        if (!item.hidden) ++here;
      }
      details.open = isSearching && here > 0;
      details.classList.toggle("empty", here === 0);
      count += here;
    }
    found.textContent = !isSearching ? "" : count === 0 ? said.nothing : count === 1 ? said.one : said.several.replace("{0}", count);
    letScroll();
  };

  sought.addEventListener("input", show);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    document.querySelector("#all li:not([hidden]) a")?.focus();
  });
  form.hidden = false;
  show();

  for (const { details } of parts) details.addEventListener("toggle", letScroll);
  let waits = 0;
  addEventListener("resize", () => {
    clearTimeout(waits);
    waits = setTimeout(letScroll, 150);
  });
})();
