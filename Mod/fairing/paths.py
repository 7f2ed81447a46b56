# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the add-on's files are."""

from __future__ import annotations

from pathlib import Path

RESOURCES = Path(__file__).resolve().parent.parent / "resources"


def icon(name: str) -> str:
    return str(RESOURCES / "icons" / name)


def form(name: str) -> str:
    return str(RESOURCES / "ui" / name)


def translations() -> str:
    return str(RESOURCES / "translations")
