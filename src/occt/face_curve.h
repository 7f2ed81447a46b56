// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <optional>
#include <vector>

#include "core/boundary/ribbon.h"
#include "occt/surface_point.h"

/// New curves on a face, as edges that a face can be split along.
namespace fairing::occt {

/// The surface of a face and its trim, in the surface's parameters w = (u, v). Not to be used by
/// two threads at once.
class FaceDomain {
 public:
  explicit FaceDomain(const TopoDS_Face& face);

  [[nodiscard]] const BRepAdaptor_Surface& surface() const { return surface_; }
  [[nodiscard]] SurfacePoint at(const Eigen::Vector2d& w) const;
  [[nodiscard]] TopAbs_State state(const Eigen::Vector2d& w) const;
  /// Inside the trim, or on its border.
  [[nodiscard]] bool isInside(const Eigen::Vector2d& w) const { return state(w) != TopAbs_OUT; }

 private:
  BRepAdaptor_Surface surface_;
  BRepTopAdaptor_FClass2d trim_;
};

/// An edge that follows points over [0, 1], as smooth as they are but for `breaks`, within 2e-8 mm;
/// where it needs too many control points for that, its tolerance says what is left. What is closed
/// stays closed.
[[nodiscard]] TopoDS_Edge edgeThrough(const std::function<Eigen::Vector3d(double)>& pointAt,
                                      const std::vector<boundary::CurveBreak>& breaks = {});

/// A straight line in the parameters, from a place inside a face until it has left it.
struct WayOut {
  TopoDS_Edge edge;     ///< a step longer than that
  double length = 0.0;  ///< mm to the face's border
};

/// The way out from `end` in the direction that leads there from `before`, in steps of 2 % of
/// `size` mm; nothing where ten times that size is not enough.
[[nodiscard]] std::optional<WayOut> straightOut(const FaceDomain& face,
                                                const Eigen::Vector2d& end,
                                                const Eigen::Vector2d& before,
                                                double size);

}  // namespace fairing::occt
