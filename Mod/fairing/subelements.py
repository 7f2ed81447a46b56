# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of edges and faces as FreeCAD writes them ("Edge7") and as numbers (7)."""

from __future__ import annotations

from typing import Iterable, Union

Pick = Union[str, int]


def edge_numbers(picks: Iterable[Pick]) -> tuple[int, ...]:
    """Numbers of the edges among picks; a bare number counts as an edge."""
    return tuple(_number(pick, "Edge") for pick in picks if isinstance(pick, int) or is_edge(pick))


def only_edges(picks: Union[Pick, Iterable[Pick]]) -> tuple[int, ...]:
    """Numbers of one pick or several, all of them edges. Raises ValueError with the first that is none."""
    picks = [picks] if isinstance(picks, (str, int)) else list(picks)
    for pick in picks:
        if not isinstance(pick, int) and not is_edge(pick):
            raise ValueError(f"{pick!r} is not an edge (Edge7)")
    return edge_numbers(picks)


def only_faces(picks: Union[Pick, Iterable[Pick]]) -> tuple[int, ...]:
    """Numbers of one pick or several, all of them faces. Raises ValueError with the first that is none."""
    picks = [picks] if isinstance(picks, (str, int)) else list(picks)
    for pick in picks:
        if not isinstance(pick, int) and not is_face(pick):
            raise ValueError(f"{pick!r} is not a face (Face3)")
    return tuple(_number(pick, "Face") for pick in picks)


def vertex_number(pick: Pick) -> int:
    """The number of one vertex. Raises ValueError where it is none."""
    if not isinstance(pick, int) and not is_vertex(pick):
        raise ValueError(f"{pick!r} is not a vertex (Vertex3)")
    return _number(pick, "Vertex")


def vertex_pair(pair: Iterable[Pick]) -> tuple[int, int]:
    """The numbers of two vertices. Raises ValueError where they are none, or not two."""
    numbers = tuple(map(vertex_number, pair))
    if len(numbers) != 2:
        raise ValueError(f"{pair!r} is no pair of vertices: a vertex of either side is needed")
    return numbers


def face_numbers(picks: Iterable[Pick]) -> tuple[int, ...]:
    """Numbers of the faces among picks."""
    return tuple(_number(pick, "Face") for pick in picks if not isinstance(pick, int) and is_face(pick))


def is_edge(name: str) -> bool:
    return _is(name, "Edge")


def is_face(name: str) -> bool:
    return _is(name, "Face")


def is_vertex(name: str) -> bool:
    return _is(name, "Vertex")


def local_name(path: str) -> str:
    """The name itself out of a path through containers: "Body.Pad.Edge7" -> "Edge7"."""
    return path.rsplit(".", 1)[-1]


def check_names(picks: Iterable[Pick]) -> None:
    """Raises ValueError with the first pick that is neither an edge nor a face."""
    for pick in picks:
        if not isinstance(pick, int) and not is_edge(pick) and not is_face(pick):
            raise ValueError(f"{pick!r} is neither an edge (Edge7) nor a face (Face3)")


def _is(name: str, kind: str) -> bool:
    return name.startswith(kind) and name[len(kind):].isdigit()


def _number(pick: Pick, kind: str) -> int:
    return pick if isinstance(pick, int) else int(pick[len(kind):])
