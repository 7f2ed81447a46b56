// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/find_fold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

constexpr int kFewest = 12;  // samples along u and v

struct Sample {
  Vector3d point, normal;  // the normal as long as its cell is large
  char side = 0;           // +1 or -1 once it is known
};

class Grid {
 public:
  Grid(const spline::BsplineSurface& patch, int divisions) : n_(divisions) {
    const double du = patch.u.last() / n_, dv = patch.v.last() / n_;
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) {
        const spline::SurfaceJet jet = patch.jet((i + 0.5) * du, (j + 0.5) * dv);
        samples_.push_back({jet.point, du * dv * jet.normalVector()});
      }
    spread();
  }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] double areaOf(int side) const {
    double area = 0.0;
    for (const Sample& s : samples_)
      if (s.side == side) area += s.normal.norm();
    return area;
  }

 private:
  // From neighbour to neighbour, across a fold to the other side.
  void spread() {
    samples_.front().side = 1;
    std::vector<int> waiting{0};
    while (!waiting.empty()) {
      const int at = waiting.back();
      waiting.pop_back();
      const int i = at / n_, j = at % n_;
      for (const auto& [di, dj] :
           std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
        if (i + di < 0 || i + di >= n_ || j + dj < 0 || j + dj >= n_) continue;
        const int next = at + di * n_ + dj;
        Sample& other = samples_[static_cast<std::size_t>(next)];
        const Sample& own = samples_[static_cast<std::size_t>(at)];
        if (other.side != 0) continue;
        other.side = own.normal.dot(other.normal) < 0.0 ? static_cast<char>(-own.side) : own.side;
        waiting.push_back(next);
      }
    }
  }

  int n_;
  std::vector<Sample> samples_;
};

}  // namespace

std::optional<Fold> findFold(const std::vector<spline::BsplineSurface>& patches, int samples) {
  if (patches.empty()) return std::nullopt;
  const int divisions =
      std::max(kFewest, static_cast<int>(std::sqrt(samples / static_cast<double>(patches.size()))));
  double area = 0.0, turned = 0.0;
  Vector3d middle = Vector3d::Zero();
  std::vector<Vector3d> points;
  for (const spline::BsplineSurface& patch : patches) {
    const Grid grid(patch, divisions);
    const double front = grid.areaOf(1), back = grid.areaOf(-1);
    area += front + back;
    if (std::min(front, back) <= 0.0) continue;
    turned += std::min(front, back);
    for (const Sample& s : grid.samples()) {
      if (s.side != (front < back ? 1 : -1)) continue;
      middle += s.normal.norm() * s.point;
      points.push_back(s.point);
    }
  }
  if (points.empty()) return std::nullopt;
  middle /= turned;
  const auto nearer = [&](const Vector3d& a, const Vector3d& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  };
  return Fold{*std::min_element(points.begin(), points.end(), nearer), turned / area};
}

}  // namespace fairing::analysis
