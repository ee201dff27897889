#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does a long export keep its pace and its memory?

usage: long_sequence.py POLHODE [EXPORT ARGUMENTS]

Exports a film and prints how the last tenth compares with the first: CPU time and wall time of a frame, and
what the process holds in memory. Without arguments 10,000 frames of one scene, 480x270: a body that rolls, in a
stage of one step, so that all frames have the same things in them. Ends with 1 if a frame takes more than 5 %
more CPU time at the end, or memory has grown since the first tenth by more than 0.5 % (the allocator keeps a
megabyte more or less).
"""
import os
import subprocess
import sys
import tempfile
import time

LESSON = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "data", "app", "tiny.md")
USUAL = [LESSON, "--stage", "rolling", "--what", "figure", "--size", "480x270", "--each", "frame",
         "--fps", "1000", "--seconds", "10"]


def cpu_seconds(process):
    with open(f"/proc/{process}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident_kib(process):
    with open(f"/proc/{process}/status") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))


def watch(program, folder):
    """A sample after every hundredth of the way: frames, wall seconds, CPU seconds, KiB."""
    samples = []
    while program.poll() is None:
        try:
            frames = sum(name.endswith(".png") for name in os.listdir(folder))
            samples.append((frames, time.monotonic(), cpu_seconds(program.pid), resident_kib(program.pid)))
        except (OSError, StopIteration):
            pass  # not begun, or just ended
        time.sleep(0.25)
    return [sample for sample in samples if sample[0] > 10]


def pace(samples, begin, end):
    """Wall and CPU milliseconds of a frame between two numbers of frames."""
    inside = [sample for sample in samples if begin <= sample[0] <= end]
    first, last = inside[0], inside[-1]
    frames = last[0] - first[0]
    return 1e3 * (last[1] - first[1]) / frames, 1e3 * (last[2] - first[2]) / frames


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        arguments = sys.argv[2:] or USUAL
        program = subprocess.Popen([sys.argv[1], "export", *arguments, "-o", folder], stderr=subprocess.DEVNULL)
        samples = watch(program, folder)
        if program.returncode != 0:
            sys.exit(f"the export ended with {program.returncode}")
        total = sum(name.endswith(".png") for name in os.listdir(folder))
    drawing = [sample for sample in samples if sample[0] < total]
    tenth = total // 10
    wall_first, cpu_first = pace(drawing, 10, 10 + tenth)
    wall_last, cpu_last = pace(drawing, total - tenth, total)
    kib_first = next(sample[3] for sample in drawing if sample[0] >= tenth)
    kib_last = drawing[-1][3]
    growth = kib_last / kib_first - 1
    print(f"frames {total}")
    print(f"CPU ms a frame: first tenth {cpu_first:.3f}, last {cpu_last:.3f}, ratio {cpu_last / cpu_first:.3f}")
    print(f"wall ms a frame: first tenth {wall_first:.3f}, last {wall_last:.3f}, ratio {wall_last / wall_first:.3f}")
    print(f"memory: {kib_first} KiB after {tenth} frames, {kib_last} KiB at the end, growth {100 * growth:.2f} %")
    sys.exit(0 if cpu_last <= 1.05 * cpu_first and growth <= 0.005 else 1)


main()
