// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "core/analysis/curvature.h"
#include "core/base/angle.h"

namespace fairing::analysis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Below this sine between R_u and R_v, or ratio of their lengths, a normal is left to chance.
constexpr double kSingular = 1e-7;
// How far towards the middle of a triangle a corner without a normal looks for one.
constexpr double kInwards = 1e-3;
constexpr double kOutside = 0.02;  // share beyond either end of a range
constexpr double kLeastTurn = 1e-3;
constexpr int kPasses = 10;
constexpr std::size_t kMostVertices = 200000;
// An edge that turns is not split below this share of the longest one.
constexpr double kShortestShare = 1.0 / 16.0;

bool isSingular(const spline::ThirdOrderJet& jet) {
  const Vector3d u = jet.col(0), v = jet.col(1);
  const double a = u.norm(), b = v.norm();
  return !(std::min(a, b) > kSingular * std::max(a, b) && u.cross(v).norm() > kSingular * a * b);
}

bool isSigned(CurvatureQuantity quantity) {
  return quantity != CurvatureQuantity::MeanGradient;
}

// Over a diagonal d a turn by t radians is a curvature of t / d.
double leastRange(CurvatureQuantity quantity, double diagonal) {
  const double curvature = kLeastTurn / diagonal;
  switch (quantity) {
    case CurvatureQuantity::Gauss:
      return curvature * curvature;
    case CurvatureQuantity::MeanGradient:
      return curvature / diagonal;
    case CurvatureQuantity::Mean:
    case CurvatureQuantity::K1:
    case CurvatureQuantity::K2:
      break;
  }
  return curvature;
}

struct Weighted {
  double value, weight;
};

// The value below which lies a share of the weight.
double percentile(const std::vector<Weighted>& ascending, double share) {
  double total = 0.0, below = 0.0;
  for (const Weighted& item : ascending) total += item.weight;
  for (const Weighted& item : ascending) {
    below += item.weight;
    if (below >= share * total) return item.value;
  }
  return ascending.empty() ? 0.0 : ascending.back().value;
}

// By the side that is seen: turned round, curvatures change their sign.
CurvatureValues curvatureValues(const spline::ThirdOrderJet& jet, bool reversed) {
  const Curvature c = curvatureOf(jet);
  // Rounding is no slope; what is not finite stays so.
  const double gradient = c.meanGradientSquared < 0.0 ? 0.0 : std::sqrt(c.meanGradientSquared);
  CurvatureValues values;
  if (reversed)
    values << -c.mean, c.gauss, -c.k2(), -c.k1(), gradient;
  else
    values << c.mean, c.gauss, c.k1(), c.k2(), gradient;
  return values;
}

PictureSurface pictureSurface(spline::BsplineSurface patch, bool reversed, int number) {
  const auto shared = std::make_shared<const spline::BsplineSurface>(std::move(patch));
  return {[shared](double u, double v) {
            const spline::Partials partials = shared->derivatives(u, v, 3);
            return PlacedJet{partials.col(0), spline::thirdOrderJet(partials)};
          },
          reversed,
          number};
}

}  // namespace

CurvaturePicture::Vertex CurvaturePicture::vertexAt(int surface, const Vector2d& at) const {
  const PictureSurface& on = surfaces_[static_cast<std::size_t>(surface)];
  const PlacedJet placed = on.at(at[0], at[1]);
  Vertex vertex{at, placed.point, Vector3d::Zero(), CurvatureValues(), surface};
  if (isSingular(placed.jet)) {
    vertex.values.setConstant(std::numeric_limits<double>::quiet_NaN());
    return vertex;
  }
  const Vector3d across = placed.jet.col(0).cross(placed.jet.col(1));
  vertex.normal = (on.reversed ? -across : across).normalized();
  vertex.values = curvatureValues(placed.jet, on.reversed);
  return vertex;
}

// Splits marked edges at their middles: a triangle into two, three or four.
class CurvaturePicture::Refinement {
 public:
  Refinement(CurvaturePicture& picture, std::size_t firstTriangle, const PictureFineness& fineness)
      : picture_(picture), first_(firstTriangle), fineness_(fineness) {}

