"""fv against the moving Gaussian of Eagar and Tsai, unit case (Q = k = a = v = s = 1, here Q = 1e4): check_moving.py FV

The run lasts 20 units of time, so the exact integral ends there too; compared is the peak behind the beam's centre.
"""

import math
import subprocess
import sys

POWER, TIME = 1e4, 20.0


def rise(x, end=TIME):
    """At distance x from the beam on its path; the integral over sqrt(t) by midpoints."""
    count, last = 20000, math.sqrt(end)
    total = 0.0
    for i in range(count):
        t = ((i + 0.5) / count * last) ** 2
        total += math.exp(-((x + t) ** 2) / (2 * (1 + 2 * t))) / (1 + 2 * t)
    return POWER * total * last / count / math.pi**1.5


print(f"unit case at the beam's centre: {rise(0, 1e4) / POWER:.6f}; Eagar and Tsai 0.145620")
exact = max(rise(-0.05 * i) for i in range(12))
for cell in (0.25, 0.125):
    args = (
        f"kind=seam d={cell} rs={math.sqrt(2)} speed=1 from=0 power=0:{POWER},{TIME}:{POWER} rho=1 cs=0:1 cl=0:1 ks=0:1 "
        f"kl=0:1 hf=1e-3 ts=9000 tl=9001 tmax=12000 x0=-15 xf0=10 xf1=23 x1=40 yf=3 y1=18 thickness=18 zf=2.5 "
        f"growth=1.08 end={TIME}"
    )
    line = subprocess.run([sys.argv[1], *args.split()], capture_output=True, text=True, check=True).stdout
    found = float(line.split("peak=")[1].split()[0]) - 293
    print(f"cell {cell}: {found:.2f} K, exact {exact:.2f} K, {100 * (found / exact - 1):+.3f} %")
