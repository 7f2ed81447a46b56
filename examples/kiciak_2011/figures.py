#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The studies of [Kiciak2011] section 6, made again with nets of our own (nets.py):

    examples/kiciak_2011/figures.py build/dev/bin/kiciak_2011 DIR

prints a table a study and writes kiciak_isophotes.png into DIR: nine patches with one border. Along a row the number of
spans doubles, 10, 20 and 40; from above the patches are triharmonic, of F with C = 0.1, and of F with C = 0.001.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import nets  # noqa: E402
import painting  # noqa: E402
import patches  # noqa: E402

COARSEST = 7  # control points inside the rings: 10 spans
HALVINGS = 3  # nets with one border
KINDS = {"triharmonic": ("--functional", "triharmonic"), "F, C = 0.1": ("--c", "0.1"), "F, C = 0.001": ("--c", "0.001")}
WEIGHTS = "0.1", "0.01", "0.001", "0.0001", "0"
REMEDIES = {
    "triharmonic": ("--functional", "triharmonic"),
    "F": (),
    "F, C = 0.1": ("--c", "0.1"),
    "flattened to 0.7": ("--stretch", "1,1,0.7"),
    "flattened to 0.5": ("--stretch", "1,1,0.5"),
    "one curve kept": ("--fix-u", "10.5"),
    "two curves kept": ("--fix-u", "10.5", "--fix-v", "10.5"),
}
TILE, CELLS, TURN, TILT = 240, 100, 30.0, 50.0  # pixels; of a patch in the picture; degrees
SCALE = 75.0  # pixels a unit
BANDS, LIGHT = 14.0, (0.36, 0.48, 0.8)  # dark and bright stripes of equal angle to the light


def rows_of(name, inner):
    points, count = nets.net_of(nets.SURFACES[name], inner), inner + 6
    return [points[i * count:(i + 1) * count] for i in range(count)]


def print_row(name, *numbers):
    print(f"{name:24}" + "".join(f"{number:>14}" for number in numbers))


def told(report, *more):
    return [f"{report[name]:.6g}" for name in "TSQF"] + list(more)


def resolutions(program, path):
    """Nine patches with one border, and their picture."""
    print_row("step, one border", "spans", "T", "S", "Q", "F", "steps")
    canvas = painting.Canvas(HALVINGS * TILE, len(KINDS) * TILE)
    given = rows_of("step", COARSEST)
    for column in range(HALVINGS):
        for row, (name, arguments) in enumerate(KINDS.items()):
            net, report = patches.optimise(program, given, *arguments)
            print_row(name, len(given) - 3, *told(report, len(report["steps"])))
            canvas.draw([[place(point, normal, column, row) for point, normal in line]
                         for line in patches.grid(net, CELLS)])
        given = patches.halved(given)
    canvas.write(path, lambda light: (40, 60, 90) if int(BANDS * light) % 2 else (205, 222, 240))


def place(point, normal, column, row):
    x, y, depth = painting.seen(point, TURN, TILT)
    light = abs(sum(n * l for n, l in zip(normal, LIGHT)))
    return TILE * (column + 0.5) + SCALE * x, TILE * (row + 0.5) - SCALE * y, depth, light


def weights(program):
    print_row("C, N = 20", "T", "S", "Q", "F", "steps", "end")
    for name in ("wave", "saddle", "step"):
        for weight in WEIGHTS:
            _, report = patches.optimise(program, rows_of(name, 20), "--c", weight, "--steps", "200")
            print_row(f"{name}, C = {weight}", *told(report, len(report["steps"]), report["outcome"]))


def starts(program):
    print_row("start, N = 20", "F there", "F least", "steps", "factorings")
    for name in ("wave", "saddle", "step"):
        for start in ("triharmonic", "coons", "given"):
            _, report = patches.optimise(program, rows_of(name, 20), "--start", start)
            print_row(f"{name}, {start}", f"{report['steps'][0]['F']:.6g}", f"{report['F']:.9g}",
                      len(report["steps"]), sum(step["factorisations"] for step in report["steps"]))


def remedies(program):
    print_row("plateau, N = 12", "T", "S", "Q", "F", "stands out by")
    for name, arguments in REMEDIES.items():
        net, report = patches.optimise(program, rows_of("plateau", 12), *arguments)
        reach = max(abs(coordinate) for line in patches.grid(net, CELLS) for point, _ in line for coordinate in point[:2])
        print_row(name, *told(report, f"{100.0 * (reach - 1.0):.1f} %"))


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    program, folder = sys.argv[1:]
    resolutions(program, os.path.join(folder, "kiciak_isophotes.png"))
    for study in (weights, starts, remedies):
        print()
        study(program)
    return 0


if __name__ == "__main__":
    sys.exit(main())
