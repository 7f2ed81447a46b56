// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <utility>

#include "core/blend/blend_ring.h"
#include "core/boundary/strip_ends.h"
#include "occt/blend_notes.h"
#include "occt/make_faces.h"
#include "occt/read_ends.h"
#include "occt/setback.h"
#include "occt/slide_end.h"
#include "occt/support_notes.h"

namespace fairing::occt {
namespace {

/// The base of a blend, and the user's numbers for its edges and faces.
struct Base {
  const ShapeIndex& index;
  UserNumbers users = {};
  std::vector<analysis::Note> notes = {};  ///< on how it was made
};

/// `sides` in the base's own numbers.
Result<ShapeBlend> joined(const Base& base,
                          const boundary::BoundaryLoop& sides,
                          const std::vector<boundary::SideRange>& chains,
                          Blend blend,
                          const Reach& reach,
                          ResultMode mode) {
  FillResult& fill = blend.fill;
  auto& notes = fill.report.notes;
  notes.insert(notes.end(), base.notes.begin(), base.notes.end());
  for (const analysis::Note& note : blendNotes(base.index, sides, chains, fill.patches))
    notes.push_back(inNumbersOf(note, base.users));
  boundary::BoundaryLoop loop = inNumbersOf(sides, base.users);
  addSingularSupports(loop, fill.report);
  const auto faces = makeFaces(fill);
  if (!faces) return fail(faces.error());
  boundary::BoundaryLoop joints = sides;
  std::erase_if(joints.sides, [](const auto& side) { return side.edge == 0; });  // on a wall
  const auto shape = joinResult(base.index, {}, {{*faces, joints, fill.report.largestGap}}, mode);
  if (!shape) return fail(inNumbersOf(shape.error(), base.users));
  auto live = std::make_shared<LiveFill>(loop, blend.natural->options(), blend.natural->result());
  return ShapeBlend{
      {*shape, std::move(fill), std::move(loop), std::move(live)}, std::move(blend.natural), reach};
}

boundary::ChainPair named(boundary::ChainPair pair, const UserNumbers& users) {
  pair.sides = inNumbersOf(std::move(pair.sides), users);
  return pair;
}

/// The pair with what the ends are to follow. Where they slide on a face, a strip with free ends
/// there says where.
Result<boundary::ChainPair> ended(const Base& base,
                                  const boundary::ChainPair& chains,
                                  const BlendPicks& picks,
                                  const BlendOptions& options,
                                  Progress* progress) {
  auto read = readEnds(base.index, picks, chains);
  if (!read) return fail(inNumbersOf(read.error(), base.users));
  if (read->walls == std::array{0, 0}) return std::move(read->pair);
  BlendOptions natural = options;
  natural.reach = {};
  const auto free = blendChains(named(read->pair, base.users), natural, progress);
  if (!free) return fail(free.error());
  boundary::StripEnds ends = boundary::endsOf(read->pair);
  for (const std::size_t chain : {0, 1}) {
    if (read->walls[chain] == 0) continue;
    auto side = slidingEnd(base.index, read->walls[chain], read->pair, chain, free->fill.patches);
    if (!side) return fail(inNumbersOf(side.error(), base.users));
    ends[chain] = {std::move(*side)};
  }
  auto pair = boundary::withEnds(read->pair, ends);
  if (!pair) return fail(inNumbersOf(pair.error(), base.users));
  return pair;
}

Result<ShapeBlend> strip(const Base& base,
                         const boundary::ChainPair& chains,
                         const BlendPicks& picks,
                         const BlendOptions& options,
                         ResultMode mode,
                         Progress* progress) {
  const auto pair = ended(base, chains, picks, options, progress);
  if (!pair) return fail(pair.error());
  auto blend = blendChains(named(*pair, base.users), options, progress);
  if (!blend) return fail(blend.error());
  return joined(
      base, pair->sides, {pair->chain(0), pair->chain(1)}, std::move(*blend), options.reach, mode);
}

/// What is wished of two chains alone, if anything.
const char* wishOfPair(const BlendPicks& picks) {
  if (picks.isSetBack()) return "setback";
  if (!picks.pairs.empty()) return "pairs of vertices";
  if (picks.alignment != 0.0) return "alignment";
  if (picks.match != boundary::MatchKind::Auto) return "matching";
  if (picks.hasEnds()) return "ends";
  return nullptr;
}

Result<ShapeBlend> junction(const Base& base,
                            const boundary::ChainRing& ring,
                            const BlendOptions& options,
                            ResultMode mode,
                            Progress* progress) {
  auto made = blendRing(ring, options, progress);
  if (!made) return fail(made.error());
  return joined(base, ring.sides, ring.sides.chains(), std::move(*made), options.reach, mode);
}

}  // namespace

Result<ShapeBlend> blendShape(const ShapeIndex& index,
                              const BlendPicks& picks,
                              const BlendOptions& options,
                              ResultMode mode,
                              Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  const auto sides = readBlend(index, picks);
  if (!sides) return fail(sides.error());
  if (const auto* ring = std::get_if<boundary::ChainRing>(&*sides)) {
    if (const char* wish = wishOfPair(picks))
      return fail({.code = ErrorCode::JunctionWish, .detail = wish});
    return junction({index}, *ring, options, mode, progress);
  }
  const auto& pair = std::get<boundary::ChainPair>(*sides);
  if (!picks.cuts.empty()) return fail({.code = ErrorCode::CutUnfit, .edge = picks.cuts.front()});
  if (!picks.isSetBack()) return strip({index}, pair, picks, options, mode, progress);
  if (!picks.pairs.empty()) return fail({.code = ErrorCode::SetbackPairs});
  const auto trimmed = trimBack(index, picks, pair);
  if (!trimmed) return fail(trimmed.error());
  const auto inner = readChains(trimmed->index, trimmed->picks);
  if (!inner) return fail(inNumbersOf(inner.error(), trimmed->users));
  const Base base{trimmed->index, trimmed->users, trimmed->notes};
  return strip(base, *inner, trimmed->picks, options, mode, progress);
}

Result<ShapeBlend> reaching(const ShapeBlend& blend, const Reach& reach) {
  if (const auto error = validate(BlendOptions{.reach = reach})) return fail(*error);
  auto fill = blend.natural->reaching(reach);
  if (!fill) return fail(fill.error());
  return ShapeBlend{preview(blend, std::move(*fill)), blend.natural, reach};
}

}  // namespace fairing::occt
