// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/edit_face.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <memory>

#include "occt/check_shape.h"
#include "occt/convert_face.h"
#include "occt/guarded.h"
#include "occt/join.h"

namespace fairing::occt {
namespace {

using Eigen::Vector2d;

constexpr int kBorderSamples = 400;  // of an edge
/// A border this close to the bounds of the surface, as a share of them, lies on the bounds.
constexpr double kOnBound = 1e-9;

std::vector<Vector2d> borderOf(const TopoDS_Face& face) {
  std::vector<Vector2d> places;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first, last;
    const auto curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, first, last);
    if (curve.IsNull()) continue;
    for (int k = 0; k <= kBorderSamples; ++k) {
      const gp_Pnt2d at = curve->Value(first + (last - first) * k / kBorderSamples);
      places.emplace_back(at.X(), at.Y());
    }
  }
  return places;
}

bool isOnBounds(const Vector2d& at, const spline::BsplineSurface& surface) {
  const auto near = [](double t, const spline::KnotVector& knots) {
    const double close = kOnBound * (knots.last() - knots.first());
    return t <= knots.first() + close || t >= knots.last() - close;
  };
  return near(at[0], surface.u) || near(at[1], surface.v);
}

/// Whether rectangles of the parameters lie on the face.
class Trim {
 public:
  Trim(const TopoDS_Face& face, std::vector<Vector2d> inner, double resolution)
      : inner_(std::move(inner)),
        classifier_(std::make_shared<BRepTopAdaptor_FClass2d>(face, resolution)) {}

  bool operator()(double u0, double u1, double v0, double v1) const {
    const auto isOut = [&](double u, double v) {
      return classifier_->Perform(gp_Pnt2d(u, v), false) == TopAbs_OUT;
    };
    if (isOut(u0, v0) || isOut(u0, v1) || isOut(u1, v0) || isOut(u1, v1)) return false;
    return std::none_of(inner_.begin(), inner_.end(), [&](const Vector2d& at) {
      return at[0] >= u0 && at[0] <= u1 && at[1] >= v0 && at[1] <= v1;
    });
  }

 private:
  std::vector<Vector2d> inner_;  // the border where it is not the surface's own
  std::shared_ptr<BRepTopAdaptor_FClass2d> classifier_;
};

EditRegion regionOf(const TopoDS_Face& face, const spline::BsplineSurface& surface) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  EditRegion region;
  region.border = borderOf(forward);
  std::vector<Vector2d> inner;
  for (const Vector2d& at : region.border)
    if (!isOnBounds(at, surface)) inner.push_back(at);
  if (inner.empty()) return {};
  const double range =
      std::max(surface.u.last() - surface.u.first(), surface.v.last() - surface.v.first());
  region.contains = Trim(forward, std::move(inner), kOnBound * range);
  return region;
}

}  // namespace

Result<FaceEdit> FaceEdit::make(const ShapeIndex& index, int number, const EditOptions& options) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  if (!index.hasFace(number))
    return fail({.code = ErrorCode::FaceOutOfRange,
                 .face = number,
                 .value = static_cast<double>(index.faceCount())});
  return guarded([&]() -> Result<FaceEdit> {
    const TopoDS_Face& face = index.face(number);
    const ConvertedSurface old = convertSurface(face);
    const EditRegion region = regionOf(face, old.surface);
    auto edit = SurfaceEdit::make(old.surface, options, region);
    if (!edit) {
      edit.error().face = number;
      return fail(edit.error());
    }
    return FaceEdit(
        number, face, static_cast<bool>(region.contains), old.deviation, std::move(*edit));
  });
}

Result<ShapeEdit> FaceEdit::under(const energy::Guidance& guidance, bool lookUp) {
  guidance_ = guidance;
  return guarded([&] { return faced(edit_.under(guidance, lookUp)); });
}

Result<ShapeEdit> FaceEdit::settled(const energy::Guidance& guidance, Progress* progress) {
  guidance_ = guidance;
  return guarded([&] { return faced(edit_.settled(guidance, progress)); });
}

Result<ShapeEdit> FaceEdit::faced(Result<EditResult> edit) const {
  if (!edit) {
    edit.error().face = number_;
    return fail(edit.error());
  }
  if (deviation_ > 0.0)
    edit->report.notes.push_back(
        {.code = analysis::NoteCode::FaceConverted, .value = deviation_, .face = number_});
  const TopoDS_Face made = onSurface(face_, edit->surface, deviation_);
  if (const auto error = checkShape(made)) return fail(*error);
  return ShapeEdit{made, made, std::move(*edit), trimmed_};
}

Result<ShapeEdit> editFace(const ShapeIndex& index,
                           int number,
                           const EditOptions& options,
                           ResultMode mode,
                           Progress* progress) {
  auto made = FaceEdit::make(index, number, options);
  if (!made) return fail(made.error());
  const auto live = std::make_shared<FaceEdit>(std::move(*made));
  auto edit = live->settled(options.guidance, progress);
  if (!edit) return edit;
  const double gap = edit->edit.report.borderMove + live->deviation();
  auto shape = joinResult(index, {number}, {{edit->face, {}, gap}}, mode);
  if (!shape) return fail(shape.error());
  edit->shape = std::move(*shape);
  edit->live = live;
  return edit;
}

Result<ShapeEdit> guiding(const ShapeEdit& before, const energy::Guidance& guidance, bool lookUp) {
  auto edit = before.live->under(guidance, lookUp);
  if (edit) edit->live = before.live;
  return edit;
}

}  // namespace fairing::occt
