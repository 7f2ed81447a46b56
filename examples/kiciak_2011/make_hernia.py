# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the hernia effect and what helps against it, without a window:

    scripts/with_freecad --output DIR examples/kiciak_2011/make_hernia.py build/dev/bin/kiciak_2011

runs the program on a plateau with steep sides, as it is and with each remedy, and writes into DIR hernia.FCStd with the
faces side by side and kiciak_hernia.svg, a picture of them.
"""

import math
import os
import subprocess
import sys

import FreeCAD as App
import Part

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import nets  # noqa: E402  freecadcmd does not look beside the script

INNER = 12  # control points along either direction, inside the rings
CASES = {
    "Triharmonic": ["--functional", "triharmonic"],
    "Hernia": [],
    "Flattened": ["--stretch", "1,1,0.5"],
    "Curves": ["--fix-u", "10.5", "--fix-v", "10.5"],
}
TITLES = {
    "Triharmonic": "triharmonic",
    "Hernia": "F: a hernia",
    "Flattened": "F, space flattened to one half",
    "Curves": "F, the two middle curves kept",
}
SPACING = 3.2  # between the faces
QUADS = 20  # of a face in the picture, along either direction
SCALE, ACROSS, DOWN = 80.0, 250.0, 270.0  # pixels


def optimised(program, folder, case):
    """The face of a case."""
    start, end = (os.path.join(folder, f"{case}_{which}.txt") for which in ("in", "out"))
    nets.write_net(start, nets.net_of(nets.SURFACES["plateau"], INNER))
    subprocess.run([program, start, "-o", end, *CASES[case]], check=True)
    return surface_of(nets.read_net(end))


def surface_of(rows):
    """The patch on its uniform knots."""
    surface = Part.BSplineSurface()
    knots_u, knots_v = ([float(k) for k in range(count + 4)] for count in (len(rows), len(rows[0])))
    poles = [[App.Vector(*point) for point in row] for row in rows]
    surface.buildFromPolesMultsKnots(
        poles, [1] * len(knots_u), [1] * len(knots_v), knots_u, knots_v, False, False, 3, 3)
    return surface


def seen(point):
    """Where a point lies in the picture, and how near."""
    turned = 0.5 * (point.x - point.y) * math.sqrt(2.0), 0.5 * (point.x + point.y) * math.sqrt(2.0)
    tilt = math.radians(12.0)
    return turned[0], turned[1] * math.sin(tilt) - point.z * math.cos(tilt), turned[1]


def quads_of(surface):
    """Shaded quads of a surface, the farthest first: corners in the picture and a grey."""
    u0, u1, v0, v1 = surface.bounds()
    points = [[surface.value(u0 + (u1 - u0) * i / QUADS, v0 + (v1 - v0) * j / QUADS)
               for j in range(QUADS + 1)] for i in range(QUADS + 1)]
    light = App.Vector(0.3, 0.5, 0.8).normalize()
    quads = []
    for i in range(QUADS):
        for j in range(QUADS):
            corners = points[i][j], points[i + 1][j], points[i + 1][j + 1], points[i][j + 1]
            normal = (corners[2] - corners[0]).cross(corners[3] - corners[1])
            brightness = abs(normal.normalize().dot(light)) if normal.Length > 0.0 else 0.5
            places = [seen(corner) for corner in corners]
            quads.append((sum(place[2] for place in places), places, int(70 + 170 * brightness)))
    return sorted(quads, key=lambda quad: quad[0])


def draw(surfaces, path):
    """All surfaces in one SVG."""
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {ACROSS * len(surfaces):.0f} 340" '
             'font-family="sans-serif" font-size="14" text-anchor="middle">',
             f'<rect width="{ACROSS * len(surfaces):.0f}" height="340" fill="white"/>']
    for number, (case, surface) in enumerate(surfaces.items()):
        middle = ACROSS * (number + 0.5)
        for _, places, grey in quads_of(surface):
            corners = " ".join(f"{middle + SCALE * x:.1f},{DOWN + SCALE * y:.1f}" for x, y, _ in places)
            colour = f"#{grey * 3 // 4:02x}{grey * 7 // 8:02x}{grey:02x}"
            lines.append(f'<polygon points="{corners}" fill="{colour}" stroke="{colour}"/>')
        lines.append(f'<text x="{middle:.0f}" y="330">{TITLES[case]}</text>')
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "</svg>", ""]))


def make(program, folder):
    """Both files."""
    surfaces = {case: optimised(program, folder, case) for case in CASES}
    document = App.newDocument("hernia")
    for number, (case, surface) in enumerate(surfaces.items()):
        feature = document.addObject("Part::Feature", case)
        feature.Shape = surface.toShape()
        feature.Placement.Base = App.Vector(SPACING * number, 0.0, 0.0)
    document.recompute()
    document.saveAs(os.path.join(folder, "hernia.FCStd"))
    draw(surfaces, os.path.join(folder, "kiciak_hernia.svg"))


make(sys.argv[-1], os.environ["FAIRING_OUTPUT"])
