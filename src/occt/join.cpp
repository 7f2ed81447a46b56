// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/join.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>

#include "occt/check_shape.h"
#include "occt/free_sides.h"
#include "occt/guarded.h"
#include "occt/solids.h"

namespace fairing::occt {
namespace {

std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  return faces;
}

/// One shell of the faces as they are, without sewing: those of one fill share their seams.
TopoDS_Shape shellOf(const TopoDS_Shape& shape) {
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  for (const TopoDS_Shape& face : facesOf(shape)) builder.Add(shell, face);
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
  const std::map<int, double> free = freeSides(parts, sewing);
  if (!free.empty()) return fail(sewingOpen(free));
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
    if (mode == ResultMode::Base) return sewIntoBase(base, replaced, parts);
    std::vector<TopoDS_Shape> shapes;
    for (const JoinPart& part : parts) {
      shapes.push_back(mode == ResultMode::Shell ? shellOf(part.faces) : part.faces);
    }
    return compoundOf(shapes);
  });
}

}  // namespace fairing::occt