  // Whether anything was split.
  bool pass() {
    middles_.clear();
    for (std::size_t t = first_; t < picture_.triangles_.size(); ++t) {
      const auto corners = picture_.triangles_[t];
      for (std::size_t k = 0; k < 3; ++k) mark(corners[k], corners[(k + 1) % 3]);
    }
    if (middles_.empty()) return false;
    const std::vector<std::array<int, 3>> before(
        picture_.triangles_.begin() + static_cast<std::ptrdiff_t>(first_),
        picture_.triangles_.end());
    picture_.triangles_.resize(first_);
    for (const auto& triangle : before) split(triangle);
    return true;
  }

 private:
  using Edge = std::pair<int, int>;
  [[nodiscard]] static Edge edge(int a, int b) { return std::minmax(a, b); }
  [[nodiscard]] const Vertex& vertex(int k) const {
    return picture_.vertices_[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] bool isTooCoarse(const Vertex& a, const Vertex& b) const {
    const double length = (a.point - b.point).norm();
    if (fineness_.longest > 0.0 && length > fineness_.longest) return true;
    if (fineness_.turn <= 0.0 || length <= kShortestShare * fineness_.longest) return false;
    return angleBetween(a.normal, b.normal) > fineness_.turn;
  }
  void mark(int a, int b) {
    if (middles_.count(edge(a, b)) > 0 || !isTooCoarse(vertex(a), vertex(b))) return;
    const Vector2d middle = 0.5 * (vertex(a).at + vertex(b).at);
    middles_[edge(a, b)] = static_cast<int>(picture_.vertices_.size());
    picture_.vertices_.push_back(picture_.vertexAt(vertex(a).surface, middle));
  }
  [[nodiscard]] int middle(int a, int b) const {
    const auto found = middles_.find(edge(a, b));
    return found == middles_.end() ? -1 : found->second;
  }
  void keep(int a, int b, int c) { picture_.triangles_.push_back({a, b, c}); }
  void split(const std::array<int, 3>& triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      if (ab >= 0 && bc >= 0 && ca >= 0) return splitInFour(triangle, {ab, bc, ca});
      if (ab < 0 || ca >= 0) continue;  // seen from another corner
      keep(a, ab, c);
      if (bc < 0) return keep(ab, b, c);
      keep(ab, b, bc);
      return keep(ab, bc, c);
    }
    keep(triangle[0], triangle[1], triangle[2]);
  }
  void splitInFour(const std::array<int, 3>& corners, const std::array<int, 3>& middles) {
    keep(corners[0], middles[0], middles[2]);
    keep(middles[0], corners[1], middles[1]);
    keep(middles[2], middles[1], corners[2]);
    keep(middles[0], middles[1], middles[2]);
  }

  CurvaturePicture& picture_;
  std::size_t first_;
  const PictureFineness& fineness_;
  std::map<Edge, int> middles_;
};

// A corner without a normal takes that of a place a little inside its triangle.
void CurvaturePicture::mendSingular(std::size_t firstTriangle) {
  for (std::size_t t = firstTriangle; t < triangles_.size(); ++t)
    for (const int corner : triangles_[t]) {
      Vertex& vertex = vertices_[static_cast<std::size_t>(corner)];
      if (!vertex.normal.isZero()) continue;
      Vector2d middle = Vector2d::Zero();
      for (const int k : triangles_[t]) middle += vertices_[static_cast<std::size_t>(k)].at / 3.0;
      const Vertex inside = vertexAt(vertex.surface, vertex.at + kInwards * (middle - vertex.at));
      vertex.normal = inside.normal;
      vertex.values = inside.values;
    }
}

void CurvaturePicture::add(PictureSurface surface,
                           const ParameterMesh& mesh,
                           const PictureFineness& fineness) {
  const auto number = static_cast<int>(surfaces_.size());
  const std::size_t firstVertex = vertices_.size(), firstTriangle = triangles_.size();
  const bool reversed = surface.reversed;
  surfaces_.push_back(std::move(surface));
  for (const Vector2d& at : mesh.at) vertices_.push_back(vertexAt(number, at));
  const int shift = static_cast<int>(firstVertex);
  for (auto [a, b, c] : mesh.triangles) {
    if (reversed) std::swap(b, c);
    triangles_.push_back({a + shift, b + shift, c + shift});
  }
  Refinement refinement(*this, firstTriangle, fineness);
  for (int pass = 0; pass < kPasses && vertices_.size() - firstVertex < kMostVertices; ++pass)
    if (!refinement.pass()) break;
  mendSingular(firstTriangle);
}

