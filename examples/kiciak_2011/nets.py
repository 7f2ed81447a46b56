#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""nets.py NAME N FILE: writes a control net for kiciak_2011, N x N points inside three rings.

Names: wave, saddle, step (a ledge that fades out), plateau (steep sides all round: grows a hernia).
"""

import math
import sys


def wave(u, v):
    return u, v, 0.25 * math.sin(2.5 * u + 0.7) * math.cos(3.1 * v - 0.4) + 0.2 * u * v


def saddle(u, v):
    radius = 1.0 + 0.35 * v * v + 0.15 * math.sin(3.0 * v)
    return radius * math.sin(1.1 * u), 1.2 * v + 0.2 * u, radius * math.cos(1.1 * u)


def step(u, v):
    return u, v, 0.5 * math.tanh(4.0 * u) + 0.15 * (1.0 - v * v) * (1.0 if u > 0.0 else 0.4)


def plateau(u, v):
    return u, v, math.tanh(3.0 * (1.0 - u * u)) * math.tanh(3.0 * (1.0 - v * v))


SURFACES = {"wave": wave, "saddle": saddle, "step": step, "plateau": plateau}


def net_of(surface, inner):
    """Control points (x, y, z), those of one u after the other; u and v go from -1 to 1 along the second ring."""
    places = [2.0 * (i - 1) / (inner + 3) - 1.0 for i in range(inner + 6)]
    return [surface(u, v) for u in places for v in places]


def write_net(path, points):
    """The text format of kiciak_2011, for a square net."""
    count = math.isqrt(len(points))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{count} {count}\n")
        file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in points)


def read_net(path):
    """The rows of a net in the same format: rows[i][j] is a control point."""
    with open(path, encoding="utf-8") as file:
        numbers = file.read().split()
    rows, columns = int(numbers[0]), int(numbers[1])
    flat = [float(number) for number in numbers[2:]]
    return [[tuple(flat[3 * (i * columns + j):][:3]) for j in range(columns)] for i in range(rows)]


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in SURFACES:
        print(__doc__, file=sys.stderr)
        return 2
    write_net(sys.argv[3], net_of(SURFACES[sys.argv[1]], int(sys.argv[2])))
    return 0


if __name__ == "__main__":
    sys.exit(main())
