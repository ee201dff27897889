#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the benchmarks of pictures, each against what is required, and prints one table.

    cmake --preset bench && cmake --build --preset bench && tests/bench/rendering_benchmarks.py

CPU time is that of all threads (getrusage) and is to be trusted over wall time. What is compared takes turns within
this run; ratios are medians over the turns. Wall times and all that is said of two cores need a machine with nothing
else to do. What is missing (a peer's package, an option) is named in the table. Takes some 10 minutes; --quick some 3.
"""
import argparse
import filecmp
import json
import os
import pathlib
import random
import re
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time

from benchmark_table import Table

ROOT = pathlib.Path(__file__).resolve().parents[2]
LESSON = [ROOT / "tests/bench/poinsot.md", "--what", "figure", "--each", "frame"]
FPS = 25


class Missing(Exception):
    """Why something was not measured."""


class Usage:
    """What a process and its children took."""

    def __init__(self, cpu_s, wall_s, peak_mib):
        self.cpu_s, self.wall_s, self.peak_mib = cpu_s, wall_s, peak_mib


class Bench:
    """The programs, a scratch folder, and how they are run."""

    def __init__(self, build, scratch, options):
        self.polhode, self.tests = build / "app/polhode", build / "tests/bench"
        self.scratch, self.options = scratch, options
        for program in (self.polhode, self.tests / "render_bench", self.tests / "png_bench"):
            if not program.exists():
                sys.exit(f"rendering_benchmarks: {program} is not there; build the preset bench first")

    def run(self, command, environment=None, cores=None):
        """Output and usage of a command that ends by itself, held to those cores."""
        with tempfile.TemporaryFile(dir=self.scratch) as out, tempfile.TemporaryFile(dir=self.scratch) as err:
            start = time.monotonic()
            process = self.start(command, environment, out, err, cores)
            _, status, used = os.wait4(process.pid, 0)
            wall = time.monotonic() - start
            process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            err.seek(0)
            text, told = out.read().decode(), err.read().decode(errors="replace")
        if process.returncode:
            raise Missing((told.strip().splitlines() or [f"exit {process.returncode}"])[-1][:100])
        return text, Usage(used.ru_utime + used.ru_stime, wall, used.ru_maxrss / 1024)

    def start(self, command, environment=None, out=subprocess.DEVNULL, err=subprocess.DEVNULL, cores=None):
        hold = (lambda: os.sched_setaffinity(0, cores)) if cores else None
        return subprocess.Popen([str(part) for part in command], stdout=out, stderr=err, preexec_fn=hold,
                                env={**os.environ, **(environment or {})})

    def folder(self, name):
        return pathlib.Path(tempfile.mkdtemp(prefix=name + "-", dir=self.scratch))

    def export(self, folder, frames, size="1920x1080", extra=()):
        return [self.polhode, "export", *LESSON, "-o", folder, "--fps", FPS, "--seconds", frames / FPS, "--size", size,
                *extra]

    def per_frame(self, frames, size="1920x1080", extra=(), environment=None, cores=None):
        """CPU and wall ms of a frame of polhode export: of the frames between a short run and a longer one."""
        short = self.run(self.export(self.folder("short"), 10, size, extra), environment, cores)[1]
        longer = self.run(self.export(self.folder("long"), 10 + frames, size, extra), environment, cores)[1]
        return [1e3 * (b - a) / frames for a, b in ((short.cpu_s, longer.cpu_s), (short.wall_s, longer.wall_s))]

    def benchmarks(self, pattern, seconds, tests=None):
        """{name without its suffixes: (CPU ms, wall ms)} of render_bench, of another build if its folder is given."""
        text, _ = self.run([(tests or self.tests) / "render_bench", f"--benchmark_filter={pattern}",
                            "--benchmark_format=json", f"--benchmark_min_time={seconds}"])
        if not text.startswith("{"):
            return {}
        return {re.sub(r"/(process_time|real_time)", "", one["name"]): (one["cpu_time"], one["real_time"])
                for one in json.loads(text)["benchmarks"]}


def median(values):
    return statistics.median(values)


def ms(pair):
    return f"{pair[0]:.1f} CPU ms, {pair[1]:.1f} wall ms"


def medians(turns, name):
    """CPU and wall medians of a benchmark over the turns."""
    found = [turn[name] for turn in turns if name in turn]
    if not found:
        raise Missing(f"render_bench has no {name}")
    return tuple(median([one[i] for one in found]) for i in (0, 1))


def ratio(turns, above, below, which=0):
    """Median over the turns of above / below, CPU (0) or wall (1)."""
    both = [turn[above][which] / turn[below][which] for turn in turns if above in turn and below in turn]
    if not both:
        raise Missing(f"render_bench has no {above} or no {below}")
    return median(both)


# ---- what takes turns: our frame, its floor, the way of old, and the peers ------------------------------

OURS, FLOOR, LARGE, OLD = "BM_Frame/1080", "BM_ClearReadPng/1080", "BM_Frame/2160", "msaa4"
BEFORE = "before"  # BM_Frame of the build that --before names
ROLLING = "BM_FrameOfRolling/1080"  # with ticks on its curves
FILM = "BM_Film/1080"  # the same frames to files, as polhode export writes them: packed in a second thread
PEERS = [("VTK 9.1, MSAA 4x", "peer_vtk.py", 15), ("MuJoCo 2.2, 4 samples", "peer_mujoco", 15),
         ("matplotlib 3-D", "peer_matplotlib.py", 9)]


def take_turns(bench):
    """One dictionary of (CPU ms, wall ms) for each turn; and why a peer is missing."""
    scene = bench.scratch / "scene.json"
    scene.write_text(bench.run([bench.tests / "write_scene", bench.options.peer_frames])[0], encoding="utf-8")
    turns, missing = [], {}
    for _ in range(bench.options.turns):
        turn = bench.benchmarks("BM_Frame|BM_Film|BM_ClearReadPng|[Mm]saa4", bench.options.seconds)
        for name in [name for name in turn if re.search("msaa4", name, re.I)][:1]:
            turn[OLD] = turn[name]
        if bench.options.before:
            before = bench.benchmarks(OURS, bench.options.seconds, bench.options.before / "tests/bench")
            turn[BEFORE] = before[OURS]
        for _, program, _ in PEERS:
            for full in (False, True):
                key = (program, full)
                if key in missing:
                    continue
                try:
                    turn[key] = run_peer(bench, program, full, scene)
                except (Missing, OSError) as reason:
                    missing[key] = str(reason)
        turns.append(turn)
    return turns, missing


def run_peer(bench, program, full, scene):
    folder = bench.folder("peer")
    if program.endswith(".py"):
        command = ["/usr/bin/python3", ROOT / "tests/bench/peers" / program, scene, "-o", folder,
                   *(["--full"] if full else [])]
    else:
        command = [bench.tests / program, scene, folder, *(["full"] if full else [])]
    told = json.loads(bench.run(command)[0])
    return told["cpu_ms"], told["wall_ms"]


def frame_benchmarks(table, bench):
    turns, missing = take_turns(bench)
    ours, film = medians(turns, OURS), medians(turns, FILM)
    table.row("1080p frame to PNG, moving camera (BM_Frame): CPU", "<= 65 ms", ms(ours), ours[0] <= 65)
    table.row("with ticks of rolling / without", "<= 1.3", *at_most(1.3, turns, ROLLING, OURS))
    table.row("the same to files, packed in a second thread (BM_Film)", "", ms(film))
    table.row("its frames/s (stretch: 40)", ">= 30", f"{1e3 / film[1]:.1f}", 1e3 / film[1] >= 30)
    for title, program, required in PEERS:
        for full in (True, False):
            peer_benchmark(table, turns, missing, (program, full), title + (", all the look" if full else ", the least"),
                        required)
    guarded(table, "our own MSAA path / ours, CPU", ">= 4", lambda: at_least(4, turns, OLD))
    if bench.options.before:
        guarded(table, "BM_Frame of the build before / ours, CPU", ">= 4", lambda: at_least(4, turns, BEFORE))
    guarded(table, "CPU of a frame / of clear + read + PNG alone", "<= 3", lambda: at_most(3, turns, OURS, FLOOR))
    guarded(table, "4K frame / 1080p frame, CPU", "<= 4.2", lambda: at_most(4.2, turns, LARGE, OURS))


def peer_benchmark(table, turns, missing, key, title, required):
    """The requirement is one of frames/s, as its sources count; CPU stands beside it."""
    benchmark = f"{title} / ours: frames/s (CPU)"
    if key in missing:
        table.row(benchmark, f">= {required}", "left out: " + missing[key])
        return
    pace = ratio(turns, key, FILM, 1)
    cpu, wall = medians(turns, key)
    table.row(benchmark, f">= {required}", f"{pace:.1f} ({ratio(turns, key, OURS):.1f}): {cpu:.0f} CPU ms, "
              f"{wall:.0f} wall", pace >= required)


def at_least(required, turns, above):
    cpu, wall = ratio(turns, above, OURS, 0), ratio(turns, above, OURS, 1)
    return f"{cpu:.2f} CPU, {wall:.2f} wall ({medians(turns, above)[0]:.0f} CPU ms)", cpu >= required


def at_most(required, turns, above, below):
    cpu = ratio(turns, above, below)
    return f"{cpu:.2f} ({medians(turns, above)[0]:.1f} / {medians(turns, below)[0]:.1f} CPU ms)", cpu <= required


def quality_benchmark(table, bench):
    """Of the picture that users get by default and of plain multisampling, each against one drawn 4 x 4 finer."""
    told = json.loads(bench.run([bench.polhode, "measure", "--rendering", "--json"])[0])
    rows = {row["setting"]: row for row in told["rows"]}
    if "normal" not in rows or OLD not in rows:
        raise Missing(f"measure --rendering has no normal and {OLD}, but {', '.join(rows)}"[:60])
    ours, old = rows["normal"], rows[OLD]
    table.row("error against a picture 4 x 4 finer, ours / MSAA 4x", "<= 1", f"{ours['rms'] / old['rms']:.2f} (rms "
              f"{ours['rms']:.2f} / {old['rms']:.2f} levels)", ours["rms"] <= old["rms"])
    for name in ("draft", "normal", "fine", OLD):
        if name in rows:
            row = rows[name]
            table.row(f"drawing alone, {name}", "", f"{row['cpu_ms_per_frame']:.1f} CPU ms, rms {row['rms']:.2f}")


# ---- PNG, memory ------------------------------------------------------------------------------------------


def png_benchmarks(table, bench):
    folder = bench.folder("picture")
    bench.run(bench.export(folder, 1))
    picture = next(folder.glob("*.png"))
    told = json.loads(bench.run([bench.tests / "png_bench", picture, bench.options.png_turns])[0])
    fast, small, default = (told[name] for name in ("fast", "small", "default"))
    table.row("PNG of a 1080p frame, --png fast", "<= 30 ms", f"{fast['ms']:.1f} CPU ms", fast["ms"] <= 30)
    table.row("its size / libpng's default", "<= 1.15", f"{fast['bytes'] / default['bytes']:.3f} "
              f"({fast['bytes'] // 1000} / {default['bytes'] // 1000} kB)", fast["bytes"] <= 1.15 * default["bytes"])
    table.row("libpng's default; --png small", "", f"{default['ms']:.0f} ms; {small['ms']:.0f} ms, "
              f"{small['bytes'] / default['bytes']:.3f} of the size")


def memory_benchmark(table, bench):
    used = bench.run(bench.export(bench.folder("large"), 12, "3840x2160"))[1]
    table.row("memory of an export at 4K", "<= 400 MiB", f"{used.peak_mib:.0f} MiB", used.peak_mib <= 400)


# ---- a long sequence --------------------------------------------------------------------------------------


def cpu_and_memory_of(pid):
    """s and MiB, of all threads, so far."""
    stat = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    pages = int(pathlib.Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1])
    return (int(stat[11]) + int(stat[12])) / os.sysconf("SC_CLK_TCK"), pages * resource.getpagesize() / 2**20


def long_benchmarks(table, bench):
    """CPU of a frame in stretches at the start and at the end of one export of small frames, and its memory at both."""
    frames, stretch = bench.options.long_frames, bench.options.long_frames // 40
    folder = bench.folder("long")
    bench.run(bench.export(bench.folder("first"), 1, "320x180"))
    stage = next(bench.scratch.glob("first-*/*.png")).name.split("-frame")[0]
    process = bench.start(bench.export(folder, frames + 1, "320x180"))
    around = [i * stretch for i in range(-2, 3)]
    marks = [10 + 2 * stretch + i for i in around] + [frames // 2 + i for i in around] + [
        frames - 2 * stretch + i for i in around]
    seen = []
    try:
        for mark in marks:
            while not (folder / f"{stage}-frame{mark:0{len(str(frames))}d}.png").exists():
                if process.poll() is not None:
                    raise Missing("the export ended early")
                time.sleep(0.02)
            seen.append(cpu_and_memory_of(process.pid))
    finally:
        process.kill()
        process.wait()
    cost = [b[0] - a[0] for a, b in zip(seen, seen[1:])]
    late = median(cost[10:]) / median(cost[:4])
    table.row(f"frame {frames:,} / frame 10 of one export", "1.00 +- 0.05", f"{late:.3f} "
              f"({1e3 * cost[0] / stretch:.1f} CPU ms at 320x180)", abs(late - 1) <= 0.05)
    # Caches of glyphs fill for some thousand frames. Pages come and go by a MiB: medians of five looks, and 0.1 beyond.
    growth = median([memory for _, memory in seen[10:]]) - median([memory for _, memory in seen[5:10]])
    table.row(f"its memory, frame {frames:,} - frame {frames // 2:,}", "0 MiB",
              f"{growth:+.2f} MiB of {seen[-1][1]:.0f}", growth <= 0.1)


# ---- shards and kills -------------------------------------------------------------------------------------


class Kills:
    """Exports in shards whose processes are killed at random times until `wanted` were."""

    FRAMES, SIZE = 64, "320x180"

    def __init__(self, bench):
        self.bench, self.seed = bench, random.randrange(10**6)
        self.chance = random.Random(self.seed)
        self.alone = bench.folder("alone")
        self.whole_s = bench.run(bench.export(self.alone, self.FRAMES, self.SIZE))[1].wall_s
        self.count = self.partial = 0

    def export(self, shards, wanted):
        """One export in so many shards, in any order, again and again until its manifest is there, and the marker,
        which a process killed just after it leaves to the next, is not."""
        folder = self.bench.folder("killed")
        while not (folder / "manifest.json").exists() or (folder / ".polhode-unfinished.json").exists():
            order = list(range(1, shards + 1))
            self.chance.shuffle(order)
            for shard in order:
                command = self.bench.export(folder, self.FRAMES, self.SIZE,
                                            ["--shard", f"{shard}/{shards}", "--skip-existing"])
                if self.count < wanted:
                    self.kill(command, self.chance.uniform(0, 0.2 + self.whole_s / shards))
                    self.partial += count_different(self.alone, folder)
                else:
                    self.bench.run(command)
        return folder

    def kill(self, command, after_s):
        process = self.bench.start(command)
        try:
            process.wait(after_s)
        except subprocess.TimeoutExpired:
            process.send_signal(self.chance.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT]))
            process.wait()
            self.count += 1


def kill_benchmark(table, bench):
    """Shards 1..8 in any order, each killed and started again at random times, against one run alone."""
    kills = Kills(bench)
    for shards in range(1, 9):
        wanted, first = bench.options.kills * shards // 8, True
        while first or kills.count < wanted:
            first = False
            if different := differences(kills.alone, kills.export(shards, wanted)):
                table.row(f"shards 1...8 killed and resumed (seed {kills.seed})", "bytes equal",
                          f"with {shards} shards: {', '.join(different[:3])}", False)
                return
    table.row(f"shards 1...8, any order, killed {kills.count} times (seed {kills.seed})", "bytes equal",
              f"equal; {kills.partial} partial files", kills.partial == 0)


def differences(one, other):
    """Names that only one of the folders has, or whose bytes differ."""
    names = set(os.listdir(one)) & set(os.listdir(other))
    _, different, errors = filecmp.cmpfiles(one, other, names, shallow=False)
    return sorted(set(os.listdir(one)) ^ set(os.listdir(other)) | set(different) | set(errors))


def count_different(alone, folder):
    """Pictures under their final name that are not those of the run alone."""
    names = [name for name in os.listdir(folder) if name.endswith(".png") and not name.startswith(".")]
    _, different, errors = filecmp.cmpfiles(alone, folder, names, shallow=False)
    return len(different) + len(errors)


# ---- two cores ----------------------------------------------------------------------------------------------


def shared(bench, frames, shards, cores=None):
    """Wall s of an export in so many processes of one drawing thread each, each held to a core if cores are given."""
    folder = bench.folder("shared")
    start = time.monotonic()
    processes = [bench.start(bench.export(folder, frames, extra=["--shard", f"{i + 1}/{shards}"]),
                             {"LP_NUM_THREADS": "1"}, cores=cores and {cores[i]}) for i in range(shards)]
    if any([process.wait() for process in processes]):
        raise Missing("an export in shards failed")
    return time.monotonic() - start


def core_benchmarks(table, bench):
    """What a second core is worth. Counted are the frames between a short run and a longer one, not starting up. A
    process with one drawing thread keeps more than one core busy, since it encodes in another thread; so the same is
    also measured with the one process held to one core."""
    cores = sorted(os.sched_getaffinity(0))[:2]
    if len(cores) < 2:
        raise Missing("this machine has one core")
    few, many = 10, 10 + bench.options.export_frames
    gains = {"processes": [], "processes held": [], "threads": [], "threads held": []}
    for _ in range(bench.options.turns):
        free, held, two = (shared(bench, many, *how) - shared(bench, few, *how)
                           for how in ((1,), (1, cores), (2, cores)))
        gains["processes"].append(free / two)
        gains["processes held"].append(held / two)
        free, held, two = (bench.per_frame(many - few, environment={"LP_NUM_THREADS": str(count)}, cores=on)[1]
                           for count, on in ((1, None), (1, {cores[0]}), (2, None)))
        gains["threads"].append(free / two)
        gains["threads held"].append(held / two)
    for name, benchmark in (("processes", "two processes / one, LP_NUM_THREADS=1"),
                            ("processes held", "two on two cores / one on one core, LP_NUM_THREADS=1"),
                            ("threads", "one process, LP_NUM_THREADS 2 / 1"),
                            ("threads held", "one process, 2 on two cores / 1 on one core")):
        gain = median(gains[name])
        table.row(benchmark, ">= 1.8", f"{gain:.2f} x the frames/s", gain >= 1.8)


def guarded(table, benchmark, required, measure):
    try:
        measured, holds = measure()
        table.row(benchmark, required, measured, holds)
    except Missing as reason:
        table.row(benchmark, required, f"not measured: {reason}")


PARTS = {"frame": frame_benchmarks, "quality": quality_benchmark, "png": png_benchmarks, "memory": memory_benchmark,
         "long": long_benchmarks, "kills": kill_benchmark, "cores": core_benchmarks}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", help=f"some of {', '.join(PARTS)} (all)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/bench")
    parser.add_argument("--before", type=pathlib.Path, metavar="DIR",
                        help="a bench build of an earlier version beside it")
    parser.add_argument("--quick", action="store_true", help="fewer turns, frames and kills")
    options = parser.parse_args()
    if unknown := set(options.parts) - set(PARTS):
        parser.error(f"no such part: {', '.join(unknown)}")
    quick = options.quick
    options.before = options.before and options.before.resolve()
    options.turns, options.seconds, options.peer_frames = (1, 0.5, 6) if quick else (5, 1, 12)
    options.export_frames, options.png_turns = (20, 3) if quick else (60, 9)
    options.long_frames, options.kills = (1000, 24) if quick else (10000, 200)

    table = Table()
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(options.build.resolve(), pathlib.Path(scratch), options)
        for name in options.parts or PARTS:
            try:
                PARTS[name](table, bench)
            except Missing as reason:
                table.row(f"({name})", "", f"not measured: {reason}")
    print(f"{table.missed} do not hold" if table.missed else "all that was measured holds")
    return 1 if table.missed else 0


if __name__ == "__main__":
    sys.exit(main())
