# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same hole with several energies: from Python and on the command line, against the sphere it was cut from."""

import json
import os
import subprocess

import FreeCAD as App
import Part
import pytest

import fairing
from fairing.choices import ENERGIES
from interrupts import interrupted

PROGRAM = os.environ["FAIRING_BINARY"]
RADIUS = 30.0
VALUES = ("thin_plate", "total_curvature", "mean_curvature_gradient", "minimum_variation")


@pytest.fixture(scope="module")
def sphere():
    """A sphere without what a cylinder round its pole cuts off."""
    return Part.makeSphere(RADIUS).Faces[0].cut(Part.makeCylinder(15, 60))


@pytest.fixture(scope="module")
def reports(sphere):
    return fairing.compare(sphere, fairing.holes(sphere)[0])


def off_the_sphere(patches):
    """Largest distance of a shape's points from the sphere."""
    places = []
    for face in patches.Faces:
        u0, u1, v0, v1 = face.ParameterRange
        places += [face.valueAt(u0 + (u1 - u0) * i / 12, v0 + (v1 - v0) * j / 12) for i in range(13) for j in range(13)]
    return max(abs(point.Length - RADIUS) for point in places)


def test_every_energy_has_a_report_with_the_values_of_all(reports):
    assert [report["energy"] for report in reports] == list(ENERGIES)
    for report in reports:
        assert all(report["fairness"][name] >= 0.0 for name in VALUES)
        assert report["largest_gap"] <= report["limits"]["gap"] and report["solve"]["total_time"] > 0.0


def test_minimum_variation_varies_least_and_is_the_sphere(sphere, reports):
    variation = {report["energy"]: report["fairness"]["minimum_variation"] for report in reports}
    assert min(variation, key=variation.get) == "minimum-variation"
    assert variation["minimum-variation"] < 1e-3 * variation["thin-plate"]
    edges = fairing.holes(sphere)[0]
    off = {energy: off_the_sphere(fairing.fill(sphere, edges, energy=energy)[0])
           for energy in ("thin-plate", "membrane", "minimum-variation")}
    assert min(off, key=off.get) == "minimum-variation"
    assert off["minimum-variation"] < 1e-3


def test_membrane_bends_most(reports):
    total = {report["energy"]: report["fairness"]["total_curvature"] for report in reports}
    assert max(total, key=total.get) == "membrane"


def test_a_sphere_has_the_total_curvature_of_its_area(reports):
    best = next(report for report in reports if report["energy"] == "minimum-variation")["fairness"]
    assert best["total_curvature"] == pytest.approx(2.0 * best["area"] / RADIUS ** 2, rel=1e-4)


def test_only_the_energies_asked_for_and_an_unknown_one_is_told(sphere):
    edges = fairing.holes(sphere)[0]
    two = fairing.compare(sphere, edges, energies=("membrane", "soap"))
    assert [report["energy"] for report in two] == ["membrane", "soap"]
    assert "within_tolerance" in two[0] and "soap" in two[1]["error"]
    with pytest.raises(fairing.FairingError):
        fairing.compare(sphere, [999])


@pytest.fixture(scope="module")
def pipes():
    """Two pipes one above the other, and the rims that face each other."""
    shape = Part.makeCompound([Part.makeCircle(10, App.Vector(0, 0, z)).extrude(App.Vector(0, 0, 20)) for z in (0, 45)])
    return shape, [next(k for k, edge in enumerate(shape.Edges, 1)
                        if edge.CenterOfMass.isEqual(App.Vector(0, 0, z), 1e-6)) for z in (20, 45)]


