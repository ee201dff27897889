#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the benchmarks of the window, each against what is required, and prints one table.

    cmake --preset bench && cmake --build --preset bench && tests/bench/window_benchmarks.py

`polhode play` under Xvfb, by its own log of frames (POLHODE_FRAME_LOG): a line "t cpu_ms moving full" for each. Needs
Xvfb, xdotool, and a machine with nothing else to do. Takes some 2 minutes; --quick some 40 s.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from benchmark_table import Table

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = [("euler-equations", "frames"), ("euler-equations", "tensor-turns"), ("euler-equations", "components"),
          ("euler-equations", "poinsot"), ("euler-equations", "trust"), ("intermediate-axis", "map"),
          ("intermediate-axis", "three-spins"), ("numerical-lab", "ghost")]
PATIENCE_S = 60


class Display:
    """Xvfb; ends with its block."""

    def __init__(self, size, without_gl=False):
        out, into = os.pipe()
        command = ["Xvfb", "-displayfd", str(into), "-screen", "0", f"{size}x24", "-nolisten", "tcp", "-noreset"]
        self.server = subprocess.Popen(command + ["-extension", "GLX"] * without_gl, pass_fds=[into],
                                       stderr=subprocess.DEVNULL)
        os.close(into)
        with os.fdopen(out) as said:
            self.name = ":" + said.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def act(self, *words):
        subprocess.run(["xdotool", *words], env={**os.environ, "DISPLAY": self.name}, check=True,
                       stdout=subprocess.DEVNULL)


class Frame:
    def __init__(self, line):
        t, cpu_ms, moving, full = line.split()
        self.t, self.cpu_ms, self.moving, self.full = float(t), float(cpu_ms), moving == "1", full == "1"


class Play:
    """polhode play with a home of its own; ends with its block."""

    def __init__(self, polhode, display, lesson, stage):
        self.home, self.display = tempfile.TemporaryDirectory(), display
        self.log = pathlib.Path(self.home.name, "frames")
        environment = {**os.environ, "DISPLAY": display.name, "HOME": self.home.name, "XDG_STATE_HOME": self.home.name,
                       "POLHODE_FRAME_LOG": str(self.log), "POLHODE_LESSONS": str(ROOT / "lessons")}
        self.started = time.monotonic()
        self.process = subprocess.Popen([polhode, "play", lesson, "--stage", stage], env=environment,
                                        stderr=subprocess.DEVNULL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.home.cleanup()

    def frames(self):
        text = self.log.read_text() if self.log.exists() else ""
        return [Frame(line) for line in text[:text.rfind("\n") + 1].splitlines()]

    def wait(self, holds):
        """Until the frames are as they should be; they."""
        end = time.monotonic() + PATIENCE_S
        while True:
            frames = self.frames()
            if holds(frames):
                return frames
            if time.monotonic() > end or self.process.poll() is not None:
                sys.exit("window_benchmarks: polhode play does not do what is waited for")
            time.sleep(0.005)

    def wait_for_rest(self):
        quiet_s = 0.5
        return self.wait(lambda f: f and f[-1].full and not f[-1].moving and time.monotonic() - f[-1].t > quiet_s)

    def press(self, *keys):
        self.display.act("key", "--delay", "2", *keys)

    def cpu_s(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def go_to_last_step(self):
        """The title is not asked: the stage's last step is one before the next stage."""
        self.press("Down", "Left")
        self.wait_for_rest()


def first_frame(table, polhode, display):
    """From the start of the program to the first picture, and to the first of full quality."""
    runs = []
    for _ in range(3):
        with Play(polhode, display, "euler-equations", "poinsot") as play:
            frames = play.wait(lambda f: any(one.full for one in f))
            runs.append((frames[0].t - play.started, next(f.t for f in frames if f.full) - play.started))
    first, full = (statistics.median(one[i] for one in runs) for i in (0, 1))
    table.row("first frame after the start", "<= 0.6 s", f"{first:.2f} s; of full quality {full:.2f} s", first <= 0.6)


def moving(table, play, name, seconds):
    """Frames a second while playing, and how soon the picture is full again."""
    before = len(play.frames())
    play.press("space")
    play.wait(lambda f: any(one.moving for one in f[before:]))
    time.sleep(seconds)
    play.press("space")
    played = [f for f in play.wait_for_rest()[before:]]
    last = max(i for i, f in enumerate(played) if f.moving)
    times = [f.t for f in played[:last + 1] if f.moving]
    times = times[len(times) // 4:]  # it has found its resolution
    if len(times) < 3:
        table.row(f"frames a second, {name}", ">= 30", "it hardly moves", False)
        return
    rate = (len(times) - 1) / (times[-1] - times[0])
    gaps = sorted(b - a for a, b in zip(times, times[1:]))
    cpu = statistics.median(f.cpu_ms for f in played if f.moving)
    measured = f"{rate:.1f}; 95 % within {1e3 * gaps[int(0.95 * (len(gaps) - 1))]:.0f} ms; {cpu:.1f} CPU ms"
    table.row(f"frames a second, {name}", ">= 30", measured, rate >= 30)
    full = next(f.t for f in played[last:] if f.full) - played[last].t
    table.row(f"full quality after rest, {name}", "<= 0.3 s", f"{full:.2f} s", full <= 0.3)


def idle(table, play, name, seconds):
    play.wait_for_rest()
    before, frames = play.cpu_s(), len(play.frames())
    time.sleep(seconds)
    used = play.cpu_s() - before
    table.row(f"CPU time of {seconds} s at rest, {name}", "<= 0.03 s/s",
              f"{used:.2f} s, {len(play.frames()) - frames} frames", used <= 0.03 * seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--polhode", type=pathlib.Path, default=ROOT / "build/bench/app/polhode")
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("--without-gl", action="store_true", help="a display without OpenGL: the plain window")
    parser.add_argument("--quick", action="store_true", help="fewer stages, shorter")
    options = parser.parse_args()
    if not options.polhode.exists():
        sys.exit(f"window_benchmarks: {options.polhode} is not there; build the preset bench first")
    seconds, stages = (2, STAGES[:4:3]) if options.quick else (5, STAGES)

    table = Table()
    with Display(options.size, options.without_gl) as display:
        first_frame(table, options.polhode, display)
        for lesson, stage in stages:
            with Play(options.polhode, display, lesson, stage) as play:
                play.wait_for_rest()
                play.go_to_last_step()
                moving(table, play, stage, seconds)
                if stage in ("poinsot", "ghost"):
                    idle(table, play, stage, 3)
    print(f"{table.missed} do not hold" if table.missed else "all that was measured holds")
    return 1 if table.missed else 0


if __name__ == "__main__":
    sys.exit(main())
