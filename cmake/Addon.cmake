# SPDX-License-Identifier: LGPL-2.1-or-later
# Every build leaves a complete add-on in build/<preset>/Mod/Fairing.
add_custom_target(addon ALL
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D ADDON=${FAIRING_ADDON_DIR}
          -P ${PROJECT_SOURCE_DIR}/cmake/AssembleAddon.cmake
  COMMENT "Assembling ${FAIRING_ADDON_DIR}"
)
add_dependencies(addon _fairing)
