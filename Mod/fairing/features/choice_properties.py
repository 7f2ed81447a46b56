# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties that every kind of fill has: what may be chosen, and how they are added to an object."""

from __future__ import annotations

import FreeCAD as App

from .. import subelements
from ..choices import CONTINUITIES, DEPARTURES, ENERGIES, INNER, LAYOUTS, MATCHES, RESULTS, Choices
from . import guidance_properties
from .property_modes import READ_ONLY

# name, type, group, tooltip
CHOSEN = (
    ("Continuity", "App::PropertyEnumeration", "Boundary",
     "How the surface meets its neighbours: G2 in curvature, G1 tangentially, G0 only touching"),
    ("EdgeContinuity", "App::PropertyStringList", "Boundary", "Edges that differ, one a line: Edge7=G0"),
    ("EdgeDirections", "App::PropertyStringList", "Boundary",
     "Edges met along a direction in place of a face, one a line: Edge7=tangent 0 0 1, or Edge9=symmetry 1 0 0 for "
     "an edge in a symmetry plane with that normal"),
    ("GapTolerance", "App::PropertyLength", "Boundary",
     "Largest distance of an edge from the surface; 0: a millionth of the hole's diagonal"),
    ("AngleTolerance", "App::PropertyAngle", "Boundary", "Largest angle between the normals along an edge"),
    ("Layout", "App::PropertyEnumeration", "Shape",
     "How patches span the hole: quad one patch, star one a corner, o-grid a ring round an inner one, trimmed one "
     "trimmed surface; auto: what suits the hole"),
    ("Energy", "App::PropertyEnumeration", "Shape",
     "What the surface minimises: thin-plate bends as little as possible, membrane stretches as little as possible, "
     "mean-curvature-gradient changes its curvature as little as possible, mean-curvature-gradient-minimum takes that to "
     "the end, minimum-variation changes its curvatures as little as possible along themselves, total-curvature bends as "
     "little as possible whatever the parameters, triharmonic bends as evenly as possible"),
    ("InnerContinuity", "App::PropertyEnumeration", "Shape",
     "How patches meet each other: G1 tangentially, G2 in curvature"),
    ("Degree", "App::PropertyInteger", "Shape", "Degree of the surface, 3 to 9; 0: chosen from the edges"),
    ("MaxPoles", "App::PropertyInteger", "Shape", "Largest number of control points"),
    *guidance_properties.ASKED,
    ("ResultMode", "App::PropertyEnumeration", "Result",
     "patches: the new faces; shell: sewn to one another; base: sewn into the base, a solid where that closes it"),
)
_BY_NAME = {item[0]: item for item in CHOSEN}
WORDS = {"Continuity": CONTINUITIES, "Layout": LAYOUTS, "Energy": ENERGIES, "InnerContinuity": INNER, "ResultMode": RESULTS,
         "FromDeparture": DEPARTURES, "ToDeparture": DEPARTURES, "Match": MATCHES}


def chosen(*names: str) -> tuple:
    """Some of the properties in CHOSEN, for objects that do not have them all."""
    return tuple(_BY_NAME[name] for name in names)


def add(obj: App.DocumentObject, asked, measured, defaults: dict, words=None) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values. `words` are
    what enumerations offer, WORDS where there are no others."""
    words = words or WORDS
    for name, kind, group, tip in asked:
        is_new = name not in obj.PropertiesList
        if is_new:
            obj.addProperty(kind, name, group, tip)
        if name in words:
            _offer(obj, name, list(words[name]), None if is_new else getattr(obj, name))
        if is_new and name in defaults:
            setattr(obj, name, defaults[name])
    for name, kind, group, tip in measured:
        if name not in obj.PropertiesList:
            obj.addProperty(kind, name, group, tip, READ_ONLY)


def defaults_of(plain: Choices) -> dict:
    """Every other property starts as FreeCAD makes it: 0, empty, the first choice."""
    return {"Continuity": plain.continuity, "Layout": plain.layout, "Energy": plain.energy,
            "InnerContinuity": plain.inner_continuity,
            "AngleTolerance": plain.angle_tolerance, "MaxPoles": plain.max_poles}


def write(obj: App.DocumentObject, chosen: Choices, reference) -> None:
    """Stores what is chosen; of the reference its links, [(object, [names])]."""
    obj.Continuity = chosen.continuity
    obj.EdgeContinuity = [f"Edge{edge}={word}" for edge, word in chosen.edge_continuity]
    obj.EdgeDirections = [f"Edge{edge}={word} {' '.join(map(repr, direction))}"
                          for word, directions in (("tangent", chosen.tangents), ("symmetry", chosen.symmetry))
                          for edge, direction in directions]
    obj.GapTolerance = chosen.gap_tolerance or 0.0
    obj.AngleTolerance = chosen.angle_tolerance
    obj.Layout = chosen.layout
    obj.Energy = chosen.energy
    obj.InnerContinuity = chosen.inner_continuity
    obj.Degree = chosen.degree
    obj.MaxPoles = chosen.max_poles
    guidance_properties.write(obj, chosen.lambda_, chosen.gamma, reference)
    obj.ResultMode = chosen.result


def read(obj: App.DocumentObject) -> dict:
    """What an object's properties choose, as arguments of a request's of(). Raises ValueError with one sentence."""
    directions = {"tangent": {}, "symmetry": {}}
    for edge, wish in wishes(obj, "EdgeDirections", "Edge7=tangent 0 0 1"):
        word, *numbers = wish.replace(",", " ").split() or [""]
        if word not in directions or len(numbers) != 3 or not all(map(_is_number, numbers)):
            raise ValueError(f"EdgeDirections holds '{edge}={wish}': write such as Edge7=tangent 0 0 1")
        directions[word][edge] = tuple(map(float, numbers))
    return dict(
        edge_continuity=dict(wishes(obj, "EdgeContinuity", "Edge7=G0")), tangents=directions["tangent"],
        symmetry=directions["symmetry"], continuity=obj.Continuity, layout=obj.Layout, energy=obj.Energy,
        inner_continuity=obj.InnerContinuity,
        gap_tolerance=obj.GapTolerance.Value or None, angle_tolerance=obj.AngleTolerance.Value, degree=obj.Degree,
        max_poles=obj.MaxPoles, result=obj.ResultMode, **guidance_properties.read(obj))


def wishes(obj: App.DocumentObject, name: str, sample: str, takes_objects: bool = False):
    """The lines "Edge7=..." of a property, as pairs; "Pipe.Edge7=..." where objects may stand in front. Raises
    ValueError with a line that is none."""
    for line in getattr(obj, name):
        edge, _, wish = (part.strip() for part in line.partition("="))
        if not subelements.is_edge(subelements.local_name(edge) if takes_objects else edge):
            raise ValueError(f"{name} holds '{line}': write an edge and its wish, such as {sample}")
        yield edge, wish


def _offer(obj: App.DocumentObject, name: str, words: list[str], kept) -> None:
    """Today's words to choose from, also in objects that were made when there were fewer."""
    if kept is None or obj.getEnumerationsOfProperty(name) != words:
        setattr(obj, name, words)
        if kept is not None:
            setattr(obj, name, kept)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
