# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs without_addon.py step by step: with Fairing, without it, with it again; and with a native module that is missing
or foreign."""

import os
import pathlib
import shutil
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
ADDON = pathlib.Path(os.environ["FAIRING_ADDON"])


def run(script, *arguments, addon=ADDON, runner="with_freecad"):
    done = subprocess.run([SCRIPTS / runner, "--addon", addon, HERE / script, *map(str, arguments)], text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture
def no_addon(tmp_path):
    folder = tmp_path / "nothing"
    folder.mkdir()
    (folder / "InitGui.py").touch()
    return folder


@pytest.fixture
def copied_addon(tmp_path):
    copy = tmp_path / "Fairing"
    shutil.copytree(ADDON, copy)
    return copy


def native_module(addon):
    return next((addon / "fairing").glob("_fairing*.so"))


def test_a_fill_keeps_its_shape_without_the_addon_and_lives_again_with_it(tmp_path, no_addon):
    path = tmp_path / "life.FCStd"
    run("without_addon.py", "make", path)
    run("without_addon.py", "keep", path, addon=no_addon)
    run("without_addon.py", "revive", path, runner="with_freecad_gui")


def test_a_missing_native_module_is_told_in_one_sentence(copied_addon):
    native_module(copied_addon).unlink()
    run("broken_addon.py", "is missing", addon=copied_addon, runner="with_freecad_gui")


def test_a_native_module_of_another_python_is_told_in_one_sentence(copied_addon):
    module = native_module(copied_addon)
    module.rename(module.with_name("_fairing.cpython-27-x86_64-linux-gnu.so"))
    run("broken_addon.py", "another Python", addon=copied_addon, runner="with_freecad_gui")


def test_a_native_module_that_does_not_load_is_told_in_one_sentence(copied_addon):
    native_module(copied_addon).write_bytes(b"no library")
    run("broken_addon.py", "does not load", addon=copied_addon, runner="with_freecad_gui")
