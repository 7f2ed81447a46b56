# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a fill: what is asked for, and what was measured."""

from __future__ import annotations

import FreeCAD as App

from ..fill_request import FillRequest
from . import choice_properties, guidance_properties, links
from .placement import container_of

# name, type, group, tooltip
ASKED = (
    ("Edges", "App::PropertyLinkSubGlobal", "Boundary", "Edges of the hole's border, or the face to be replaced"),
    ("Through", "App::PropertyLinkSubListGlobal", "Guidance",
     "Vertices, edges, sketches and datum points that the surface passes through"),
    *choice_properties.CHOSEN,
    *guidance_properties.GUIDES,
)
MEASURED = (
    ("Verdict", "App::PropertyString", "Report", "Whether the surface meets its neighbours, in words"),
    ("WithinTolerance", "App::PropertyBool", "Report", "Whether every edge is met within the tolerances"),
    ("LargestGap", "App::PropertyLength", "Report", "Largest distance of an edge from the surface"),
    ("LargestAngle", "App::PropertyAngle", "Report", "Largest angle to a neighbour along the edges"),
    ("LargestCornerAngle", "App::PropertyAngle", "Report", "Largest angle to a neighbour next to the corners"),
    ("LargestCurvature", "App::PropertyFloat", "Report",
     "Largest relative difference of the curvatures across the edges met in curvature, 0 to 1"),
    ("LargestSeamAngle", "App::PropertyAngle", "Report", "Largest angle between the patches along their seams"),
    ("LargestInnerGap", "App::PropertyLength", "Report", "Largest distance of what the surface passes through"),
    ("LayoutUsed", "App::PropertyString", "Report", "How patches span the hole"),
    ("Notes", "App::PropertyStringList", "Report", "What should be known of the hole and is no failure"),
    ("ReportEdges", "App::PropertyStringList", "Report", "The edges in the order of the hole's border"),
    ("EdgeGaps", "App::PropertyFloatList", "Report", "Largest distance from the surface, edge by edge, mm"),
    ("EdgeAngles", "App::PropertyFloatList", "Report", "Largest angle, edge by edge, degrees"),
    ("EdgeCornerAngles", "App::PropertyFloatList", "Report",
     "Largest angle next to its corners, edge by edge, degrees"),
    ("EdgeCurvatures", "App::PropertyFloatList", "Report",
     "Largest relative difference of the curvatures across the edge, edge by edge, 0 to 1"),
    ("Poles", "App::PropertyInteger", "Report", "Number of control points"),
    ("FilledArea", "App::PropertyArea", "Report", "Area of the new faces"),
    *guidance_properties.MEASURED,
)


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    choice_properties.add(obj, ASKED, MEASURED, choice_properties.defaults_of(FillRequest()))


def write_request(obj: App.DocumentObject, request: FillRequest, base: App.DocumentObject, reference, through) -> None:
    """Stores what is asked for; of the reference and of `through` their links, [(object, [names])]. Handles and curves
    are written by guide_objects."""
    obj.Edges = (base, request.picks())
    obj.Through = [(part, names or [""]) for part, names in through]  # "": the whole object
    choice_properties.write(obj, request, reference)


def read_request(obj: App.DocumentObject) -> FillRequest:
    """What an object's properties ask for. Raises ValueError with one sentence."""
    picks = obj.Edges[1] if obj.Edges else ()
    return FillRequest.of([pick for pick in picks if pick],
                          through=links.through_data(obj.Through, container_of(obj)), **choice_properties.read(obj))


def write_report(obj: App.DocumentObject, fill) -> None:
    """Stores what was measured."""
    write_measured(obj, fill)
    obj.LargestInnerGap = fill.report["largest_inner_gap"]
    obj.LayoutUsed = fill.report["layout"]


def write_measured(obj: App.DocumentObject, fill) -> None:
    """The part of it that any surface between edges has."""
    report = fill.report
    sides = report["sides"]
    obj.Verdict = fill.verdict
    obj.WithinTolerance = fill.within_tolerance
    obj.LargestGap = report["largest_gap"]
    obj.LargestAngle = report["largest_angle"]
    obj.LargestCornerAngle = report["largest_corner_angle"]
    obj.LargestCurvature = report["largest_curvature"]
    obj.LargestSeamAngle = report["largest_seam_angle"]
    obj.Notes = [note["text"] for note in report["notes"]]
    obj.ReportEdges = [f"Edge{side['edge']}" for side in sides]
    obj.EdgeGaps = [side["gap"]["max"] for side in sides]
    obj.EdgeAngles = [side["angle"]["max"] for side in sides]
    obj.EdgeCornerAngles = [side["corner_angle"]["max"] for side in sides]
    obj.EdgeCurvatures = [side["curvature"]["max"] for side in sides]
    obj.Poles = report["solve"]["poles"]
    obj.FilledArea = report["fairness"]["area"]
    guidance_properties.write_report(obj, report["guidance"])


def write_failure(obj: App.DocumentObject, sentence: str) -> None:
    """The shape and its numbers stay those of the last success; only the verdict changes."""
    obj.Verdict = sentence
    obj.WithinTolerance = False
