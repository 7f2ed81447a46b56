# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving on a thread: others go on meanwhile, and it can be stopped."""

import json
import threading
import time

import pytest

from fairing import _fairing, exchange
from fairing.choices import SOLVED
from fairing.comparison import solve_each
from fairing.edit_request import EditRequest
from fairing.fill_all_request import FillAllRequest
from fairing.fill_request import FillRequest

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


def end_of(fill):
    return fill.report["solve"]["shape"]["end"]


def stopped(request, brep):
    """What a request gives that is asked for the best so far at once."""
    progress = _fairing.Progress()
    progress.finish()
    assert progress.finishing
    return request.solve(brep, progress)


def test_what_was_stopped_is_no_answer_to_a_later_request(sheet, edges):
    brep = exchange.data_of(sheet)
    one = FillRequest.of(edges[:1], energy="minimum-variation")
    assert end_of(stopped(one, brep)) == "stopped"
    assert end_of(one.solve(brep)) != "stopped"
    assert one.solve(brep) is one.solve(brep), "what is solved to the end is kept"
    assert stopped(one, brep) is one.solve(brep), "and better than the best so far"
    every = FillAllRequest(energy="total-curvature")
    assert end_of(stopped(every, brep).holes[0].fill) == "stopped"
    assert end_of(every.solve(brep).holes[0].fill) != "stopped"
    stopped(FillRequest.of(edges[:1], energy="total-curvature"), brep)
    solved = next(solve_each(FillRequest.of(edges[:1]), brep, ("total-curvature",)))
    assert end_of(solved.fill) != "stopped", "nor to a comparison"


def test_what_is_taken_answers_while_it_is_taken(sheet, edges):
    brep = exchange.data_of(sheet)
    request = FillRequest.of(edges[:1], energy="mean-curvature-gradient-minimum")
    best = stopped(request, brep)
    with SOLVED.taking(request, brep, best):
        assert FillRequest.of(edges[:1], energy="mean-curvature-gradient-minimum").solve(brep) is best
        assert FillRequest.of(edges[:1]).solve(brep) is not best
    assert request.solve(brep) is not best and end_of(request.solve(brep)) != "stopped"


def test_finish_takes_the_latest_look_at_what_guides_an_edit(sheet):
    brep = exchange.data_of(sheet)
    face = sheet.Faces[0]
    handle = [{"point": tuple(face.CenterOfMass), "normal": (0.5, 0.0, 1.0), "weight": 1.0, "radius": 20.0}]
    request = EditRequest(face=1, degree=5, spans=6, lambda_=1e4, gamma=1.0, guide=json.dumps(handle))
    early = stopped(request, brep)
    assert [note["text"] for note in early.report["notes"]] == [
        "Stopped after looking the guide up 1 of at most 6 times: it may not be followed to the end."]
    late = request.solve(brep)
    assert not any(note["text"].startswith("Stopped") for note in late.report["notes"])
    assert late.report["energy"] != early.report["energy"]
