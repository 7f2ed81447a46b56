// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/border_candidates.h"

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include "occt/edge_curve.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

constexpr int kSamples = 8;

void measure(const TopoDS_Edge& edge, Candidate& c) {
  const EdgeCurve curve(edge, Direction::Forward);
  for (int i = 0; i <= kSamples; ++i) {
    c.samples.push_back(curve.point(double(i) / kSamples));
    if (i > 0) c.length += (c.samples[std::size_t(i)] - c.samples[std::size_t(i - 1)]).norm();
  }
  c.tolerance = BRep_Tool::Tolerance(edge);
}

Error degenerate(int number, const TopoDS_Edge& edge, double length) {
  Error error{.code = ErrorCode::EdgeDegenerate, .edge = number, .value = length};
  const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
  if (!vertex.IsNull()) error.where = fromOcct(BRep_Tool::Pnt(vertex));
  return error;
}

/// Sorts the uses of an edge into those that stay and the one that goes; an error where no hole can
/// run along it.
Result<Candidate> candidate(const ShapeIndex& index, int number, const std::set<int>& pickedFaces) {
  if (BRep_Tool::Degenerated(index.edge(number)))
    return fail(degenerate(number, index.edge(number), 0.0));
  std::vector<EdgeUse> staying, removed;
  for (const EdgeUse& use : index.uses(number))
    (pickedFaces.contains(use.face) ? removed : staying).push_back(use);
  const std::size_t faces = index.uses(number).size();
  if (staying.size() > 1 || removed.size() > 1) return fail(notFree(number, faces));
  auto c = measured(index, number);
  if (!c) return c;
  c->walkable = pickedFaces.empty() ? faces <= 1 : removed.size() == 1;
  c->staying = std::move(staying);
  if (!removed.empty()) c->removed = removed.front();
  return c;
}

}  // namespace

Result<Candidate> measured(const ShapeIndex& index, int edge) {
  const TopoDS_Edge& shape = index.edge(edge);
  if (BRep_Tool::Degenerated(shape)) return fail(degenerate(edge, shape, 0.0));
  if (!EdgeCurve(shape, Direction::Forward).isFinite())
    return fail({.code = ErrorCode::EdgeInfinite, .edge = edge});
  Candidate c{.edge = edge};
  measure(shape, c);
  if (!(c.length > 1e-3 * Precision::Confusion())) return fail(degenerate(edge, shape, c.length));
  return c;
}

Error notFree(int edge, std::size_t faces) {
  return {.code = faces > 2 ? ErrorCode::EdgeWithManyFaces : ErrorCode::EdgeNotFree,
          .edge = edge,
          .value = double(faces)};
}

Candidates collectCandidates(const ShapeIndex& index, const std::set<int>& pickedFaces) {
  Candidates result;
  result.refusals.resize(std::size_t(index.edgeCount()) + 1);
  for (int number = 1; number <= index.edgeCount(); ++number) {
    auto c = guarded([&] { return candidate(index, number, pickedFaces); });
    result.refusals[std::size_t(number)] =
        c ? notFree(number, index.uses(number).size()) : c.error();
    if (c) result.edges.push_back(std::move(*c));
  }
  return result;
}

}  // namespace fairing::occt
