# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line of Python that does what OK of the blend panel does."""

from __future__ import annotations

from ..blend_request import BlendRequest
from ..features import blend_properties as properties
from ..features.blend_sides import NO_CURVES, named_pairs
from ..features.links import Link, links_of
from .commands import link_command, object_command


def blend_command(session) -> str:
    """Of a BlendSession: only what differs from the defaults, or from the object as it is."""
    links = [_links_command(side.links()) for side in session.sides]
    if session.obj is None:
        head, before = f"fairing.make_blend({', '.join(links)}", BlendRequest()
        known, known_pairs, known_curves, known_ends, known_cuts = [{}, {}], [], NO_CURVES, [], []
    else:
        head, before = f"fairing.change_blend({object_command(session.obj)}", _request_of(session.obj)
        old = [properties.from_side(session.obj), properties.to_side(session.obj)]
        moved = [link != _links_command(was.links()) for link, was in zip(links, old)]
        known_curves = properties.read_curves(session.obj)
        head += "".join(f", {name}={link}" for name, link, is_other in zip(("from_edges", "to_edges"), links, moved)
                        if is_other)
        known = [{} if is_other else was.named_wishes() for was, is_other in zip(old, moved)]
        known_ends, known_cuts = links_of(session.obj.Ends), links_of(session.obj.Cuts)
        known_pairs = [] if any(moved) else named_pairs(properties.read_pairs(session.obj), *old)
    changed = {}
    for name, side, was in zip(("from_continuity", "to_continuity"), session.sides, known):
        if side.named_wishes() != was:
            changed[name] = side.named_wishes()
    pairs = named_pairs(session.pairs, *session.sides)
    if pairs != known_pairs:
        changed["pairs"] = pairs
    changed.update((name, value) for name, value in session.choices().items() if value != getattr(before, name))
    head += "".join(f", {name}={_links_command(curve)}" for name, curve, was in
                    zip(("from_curve", "to_curve"), session.asked_curves, known_curves) if curve != was)
    for name, links, was in (("ends", session.asked_ends, known_ends), ("cuts", session.asked_cuts, known_cuts)):
        if links != was:
            head += f", {name}=[{', '.join(map(link_command, links))}]"
    tail = "".join(f", {name}={value!r}" for name, value in changed.items())
    return f"{head}{tail}{session.guidance_command()})"


def _request_of(obj) -> BlendRequest:
    return BlendRequest(**properties.read_choices(obj))


def _links_command(links: list[Link]) -> str:
    commands = [link_command(link) for link in links]
    return commands[0] if len(commands) == 1 else f"[{', '.join(commands)}]"
