// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/join.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>

#include "occt/check_shape.h"
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

/// Edges with a face beside them that the sewn shape still has only once.
std::vector<int> stillFree(const ShapeIndex& base,
                           const std::vector<JoinPart>& parts,
                           const BRepBuilderAPI_Sewing& sewing) {
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
  TopExp::MapShapesAndAncestors(sewing.SewedShape(), TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
  std::vector<int> open;
  for (const JoinPart& part : parts) {
    for (const boundary::BoundarySide& side : part.loop.sides) {
      if (side.face == 0) continue;
      const TopoDS_Shape& edge = base.edge(side.edge);
      const TopoDS_Shape now =
          sewing.IsModifiedSubShape(edge) ? sewing.ModifiedSubShape(edge) : edge;
      bool free = false;
      for (TopExp_Explorer it(now, TopAbs_EDGE); it.More(); it.Next()) {
        const TopTools_ListOfShape* faces = facesOfEdge.Seek(it.Current());
        free = free || faces == nullptr || faces->Extent() < 2;
      }
      if (free) open.push_back(side.edge);
    }
  }
  return open;
}

/// A closed shell becomes a solid that encloses a positive volume.
TopoDS_Shape solidWhereClosed(const TopoDS_Shape& shape) {
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
  const std::vector<int> open = stillFree(base, parts, sewing);
  if (!open.empty()) {
    return fail(
        {.code = ErrorCode::SewingOpen, .edge = open.front(), .value = double(open.size())});
  }
  const TopoDS_Shape result = solidWhereClosed(sewing.SewedShape());
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
