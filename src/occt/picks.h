// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <map>
#include <vector>

#include "core/boundary/continuity.h"

namespace fairing::occt {

/// What takes the place of a face beside an edge.
struct EdgeDirection {
  enum class Kind {
    Tangent,   ///< the patch's tangent plane along the edge contains `direction`
    Symmetry,  ///< the edge lies in a plane with this normal, and the patch meets its mirror image
               ///< beyond it tangentially
  };
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of any length but zero
  Kind kind = Kind::Tangent;
};

/// What the user picked, in any order, and what is wished. Numbers are FreeCAD's (EdgeN, FaceN).
struct Picks {
  std::vector<int> edges = {};  ///< one edge of a hole is enough
  std::vector<int> faces = {};  ///< faces that are to be replaced: their border is the hole
  /// Of every edge with a face beside it; an edge without one is met G0.
  Continuity continuity = Continuity::G1;
  std::map<int, Continuity> edgeContinuity = {};  ///< by edge number, goes before `continuity`
  std::map<int, EdgeDirection> directions = {};   ///< by edge number, goes before the edge's face
};

}  // namespace fairing::occt
