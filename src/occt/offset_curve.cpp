// SPDX-License-Identifier: LGPL-2.1-or-later
// Notation: S(u, v) the surface, w = (u, v), a geodesic S(w(l)) by its length l has no acceleration
// in the tangent plane:
//   w'' = -I^-1 (Su . a, Sv . a),   a = Suu u'^2 + 2 Suv u' v' + Svv v'^2      [DoCarmo1976] 4-4
#include "occt/offset_curve.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/bisect.h"
#include "occt/face_curve.h"

namespace fairing::occt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kPlaces = 65;    // along the edge
constexpr int kSteps = 48;     // along a geodesic
constexpr int kHalvings = 16;  // of the step that leaves the face
constexpr double kSameParameter = 1e-9;

// How far a geodesic got, and whether it was inside the face all along.
struct Reached {
  Vector2d at;
  double inside = 0.0;  // mm from the edge
  bool all = false;
};

class Offset {
 public:
  explicit Offset(const OffsetRequest& request) : request_(request), face_(request.face) {
    pcurve_ = BRep_Tool::CurveOnSurface(request.use, request.face, first_, last_);
    if (pcurve_.IsNull()) throw Standard_Failure("an edge has no curve on its face");
    const bool faceReversed = request.face.Orientation() == TopAbs_REVERSED;
    const bool edgeReversed = request.use.Orientation() == TopAbs_REVERSED;
    insideSign_ = faceReversed == edgeReversed ? 1.0 : -1.0;
  }

  // The geodesic from the place s in [0, 1] of the edge.
  [[nodiscard]] Reached from(double s) const {
    gp_Pnt2d uv;
    gp_Vec2d d;
    pcurve_->D1(first_ + s * (last_ - first_), uv, d);
    State state{{uv.X(), uv.Y()}, {}};
    const SurfacePoint start = at(state.w);
    const Vector3d along = d.X() * start.su + d.Y() * start.sv;
    state.dw = start.parametersOf(insideSign_ * start.cross().cross(along).normalized());
    const double step = request_.distance / kSteps;
    Reached reached;
    bool inside = true;
    for (int k = 1; k <= kSteps; ++k) {
      const State next = advanced(state, step);
      if (inside) reached.inside += face_.isInside(next.w) ? step : insidePart(state, step);
      inside = inside && face_.isInside(next.w);
      state = next;
    }
    reached.at = state.w;
    reached.all = inside;
    return reached;
  }
  [[nodiscard]] SurfacePoint at(const Vector2d& w) const { return face_.at(w); }
  [[nodiscard]] const FaceDomain& face() const { return face_; }

 private:
  struct State {
    Vector2d w, dw;
  };
  [[nodiscard]] State rate(const State& s) const {
    const SurfacePoint p = at(s.w);
    const double u = s.dw.x(), v = s.dw.y();
    return {s.dw, -p.parametersOf(u * u * p.suu + 2.0 * u * v * p.suv + v * v * p.svv)};
  }
  // One step of the classical Runge-Kutta method.
  [[nodiscard]] State advanced(const State& s, double h) const {
    const auto moved = [&](const State& r, double x) {
      return State{s.w + x * r.w, s.dw + x * r.dw};
    };
    const State a = rate(s), b = rate(moved(a, 0.5 * h)), c = rate(moved(b, 0.5 * h)),
                d = rate(moved(c, h));
    return {s.w + h / 6.0 * (a.w + 2.0 * b.w + 2.0 * c.w + d.w),
            s.dw + h / 6.0 * (a.dw + 2.0 * b.dw + 2.0 * c.dw + d.dw)};
  }
  // How far a step goes within the face that it leaves.
  [[nodiscard]] double insidePart(const State& from, double step) const {
    return bisect(
        0.0, step, kHalvings, [&](double h) { return face_.isInside(advanced(from, h).w); });
  }

  const OffsetRequest& request_;
  FaceDomain face_;
  Handle(Geom2d_Curve) pcurve_;
  double first_ = 0.0, last_ = 1.0, insideSign_ = 1.0;
};

