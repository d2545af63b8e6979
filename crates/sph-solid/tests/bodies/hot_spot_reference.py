"""Residual stress of a disc with a hot spot: the reference of hot_spot.rs. Run: python3 hot_spot_reference.py 160 200

Axisymmetric, plane strain, small strain, isotropic, J2 without hardening, sigma_y = 90 MPa (1 - (T - 293)/560) from 293 to
853 K, E 70 GPa, nu 0.33, strain exp(alpha dT) - 1 with alpha 23.1e-6. T - 293 K = 700 K f exp(-(r/0.4 R)^2), f from 0 to 1
and back in equal steps. Linear finite elements over the radius, one point each, modified Newton with the elastic stiffness,
radial return. Prints radius/R and the radial, hoop and axial stress in MPa when cold. Needs no package.
"""
import math
import sys

YOUNG, POISSON, ALPHA, YIELD, RANGE = 70e9, 0.33, 23.1e-6, 90e6, 560.0
MU = YOUNG / 2 / (1 + POISSON)
LAMBDA = YOUNG / 3 / (1 - 2 * POISSON) - 2 * MU / 3


def stress_of(strain):
    """Hooke's law."""
    trace = sum(strain)
    return [LAMBDA * trace + 2 * MU * component for component in strain]


def point(strain, thermal, plastic, rise):
    """Stress and plastic strain after the return to the yield stress."""
    stress = stress_of([strain[k] - thermal - plastic[k] for k in range(3)])
    mean = sum(stress) / 3
    deviator = [component - mean for component in stress]
    mises = math.sqrt(1.5 * sum(component**2 for component in deviator))
    strength = YIELD * max(0.0, 1 - rise / RANGE)
    if mises <= strength:
        return stress, plastic
    scale = strength / mises
    flowed = [plastic[k] + deviator[k] * (1 - scale) / (2 * MU) for k in range(3)]
    return [mean + component * scale for component in deviator], flowed


def factor(middles, size):
    """Diagonal after elimination and off-diagonal of the elastic stiffness."""
    count = len(middles)
    diagonal, beside = [0.0] * (count + 1), [0.0] * count
    for e, middle in enumerate(middles):
        rows = [(-1 / size, 0.5 / middle, 0.0), (1 / size, 0.5 / middle, 0.0)]
        entry = lambda a, b: sum(x * y for x, y in zip(rows[a], stress_of(rows[b]))) * middle * size
        diagonal[e] += entry(0, 0)
        diagonal[e + 1] += entry(1, 1)
        beside[e] = entry(0, 1)
    for i in range(2, count + 1):
        diagonal[i] -= beside[i - 1] ** 2 / diagonal[i - 1]
    return diagonal, beside


def solve(count, steps):
    """Middles of the elements and their stresses at the end."""
    size = 1.0 / count
    middles = [(e + 0.5) * size for e in range(count)]
    diagonal, beside = factor(middles, size)
    moved, plastic = [0.0] * (count + 1), [[0.0] * 3 for _ in middles]
    for level in list(range(1, steps + 1)) + list(range(steps - 1, -1, -1)):
        rises = [700.0 * level / steps * math.exp(-((middle / 0.4) ** 2)) for middle in middles]
        while True:
            residual, points = [0.0] * (count + 1), []
            for e, middle in enumerate(middles):
                strain = [(moved[e + 1] - moved[e]) / size, (moved[e] + moved[e + 1]) / 2 / middle, 0.0]
                points.append(point(strain, math.exp(ALPHA * rises[e]) - 1, plastic[e], rises[e]))
                radial, hoop, _ = points[e][0]
                residual[e] += (-radial / size + hoop / 2 / middle) * middle * size
                residual[e + 1] += (radial / size + hoop / 2 / middle) * middle * size
            if max(abs(force) for force in residual[1:]) < 1e-6 * YIELD * size:
                break
            forward = [0.0] * (count + 1)
            for i in range(1, count + 1):
                forward[i] = -residual[i] - (beside[i - 1] / diagonal[i - 1] * forward[i - 1] if i > 1 else 0)
            change = [0.0] * (count + 2)
            for i in range(count, 0, -1):
                change[i] = (forward[i] - (beside[i] * change[i + 1] if i < count else 0)) / diagonal[i]
                moved[i] += change[i]
        plastic = [flowed for _, flowed in points]
    return middles, [stress for stress, _ in points]


if __name__ == "__main__":
    middles, stresses = solve(int(sys.argv[1]), int(sys.argv[2]))
    for tenth in range(1, 10):
        right = next(e for e, middle in enumerate(middles) if middle > tenth / 10)
        pair = zip(stresses[right - 1], stresses[right])
        print(tenth / 10, *(f"{(a + b) / 2e6:.2f}" for a, b in pair))
