#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_layers.py [ROOT]: holds the tree against rules.py; one line for each breach, status 1 if there is one."""

import ast
import fnmatch
import re
import subprocess
import sys
from pathlib import Path, PurePosixPath

import rules

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
CODE = {".cpp", ".h", ".py", ".cmake"}
PAGE = re.compile(r"[\w./-]+\.md\b")
MACHINE_PATH = re.compile(r"(?<![\w.$~{}])/(?:work|home|root|tmp/\w)/\w")


def project_files(root):
    """Paths relative to root of what git knows or would add; without git, of every file."""
    listing = subprocess.run(
        ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, text=True, check=False)
    if listing.returncode == 0 and (root / ".git").exists():
        names = [name for name in listing.stdout.split("\0") if name and (root / name).is_file()]
    else:
        names = [path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()]
    return sorted(names)


def stage_of(name):
    """The layer of a path under src/, or None: core/energy/x.h -> core/energy, occt/x.h -> occt."""
    parts = PurePosixPath(name).parts
    stage = "/".join(parts[:2]) if parts[0] == "core" else parts[0]
    return stage if stage in rules.STAGES and len(parts) > len(stage.split("/")) else None


def may_include(stage, header):
    """Whether a file of one layer may include a header, given by its path from src/."""
    target = stage_of(header)
    if stage == target:
        return True
    if stage in rules.PIPELINES and target in rules.PIPELINES:
        return False
    return any(allowed == header or fnmatch.fnmatch(target, allowed) for allowed in rules.STAGES[stage])


def check_includes(name, text):
    """Breaches of one file under src/."""
    inside = name.removeprefix("src/")
    stage = stage_of(inside)
    if stage is None:
        yield f"{name}: lies in no layer of rules.py"
        return
    for bracket, header in INCLUDE.findall(text):
        target = stage_of(header)
        if bracket == '"' and target is None:
            yield f'{name}: "{header}" is not a path from src/ to a layer'
        elif bracket == '"' and not may_include(stage, header):
            yield f"{name}: {stage} must not know {target} ({header})"
        elif bracket == "<" and not any(
                re.fullmatch(pattern, header) for pattern in rules.FOREIGN[stage.split("/")[0]]):
            yield f"{name}: {stage} must not know <{header}>"


def imported_modules(text):
    """First names of the modules imported while the file is imported, not inside a function."""
    pending = list(ast.parse(text).body)
    while pending:
        node = pending.pop()
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split(".")[0]
        elif not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            pending.extend(ast.iter_child_nodes(node))


def check_imports(name, text):
    """Breaches of one Python file of the workbench: it must be importable without a GUI."""
    if name.startswith(tuple(rules.GUI_PLACES)):
        return
    for module in imported_modules(text):
        if module in rules.GUI_MODULES:
            yield f"{name}: imports {module} at its top; that is for {' and '.join(rules.GUI_PLACES)}"


def check_form(name, text):
    """Breaches any file can commit: length, licence line, ASCII, paths of one machine."""
    suffix = PurePosixPath(name).suffix
    script = text.startswith("#!")
    lines = text.count("\n")
    limit = next(size for place, size in rules.LINE_LIMITS.items() if name.startswith(place))
    if (suffix in CODE or script) and lines > limit:
        yield f"{name}: {lines} lines, the limit is {limit}"
    if (suffix in CODE or script or name.endswith("CMakeLists.txt")) and \
            "SPDX-License-Identifier: LGPL-2.1-or-later" not in "\n".join(text.split("\n")[:3]):
        yield f"{name}: no SPDX line at its top"
    if suffix in {".cpp", ".h"} and not text.isascii():
        yield f"{name}: not ASCII"
    if suffix == ".h" and "#pragma once" not in text:
        yield f"{name}: no #pragma once"
    found = MACHINE_PATH.search(text)
    if found:
        yield f"{name}: names a path of one machine ({found.group()})"


def check_pages(name, text, names):
    """Pages a source speaks of that the tree does not have."""
    for page in sorted(set(PAGE.findall(text))):
        if not any(known == page or known.endswith("/" + page) for known in names):
            yield f"{name}: speaks of {page}, which does not exist"


def check_folders(names):
    """Folders the architecture does not know."""
    seen = {parent.as_posix() for name in names for parent in PurePosixPath(name).parents} - {"."}
    for folder in sorted(seen):
        path = PurePosixPath(folder)
        known = rules.FOLDERS.get(path.parent.as_posix())
        if known is not None and path.name not in known:
            yield f"{folder}/: not a folder of the architecture (docs/ARCHITECTURE.md)"


def check_tree(root):
    """Every breach under root."""
    names = project_files(root)
    yield from check_folders(names)
    for name in names:
        try:
            text = (root / name).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        yield from check_form(name, text)
        if PurePosixPath(name).suffix in CODE and not name.startswith("tests/architecture/"):
            yield from check_pages(name, text, names)
        if name.startswith("src/") and name.endswith((".h", ".cpp")):
            yield from check_includes(name, text)
        if name.startswith("Mod/fairing/") and name.endswith(".py"):
            yield from check_imports(name, text)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2])
    breaches = list(check_tree(root))
    print("\n".join(breaches) or "The layers hold.")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
