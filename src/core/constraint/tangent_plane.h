// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/boundary/boundary_loop.h"
#include "core/constraint/constraint_set.h"

namespace fairing::constraint {

/// A patch edge that follows a side, with what is known of it: everything along the border's
/// direction.
struct ConstrainedEdge {
  const boundary::BoundarySide* side = nullptr;
  const layout::SideUse* use = nullptr;
  spline::KnotVector knots;
  std::vector<int> outer, inner;  ///< point numbers of the row on the edge and of the next one

  [[nodiscard]] bool isTangent() const {
    return side->continuity != Continuity::G0 && side->ribbon.hasSupport();
  }
  /// The side's parameter at a parameter of the patch.
  [[nodiscard]] double sideParameter(double s) const {
    return use->from + (use->to - use->from) * (s - knots.first()) / (knots.last() - knots.first());
  }
  /// d(side parameter) / d(patch parameter).
  [[nodiscard]] double rate() const {
    return (use->to - use->from) / (knots.last() - knots.first());
  }
};

/// The twist of the corner where `before` ends and `after` starts, from the sides that are tangent
/// there.
///   R_v . n = 0 along `before` gives, differentiated, R_uv . n = -R_v . n_u; `after` gives R_uv .
///   n = -R_u . n_v.
/// Where the two differ their mean is taken: each side then bears half of the error.
[[nodiscard]] Result<std::optional<solver::ConstraintBlock>> cornerTwist(
    const ConstrainedEdge& before, const ConstrainedEdge& after);

/// R_v . n = 0 along an edge, collocated at the Greville abscissae of the inner row's poles but for
/// the two at either end: with the ends and twists known, R_v . n has a double zero at both ends
/// already.
[[nodiscard]] Result<solver::ConstraintBlock> tangentRows(const ConstrainedEdge& edge);

}  // namespace fairing::constraint
