# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a blend: what is asked for, and what was measured."""

from __future__ import annotations

import FreeCAD as App

from ..blend_request import BlendRequest
from . import choice_properties, fill_properties
from .blend_sides import BlendSides, Side
from .placement import container_of

# name, type, group, tooltip
ASKED = (
    ("FromEdges", "App::PropertyLinkSubListGlobal", "Boundary",
     "Edges the blend starts from: one of a smooth chain is enough"),
    ("ToEdges", "App::PropertyLinkSubListGlobal", "Boundary",
     "Edges the blend ends at, of any objects: one of a smooth chain is enough; several closed chains make a junction"),
    ("FromContinuity", "App::PropertyStringList", "Boundary",
     "Edges of the side it starts from that differ, one a line: Edge7=G0"),
    ("ToContinuity", "App::PropertyStringList", "Boundary",
     "Edges of the side it ends at that differ, one a line: Edge7=G0, or Pipe.Edge7=G0 where there are several "
     "objects"),
    ("FromReach", "App::PropertyFloat", "Shape",
     "How far the blend goes on before it turns away from the side it starts from; 1: what the energy likes best"),
    ("ToReach", "App::PropertyFloat", "Shape",
     "How far the blend goes on before it turns away from the side it ends at; 1: what the energy likes best"),
    ("GapTolerance", "App::PropertyLength", "Boundary",
     "Largest distance of an edge from the surface; 0: a millionth of the diagonal of both chains"),
    *choice_properties.chosen("Continuity", "AngleTolerance", "Energy", "Degree", "MaxPoles"),
    ("ResultMode", "App::PropertyEnumeration", "Result",
     "patches: the new face; shell: a shell of it; base: sewn to what it joins, a solid where that closes it"),
)
MEASURED = tuple(item for item in fill_properties.MEASURED if item[0] not in ("LargestInnerGap", "LayoutUsed"))

write_failure = fill_properties.write_failure


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    plain = BlendRequest()
    defaults = {"Continuity": plain.continuity, "Energy": plain.energy, "AngleTolerance": plain.angle_tolerance,
                "MaxPoles": plain.max_poles, "FromReach": plain.from_reach, "ToReach": plain.to_reach}
    choice_properties.add(obj, ASKED, MEASURED, defaults)


def write_request(obj: App.DocumentObject, request: BlendRequest, sides: BlendSides) -> None:
    """Stores what is asked for."""
    obj.FromEdges, obj.ToEdges = sides.from_side.links(), sides.to_side.links()
    obj.FromContinuity, obj.ToContinuity = sides.from_side.lines(), sides.to_side.lines()
    obj.Continuity = request.continuity
    obj.GapTolerance = request.gap_tolerance or 0.0
    obj.AngleTolerance = request.angle_tolerance
    obj.FromReach, obj.ToReach = request.from_reach, request.to_reach
    obj.Energy = request.energy
    obj.Degree = request.degree
    obj.MaxPoles = request.max_poles
    obj.ResultMode = request.result


def from_side(obj: App.DocumentObject) -> Side:
    """Raises ValueError with one sentence, as to_side() does."""
    return Side.of(obj.FromEdges, _wishes(obj, "FromContinuity"))


def to_side(obj: App.DocumentObject) -> Side:
    return Side.of(obj.ToEdges, _wishes(obj, "ToContinuity"))


def read_sides(obj: App.DocumentObject) -> BlendSides:
    """What an object's blend joins, in the coordinates it lives in. Raises ValueError with one sentence."""
    return BlendSides(from_side(obj), to_side(obj), container_of(obj))


def read_choices(obj: App.DocumentObject) -> dict:
    """The choices that belong to no single edge, by the names of BlendRequest."""
    return dict(continuity=obj.Continuity, from_reach=obj.FromReach, to_reach=obj.ToReach, energy=obj.Energy,
                gap_tolerance=obj.GapTolerance.Value or None, angle_tolerance=obj.AngleTolerance.Value,
                degree=obj.Degree, max_poles=obj.MaxPoles, result=obj.ResultMode)


def write_report(obj: App.DocumentObject, blend) -> None:
    """Stores what was measured; edges by their names in the objects they belong to."""
    fill_properties.write_measured(obj, blend)
    sides = read_sides(obj)
    obj.ReportEdges = [sides.joined.name(side["edge"]) for side in blend.report["sides"]]


def _wishes(obj: App.DocumentObject, name: str) -> dict[str, str]:
    return dict(choice_properties.wishes(obj, name, "Edge7=G0", takes_objects=True))
