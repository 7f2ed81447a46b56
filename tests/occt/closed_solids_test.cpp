// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids with free-form faces: every face taken away in turn and filled again.
#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomLProp_SLProps.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "occt/fill_shape.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;

constexpr double kPi = std::numbers::pi;
constexpr double kSmooth = 0.5;  // degrees; a face is met tangentially where the solid was

/// A box, three edges at one corner rounded with three radii: fillets, and a face that joins them.
TopoDS_Shape roundedBox() {
  const TopoDS_Shape sharp = box(40, 30, 20);
  const ShapeIndex index(sharp);
  const std::vector<int> edges = edgesNear(index, {{20, 0, 0}, {0, 15, 0}, {0, 0, 10}});
  BRepFilletAPI_MakeFillet fillet(sharp);
  fillet.Add(3, index.edge(edges[0]));
  fillet.Add(5, index.edge(edges[1]));
  fillet.Add(8, index.edge(edges[2]));
  return fillet.Shape();
}

TopoDS_Wire rectangleAt(double z, double a, double b) {
  return BRepBuilderAPI_MakePolygon(
      gp_Pnt(-a, -b, z), gp_Pnt(a, -b, z), gp_Pnt(a, b, z), gp_Pnt(-a, b, z), true);
}

/// A waisted loft through three rectangles, its four long edges rounded.
TopoDS_Shape roundedLoft() {
  BRepOffsetAPI_ThruSections loft(true, false);
  loft.AddWire(rectangleAt(0, 20, 15));
  loft.AddWire(rectangleAt(20, 15, 12));
  loft.AddWire(rectangleAt(40, 18, 16));
  const TopoDS_Shape sharp = loft.Shape();
  const ShapeIndex index(sharp);
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (const int edge :
       edgesNear(index, {{-15, -12, 20}, {15, -12, 20}, {15, 12, 20}, {-15, 12, 20}}))
    fillet.Add(4, index.edge(edge));
  return fillet.Shape();
}

/// A torus of 6 x 4 faces, cut by an oblique plane: faces of three to five sides, and the cuts. No
/// border tells the whole of a torus: of larger faces, 90 by 120 degrees, the volume comes out up
/// to 1.4e-3 off.
TopoDS_Shape cutTorus() {
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 40, 15);
  const TopoDS_Shape shell =
      grid(torus,
           {0.0, kPi / 3.0, 2.0 * kPi / 3.0, kPi, 4.0 * kPi / 3.0, 5.0 * kPi / 3.0, 2.0 * kPi},
           {0.0, 0.5 * kPi, kPi, 1.5 * kPi, 2.0 * kPi},
           {});
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell));
  BRepLib::OrientClosedSolid(solid);
  gp_Trsf place;
  place.SetTransformation(gp_Ax3(gp_Pnt(12, 3, 0), gp_Dir(1.0, 0.25, 0.4)), gp_Ax3());
  const TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(-200, -200, 0), 400, 400, 200).Shape();
  return BRepAlgoAPI_Cut(solid, tool.Moved(place)).Shape();
}

gp_Vec normalBeside(const TopoDS_Edge& edge, const TopoDS_Face& face, double share) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom2d_Curve) trace = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const gp_Pnt2d at = trace->Value(first + share * (last - first));
  GeomLProp_SLProps properties(BRep_Tool::Surface(face), at.X(), at.Y(), 1, 1e-9);
  const gp_Vec normal(properties.Normal());
  return face.Orientation() == TopAbs_REVERSED ? -normal : normal;
}

bool isSmooth(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& other) {
  for (const double share : {0.1, 0.5, 0.9}) {
    const gp_Vec a = normalBeside(edge, face, share);
    if (a.Angle(normalBeside(edge, other, share)) * 180.0 / kPi > kSmooth) return false;
  }
  return true;
}

/// A face to be replaced: G1 where it met its neighbours smoothly, G0 at sharp edges.
struct Removal {
  Picks picks;
  bool anySmooth = false;
};

Removal removalOf(const ShapeIndex& index, int number) {
  Removal removal{.picks = {.faces = {number}}};
  for (int k = 1; k <= index.edgeCount(); ++k) {
    const std::vector<EdgeUse>& uses = index.uses(k);
    if (uses.size() != 2 || (uses[0].face != number && uses[1].face != number)) continue;
    const bool smooth = isSmooth(index.edge(k), index.face(uses[0].face), index.face(uses[1].face));
    removal.picks.edgeContinuity[k] = smooth ? Continuity::G1 : Continuity::G0;
    removal.anySmooth = removal.anySmooth || smooth;
  }
  return removal;
}

struct Solid {
  const char* name;
  TopoDS_Shape (*make)();
};

class ClosedSolids : public ::testing::TestWithParam<Solid> {};

TEST_P(ClosedSolids, CloseAgainWhicheverFaceIsReplaced) {
  const TopoDS_Shape solid = GetParam().make();
  ASSERT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  const ShapeIndex index(solid);
  ASSERT_GE(index.faceCount(), 10);
  const double before = volume(solid);
  ASSERT_GT(before, 0.0);
  int smoothFaces = 0;
  for (int face = 1; face <= index.faceCount(); ++face) {
    SCOPED_TRACE("face " + std::to_string(face));
    const Removal removal = removalOf(index, face);
    const auto fill = fillShape(index, removal.picks, {}, ResultMode::Base);
    if (!fill) {
      ADD_FAILURE() << "error " << int(fill.error().code);
      continue;
    }
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(fill->shape, TopAbs_SOLID, solids);
    EXPECT_EQ(solids.Extent(), 1);
    EXPECT_TRUE(BRepCheck_Analyzer(fill->shape).IsValid());
    EXPECT_TRUE(fill->fill.report.withinTolerance);
    const double after = volume(fill->shape);
    EXPECT_GT(after, 0.0);
    if (!removal.anySmooth) continue;
    ++smoothFaces;
    EXPECT_NEAR(after / before, 1.0, 1e-3);
  }
  EXPECT_GT(smoothFaces, 0);
}

INSTANTIATE_TEST_SUITE_P(FillShape,
                         ClosedSolids,
                         ::testing::Values(Solid{"RoundedBox", roundedBox},
                                           Solid{"RoundedLoft", roundedLoft},
                                           Solid{"CutTorus", cutTorus}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace fairing::occt
