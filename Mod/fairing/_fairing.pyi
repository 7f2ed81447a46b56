# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing's native module: holes of shapes filled and edges joined with B-spline faces. Lengths in mm, angles in degrees."""

from typing import Any, Collection, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

Guide = Union[Sequence[Mapping[str, Any]], Mapping[str, Any]]  # handles; or handles, curves and a field

__version__: str
occt_version: str

class FairingError(ValueError):
    code: str
    edge: int
    face: int
    value: float
    where: Optional[tuple[float, float, float]]

def mesh_faces(points: NDArray[np.float64], triangles: NDArray[np.int32]) -> bytes: ...
def guide_curve(
    edges: bytes, faces: Optional[bytes] = None, normal: Optional[Sequence[float]] = None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

class Progress:
    def __init__(self) -> None: ...
    def abort(self) -> None: ...
    def finish(self) -> None: ...
    @property
    def finishing(self) -> bool: ...
    @property
    def aborted(self) -> bool: ...
    @property
    def fraction(self) -> float: ...

class CurvaturePicture:
    def mesh(self) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int32]]: ...
    def values(self) -> NDArray[np.float64]: ...
    def range(self, quantity: str) -> tuple[float, float]: ...
    def at(self, triangle: int, a: float, b: float) -> dict[str, Any]: ...

