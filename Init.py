# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this at every start, with or without a window. Documents may only restore proxies of modules that are
# imported already, so the package is imported here.
import fairing  # noqa: F401
