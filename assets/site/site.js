// SPDX-License-Identifier: MIT
// Looks for words among the headings and equations of the page, which are all there without it.
"use strict";
(() => {
  const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  const said = JSON.parse(document.body.dataset.words);
  const form = document.getElementById("search");
  const sought = document.getElementById("sought");
  const found = document.getElementById("found");
  const parts = [...document.querySelectorAll("#all details")].map((details) => ({
    details,
    entries: [...details.querySelectorAll("li")].map((item) => ({ item, text: plain(item.dataset.words) })),
  }));

  const show = () => {
    const words = plain(sought.value).split(/\s+/).filter((word) => word !== "");
    const isSearching = words.length > 0;
    document.documentElement.classList.toggle("searching", isSearching);
    let count = 0;
    for (const { details, entries } of parts) {
      let here = 0;
      for (const { item, text } of entries) {
        item.hidden = !words.every((word) => text.includes(word));
        if (!item.hidden) ++here;
      }
      details.open = isSearching && here > 0;
      details.classList.toggle("empty", here === 0);
      count += here;
    }
    found.textContent = !isSearching ? "" : count === 0 ? said.nothing : count === 1 ? said.one : said.several.replace("{0}", count);
  };

  sought.addEventListener("input", show);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    document.querySelector("#all li:not([hidden]) a")?.focus();
  });
  form.hidden = false;
  show();
})();
