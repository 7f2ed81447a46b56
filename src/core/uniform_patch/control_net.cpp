// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/control_net.h"

#include <vector>

#include "core/uniform_patch/span_quadrature.h"

namespace fairing::uniform_patch {
namespace {

using Eigen::Vector3d;

// All knots of the domain along one side.
std::vector<double> knotsOf(int spans) {
  std::vector<double> knots;
  for (int k = 0; k <= spans; ++k) knots.push_back(3.0 + k);
  return knots;
}

}  // namespace

Result<void> validate(const ControlNet& net) {
  const int fewest = std::min(net.rows, net.columns);
  if (fewest < 2 * kRings + 1) return fail({.code = ErrorCode::NetTooSmall, .value = 1.0 * fewest});
  if (!net.points.allFinite()) return fail({.code = ErrorCode::NotFinite});
  return {};
}

Vector3d evaluate(const ControlNet& net, double u, double v, int a, int b) {
  const SpanPlace s(u, net.spansU()), t(v, net.spansV());
  const Eigen::Matrix4d bu = cubicRows(s.local), bv = cubicRows(t.local);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum += bu(a, i) * bv(b, j) * net.points.row(net.index(s.span + i, t.span + j)).transpose();
  return sum;
}

double borderDiameter(const ControlNet& net) {
  std::vector<Vector3d> border;
  for (const double u : knotsOf(net.spansU()))
    for (const double v : {3.0, double(net.columns)}) border.push_back(evaluate(net, u, v));
  for (const double v : knotsOf(net.spansV()))
    for (const double u : {3.0, double(net.rows)}) border.push_back(evaluate(net, u, v));
  double largest = 0.0;
  for (const Vector3d& p : border)
    for (const Vector3d& q : border) largest = std::max(largest, (p - q).norm());
  return largest;
}

ControlNet coonsNet(const ControlNet& net) {
  constexpr int first = kRings - 1;
  const int lastI = net.rows - kRings, lastJ = net.columns - kRings;
  const auto point = [&](int i, int j) { return net.points.row(net.index(i, j)); };
  ControlNet coons = net;
  for (int i = kRings; i < lastI; ++i)
    for (int j = kRings; j < lastJ; ++j) {
      const double s = double(i - first) / (lastI - first), t = double(j - first) / (lastJ - first);
      coons.points.row(net.index(i, j)) =
          (1.0 - s) *
              (point(first, j) - (1.0 - t) * point(first, first) - t * point(first, lastJ)) +
          s * (point(lastI, j) - (1.0 - t) * point(lastI, first) - t * point(lastI, lastJ)) +
          (1.0 - t) * point(i, first) + t * point(i, lastJ);
    }
  return coons;
}

}  // namespace fairing::uniform_patch
