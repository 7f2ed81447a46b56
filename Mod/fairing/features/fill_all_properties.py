# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of an object that fills all holes: what is asked for, and what was measured, hole by hole."""

from __future__ import annotations

import FreeCAD as App

from .. import subelements
from ..fill_all_request import FillAllRequest
from . import choice_properties

ASKED = (
    ("Base", "App::PropertyLinkGlobal", "Boundary", "The object whose holes are filled"),
    ("OuterBorders", "App::PropertyBool", "Boundary", "Fill the rims of open sheets, too"),
    ("Skipped", "App::PropertyStringList", "Boundary", "Holes left out, by one of their edges each: Edge7"),
    *choice_properties.CHOSEN,
)
MEASURED = (
    ("Verdict", "App::PropertyString", "Report", "How many holes are filled, and how well"),
    ("WithinTolerance", "App::PropertyBool", "Report", "Whether every hole is filled within the tolerances"),
    ("HoleEdges", "App::PropertyStringList", "Report", "The first edge of every hole"),
    ("HoleVerdicts", "App::PropertyStringList", "Report", "How well each hole is filled, or why it is not"),
    ("HoleLayouts", "App::PropertyStringList", "Report", "How patches span each hole, empty where there are none"),
    ("HoleGaps", "App::PropertyFloatList", "Report", "Largest distance of an edge, hole by hole, mm; -1: not filled"),
    ("HoleAngles", "App::PropertyFloatList", "Report",
     "Largest angle to a neighbour, hole by hole, degrees; -1: not filled"),
    ("FilledArea", "App::PropertyArea", "Report", "Area of the new faces"),
)


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    choice_properties.add(obj, ASKED, MEASURED, choice_properties.defaults_of(FillAllRequest()))


def write_request(obj: App.DocumentObject, request: FillAllRequest, base: App.DocumentObject, reference) -> None:
    obj.Base = base
    obj.OuterBorders = request.outer_borders
    obj.Skipped = request.skipped_names()
    choice_properties.write(obj, request, reference)


def read_request(obj: App.DocumentObject) -> FillAllRequest:
    """What an object's properties ask for. Raises ValueError with one sentence."""
    for name in obj.Skipped:
        if not subelements.is_edge(name):
            raise ValueError(f"Skipped holds '{name}': write an edge of the hole, such as Edge7")
    return FillAllRequest.of(obj.Skipped, outer_borders=obj.OuterBorders, **choice_properties.read(obj))


def write_report(obj: App.DocumentObject, filled) -> None:
    """Stores what was measured."""
    holes = filled.holes
    reports = [hole.fill.report if hole.fill else None for hole in holes]
    obj.Verdict = verdict(filled)
    obj.WithinTolerance = filled.within_tolerance
    obj.HoleEdges = [f"Edge{hole.edges[0]}" for hole in holes]
    obj.HoleVerdicts = [hole.fill.verdict if hole.fill else hole.error for hole in holes]
    obj.HoleLayouts = [report["layout"] if report else "" for report in reports]
    obj.HoleGaps = [report["largest_gap"] if report else -1.0 for report in reports]
    obj.HoleAngles = [largest_angle(report) if report else -1.0 for report in reports]
    obj.FilledArea = sum(report["fairness"]["area"] for report in reports if report)


def write_failure(obj: App.DocumentObject, sentence: str) -> None:
    """The shape and its numbers stay those of the last success; only the verdict changes."""
    obj.Verdict = sentence
    obj.WithinTolerance = False


def largest_angle(report: dict) -> float:
    """Of all edges of a hole, corners included, degrees."""
    return max(report["largest_angle"], report["largest_corner_angle"])


def verdict(filled) -> str:
    """One sentence over all holes."""
    total = len(filled.holes)
    good = sum(1 for hole in filled.holes if hole.fill and hole.fill.within_tolerance)
    failed = sum(1 for hole in filled.holes if not hole.fill)
    if good == total:
        return "Fills the hole within tolerance." if total == 1 else f"Fills all {total} holes within tolerance."
    parts = [f"{good} of {total} holes are filled within tolerance"]
    if total - good - failed:
        parts.append(f"{total - good - failed} out of tolerance")
    if failed:
        parts.append(f"{failed} not at all")
    return ", ".join(parts) + "."
