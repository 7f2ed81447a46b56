// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/inner_constraints.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <limits>
#include <memory>

#include "occt/edge_curve.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

constexpr int kSamples = 16;  // along a side and along a curve

InnerConstraint throughEdge(const TopoDS_Edge& edge) {
  const auto curve = std::make_shared<EdgeCurve>(edge, Direction::Forward);
  return {.at = [curve](double t) { return curve->point(t); }, .isPoint = false};
}

InnerConstraint throughVertex(const TopoDS_Vertex& vertex) {
  return throughPoint(fromOcct(BRep_Tool::Pnt(vertex)));
}

/// Least distance of a constraint from the loop, and where on the constraint.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
};

Nearest nearestTo(const boundary::BoundaryLoop& loop, const InnerConstraint& constraint) {
  Nearest nearest;
  for (int i = 0; i <= (constraint.isPoint ? 0 : kSamples); ++i) {
    const Eigen::Vector3d point = constraint.at(double(i) / kSamples);
    for (const boundary::BoundarySide& side : loop.sides) {
      for (int k = 0; k <= kSamples; ++k) {
        const double distance = (side.ribbon.curve(double(k) / kSamples).point - point).norm();
        if (distance < nearest.distance) nearest = {distance, point};
      }
    }
  }
  return nearest;
}

}  // namespace

InnerConstraint throughPoint(const Eigen::Vector3d& point) {
  return {.at = [point](double) { return point; }, .isPoint = true};
}

Result<std::vector<InnerConstraint>> throughParts(const ShapeIndex& index,
                                                  const std::vector<int>& edges,
                                                  const std::vector<int>& vertices) {
  return guarded([&]() -> Result<std::vector<InnerConstraint>> {
    std::vector<InnerConstraint> through;
    for (int edge : edges) {
      if (!index.hasEdge(edge)) {
        return fail(
            {.code = ErrorCode::EdgeOutOfRange, .edge = edge, .value = double(index.edgeCount())});
      }
      through.push_back(throughEdge(index.edge(edge)));
    }
    TopTools_IndexedMapOfShape all;
    if (!vertices.empty()) TopExp::MapShapes(index.shape(), TopAbs_VERTEX, all);
    for (int vertex : vertices) {
      if (vertex < 1 || vertex > all.Extent()) {
        return fail(
            {.code = ErrorCode::VertexOutOfRange, .edge = vertex, .value = double(all.Extent())});
      }
      through.push_back(throughVertex(TopoDS::Vertex(all(vertex))));
    }
    return through;
  });
}

Result<std::vector<InnerConstraint>> throughShape(const TopoDS_Shape& shape) {
  return guarded([&]() -> Result<std::vector<InnerConstraint>> {
    std::vector<InnerConstraint> through;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))))
        through.push_back(throughEdge(TopoDS::Edge(edges(i))));
    }
    for (TopExp_Explorer it(shape, TopAbs_VERTEX, TopAbs_EDGE); it.More(); it.Next()) {
      through.push_back(throughVertex(TopoDS::Vertex(it.Current())));
    }
    if (through.empty()) return fail({.code = ErrorCode::ShapeEmpty});
    return through;
  });
}

std::optional<Error> checkThrough(const boundary::BoundaryLoop& loop,
                                  const std::vector<InnerConstraint>& through) {
  for (const InnerConstraint& constraint : through) {
    const Nearest nearest = nearestTo(loop, constraint);
    if (!nearest.where.allFinite() || !(nearest.distance < std::numeric_limits<double>::infinity()))
      return Error{.code = ErrorCode::NotFinite};
    if (nearest.distance > loop.diagonal) {
      return Error{
          .code = ErrorCode::InnerConstraintOff, .where = nearest.where, .value = nearest.distance};
    }
  }
  return std::nullopt;
}

}  // namespace fairing::occt
