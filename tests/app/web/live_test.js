// SPDX-License-Identifier: MIT
// live_test.js POLHODE_JS POLHODE LESSONS: what ./web has built, called as a page calls it, held against the program.
// Without a browser there is no canvas; all else is the same.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const { readFileSync } = require("node:fs");

delete globalThis.fetch;  // what emscripten of Debian 12 writes takes it for a browser's
const [script, program, lessons] = process.argv.slice(2);
const kWidth = 800;

const opened = async () => {
  const module = await require(script)({ print() {}, printErr() {} });
  const types = (list) => list.map((value) => (typeof value === "string" ? "string" : "number"));
  const call = (name, ...list) => module.ccall("polhode_" + name, "number", types(list), list);
  const said = (name) => module.ccall("polhode_" + name, "string", [], []);
  const json = (name) => JSON.parse(said(name));
  return { call, said, state: () => json("state"), words: () => json("words"), choices: () => json("choices") };
};
const lesson = (id) => readFileSync(`${lessons}/${id}.md`, "utf8");
/// Drawing is refused, for there is no canvas, but hands then know where things are.
const layOut = (live) => {
  assert.equal(live.call("draw", kWidth, live.call("height_for", kWidth), 0, 1), 0);
  assert.match(live.said("message"), /canvas/);
};
/// polhode trace: ω and the attitude at these times, of the motion that a state tells of.
const traced = (state, times) => {
  const rows = execFileSync(program, ["trace", "--inertia", state.moments.join(), "--omega", state.omega0.join(),
    "--attitude", state.attitude0.join(), "--times", times.join(), "--columns", "w1,w2,w3,qw,qx,qy,qz"], { encoding: "utf8" });
  return rows.trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
};
const norm = (list) => Math.hypot(...list);
const apart = (a, b) => norm(a.map((one, i) => one - b[i]));

const tests = {
  async "a lesson opens, and its steps are shown"(live) {
    assert.equal(live.said("state"), "null");
    assert.equal(live.call("open_lesson", lesson("euler-equations"), "euler-equations.md"), 1, live.said("message"));
    let shown = 0;
    for (let stage = 1; stage <= 60; ++stage)
      for (let step = 1; step <= 30; ++step)
        if (live.call("show", stage, step)) {
          const state = live.state(), words = live.words();
          assert.equal(state.stage, stage);
          assert.equal(state.step, step);
          assert.equal(state.t, state.still);
          assert.ok(words.alt.length > 20 && live.call("height_for", kWidth) > 100);
          ++shown;
        } else assert.notEqual(live.said("message"), "");
    assert.ok(shown > 50, `${shown} steps with a figure`);
  },

  async "what cannot be is refused in words"(live) {
    assert.equal(live.call("open_lesson", "# nothing", "x.md"), 0);
    assert.notEqual(live.said("message"), "");
    assert.equal(live.call("open_scene", 'body = "textbook"\nomega = [0.1, 3, 0.1]\nshow = ["shape", "omega"]', ""), 1);
    assert.equal(live.call("set_moments", 1, 1, 3), 0);
    assert.match(live.said("message"), /I/);
    assert.equal(live.call("set_omega", NaN, 0, 0), 0);
    assert.equal(live.call("set_body", "cloud"), 0);
    assert.equal(live.call("undo"), 0);
    assert.equal(live.call("attach", "#nowhere"), 0);
    assert.match(live.said("message"), /stays a picture/);
  },

  async "after a drag of ω the motion is that of polhode trace"(live) {
    live.call("open_lesson", lesson("euler-equations"), "euler-equations.md");
    let dragged = 0;
    for (let stage = 1; stage <= 60 && dragged < 5; ++stage) {
      if (!live.call("show", stage, 1)) continue;
      layOut(live);
      const before = live.state();
      if (before.tips.length === 0 || !before.torque_free) continue;
      const [tip] = before.tips, at = [tip.x + 31, tip.y - 17];
      assert.equal(live.call("pointer", 0, tip.x, tip.y, 12), 2);
      live.call("pointer", 1, ...at, 12);
      assert.equal(live.said("message"), "");
      live.call("pointer", 2, ...at, 12);
      live.call("set_time", 0);
      const start = live.state();
      assert.ok(start.changed);
      assert.ok(Math.abs(start.T - before.T) <= 1e-12 * before.T, "T is kept");
      start.attitude0 = start.quaternion;
      const times = [0.1, 0.7, 1.9].map((part) => part * start.duration);
      const rows = traced(start, times);
      times.forEach((t, i) => {
        if (!live.call("set_time", t)) return;
        const now = live.state(), [w, q] = [rows[i].slice(0, 3), rows[i].slice(3)];
        assert.ok(apart(now.omega, w) <= 1e-12 * norm(w), `stage ${stage}, t = ${t}: ω is ${now.omega}, not ${w}`);
        const sign = now.quaternion.reduce((sum, one, k) => sum + one * q[k], 0) < 0 ? -1 : 1;
        assert.ok(apart(now.quaternion.map((one) => sign * one), q) <= 1e-12, `stage ${stage}, t = ${t}: the attitude`);
      });
      ++dragged;
    }
    assert.ok(dragged >= 3, `${dragged} figures`);
  },

  async "a drag beside ω turns the camera, half a turn over the height"(live) {
    live.call("open_scene", 'body = "textbook"\nomega = [0.1, 3, 0.1]\nshow = ["shape", "omega"]', "");
    layOut(live);
    const height = live.call("height_for", kWidth), before = live.state().camera;
    assert.equal(live.call("pointer", 0, 4, 4, 12), 1);
    live.call("pointer", 1, 44, 24, 12);
    live.call("pointer", 2, 44, 24, 12);
    const after = live.state().camera, grid = 1e-4 * Math.PI / 180;
    assert.ok(Math.abs(after.azimuth - (before.azimuth - 40 * Math.PI / height)) <= grid);
    assert.ok(Math.abs(after.elevation - (before.elevation + 20 * Math.PI / height)) <= grid);
  },

  async "a state costs little"(live) {
    live.call("open_scene", 'body = "textbook"\nomega = [0.1, 3, 0.1]\nshow = ["shape", "omega"]', "");
    const begin = process.hrtime.bigint(), kStates = 200;
    for (let i = 0; i < kStates; ++i) live.call("set_time", 0.01 * i);
    const each_us = Number(process.hrtime.bigint() - begin) / 1e3 / kStates;
    console.log(`  set_time: ${each_us.toFixed(1)} µs`);
  },
};

(async () => {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test(await opened());
      console.log("ok: " + name);
    } catch (error) {
      ++failed;
      console.log("FAILED: " + name + "\n" + (error.stack ?? error));
    }
  }
  process.exit(failed ? 1 : 0);
})();
