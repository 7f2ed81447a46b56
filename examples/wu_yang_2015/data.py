# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input of our own for the figures of [WuYang2015], whose numbers were not published: surfaces and normal fields of the
kinds the paper describes, over a square of 100 mm."""

import math

import FreeCAD as App
import Part

SIDE = 100.0  # mm


def patch(poles) -> Part.BSplineSurface:
    """A Bezier patch over the unit square."""
    n, m = len(poles) - 1, len(poles[0]) - 1
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, [n + 1] * 2, [m + 1] * 2, [0.0, 1.0], [0.0, 1.0], False, False, n, m)
    return surface


def level(height, n: int, m: int) -> list:
    """Control points over the square, evenly spread, height(s, t) above it."""
    return [[App.Vector(SIDE * i / n, SIDE * j / m, height(i / n, j / m)) for j in range(m + 1)] for i in range(n + 1)]


def raised(poles, by, rows: int) -> list:
    """Control points with all but the outer rows lifted by by(s, t)."""
    n, m = len(poles) - 1, len(poles[0]) - 1

    def lift(i, j):
        return by(i / n, j / m) if min(i, j, n - i, m - j) >= rows else 0.0
    return [[poles[i][j] + App.Vector(0, 0, lift(i, j)) for j in range(m + 1)] for i in range(n + 1)]


def bump(s, t, at, width) -> float:
    return math.exp(-((s - at[0]) ** 2 + (t - at[1]) ** 2) / width ** 2)


# Normal fields.

def polynomial_field(poles) -> dict:
    """The normals (-z_x, -z_y, 1) of a patch over the square: a Bezier patch of the same degrees, exact."""
    n, m = len(poles) - 1, len(poles[0]) - 1
    z = [[pole.z / SIDE for pole in row] for row in poles]
    along = [_slopes([z[i][j] for i in range(n + 1)]) for j in range(m + 1)]
    across = [_slopes(z[i]) for i in range(n + 1)]
    return {"degree": [n, m],
            "normals": [[-along[j][i], -across[i][j], 1.0] for i in range(n + 1) for j in range(m + 1)]}


def sampled_field(n: int, m: int, normal, weight=lambda s, t: 1.0) -> dict:
    """Unit normals on a grid, and how much each one weighs."""
    places = [(i / n, j / m) for i in range(n + 1) for j in range(m + 1)]
    return {"n": n, "m": m, "normals": [list(App.Vector(*normal(s, t)).normalize()) for s, t in places],
            "weights": [weight(s, t) for s, t in places]}


def true_field(surface, n: int, m: int) -> dict:
    """The unit normals of a surface on a grid."""
    return sampled_field(n, m, surface.normal)


def _slopes(z) -> list:
    """Control points of the derivative of a Bezier function, raised to the function's own degree."""
    n = len(z) - 1
    steps = [0.0] + [n * (z[i + 1] - z[i]) for i in range(n)] + [0.0]
    return [i / n * steps[i] + (1 - i / n) * steps[i + 1] for i in range(n + 1)]


# Figure 1: a bi-quintic patch and two polynomial fields, of degree 8 x 8 and 5 x 5.

def arch() -> Part.BSplineSurface:
    return patch(level(lambda s, t: 30.0 * s * (1 - s) * (1.6 - t) + 8.0 * math.sin(5.0 * t), 5, 5))


def field_of_two_humps() -> dict:
    high = arch()
    high.increaseDegree(8, 8)
    return polynomial_field(raised(
        high.getPoles(), lambda s, t: 70.0 * bump(s, t, (0.25, 0.5), 0.2) + 70.0 * bump(s, t, (0.75, 0.5), 0.2), 1))


def field_of_a_hollow() -> dict:
    return polynomial_field(raised(
        arch().getPoles(), lambda s, t: -55.0 * bump(s, t, (0.6, 0.4), 0.35) + 25.0 * bump(s, t, (0.2, 0.8), 0.2), 1))


# Figures 2 and 3: a patch of degree 8 x 8 with a wavy edge and normals on a grid.

GRID = 16


def wavy_edge() -> Part.BSplineSurface:
    def height(s, t):
        x, y = 2 * s - 1, 2 * t - 1
        rim = max(abs(x), abs(y))
        return 20.0 * (1 - rim) + 14.0 * rim ** 4 * math.cos(4.0 * math.atan2(y, x))
    return patch(level(height, 8, 8))


