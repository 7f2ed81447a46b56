# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a fill: what is asked for, and what was measured."""

from __future__ import annotations

import FreeCAD as App

from .. import exchange, subelements
from ..fill_request import CONTINUITIES, ENERGIES, RESULTS, FillRequest
from .placement import container_of, shape_in

READ_ONLY, HIDDEN = 1, 4  # FreeCAD's property editor modes, as bits of addProperty's attributes

# name, type, group, tooltip
ASKED = (
    ("Edges", "App::PropertyLinkSubGlobal", "Boundary", "Edges of the hole's border, or the face to be replaced"),
    ("Continuity", "App::PropertyEnumeration", "Boundary",
     "How the surface meets its neighbours: G1 tangentially, G0 only touching"),
    ("EdgeContinuity", "App::PropertyStringList", "Boundary", "Edges that differ, one a line: Edge7=G0"),
    ("GapTolerance", "App::PropertyLength", "Boundary",
     "Largest distance of an edge from the surface; 0: a millionth of the hole's diagonal"),
    ("AngleTolerance", "App::PropertyAngle", "Boundary", "Largest angle between the normals along an edge"),
    ("Energy", "App::PropertyEnumeration", "Shape",
     "What the surface minimises: thin-plate bends as little as possible, membrane stretches as little as possible"),
    ("Degree", "App::PropertyInteger", "Shape", "Degree of the surface, 3 to 9; 0: chosen from the edges"),
    ("MaxPoles", "App::PropertyInteger", "Shape", "Largest number of control points"),
    ("Reference", "App::PropertyLinkSubGlobal", "Guidance", "Faces whose normals and points guide the surface"),
    ("Lambda", "App::PropertyFloat", "Guidance", "Weight of the reference's normals, 0: none"),
    ("Gamma", "App::PropertyFloat", "Guidance", "Weight of the reference's points, 0: none"),
    ("ResultMode", "App::PropertyEnumeration", "Result",
     "patches: the new faces; shell: sewn to one another; base: sewn into the base, a solid where that closes it"),
)
MEASURED = (
    ("Verdict", "App::PropertyString", "Report", "Whether the surface meets its neighbours, in words"),
    ("WithinTolerance", "App::PropertyBool", "Report", "Whether every edge is met within the tolerances"),
    ("LargestGap", "App::PropertyLength", "Report", "Largest distance of an edge from the surface"),
    ("LargestAngle", "App::PropertyAngle", "Report", "Largest angle to a neighbour along the edges"),
    ("LargestCornerAngle", "App::PropertyAngle", "Report", "Largest angle to a neighbour next to the corners"),
    ("ReportEdges", "App::PropertyStringList", "Report", "The edges in the order of the hole's border"),
    ("EdgeGaps", "App::PropertyFloatList", "Report", "Largest distance from the surface, edge by edge, mm"),
    ("EdgeAngles", "App::PropertyFloatList", "Report", "Largest angle, edge by edge, degrees"),
    ("EdgeCornerAngles", "App::PropertyFloatList", "Report",
     "Largest angle next to its corners, edge by edge, degrees"),
    ("EdgeCurvatures", "App::PropertyFloatList", "Report",
     "Largest relative difference of the curvatures across the edge, edge by edge, 0 to 1"),
    ("Poles", "App::PropertyInteger", "Report", "Number of control points"),
    ("FilledArea", "App::PropertyArea", "Report", "Area of the new faces"),
)
CHOICES = {"Continuity": CONTINUITIES, "Energy": ENERGIES, "ResultMode": RESULTS}


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    for name, kind, group, tip in ASKED:
        if name not in obj.PropertiesList:
            obj.addProperty(kind, name, group, tip)
            if name in CHOICES:
                setattr(obj, name, list(CHOICES[name]))
            _set_default(obj, name)
    for name, kind, group, tip in MEASURED:
        if name not in obj.PropertiesList:
            obj.addProperty(kind, name, group, tip, READ_ONLY)


def write_request(obj: App.DocumentObject, request: FillRequest, base: App.DocumentObject, reference) -> None:
    """Stores what is asked for; of the reference its link, (object, [names]) or None."""
    obj.Edges = (base, request.picks())
    obj.Continuity = request.continuity
    obj.EdgeContinuity = [f"Edge{edge}={word}" for edge, word in request.edge_continuity]
    obj.GapTolerance = request.gap_tolerance or 0.0
    obj.AngleTolerance = request.angle_tolerance
    obj.Energy = request.energy
    obj.Degree = request.degree
    obj.MaxPoles = request.max_poles
    obj.Lambda = request.lambda_
    obj.Gamma = request.gamma
    obj.Reference = reference
    obj.ResultMode = request.result


def read_request(obj: App.DocumentObject) -> FillRequest:
    """What an object's properties ask for. Raises ValueError with one sentence."""
    picks = obj.Edges[1] if obj.Edges else ()
    exceptions = {}
    for line in obj.EdgeContinuity:
        edge, _, word = (part.strip() for part in line.partition("="))
        if not subelements.is_edge(edge):
            raise ValueError(f"EdgeContinuity holds '{line}': write an edge and its continuity, such as Edge7=G0")
        exceptions[edge] = word
    reference = shape_in(container_of(obj), *obj.Reference) if obj.Reference else None
    return FillRequest.of(
        [pick for pick in picks if pick], exceptions, continuity=obj.Continuity, energy=obj.Energy,
        lambda_=obj.Lambda, gamma=obj.Gamma, reference=exchange.data_of(reference) if reference else None,
        gap_tolerance=obj.GapTolerance.Value or None, angle_tolerance=obj.AngleTolerance.Value, degree=obj.Degree,
        max_poles=obj.MaxPoles, result=obj.ResultMode)


def write_report(obj: App.DocumentObject, fill) -> None:
    """Stores what was measured."""
    report = fill.report
    sides = report["sides"]
    obj.Verdict = fill.verdict
    obj.WithinTolerance = fill.within_tolerance
    obj.LargestGap = report["largest_gap"]
    obj.LargestAngle = report["largest_angle"]
    obj.LargestCornerAngle = report["largest_corner_angle"]
    obj.ReportEdges = [f"Edge{side['edge']}" for side in sides]
    obj.EdgeGaps = [side["gap"]["max"] for side in sides]
    obj.EdgeAngles = [side["angle"]["max"] for side in sides]
    obj.EdgeCornerAngles = [side["corner_angle"]["max"] for side in sides]
    obj.EdgeCurvatures = [side["curvature"]["max"] for side in sides]
    obj.Poles = report["solve"]["poles"]
    obj.FilledArea = report["fairness"]["area"]


def write_failure(obj: App.DocumentObject, sentence: str) -> None:
    """The shape and its numbers stay those of the last success; only the verdict changes."""
    obj.Verdict = sentence
    obj.WithinTolerance = False


def _set_default(obj: App.DocumentObject, name: str) -> None:
    """Every other property starts as FreeCAD makes it: 0, empty, the first choice."""
    plain = FillRequest()
    defaults = {"Continuity": plain.continuity, "AngleTolerance": plain.angle_tolerance, "MaxPoles": plain.max_poles}
    if name in defaults:
        setattr(obj, name, defaults[name])
