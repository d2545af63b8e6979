"""The three NIST tracks on IN625 (AM-Bench 2018-02) by finite volumes: nist.py FV [cells to a 1/e beam radius]

One absorptivity, fitted to width times depth of the first track, as `welder verify weld/nist-amb2018` does with particles:
what is then missing on the other two is missing in conduction from a plane surface, whatever computes it.
"""

import math
import subprocess
import sys

from cases import MATERIALS

RADIUS = 85e-6  # 1/e²
ROOM, WAY, ASIDE, BELOW = (radii * RADIUS for radii in (4, 12, 7, 6))  # as in apps/welder/src/verify/coupled/nist_tracks.rs
TRACKS = [(137.9, 0.4, 148e-6, 42e-6), (179.2, 0.8, 123e-6, 36e-6), (179.2, 1.2, 106e-6, 30e-6)]
FITTED = 1e-3


def track(fv, power, speed, absorptivity, divisions):
    """Width and depth of everything that was ever above the liquidus [m]."""
    rs = RADIUS / math.sqrt(2)
    on, absorbed = WAY / speed, absorptivity * power
    args = dict(MATERIALS["in625"], kind="seam", rs=rs, d=rs / divisions, start=293.0, growth=1 + 0.1 * 8 / divisions, courant=0.03,
                power=f"0:{absorbed!r},{on!r}:{absorbed!r}", speed=speed, end=2 * on, x1=2 * ROOM + WAY, y1=ASIDE, thickness=BELOW,
                xf0=ROOM - 2 * rs, xf1=ROOM + WAY + 2 * rs, yf=0.13e-3, zf=0.1e-3, **{"from": ROOM})
    line = subprocess.run([fv, *(f"{key}={value}" for key, value in args.items())], capture_output=True, text=True, check=True).stdout
    values = dict(pair.split("=") for pair in line.split())
    return float(values["width"]), float(values["depth"])


def fit(fv, divisions):
    """The absorptivity of the first track: secants in the logarithm of width times depth."""
    power, speed, wide, deep = TRACKS[0]

    def miss(absorptivity):
        width, depth = track(fv, power, speed, absorptivity, divisions)
        return math.log(width * depth / (wide * deep))

    before, now = 0.28, 0.34
    was, off = miss(before), miss(now)
    while abs(off) > FITTED:
        before, was, now = now, off, now - off * (now - before) / (off - was)
        off = miss(now)
    return now


def main():
    fv, divisions = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 8
    absorptivity = fit(fv, divisions)
    print(f"absorptivity {absorptivity:.4f}, {divisions} cells to a 1/e beam radius")
    for power, speed, wide, deep in TRACKS:
        width, depth = track(fv, power, speed, absorptivity, divisions)
        print(f"{power} W, {speed} m/s: width {1e6 * width:.1f} um ({100 * (width / wide - 1):+.1f} %), "
              f"depth {1e6 * depth:.1f} um ({100 * (depth / deep - 1):+.1f} %)", flush=True)


if __name__ == "__main__":
    main()
