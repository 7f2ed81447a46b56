# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels and what they draw into the 3D view."""
