// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/solids.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

namespace fairing::occt {
namespace {

void collect(const TopoDS_Shape& shape,
             std::vector<TopoDS_Shell>& closed,
             std::vector<TopoDS_Shape>& open) {
  if (shape.ShapeType() == TopAbs_COMPOUND) {
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) collect(it.Value(), closed, open);
  } else if (shape.ShapeType() == TopAbs_SHELL && BRep_Tool::IsClosed(shape)) {
    closed.push_back(TopoDS::Shell(shape));
  } else {
    open.push_back(shape);
  }
}

TopoDS_Solid solidOf(const TopoDS_Shell& shell) {
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

/// Whether a shell lies within a solid, told by one of its vertices: shells do not cross.
bool contains(const TopoDS_Solid& solid, const TopoDS_Solid& other) {
  const TopExp_Explorer vertex(other, TopAbs_VERTEX);
  if (!vertex.More()) return false;
  const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
  return BRepClass3d_SolidClassifier(solid, point, Precision::Confusion()).State() == TopAbs_IN;
}

/// Shells at an even depth are outsides, those within them at the next depth are their cavities.
std::vector<TopoDS_Shape> nested(const std::vector<TopoDS_Solid>& solids) {
  const std::size_t n = solids.size();
  std::vector<std::vector<bool>> inside(n, std::vector<bool>(n, false));
  std::vector<int> depth(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      if (i == k || !contains(solids[k], solids[i])) continue;
      inside[i][k] = true;
      ++depth[i];
    }
  }
  std::vector<TopoDS_Shape> result;
  for (std::size_t k = 0; k < n; ++k) {
    if (depth[k] % 2 == 1) continue;
    BRepBuilderAPI_MakeSolid maker(solids[k]);
    for (std::size_t i = 0; i < n; ++i) {
      if (!inside[i][k] || depth[i] != depth[k] + 1) continue;
      const TopExp_Explorer shell(solids[i], TopAbs_SHELL);
      maker.Add(TopoDS::Shell(shell.Current().Reversed()));
    }
    result.push_back(maker.Solid());
  }
  return result;
}

}  // namespace

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  if (shapes.size() == 1) return shapes.front();
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

TopoDS_Shape solidsWhereClosed(const TopoDS_Shape& sewn) {
  std::vector<TopoDS_Shell> closed;
  std::vector<TopoDS_Shape> shapes;
  collect(sewn, closed, shapes);
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Shell& shell : closed) solids.push_back(solidOf(shell));
  for (const TopoDS_Shape& solid : nested(solids)) shapes.push_back(solid);
  return compoundOf(shapes);
}

}  // namespace fairing::occt
