"""Reads what lammps_heat.sh collected and prints medians and the ratio per directed pair."""

import re
import statistics
import sys


def lammps(text):
    """Million directed pairs a second of each run, and neighbours a particle."""
    loops = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", text)[1::2]
    half = [int(count) for count in re.findall(r"Total # of neighbors = (\d+)", text)][1::2]
    speeds = [2e-6 * pairs * int(steps) / float(seconds) for (seconds, steps, _), pairs in zip(loops, half)]
    return speeds, 2 * half[0] / int(loops[0][2])


def ours(text):
    """The same of our runs; neighbours are those of a particle before mirror images are folded onto their sources."""
    runs = [dict(zip(line.split()[::2], line.split()[1::2])) for line in text.splitlines()]
    return [float(run["million_pairs_per_second"]) for run in runs], float(runs[0]["searched_neighbours"])


def main():
    with open(sys.argv[1]) as file:
        theirs, their_neighbours = lammps(file.read())
    with open(sys.argv[2]) as file:
        own, own_neighbours = ours(file.read())
    if abs(their_neighbours - own_neighbours) > 1e-9:
        sys.exit(f"neighbours differ: {their_neighbours} against {own_neighbours}")
    for name, speeds in [("LAMMPS", theirs), ("ours", own)]:
        runs = " ".join(f"{speed:.0f}" for speed in speeds)
        print(f"{name}: median {statistics.median(speeds):.0f} million directed pairs/s ({runs})")
    print(f"neighbours a particle: {own_neighbours:g}")
    print(f"ratio per directed pair: {statistics.median(own) / statistics.median(theirs):.2f}")


if __name__ == "__main__":
    main()
