// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blends.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <limits>
#include <numbers>

#include "occt/shapes.h"
#include "text/error_text.h"

namespace fairing::testing {

using Eigen::Vector3d;

Blended tryBlend(const TopoDS_Shape& shape,
                 const occt::BlendPicks& picks,
                 occt::ResultMode mode,
                 const BlendOptions& options) {
  return occt::blendShape(occt::ShapeIndex(shape), picks, options, mode);
}

occt::ShapeFill blended(const TopoDS_Shape& shape,
                        const occt::BlendPicks& picks,
                        occt::ResultMode mode,
                        const BlendOptions& options) {
  const auto result = tryBlend(shape, picks, mode, options);
  EXPECT_TRUE(result.has_value()) << (result ? "" : text::sentence(result.error()));
  return result ? occt::ShapeFill(*result) : occt::ShapeFill{};
}

Error errorOf(const TopoDS_Shape& shape,
              const occt::BlendPicks& picks,
              const BlendOptions& options) {
  const auto result = tryBlend(shape, picks, occt::ResultMode::Patches, options);
  EXPECT_FALSE(result.has_value());
  return result ? Error{} : result.error();
}

ErrorCode refusal(const TopoDS_Shape& shape,
                  const occt::BlendPicks& picks,
                  const BlendOptions& options) {
  return errorOf(shape, picks, options).code;
}

void expectWithin(const occt::ShapeFill& blend) {
  const analysis::FillReport& report = blend.fill.report;
  EXPECT_TRUE(report.withinTolerance);
  EXPECT_LT(report.largestAngle, 0.02);
  EXPECT_LT(report.largestSeamAngle, 0.02);
  EXPECT_LT(report.largestGap, 1e-6 * report.diagonal);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
}

occt::BlendPicks picksNear(const TopoDS_Shape& shape,
                           const std::vector<Vector3d>& from,
                           const std::vector<Vector3d>& to,
                           const std::vector<Vector3d>& ends) {
  const occt::ShapeIndex index(shape);
  return {
      .from = edgesNear(index, from), .to = edgesNear(index, to), .ends = edgesNear(index, ends)};
}

occt::BlendPicks between(const TopoDS_Shape& shape,
                         const Vector3d& from,
                         const Vector3d& to,
                         Continuity continuity) {
  occt::BlendPicks picks = picksNear(shape, {from}, {to});
  picks.continuity = continuity;
  return picks;
}

gp_Ax3 upright(double z) {
  return gp_Ax3(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1));
}

TopoDS_Shape pipe(const gp_Ax3& frame, double radius, double from, double to) {
  return grid(new Geom_CylindricalSurface(frame, radius),
              {0.0, 2.0 * std::numbers::pi},
              {from, to},
              {},
              Joint::Loose);
}

std::vector<Vector3d> pointsOf(const occt::ShapeFill& blend, int cells) {
  std::vector<Vector3d> points;
  for (const auto& patch : blend.fill.patches)
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j)
        points.push_back(patch.evaluate(patch.u.last() * i / cells, patch.v.last() * j / cells));
  return points;
}

double apart(const occt::ShapeFill& a, const occt::ShapeFill& b) {
  double largest = 0.0;
  for (const Vector3d& p : pointsOf(a, 3)) {
    double least = std::numeric_limits<double>::infinity();
    for (TopExp_Explorer face(b.shape, TopAbs_FACE); face.More(); face.Next()) {
      const GeomAPI_ProjectPointOnSurf foot(gp_Pnt(p.x(), p.y(), p.z()),
                                            BRep_Tool::Surface(TopoDS::Face(face.Current())));
      if (foot.NbPoints() > 0) least = std::min(least, foot.LowerDistance());
    }
    largest = std::max(largest, least);
  }
  return largest;
}

}  // namespace fairing::testing
