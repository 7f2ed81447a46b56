# SPDX-License-Identifier: LGPL-2.1-or-later
# Headers that nearly every file of a target reads are compiled once. The presets "release" and "tidy" go without them
# (CMAKE_DISABLE_PRECOMPILE_HEADERS) and so see to it that every file includes what it uses.
set(FAIRING_COMMON_HEADERS
  <Eigen/Cholesky> <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore> <algorithm> <array> <cmath> <functional> <map>
  <memory> <optional> <string> <tl/expected.hpp> <utility> <vector>)
set(FAIRING_OCCT_HEADERS
  <BRepAdaptor_Surface.hxx> <BRep_Builder.hxx> <BRep_Tool.hxx> <Geom_BSplineSurface.hxx> <TopExp.hxx>
  <TopExp_Explorer.hxx> <TopTools_IndexedMapOfShape.hxx> <TopoDS.hxx> <TopoDS_Edge.hxx> <TopoDS_Face.hxx>)

# fairing_precompile(TARGET HEADERS...): the common headers and these.
function(fairing_precompile target)
  target_precompile_headers(${target} PRIVATE ${FAIRING_COMMON_HEADERS} ${ARGN})
endfunction()
