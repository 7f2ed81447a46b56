# SPDX-License-Identifier: LGPL-2.1-or-later
# Run by cpack on the tree it is about to pack: the program is found on the PATH.
file(MAKE_DIRECTORY ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/bin)
file(CREATE_LINK ../share/freecad/Mod/Fairing/bin/fairing ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/bin/fairing SYMBOLIC)
