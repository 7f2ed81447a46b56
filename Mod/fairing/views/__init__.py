# SPDX-License-Identifier: LGPL-2.1-or-later
"""How document objects look and behave in the tree and the 3D view."""
