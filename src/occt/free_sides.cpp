// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/free_sides.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cstdio>

#include "occt/edge_curve.h"
#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using boundary::BoundarySide;

constexpr int kSamples = 16;  // along a side

/// The side that an edge of the new faces runs along; none where it is the free end of a strip: its
/// middle is far from every side then, measured by its length.
const BoundarySide* sideOf(const boundary::BoundaryLoop& loop, const TopoDS_Edge& edge) {
  constexpr double kBeside = 0.1;
  const EdgeCurve curve(edge, Direction::Forward);
  const Eigen::Vector3d middle = curve.point(0.5);
  const double length = (curve.point(0.0) - middle).norm() + (curve.point(1.0) - middle).norm();
  const BoundarySide* nearest = nullptr;
  double least = kBeside * length;
  for (const BoundarySide& side : loop.sides) {
    for (int i = 0; i <= kSamples; ++i) {
      const double distance = (side.ribbon.curve(double(i) / kSamples).point - middle).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = &side;
    }
  }
  return nearest;
}

/// Largest distance of a side from a set of edges, mm.
double gapOf(const BoundarySide& side, const TopoDS_Shape& edges) {
  double gap = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const gp_Pnt point = toPoint(side.ribbon.curve(double(i) / kSamples).point);
    const BRepExtrema_DistShapeShape foot(BRepBuilderAPI_MakeVertex(point).Vertex(), edges);
    if (foot.IsDone()) gap = std::max(gap, foot.Value());
  }
  return gap;
}

}  // namespace

std::map<int, double> freeSides(const std::vector<JoinPart>& parts,
                                const BRepBuilderAPI_Sewing& sewing) {
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
  TopExp::MapShapesAndAncestors(sewing.SewedShape(), TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
  const BRep_Builder builder;
  std::map<int, double> free;
  for (const JoinPart& part : parts) {
    TopoDS_Compound open;
    builder.MakeCompound(open);
    std::vector<const BoundarySide*> sides;
    for (TopExp_Explorer old(part.faces, TopAbs_EDGE); old.More(); old.Next()) {
      const TopoDS_Shape& edge = old.Current();
      const TopoDS_Shape now =
          sewing.IsModifiedSubShape(edge) ? sewing.ModifiedSubShape(edge) : edge;
      for (TopExp_Explorer it(now, TopAbs_EDGE); it.More(); it.Next()) {
        const TopTools_ListOfShape* faces = facesOfEdge.Seek(it.Current());
        if (faces != nullptr && faces->Extent() > 1) continue;
        const BoundarySide* side = sideOf(part.loop, TopoDS::Edge(it.Current()));
        if (side == nullptr) continue;
        builder.Add(open, it.Current());
        sides.push_back(side);
      }
    }
    for (const BoundarySide* side : sides) {
      if (side->face != 0 && !free.contains(side->edge)) free[side->edge] = gapOf(*side, open);
    }
  }
  return free;
}

Error sewingOpen(const std::map<int, double>& free) {
  Error error{
      .code = ErrorCode::SewingOpen, .edge = free.begin()->first, .value = double(free.size())};
  for (const auto& [edge, gap] : free) {
    char text[64];
    std::snprintf(text, sizeof text, "edge %d: %.3g mm", edge, gap);
    error.detail += (error.detail.empty() ? "" : ", ") + std::string(text);
  }
  return error;
}

}  // namespace fairing::occt
