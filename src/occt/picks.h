// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <map>
#include <vector>

#include "core/boundary/continuity.h"

namespace fairing::occt {

/// What the user picked, in any order, and what is wished. Numbers are FreeCAD's (EdgeN, FaceN).
struct Picks {
  std::vector<int> edges = {};  ///< one edge of a hole is enough
  std::vector<int> faces = {};  ///< faces that are to be replaced: their border is the hole
  /// Of every edge with a face beside it; an edge without one is met G0.
  Continuity continuity = Continuity::G1;
  std::map<int, Continuity> edgeContinuity = {};  ///< by edge number, goes before `continuity`
};

}  // namespace fairing::occt
