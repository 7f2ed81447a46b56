# SPDX-License-Identifier: LGPL-2.1-or-later
# cmake --install puts the add-on, with the program in its bin folder, into the user's FreeCAD; cpack makes a Debian
# package that puts it where Debian's FreeCAD looks for everybody.
if(CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set_property(CACHE CMAKE_INSTALL_PREFIX PROPERTY VALUE $ENV{HOME}/.local/share/FreeCAD/Mod/Fairing)
endif()
install(DIRECTORY ${FAIRING_ADDON_DIR}/ DESTINATION . PATTERN __pycache__ EXCLUDE)
install(TARGETS fairing_cli DESTINATION bin)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fairing)
set(CPACK_PACKAGE_CONTACT "The Fairing maintainers <maintainers@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "FreeCAD workbench that fills holes with fair B-spline faces")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr/share/freecad/Mod/Fairing)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/PackageLinks.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "freecad (>= 0.20), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
