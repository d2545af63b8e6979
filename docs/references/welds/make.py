"""Runs the finite volumes on two meshes per case and writes the extrapolated values: make.py FV OUT.csv [case ...]"""

import os
import subprocess
import sys
import time

from cases import CASES, fv_args

HEADER = """\
# Reference welds by finite volumes (docs/references/welds): axisymmetric spots, three-dimensional half seams; conduction only
# Two meshes a case (16 and 32 cells to a 1/e beam radius for spots, 8 and 12 for seams; tiny-beam 8 and 16, seam-steel-2 12 and 18), extrapolated at second order
# uncertainty_percent: largest distance of the extrapolated value from the finer mesh, over all columns
# g++ -O3 -march=native -ffast-math -std=c++17 -o fv fv.cpp && python3 make.py ./fv reference_welds.csv
# Lengths are maxima over time: full width, depth, length of the region above the liquidus and (_s) the solidus
name,width_m,depth_m,width_s_m,depth_s_m,length_m,length_s_m,peak_k,frozen_s,start_k,uncertainty_percent
"""
COLUMNS = ["width", "depth", "width_s", "depth_s", "length", "length_s", "peak", "frozen"]


def run(fv, name, divisions):
    began = time.time()
    line = subprocess.run([fv, *fv_args(name, divisions)], capture_output=True, text=True, check=True).stdout
    values = {key: float(value) for key, value in (pair.split("=") for pair in line.split())}
    print(f"{name} {divisions}: {time.time() - began:.1f} s {line.strip()}", file=sys.stderr, flush=True)
    return values


def main():
    fv, out, *names = sys.argv[1:]
    if not os.path.exists(out):
        with open(out, "w") as file:
            file.write(HEADER)
    for name in names or CASES:
        meshes = CASES[name].get("meshes", (16, 32) if CASES[name]["kind"] == "spot" else (8, 12))
        coarse, fine = (run(fv, name, divisions) for divisions in meshes)
        share = meshes[0] ** 2 / (meshes[1] ** 2 - meshes[0] ** 2)  # second order in the cells
        best = {key: fine[key] + share * (fine[key] - coarse[key]) for key in COLUMNS}
        start = CASES[name]["start"]
        scale = lambda key: best[key] - start if key == "peak" else best[key]
        far = {key: abs(best[key] - fine[key]) / scale(key) if scale(key) else 0.0 for key in COLUMNS}
        row = [name] + [f"{best[key]:.6g}" for key in COLUMNS] + [f"{start:.6g}", f"{100 * max(far.values()):.3f}"]
        with open(out, "a") as file:
            file.write(",".join(row) + "\n")


if __name__ == "__main__":
    main()
