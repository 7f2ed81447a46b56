# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line program and Ctrl-C."""

import os
import pathlib
import signal
import subprocess
import time

PROGRAM = os.environ["FAIRING_BINARY"]
PATIENCE = 60.0  # s


def interrupted(*arguments):
    """Exit status, output and errors of a command that meets Ctrl-C while it solves."""
    run = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + PATIENCE
    while not _heeds_interrupts(run):
        assert run.poll() is None and time.monotonic() < end, "it was to solve something"
        time.sleep(0.005)
    run.send_signal(signal.SIGINT)
    out, told = run.communicate(timeout=PATIENCE)
    return run.returncode, out, told


def _heeds_interrupts(run):
    """Whether the program has put up its handler: it does so for solving only."""
    lines = pathlib.Path(f"/proc/{run.pid}/status").read_text().splitlines()
    caught = next((line.split()[1] for line in lines if line.startswith("SigCgt:")), "0")
    return bool(int(caught, 16) & 1 << signal.SIGINT - 1)
