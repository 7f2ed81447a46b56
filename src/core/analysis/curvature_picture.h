// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "core/analysis/tessellation.h"
#include "core/spline/bspline_surface.h"
#include "core/spline/fundamental_forms.h"

namespace fairing::analysis {

/// What a picture shows, in the order of its columns. Signed ones are positive where the surface
/// bends towards its normal: a sphere whose normal points outwards has H = -1 / r.
enum class CurvatureQuantity {
  Mean,          ///< H = (k1 + k2) / 2, 1/mm
  Gauss,         ///< K = k1 k2, 1/mm^2
  K1,            ///< the greater principal curvature, 1/mm
  K2,            ///< the smaller one, 1/mm
  MeanGradient,  ///< |grad H| on the surface, 1/mm^2
};
inline constexpr int kCurvatureQuantities = 5;
using CurvatureValues = Eigen::Matrix<double, 1, kCurvatureQuantities>;

/// A point of a surface with its derivatives.
struct PlacedJet {
  Eigen::Vector3d point;
  spline::ThirdOrderJet jet;
};

/// A surface to be drawn, whatever it is made of.
struct PictureSurface {
  std::function<PlacedJet(double u, double v)> at;
  bool reversed = false;  ///< its normal is -u x v
  int number = 0;         ///< of its face or patch, from 1 on
};

/// Triangles in the parameters of a surface, counter-clockwise.
struct ParameterMesh {
  std::vector<Eigen::Vector2d> at;
  std::vector<std::array<int, 3>> triangles;
};

/// How fine a picture is to be.
struct PictureFineness {
  double longest = 0.0;  ///< of a triangle's edges, mm; 0: as they are
  double turn = 0.0;     ///< of the normal along an edge, degrees; 0: whatever it is
};

/// The curvature at one place.
struct CurvaturePlace {
  int number = 0;  ///< of the surface
  Eigen::Vector3d point, normal;
  CurvatureValues values;
};

/// Surfaces as triangles with the curvature at every vertex, exact there.
class CurvaturePicture {
 public:
  /// Splits edges of the triangles in halves until they are as fine as asked; triangles that share
  /// an edge go on sharing it. Where the surface has no normal (a pole), its neighbourhood's is
  /// taken, and the curvature with it.
  void add(PictureSurface surface, const ParameterMesh& mesh, const PictureFineness& fineness = {});

  [[nodiscard]] int triangleCount() const { return static_cast<int>(triangles_.size()); }
  [[nodiscard]] Mesh mesh() const;
  /// A row a vertex, a column a CurvatureQuantity. Not finite where there is no curvature.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, kCurvatureQuantities, Eigen::RowMajor>
  values() const;
  /// What nearly all of the picture lies within: the 2nd and 98th percentile, a triangle counting
  /// by its area; symmetric about 0 where the quantity has a sign, from 0 on where it has none.
  /// Never narrower than a turn by 0.06 degrees over the whole picture makes it: rounding has no
  /// colours.
  [[nodiscard]] std::pair<double, double> range(CurvatureQuantity quantity) const;
  /// The surface's own curvature, evaluated at a place in a triangle: (1 - a - b) of its first
  /// corner, a of its second, b of its third.
  [[nodiscard]] CurvaturePlace at(int triangle, double a, double b) const;

 private:
  struct Vertex {
    Eigen::Vector2d at;
    Eigen::Vector3d point, normal;
    CurvatureValues values;
    int surface;
  };
  class Refinement;
  [[nodiscard]] Vertex vertexAt(int surface, const Eigen::Vector2d& at) const;
  void mendSingular(std::size_t firstTriangle);

  std::vector<PictureSurface> surfaces_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 3>> triangles_;
};

/// Whole patches, `cells` by `cells` each, numbered from 1; `reversed` as FillResult has it.
[[nodiscard]] CurvaturePicture curvaturePicture(const std::vector<spline::BsplineSurface>& patches,
                                                const std::vector<bool>& reversed,
                                                int cells);

}  // namespace fairing::analysis
