"""Writes the scene of every reference weld at about 8.5 spacings to a beam radius: scenes.py FOLDER"""

import sys

from cases import CASES, scene

# Cells through the thickness; the spacing that this gives divides the other sides too.
THROUGH = {
    "al-400": 60, "al-500": 60, "al-600": 60, "al-1k": 60, "steel": 51, "in625": 48, "thin-steel": 10,
    "thin-steel-through": 7, "top-hat": 51, "losses": 26, "conducting-melt": 60, "short-pulse": 60, "two-ramps": 60,
    "hot-start": 60, "small-beam": 128, "tiny-beam": 160, "seam-al-6": 60, "seam-al-1": 60, "seam-steel-2": 34,
    "seam-in625-amb": 51,
}

for name, case in CASES.items():
    thickness = case["thickness"] if case["kind"] == "spot" else case["size"][2]
    with open(f"{sys.argv[1]}/{name}.ron", "w") as file:
        file.write(scene(name, thickness / THROUGH[name]))
