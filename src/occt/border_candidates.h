// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "core/base/result.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// An edge with at most one face that stays, before ends and coincident edges are matched.
struct Candidate {
  int edge = 0;
  std::vector<EdgeUse> staying = {};    ///< at most one before twins are joined
  std::optional<EdgeUse> removed = {};  ///< by the picked face
  bool walkable = false;                ///< a hole may run along it; else it only lends its face
  /// Numbers of the points where the parameter starts and ends, see joinEnds().
  std::array<int, 2> ends{};
  std::vector<Eigen::Vector3d> samples = {};  ///< along the edge, ends included
  double length = 0.0;                        ///< mm
  double tolerance = 0.0;                     ///< mm

  [[nodiscard]] bool isLone() const { return staying.empty() && !removed; }
};

/// An edge by itself, without its faces. Fails with EdgeDegenerate or EdgeInfinite.
[[nodiscard]] Result<Candidate> measured(const ShapeIndex& index, int edge);

struct Candidates {
  std::vector<Candidate> edges;
  std::vector<Error> refusals;  ///< by edge number: why an edge that borders no hole does not
};

/// The edges of a shape that may border a hole, once the picked faces are gone.
[[nodiscard]] Candidates collectCandidates(const ShapeIndex& index,
                                           const std::set<int>& pickedFaces);

/// The refusal of an edge that has `faces` faces beside it: EdgeNotFree or EdgeWithManyFaces.
[[nodiscard]] Error notFree(int edge, std::size_t faces);

}  // namespace fairing::occt
