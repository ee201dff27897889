# SPDX-License-Identifier: MIT
"""What the peers written in Python share: their arguments, the scene, and the measuring."""
import argparse
import json
import os
import re
import resource
import time

SIZE = (1920, 1080)
WARM_UP = 3  # frames: shaders, fonts, caches
PAPER_TOP, PAPER_BOTTOM = (0.93, 0.94, 0.95), (0.82, 0.85, 0.88)
GRID_HALF = 4.0  # the floor's grid, scene units from the middle


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("scene", help="JSON of write_scene; its frames are drawn in order")
    parser.add_argument("-o", "--output", required=True, help="folder for the PNG files")
    parser.add_argument("--full", action="store_true", help="also what is merely beautiful, as far as the peer can")
    parsed = parser.parse_args()
    os.makedirs(parsed.output, exist_ok=True)
    with open(parsed.scene, encoding="utf-8") as file:
        parsed.scene = json.load(file)
    return parsed


def plain(text):
    """Without TeX, for who cannot set it."""
    text = re.sub(r"\\vec ?|[${}\\]", "", text.replace(r"\cdot", "·").replace(r"\omega", "ω"))
    return text.replace("_1", "₁").replace("_2", "₂").replace("_3", "₃").replace("^2", "²")


def closed_points(curve):
    return curve["points"] + curve["points"][:1] if curve["closed"] else curve["points"]


def grid_lines(floor):
    """Ends of the floor's lines and whether each is a heavy one: four light ones lie between two of those."""
    step, half = floor["grid"] / 5.0, GRID_HALF
    count = round(half / step)
    for n in range(-count, count + 1):
        heavy = n % 5 == 0
        yield (n * step, -half, floor["z"]), (n * step, half, floor["z"]), heavy
        yield (-half, n * step, floor["z"]), (half, n * step, floor["z"]), heavy


def cpu_s():
    """CPU time of all threads of this process and of its children that have ended."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def measure(name, version, options, draw, write, cpu_of_others=lambda: 0.0):
    """Draws and writes every frame after the warm-up; one line of JSON tells what that cost."""
    frames = options.scene["frames"]
    for frame in frames[:WARM_UP]:
        draw(frame)
        write(os.path.join(options.output, "warm-up.png"))
    os.remove(os.path.join(options.output, "warm-up.png"))
    cpu, wall, cpu_drawing = cpu_s() + cpu_of_others(), time.monotonic(), 0.0
    for n, frame in enumerate(frames):
        before = cpu_s()
        draw(frame)
        cpu_drawing += cpu_s() - before
        write(os.path.join(options.output, f"{n:05d}.png"))
    cpu, wall = cpu_s() + cpu_of_others() - cpu, time.monotonic() - wall
    ms = 1000.0 / len(frames)
    print(json.dumps({"name": name + ", full" if options.full else name, "version": version,
                      "frames": len(frames), "cpu_ms": round(cpu * ms, 2), "wall_ms": round(wall * ms, 2),
                      "draw_cpu_ms": round(cpu_drawing * ms, 2)}))
