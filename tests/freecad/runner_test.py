# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/with_freecad tells the truth: the tests in FreeCAD can fail, and are seen to."""

import os
import subprocess

import pytest

RUNNER = os.path.join(os.path.dirname(__file__), "..", "..", "scripts", "with_freecad")


def run(tmp_path, script, *arguments, limit=60):
    path = tmp_path / "script.py"
    path.write_text(script)
    return subprocess.run(
        [RUNNER, "--addon", os.environ["FAIRING_ADDON"], "--limit", str(limit), path, *arguments],
        capture_output=True, text=True, check=False)


def test_a_script_runs_once_with_its_arguments_and_prints(tmp_path):
    done = run(tmp_path, "import sys, FreeCAD\nprint(sys.argv[1:], FreeCAD.GuiUp)\n", "a b", "c")
    assert (done.returncode, done.stdout) == (0, "['a b', 'c'] 0\n")


# FreeCAD 0.20.2 answers a crash with exit(1), which may itself crash among the destructors: 128 + SIGSEGV.
CRASHED = {1, 139}


@pytest.mark.parametrize("script, statuses, words", [
    ("assert 1 == 2, 'no'", {1}, "AssertionError: no"),
    ("import sys; sys.exit(5)", {5}, ""),
    ("import sys; sys.exit('because')", {1}, "because"),
    ("import ctypes; ctypes.string_at(0)", CRASHED, "Segmentation fault"),
    ("def broken(:", {1}, "SyntaxError"),
])
def test_a_failure_has_its_status_and_its_reason(tmp_path, script, statuses, words):
    done = run(tmp_path, script)
    assert done.returncode in statuses
    assert done.stdout.count(words) >= 1


def test_a_script_that_hangs_is_ended(tmp_path):
    assert run(tmp_path, "import time; time.sleep(60)", limit=2).returncode == 124


def test_the_home_of_the_user_is_left_alone(tmp_path):
    done = run(tmp_path, "import FreeCAD, os\nprint(FreeCAD.getUserAppDataDir(), os.environ['HOME'])")
    assert os.path.expanduser("~") not in done.stdout.replace(str(tmp_path), "")
