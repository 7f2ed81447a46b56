# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a blend: what is asked for, and what was measured."""

from __future__ import annotations

import FreeCAD as App

from ..blend_request import BlendRequest
from . import choice_properties, fill_properties, guidance_properties
from .blend_sides import BlendSides, Curves, Side, named_pairs, pairs_of
from .links import links_of
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
    ("FromReachEnd", "App::PropertyFloat", "Shape",
     "Reach at the end of an open side it starts from, linear along the side; 0: as at the start"),
    ("ToReachEnd", "App::PropertyFloat", "Shape",
     "Reach at the end of an open side it ends at, linear along the side; 0: as at the start"),
    ("FromDeparture", "App::PropertyEnumeration", "Shape",
     "Direction in which it leaves the edges it starts from: free in the tangent plane, perpendicular to the edge, or "
     "along the face's iso-curves"),
    ("ToDeparture", "App::PropertyEnumeration", "Shape",
     "Direction in which it leaves the edges it ends at: free in the tangent plane, perpendicular to the edge, or "
     "along the face's iso-curves"),
    ("FromFlip", "App::PropertyBool", "Shape", "Leave the side it starts from the other way, over its face"),
    ("ToFlip", "App::PropertyBool", "Shape", "Leave the side it ends at the other way, over its face"),
    ("FromSetback", "App::PropertyLength", "Shape",
     "How far inside the faces it starts, trimmed back to there in the sewn result"),
    ("ToSetback", "App::PropertyLength", "Shape",
     "How far inside the faces it ends, trimmed back to there in the sewn result"),
    ("FromCurve", "App::PropertyLinkSubListGlobal", "Shape",
     "Edges or sketches that make a curve on the faces it starts from: it starts there, the faces trimmed back to it"),
    ("ToCurve", "App::PropertyLinkSubListGlobal", "Shape",
     "Edges or sketches that make a curve on the faces it ends at: it ends there, the faces trimmed back to it"),
    ("Match", "App::PropertyEnumeration", "Shape",
     "Which points of the sides belong together: equal shares of their lengths, or corner to corner; auto: corners "
     "where both sides have as many"),
    ("Alignment", "App::PropertyFloat", "Shape",
     "Turns closed sides against each other from where the blend is least twisted, by a share of the length, -0.5 to "
     "0.5"),
    ("Pairs", "App::PropertyStringList", "Shape",
     "Vertices of both sides that belong together, one pair a line: Vertex3=Vertex7"),
    ("Ends", "App::PropertyLinkSubListGlobal", "Boundary",
     "Edges, and faces by their borders or as walls, that the ends of a blend between open sides follow"),
    ("Ring", "App::PropertyBool", "Boundary",
     "Open chains of the side it ends at are sides of their own: they come to a vertex with that it starts from"),
    ("Cuts", "App::PropertyLinkSubListGlobal", "Shape",
     "Edges from rim to rim, of any objects, that show where a junction is cut"),
    ("GapTolerance", "App::PropertyLength", "Boundary",
     "Largest distance of an edge from the surface; 0: a millionth of the diagonal of both chains"),
    *choice_properties.chosen("Continuity", "AngleTolerance", "Energy", "InnerContinuity", "Degree", "MaxPoles"),
    *guidance_properties.ASKED,
    *guidance_properties.GUIDES,
    ("ResultMode", "App::PropertyEnumeration", "Result",
     "patches: the new face; shell: a shell of it; base: sewn to what it joins, a solid where that closes it"),
)
MEASURED = tuple(item for item in fill_properties.MEASURED if item[0] not in ("LargestInnerGap", "LayoutUsed"))

