#!/usr/bin/env python3
"""Answers the five figures of Hu and Eberhard (2015) with cases/flow-spot-aluminium and cases/flow-seam-aluminium: writes
docs/src/paper-figures.md and its pictures.

    cargo build -p welder && python3 docs/paper_figures.py [--out DIR]

Needs meshio, to read the frames. Pictures are the program's, numbers come from its frames, history and summary. A case whose results
are in DIR already is not run again.
"""

import argparse
import csv
import json
import subprocess
from pathlib import Path

import meshio
import numpy as np

from gallery import small_png

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/src/paper-figures.md"
PICTURES = ROOT / "docs/src/paper-figures"


class Weld:
    """A case that was run, and its frame nearest to the moment at which the light goes out."""

    def __init__(self, program, case, out, lit_s):
        self.case, self.out = case, out / case
        if not (self.out / "summary.json").is_file():
            command = [program, "run", ROOT / "cases" / case, "--quiet", "--threads", "1", "--out", self.out]
            subprocess.run(command, check=True)
        self.summary = json.loads((self.out / "summary.json").read_text())
        self.history = list(csv.DictReader((self.out / "history.csv").open()))
        listed = (self.out / "frames.pvd").read_text().split("<DataSet ")[1:]
        frames = [(float(line.split('timestep="')[1].split('"')[0]), line.split('file="')[1].split('"')[0]) for line in listed]
        self.time_s, name = max(frame for frame in frames if frame[0] <= lit_s + 1e-9)
        self.frame, self.last = meshio.read(self.out / name), meshio.read(self.out / frames[-1][1])

    def forces_un(self):
        """Places and Marangoni forces of the particles that feel one."""
        force = 1e6 * self.frame.point_data["marangoni_force_n"]
        felt = np.linalg.norm(force, axis=1) > 0
        return self.frame.points[felt], force[felt]

    def picture(self, stem):
        PICTURES.mkdir(exist_ok=True)
        name = f"{self.case}-{stem}.png"
        (PICTURES / name).write_bytes(small_png((self.out / f"{stem}.png").read_bytes()))
        return f"![{stem} of {self.case}](paper-figures/{name})"


def radial(places, forces):
    """Distance from the middle [um], and the outward part of the forces [uN]."""
    distance = np.hypot(places[:, 0], places[:, 1])
    outward = (forces[:, :2] * places[:, :2]).sum(axis=1) / np.maximum(distance, 1e-12)
    return 1e6 * distance, outward


def spot_lines(spot):
    pool = spot.summary["pool"]
    radius, depth = (1e6 * pool["max_width_m"] / 2, 1e6 * pool["max_depth_m"])
    distance, outward = radial(*spot.forces_un())
    rings = np.arange(0.0, radius + 50.0, 50.0)
    ring = np.digitize(distance, rings)
    means = [(rings[k - 1] + 25.0, outward[ring == k].sum()) for k in range(1, len(rings)) if (ring == k).any()]
    farthest = max(means, key=lambda mean: mean[1])
    vertical = spot.forces_un()[1][:, 2]
    numbers = spot.summary["numbers"]
    molten = spot.last.point_data["was_molten"].ravel() > 0
    return [
        "## Figure 1: temperature of the spot when the light goes out",
        spot.picture("section_x"),
        spot.picture("top"),
        f"At t = {1e3 * spot.time_s:.2f} ms the pool is {2 * radius:.0f} um wide and {depth:.0f} um deep: the depth is "
        f"{depth / radius:.2f} of the radius, below one as the paper finds it. Peak {spot.summary['peak_temperature_k']:.0f} K.",
        "## Figure 2: Marangoni force on the spot",
        *[spot.picture(f"marangoni_{axis}") for axis in "xyz"],
        f"The outward part is positive on {100 * (outward > 0).mean():.0f} % of the particles that feel a force. Added up over rings of 50 um, "
        f"it is largest {farthest[0]:.0f} um from the middle ({farthest[1]:.1f} uN), {farthest[0] / radius:.2f} of the pool's radius. The paper "
        f"says: largest near the border of the pool. Along z the sum is {vertical.sum():.1f} uN, between {vertical.min():.2f} and "
        f"{vertical.max():.2f} uN a particle: where the surface is bent, the force along it has a part upwards; the paper says negative, with no "
        f"distinct minimum.",
        "## Figure 3: the weld after freezing",
        spot.picture("speed_x"),
        f"{int(molten.sum())} particles of {len(molten)} were all liquid once. The weld is {1e6 * spot.summary['weld']['width_m']:.0f} um wide and "
        f"{1e6 * spot.summary['weld']['depth_m']:.0f} um deep; its top stands up to {1e6 * numbers['crown_m']:.0f} um above the part's face and down to "
        f"{1e6 * numbers['dip_m']:.0f} um below, {1e6 * numbers['surface_roughness_m']:.0f} um root mean square: the roughness that the paper sees, in "
        f"numbers, of which the spacing is {1e6 * spot.summary['spacing_m']:.0f} um. The picture shows the melt's speed when the light goes out.",
    ]


