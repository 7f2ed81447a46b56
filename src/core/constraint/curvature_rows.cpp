// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/curvature_rows.h"

#include <algorithm>

#include "core/boundary/constraint_normal.h"
#include "core/constraint/across.h"
#include "core/spline/bspline_basis.h"

namespace fairing::constraint {
namespace {

using Eigen::Vector3d;
using layout::PatchEdge;

bool asksForCurvature(const ConstrainedEdge& edge) {
  return edge.isTangent() && edge.side->continuity == Continuity::G2;
}

// A patch edge with the three rows of control points its curvature depends on.
struct CurvedEdge {
  const ConstrainedEdge* edge;
  Across across;
  std::array<std::vector<int>, 3> rows;
};

// The row at parameter s; nothing where the support has no normal or no curvature is asked for.
std::optional<solver::LinearRow> rowAt(const CurvedEdge& e, double s, const solver::Points& about) {
  const ConstrainedEdge& edge = *e.edge;
  const double t = edge.sideParameter(s);
  if (edge.side->continuityAt(t) != Continuity::G2) return std::nullopt;
  const Vector3d normal = boundary::constraintNormal(edge.side->ribbon, t);
  const Eigen::Matrix3d form = edge.side->ribbon.support(t).secondForm;
  if (!normal.allFinite() || !form.allFinite()) return std::nullopt;
  const spline::BasisRow basis = spline::basisRow(edge.knots, s);
  const auto eachPole = [&](auto visit) {
    for (int k = 0; k <= edge.knots.degree(); ++k)
      for (std::size_t r = 0; r < 3; ++r)
        visit(e.rows[r][static_cast<std::size_t>(basis.first + k)], basis.values(0, k), r);
  };
  Vector3d v = Vector3d::Zero();
  eachPole([&](int point, double b, std::size_t r) {
    v += b * e.across.first[r] * about.row(point).transpose();
  });
  const Vector3d formV = form * v;
  solver::LinearRow row;
  row.right = -v.dot(formV);
  eachPole([&](int point, double b, std::size_t r) {
    row.points.push_back(point);
    row.weights.push_back(b * (e.across.second[r] * normal - 2.0 * e.across.first[r] * formV));
  });
  double largest = 0.0;
  for (const Vector3d& w : row.weights) largest = std::max(largest, w.norm());
  for (Vector3d& w : row.weights) w /= largest;
  row.right /= largest;
  return row;
}

solver::LinearRow mean(const solver::LinearRow& a, const solver::LinearRow& b) {
  solver::LinearRow result = a;
  result.points.insert(result.points.end(), b.points.begin(), b.points.end());
  result.weights.insert(result.weights.end(), b.weights.begin(), b.weights.end());
  for (Vector3d& w : result.weights) w *= 0.5;
  result.right = 0.5 * (a.right + b.right);
  return result;
}

class Collector {
 public:
  Collector(const solver::Points& about) : about_(about) {}

  void add(const CurvedEdge& e, int i) { add(e, {i, e.edge->knots.greville(i)}); }
  void add(const CurvedEdge& e, const Collocation& at) {
    if (auto row = rowAt(e, at.s, about_)) add(*row, e, at.pole);
  }
  void addCorner(const CurvedEdge& before, const CurvedEdge& after) {
    const int last = before.edge->knots.poleCount() - 3;
    const auto a = rowAt(before, before.edge->knots.greville(last), about_);
    const auto b = rowAt(after, after.edge->knots.greville(2), about_);
    if (a && b)
      add(mean(*a, *b), before, last);
    else if (a)
      add(*a, before, last);
    else if (b)
      add(*b, after, 2);
  }
  [[nodiscard]] std::optional<solver::ConstraintBlock> take() && {
    if (block_.rows.empty()) return std::nullopt;
    return std::move(block_);
  }

 private:
  void add(const solver::LinearRow& row, const CurvedEdge& e, int i) {
    block_.rows.push_back(row);
    block_.solvedFor.push_back(e.rows[2][static_cast<std::size_t>(i)]);
  }

  const solver::Points& about_;
  solver::ConstraintBlock block_;
};

// How many poles next to an end have no row of their own: those of a corner that belong to the
// `other` edge there (its outer row, its inner one where it is tangent, and one shared where it is
// curved), and at the start of a smooth seam, whose patches share them.
int leftOut(ConstrainedEdge::End end,
            bool atSeam,
            bool sharedFromStart,
            const std::optional<ConstrainedEdge>& other) {
  if (end != ConstrainedEdge::End::Held) return 0;
  if (atSeam) return sharedFromStart ? 2 : 0;
  if (!other->isTangent()) return 1;
  return asksForCurvature(*other) ? 3 : 2;
}

}  // namespace

std::optional<solver::ConstraintBlock> curvatureRows(
    const layout::PatchLayout& layout,
    const std::vector<std::array<std::optional<ConstrainedEdge>, 4>>& patches,
    const solver::Points& about) {
  Collector collector(about);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    std::array<std::optional<CurvedEdge>, 4> curved;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& edge = patches[p][k];
      if (!edge || !asksForCurvature(*edge)) continue;
      const PatchEdge which = layout::kPatchEdges[k];
      curved[k] = CurvedEdge{&*edge,
                             acrossOf(layout.patches[p], which),
                             {edge->outer, edge->inner, edgePoints(layout.patches[p], which, 2)}};
    }
    for (std::size_t k = 0; k < 4; ++k) {
      if (!curved[k]) continue;
      const auto& next = curved[(k + 1) % 4];
      const ConstrainedEdge& edge = *curved[k]->edge;
      if (edge.start == ConstrainedEdge::End::Closed) {
        for (const Collocation& at : collocation(edge)) collector.add(*curved[k], at);
        continue;
      }
      if (next && edge.end == ConstrainedEdge::End::Held) collector.addCorner(*curved[k], *next);
      const bool startsAtSeam = !patches[p][(k + 3) % 4], endsAtSeam = !patches[p][(k + 1) % 4];
      const int first = leftOut(edge.start, startsAtSeam, true, patches[p][(k + 3) % 4]);
      const int last = leftOut(edge.end, endsAtSeam, false, patches[p][(k + 1) % 4]);
      for (int i = first; i < edge.knots.poleCount() - last; ++i) collector.add(*curved[k], i);
    }
  }
  return std::move(collector).take();
}

}  // namespace fairing::constraint