def compare(command, *arguments):
    return subprocess.run([PROGRAM, command, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def test_a_blend_is_compared_in_the_same_way(pipes):
    pipes, rims = pipes
    energies = ("thin-plate", "minimum-variation")
    reports = fairing.compare_blend(pipes, rims[:1], rims[1:], energies=energies)
    told = {report["energy"]: report["fairness"] for report in reports}
    assert tuple(told) == energies
    best = told["minimum-variation"]  # the cylinder itself: H = 1 / (2 r) all over
    assert best["minimum_variation"] < told["thin-plate"]["minimum_variation"]
    assert best["total_curvature"] == pytest.approx(best["area"] / 10.0 ** 2, rel=1e-3)


def test_the_command_line_prints_the_same(sphere, reports, tmp_path):
    path, json_path = tmp_path / "sphere.brep", tmp_path / "report.json"
    sphere.exportBrep(str(path))
    edge = fairing.holes(sphere)[0][0][4:]
    done = subprocess.run([PROGRAM, "compare", path, "--edges", edge, "--report", json_path], capture_output=True,
                          text=True)
    lines = done.stdout.splitlines()
    assert done.returncode in (0, 1) and not done.stderr
    assert lines[0].split()[0] == "energy" and len(lines) == 2 + len(ENERGIES)
    rows = {line.split()[0]: line for line in lines[2:]}
    assert set(rows) == set(ENERGIES)
    told = {item["energy"]: item for item in json.loads(json_path.read_text())["energies"]}
    for report in reports:
        expected = report["fairness"]["total_curvature"]
        assert told[report["energy"]]["fairness"]["total_curvature"] == pytest.approx(expected, rel=1e-6)
        assert f" {expected:.4g} " in rows[report["energy"]]


def test_the_command_line_names_what_is_wrong(sphere, tmp_path):
    path = tmp_path / "sphere.brep"
    sphere.exportBrep(str(path))
    for extra, word in ((["--energies", "soap"], "soap"), (["--edges", "999"], "999")):
        done = subprocess.run([PROGRAM, "compare", path, *extra], capture_output=True, text=True)
        assert done.returncode == 2 and word in done.stderr and len(done.stderr.splitlines()) == 1


def test_several_holes_ask_for_a_pick(tmp_path):
    plate = Part.makePlane(60, 30).cut(Part.makeCylinder(5, 9, App.Vector(15, 15, -3)))
    plate = plate.cut(Part.makeCylinder(5, 9, App.Vector(45, 15, -3)))
    path = tmp_path / "plate.brep"
    plate.exportBrep(str(path))
    done = subprocess.run([PROGRAM, "compare", path], capture_output=True, text=True)
    assert done.returncode == 2 and "--edges" in done.stderr


def test_the_command_line_compares_blends_in_the_same_words(pipes, tmp_path):
    shape, rims = pipes
    path, json_path = tmp_path / "pipes.brep", tmp_path / "report.json"
    shape.exportBrep(str(path))
    picks = ("--from", rims[0], "--to", rims[1], "--reach-from", 1.5, "--continuity", "G2")
    done = compare("compare-blend", path, *picks, "--energies", "thin-plate,minimum-variation", "--report", json_path)
    assert done.returncode == 0 and not done.stderr, done.stderr
    reports = fairing.compare_blend(shape, rims[:1], rims[1:], from_reach=1.5, continuity="G2",
                                    energies=("thin-plate", "minimum-variation"))
    lines = done.stdout.splitlines()
    assert lines[0].split()[:4] == ["energy", "gap", "angle", "curvature"] and len(lines) == 4
    told = json.loads(json_path.read_text())["energies"]
    assert [item["energy"] for item in told] == ["thin-plate", "minimum-variation"]
    for line, item, report in zip(lines[2:], told, reports):
        assert line.split()[0] == item["energy"]
        assert item["layout"] == report["layout"] == "strip"
        for name in VALUES:
            assert item["fairness"][name] == pytest.approx(report["fairness"][name], rel=1e-6)
        assert f" {report['fairness']['total_curvature']:.4g} " in line
    grouped = compare("compare-blend", path, "--edges", f"{rims[0]},{rims[1]}", "--energies", "membrane")
    assert grouped.returncode == 0 and grouped.stdout.splitlines()[2].startswith("membrane ")


def test_a_hole_is_compared_with_what_a_fill_takes(sphere, tmp_path):
    path = tmp_path / "sphere.brep"
    sphere.exportBrep(str(path))
    edge = fairing.holes(sphere)[0][0][4:]
    done = compare("compare", path, "--edges", edge, "--through", "0,0,33", "--inner-continuity", "G2",
                   "--quadrature", "lobatto", "--energies", "thin-plate", "--report", tmp_path / "report.json")
    assert done.returncode in (0, 1) and not done.stderr, done.stderr
    item, = json.loads((tmp_path / "report.json").read_text())["energies"]
    assert item["inner"][0]["gap"]["max"] < 1e-3 and {seam["asked"] for seam in item["seams"]} == {"G2"}


def test_comparing_blends_names_what_is_wrong(pipes, tmp_path):
    shape, rims = pipes
    path = tmp_path / "pipes.brep"
    shape.exportBrep(str(path))
    sides = ["--from", rims[0], "--to", rims[1]]
    for arguments, word in (([*sides, "--energies", "soap"], "soap"), (["--from", 999, "--to", rims[1]], "999"),
                            (["--from", rims[0]], 'side "to"'), ([*sides, "--report", tmp_path / "no" / "r.json"], "r.json"),
                            ([*sides, "-o", "out.brep"], "-o"), ([*sides, "--energy", "membrane"], "--energy")):
        done = compare("compare-blend", path, *arguments)
        assert done.returncode == 2 and word in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr
        assert not done.stdout


def test_an_interrupt_ends_a_comparison_with_what_there_is(pipes, sphere, tmp_path):
    for name, shape, command in (("pipes", pipes[0], ["compare-blend", "--from", pipes[1][0], "--to", pipes[1][1]]),
                                 ("sphere", sphere, ["compare", "--edges", fairing.holes(sphere)[0][0]])):
        path, json_path = tmp_path / f"{name}.brep", tmp_path / f"{name}.json"
        shape.exportBrep(str(path))
        status, out, told = interrupted(command[0], path, *command[1:], "--report", json_path,
                                        "--energies", "minimum-variation,thin-plate,membrane")
        assert status == 1, told
        done, = json.loads(json_path.read_text())["energies"]
        assert done["energy"] == "minimum-variation" and done["solve"]["shape"]["end"] == "stopped"
        assert [line.split()[0] for line in out.splitlines()[2:]] == ["minimum-variation"]
        assert told == "fairing: Stopped: minimum-variation is the best so far; not compared: thin-plate, membrane.\n"
