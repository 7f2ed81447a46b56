# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line's contract: exit status, what is written, and one sentence on stderr."""
import json
import os
import subprocess
import sys

import pytest

sys.path[:0] = ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/Mod/Part"]
import FreeCAD  # noqa: E402,F401  Part needs it to be loaded first
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402
from interrupts import interrupted  # noqa: E402

PROGRAM = os.environ["FAIRING_BINARY"]
CELLS = 3


def height(x, y):
    return 0.02 * (x - 15) ** 2 - 0.015 * (y - 12) ** 2


def grid(without):
    """3 x 3 faces of 10 mm over a gently curved surface, without some of them."""
    surface = Part.BSplineSurface()
    surface.interpolate([[Vector(3 * i, 3 * j, height(3 * i, 3 * j)) for j in range(11)] for i in range(11)])
    u0, u1, v0, v1 = surface.bounds()
    faces = []
    for i in range(CELLS):
        for j in range(CELLS):
            if (i, j) in without:
                continue
            cell = surface.copy()
            cell.segment(u0 + (u1 - u0) * i / CELLS, u0 + (u1 - u0) * (i + 1) / CELLS,
                         v0 + (v1 - v0) * j / CELLS, v0 + (v1 - v0) * (j + 1) / CELLS)
            faces.append(cell.toShape())
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


def edge_at(shape, point):
    """The number of the edge whose middle is nearest in plan."""
    def distance(edge):
        middle = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
        return (middle.x - point[0]) ** 2 + (middle.y - point[1]) ** 2
    return 1 + min(range(len(shape.Edges)), key=lambda k: distance(shape.Edges[k]))


def read(path):
    shape = Part.Shape()
    shape.read(str(path))
    return shape


@pytest.fixture(scope="module")
def sheet(tmp_path_factory):
    """A file with a sheet that has a hole in its middle, and the numbers of the hole's edges."""
    shape = grid({(1, 1)})
    path = tmp_path_factory.mktemp("shapes") / "sheet.brep"
    shape.exportBrep(str(path))
    return path, [edge_at(shape, p) for p in ((15, 10), (20, 15), (15, 20), (10, 15))]


def run(*arguments, cwd=None):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=cwd)
    assert "terminate" not in done.stderr
    return done


def refused(*arguments, cwd=None):
    """Runs what must fail; returns the one line that says why."""
    done = run(*arguments, cwd=cwd)
    assert done.returncode == 2, done.stdout + done.stderr
    lines = done.stderr.splitlines()
    assert len(lines) == 1 and lines[0].startswith("fairing: "), done.stderr
    return lines[0][len("fairing: "):]


def test_fills_from_one_edge_and_says_how_well(sheet, tmp_path):
    path, edges = sheet
    out, report = tmp_path / "out.brep", tmp_path / "report.json"
    done = run("fill", path, "-o", out, "--edges", edges[0], "--report", report)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    verdict, *table = done.stdout.splitlines()
    assert verdict.startswith("Meets all 4 edges: tangent within ")
    assert len(table) == 6 and table[-1].startswith("Layout quad: 1 patch, ")
    numbers = json.loads(report.read_text())
    assert numbers["within_tolerance"] is True
    assert sorted(side["edge"] for side in numbers["holes"][0]["sides"]) == sorted(edges)
    assert numbers["holes"][0]["largest_angle"] <= 0.02
    face = read(out)
    assert face.isValid() and len(face.Faces) == 1
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out.brep", "report.json"]


def test_refuses_patches_that_only_touch(sheet, tmp_path):
    sentence = refused("fill", sheet[0], "-o", tmp_path / "out.brep", "--inner-continuity", "G0")
    assert "--inner-continuity" in sentence and "G0" in sentence


def test_any_order_and_any_edges_give_the_same_file(sheet, tmp_path):
    path, edges = sheet
    files = []
    for k, picks in enumerate((edges, edges[::-1], edges[2:3], [f"Edge{n}" for n in edges[1:3]])):
        files.append(tmp_path / f"{k}.brep")
        assert run("fill", path, "-o", files[-1], "--edges", ",".join(map(str, picks))).returncode == 0
    assert all(file.read_bytes() == files[0].read_bytes() for file in files)


