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
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include "occt/drawn_setback.h"
#include "occt/edge_curve.h"
#include "occt/guarded.h"
#include "occt/offset_curve.h"

namespace fairing::occt {
namespace {

using boundary::BoundarySide;
using boundary::ChainPair;

/// What a chain's edge is to be set back to.
struct Cut {
  int edge = 0, face = 0;
  std::vector<TopoDS_Edge> tools;
  /// What it means if the face lets the edge go nowhere.
  ErrorCode without = ErrorCode::SetbackTooLarge;
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
  const EdgeUse* use = useIn(index, side.edge, side.face);
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
  return Cut{side.edge, side.face, std::move(*tools)};
}

std::optional<Error> checkSetback(const ShapeIndex& index,
                                  const BlendPicks& picks,
                                  const ChainPair& pair) {
  for (const std::size_t chain : {0U, 1U}) {
    if (!(picks.setback[chain] >= 0.0))
      return Error{.code = ErrorCode::SetbackNegative, .value = picks.setback[chain]};
    if (picks.setback[chain] > 0.0 && !picks.setbackCurve[chain].empty())
      return Error{.code = ErrorCode::SetbackTwice, .detail = chain == 0 ? "from" : "to"};
  }
  for (std::size_t k = 0; k < pair.sides.sides.size(); ++k) {
    const BoundarySide& side = pair.sides.sides[k];
    const bool hasFace = side.face > 0 && useIn(index, side.edge, side.face);
    if (picks.isSetBack(pair.chainOf(k)) && !hasFace)
      return Error{.code = ErrorCode::SetbackWithoutFace, .edge = side.edge};
  }
  return std::nullopt;
}

/// The cuts of one chain; the notes of a drawn curve go to `notes`.
Result<std::vector<Cut>> cutsOf(const ShapeIndex& index,
                                const BlendPicks& picks,
                                const ChainPair& pair,
                                std::size_t chain,
                                std::vector<analysis::Note>& notes) {
  std::vector<Cut> cuts;
  if (!picks.isSetBack(chain)) return cuts;
  const auto [first, end] = pair.chain(chain);
  if (const std::vector<int>& drawn = picks.setbackCurve[chain]; !drawn.empty()) {
    auto laid = layOntoFaces(index, drawn, pair, chain);
    if (!laid) return fail(laid.error());
    notes.insert(notes.end(), laid->notes.begin(), laid->notes.end());
    for (std::size_t k = first; k < end; ++k) {
      const BoundarySide& side = pair.sides.sides[k];
      cuts.push_back(
          {side.edge, side.face, laid->onFace[side.face], ErrorCode::SetbackCurveBeside});
    }
    return cuts;
  }
  for (std::size_t k = first; k < end; ++k) {
    auto cut = cutOf(index, pair, k, picks.setback[chain]);
    if (!cut) return fail(cut.error());
    cuts.push_back(std::move(*cut));
  }
  return cuts;
}

/// What bears a number of the user's.
std::vector<int> ownNumbers(const std::map<int, int>& users, int user) {
  std::vector<int> numbers;
  for (const auto& [number, own] : users)
    if (own == user) numbers.push_back(number);
  return numbers;
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

/// How far the middle of an edge lies from another one, mm.
double middleTo(const TopoDS_Edge& edge, const TopoDS_Edge& other) {
  constexpr int kSamples = 32;
  const Eigen::Vector3d middle = EdgeCurve(edge, Direction::Forward).point(0.5);
  const EdgeCurve curve(other, Direction::Forward);
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kSamples; ++k)
    nearest = std::min(nearest, (curve.point(double(k) / kSamples) - middle).norm());
  return nearest;
}

/// The base while it is trimmed.
class Trimming {
 public:
  Trimming(const ShapeIndex& index,
           const std::vector<Cut>& cuts,
           const std::set<int>& drawn,
           BRepAlgoAPI_Splitter& splitter)
      : index_(index), cuts_(cuts), drawn_(drawn), images_(splitter) {}

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
      if (index_.uses(edge).empty() && !drawn_.contains(edge))
        for (const TopoDS_Shape& image : images_.of(index_.edge(edge))) staying.push_back(image);
    return compoundOf(staying);
  }