Mesh CurvaturePicture::mesh() const {
  Mesh mesh;
  const auto count = static_cast<Eigen::Index>(vertices_.size());
  mesh.points.resize(count, 3);
  mesh.normals.resize(count, 3);
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vertex& vertex = vertices_[static_cast<std::size_t>(k)];
    mesh.points.row(k) = vertex.point.cast<float>().transpose();
    mesh.normals.row(k) = vertex.normal.cast<float>().transpose();
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto& [a, b, c] = triangles_[static_cast<std::size_t>(t)];
    mesh.triangles.row(t) << a, b, c;
  }
  return mesh;
}

Eigen::Matrix<double, Eigen::Dynamic, kCurvatureQuantities, Eigen::RowMajor>
CurvaturePicture::values() const {
  Eigen::Matrix<double, Eigen::Dynamic, kCurvatureQuantities, Eigen::RowMajor> all(
      static_cast<Eigen::Index>(vertices_.size()), kCurvatureQuantities);
  for (std::size_t k = 0; k < vertices_.size(); ++k)
    all.row(static_cast<Eigen::Index>(k)) = vertices_[k].values;
  return all;
}

std::pair<double, double> CurvaturePicture::range(CurvatureQuantity quantity) const {
  const auto column = static_cast<Eigen::Index>(quantity);
  std::vector<Weighted> found;
  Eigen::AlignedBox3d box;
  for (const auto& triangle : triangles_) {
    const auto corner = [&](std::size_t k) -> const Vertex& {
      return vertices_[static_cast<std::size_t>(triangle[k])];
    };
    const Vector3d first = corner(1).point - corner(0).point,
                   second = corner(2).point - corner(0).point;
    const double area = first.cross(second).norm();
    for (std::size_t k = 0; k < 3; ++k) {
      box.extend(corner(k).point);
      const double value = corner(k).values[column];
      if (std::isfinite(value)) found.push_back({value, area});
    }
  }
  if (found.empty()) return {isSigned(quantity) ? -1.0 : 0.0, 1.0};
  std::sort(found.begin(), found.end(), [](const Weighted& a, const Weighted& b) {
    return a.value < b.value;
  });
  const double low = percentile(found, kOutside), high = percentile(found, 1.0 - kOutside);
  const double most =
      std::max({std::abs(low), std::abs(high), leastRange(quantity, box.diagonal().norm())});
  return {isSigned(quantity) ? -most : 0.0, most};
}

CurvaturePlace CurvaturePicture::at(int triangle, double a, double b) const {
  const auto& corners = triangles_[static_cast<std::size_t>(triangle)];
  const auto corner = [&](std::size_t k) -> const Vertex& {
    return vertices_[static_cast<std::size_t>(corners[k])];
  };
  const Vector2d at = (1.0 - a - b) * corner(0).at + a * corner(1).at + b * corner(2).at;
  const Vertex vertex = vertexAt(corner(0).surface, at);
  const bool isPole = vertex.normal.isZero();
  return {surfaces_[static_cast<std::size_t>(vertex.surface)].number,
          vertex.point,
          isPole ? corner(0).normal : vertex.normal,
          isPole ? corner(0).values : vertex.values};
}

CurvaturePicture curvaturePicture(const std::vector<spline::BsplineSurface>& patches,
                                  const std::vector<bool>& reversed,
                                  int cells) {
  CurvaturePicture picture;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& [u, v, poles] = patches[p];
    ParameterMesh mesh;
    const int side = cells + 1;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        mesh.at.emplace_back(u.at(double(i) / cells), v.at(double(j) / cells));
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) {
        const int a = i * side + j, b = a + side, c = b + 1, d = a + 1;
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    picture.add(pictureSurface(patches[p], reversed[p], static_cast<int>(p) + 1), mesh);
  }
  return picture;
}

}  // namespace fairing::analysis
