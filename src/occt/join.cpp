// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/join.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <limits>
#include <set>

#include "occt/check_shape.h"
#include "occt/edge_curve.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  if (shapes.size() == 1) return shapes.front();
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  return faces;
}

/// One shell of all faces as they are, without sewing.
TopoDS_Shape shellOf(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  for (const TopoDS_Shape& shape : shapes) {
    for (const TopoDS_Shape& face : facesOf(shape)) builder.Add(shell, face);
  }
  shell.Closed(BRep_Tool::IsClosed(shell));
  return shell;
}

/// Twice the largest distance measured, and what the vertices of the loops claim for themselves.
double sewingTolerance(const ShapeIndex& base, const std::vector<JoinPart>& parts) {
  double tolerance = Precision::Confusion();
  for (const JoinPart& part : parts) {
    tolerance = std::max(tolerance, 2.0 * part.gap);
    for (const boundary::BoundarySide& side : part.loop.sides) {
      tolerance = std::max(tolerance, 2.0 * side.supportDeviation);
      tolerance = std::max(tolerance, BRep_Tool::Tolerance(base.edge(side.edge)));
    }
    for (const boundary::Corner& corner : part.loop.corners) {
      tolerance = std::max(tolerance, 2.0 * corner.gap);
    }
  }
  return tolerance;
}

/// The side of the loop that runs nearest to the middle of an edge.
const boundary::BoundarySide& nearestSide(const boundary::BoundaryLoop& loop,
                                          const TopoDS_Edge& edge) {
  constexpr int kSamples = 16;
  const Eigen::Vector3d middle = EdgeCurve(edge, Direction::Forward).point(0.5);
  const boundary::BoundarySide* nearest = &loop.sides.front();
  double least = std::numeric_limits<double>::infinity();
  for (const boundary::BoundarySide& side : loop.sides) {
    for (int i = 0; i <= kSamples; ++i) {
      const double distance = (side.ribbon.curve(double(i) / kSamples).point - middle).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = &side;
    }
  }
  return *nearest;
}

/// Sides with a face beside them along which the new faces still end freely in the sewn shape.
std::set<int> stillFree(const std::vector<JoinPart>& parts, const BRepBuilderAPI_Sewing& sewing) {
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
  TopExp::MapShapesAndAncestors(sewing.SewedShape(), TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
  std::set<int> open;
  for (const JoinPart& part : parts) {
    for (TopExp_Explorer old(part.faces, TopAbs_EDGE); old.More(); old.Next()) {
      const TopoDS_Shape& edge = old.Current();
      const TopoDS_Shape now =
          sewing.IsModifiedSubShape(edge) ? sewing.ModifiedSubShape(edge) : edge;
      for (TopExp_Explorer it(now, TopAbs_EDGE); it.More(); it.Next()) {
        const TopTools_ListOfShape* faces = facesOfEdge.Seek(it.Current());
        if (faces != nullptr && faces->Extent() > 1) continue;
        const boundary::BoundarySide& side = nearestSide(part.loop, TopoDS::Edge(it.Current()));
        if (side.face != 0) open.insert(side.edge);
      }
    }
  }
  return open;
}

/// A closed shell becomes a solid that encloses a positive volume; also inside a compound.
TopoDS_Shape solidsWhereClosed(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_COMPOUND) {
    std::vector<TopoDS_Shape> members;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      members.push_back(solidsWhereClosed(it.Value()));
    }
    return compoundOf(members);
  }
  if (shape.ShapeType() != TopAbs_SHELL || !BRep_Tool::IsClosed(shape)) return shape;
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shape)).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

Result<TopoDS_Shape> sewIntoBase(const ShapeIndex& base,
                                 const std::vector<int>& replaced,
                                 const std::vector<JoinPart>& parts) {
  BRepBuilderAPI_Sewing sewing(sewingTolerance(base, parts));
  for (int face = 1; face <= base.faceCount(); ++face) {
    if (std::find(replaced.begin(), replaced.end(), face) == replaced.end())
      sewing.Add(base.face(face));
  }
  for (const JoinPart& part : parts) sewing.Add(part.faces);
  sewing.Perform();
  const std::set<int> open = stillFree(parts, sewing);
  if (!open.empty()) {
    return fail(
        {.code = ErrorCode::SewingOpen, .edge = *open.begin(), .value = double(open.size())});
  }
  const TopoDS_Shape result = solidsWhereClosed(sewing.SewedShape());
  if (const auto error = checkShape(result)) return fail(*error);
  return result;
}

}  // namespace

Result<TopoDS_Shape> joinResult(const ShapeIndex& base,
                                const std::vector<int>& replaced,
                                const std::vector<JoinPart>& parts,
                                ResultMode mode) {
  return guarded([&]() -> Result<TopoDS_Shape> {
    std::vector<TopoDS_Shape> faces;
    for (const JoinPart& part : parts) faces.push_back(part.faces);
    switch (mode) {
      case ResultMode::Patches:
        return compoundOf(faces);
      case ResultMode::Shell:
        return shellOf(faces);
      case ResultMode::Base:
        return sewIntoBase(base, replaced, parts);
    }
    return compoundOf(faces);
  });
}

}  // namespace fairing::occt
