// SPDX-License-Identifier: LGPL-2.1-or-later
// Notation: S(u, v) the support surface, n its unit normal with the face's orientation,
//   I  = (Su.Su  Su.Sv; Su.Sv  Sv.Sv)   first fundamental form, J = (Su Sv), 3 x 2
//   II = (Suu.n  Suv.n; Suv.n  Svv.n)   second fundamental form
// As a form in space: J I^-1 II I^-1 J', so that tangent vectors may be put in as they are.
#include "occt/edge_support.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <optional>

#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using boundary::SupportSample;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Below this sine between Su and Sv a normal has lost half its digits.
constexpr double kSingularSine = 1e-7;
/// One partial derivative this much shorter than the other (in lengths over the face's domain) is a
/// pole of the surface.
constexpr double kSingularRatio = 1e-7;
/// First distance from a singular point at which the limit is taken, in units of the face's domain.
constexpr double kLimitStep = 1e-3;
/// Largest turn of the normal (radians) over the last halving of that distance for a limit to
/// exist.
constexpr double kLimitTurn = 0.01;
constexpr int kLandmarks = 64;
constexpr int kNewtonSteps = 12;

SupportSample noSupport(const Vector3d& point) {
  return {.point = point, .normal = Vector3d::Zero(), .singular = true};
}

}  // namespace

struct EdgeSupport::Jet {
  double u, v;
  Vector3d point, su, sv, suu, suv, svv;

  [[nodiscard]] Vector3d cross() const { return su.cross(sv); }
  [[nodiscard]] bool regular(double uRange, double vRange) const {
    const double a = su.norm() * uRange;
    const double b = sv.norm() * vRange;
    const double sine = cross().norm() / (su.norm() * sv.norm());
    return std::min(a, b) > kSingularRatio * std::max(a, b) && sine > kSingularSine;
  }
};

EdgeSupport::EdgeSupport(const TopoDS_Face& face,
                         const TopoDS_Edge& use,
                         EdgeMatch match,
                         NormalSense sense)
    : surface_(face, false), face_(face) {
  BRep_Tool::Range(use, edgeFirst_, edgeLast_);
  const Handle(Geom2d_Curve) pcurve =
      BRep_Tool::CurveOnSurface(use, face, pcurveFirst_, pcurveLast_);
  if (pcurve.IsNull()) throw Standard_Failure("an edge has no curve on its face");
  pcurve_.Load(pcurve);
  const bool faceReversed = face.Orientation() == TopAbs_REVERSED;
  const bool edgeReversed = use.Orientation() == TopAbs_REVERSED;
  normalSign_ = (faceReversed == (sense == NormalSense::Turned)) ? 1.0 : -1.0;
  insideSign_ = faceReversed == edgeReversed ? 1.0 : -1.0;
  if (match == EdgeMatch::Twin) {
    for (int i = 0; i <= kLandmarks; ++i) {
      const double t = pcurveFirst_ + (pcurveLast_ - pcurveFirst_) * i / kLandmarks;
      const gp_Pnt2d uv = pcurve_.Value(t);
      landmarks_.push_back({t, fromOcct(surface_.Value(uv.X(), uv.Y()))});
    }
  } else if (BRep_Tool::SameParameter(use)) {
    trust_ = BRep_Tool::Tolerance(use);
  }
}

EdgeSupport::Jet EdgeSupport::evaluate(double u, double v) const {
  gp_Pnt p;
  gp_Vec su, sv, suu, svv, suv;
  surface_.D2(u, v, p, su, sv, suu, svv, suv);
  return {
      u, v, fromOcct(p), fromOcct(su), fromOcct(sv), fromOcct(suu), fromOcct(suv), fromOcct(svv)};
}

gp_Pnt2d EdgeSupport::start(double parameter, const Vector3d& point) const {
  if (landmarks_.empty()) {
    const double share = (parameter - edgeFirst_) / (edgeLast_ - edgeFirst_);
    return pcurve_.Value(pcurveFirst_ + (pcurveLast_ - pcurveFirst_) * share);
  }
  const auto nearest = std::min_element(
      landmarks_.begin(), landmarks_.end(), [&](const Landmark& a, const Landmark& b) {
        return (a.point - point).squaredNorm() < (b.point - point).squaredNorm();
      });
  return pcurve_.Value(nearest->parameter);
}

