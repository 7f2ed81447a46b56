# SPDX-License-Identifier: LGPL-2.1-or-later
"""fairing.fill() and its companions on Part shapes, as a script uses them; the command line gives the same."""

import json
import os
import subprocess

import FreeCAD as App
import Part
import pytest

import fairing
from fairing.fill_request import FillRequest


def test_fill_takes_names_and_numbers_alike(sheet, edges):
    by_name, _ = fairing.fill(sheet, [f"Edge{edges[0]}"])
    by_number, _ = fairing.fill(sheet, edges[0])
    assert by_name.CenterOfMass == by_number.CenterOfMass


def test_fill_moves_with_the_shape(sheet, edges):
    patch, report = fairing.fill(sheet, edges[:1])
    placement = App.Placement(App.Vector(100, 200, -50), App.Rotation(App.Vector(1, 1, 0), 35))
    moved = sheet.copy()
    moved.Placement = placement
    patch_moved, report_moved = fairing.fill(moved, edges[:1])
    assert patch_moved.CenterOfMass.distanceToPoint(placement.multVec(patch.CenterOfMass)) < 1e-9 * report["diagonal"]
    assert patch_moved.Area == pytest.approx(patch.Area, rel=1e-9)


def test_a_plane_hole_gets_a_plane_patch():
    outer = Part.makePlane(40, 40, App.Vector(-20, -20, 0))
    frame = outer.cut(Part.Face(Part.makePolygon([(-5, -5, 0), (5, -5, 0), (6, 5, 0), (-5, 6, 0), (-5, -5, 0)])))
    patch, report = fairing.fill(frame, fairing.holes(frame)[0])
    assert patch.BoundBox.ZLength < 1e-9
    assert patch.Area == pytest.approx(1600.0 - frame.Area, rel=1e-9)
    assert report["within_tolerance"]


def test_membrane_is_smaller_and_thin_plate_fairer(sheet, edges):
    plate, plate_report = fairing.fill(sheet, edges[:1])
    membrane, membrane_report = fairing.fill(sheet, edges[:1], energy="membrane")
    assert membrane.Area < plate.Area
    assert membrane_report["fairness"]["total_curvature"] > plate_report["fairness"]["total_curvature"]


@pytest.mark.parametrize("energy", ["mean-curvature-gradient-minimum", "minimum-variation", "total-curvature"])
def test_energies_of_the_shape_go_to_their_minimum(sheet, edges, energy):
    _, report = fairing.fill(sheet, edges[:1], energy=energy)
    assert report["within_tolerance"]
    shape = report["solve"]["shape"]
    assert shape["end"] == "converged"
    assert shape["steps"][-1]["energy"] <= shape["start"]


def curvatures_in_the_middle(patches):
    """Gaussian and mean curvature of every patch of a star where all of them meet."""
    corners = []
    for face in patches.Faces:
        u0, u1, v0, v1 = face.Surface.bounds()
        corners.append([(face.Surface.value(u, v), face.Surface, u, v) for u in (u0, u1) for v in (v0, v1)])
    middle = min(corners[0], key=lambda corner: sum(
        min(corner[0].distanceToPoint(other[0]) for other in others) for others in corners[1:]))[0]
    nearest = [min(own, key=lambda corner: corner[0].distanceToPoint(middle)) for own in corners]
    return [(surface.curvature(u, v, "Gauss"), surface.curvature(u, v, "Mean")) for _, surface, u, v in nearest]


def test_patches_meet_in_curvature_where_that_is_asked(sheet, edges):
    patches, report = fairing.fill(sheet, edges[:1], layout="star", inner_continuity="G2")
    assert len(patches.Faces) == 4 and report["within_tolerance"]
    assert all(seam["asked"] == "G2" and seam["jump"]["max"] <= 0.01 for seam in report["seams"])
    gauss, mean = zip(*curvatures_in_the_middle(patches))
    scale = max(map(abs, mean)) or 1.0
    assert max(gauss) - min(gauss) < 1e-6 * scale ** 2 and max(mean) - min(mean) < 1e-6 * scale


def test_triharmonic_bends_more_evenly_than_the_plate(sheet, edges):
    _, plate = fairing.fill(sheet, edges[:1], energy="thin-plate")
    _, report = fairing.fill(sheet, edges[:1], energy="triharmonic")
    assert report["within_tolerance"] and report["solve"]["shape"]["end"] == "none"
    fairness = [r["fairness"]["mean_curvature_gradient"] for r in (report, plate)]
    assert fairness[0] < fairness[1]


def test_a_reference_attracts(sheet, edges):
    free, _ = fairing.fill(sheet, edges[:1])
    reference = free.translated(App.Vector(0, 0, 5))
    weak, _ = fairing.fill(sheet, edges[:1], reference=reference, gamma=1e3)
    strong, report = fairing.fill(sheet, edges[:1], reference=reference, gamma=1e5)
    heights = [patch.CenterOfMass.z - free.CenterOfMass.z for patch in (weak, strong)]
    assert 0.0 < heights[0] < heights[1] < 5.0 and report["within_tolerance"]


def test_report_measures_foreign_faces(sheet, edges):
    wires = Part.Compound([sheet.Edges[edge - 1] for edge in edges])
    coons = Part.makeFilledFace(wires.Edges)
    report = fairing.report(sheet, coons, edges[:1])
    assert not report["within_tolerance"] and report["largest_angle"] > 0.02


def test_the_command_line_gives_the_same(sheet, edges, tmp_path):
    sheet.exportBrep(str(tmp_path / "in.brep"))
    subprocess.run([os.environ["FAIRING_BINARY"], "fill", tmp_path / "in.brep", "-o", tmp_path / "out.brep", "--edges",
                    str(edges[0]), "--report", tmp_path / "report.json"], check=True, capture_output=True)
    written = Part.read(str(tmp_path / "out.brep")).Faces[0]
    patch, report = fairing.fill(sheet, edges[:1])
    assert written.CenterOfMass.distanceToPoint(patch.CenterOfMass) < 1e-9
    assert json.loads((tmp_path / "report.json").read_text())["within_tolerance"] is report["within_tolerance"]


def test_request_reads_names_and_keeps_only_differences():
    request = FillRequest.of(["Edge7", 3], {"Edge9": "G0"}, energy="membrane")
    assert (request.edges, request.faces, request.edge_continuity) == ((7, 3), (), ((9, "G0"),))
    assert request.differences(FillRequest()) == {"edge_continuity": {"Edge9": "G0"}, "energy": "membrane"}
    assert FillRequest.of("Face2").picks() == ["Face2"]
    with pytest.raises(ValueError, match="Vertex1"):
        FillRequest.of(["Vertex1"])


def test_a_repeated_fill_is_not_computed_again(sheet, edges):
    from fairing import exchange

    request, data = FillRequest.of(edges[:1], degree=5), exchange.data_of(sheet)
    assert request.solve(data) is request.solve(data)
    assert request.solve(data) is not FillRequest.of(edges[:1], degree=6).solve(data)
