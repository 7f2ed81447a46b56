# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of everything that is guided: the reference, handles and curves, their weights, and how well they are
followed."""

from __future__ import annotations

from typing import Iterable, Optional

import FreeCAD as App

from . import guide_objects, guides, links
from .placement import container_of

# name, type, group, tooltip
ASKED = (
    ("Reference", "App::PropertyLinkSubListGlobal", "Guidance",
     "Faces and meshes whose normals and points guide the surface"),
    ("Lambda", "App::PropertyFloat", "Guidance", "Weight of the guiding normals, 0: none"),
    ("Gamma", "App::PropertyFloat", "Guidance", "Weight of the reference's points, 0: none"),
)
GUIDES = (("Guides", "App::PropertyLinkListGlobal", "Guidance", "Normal handles and feature curves that guide the "
           "surface"),)
MEASURED = (
    ("GuideRmsAngle", "App::PropertyAngle", "Report", "Angle to the guiding normals, root of the mean square"),
    ("GuideLargestAngle", "App::PropertyAngle", "Report", "Largest angle to the guiding normals"),
    ("GuideRmsDistance", "App::PropertyLength", "Report", "Distance from the reference, root of the mean square"),
    ("GuideCovered", "App::PropertyFloat", "Report", "Share of the surface that its reference covers, 0 to 1"),
)


def write(obj: App.DocumentObject, lambda_: float, gamma: float, reference: Iterable[links.Link]) -> None:
    """Stores the weights and the links to what guides; handles and curves are written by guide_objects."""
    obj.Lambda, obj.Gamma = lambda_, gamma
    obj.Reference = [(part, names or [""]) for part, names in reference]  # "": the whole object


def read(obj: App.DocumentObject) -> dict:
    """What guides an object, by the names of Choices. Raises ValueError or FairingError with one sentence."""
    container = container_of(obj)
    return dict(lambda_=obj.Lambda, gamma=obj.Gamma, reference=links.reference_data(obj.Reference, container),
                guide=guides.native_text(guide_objects.read(obj), container))


def write_report(obj: App.DocumentObject, guidance: Optional[dict]) -> None:
    """Stores how well an object follows, as a report tells it; None: nothing guides."""
    measured = guidance or {"rms_angle": 0.0, "largest_angle": 0.0, "rms_distance": 0.0, "covered": 0.0}
    obj.GuideRmsAngle = measured["rms_angle"]
    obj.GuideLargestAngle = measured["largest_angle"]
    obj.GuideRmsDistance = measured["rms_distance"]
    obj.GuideCovered = measured["covered"]
