# SPDX-License-Identifier: LGPL-2.1-or-later
# package.xml is the only place of the version number; this reads it into FAIRING_VERSION.
set(manifest ${CMAKE_CURRENT_LIST_DIR}/../package.xml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manifest})
file(STRINGS ${manifest} line REGEX "<version>")
if(NOT line MATCHES "<version>([0-9]+\\.[0-9]+\\.[0-9]+)</version>")
  message(FATAL_ERROR "package.xml has no <version>x.y.z</version>")
endif()
set(FAIRING_VERSION ${CMAKE_MATCH_1})