// A curve of a surface that does not go on beyond its knots ends there.
TopoDS_Edge edgeOn(const Handle(Geom_Curve) & curve, double from, double to) {
  double first = std::min(from, to), last = std::max(from, to);
  if (!curve->IsPeriodic()) {
    first = std::max(first, curve->FirstParameter());
    last = std::min(last, curve->LastParameter());
  }
  BRepBuilderAPI_MakeEdge make(curve, first, last);
  if (!make.IsDone()) throw Standard_Failure("the curve of a setback makes no edge");
  return make.Edge();
}

// The offset where it is an iso-curve of the surface.
std::optional<TopoDS_Edge> isoEdge(const TopoDS_Face& face, const std::vector<Vector2d>& places) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const Vector2d first = places.front(), last = places.back();
  for (const int fixed : {0, 1}) {
    const double size = std::max(1.0, std::abs(first[fixed]));
    const bool isIso = std::all_of(places.begin(), places.end(), [&](const Vector2d& w) {
      return std::abs(w[fixed] - first[fixed]) <= kSameParameter * size;
    });
    const int free = 1 - fixed;
    if (!isIso || first[free] == last[free]) continue;
    const Handle(Geom_Curve) curve = fixed == 0 ? surface->UIso(first[0]) : surface->VIso(first[1]);
    return edgeOn(curve, first[free], last[free]);
  }
  return std::nullopt;
}

// Any other one, between two places of the edge.
TopoDS_Edge fittedEdge(const Offset& offset, double from, double to) {
  return edgeThrough(
      [&](double t) { return offset.at(offset.from(from + t * (to - from)).at).point; });
}

// The places between which the offset lies inside the face, and one beyond on either side.
struct Range {
  int first = 0, last = kPlaces - 1;
};

Result<Range> insideRange(const std::vector<Reached>& reached, const OffsetRequest& request) {
  const auto inside = [](const Reached& r) { return r.all; };
  const auto less = [](const Reached& a, const Reached& b) { return a.inside < b.inside; };
  const bool joined = request.ends[0] == EdgeEnd::Joined && request.ends[1] == EdgeEnd::Joined;
  if (joined && !std::all_of(reached.begin(), reached.end(), inside))
    return fail({.code = ErrorCode::SetbackTooLarge,
                 .value = std::min_element(reached.begin(), reached.end(), less)->inside});
  const auto first = std::find_if(reached.begin(), reached.end(), inside);
  if (first == reached.end())
    return fail({.code = ErrorCode::SetbackTooLarge,
                 .value = std::max_element(reached.begin(), reached.end(), less)->inside});
  const auto last = std::find_if(reached.rbegin(), reached.rend(), inside).base() - 1;
  return Range{std::max(0, int(first - reached.begin()) - 1),
               std::min(kPlaces - 1, int(last - reached.begin()) + 1)};
}

}  // namespace

Result<std::vector<TopoDS_Edge>> offsetOnFace(const OffsetRequest& request) {
  const Offset offset(request);
  const auto share = [](int place) { return double(place) / (kPlaces - 1); };
  std::vector<Reached> reached;
  for (int k = 0; k < kPlaces; ++k) reached.push_back(offset.from(share(k)));
  const auto range = insideRange(reached, request);
  if (!range) return fail(range.error());
  std::vector<Vector2d> places;
  for (int k = range->first; k <= range->last; ++k) places.push_back(reached[std::size_t(k)].at);
  std::vector<TopoDS_Edge> edges;
  if (const auto iso = isoEdge(request.face, places))
    edges.push_back(*iso);
  else
    edges.push_back(fittedEdge(offset, share(range->first), share(range->last)));
  double length = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k)
    length += (offset.at(places[k]).point - offset.at(places[k - 1]).point).norm();
  const auto goOn = [&](const Vector2d& end, const Vector2d& before) {
    if (offset.face().state(end) != TopAbs_IN) return;
    if (const auto way = straightOut(offset.face(), end, before, length))
      edges.push_back(way->edge);
  };
  if (request.ends[0] == EdgeEnd::Open) goOn(places.front(), places[1]);
  if (request.ends[1] == EdgeEnd::Open) goOn(places.back(), places[places.size() - 2]);
  return edges;
}

}  // namespace fairing::occt