  /// The new base; fails with SetbackTooLarge, SetbackCurveBeside and EdgeNotInLoop.
  [[nodiscard]] Result<TrimmedBase> finish(const BlendPicks& picks, const ChainPair& pair) {
    TrimmedBase base{ShapeIndex(stayingFaces()), {}, {}, {}};
    ShapeMap edges, faces;
    TopExp::MapShapes(base.index.shape(), TopAbs_EDGE, edges);
    TopExp::MapShapes(base.index.shape(), TopAbs_FACE, faces);
    for (int edge = 1; edge <= index_.edgeCount(); ++edge)
      for (const int number : numbersOf(index_.edge(edge), edges))
        base.users.edges.emplace(number, edge);
    for (int face = 1; face <= index_.faceCount(); ++face)
      for (const int number : numbersOf(index_.face(face), faces))
        base.users.faces.emplace(number, face);
    if (const auto uncut = nameBorders(edges, base)) return fail(*uncut);
    if (const auto stray = translate(picks, pair, base)) return fail(*stray);
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
  /// Gives every new border the number of the edge that was set back to it, the nearest one where
  /// several were.
  std::optional<Error> nameBorders(const ShapeMap& edges, TrimmedBase& base) {
    std::map<int, double> nearest;
    for (const Cut& cut : cuts_) {
      std::set<int> border;
      for (const TopoDS_Edge& tool : cut.tools) border.merge(numbersOf(tool, edges));
      std::erase_if(border, [&](int number) { return base.index.uses(number).size() > 1; });
      if (border.empty()) return Error{.code = cut.without, .edge = cut.edge, .face = cut.face};
      for (const int number : border) {
        const double distance = middleTo(base.index.edge(number), index_.edge(cut.edge));
        const auto [known, isNew] = nearest.try_emplace(number, distance);
        if (!isNew && known->second <= distance) continue;
        known->second = distance;
        base.users.edges[number] = cut.edge;
      }
    }
    return std::nullopt;
  }
  /// The wishes in the base's numbers; fails where one is about an edge that was cut off.
  static std::optional<Error> translate(const BlendPicks& picks,
                                        const ChainPair& pair,
                                        TrimmedBase& base) {
    BlendPicks& inner = base.picks;
    inner.continuity = picks.continuity;
    inner.match = picks.match;
    inner.alignment = picks.alignment;
    for (const std::size_t chain : {0U, 1U})
      for (auto [k, end] = pair.chain(chain); k < end; ++k)
        for (const int number : ownNumbers(base.users.edges, pair.sides.sides[k].edge))
          (chain == 0 ? inner.from : inner.to).push_back(number);
    for (const auto& [edge, wish] : picks.edgeContinuity) {
      const std::vector<int> numbers = ownNumbers(base.users.edges, edge);
      if (numbers.empty()) return Error{.code = ErrorCode::EdgeNotInLoop, .edge = edge};
      for (const int number : numbers) inner.edgeContinuity[number] = wish;
    }
    for (const int edge : picks.ends) {
      const std::vector<int> numbers = ownNumbers(base.users.edges, edge);
      if (numbers.empty()) return Error{.code = ErrorCode::EdgeNotInLoop, .edge = edge};
      inner.ends.insert(inner.ends.end(), numbers.begin(), numbers.end());
    }
    for (const int face : picks.endFaces)
      for (const int number : ownNumbers(base.users.faces, face)) inner.endFaces.push_back(number);
    return std::nullopt;
  }

  const ShapeIndex& index_;
  const std::vector<Cut>& cuts_;
  const std::set<int>& drawn_;
  Images images_;
};

void split(const TopoDS_Shape& shape,
           const std::vector<Cut>& cuts,
           BRepAlgoAPI_Splitter& splitter) {
  TopTools_ListOfShape shapes, tools;
  shapes.Append(shape);
  ShapeMap different;  // edges of one face are cut off by one curve
  for (const Cut& cut : cuts)
    for (const TopoDS_Edge& tool : cut.tools) different.Add(tool);
  for (int k = 1; k <= different.Extent(); ++k) tools.Append(different(k));
  splitter.SetArguments(shapes);
  splitter.SetTools(tools);
  splitter.SetNonDestructive(true);
  splitter.Build();
}

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
  if (const auto wrong = checkSetback(index, picks, pair)) return fail(*wrong);
  return guarded([&]() -> Result<TrimmedBase> {
    std::vector<Cut> cuts;
    std::vector<analysis::Note> notes;
    std::set<int> drawn;
    for (const std::size_t chain : {0U, 1U}) {
      auto own = cutsOf(index, picks, pair, chain, notes);
      if (!own) return fail(own.error());
      std::move(own->begin(), own->end(), std::back_inserter(cuts));
      drawn.insert(picks.setbackCurve[chain].begin(), picks.setbackCurve[chain].end());
    }
    BRepAlgoAPI_Splitter splitter;
    split(index.shape(), cuts, splitter);
    if (splitter.HasErrors())
      return fail({.code = ErrorCode::Foreign, .detail = "the faces could not be set back"});
    auto base = Trimming(index, cuts, drawn, splitter).finish(picks, pair);
    if (base) base->notes = std::move(notes);
    return base;
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
