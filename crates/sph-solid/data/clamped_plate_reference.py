"""Residual stress of a clamped plate with a hot spot: the reference of clamped_plate.rs. Needs numpy and scipy.

Run: python3 clamped_plate_reference.py 64 200 > clamped_plate.csv

A disc of radius R and thickness R/2, clamped at its rim, faces free; axisymmetric, small strain, isotropic, J2 without
hardening, sigma_y = 90 MPa (1 - (T - 293)/560) from 293 to 853 K, E 70 GPa, nu 0.33, strain exp(alpha dT) - 1 with alpha 23.1e-6.
T - 293 K = 700 K f exp(-(r^2 + d^2)/(0.4 R)^2), d the depth below the upper face, f from 0 to 1 and back in equal steps.
Four-node elements, CELLS over the radius, with the mean dilatation of the element (B-bar), radial return, Newton with its
tangent (of which melt keeps 1e-3 of the elastic one, so that it can be solved) and half
steps back where it went too far. Prints r/R, depth/R and radial, hoop, axial and shear stress in MPa when cold, at the elements'
middles nearest to a grid of 0.025 R.
"""
import sys

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

YOUNG, POISSON, ALPHA, YIELD, RANGE = 70e9, 0.33, 23.1e-6, 90e6, 560.0
MU = YOUNG / 2 / (1 + POISSON)
BULK = YOUNG / 3 / (1 - 2 * POISSON)
ONE = np.array([1.0, 1.0, 1.0, 0.0])
# Radial, hoop, axial strain and engineering shear.
DEVIATOR = np.diag([1.0, 1.0, 1.0, 0.5]) - np.outer(ONE, ONE) / 3
ELASTIC = BULK * np.outer(ONE, ONE) + 2 * MU * DEVIATOR
GAUSS = [(a, b) for a in (-(3**-0.5), 3**-0.5) for b in (-(3**-0.5), 3**-0.5)]


def mesh(cells):
    high = cells // 2
    size = 1.0 / cells
    node = lambda i, j: i * (high + 1) + j
    r = np.repeat(np.arange(cells + 1) * size, high + 1)
    z = np.tile(np.arange(high + 1) * size, cells + 1)
    quads = [[node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)] for i in range(cells) for j in range(high)]
    return r, z, np.array(quads), size


def strain_matrices(r, quads, size):
    """B-bar (elements, points, 4, 8), weights, and radius and height of the points."""
    matrices, weights, places = [], [], []
    for a, b in GAUSS:
        shape = 0.25 * np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)])
        by_r = 0.5 / size * np.array([-(1 - b), 1 - b, 1 + b, -(1 + b)])
        by_z = 0.5 / size * np.array([-(1 - a), -(1 + a), 1 + a, 1 - a])
        radius = r[quads] @ shape
        rows = np.zeros((len(quads), 4, 8))
        rows[:, 0, 0::2], rows[:, 2, 1::2] = by_r, by_z
        rows[:, 1, 0::2] = shape / radius[:, None]
        rows[:, 3, 0::2], rows[:, 3, 1::2] = by_z, by_r
        matrices.append(rows)
        weights.append(radius * size * size / 4)
        places.append(shape)
    matrices, weights = np.stack(matrices, 1), np.stack(weights, 1)
    dilatation = matrices[:, :, :3].sum(2)
    mean = (dilatation * weights[..., None]).sum(1) / weights.sum(1)[:, None]
    matrices[:, :, :3] += ((mean[:, None] - dilatation) / 3)[:, :, None]
    return matrices, weights, places


def solve(cells, steps):
    r, z, quads, size = mesh(cells)
    matrices, weights, places = strain_matrices(r, quads, size)
    radius = np.stack([r[quads] @ shape for shape in places], 1)
    depth = 0.5 - np.stack([z[quads] @ shape for shape in places], 1)
    full = 700.0 * np.exp(-(radius**2 + depth**2) / 0.16)
    numbers = np.stack([2 * quads, 2 * quads + 1], 2).reshape(len(quads), 8)
    rows = np.repeat(numbers, 8, 1).ravel()
    columns = np.tile(numbers, (1, 8)).ravel()
    count = 2 * len(r)
    held = np.zeros(count, bool)
    held[0::2] |= (r < 1e-9) | (r > 1 - 1e-9)
    held[1::2] |= r > 1 - 1e-9
    free = np.flatnonzero(~held)
    moved, plastic = np.zeros(count), np.zeros(radius.shape + (4,))
    for level in list(range(1, steps + 1)) + list(range(steps - 1, -1, -1)):
        rise = full * level / steps
        strength = YIELD * np.maximum(0.0, 1 - rise / RANGE)
        before, change = np.inf, np.zeros(len(free))
        for _ in range(1000):
            strain = np.einsum("egkj,ej->egk", matrices, moved[numbers])
            elastic = strain - plastic - (np.exp(ALPHA * rise) - 1)[..., None] * ONE
            stress = elastic @ ELASTIC
            mean = stress[..., :3].mean(-1)
            deviator = stress - mean[..., None] * ONE
            mises = np.sqrt(1.5 * ((deviator[..., :3] ** 2).sum(-1) + 2 * deviator[..., 3] ** 2))
            scale = np.where(mises > strength, strength / np.maximum(mises, 1e-300), 1.0)
            flow = deviator * (1 - scale)[..., None] / (2 * MU) * np.array([1, 1, 1, 2.0])
            stress = mean[..., None] * ONE + deviator * scale[..., None]
            force = np.einsum("eg,egkj,egk->ej", weights, matrices, stress)
            residual = np.bincount(numbers.ravel(), force.ravel(), count)[free]
            if np.abs(residual).max() < 1e-5 * YIELD * size * 0.5:
                break
            if np.linalg.norm(residual) > before:
                # Too far: half of the way back.
                change *= 0.5
                moved[free] += change
                continue
            before = np.linalg.norm(residual)
            # Bulk, what is left of shear, and none along the flow.
            share = np.maximum(scale, 1e-3)
            along = deviator / np.maximum(mises, 1e-300)[..., None] * 1.5**0.5
            lost = np.where(scale < 1, 2 * MU * share, 0.0)
            tangent = BULK * np.outer(ONE, ONE) + 2 * MU * share[..., None, None] * DEVIATOR
            tangent = tangent - 0.999 * lost[..., None, None] * along[..., :, None] * along[..., None, :]
            stiffness = np.einsum("eg,egki,egkl,eglj->eij", weights, matrices, tangent, matrices, optimize=True)
            total = sparse.csc_matrix((stiffness.ravel(), (rows, columns)), (count, count))
            change = splu(total[free][:, free]).solve(residual)
            moved[free] -= change
        else:
            raise SystemExit(f"no equilibrium at level {level}")
        plastic = plastic + flow
    return radius.mean(1), depth.mean(1), stress.mean(1)


if __name__ == "__main__":
    cells, steps = int(sys.argv[1]), int(sys.argv[2])
    radius, depth, stress = solve(cells, steps)
    print("r_over_radius,depth_over_radius,radial_mpa,hoop_mpa,axial_mpa,shear_mpa")
    for i in range(36):
        for j in range(20):
            at_r, at_d = 0.0125 + 0.025 * i, 0.0125 + 0.025 * j
            near = np.argsort((radius - at_r) ** 2 + (depth - at_d) ** 2)
            near = [e for e in near[:4] if (radius[e] - at_r) ** 2 + (depth[e] - at_d) ** 2 < (0.71 / cells) ** 2]
            value = stress[near].mean(0) / 1e6
            print(f"{at_r:.4f},{at_d:.4f}," + ",".join(f"{component:.3f}" for component in value))
