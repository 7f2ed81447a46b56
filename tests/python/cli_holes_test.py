# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line on several holes at once, on edges without faces, and on what to pass through."""
import json
import math

import Part
import pytest
from FreeCAD import Vector

from cli_test import edge_at, grid, read, refused, run


@pytest.fixture(scope="module")
def holed(tmp_path_factory):
    """A plane sheet of 5 x 3 faces without two that touch neither each other nor the rim."""
    plane = [[Part.makePlane(10, 10, Vector(10 * i, 10 * j, 0)) for j in range(3)] for i in range(5)]
    shell = Part.makeShell([plane[i][j] for i in range(5) for j in range(3) if (i, j) not in ((1, 1), (3, 1))])
    shell.sewShape()
    path = tmp_path_factory.mktemp("holes") / "holed.brep"
    shell.exportBrep(str(path))
    return path


def test_every_hole_gets_a_line(holed, tmp_path):
    done = run("fill", holed, "-o", tmp_path / "out.brep", "--result", "base", "--report", tmp_path / "r.json")
    assert done.returncode == 0, done.stderr
    head, *lines = done.stdout.splitlines()
    assert head.split() == ["hole", "edge", "sides", "layout", "gap", "angle", "verdict"]
    assert len(lines) == 2 and all("quad" in line and "Meets all 4 edges" in line for line in lines)
    base = read(tmp_path / "out.brep")
    assert base.isValid() and len(base.Faces) == 15 and abs(base.Area - 1500) < 1e-6
    report = json.loads((tmp_path / "r.json").read_text())
    assert len(report["holes"]) == 2 and report["failed"] == [] and report["within_tolerance"]


def test_a_hole_that_fails_leaves_the_other_alone(holed, tmp_path):
    edge = edge_at(read(holed), (15, 10))
    done = run("fill", holed, "-o", tmp_path / "out.brep", "--tangent", f"{edge}=1,0,0", "--report", tmp_path / "r.json")
    assert done.returncode == 1
    assert "Hole at edge" in done.stderr and "runs along the edge" in done.stderr
    assert len(read(tmp_path / "out.brep").Faces) == 1
    report = json.loads((tmp_path / "r.json").read_text())
    assert len(report["holes"]) == 1 and edge in report["failed"][0]["edges"]
    assert not report["within_tolerance"]


def test_only_outer_borders_is_no_hole(tmp_path):
    grid(set()).exportBrep(str(tmp_path / "whole.brep"))
    said = refused("fill", tmp_path / "whole.brep", "-o", tmp_path / "out.brep")
    assert "no hole" in said


def test_what_to_pass_through_belongs_to_one_hole(holed, tmp_path):
    said = refused("fill", holed, "-o", tmp_path / "out.brep", "--through", "15,15,1")
    assert "pick an edge" in said


def test_a_point_too_far_off_is_refused(holed, tmp_path):
    edge = edge_at(read(holed), (15, 10))
    said = refused("fill", holed, "-o", tmp_path / "out.brep", "--edges", edge, "--through", "15,15,300")
    assert "farther than the loop is large" in said


def test_files_of_points_say_which_line_is_wrong(holed, tmp_path):
    edge = edge_at(read(holed), (15, 10))
    points = tmp_path / "points.txt"
    points.write_text("# x y z\n15 15 0.5\nup and away\n")
    assert '"up and away" for --through' in refused(
        "fill", holed, "-o", tmp_path / "out.brep", "--edges", edge, "--through", points)


def arch():
    """Edges without faces: arcs 5 mm high over 40 mm in the planes y = 0 and y = 20, lines between their ends."""
    arcs = [Part.Arc(Vector(0, y, 0), Vector(20, y, 5), Vector(40, y, 0)).toShape() for y in (0, 20)]
    lines = [Part.makeLine(Vector(x, 0, 0), Vector(x, 20, 0)) for x in (0, 40)]
    return Part.makeCompound(arcs + lines)


def test_a_symmetry_plane_takes_the_place_of_a_face(tmp_path):
    arch().exportBrep(str(tmp_path / "arch.brep"))
    done = run("fill", tmp_path / "arch.brep", "-o", tmp_path / "out.brep", "--edges", "1,2,3,4",
               "--symmetry", "1=0,1,0", "--symmetry", "2=0,1,0")
    assert done.returncode == 0, done.stderr + done.stdout
    assert "G1" in done.stdout
    face = read(tmp_path / "out.brep").Faces[0]
    for x in (5, 15, 30):
        point = Vector(x, 0, math.sqrt(42.5 ** 2 - (x - 20) ** 2) - 37.5)
        assert abs(face.normalAt(*face.Surface.parameter(point)).y) < 1e-3


def test_a_direction_along_its_edge_is_refused(tmp_path):
    arch().exportBrep(str(tmp_path / "arch.brep"))
    said = refused("fill", tmp_path / "arch.brep", "-o", tmp_path / "out.brep", "--edges", "1,2,3,4",
                   "--tangent", "3=0,1,0")
    assert "runs along the edge" in said and "edge 3" in said
    said = refused("fill", tmp_path / "arch.brep", "-o", tmp_path / "out.brep", "--edges", "1,2,3,4",
                   "--symmetry", "1=0,1,1")
    assert "leaves the symmetry plane" in said


def test_a_loop_that_crosses_itself_is_refused(tmp_path):
    corners = [Vector(0, 0, 0), Vector(10, 10, 0), Vector(10, 0, 0), Vector(0, 10, 0)]
    Part.makeCompound([Part.makeLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]).exportBrep(
        str(tmp_path / "bow.brep"))
    said = refused("fill", tmp_path / "bow.brep", "-o", tmp_path / "out.brep", "--edges", "1,2,3,4")
    assert "crosses itself" in said and "(5, 5, 0)" in said
