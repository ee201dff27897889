#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the fuzzers of the preset fuzz, one after the other, and counts what they tried.

  cmake --preset fuzz && cmake --build --preset fuzz
  tests/fuzz/fuzz.py [--seconds 60] [--rounds 1] [TARGET ...]

Seeds are lessons, formulas, pictures and records of this checkout, and the inputs in tests/data/fuzz. What is learned
stays in build/fuzz/corpus; a finding is shown and kept in build/fuzz/findings. Mend it, and put its input, as small as it
goes (NAME_fuzzer -minimize_crash=1), into tests/data/fuzz/TARGET, which every ./check tries. Ends with 1 where there is one.
"""

import argparse
import os
import pathlib
import re
import struct
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "fuzz"

# The longest input of each target, bytes: what is longer is tried by tests of limits.
LONGEST = {
    "lesson": 6000, "front_matter": 2000, "tex": 500, "formula": 500, "text": 500, "expression": 300, "line": 200, "answer": 200,
    "png": 4000, "record": 2000, "state": 1000, "report": 2000, "command": 300,
}
MOST_MEBIBYTES = 256  # of one request for memory


def parts_of_lessons():
    """Each stage of each lesson behind its front matter; and the front matters."""
    files = sorted((ROOT / "lessons").glob("*-*.md")) + sorted((ROOT / "tests/data/app").glob("*.md"))
    invalid = sorted((ROOT / "tests/data/lessons/invalid").glob("*.md"))
    stages, matters = [path.read_bytes() for path in invalid], []
    for path in files:
        text = path.read_text()
        match = re.match(r"\+\+\+\n(.*?)\n\+\+\+\n", text, re.DOTALL)
        if not match:
            continue
        matter = match.group(1)
        matters.append(re.sub(r"(?m)^(format|id) *=.*\n", "", matter).encode())
        for stage in re.split(r"(?m)^(?=# )", text[match.end():]):
            stages.append(f"+++\n{matter}\n+++\n{stage}".encode())
            small = "format = 1\nid = \"a\"\ntitle = \"A\"\n[scene]\nbody = \"textbook\"\nomega = [0.9, 0.4, 1.0]"
            stages.append(f"+++\n{small}\n+++\n{stage}".encode())
    return stages, matters


def lines_of(path):
    return [line for line in (ROOT / path).read_text().splitlines() if line and not line.startswith("#")]


def small_png(color_type, bits, interlaced):
    """Of 5 x 3 pixels and what such a picture may have beside them."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color_type]
    rows = b"".join(bytes([filter_type]) + bytes(range((5 * channels * bits + 7) // 8)) for filter_type in (1, 2, 4))
    parts = [(b"IHDR", struct.pack(">IIBBBBB", 5, 3, bits, color_type, 0, 0, int(interlaced)))]
    if color_type == 3:
        parts += [(b"PLTE", bytes(3 * 2**min(bits, 3))), (b"tRNS", b"\0\x80")]
    parts += [(b"gAMA", struct.pack(">I", 45455)), (b"pHYs", struct.pack(">IIB", 3780, 3780, 1)),
              (b"tEXt", b"Title\0a"), (b"zTXt", b"Comment\0\0" + zlib.compress(b"words")),
              (b"iTXt", b"Description\0\1\0\0\0" + zlib.compress(b"words")),
              (b"IDAT", zlib.compress(bytes(200) if interlaced else rows)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def seeds_of(target):
    if target in ("lesson", "front_matter"):
        stages, matters = parts_of_lessons()
        return stages if target == "lesson" else matters
    formulas = [line.split("\t", 1)[-1] for name in ("corpus", "lecture")
                for line in lines_of(f"tests/data/formulas/{name}.tsv")]
    typed = [word for line in lines_of("tests/data/derivations/lines.tsv") for word in line.split("\t")]
    if target in ("tex", "formula"):
        return [formula.encode() for formula in formulas]
    if target == "text":
        prose = [block for path in (ROOT / "lessons").glob("*-*.md") for block in path.read_text().split("\n\n")]
        return [block.encode() for block in prose if len(block) < 500 and not block.startswith(("```", "+++"))]
    if target in ("line", "answer"):
        return [word.encode() for word in typed]
    if target == "expression":
        claims = re.findall(r"(?m)^claim +\S+ \S+ *(.*)$|`([^`\n]+)`", (ROOT / "lessons/FORMAT.md").read_text())
        return [part.encode() for pair in claims for part in pair if part]
    if target == "png":
        kinds = [(0, 1), (0, 8), (0, 16), (2, 8), (2, 16), (3, 1), (3, 4), (3, 8), (4, 8), (6, 8), (6, 16)]
        return [small_png(*kind, interlaced) for kind in kinds for interlaced in (False, True)]
    if target == "command":
        lines = re.findall(r"`(polhode [^`\n]+)`", (ROOT / "docs/recipes.md").read_text())
        lines += re.findall(r"(?m)^polhode .+", (ROOT / "README.md").read_text())
        return [re.sub(r" +", "\n", line.strip()).encode() for line in lines]
    return []


def words_for(target):
    """What a fuzzer puts in whole."""
    sources = {"tex": ["docs/tex.md"], "formula": ["docs/tex.md"], "text": ["docs/tex.md"], "command": ["docs/recipes.md"]}
    words = set()
    for path in sources.get(target, ["lessons/FORMAT.md"]):
        for code in re.findall(r"`([^`\n]+)`", (ROOT / path).read_text()):
            words.update(re.findall(r"\\?[A-Za-z_*-]+|[^A-Za-z\s]{2,6}", code))
    return sorted(word for word in words if 1 < len(word) < 30)


def quoted(word):
    escaped = word.encode().replace(b"\\", b"\\\\").replace(b'"', b'\\"')
    return '"' + "".join(chr(c) if 32 <= c < 127 else f"\\x{c:02x}" for c in escaped) + '"\n'


def prepare(target):
    seeds = BUILD / "seeds" / target
    seeds.mkdir(parents=True, exist_ok=True)
    for i, text in enumerate(seeds_of(target)):
        (seeds / str(i)).write_bytes(text)
    (BUILD / f"{target}.dict").write_text("".join(quoted(word) for word in words_for(target)))
    corpus = BUILD / "corpus" / target
    corpus.mkdir(parents=True, exist_ok=True)
    findings = BUILD / "findings" / target
    findings.mkdir(parents=True, exist_ok=True)
    return [corpus, seeds, ROOT / "tests/data/fuzz" / target], findings


def run(target, seconds, seed):
    folders, findings = prepare(target)
    command = [
        str(BUILD / "tests/fuzz" / f"{target}_fuzzer"), *map(str, folders), f"-max_total_time={seconds}",
        f"-max_len={LONGEST[target]}", f"-dict={BUILD / target}.dict", f"-seed={seed}", "-timeout=60",
        f"-malloc_limit_mb={MOST_MEBIBYTES}", "-rss_limit_mb=1500", "-print_final_stats=1", "-close_fd_mask=1",
        "-reload=0", f"-artifact_prefix={findings}/",
    ]
    environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=32", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(command, stderr=subprocess.PIPE, env=environment, check=False, errors="replace",
                          cwd=BUILD)
    count = re.search(r"stat::number_of_executed_units: (\d+)", done.stderr)
    slowest = re.search(r"stat::slowest_unit_time_sec: +(\d+)", done.stderr)
    peak = re.search(r"stat::peak_rss_mb: +(\d+)", done.stderr)
    covered = re.findall(r"cov: (\d+)", done.stderr)
    numbers = [int(match.group(1)) if match else 0 for match in (count, slowest, peak)]
    print(f"{target:14}{numbers[0]:>12} inputs, {covered[-1] if covered else '?':>6} edges, slowest {numbers[1]} s, "
          f"peak {numbers[2]} MiB{'' if done.returncode == 0 else ', FINDING'}", flush=True)
    if done.returncode != 0:
        print(done.stderr[-6000:], flush=True)
    return numbers[0], done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=int, default=60, help="for each target and round")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("targets", nargs="*", metavar="TARGET")
    asked = parser.parse_args()
    built = [name for name in LONGEST if (BUILD / "tests/fuzz" / f"{name}_fuzzer").exists()]
    targets = asked.targets or built
    if not targets or any(name not in built for name in targets):
        sys.exit(f"fuzz.py: not built in {BUILD}: {', '.join(set(targets) - set(built)) or 'any fuzzer'}")
    total, sound = 0, True
    for turn in range(asked.rounds):
        for target in targets:
            count, whole = run(target, asked.seconds, seed=turn + 1)
            total += count
            sound = sound and whole
    print(f"{total} inputs in all")
    sys.exit(0 if sound else 1)


if __name__ == "__main__":
    main()
