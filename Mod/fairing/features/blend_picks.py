# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges picked in any number, told apart into the two sides of a blend."""

from __future__ import annotations

from typing import Iterable

from .. import exchange
from .blend_sides import NO_SIDE
from .joined_shapes import JoinedShapes, Place
from .links import Link, links_of
from .placement import container_for_results


def two_sides(picks: Iterable[Link]) -> tuple[list[Link], list[Link]]:
    """The sides that picked edges make: the chain of the first pick, and all others.

    Two edges are a side each; more are grouped by which of them connect. Raises ValueError with one sentence where
    they make one chain only, or FairingError where an edge is not free.
    """
    edges = [(obj, int(name[len("Edge"):])) for obj, names in links_of(picks) for name in names]
    if len(edges) < 2:
        raise ValueError(NO_SIDE)
    if len(edges) == 2:
        return _links(edges[:1]), _links(edges[1:])
    joined = JoinedShapes((obj for obj, _ in edges), container_for_results(edges[0][0]))
    numbers = [joined.number(*edge) for edge in edges]
    chains = exchange.native_shape(joined.shape).chains(numbers)
    if len(chains) < 2:
        raise ValueError("The edges make one chain: a blend joins two or more.")
    chains.sort(key=lambda chain: min(map(numbers.index, chain)))
    first, *others = ([joined.place(number) for number in chain] for chain in chains)
    return _links(first), _links(edge for chain in others for edge in chain)


def _links(edges: Iterable[Place]) -> list[Link]:
    return links_of((obj, [f"Edge{edge}"]) for obj, edge in edges)
