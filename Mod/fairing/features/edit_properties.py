# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of an edited face: what is asked for, and what was measured."""

from __future__ import annotations

import FreeCAD as App

from .. import subelements
from ..choices import EDIT_ENERGIES, KEEPS, RESULTS
from ..edit_request import EditRequest
from . import choice_properties, guidance_properties

# name, type, group, tooltip
ASKED = (
    ("Face", "App::PropertyLinkSubGlobal", "Boundary", "The face that is shaped anew"),
    ("Keep", "App::PropertyEnumeration", "Boundary",
     "What stays along the face's border: G0 its place, G1 the tangent planes, too, G2 the curvatures; auto: G1, or G0 "
     "for the membrane"),
    ("Energy", "App::PropertyEnumeration", "Shape",
     "What the surface minimises: thin-plate bends as little as possible, membrane stretches as little as possible"),
    ("Degree", "App::PropertyInteger", "Shape", "Raises the degree of the face, 3 to 9; 0: its own"),
    ("Spans", "App::PropertyInteger", "Shape",
     "Splits the face into as many spans along each direction, 1 to 64: more freedom inside; 0: its own"),
    *guidance_properties.ASKED,
    *guidance_properties.GUIDES,
    ("ResultMode", "App::PropertyEnumeration", "Result",
     "patches: the new face; shell: a shell of it; base: the base with the new face in place of the old one"),
)
MEASURED = (
    ("Verdict", "App::PropertyString", "Report", "What was moved, in words"),
    ("BorderMove", "App::PropertyLength", "Report", "Largest move of the border"),
    ("BorderTurn", "App::PropertyAngle", "Report", "Largest turn of the surface's normal along the border"),
    ("LargestMove", "App::PropertyLength", "Report", "Largest move of any point"),
    ("EnergyBefore", "App::PropertyFloat", "Report", "Energy of the face as it was, with what guidance costs"),
    ("EnergyAfter", "App::PropertyFloat", "Report", "Energy of the new face"),
    ("Poles", "App::PropertyInteger", "Report", "Number of control points"),
    ("MovedPoles", "App::PropertyInteger", "Report", "Number of control points that are free to move"),
    ("Notes", "App::PropertyStringList", "Report", "What should be known of the face and is no failure"),
    *guidance_properties.MEASURED,
)
WORDS = {"Keep": KEEPS, "Energy": EDIT_ENERGIES, "ResultMode": RESULTS}


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    choice_properties.add(obj, ASKED, MEASURED, {}, WORDS)


def write_request(obj: App.DocumentObject, request: EditRequest, base: App.DocumentObject, reference) -> None:
    """Stores what is asked for; of the reference its links. Handles and curves are written by guide_objects."""
    obj.Face = (base, [f"Face{request.face}"])
    obj.Keep = request.keep or KEEPS[0]
    obj.Energy, obj.Degree, obj.Spans = request.energy, request.degree, request.spans
    guidance_properties.write(obj, request.lambda_, request.gamma, reference)
    obj.ResultMode = request.result


def read_request(obj: App.DocumentObject) -> EditRequest:
    """What an object's properties ask for. Raises ValueError with one sentence."""
    numbers = subelements.only_faces(obj.Face[1] if obj.Face else ())
    return EditRequest(face=numbers[0] if numbers else 0, energy=obj.Energy,
                       keep=None if obj.Keep == KEEPS[0] else obj.Keep, degree=obj.Degree, spans=obj.Spans,
                       result=obj.ResultMode, **guidance_properties.read(obj))


def write_report(obj: App.DocumentObject, edit) -> None:
    """Stores what was measured."""
    report = edit.report
    obj.Verdict = edit.verdict
    obj.BorderMove, obj.BorderTurn = report["border_move"], report["border_turn"]
    obj.LargestMove = report["largest_move"]
    obj.EnergyBefore, obj.EnergyAfter = report["energy_before"], report["energy"]
    obj.Poles, obj.MovedPoles = report["poles"], report["moved"]
    obj.Notes = [note["text"] for note in report["notes"]]
    guidance_properties.write_report(obj, report["after"])


def write_failure(obj: App.DocumentObject, sentence: str) -> None:
    """The shape and its numbers stay those of the last success; only the verdict changes."""
    obj.Verdict = sentence