class Fill:
    def brep(self) -> bytes: ...
    def curvature_picture(self, divisions: int = 32) -> CurvaturePicture: ...
    def mesh(
        self, divisions: int = 32
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int32]]: ...
    def guiding(self, lambda_: float, gamma: float, guide: Optional[Guide] = None) -> Fill: ...
    @property
    def guides_quickly(self) -> bool: ...
    def guide_arrows(
        self, count: int = 12
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
    def control_net(self) -> list[tuple[int, int, NDArray[np.float64]]]: ...
    @property
    def composition(self) -> str: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def table(self) -> str: ...
    @property
    def verdict(self) -> str: ...
    @property
    def within_tolerance(self) -> bool: ...

class Blend(Fill):
    def reaching(
        self,
        from_reach: float,
        to_reach: float,
        from_reach_end: Optional[float] = None,
        to_reach_end: Optional[float] = None,
    ) -> Blend: ...
    def guiding(self, lambda_: float, gamma: float, guide: Optional[Guide] = None) -> Blend: ...
    @property
    def guides_quickly(self) -> bool: ...
    def guide_arrows(
        self, count: int = 12
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
    def control_net(self) -> list[tuple[int, int, NDArray[np.float64]]]: ...
    @property
    def arms(self) -> list[tuple[tuple[float, float, float], tuple[float, float, float]]]: ...

class Edit:
    def brep(self) -> bytes: ...
    def curvature_picture(self, divisions: int = 32) -> CurvaturePicture: ...
    def mesh(
        self, divisions: int = 32
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int32]]: ...
    def guiding(self, lambda_: float, gamma: float, guide: Optional[Guide] = None) -> Edit: ...
    @property
    def guides_quickly(self) -> bool: ...
    def guide_arrows(
        self, count: int = 12
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
    def control_net(self) -> list[tuple[int, int, NDArray[np.float64]]]: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def table(self) -> str: ...
    @property
    def verdict(self) -> str: ...

class HoleFill:
    @property
    def edges(self) -> list[int]: ...
    @property
    def fill(self) -> Optional[Fill]: ...
    @property
    def error(self) -> str: ...

class FillAll:
    def brep(self) -> bytes: ...
    @property
    def holes(self) -> list[HoleFill]: ...
    @property
    def table(self) -> str: ...
    @property
    def within_tolerance(self) -> bool: ...

class Shape:
    def __init__(self, data: bytes) -> None: ...
    @property
    def edge_count(self) -> int: ...
    @property
    def face_count(self) -> int: ...
    def curvature_picture(self, faces: Sequence[int] = [], divisions: int = 64) -> CurvaturePicture: ...
    def holes(self, outer_borders: bool = False) -> list[list[int]]: ...
    def find_loop(self, edges: Sequence[int] = [], faces: Sequence[int] = []) -> list[int]: ...
    def boundary(
        self,
        edges: Sequence[int] = [],
        faces: Sequence[int] = [],
        continuity: str = "G1",
        edge_continuity: Mapping[int, str] = {},
        tangents: Mapping[int, Sequence[float]] = {},
        symmetry: Mapping[int, Sequence[float]] = {},
    ) -> list[dict[str, Any]]: ...
    def fill(
        self,
        edges: Sequence[int] = [],
        faces: Sequence[int] = [],
        continuity: str = "G1",
        edge_continuity: Mapping[int, str] = {},
        tangents: Mapping[int, Sequence[float]] = {},
        symmetry: Mapping[int, Sequence[float]] = {},
        through: Sequence[Union[bytes, Sequence[float]]] = [],
        layout: str = "auto",
        energy: str = "mean-curvature-gradient",
        inner_continuity: str = "G1",
        lambda_: float = 0.0,
        gamma: float = 0.0,
        reference: Optional[bytes] = None,
        guide: Guide = [],
        tolerance: Optional[float] = None,
        angle: float = 0.02,
        degree: int = 0,
        max_poles: int = 2500,
        result: str = "patches",
        progress: Optional[Progress] = None,
    ) -> Fill: ...
    def fill_all(
        self,
        outer_borders: bool = False,
        skipped: Collection[int] = set(),
        continuity: str = "G1",
        edge_continuity: Mapping[int, str] = {},
        tangents: Mapping[int, Sequence[float]] = {},
        symmetry: Mapping[int, Sequence[float]] = {},
        layout: str = "auto",
        energy: str = "mean-curvature-gradient",
        inner_continuity: str = "G1",
        lambda_: float = 0.0,
        gamma: float = 0.0,
        reference: Optional[bytes] = None,
        guide: Guide = [],
        tolerance: Optional[float] = None,
        angle: float = 0.02,
        degree: int = 0,
        max_poles: int = 2500,
        result: str = "patches",
        progress: Optional[Progress] = None,
    ) -> FillAll: ...
    def chains(self, edges: Sequence[int]) -> list[list[int]]: ...
    def whole_chain(
        self,
        edges: Sequence[int],
        others: Sequence[int] = [],
        ends: Sequence[int] = [],
        end_faces: Sequence[int] = [],
    ) -> tuple[list[int], bool]: ...
    def blend(
        self,
        from_edges: Sequence[int],
        to_edges: Sequence[int],
        continuity: str = "G1",
        edge_continuity: Optional[Mapping[int, str]] = None,
        from_reach: float = 1.0,
        to_reach: float = 1.0,
        from_reach_end: Optional[float] = None,
        to_reach_end: Optional[float] = None,
        from_departure: str = "free",
        to_departure: str = "free",
        from_flip: bool = False,
        to_flip: bool = False,
        from_setback: float = 0.0,
        to_setback: float = 0.0,
        from_curve: Sequence[int] = [],
        to_curve: Sequence[int] = [],
        match: str = "auto",
        alignment: float = 0.0,
        pairs: Sequence[tuple[int, int]] = [],
        ends: Sequence[int] = [],
        end_faces: Sequence[int] = [],
        ring: bool = False,
        cuts: Sequence[int] = [],
        energy: str = "mean-curvature-gradient",
        inner_continuity: str = "G1",
        lambda_: float = 0.0,
        gamma: float = 0.0,
        reference: Optional[bytes] = None,
        guide: Guide = [],
        tolerance: Optional[float] = None,
        angle: float = 0.02,
        degree: int = 0,
        max_poles: int = 2500,
        result: str = "patches",
        progress: Optional[Progress] = None,
    ) -> Blend: ...
    def edit(
        self,
        face: int,
        energy: str = "thin-plate",
        lambda_: float = 0.0,
        gamma: float = 0.0,
        reference: Optional[bytes] = None,
        guide: Guide = [],
        keep: Optional[str] = None,
        degree: int = 0,
        spans: int = 0,
        result: str = "patches",
        progress: Optional[Progress] = None,
    ) -> Edit: ...
    def measure(
        self,
        patches: Shape,
        edges: Sequence[int] = [],
        faces: Sequence[int] = [],
        continuity: str = "G1",
        edge_continuity: Mapping[int, str] = {},
        tolerance: Optional[float] = None,
        angle: float = 0.02,
    ) -> dict[str, Any]: ...
