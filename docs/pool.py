#!/usr/bin/env python3
"""Runs a quarter of cases/flow-spot-aluminium several times, each from a start temperature a tenth of a kelvin apart, and prints what
the runs give as tables in markdown: mean and standard deviation over the runs of each setting.

    python3 docs/pool.py                              # all settings, some 15 minutes of processor time
    python3 docs/pool.py --only "50 um" --runs 3      # one of them

Runs whose summary is there already are not repeated.
"""

import argparse
import csv
import json
import os
import statistics
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASE = ROOT / "cases" / "flow-spot-aluminium"
QUARTER = [
    "part.low_corner_m=(0.0,0.0)",
    "part.size_m=(1e-3,1e-3,0.8e-3)",
    "part.faces=(x_min: Symmetry, y_min: Symmetry)",
    "output.frames=false",
    "output.pictures=false",
]
START_K = 293.0
# Last quarter of the time that the laser shines [s].
LATE = (3e-3, 4e-3)


def flow(settings):
    return f"physics=[Heat(), Flow({settings})]"


SPACINGS = {"50": 50e-6, "33.3": 1e-3 / 30, "25": 25e-6}
SETTINGS = {f"{name} um": [f"resolution.spacing_m={spacing}"] for name, spacing in SPACINGS.items()}
# Friction of the scheme taken out of the melt's own: 20 of aluminium's viscosity in all.
SETTINGS |= {
    f"{name} um, friction 20 in all": [
        f"resolution.spacing_m={spacing}",
        flow(f"viscosity_factor: {20 - 7.28 * spacing / 50e-6:.2f}, sound_speed_m_s: 10.1"),
    ]
    for name, spacing in SPACINGS.items()
}
SETTINGS["50 um, one spacing"] = ["resolution.levels=Uniform"]
SETTINGS["50 um, one spacing, schedule Together"] = [
    "resolution.levels=Uniform",
    flow("viscosity_factor: 20.0, schedule: Together"),
]
# Title, factor and digits of each quantity.
QUANTITIES = [
    ("width um", 1e6, 1),
    ("depth um", 1e6, 1),
    ("weld 1e-11 m^3", 1e11, 3),
    ("late width um", 1e6, 1),
    ("late depth um", 1e6, 1),
    ("late melt 1e-11 m^3", 1e11, 3),
    ("peak K", 1.0, 0),
    ("crown um", 1e6, 1),
    ("dip um", 1e6, 1),
    ("cpu s", 1.0, 1),
]


def run(program, settings, folder, start):
    """The summary and the history of a run, from its folder if it has been there."""
    if not (folder / "summary.json").exists():
        sets = QUARTER + settings + [f"part.start_k={start:.1f}"]
        command = [program, "run", str(CASE), "--quiet", "--out", str(folder)]
        command += [part for value in sets for part in ("--set", value)]
        subprocess.run(command, check=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
    with open(folder / "history.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if LATE[0] < float(row["time_s"]) <= LATE[1]]
    return json.loads((folder / "summary.json").read_text()), rows


def measured(summary, rows):
    late = [statistics.fmean(float(row[column]) for row in rows) for column in
            ("pool_width_m", "pool_depth_m", "melt_volume_m3")]
    pool, numbers = summary["pool"], summary["numbers"]
    return [pool["max_width_m"], pool["max_depth_m"], summary["weld"]["volume_m3"], *late,
            summary["peak_temperature_k"], numbers["crown_m"], numbers["dip_m"], summary["cpu_s"]]


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--program", default=str(ROOT / "target/debug/welder"))
    options.add_argument("--out", type=Path, default=ROOT / "out/pool")
    options.add_argument("--runs", type=int, default=5)
    options.add_argument("--only", action="append", choices=SETTINGS)
    options = options.parse_args()
    print("| setting | runs | " + " | ".join(title for title, _, _ in QUANTITIES) + " |")
    print("|---" * (len(QUANTITIES) + 2) + "|")
    for name in options.only or SETTINGS:
        slug = name.replace(" ", "-").replace(",", "")
        runs = [
            measured(*run(options.program, SETTINGS[name], options.out / f"{slug}-{k}", START_K + 0.1 * k))
            for k in range(options.runs)
        ]
        cells = []
        for values, (_, factor, digits) in zip(zip(*runs), QUANTITIES):
            spread = statistics.stdev(values) if len(values) > 1 else 0.0
            cells.append(f"{factor * statistics.fmean(values):.{digits}f} ± {factor * spread:.{digits}f}")
        print(f"| {name} | {len(runs)} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
