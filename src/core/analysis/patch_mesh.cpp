// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/patch_mesh.h"

#include <algorithm>
#include <cmath>

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

constexpr double kSamePoint = 1e-7;  // of the extent of all points
constexpr double kFewest = 8.0, kMost = 160.0;

double widthOf(const spline::KnotVector& knots) {
  return knots.last() - knots.first();
}

class Mesher {
 public:
  void add(const spline::BsplineSurface& patch, int nu, int nv) {
    const double width = widthOf(patch.u), height = widthOf(patch.v);
    const int first = static_cast<int>(mesh_.points.size()), row = nv + 1;
    for (int i = 0; i <= nu; ++i)
      for (int j = 0; j <= nv; ++j) {
        if (i == 0 || i == nu || j == 0 || j == nv)
          border_.push_back(static_cast<int>(mesh_.points.size()));
        mesh_.points.push_back(
            patch.evaluate(patch.u.first() + width * i / nu, patch.v.first() + height * j / nv));
      }
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j) {
        const int a = first + i * row + j, b = a + row, c = b + 1, d = a + 1;
        mesh_.triangles.push_back({a, b, c});
        mesh_.triangles.push_back({a, c, d});
      }
  }
  [[nodiscard]] TriangleMesh finish() && {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : mesh_.points) box.extend(point);
    const double same = mesh_.points.empty() ? 0.0 : kSamePoint * box.diagonal().norm();
    const auto x = [&](int k) { return mesh_.points[static_cast<std::size_t>(k)].x(); };
    std::sort(border_.begin(), border_.end(), [&](int a, int b) { return x(a) < x(b); });
    std::vector<int> stands(mesh_.points.size());
    for (std::size_t k = 0; k < stands.size(); ++k) stands[k] = static_cast<int>(k);
    for (std::size_t k = 0; k < border_.size(); ++k)
      for (std::size_t l = k; l-- > 0 && x(border_[k]) - x(border_[l]) <= same;)
        if (distance(border_[k], border_[l]) <= same) {
          stands[static_cast<std::size_t>(border_[k])] =
              stands[static_cast<std::size_t>(border_[l])];
          break;
        }
    for (auto& triangle : mesh_.triangles)
      for (int& point : triangle) point = stands[static_cast<std::size_t>(point)];
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] double distance(int a, int b) const {
    return (mesh_.points[static_cast<std::size_t>(a)] - mesh_.points[static_cast<std::size_t>(b)])
        .norm();
  }
  TriangleMesh mesh_;
  std::vector<int> border_;
};

}  // namespace

TriangleMesh meshOf(const std::vector<spline::BsplineSurface>& patches, int cells) {
  if (patches.empty()) return {};
  const int each = cells / static_cast<int>(patches.size());
  // Where patches meet u may run along one of them and v along the other.
  const bool isOne = patches.size() == 1;
  const double ratio = isOne ? widthOf(patches.front().u) / widthOf(patches.front().v) : 1.0;
  const int nu = static_cast<int>(std::clamp(std::sqrt(each * ratio), kFewest, kMost));
  const int nv = isOne ? std::max(static_cast<int>(kFewest), each / nu) : nu;
  Mesher mesher;
  for (const spline::BsplineSurface& patch : patches) mesher.add(patch, nu, nv);
  return std::move(mesher).finish();
}

}  // namespace fairing::analysis
