// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/setback.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "occt/edge_curve.h"
#include "occt/guarded.h"
#include "occt/offset_curve.h"

namespace fairing::occt {
namespace {

using boundary::BoundarySide;
using boundary::ChainPair;

/// The curve a chain's edge is to be set back to.
struct Cut {
  int edge = 0, face = 0;
  std::size_t chain = 0;
  std::vector<TopoDS_Edge> tools;
};

/// The side before (step -1) or after (+1) in its chain; nothing at an open end.
std::optional<std::size_t> neighbour(const ChainPair& pair, std::size_t side, int step) {
  const std::size_t before = step > 0 ? side : pair.sides.previous(side);
  if (pair.sides.corners[before].apart) return std::nullopt;
  return step > 0 ? pair.sides.next(side) : before;
}

const EdgeUse* useIn(const ShapeIndex& index, int edge, int face) {
  for (const EdgeUse& use : index.uses(edge))
    if (use.face == face) return &use;
  return nullptr;
}

/// Whether the side runs as its edge's own curve does.
bool runsForward(const ShapeIndex& index, const BoundarySide& side) {
  const EdgeCurve own(index.edge(side.edge), Direction::Forward);
  return own.at(0.5).derivative.dot(side.ribbon.curve(0.5).derivative) > 0.0;
}

Result<Cut> cutOf(const ShapeIndex& index, const ChainPair& pair, std::size_t k, double distance) {
  const BoundarySide& side = pair.sides.sides[k];
  const EdgeUse* use = side.face > 0 ? useIn(index, side.edge, side.face) : nullptr;
  if (!use) return fail({.code = ErrorCode::SetbackWithoutFace, .edge = side.edge});
  const auto end = [&](int step) {
    const auto next = neighbour(pair, k, step);
    return next && pair.sides.sides[*next].face == side.face ? EdgeEnd::Joined : EdgeEnd::Open;
  };
  OffsetRequest request{index.face(side.face), use->edge, distance, {end(-1), end(1)}};
  if (!runsForward(index, side)) std::swap(request.ends[0], request.ends[1]);
  auto tools = offsetOnFace(request);
  if (!tools) {
    Error error = tools.error();
    error.edge = side.edge;
    error.face = side.face;
    error.where = side.ribbon.curve(0.5).point;
    return fail(error);
  }
  return Cut{side.edge, side.face, pair.chainOf(k), std::move(*tools)};
}

/// What shapes have become.
class Images {
 public:
  explicit Images(BRepAlgoAPI_Splitter& splitter) : splitter_(splitter) {}
  [[nodiscard]] std::vector<TopoDS_Shape> of(const TopoDS_Shape& shape) {
    const TopTools_ListOfShape& images = splitter_.Modified(shape);
    if (!images.IsEmpty()) return {images.begin(), images.end()};
    if (splitter_.IsDeleted(shape)) return {};
    return {shape};
  }

 private:
  BRepAlgoAPI_Splitter& splitter_;
};

TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

using ShapeMap = TopTools_IndexedMapOfShape;

/// The base while it is trimmed.
class Trimming {
 public:
  Trimming(const ShapeIndex& index, const std::vector<Cut>& cuts, BRepAlgoAPI_Splitter& splitter)
      : index_(index), cuts_(cuts), images_(splitter) {}

  /// The faces that stay: pieces that still hold an edge of a chain are left out.
  [[nodiscard]] TopoDS_Compound stayingFaces() {
    TopTools_MapOfShape left;
    for (const Cut& cut : cuts_)
      for (const TopoDS_Shape& image : images_.of(index_.edge(cut.edge))) left.Add(image);
    std::vector<TopoDS_Shape> staying;
    for (int face = 1; face <= index_.faceCount(); ++face) {
      const bool isCut =
          std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) { return cut.face == face; });
      for (const TopoDS_Shape& image : images_.of(index_.face(face))) {
        bool holds = false;
        for (TopExp_Explorer it(image, TopAbs_EDGE); it.More(); it.Next())
          holds = holds || left.Contains(it.Current());
        if (!isCut || !holds) staying.push_back(image);
      }
    }
    for (int edge = 1; edge <= index_.edgeCount(); ++edge)
      if (index_.uses(edge).empty())
        for (const TopoDS_Shape& image : images_.of(index_.edge(edge))) staying.push_back(image);
    return compoundOf(staying);
  }

