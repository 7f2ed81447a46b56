// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "core/boundary/ribbon.h"
#include "occt/shape_index.h"
#include "occt/surface_point.h"

namespace fairing::occt {

/// Which way the unit normal is taken: as the face says, or turned because the face is oriented
/// against its neighbours.
enum class NormalSense { AsFace, Turned };

/// How the edge asking and the edge in the face's border relate.
enum class EdgeMatch {
  Same,  ///< one and the same edge: the pcurve is followed at the edge's own parameter
  Twin,  ///< two coincident edges of an unsewn shape: the nearest point of the pcurve is taken
};

/// The face beside a boundary edge: its point, normal and second fundamental form along the edge.
/// One evaluation costs a pcurve and a surface evaluation; nothing is allocated. Not to be shared
/// between threads.
class EdgeSupport {
 public:
  /// `use` is the edge in the border of `face`.
  EdgeSupport(const TopoDS_Face& face, const TopoDS_Edge& use, EdgeMatch match, NormalSense sense);

  /// The support at the edge's parameter, where the 3D edge is at `point`: the point's foot on the
  /// surface, found from the pcurve. Where the surface has no normal, the limit from within the
  /// face is taken; without a limit: singular.
  [[nodiscard]] boundary::SupportSample at(double parameter, const Eigen::Vector3d& point) const;

 private:
  [[nodiscard]] gp_Pnt2d start(double parameter, const Eigen::Vector3d& point) const;
  [[nodiscard]] boundary::SupportSample limit(double parameter, const SurfacePoint& foot) const;
  [[nodiscard]] boundary::SupportSample sample(const SurfacePoint& foot) const;
  [[nodiscard]] bool runsAlongU() const;

  BRepAdaptor_Surface surface_;
  Geom2dAdaptor_Curve pcurve_;
  TopoDS_Face face_;
  double edgeFirst_ = 0.0, edgeLast_ = 1.0;      ///< parameters of the 3D edge
  double pcurveFirst_ = 0.0, pcurveLast_ = 1.0;  ///< the same on the pcurve; equal for sound edges
  double normalSign_ = 1.0;
  double insideSign_ = 1.0;  ///< +1: the face lies to the left of the pcurve in (u, v)
  bool isoIsV_ = true;       ///< of the two families of iso-curves those along v cross the edge
  struct Landmark {
    double parameter;
    Eigen::Vector3d point;
  };
  std::vector<Landmark> landmarks_;  ///< along the pcurve, for twins
};

}  // namespace fairing::occt
