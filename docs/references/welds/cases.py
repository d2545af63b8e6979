"""The reference welds: one description per case, for the finite volumes (fv.cpp) and for the program (scene.ron).

Lengths in m, powers in W absorbed. The part of a spot is a quarter of a square plate; the finite volumes take the disc of
equal area. A seam is half a plate. Results do not depend on the outer shape beyond the stated uncertainty.
"""

import math

MATERIALS = {
    "al": dict(rho=2500, ts=847, tl=905, hf=3.97e5, cs="0:1050", cl="0:1180", ks="0:200", kl="0:95"),
    "al1k": dict(rho=2500, ts=904.5, tl=905.5, hf=3.97e5, cs="0:1050", cl="0:1180", ks="0:200", kl="0:95"),
    "conducting-melt": dict(rho=2500, ts=847, tl=905, hf=3.97e5, cs="0:1050", cl="0:1180", ks="0:50", kl="0:200"),
    "steel": dict(rho=7954, ts=1658, tl=1723, hf=2.6e5, cs="300:498.8,1658:679.2", cl="0:770",
                  ks="300:13.96,1658:35.30", kl="1658:17.85,3090:22.54"),
    "in625": dict(rho=7570, ts=1410, tl=1620, hf=2.175e5, cs="0:579", cl="0:751",
                  ks="200:11.219,1620:32.1214", kl="1410:25.6766,4500:71.2325"),
}

W06 = 0.6e-3 / math.sqrt(2)  # 1/e radius of the aluminium spot


def spot(material, power, rs, t_on, size=6e-3, thickness=3e-3, **more):
    case = dict(kind="spot", material=material, rs=rs, size=size, thickness=thickness, beam="gauss", start=293.0,
                pulse=[(0.0, power), (t_on, power)], end=3 * t_on, rf=2.4 * rs, zf=2.0 * rs)
    case.update(more)
    return case


def seam(material, power, rs, speed, length, size, x_from, **more):
    case = dict(kind="seam", material=material, rs=rs, size=size, power=power, speed=speed, length=length, x_from=x_from,
                start=293.0, end=2.0 * length / speed)
    case.update(more)
    return case


CASES = {
    "al-400": spot("al", 400, W06, 15e-3),
    "al-500": spot("al", 500, W06, 15e-3),
    "al-600": spot("al", 600, W06, 15e-3),
    "al-1k": spot("al1k", 500, W06, 15e-3),
    "steel": spot("steel", 55, 0.2e-3, 10e-3, size=2.4e-3, thickness=1.2e-3, end=60e-3),
    "in625": spot("in625", 45, 0.2e-3, 10e-3, size=2.4e-3, thickness=1.2e-3, end=60e-3),
    "thin-steel": spot("steel", 90, 0.4e-3, 60e-3, size=4.8e-3, thickness=0.48e-3, end=0.4, zf=0.48e-3),
    "thin-steel-through": spot("steel", 150, 0.6e-3, 90e-3, size=4.8e-3, thickness=0.48e-3, end=0.9, zf=0.48e-3,
                               rf=1.2e-3),
    "top-hat": spot("al", 500, 0.5e-3, 15e-3, beam="hat"),
    "losses": spot("steel", 110, 0.5e-3, 0.2, size=6e-3, thickness=1.5e-3, conv=1000.0, emis=1.0, end=1.0),
    "conducting-melt": spot("conducting-melt", 300, W06, 15e-3, end=60e-3),
    "short-pulse": spot("al", 900, W06, 2e-3, end=10e-3),
    "two-ramps": spot("al", 600, W06, 15e-3, pulse=[(0.0, 0.0), (5e-3, 600.0), (12e-3, 450.0), (15e-3, 0.0)]),
    "hot-start": spot("al", 120, W06, 6e-3, start=800.0, end=0.1, rf=2.4e-3, zf=1.6e-3),
    "small-beam": spot("al", 300, 0.2e-3, 15e-3, size=6e-3, thickness=3e-3, rf=0.9e-3, zf=0.8e-3),
    "tiny-beam": spot("conducting-melt", 150, 0.1e-3, 15e-3, size=3.84e-3, thickness=1.92e-3, end=60e-3, rf=0.75e-3,
                      zf=0.7e-3, meshes=(8, 16)),
    "seam-al-6": seam("al", 500, W06, 0.1, 5e-3, (12e-3, 4.8e-3, 3e-3), 4e-3, yf=0.9e-3, zf=0.7e-3),
    "seam-al-1": seam("al", 500, W06, 1 / 60, 4e-3, (12e-3, 4.8e-3, 3e-3), 4e-3, yf=1.2e-3, zf=1.0e-3),
    "seam-steel-2": seam("steel", 95, 0.3e-3, 2 / 60, 4e-3, (7.2e-3, 2.4e-3, 1.2e-3), 1.8e-3, yf=0.45e-3, zf=0.3e-3,
                         meshes=(12, 18), dxratio=1.5),
    "seam-in625-amb": seam("in625", 48, 85e-6 / math.sqrt(2), 0.4, 1.2e-3, (1.92e-3, 0.48e-3, 0.36e-3), 0.36e-3,
                           yf=0.13e-3, zf=0.1e-3),
}