  /// The new base; fails with SetbackTooLarge and EdgeNotInLoop.
  [[nodiscard]] Result<TrimmedBase> finish(const BlendPicks& picks, const ChainPair& pair) {
    TrimmedBase base{ShapeIndex(stayingFaces()), {.continuity = picks.continuity}, {}};
    ShapeMap edges, faces;
    TopExp::MapShapes(base.index.shape(), TopAbs_EDGE, edges);
    TopExp::MapShapes(base.index.shape(), TopAbs_FACE, faces);
    for (int edge = 1; edge <= index_.edgeCount(); ++edge)
      for (const int number : numbersOf(index_.edge(edge), edges))
        base.users.edges.emplace(number, edge);
    for (int face = 1; face <= index_.faceCount(); ++face)
      for (const int number : numbersOf(index_.face(face), faces))
        base.users.faces.emplace(number, face);
    for (const Cut& cut : cuts_) {
      std::set<int> border;
      for (const TopoDS_Edge& tool : cut.tools) border.merge(numbersOf(tool, edges));
      if (border.empty())
        return fail({.code = ErrorCode::SetbackTooLarge, .edge = cut.edge, .face = cut.face});
      for (const int number : border) base.users.edges[number] = cut.edge;
    }
    for (std::size_t k = 0; k < pair.sides.sides.size(); ++k)
      for (const auto& [number, user] : base.users.edges)
        if (user == pair.sides.sides[k].edge)
          (pair.chainOf(k) == 0 ? base.picks.from : base.picks.to).push_back(number);
    if (const auto stray = translate(picks.edgeContinuity, base)) return fail(*stray);
    return base;
  }

 private:
  /// The numbers in `all` of what a shape has become.
  [[nodiscard]] std::set<int> numbersOf(const TopoDS_Shape& shape, const ShapeMap& all) {
    std::set<int> numbers;
    for (const TopoDS_Shape& image : images_.of(shape))
      if (const int number = all.FindIndex(image); number > 0) numbers.insert(number);
    return numbers;
  }
  static std::optional<Error> translate(const std::map<int, Continuity>& wishes,
                                        TrimmedBase& base) {
    for (const auto& [edge, wish] : wishes) {
      bool known = false;
      for (const auto& [number, user] : base.users.edges) {
        if (user != edge) continue;
        base.picks.edgeContinuity[number] = wish;
        known = true;
      }
      if (!known) return Error{.code = ErrorCode::EdgeNotInLoop, .edge = edge};
    }
    return std::nullopt;
  }

  const ShapeIndex& index_;
  const std::vector<Cut>& cuts_;
  Images images_;
};

void rename(int& number, const std::map<int, int>& users) {
  if (const auto found = users.find(number); found != users.end()) number = found->second;
}

/// Of what names an edge and a face: a side, a failure, a note.
template <class Named>
Named renamed(Named named, const UserNumbers& users) {
  rename(named.edge, users.edges);
  rename(named.face, users.faces);
  return named;
}

}  // namespace

Result<TrimmedBase> trimBack(const ShapeIndex& index,
                             const BlendPicks& picks,
                             const boundary::ChainPair& pair) {
  for (const double setback : picks.setback)
    if (!(setback >= 0.0)) return fail({.code = ErrorCode::SetbackNegative, .value = setback});
  return guarded([&]() -> Result<TrimmedBase> {
    std::vector<Cut> cuts;
    TopTools_ListOfShape shapes, tools;
    shapes.Append(index.shape());
    for (std::size_t k = 0; k < pair.sides.sides.size(); ++k) {
      const double distance = picks.setback[pair.chainOf(k)];
      if (!(distance > 0.0)) continue;
      auto cut = cutOf(index, pair, k, distance);
      if (!cut) return fail(cut.error());
      for (const TopoDS_Edge& tool : cut->tools) tools.Append(tool);
      cuts.push_back(std::move(*cut));
    }
    BRepAlgoAPI_Splitter splitter;
    splitter.SetArguments(shapes);
    splitter.SetTools(tools);
    splitter.SetNonDestructive(true);
    splitter.Build();
    if (splitter.HasErrors())
      return fail({.code = ErrorCode::Foreign, .detail = "the faces could not be set back"});
    return Trimming(index, cuts, splitter).finish(picks, pair);
  });
}

boundary::BoundaryLoop inNumbersOf(boundary::BoundaryLoop sides, const UserNumbers& users) {
  for (BoundarySide& side : sides.sides) side = renamed(std::move(side), users);
  return sides;
}

Error inNumbersOf(Error error, const UserNumbers& users) {
  return renamed(std::move(error), users);
}

analysis::Note inNumbersOf(analysis::Note note, const UserNumbers& users) {
  return renamed(note, users);
}

}  // namespace fairing::occt
