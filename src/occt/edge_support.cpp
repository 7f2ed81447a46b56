// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/edge_support.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
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

/// First distance from a singular point at which the limit is taken, in units of the face's domain.
constexpr double kLimitStep = 1e-3;
/// Largest turn of the normal (radians) over the last halving of that distance for a limit to
/// exist.
constexpr double kLimitTurn = 0.01;
constexpr int kLandmarks = 64;
/// The foot stays near the pcurve by itself; surfaces go on a little beyond their domain.
const DomainBox kEverywhere(Vector2d::Constant(-1e100), Vector2d::Constant(1e100));

SupportSample noSupport(const Vector3d& point) {
  return {.point = point, .normal = Vector3d::Zero(), .singular = true};
}

}  // namespace

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
  isoIsV_ = runsAlongU();
  if (match == EdgeMatch::Twin) {
    for (int i = 0; i <= kLandmarks; ++i) {
      const double t = pcurveFirst_ + (pcurveLast_ - pcurveFirst_) * i / kLandmarks;
      const gp_Pnt2d uv = pcurve_.Value(t);
      landmarks_.push_back({t, fromOcct(surface_.Value(uv.X(), uv.Y()))});
    }
  }
}

/// Whether the edge as a whole runs more along u than along v, by lengths in space.
bool EdgeSupport::runsAlongU() const {
  constexpr int kSamples = 9;
  double alongU = 0.0, alongV = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double share = (i + 0.5) / kSamples;
    gp_Pnt2d uv;
    gp_Vec2d d;
    pcurve_.D1(pcurveFirst_ + (pcurveLast_ - pcurveFirst_) * share, uv, d);
    const SurfacePoint at = evaluate(surface_, uv.X(), uv.Y());
    alongU += std::abs(d.X()) * at.su.norm();
    alongV += std::abs(d.Y()) * at.sv.norm();
  }
  return alongU >= alongV;
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

SupportSample EdgeSupport::sample(const SurfacePoint& at) const {
  SupportSample result{.point = at.point};
  result.normal = normalSign_ * at.cross().normalized();
  result.secondForm = at.secondForm(result.normal);
  result.iso = (isoIsV_ ? at.sv : at.su).normalized();
  return result;
}

SupportSample EdgeSupport::limit(double parameter, const SurfacePoint& foot) const {
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
    const Vector2d at = Vector2d(foot.u, foot.v) + step * range.cwiseProduct(direction);
    const SurfacePoint near = evaluate(surface_, at.x(), at.y());
    if (!near.isRegular()) return std::nullopt;
    return sample(near);
  };
  for (const Vector2d& direction : {Vector2d((along + inside).normalized()), inside, along}) {
    const auto far = normalAt(direction, kLimitStep);
    const auto near = normalAt(direction, kLimitStep / 2);
    if (!far || !near || (far->normal - near->normal).norm() > kLimitTurn) continue;
    SupportSample result = *near;
    result.point = foot.point;
    result.isLimit = true;
    result.normal = (2.0 * near->normal - far->normal).normalized();
    return result;
  }
  return noSupport(foot.point);
}

SupportSample EdgeSupport::at(double parameter, const Vector3d& point) const {
  try {
    const gp_Pnt2d uv = start(parameter, point);
    SurfacePoint foot = evaluate(surface_, uv.X(), uv.Y());
    if ((foot.point - point).norm() > Precision::Confusion())
      foot = footFrom(surface_, point, foot, kEverywhere);
    if (!foot.point.allFinite()) return noSupport(point);
    return foot.isRegular() ? sample(foot) : limit(parameter, foot);
  } catch (const Standard_Failure&) {
    return noSupport(point);
  }
}

}  // namespace fairing::occt