def test_fills_every_hole_but_not_the_outer_border(sheet, tmp_path):
    path, edges = sheet
    done = run("fill", path, "-o", tmp_path / "out.brep")
    assert done.returncode == 0, done.stderr
    assert len(read(tmp_path / "out.brep").Faces) == 1


def test_writes_step_and_sews_into_the_base(sheet, tmp_path):
    path, edges = sheet
    assert run("fill", path, "-o", tmp_path / "out.step", "--edges", edges[0]).returncode == 0
    assert len(read(tmp_path / "out.step").Faces) == 1
    assert run("fill", path, "-o", tmp_path / "base.brep", "--edges", edges[0], "--result", "base").returncode == 0
    base = read(tmp_path / "base.brep")
    assert base.isValid() and len(base.Faces) == 9
    assert run("fill", path, "-o", tmp_path / "shell.brep", "--edges", edges[0], "--result", "shell").returncode == 0
    assert read(tmp_path / "shell.brep").ShapeType == "Shell"


def test_replaces_a_face_of_a_solid(tmp_path):
    Part.makeBox(10, 20, 30).exportBrep(str(tmp_path / "box.brep"))
    done = run("fill", tmp_path / "box.brep", "-o", tmp_path / "out.brep", "--faces", "Face3",
               "--continuity", "G0", "--result", "base")
    assert done.returncode == 0, done.stderr
    solid = read(tmp_path / "out.brep")
    assert solid.ShapeType == "Solid" and abs(solid.Volume - 6000) < 1e-6


def test_out_of_tolerance_is_written_and_told(tmp_path):
    # G1 to the walls of a box from its top: the walls meet in creases, so no smooth patch can do it.
    Part.makeBox(10, 20, 30).exportBrep(str(tmp_path / "box.brep"))
    done = run("fill", tmp_path / "box.brep", "-o", tmp_path / "out.brep", "--faces", "6", "--max-poles", "200")
    assert done.returncode == 1, done.stderr
    assert (tmp_path / "out.brep").exists()
    assert " misses tangency by " in done.stdout or "backwards" in done.stdout


def test_measures_foreign_faces(sheet, tmp_path):
    path, edges = sheet
    exact = tmp_path / "exact.brep"
    run("fill", path, "-o", exact, "--edges", edges[0])
    assert run("report", path, exact, "--edges", edges[0]).returncode == 0
    face = read(exact)
    face.translate(Vector(0, 0, 0.01))
    face.exportBrep(str(tmp_path / "shifted.brep"))
    done = run("report", path, tmp_path / "shifted.brep", "--edges", edges[0], "--report", tmp_path / "r.json")
    assert done.returncode == 1
    gap = json.loads((tmp_path / "r.json").read_text())["holes"][0]["largest_gap"]
    assert 0.009 < gap < 0.01 + 1e-9


def test_guides_by_reference_and_by_handles(sheet, tmp_path):
    path, edges = sheet
    # The missing cell, 0.5 mm higher.
    raised = grid({(i, j) for i in range(3) for j in range(3)} - {(1, 1)})
    raised.translate(Vector(0, 0, 0.5))
    raised.exportBrep(str(tmp_path / "raised.brep"))

    def middle_height(*arguments):
        out = tmp_path / "out.brep"
        done = run("fill", path, "-o", out, "--edges", edges[0], *arguments)
        assert done.returncode in (0, 1), done.stderr
        line = Part.makeLine(Vector(15, 15, -20), Vector(15, 15, 20))
        return read(out).distToShape(line)[1][0][0].z

    free = middle_height()
    pulled = middle_height("--reference", tmp_path / "raised.brep", "--gamma", 1e6)
    target = height(15, 15) + 0.5
    assert abs(pulled - target) < 0.2 * abs(free - target)

    guide = tmp_path / "guide.json"
    guide.write_text(json.dumps({"normals": [{"point": [15, 15, 0], "normal": [0.3, 0, 1], "radius": 5}]}))
    done = run("fill", path, "-o", tmp_path / "out.brep", "--edges", edges[0], "--guide", guide, "--lambda", 10)
    assert done.returncode in (0, 1), done.stderr


