# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving on a thread of its own while the window stays alive."""

from __future__ import annotations

import threading
from typing import Any, Callable, Optional

from PySide import QtCore

POLL_INTERVAL = 15  # ms
LONGEST_STOP = 0.1  # s closing waits for a job that was told to stop; then it ends by itself, unheard

Job = Callable[[Any], Any]  # takes a native Progress; works on plain data only: no document, no widget, no scene


class BackgroundSolver(QtCore.QObject):
    """Runs one job at a time; the latest request wins, and an older one that still runs is told to stop.

    on_done(value, error) is called in the window's thread, for the latest job only; on_progress(fraction) while it
    runs.
    """

    def __init__(self, make_progress: Callable[[], Any], on_done, on_progress, parent=None):
        super().__init__(parent)
        self._make_progress, self._on_done, self._on_progress = make_progress, on_done, on_progress
        self._running: Optional[_Run] = None
        self._next: Optional[Job] = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_INTERVAL)
        self._timer.timeout.connect(self._poll)

    @property
    def is_busy(self) -> bool:
        return self._running is not None and not (self._running.is_stale and self._next is None)

    def request(self, job: Job) -> None:
        """Runs a job as soon as possible, instead of any other."""
        self._next = job
        if self._running:
            self._running.stop()
        else:
            self._start()

    def cancel(self) -> None:
        """Drops what runs or waits; on_done is not called for it."""
        self._next = None
        if self._running:
            self._running.stop()

    def take_best(self) -> bool:
        """Asks the job that runs for the best so far, once; on_done is called with it. Whether there was one to ask."""
        if not self.is_busy or self._running.is_stale or self._running.is_finishing:
            return False
        self._running.take_best()
        return True

    def finish(self) -> None:
        """Cancels for good and waits a little for the thread to end."""
        self.cancel()
        self._timer.stop()
        if self._running:
            self._running.thread.join(LONGEST_STOP)
            self._running = None

    def _start(self) -> None:
        job, self._next = self._next, None
        self._running = _Run(job, self._make_progress())
        self._timer.start()

    def _poll(self) -> None:
        run = self._running
        if run.thread.is_alive():
            if not run.is_stale:
                self._on_progress(run.progress.fraction)
            return
        self._running = None
        if self._next:
            self._start()
            return
        self._timer.stop()
        if not run.is_stale:
            self._on_done(run.value, run.error)


class _Run:
    """One job on its thread."""

    def __init__(self, job: Job, progress):
        self.progress, self.is_stale, self.is_finishing = progress, False, False
        self.value = self.error = None
        self.thread = threading.Thread(target=self._work, args=(job,), name="fairing", daemon=True)
        self.thread.start()

    def stop(self) -> None:
        self.is_stale = True
        self.progress.abort()

    def take_best(self) -> None:
        self.is_finishing = True
        self.progress.finish()

    def _work(self, job: Job) -> None:
        try:
            self.value = job(self.progress)
        except Exception as error:  # handed over to the window's thread
            self.error = error
