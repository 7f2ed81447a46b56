// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/seam_ties.h"

#include <map>

#include "core/constraint/seam_rows.h"
#include "core/spline/bspline_basis.h"

namespace fairing::constraint {
namespace {

using layout::Seam;
using layout::SeamFrame;

// The derivative of order 0 or 1 along the seam of
//   first D1 + second D2 - along R_t,   D1 = sum B_i (first_i - on_i) / firstStep,  R_t = sum B_i'
//   on_i.
solver::TieRow tieRow(const SeamRows& rows, double t, int order) {
  const spline::BasisRow basis = spline::basisRow(rows.knots, t, 2);
  const SeamFrame f = rows.seam->frame(t), df = rows.seam->frameDerivative(t);
  solver::TieRow row;
  for (int k = 0; k <= rows.knots.degree(); ++k) {
    const auto i = static_cast<std::size_t>(basis.first + k);
    const double b = basis.values(0, k), db = basis.values(1, k), ddb = basis.values(2, k);
    const auto product = [&](double c, double dc) { return order == 0 ? c * b : dc * b + c * db; };
    const double w1 = product(f.first, df.first) / rows.firstStep;
    const double w2 = product(f.second, df.second) / rows.secondStep;
    const double along = order == 0 ? f.along * db : df.along * db + f.along * ddb;
    for (const auto& [point, weight] :
         {std::pair{rows.first[i], w1}, {rows.second[i], w2}, {rows.on[i], -w1 - w2 - along}}) {
      row.points.push_back(point);
      row.weights.push_back(weight);
    }
  }
  return row;
}

// Rows are scaled to weights of the order of 1, lest the rank depend on the knots; points that only
// rounding gives a weight take no part.
void addRow(solver::TieBlock& block, const solver::TieRow& row) {
  constexpr double kRounding = 1e-13;
  double largest = 0.0;
  for (const double w : row.weights) largest = std::max(largest, std::abs(w));
  if (largest == 0.0) return;
  solver::TieRow scaled;
  for (std::size_t k = 0; k < row.points.size(); ++k) {
    if (std::abs(row.weights[k]) <= kRounding * largest) continue;
    scaled.points.push_back(row.points[k]);
    scaled.weights.push_back(row.weights[k] / largest);
  }
  scaled.right = row.right / largest;
  block.rows.push_back(std::move(scaled));
}

// The n-th point from the start or from the end.
int nth(const std::vector<int>& points, bool atEnd, std::size_t n) {
  return atEnd ? points[points.size() - 1 - n] : points[n];
}

void addVertexEnd(const SeamRows& rows, bool atEnd, solver::TieBlock& block) {
  const double t = atEnd ? 1.0 : 0.0;
  addRow(block, tieRow(rows, t, 0));
  addRow(block, tieRow(rows, t, 1));
  for (const int point : {nth(rows.on, atEnd, 1),
                          nth(rows.on, atEnd, 2),
                          nth(rows.first, atEnd, 1),
                          nth(rows.second, atEnd, 1)})
    block.solvedFor.push_back(point);
}

solver::TieBlock borderEnd(const SeamRows& rows, bool atEnd) {
  solver::TieBlock block;
  addRow(block, tieRow(rows, atEnd ? 1.0 : 0.0, 0));
  addRow(block, tieRow(rows, atEnd ? 1.0 : 0.0, 1));
  block.solvedFor = {nth(rows.first, atEnd, 1), nth(rows.second, atEnd, 1)};
  const bool bends = rows.seam->frames[atEnd ? 1 : 0].along != 0.0;
  if (bends) block.solvedFor.push_back(nth(rows.on, atEnd, 1));
  return block;
}

solver::TieBlock between(const SeamRows& rows) {
  solver::TieBlock block;
  const int n = rows.knots.poleCount();
  for (int i = 2; i < n - 2; ++i) {
    addRow(block, tieRow(rows, rows.knots.greville(i), 0));
    block.solvedFor.push_back(rows.second[static_cast<std::size_t>(i)]);
  }
  return block;
}

}  // namespace

std::vector<solver::TieBlock> tieSeams(const layout::PatchLayout& layout) {
  std::vector<SeamRows> seams;
  for (const Seam& seam : layout.seams)
    if (!seam.crease) seams.push_back(seamRows(layout, seam));
  std::map<int, solver::TieBlock> vertices;
  for (const SeamRows& rows : seams)
    for (std::size_t k = 0; k < 2; ++k)
      if (rows.seam->inside[k]) addVertexEnd(rows, k == 1, vertices[rows.seam->vertices[k]]);
  std::vector<solver::TieBlock> blocks;
  for (auto& [vertex, block] : vertices) blocks.push_back(std::move(block));
  for (const SeamRows& rows : seams)
    for (std::size_t k = 0; k < 2; ++k)
      if (!rows.seam->inside[k]) blocks.push_back(borderEnd(rows, k == 1));
  for (const SeamRows& rows : seams) blocks.push_back(between(rows));
  return blocks;
}

std::vector<solver::TieBlock> tieClosing(const layout::LayoutPatch& patch) {
  const int n = patch.u.poleCount(), rows = patch.v.poleCount();
  const int smooth = std::min(patch.u.degree() - 1, spline::kMaxBasisDerivative);
  const spline::BasisRow start = spline::basisRow(patch.u, patch.u.first(), smooth);
  const spline::BasisRow end = spline::basisRow(patch.u, patch.u.last(), smooth);
  std::vector<solver::TieBlock> blocks;
  for (int j = 1; j + 1 < rows; ++j) {
    const auto point = [&](int i) { return patch.points[static_cast<std::size_t>(i * rows + j)]; };
    solver::TieBlock block;
    for (int order = 0; order <= smooth; ++order) {
      solver::TieRow row;
      for (int k = 0; k <= patch.u.degree(); ++k) {
        row.points.push_back(point(start.first + k));
        row.weights.push_back(start.values(order, k));
        row.points.push_back(point(end.first + k));
        row.weights.push_back(-end.values(order, k));
      }
      addRow(block, row);
      block.solvedFor.push_back(point(n - 1 - order));
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace fairing::constraint
