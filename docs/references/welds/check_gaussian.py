"""fv against the exact centre temperature of a Gaussian source on a half space: check_gaussian.py FV"""

import math
import subprocess
import sys

POWER, K, RHO_C, RADIUS, TIME = 1000, 210, 2.43e6, 0.5e-3, 15e-3
EXACT = POWER / (math.pi**1.5 * K * RADIUS) * math.atan(math.sqrt(4 * K / RHO_C * TIME) / RADIUS)

for cell in (50e-6, 25e-6):
    args = (
        f"d={cell} rs={RADIUS} power=0:{POWER},{TIME}:{POWER} rho=2430 cs=0:1000 cl=0:1000 ks=0:{K} kl=0:{K} hf=1e-3 "
        f"ts=9000 tl=9001 tmax=12000 rf=1e-3 zf=1e-3 radius=20e-3 thickness=20e-3 most=0.5e-3 end={TIME}"
    )
    line = subprocess.run([sys.argv[1], *args.split()], capture_output=True, text=True, check=True).stdout
    rise = float(line.split("peak=")[1].split()[0]) - 293
    print(f"cell {cell}: {rise:.2f} K, exact {EXACT:.2f} K, {100 * (rise / EXACT - 1):+.3f} %")
