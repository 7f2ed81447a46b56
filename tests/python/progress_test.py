# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving on a thread: others go on meanwhile, and it can be stopped."""

import threading
import time

import pytest

from fairing import _fairing

OUT_OF_REACH = 1e-9  # degrees; refining towards it takes seconds


def start(shape, edges, progress):
    """A thread that solves for long; its outcome lands in the list returned with it."""
    outcome = []

    def work():
        try:
            outcome.append(shape.fill(edges[:1], angle=OUT_OF_REACH, progress=progress))
        except _fairing.FairingError as error:
            outcome.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    return thread, outcome


def test_other_threads_run_while_it_solves(shape, edges):
    progress = _fairing.Progress()
    thread, _ = start(shape, edges, progress)
    turns = []
    while thread.is_alive() and len(turns) < 200:
        began = time.monotonic()
        time.sleep(0.001)
        turns.append(time.monotonic() - began)
    progress.abort()
    thread.join()
    # A solve that held the interpreter would leave one or two turns. One in ten may meet a busy machine.
    assert len(turns) > 10 and sorted(turns)[-len(turns) // 10] < 0.1, turns


def test_abort_stops_it_soon(shape, edges):
    progress = _fairing.Progress()
    thread, outcome = start(shape, edges, progress)
    while progress.fraction < 0.2 and thread.is_alive():
        time.sleep(0.01)
    began = time.monotonic()
    progress.abort()
    thread.join()
    assert time.monotonic() - began < 5.0, "one linear solve at most"
    assert progress.aborted and outcome[0].code == "Cancelled"


def test_abort_before_it_starts(shape, edges):
    progress = _fairing.Progress()
    progress.abort()
    with pytest.raises(_fairing.FairingError) as caught:
        shape.fill(edges[:1], progress=progress)
    assert caught.value.code == "Cancelled"


def test_progress_ends_at_one(shape, edges):
    progress = _fairing.Progress()
    assert progress.fraction == 0.0 and not progress.aborted
    shape.fill(edges[:1], progress=progress)
    assert progress.fraction == pytest.approx(1.0)


def test_finish_takes_the_best_so_far(shape, edges):
    progress = _fairing.Progress()
    progress.finish()
    fill = shape.fill(edges[:1], energy="minimum-variation", progress=progress)
    assert fill.report["solve"]["shape"]["end"] == "stopped"
    assert fill.report["within_tolerance"]
    assert any(note["text"].startswith("Stopped after 0 steps") for note in fill.report["notes"])
