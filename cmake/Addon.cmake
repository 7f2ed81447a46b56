# SPDX-License-Identifier: LGPL-2.1-or-later
# Every build leaves a complete add-on in build/<preset>/Mod/Fairing; install and packages copy that tree.
add_custom_target(addon ALL
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D ADDON=${FAIRING_ADDON_DIR}
          -P ${PROJECT_SOURCE_DIR}/cmake/AssembleAddon.cmake
  COMMENT "Assembling ${FAIRING_ADDON_DIR}"
)
if(TARGET _fairing)
  add_dependencies(addon _fairing)
endif()

if(CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set_property(CACHE CMAKE_INSTALL_PREFIX PROPERTY VALUE $ENV{HOME}/.local/share/FreeCAD/Mod/Fairing)
endif()
install(DIRECTORY ${FAIRING_ADDON_DIR}/ DESTINATION . PATTERN __pycache__ EXCLUDE)