EdgeSupport::Jet EdgeSupport::project(const Vector3d& point, Jet jet) const {
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vector3d r = jet.point - point;
    const Vector2d gradient(r.dot(jet.su), r.dot(jet.sv));
    Eigen::Matrix2d first;
    first << jet.su.dot(jet.su), jet.su.dot(jet.sv), jet.su.dot(jet.sv), jet.sv.dot(jet.sv);
    Eigen::Matrix2d hessian = first;
    hessian(0, 0) += r.dot(jet.suu);
    hessian(1, 1) += r.dot(jet.svv);
    hessian(0, 1) += r.dot(jet.suv);
    hessian(1, 0) = hessian(0, 1);
    if (!(hessian(0, 0) > 0.0 && hessian.determinant() > 0.5 * first.determinant()))
      hessian = first;
    if (!(hessian.determinant() > 0.0)) break;
    const Vector2d step = hessian.inverse() * gradient;
    const Jet next = evaluate(jet.u - step.x(), jet.v - step.y());
    if (!((next.point - point).norm() < r.norm())) break;
    const double moved = (next.point - jet.point).norm();
    jet = next;
    if (moved <= 1e-14 * (1.0 + point.norm())) break;
  }
  return jet;
}

SupportSample EdgeSupport::sample(const Jet& jet) const {
  SupportSample result{.point = jet.point};
  result.normal = normalSign_ * jet.cross().normalized();
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << jet.su, jet.sv;
  Eigen::Matrix2d second;
  second << jet.suu.dot(result.normal), jet.suv.dot(result.normal), jet.suv.dot(result.normal),
      jet.svv.dot(result.normal);
  const Eigen::Matrix<double, 3, 2> dual = tangents * (tangents.transpose() * tangents).inverse();
  result.secondForm = dual * second * dual.transpose();
  return result;
}

SupportSample EdgeSupport::limit(double parameter, const Jet& jet) const {
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face_, u0, u1, v0, v1);
  const Vector2d range(u1 - u0, v1 - v0);
  gp_Pnt2d uv;
  gp_Vec2d d;
  const double share = (parameter - edgeFirst_) / (edgeLast_ - edgeFirst_);
  pcurve_.D1(pcurveFirst_ + (pcurveLast_ - pcurveFirst_) * share, uv, d);
  Vector2d along = Vector2d(d.X(), d.Y()).cwiseQuotient(range).normalized();
  const Vector2d inside = insideSign_ * Vector2d(-along.y(), along.x());
  if (share > 0.5) along = -along;

  const auto normalAt = [&](const Vector2d& direction,
                            double step) -> std::optional<SupportSample> {
    const Vector2d at = Vector2d(jet.u, jet.v) + step * range.cwiseProduct(direction);
    const Jet near = evaluate(at.x(), at.y());
    if (!near.regular(range.x(), range.y())) return std::nullopt;
    return sample(near);
  };
  for (const Vector2d& direction : {Vector2d((along + inside).normalized()), inside, along}) {
    const auto far = normalAt(direction, kLimitStep);
    const auto near = normalAt(direction, kLimitStep / 2);
    if (!far || !near || (far->normal - near->normal).norm() > kLimitTurn) continue;
    SupportSample result = *near;
    result.point = jet.point;
    result.normal = (2.0 * near->normal - far->normal).normalized();
    return result;
  }
  return noSupport(jet.point);
}

SupportSample EdgeSupport::at(double parameter, const Vector3d& point) const {
  try {
    const gp_Pnt2d uv = start(parameter, point);
    Jet jet = evaluate(uv.X(), uv.Y());
    if ((jet.point - point).norm() > trust_) jet = project(point, jet);
    if (!jet.point.allFinite()) return noSupport(point);
    const double uRange = surface_.LastUParameter() - surface_.FirstUParameter();
    const double vRange = surface_.LastVParameter() - surface_.FirstVParameter();
    return jet.regular(std::min(uRange, 1.0), std::min(vRange, 1.0)) ? sample(jet)
                                                                     : limit(parameter, jet);
  } catch (const Standard_Failure&) {
    return noSupport(point);
  }
}

}  // namespace fairing::occt