def hat_with_a_flat_top() -> dict:
    """Upright on top, leaning outwards round it, nothing on the brim."""
    def radius(s, t):
        return 2 * math.hypot(s - 0.5, t - 0.5)

    def normal(s, t):
        r = radius(s, t)
        if r < 0.4:
            return 0.0, 0.0, 1.0
        return 2.5 * (s - 0.5) / r, 2.5 * (t - 0.5) / r, 1.0
    return sampled_field(GRID, GRID, normal, lambda s, t: 1.0 if radius(s, t) < 0.75 else 0.0)


def ridge_and_valley() -> dict:
    """Normals of a ridge beside a valley, faded out towards the border."""
    def normal(s, t):
        return -2.0 * math.cos(2.0 * math.pi * s), 0.0, 1.0
    return sampled_field(GRID, GRID, normal,
                         lambda s, t: 1.0 if 0.1 < s < 0.9 and 0.15 < t < 0.85 else 0.0)


# Figure 4: a hole of degree 7 x 7 and what was there.

def base_height(s, t) -> float:
    return 16.0 * math.sin(1.1 + 1.9 * s) + 12.0 * t * (1.2 - t) + 6.0 * s * t


def truth() -> Part.BSplineSurface:
    """A patch with a ridge across it that its two outer rows of control points do not tell."""
    def ridge(s, t):
        return 60.0 * math.exp(-((s - 0.35 - 0.3 * t) / 0.16) ** 2)
    return patch(raised(level(base_height, 7, 7), ridge, 2))


def around_the_hole() -> list:
    """Eight patches: the polynomial that the hole's two outer rows come from, carried on beyond its sides."""
    ranges = (-0.4, 0.0), (0.0, 1.0), (1.0, 1.4)
    poles = level(base_height, 7, 7)
    return [patch(_stretch(poles, *across, *along)) for across in ranges for along in ranges
            if across != (0.0, 1.0) or along != (0.0, 1.0)]


def _stretch(poles, s0, s1, t0, t1) -> list:
    """Control points of the same polynomial over [s0, s1] x [t0, t1]."""
    rows = [_stretched(row, t0, t1) for row in poles]
    columns = [_stretched(list(column), s0, s1) for column in zip(*rows)]
    return [list(row) for row in zip(*columns)]


def _stretched(row, a: float, b: float) -> list:
    """The same along a curve: its blossom at a and b."""
    def blossom(parameters):
        points = row
        for t in parameters:
            points = [p * (1 - t) + q * t for p, q in zip(points, points[1:])]
        return points[0]
    n = len(row) - 1
    return [blossom([a] * (n - k) + [b] * k) for k in range(n + 1)]


# Figure 5: transition surfaces of degree 5 x 5 between two sheets.

GAP = 60.0  # mm between the sheets


def roof_height(t) -> float:
    """Across both sheets: a rounded ridge."""
    return 34.0 * math.exp(-((t - 0.5) / 0.2) ** 2)


def step_height(t) -> float:
    """Across both sheets: a rounded step."""
    return 30.0 / (1.0 + math.exp(-(t - 0.5) / 0.07))


def sheet(profile, side: int, drop: float) -> Part.BSplineSurface:
    """One of two sheets, 50 mm long, that runs up to the gap; the right one is `drop` lower and falls away."""
    def point(s, t):
        x = 50.0 * (s - 1.0) if side < 0 else GAP + 50.0 * s
        fall = 0.0 if side < 0 else drop + 12.0 * s
        return App.Vector(x, SIDE * t, profile(t) - fall)
    return patch([[point(i / 5, j / 5) for j in range(6)] for i in range(6)])


def transition(profile, drop: float) -> Part.BSplineSurface:
    """The initial transition surface: tangent to both sheets by its two outer rows, flat inside."""
    left, right = sheet(profile, -1, drop).getPoles(), sheet(profile, 1, drop).getPoles()
    reach = GAP / 50.0  # the sheets' steps, as long as the gap's

    def pole(i, j):
        if i < 2:
            return left[5][j] + (left[5][j] - left[4][j]) * (i * reach)
        if i > 3:
            return right[0][j] + (right[0][j] - right[1][j]) * ((5 - i) * reach)
        share = (i - 1) / 3
        return pole(1, j) * (1 - share) + pole(4, j) * share - App.Vector(
            0, 0, 25.0 if 1 < j < 4 else 0.0)
    return patch([[pole(i, j) for j in range(6)] for i in range(6)])


def feature_field(profile, drop: float, n: int = 10) -> dict:
    """Normals of the profile swept across the gap, where the transition is to show it."""
    def normal(s, t):
        step = 1e-4
        return drop / GAP, -(profile(t + step) - profile(t - step)) / (2 * step * SIDE), 1.0
    return sampled_field(n, n, normal, lambda s, t: 1.0 if 0.15 < s < 0.85 else 0.0)
