// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/slide_end.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "core/layout/layout_plan.h"
#include "core/spline/fit_curve.h"
#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

using boundary::BoundarySide;
using boundary::ChainPair;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using spline::CurvePoint;

constexpr int kSamples = 32;
constexpr double kFit = 1e-8;         // of the diagonal
constexpr double kSameNormal = 0.02;  // sine: planes closer to each other share no line
constexpr double kDifference = 1e-4;

const DomainBox kEverywhere(Eigen::Vector2d::Constant(-1e100), Eigen::Vector2d::Constant(1e100));

/// A point on the wall, and what of a step in space is one of it.
struct Foot {
  Vector3d point, normal;
  Matrix3d step;
};

class Wall {
 public:
  explicit Wall(const TopoDS_Face& face) : face_(face), surface_(face, false) {}

  /// The foot q of p = q + h n: a step P dp in the tangent plane is (I - h II) dq.
  [[nodiscard]] Foot footOf(const Vector3d& p) const {
    const SurfacePoint at = footFrom(surface_, p, face_.nearest(p).at, kEverywhere);
    const Vector3d n = at.cross().normalized();
    const double height = (p - at.point).dot(n);
    const Matrix3d across = n * n.transpose();
    const Matrix3d bent = Matrix3d::Identity() - height * at.secondForm(n) + across;
    return {at.point, n, bent.inverse() * (Matrix3d::Identity() - across)};
  }
  /// How far a point of the surface lies beyond the face's border.
  [[nodiscard]] double beyond(const Vector3d& foot) const { return face_.nearest(foot).distance; }

 private:
  FaceProjector face_;
  BRepAdaptor_Surface surface_;
};

/// The border of the strip, moved at its ends and projected.
class Slide {
 public:
  Slide(const Wall& wall, const spline::BsplineSurface& patch, std::size_t chain)
      : wall_(wall), patch_(patch), isEast_(chain == 0) {}

  [[nodiscard]] CurvePoint at(double t) const {
    CurvePoint p = border(t);
    for (const bool atEnd : {false, true}) {
      const double s = atEnd ? 1.0 - t : t, rate = atEnd ? -1.0 : 1.0;
      const double r = 1.0 - s, cube = r * r * r;
      // s (1 - s)^3 and s^2 (1 - s)^3 / 2: the one turns the end, the other bends it.
      p.point += s * cube * turn_[atEnd] + 0.5 * s * s * cube * bend_[atEnd];
      p.derivative += rate * (r * r * (r - 3.0 * s) * turn_[atEnd] +
                              0.5 * s * r * r * (2.0 * r - 3.0 * s) * bend_[atEnd]);
    }
    const Foot foot = wall_.footOf(p.point);
    return {foot.point, foot.step * p.derivative};
  }
  /// Makes the curve leave a corner as the side there asks.
  void fitTo(const BoundarySide& side, bool atEnd) {
    const double t = atEnd ? 1.0 : 0.0, corner = atEnd ? 0.0 : 1.0;
    if (!side.isTangent()) return;
    const boundary::SupportSample support = side.ribbon.support(corner);
    if (support.singular) return;
    const CurvePoint own = at(t);
    const Foot foot = wall_.footOf(own.point);
    const Vector3d line = support.normal.cross(foot.normal);
    if (line.norm() < kSameNormal) return;
    const Vector3d along = line.normalized() * line.normalized().dot(own.derivative);
    turn_[atEnd] = (atEnd ? -1.0 : 1.0) * (along - border(t).derivative);
    if (side.continuity != Continuity::G2) return;
    const Vector3d up = support.normal - foot.normal * foot.normal.dot(support.normal);
    const double wanted = along.dot(support.secondForm * along);
    bend_[atEnd] = up * ((wanted - second(atEnd).dot(support.normal)) / up.dot(support.normal));
  }

 private:
  /// In the direction of the loop: East upwards, West downwards.
  [[nodiscard]] CurvePoint border(double t) const {
    const double height = patch_.v.last() - patch_.v.first();
    const double u = isEast_ ? patch_.u.last() : patch_.u.first();
    const double v = patch_.v.first() + height * (isEast_ ? t : 1.0 - t);
    return {patch_.evaluate(u, v), (isEast_ ? height : -height) * patch_.evaluate(u, v, 0, 1)};
  }
  /// The second derivative at an end, from first ones.
  [[nodiscard]] Vector3d second(bool atEnd) const {
    const double t = atEnd ? 1.0 : 0.0, h = atEnd ? -kDifference : kDifference;
    return (-3.0 * at(t).derivative + 4.0 * at(t + h).derivative - at(t + 2.0 * h).derivative) /
           (2.0 * h);
  }

  const Wall& wall_;
  const spline::BsplineSurface& patch_;
  bool isEast_;
  std::array<Vector3d, 2> turn_{Vector3d::Zero(), Vector3d::Zero()};
  std::array<Vector3d, 2> bend_{Vector3d::Zero(), Vector3d::Zero()};
};

/// EndLeavesFace where the end passes the face's border.
std::optional<Error> leavesFace(const Wall& wall, int face, const Slide& slide, double diagonal) {
  Error error{.code = ErrorCode::EndLeavesFace, .face = face};
  for (int k = 0; k <= kSamples; ++k) {
    const Vector3d point = slide.at(double(k) / kSamples).point;
    const double beyond = wall.beyond(point);
    if (beyond <= std::max(error.value, boundary::kLargestCornerGap * diagonal)) continue;
    error.value = beyond;
    error.where = point;
  }
  return error.where ? std::optional(error) : std::nullopt;
}

BoundarySide sideAlong(const spline::BsplineCurve& curve, int face) {
  BoundarySide side;
  side.face = face;
  side.continuity = Continuity::G0;
  side.ribbon.polynomial = curve;
  side.ribbon.curve = [curve](double t) {
    return boundary::CurveSample{curve.evaluate(t), curve.evaluate(t, 1)};
  };
  return side;
}

}  // namespace

Result<BoundarySide> slidingEnd(const ShapeIndex& index,
                                int face,
                                const ChainPair& pair,
                                std::size_t chain,
                                const std::vector<spline::BsplineSurface>& patches) {
  return guarded([&]() -> Result<BoundarySide> {
    const bool isFirst = chain == 0;
    const auto& sides = pair.sides.sides;
    const double diagonal = pair.sides.diagonal;
    const spline::BsplineSurface& patch = isFirst ? patches.back() : patches.front();
    const Wall wall(index.face(face));
    Slide slide(wall, patch, chain);
    slide.fitTo(isFirst ? sides[pair.firstCount - 1] : sides[pair.secondEnd() - 1], false);
    slide.fitTo(isFirst ? sides[pair.secondStart()] : sides[0], true);
    if (const auto leaves = leavesFace(wall, face, slide, diagonal)) return fail(*leaves);
    const auto given = [&](double t) { return slide.at(t); };
    const spline::KnotVector own = patch.v.mapped(0.0, 1.0);
    const auto knots = spline::knotsThatFit(
        {given}, isFirst ? own : own.reversed(), kFit * diagonal, layout::kMostPolesOfOne);
    const spline::CurveFit fit = spline::fitCurve(given, knots);
    if (fit.error() > boundary::kLargestCornerGap * diagonal)
      return fail({.code = ErrorCode::CurveNotFitted, .face = face, .value = fit.error()});
    return sideAlong(fit.curve, face);
  });
}

}  // namespace fairing::occt
