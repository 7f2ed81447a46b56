// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/face_projector.h"

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Eigen/Eigenvalues>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kBorderSamples = 96;
constexpr int kGrid = 24;   ///< inner samples a direction
constexpr int kStarts = 3;  ///< inner samples that are refined
constexpr int kBorderSteps = 20;
/// Shares of the way to the middle of the domain at which a normal is looked for where the surface
/// has none.
constexpr std::array kNudges{1e-6, 1e-5, 1e-4, 1e-3};
/// Feet of several faces this close, as a share of the faces' size, are one place on their border.
constexpr double kSamePlace = 1e-6;
/// Sine of the angle from the normals beyond which a point lies not above its foot.
constexpr double kAside = 0.01;

}  // namespace

FaceProjector::FaceProjector(const TopoDS_Face& face) : surface_(face, false) {
  normalSign_ = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  domain_ = DomainBox(Vector2d(u0, v0), Vector2d(u1, v1));
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  trim_ = std::make_unique<BRepTopAdaptor_FClass2d>(forward, 1e-9 * domain_.sizes().maxCoeff());
  sampleBorders(forward);
  sampleInside();
}

void FaceProjector::sampleBorders(const TopoDS_Face& forward) {
  for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
    Border border;
    const auto pcurve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), forward, border.first, border.last);
    if (pcurve.IsNull()) continue;
    border.pcurve.Load(pcurve);
    for (int i = 0; i <= kBorderSamples; ++i) {
      const double t = border.first + (border.last - border.first) * i / kBorderSamples;
      const gp_Pnt2d uv = pcurve->Value(t);
      border.samples.push_back({t, fromOcct(surface_.Value(uv.X(), uv.Y()))});
    }
    borders_.push_back(std::move(border));
  }
}

void FaceProjector::sampleInside() {
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vector2d share((i + 0.5) / kGrid, (j + 0.5) / kGrid);
      const Vector2d uv = domain_.min() + domain_.sizes().cwiseProduct(share);
      if (trim_->Perform(gp_Pnt2d(uv.x(), uv.y()), false) == TopAbs_OUT) continue;
      inside_.push_back({uv.x(), uv.y(), fromOcct(surface_.Value(uv.x(), uv.y()))});
    }
  }
}

SurfacePoint FaceProjector::onBorder(const Border& border, double parameter) const {
  const gp_Pnt2d uv = border.pcurve.Value(parameter);
  return evaluate(surface_, uv.X(), uv.Y());
}

SurfacePoint FaceProjector::footOnBorder(const Border& border, const Vector3d& target) const {
  const auto nearest =
      std::min_element(border.samples.begin(),
                       border.samples.end(),
                       [&](const BorderSample& a, const BorderSample& b) {
                         return (a.point - target).squaredNorm() < (b.point - target).squaredNorm();
                       });
  double t = nearest->parameter;
  SurfacePoint best = onBorder(border, t);
  for (int i = 0; i < kBorderSteps; ++i) {
    gp_Pnt2d uv;
    gp_Vec2d d;
    border.pcurve.D1(t, uv, d);
    const Vector3d tangent = best.su * d.X() + best.sv * d.Y();
    const double distance = (best.point - target).norm();
    if (!(tangent.squaredNorm() > 0.0)) break;
    double step = -(best.point - target).dot(tangent) / tangent.squaredNorm();
    bool nearer = false;
    for (int h = 0; h < 8 && !nearer; ++h, step *= 0.5) {
      const double to = std::clamp(t + step, border.first, border.last);
      const SurfacePoint next = onBorder(border, to);
      nearer = (next.point - target).norm() < distance;
      if (nearer) {
        t = to;
        best = next;
      }
    }
    if (!nearer || distance - (best.point - target).norm() <= 1e-15 * (1.0 + distance)) break;
  }
  return best;
}

bool FaceProjector::isInside(const SurfacePoint& foot) const {
  return trim_->Perform(gp_Pnt2d(foot.u, foot.v), false) != TopAbs_OUT;
}

Vector3d FaceProjector::normalAt(const SurfacePoint& foot) const {
  if (foot.isRegular()) return normalSign_ * foot.cross().normalized();
  for (const double share : kNudges) {
    const Vector2d uv =
        Vector2d(foot.u, foot.v) + share * (domain_.center() - Vector2d(foot.u, foot.v));
    const SurfacePoint near = evaluate(surface_, uv.x(), uv.y());
    if (near.isRegular()) return normalSign_ * near.cross().normalized();
  }
  return Vector3d::Zero();
}

bool FaceProjector::contains(const FaceFoot& foot, const Vector3d& step) const {
  if (!foot.at.isRegular()) return false;
  const Vector2d there = Vector2d(foot.at.u, foot.at.v) + foot.at.parametersOf(step);
  return trim_->Perform(gp_Pnt2d(there.x(), there.y()), false) != TopAbs_OUT;
}

FaceFoot FaceProjector::nearest(const Vector3d& target) const {
  FaceFoot best{.distance = std::numeric_limits<double>::infinity(), .face = this, .at = {}};
  const auto take = [&](const SurfacePoint& foot) {
    const double distance = (foot.point - target).norm();
    if (distance < best.distance) best = {.distance = distance, .face = this, .at = foot};
  };
  for (const Border& border : borders_) take(footOnBorder(border, target));

  const auto refine = [&](double u, double v) {
    const SurfacePoint foot = footFrom(surface_, target, evaluate(surface_, u, v), domain_);
    if ((foot.point - target).norm() < best.distance && isInside(foot)) take(foot);
  };
  if (!borders_.empty()) refine(best.at.u, best.at.v);
  std::array<const InnerSample*, kStarts> starts{};
  for (const InnerSample& sample : inside_) {
    const InnerSample* candidate = &sample;
    for (const InnerSample*& kept : starts) {
      if (kept == nullptr ||
          (candidate->point - target).squaredNorm() < (kept->point - target).squaredNorm()) {
        std::swap(candidate, kept);
        if (candidate == nullptr) break;
      }
    }
  }
  for (const InnerSample* start : starts) {
    if (start != nullptr) refine(start->u, start->v);
  }
  best.normal = normalAt(best.at);
  return best;
}

FacesProjector::FacesProjector(const TopoDS_Shape& faces) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(faces, TopAbs_FACE, map);
  for (int i = 1; i <= map.Extent(); ++i) projectors_.emplace_back(TopoDS::Face(map(i)));
  Bnd_Box box;
  BRepBndLib::Add(faces, box, false);
  if (!box.IsVoid()) size_ = std::sqrt(box.SquareExtent());
}

FaceFoot FacesProjector::nearest(const Vector3d& target) const {
  FaceFoot best{.distance = std::numeric_limits<double>::infinity(), .at = {}};
  std::vector<FaceFoot> feet;
  for (const FaceProjector& projector : projectors_) {
    feet.push_back(projector.nearest(target));
    if (feet.back().distance < best.distance) best = feet.back();
  }
  // Faces that meet at the foot cover what their normals span there.
  const double same = kSamePlace * size_;
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  for (const FaceFoot& foot : feet)
    if ((foot.at.point - best.at.point).norm() <= same)
      normals += foot.normal * foot.normal.transpose();
  const Vector3d away = target - best.at.point;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(normals);
  Vector3d aside = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (axes.eigenvalues()[k] < kAside * kAside)
      aside += away.dot(axes.eigenvectors().col(k)) * axes.eigenvectors().col(k);
  best.beside = aside.norm() > std::max(same, kAside * away.norm());
  return best;
}

}  // namespace fairing::occt
