# SPDX-License-Identifier: LGPL-2.1-or-later
"""The type stubs say what the native module has: names, parameters, defaults."""

import ast
import pathlib
import re

from fairing import _fairing

STUBS = ast.parse((pathlib.Path(_fairing.__file__).with_name("_fairing.pyi")).read_text())


def public(names):
    return {name for name in names if not name.startswith("_")}


def functions():
    return [node for node in STUBS.body if isinstance(node, ast.FunctionDef)]


def classes():
    return [node for node in STUBS.body if isinstance(node, ast.ClassDef)]


def parameters_of(function):
    """Names and default texts of a stub's parameters, without self."""
    arguments = [argument for argument in function.args.args if argument.arg != "self"]
    defaults = [None] * (len(arguments) - len(function.args.defaults)) + function.args.defaults
    return {argument.arg: ast.unparse(default) if default else None
            for argument, default in zip(arguments, defaults)}


def parameters_in(docstring):
    """The same from the signature pybind11 writes into the first line of a docstring."""
    inside = re.match(r"\w+\((.*)\) ->", docstring.splitlines()[0]).group(1)
    found = {}
    for part in re.split(r", (?=\w+:)", inside):
        name, _, rest = part.partition(":")
        found[name] = rest.split(" = ")[1] if " = " in rest else None
    found.pop("self", None)
    return found


def test_same_names_in_the_module():
    stubbed = {node.name for node in classes() + functions()} | {
        node.target.id for node in STUBS.body if isinstance(node, ast.AnnAssign)}
    assert public(stubbed) == public(vars(_fairing))


def test_same_members_in_every_class():
    for node in classes():
        if node.name == "FairingError":  # its attributes are set when it is raised
            continue
        stubbed = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        assert public(stubbed) == public(vars(getattr(_fairing, node.name))), node.name


def test_same_parameters_and_defaults():
    for node in functions():
        assert parameters_of(node) == parameters_in(getattr(_fairing, node.name).__doc__), node.name
    checked = 0
    for node in classes():
        for item in node.body:
            if isinstance(item, ast.FunctionDef) and not item.decorator_list and item.name != "__init__":
                docstring = getattr(getattr(_fairing, node.name), item.name).__doc__
                assert parameters_of(item) == parameters_in(docstring), item.name
                checked += 1
    assert checked >= 8


def test_everything_has_a_docstring():
    for node in classes() + functions():
        assert getattr(_fairing, node.name).__doc__, node.name


def test_the_package_says_that_it_is_typed():
    assert pathlib.Path(_fairing.__file__).with_name("py.typed").exists()
