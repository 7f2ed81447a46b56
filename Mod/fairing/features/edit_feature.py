# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric edit: a Part::FeaturePython that shapes a face of another object anew under guidance."""

from __future__ import annotations

import dataclasses
from typing import Optional

import FreeCAD as App

from .. import exchange, subelements
from ..edit_request import EditRequest
from . import edit_properties as properties, guide_objects, links
from .guides import guides_of, native_text
from .placement import container_for_results, container_of, shape_in
from .solved_feature import SolvedFeature

NO_FACE = "No face is picked: pick the face to be shaped anew."


class EditFeature(SolvedFeature):
    """Proxy of an edit."""

    TYPE = "Edit"
    properties = properties

    def solve(self, obj: App.DocumentObject):
        return solve(properties.read_request(obj), obj.Face[0] if obj.Face else None, container_of(obj))

    def is_good(self, solved) -> bool:
        return True  # the border stays by construction


def make_edit(base: App.DocumentObject, face: subelements.Pick, *, name: str = "Edit", reference=None, guides=(),
              **options) -> App.DocumentObject:
    """Makes an object beside the base in the document that shapes one of its faces anew, computed.

    face       "Face3" or 3
    reference  an object, (object, ["Face1", ...]), or a list of these: faces and meshes that guide by the weights
               lambda_ and gamma; without any the face itself does
    guides     handles and feature curves, see make_fill()
    options    lambda_, gamma, energy, keep, degree, spans: see fairing.edit(); result: "patches" the new face beside
               the base, "base" the base with the new face in place of the old one
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    container, guides = container_for_results(base), guides_of(guides)
    request = EditRequest(face=face_number(face), reference=links.reference_data(reference, container),
                          guide=native_text(guides, container), **options)
    solve(request, base, container)
    obj = base.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    EditFeature(obj)
    properties.write_request(obj, request, base, links.several(reference))
    guide_objects.write(obj, guides)
    if App.GuiUp:
        from ..views.edit_view import EditView

        EditView(obj.ViewObject)
    obj.Document.recompute([obj])
    return obj


def change_edit(obj: App.DocumentObject, face: Optional[subelements.Pick] = None, *, base=None,
                **changes) -> App.DocumentObject:
    """Changes some choices of an edit (those of make_edit) and computes it again; the others stay as they are. Of guides
    those that have the "name" of one of its guides change it.

    Raises FairingError with one sentence, and then the object is as it was.
    """
    container, base = container_of(obj), base or (obj.Face[0] if obj.Face else None)
    reference = links.several(changes.pop("reference", obj.Reference))
    guides = guides_of(changes.pop("guides", guide_objects.read(obj)))
    request = dataclasses.replace(properties.read_request(obj), reference=links.reference_data(reference, container),
                                  guide=native_text(guides, container), **changes)
    if face is not None:
        request = dataclasses.replace(request, face=face_number(face))
    solve(request, base, container)
    properties.write_request(obj, request, base, reference)
    guide_objects.write(obj, guides)
    obj.Document.recompute([obj])
    return obj


def face_number(face: subelements.Pick) -> int:
    """Raises ValueError where it is no face."""
    return face if isinstance(face, int) else subelements.only_faces(face)[0]


def solve(request: EditRequest, base: App.DocumentObject, container):
    """The native Edit of a request in a container's coordinates. Raises ValueError, FairingError, NativeModuleError."""
    if base is None or not request.face:
        raise ValueError(NO_FACE)
    return request.solve(exchange.data_of(shape_in(container, base)))