# members of BlendRequest and the properties that hold them as they are; 0 stands for None
NAMES = {"continuity": "Continuity", "from_reach": "FromReach", "to_reach": "ToReach",
         "from_reach_end": "FromReachEnd", "to_reach_end": "ToReachEnd", "from_departure": "FromDeparture",
         "to_departure": "ToDeparture", "from_flip": "FromFlip", "to_flip": "ToFlip", "from_setback": "FromSetback",
         "to_setback": "ToSetback", "match": "Match", "ring": "Ring", "alignment": "Alignment", "energy": "Energy",
         "inner_continuity": "InnerContinuity", "lambda_": "Lambda", "gamma": "Gamma",
         "gap_tolerance": "GapTolerance", "angle_tolerance": "AngleTolerance", "degree": "Degree",
         "max_poles": "MaxPoles", "result": "ResultMode"}
NONE_AT_ZERO = ("gap_tolerance", "from_reach_end", "to_reach_end")

write_failure = fill_properties.write_failure


def add_properties(obj: App.DocumentObject) -> None:
    """Gives an object every property it does not have yet, with its default; existing ones keep their values."""
    plain = BlendRequest()
    choice_properties.add(obj, ASKED, MEASURED,
                          {name: getattr(plain, member) or 0 for member, name in NAMES.items()})


def write_request(obj: App.DocumentObject, request: BlendRequest, sides: BlendSides, reference) -> None:
    """Stores what is asked for; of the reference its links. Handles and curves are written by guide_objects."""
    guidance_properties.write(obj, request.lambda_, request.gamma, reference)
    obj.FromEdges, obj.ToEdges = sides.from_side.links(), sides.to_side.links()
    obj.FromContinuity, obj.ToContinuity = sides.from_side.lines(), sides.to_side.lines()
    obj.Pairs = ["=".join(pair) for pair in named_pairs(sides.pairs, sides.from_side, sides.to_side)]
    for name, curve in zip(("FromCurve", "ToCurve"), sides.curves):
        setattr(obj, name, [(part, names or [""]) for part, names in curve])  # "": the whole object
    obj.Ends, obj.Cuts = sides.ends, sides.cuts
    for member, name in NAMES.items():
        setattr(obj, name, getattr(request, member) or 0)


def read_pairs(obj: App.DocumentObject) -> tuple:
    """The vertices that belong together. Raises ValueError with one sentence."""
    return pairs_of((line.split("=") for line in obj.Pairs), from_side(obj), to_side(obj))


def read_curves(obj: App.DocumentObject) -> Curves:
    """What either side is set back to."""
    return links_of(obj.FromCurve), links_of(obj.ToCurve)


def from_side(obj: App.DocumentObject) -> Side:
    """Raises ValueError with one sentence, as to_side() does."""
    return Side.of(obj.FromEdges, _wishes(obj, "FromContinuity"))


def to_side(obj: App.DocumentObject) -> Side:
    return Side.of(obj.ToEdges, _wishes(obj, "ToContinuity"))


def read_sides(obj: App.DocumentObject) -> BlendSides:
    """What an object's blend joins, in the coordinates it lives in. Raises ValueError with one sentence."""
    return BlendSides(from_side(obj), to_side(obj), container_of(obj), read_pairs(obj), read_curves(obj), obj.Ends,
                      obj.Cuts)


def read_choices(obj: App.DocumentObject) -> dict:
    """The choices that belong to no single edge, by the names of BlendRequest."""
    values = {member: getattr(obj, name) for member, name in NAMES.items()}
    plain = {member: getattr(value, "Value", value) for member, value in values.items()}
    return {member: None if member in NONE_AT_ZERO and value == 0 else value for member, value in plain.items()}


def read_request(obj: App.DocumentObject, sides: BlendSides) -> BlendRequest:
    """What an object's properties ask of its sides. Raises ValueError with one sentence."""
    return sides.request(**{**read_choices(obj), **guidance_properties.read(obj)})


def write_report(obj: App.DocumentObject, blend) -> None:
    """Stores what was measured; edges by their names in the objects they belong to."""
    fill_properties.write_measured(obj, blend)
    sides = read_sides(obj)
    obj.ReportEdges = [sides.name_of(side) for side in blend.report["sides"]]


def _wishes(obj: App.DocumentObject, name: str) -> dict[str, str]:
    return dict(choice_properties.wishes(obj, name, "Edge7=G0", takes_objects=True))