def seam_lines(seam, beam_x):
    late = [row for row in seam.history if 0.5 * seam.time_s <= float(row["time_s"]) <= seam.time_s]
    widths = np.array([1e6 * float(row["pool_width_m"]) for row in late])
    half = len(widths) // 2
    places, forces = seam.forces_un()
    ahead = places[:, 0] > beam_x
    sums = forces[ahead, 0].sum(), forces[~ahead, 0].sum()
    largest = forces[ahead, 0].max(), forces[~ahead, 0].min()
    count = len(seam.frame.points)
    lowest = 1e6 * seam.last.points[:, 2].min()
    return [
        "## Figure 4: pool of the seam",
        seam.picture("top"),
        seam.picture("section_x"),
        f"Over the second half of the track the pool is {widths.mean():.0f} um wide, with a standard deviation of {widths.std():.0f} um; between "
        f"its two quarters the mean changes by {widths[half:].mean() - widths[:half].mean():+.0f} um. All {count} particles are there at the end, "
        f"none more than {max(0.0, -lowest - 1e6 * 1.2e-3):.0f} um below the part: the seam holds together.",
        "## Figure 5: Marangoni force on the seam",
        *[seam.picture(f"marangoni_{axis}") for axis in "xyz"],
        f"Ahead of the beam the forces along x add up to {sums[0]:+.1f} uN, behind it to {sums[1]:+.1f} uN; the largest on a particle is "
        f"{largest[0]:+.2f} uN ahead and {largest[1]:+.2f} uN behind, {abs(largest[0] / largest[1]):.2f} to one. The paper finds the force in the "
        f"direction of the beam's way a little larger.",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=Path, default=ROOT / "target/debug/welder")
    parser.add_argument("--out", type=Path, default=ROOT / "target/paper-figures")
    arguments = parser.parse_args()
    spot = Weld(arguments.program, "flow-spot-aluminium", arguments.out, 4e-3)
    seam = Weld(arguments.program, "flow-seam-aluminium", arguments.out, 36e-3)
    lines = [
        "# The paper's figures",
        "Hu and Eberhard (2015) print no power, radius, spacing or size with their five figures; these are figures of the same kind, of the "
        "cases `flow-spot-aluminium` and `flow-seam-aluminium` with their own, stated numbers, and what each shows. The page was "
        "written by `python3 docs/paper_figures.py`.",
        *spot_lines(spot),
        *seam_lines(seam, 5.0e-3),
        f"Cost: {spot.summary['cpu_s']:.0f} and {seam.summary['cpu_s']:.0f} CPU s on one thread, {int(spot.summary['numbers']['melt_steps'])} and "
        f"{int(seam.summary['numbers']['melt_steps'])} steps of the melt.",
    ]
    PAGE.write_text("\n\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
