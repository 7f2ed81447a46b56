# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges picked in any number, told apart into the two sides of a blend."""

from __future__ import annotations

from typing import Iterable

from .. import exchange
from .blend_sides import NO_SIDE, BlendSides, Side
from .links import Link, links_of
from .placement import container_for_results


def two_sides(picks: Iterable[Link]) -> tuple[Link, Link]:
    """The sides that picked edges make, that of the first pick in front.

    Two edges are a side each; more are grouped by which of them connect. Raises ValueError with one sentence where
    they make other than two chains, or FairingError where an edge is not free.
    """
    links = links_of(picks)
    edges = [(obj, name) for obj, names in links for name in names]
    if len(edges) < 2:
        raise ValueError(NO_SIDE)
    if len(edges) == 2:
        return tuple((obj, [name]) for obj, name in edges)
    if len(links) > 2:
        raise ValueError(f"The edges belong to {len(links)} objects: a blend joins one or two.")
    sides = BlendSides(Side.of(links[0]), Side.of(links[-1]), container_for_results(links[0][0]))
    request = sides.request()
    picked = list(dict.fromkeys(request.from_edges + request.to_edges))
    chains = exchange.native_shape(sides.shape).chains(picked)
    if len(chains) != 2:
        raise ValueError(f"The edges make {len(chains)} separate chains: a blend joins two."
                         if len(chains) > 2 else "The edges make one chain: a blend joins two.")
    chains.sort(key=lambda chain: picked[0] not in chain)
    return tuple(_link_of([sides.place(edge) for edge in chain]) for chain in chains)


def _link_of(places) -> Link:
    if len({obj.Name for obj, _ in places}) > 1:
        raise ValueError("The edges of one side belong to two objects: join these objects first.")
    return places[0][0], [name for _, name in places]
