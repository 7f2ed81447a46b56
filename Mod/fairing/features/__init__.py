# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects. Nothing here needs a window."""
