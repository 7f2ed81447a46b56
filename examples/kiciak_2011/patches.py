# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures need of a patch: kiciak_2011 run on a net, values of its surface, the same net on halved spans."""

import json
import math
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import nets  # noqa: E402


def optimise(program, rows, *arguments):
    """The program's net for the rings of one, and its line of JSON with the history of the steps."""
    with tempfile.TemporaryDirectory() as folder:
        start, end, report = (os.path.join(folder, name) for name in ("in.txt", "out.txt", "report.json"))
        nets.write_net(start, [point for row in rows for point in row])
        run = subprocess.run([program, start, "-o", end, "--report", report, "--threads", "2", *arguments],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        if run.returncode > 1:
            raise RuntimeError(run.stderr.decode())
        with open(report, encoding="utf-8") as file:
            return nets.read_net(end), json.load(file)


def halved(rows):
    """The same patch with every span halved, by the algorithm of Lane and Riesenfeld: doubled control points, and
    means of neighbours taken three times, along either direction."""
    across = [_halved(row) for row in rows]
    return [list(row) for row in zip(*(_halved(column) for column in zip(*across)))]


def _halved(points):
    line = [point for point in points for _ in range(2)]
    for _ in range(3):
        line = [tuple(0.5 * (a + b) for a, b in zip(p, q)) for p, q in zip(line, line[1:])]
    return line


def basis(t):
    """The four cubic B-splines at 0 <= t <= 1 of a span, and their derivatives."""
    s = 1.0 - t
    values = s ** 3 / 6, (3 * t ** 3 - 6 * t * t + 4) / 6, (3 * s ** 3 - 6 * s * s + 4) / 6, t ** 3 / 6
    return values, (-s * s / 2, 1.5 * t * t - 2 * t, 2 * s - 1.5 * s * s, t * t / 2)


def _blend(weights, points):
    return [sum(w * p[c] for w, p in zip(weights, points)) for c in range(3)]


def grid(rows, cells):
    """(cells + 1)^2 points of a patch with their unit normals, evenly over the domain."""
    lines = []
    for i in range(cells + 1):
        span, values, slopes = _place(i / cells, len(rows) - 3)
        columns = [[row[j] for row in rows[span:span + 4]] for j in range(len(rows[0]))]
        ends = [_blend(values, column) for column in columns]
        turned = [_blend(slopes, column) for column in columns]
        lines.append([_point(ends, turned, j / cells) for j in range(cells + 1)])
    return lines


def _place(share, spans):
    span = min(int(share * spans), spans - 1)
    return (span, *basis(share * spans - span))


def _point(ends, turned, share):
    span, values, slopes = _place(share, len(ends) - 3)
    point, along = _blend(values, ends[span:span + 4]), _blend(slopes, ends[span:span + 4])
    u = _blend(values, turned[span:span + 4])
    normal = [u[1] * along[2] - u[2] * along[1], u[2] * along[0] - u[0] * along[2], u[0] * along[1] - u[1] * along[0]]
    length = math.sqrt(sum(x * x for x in normal)) or 1.0
    return point, [x / length for x in normal]
