// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/trimmed_face.h"

#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <vector>

#include "occt/to_geom.h"

namespace fairing::occt {
namespace {

/// Places on every span of a curve where space and surface are compared.
constexpr int kSamplesPerSpan = 32;
/// Samples below this share of the largest one hide no larger peak.
constexpr double kPeakShare = 0.5;
/// What rounding, and the kernel's own search, may find beyond what is measured.
constexpr double kBeyond = 1.001;

/// A border curve as the kernel holds it.
struct Border {
  Handle(Geom_BSplineCurve) inSpace;
  Handle(Geom2d_BSplineCurve) inParameters;

  [[nodiscard]] double first() const { return inSpace->FirstParameter(); }
  [[nodiscard]] double last() const { return inSpace->LastParameter(); }
  [[nodiscard]] gp_Pnt onSurface(const Geom_Surface& surface, double t) const {
    const gp_Pnt2d at = inParameters->Value(t);
    return surface.Value(at.X(), at.Y());
  }
};

double distanceAt(const Border& border, const Geom_Surface& surface, double t) {
  return border.inSpace->Value(t).Distance(border.onSurface(surface, t));
}

/// The largest distance between two parameters that enclose a single peak, by golden sections.
double peakBetween(const Border& border, const Geom_Surface& surface, double from, double to) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kRounds = 12;  // to 0.3 % of the interval: the peak is flat
  double peak = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const double a = to - kGolden * (to - from), b = from + kGolden * (to - from);
    const double atA = distanceAt(border, surface, a), atB = distanceAt(border, surface, b);
    peak = std::max({peak, atA, atB});
    (atA > atB ? to : from) = atA > atB ? b : a;
  }
  return peak;
}

double distanceOf(const Border& border, const Geom_Surface& surface) {
  std::vector<double> places, distances;
  for (int span = 1; span < border.inSpace->NbKnots(); ++span) {
    const double from = border.inSpace->Knot(span), to = border.inSpace->Knot(span + 1);
    for (int i = span == 1 ? 0 : 1; i <= kSamplesPerSpan; ++i) {
      places.push_back(from + (to - from) * i / kSamplesPerSpan);
      distances.push_back(distanceAt(border, surface, places.back()));
    }
  }
  const double sampled = *std::max_element(distances.begin(), distances.end());
  double largest = sampled;
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    const bool isPeak = distances[k] >= distances[k - 1] && distances[k] >= distances[k + 1];
    if (!isPeak || distances[k] < kPeakShare * sampled) continue;
    largest = std::max(largest, peakBetween(border, surface, places[k - 1], places[k + 1]));
  }
  return largest;
}

/// Where `before` ends and `after` starts.
TopoDS_Vertex vertexBetween(const Border& before,
                            const Border& after,
                            const Geom_Surface& surface) {
  const gp_Pnt end = before.inSpace->Value(before.last());
  const gp_Pnt start = after.inSpace->Value(after.first());
  const gp_Pnt middle(0.5 * (end.XYZ() + start.XYZ()));
  double tolerance = Precision::Confusion();
  for (const gp_Pnt& point : {end,
                              start,
                              before.onSurface(surface, before.last()),
                              after.onSurface(surface, after.first())})
    tolerance = std::max(tolerance, kBeyond * middle.Distance(point));
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, middle, tolerance);
  return vertex;
}

TopoDS_Edge edgeOf(const Border& border,
                   const Handle(Geom_Surface) & surface,
                   const TopoDS_Vertex& start,
                   const TopoDS_Vertex& end) {
  const BRep_Builder builder;
  const double tolerance = std::max(Precision::Confusion(), kBeyond * distanceOf(border, *surface));
  TopoDS_Edge edge;
  builder.MakeEdge(edge, border.inSpace, tolerance);
  builder.UpdateEdge(edge, border.inParameters, surface, TopLoc_Location(), tolerance);
  builder.Range(edge, border.first(), border.last());
  builder.Add(edge, start.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  edge.Closed(start.IsSame(end));
  // Both curves have the same knots, and the tolerance is the distance at equal parameters.
  builder.SameRange(edge, true);
  builder.SameParameter(edge, true);
  return edge;
}

}  // namespace

TopoDS_Face trimmedFace(const Handle(Geom_Surface) & surface, const Trim& trim) {
  std::vector<Border> borders;
  for (const TrimCurve& curve : trim.curves)
    borders.push_back({toCurve(curve.inSpace), toParameterCurve(curve)});
  const std::size_t n = borders.size();
  std::vector<TopoDS_Vertex> starts;
  for (std::size_t k = 0; k < n; ++k)
    starts.push_back(vertexBetween(borders[(k + n - 1) % n], borders[k], *surface));
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (std::size_t k = 0; k < n; ++k)
    builder.Add(wire, edgeOf(borders[k], surface, starts[k], starts[(k + 1) % n]));
  wire.Closed(true);
  TopoDS_Face face;
  builder.MakeFace(face, surface, Precision::Confusion());
  builder.Add(face, wire);
  return face;
}

}  // namespace fairing::occt