def fv_args(name, divisions):
    """Arguments of fv for a mesh of `divisions` cells to a beam radius."""
    case = CASES[name]
    args = dict(MATERIALS[case["material"]], kind=case["kind"], rs=case["rs"], d=case["rs"] / divisions, start=case["start"],
                growth=1 + 0.05 * 16 / divisions, end=case["end"])
    if case["kind"] == "spot":
        args.update(power=",".join(f"{t!r}:{p!r}" for t, p in case["pulse"]), beam=case["beam"], rf=case["rf"], zf=case["zf"],
                    radius=case["size"] * 2 / math.sqrt(math.pi), thickness=case["thickness"], steps=1000)
        if "conv" in case:
            args.update(conv=case["conv"], emis=case["emis"], bottomloss=1)
    else:
        x, y, z = case["size"]
        on = case["length"] / case["speed"]
        args.update(power=f"0:{case['power']},{on!r}:{case['power']}", speed=case["speed"], x1=x, y1=y, thickness=z,
                    xf0=case["x_from"] - 2 * case["rs"], xf1=case["x_from"] + case["length"] + 2 * case["rs"],
                    yf=case["yf"], zf=case["zf"], growth=1 + 0.1 * 8 / divisions, courant=0.03, dxratio=case.get("dxratio", 1))
        args["from"] = case["x_from"]
    return [f"{key}={value}" for key, value in args.items()]


def scene(name, spacing, levels="Auto", heat=""):
    """The text of the scene of a case at a spacing; half of the light is absorbed."""
    case, material = CASES[name], MATERIALS[CASES[name]["material"]]

    def prop(table):
        points = [tuple(map(float, pair.split(":"))) for pair in table.split(",")]
        if len(points) == 1:
            return f'(value: {points[0][1]}, source: "reference welds")'
        return "(table: [" + ", ".join(f"({t}, {v})" for t, v in points) + '], source: "reference welds")'

    constant = lambda value: f'(value: {float(value)}, source: "reference welds")'
    if case["kind"] == "spot":
        size = (case["size"], case["size"], case["thickness"])
        faces = ["x_min: Symmetry", "y_min: Symmetry"]
        points = case["pulse"]
        if len(points) == 2:
            pulse = f"Constant(start_s: 0.0, duration_s: {points[1][0]!r}, power_w: {2.0 * points[0][1]!r})"
        else:
            inner = ", ".join(f"(time_s: {t!r}, power_w: {2.0 * p!r})" for t, p in points)
            pulse = f"Table(start_s: 0.0, points: [{inner}])"
        path = f"Spot(position_m: (0.0, 0.0), pulse: {pulse})"
    else:
        size, faces = case["size"], ["y_min: Symmetry"]
        path = (f"Straight(from_m: ({case['x_from']!r}, 0.0), to_m: ({case['x_from'] + case['length']!r}, 0.0), "
                f"speed_m_s: {case['speed']!r}, power_w: {2.0 * case['power']!r}, start_s: 0.0)")
    if "conv" in case:
        loss = f"Losses(convection_w_m2_k: {case['conv']}, emissivity: {case['emis']}, ambient_k: 293.0)"
        faces += [f"top: {loss}", f"bottom: {loss}"]
    beam = f"Gaussian(radius_1e_m: {case['rs']!r})" if case.get("beam") != "hat" else f"TopHat(radius_m: {case['rs']!r})"
    return f"""(
    title: "Reference weld {name}",
    part: (size_m: {size!r}, material: "own", start_k: {case['start']}, faces: ({', '.join(faces)})),
    laser: (beam: {beam}, absorption: Surface(absorptivity: 0.5), path: {path}),
    resolution: (spacing_m: {spacing!r}, levels: {levels}),
    physics: [Heat({heat})],
    time: (end_s: {case['end']!r}, stop_when_solid: true),
    materials: {{"own": (
        density_kg_m3: {constant(material['rho'])}, solidus_k: {constant(material['ts'])},
        liquidus_k: {constant(material['tl'])}, latent_heat_j_kg: {constant(material['hf'])},
        heat_capacity_solid_j_kg_k: {prop(material['cs'])}, heat_capacity_liquid_j_kg_k: {prop(material['cl'])},
        conductivity_solid_w_m_k: {prop(material['ks'])}, conductivity_liquid_w_m_k: {prop(material['kl'])},
    )}},
)
"""