@pytest.mark.parametrize("arguments, sentence", [
    (["--edges", "999"], "There is no edge 999"),
    (["--edges", "0"], "There is no edge 0"),
    (["--edges", "seven"], '"seven" for --edges'),
    (["--faces", "99"], "There is no face 99"),
    (["--tolerance", "0"], "The tolerance must be a length above zero, not 0."),
    (["--tolerance", "-1"], "The tolerance must be a length above zero, not -1."),
    (["--tolerance", "nan"], "The tolerance must be a length above zero, not NaN."),
    (["--angle", "0"], "The angle tolerance must be above zero"),
    (["--lambda", "-1"], "The weight lambda must be zero or more, not -1."),
    (["--gamma", "nan"], "The weight gamma must be zero or more, not NaN."),
    (["--degree", "2"], "has third derivatives and needs degree 3 or more, not 2"),
    (["--degree", "2", "--energy", "thin-plate"], "The degree must be from 3 to 9"),
    (["--degree", "10"], "The degree must be from 3 to 9"),
    (["--energy", "steam"], '"steam" for --energy'),
    (["--layout", "round"], '"round" for --layout'),
    (["--result", "cake"], '"cake" for --result'),
    (["--continuity", "G7"], '"G7" for --continuity'),
    (["--edge-continuity", "7"], '"7" for --edge-continuity'),
    (["--tangent", "7=1,2"], '"7=1,2" for --tangent'),
    (["--tangent", "7=0,0,0"], '"7=0,0,0" for --tangent'),
    (["--symmetry", "x=0,0,1"], '"x=0,0,1" for --symmetry'),
    (["--through", "1,2"], "1,2 cannot be read."),
    (["--through", "none.step"], "none.step cannot be read."),
    (["--through-edges", "999"], "There is no edge 999"),
    (["--through-vertices", "Vertex999"], "There is no vertex 999"),
    (["--reference", "none.brep"], "none.brep cannot be read."),
    (["--guide", "none.json"], "none.json cannot be read."),
    (["--unheard-of"], "--unheard-of"),
])
def test_refuses_bad_options(sheet, tmp_path, arguments, sentence):
    assert sentence in refused("fill", sheet[0], "-o", "out.brep", *arguments, cwd=tmp_path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("text, why", [
    ("no json", "it is not JSON"),
    ("[]", 'no list called "normals"'),
    ('{"normals": [{"point": [0, 0], "normal": [0, 0, 1], "radius": 1}]}', "normal 1"),
    ('{"normals": [{"point": [0, 0, 0], "normal": [0, 0, 0], "radius": 1}]}', "its normal is zero"),
    ('{"normals": [{"point": [0, 0, 0], "normal": [0, 0, 1], "radius": -1}]}', "radius must be above zero"),
])
def test_refuses_bad_guides(sheet, tmp_path, text, why):
    (tmp_path / "guide.json").write_text(text)
    assert why in refused("fill", sheet[0], "-o", tmp_path / "out.brep", "--guide", tmp_path / "guide.json")


@pytest.mark.parametrize("name, content, sentence", [
    ("missing.brep", None, "cannot be read."),
    ("empty.brep", "", "holds no shape."),
    ("empty.step", "", "holds no shape."),
    ("words.brep", "These are words.", "holds no shape."),
    ("words.step", "These are words.", "holds no shape."),
    ("shape.txt", "", "is neither .brep nor .step by its name."),
])
def test_refuses_bad_files(tmp_path, name, content, sentence):
    if content is not None:
        (tmp_path / name).write_text(content)
    assert refused("fill", tmp_path / name, "-o", tmp_path / "out.brep").endswith(sentence)
    assert not (tmp_path / "out.brep").exists()


def test_refuses_what_cannot_be_written(sheet, tmp_path):
    path, edges = sheet
    for out in ("no/such/folder/out.brep", "out.obj", "."):
        refused("fill", path, "-o", out, "--edges", edges[0], cwd=tmp_path)
    (tmp_path / "old.brep").mkdir()
    assert "cannot be written" in refused("fill", path, "-o", "old.brep", "--edges", edges[0], cwd=tmp_path)


def test_refuses_loops_it_cannot_fill(sheet, tmp_path):
    path, edges = sheet
    out = tmp_path / "out.brep"
    outer = edge_at(read(path), (15, 0))
    assert "2 separate loops" in refused("fill", path, "-o", out, "--edges", f"{edges[0]},{outer}")
    Part.makeBox(1, 1, 1).exportBrep(str(tmp_path / "box.brep"))
    assert "has 2 faces beside it" in refused("fill", tmp_path / "box.brep", "-o", out, "--edges", 1)
    assert "no hole to fill" in refused("fill", tmp_path / "box.brep", "-o", out)
    points = [Vector(0, 0, 0), Vector(10, 0, 0), Vector(10, 10, 0), Vector(0, 10, 0), Vector(0, 0.5, 0)]
    lines = Part.makeCompound([Part.makeLine(a, b) for a, b in zip(points, points[1:])])
    lines.exportBrep(str(tmp_path / "gap.brep"))
    said = refused("fill", tmp_path / "gap.brep", "-o", out, "--edges", "1,2,3,4")
    assert "a gap of 0.5 mm" in said and " at (" in said
    assert not out.exists()


@pytest.fixture(scope="module")
def two_planes(tmp_path_factory):
    """A file with two rectangles, and the numbers of the edges that face each other."""
    shape = Part.Compound([Part.makePlane(20, 10), Part.makePlane(20, 10, Vector(0, 20, 8))])
    path = tmp_path_factory.mktemp("planes") / "planes.brep"
    shape.exportBrep(str(path))
    return path, edge_at(shape, (10, 10)), edge_at(shape, (10, 20))


def test_blends_two_edges_and_says_how_well(two_planes, tmp_path):
    path, start, end = two_planes
    out, report = tmp_path / "out.brep", tmp_path / "report.json"
    done = run("blend", path, "-o", out, "--from", start, "--to", f"Edge{end}", "--report", report)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert done.stdout.startswith("Meets all 2 edges: tangent within ")
    numbers = json.loads(report.read_text())
    assert numbers["within_tolerance"] is True and numbers["blend"]["layout"] == "strip"
    assert sorted(side["edge"] for side in numbers["blend"]["sides"]) == sorted([start, end])
    face = read(out)
    assert face.isValid() and len(face.Faces) == 1
    grouped = tmp_path / "grouped.brep"
    assert run("blend", path, "-o", grouped, "--edges", f"{start},{end}").returncode == 0
    assert grouped.read_bytes() == out.read_bytes()


def test_blends_into_the_base(two_planes, tmp_path):
    path, start, end = two_planes
    done = run("blend", path, "-o", tmp_path / "base.brep", "--from", start, "--to", end, "--continuity", "G2",
               "--result", "base")
    assert done.returncode == 0, done.stderr
    base = read(tmp_path / "base.brep")
    assert base.isValid() and len(base.Faces) == 3


def test_blends_from_a_drawn_curve(two_planes, tmp_path):
    path, start, end = two_planes
    pieces = [Part.makeLine(Vector(21, 8, 0), Vector(9, 6, 0)), Part.makeLine(Vector(-1, 6, 0), Vector(9, 6, 0))]
    shape = Part.Compound([read(path), *pieces])
    drawn = tmp_path / "drawn.brep"
    shape.exportBrep(str(drawn))
    start, end, last = edge_at(shape, (10, 10)), edge_at(shape, (10, 20)), len(shape.Edges)
    out = tmp_path / "trimmed.brep"
    sides = ["blend", drawn, "-o", out, "--from", start, "--to", end]
    done = run(*sides, "--from-curve", f"{last},Edge{last - 1}", "--result", "base")
    assert done.returncode == 0, done.stderr
    trimmed = min(read(out).Faces, key=lambda face: face.CenterOfMass.y)
    slope = 2.0 / 12.0  # of the second piece, from x = 9 to the border at 20
    assert abs(trimmed.Area - (20.0 * 6.0 + 0.5 * slope * 11.0 ** 2)) < 1e-4
    assert "set back by a distance and by a curve" in refused(*sides, "--to-curve", last, "--setback-to", 1)
    assert "ends inside face 1 at (9, 6, 0)" in refused(*sides, "--from-curve", last)


@pytest.fixture(scope="module")
def planes_with_ends(tmp_path_factory):
    """A file with two rectangles, a curve from the end of one to that of the other, and a wall (face 3) at the other
    ends; the numbers of the edges that face each other and that of the curve."""
    curve = Part.BezierCurve()
    curve.setPoles([Vector(0, 10, 0), Vector(0, 14, 0), Vector(0, 16, 8), Vector(0, 20, 8)])
    wall = Part.makePlane(60, 60, Vector(20, 50, -20), Vector(1, 0, 0))
    shape = Part.Compound([Part.makePlane(20, 10), Part.makePlane(20, 10, Vector(0, 20, 8)), wall, curve.toShape()])
    path = tmp_path_factory.mktemp("ends") / "planes.brep"
    shape.exportBrep(str(path))
    shape = read(path)
    return path, edge_at(shape, (10, 10)), edge_at(shape, (10, 20)), edge_at(shape, (0, 15)), wall


def test_lets_the_ends_of_a_blend_follow_edges_and_faces(planes_with_ends, tmp_path):
    path, start, end, curve, wall = planes_with_ends
    out, report = tmp_path / "out.brep", tmp_path / "report.json"
    done = run("blend", path, "-o", out, "--from", start, "--to", end, "--ends", curve, "--end-faces", "Face3",
               "--report", report)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert done.stdout.startswith("Meets all 4 edges (in position only: ") and "on face 3" in done.stdout
    sides = json.loads(report.read_text())["blend"]["sides"]
    assert sorted((side["edge"], side["asked"]) for side in sides) == sorted(
        [(0, "G0"), (curve, "G0"), (start, "G1"), (end, "G1")])
    face = read(out)
    on_wall = [vertex.Point.x for vertex in face.Vertexes if vertex.Point.x > 10]
    assert len(on_wall) == 2 and all(abs(x - 20) < 1e-6 for x in on_wall)
    assert max(point.x for edge in face.Edges for point in edge.discretize(50)) < 20 + 1e-6


def test_refuses_ends_that_make_no_sense(planes_with_ends, tmp_path):
    path, start, end, curve, _ = planes_with_ends
    out, sides = tmp_path / "out.brep", ("--from", start, "--to", end)
    other = next(number for number in range(1, 5) if number != start)
    assert f"Edge {other} leads from no end" in refused("blend", path, "-o", out, *sides, "--ends", other)
    assert "belongs to one of its sides" in refused("blend", path, "-o", out, *sides, "--ends", start)
    assert "There is no face 9" in refused("blend", path, "-o", out, *sides, "--end-faces", 9)
    assert not out.exists()


def test_refuses_blends_that_make_no_sense(two_planes, tmp_path):
    path, start, end = two_planes
    out = tmp_path / "out.brep"
    assert f"Edge {start} is picked for both sides" in refused("blend", path, "-o", out, "--from", start, "--to", start)
    assert 'No edge is picked for the side "to"' in refused("blend", path, "-o", out, "--from", start)
    assert "There is no edge 999" in refused("blend", path, "-o", out, "--from", 999, "--to", end)
    assert not out.exists()


def test_an_interrupt_writes_the_best_so_far(sheet, tmp_path):
    path, edges = sheet
    out, report = tmp_path / "out.brep", tmp_path / "report.json"
    status, done, told = interrupted("fill", path, "-o", out, "--edges", edges[0], "--report", report,
                                     "--energy", "minimum-variation")
    assert status == 0 and not told, told
    assert read(out).isValid() and done.startswith("Meets all 4 edges"), done
    hole, = json.loads(report.read_text())["holes"]
    assert hole["solve"]["shape"]["end"] == "stopped"
    assert any(note["text"].startswith("Stopped after ") for note in hole["notes"])


def test_explains_itself():
    for arguments in (["--help"], ["fill", "--help"], ["blend", "--help"], ["report", "--help"], ["compare-blend", "--help"]):
        done = run(*arguments)
        assert done.returncode == 0 and "SHAPE" in done.stdout or "fill" in done.stdout
    assert run("--version").stdout.startswith("fairing ")
    refused()
