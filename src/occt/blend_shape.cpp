// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <utility>

#include "core/blend/blend_ring.h"
#include "core/blend/natural_strip.h"
#include "occt/blend_notes.h"
#include "occt/make_faces.h"
#include "occt/setback.h"
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
                          Blend blend,
                          ResultMode mode) {
  FillResult& fill = blend.fill;
  auto& notes = fill.report.notes;
  notes.insert(notes.end(), base.notes.begin(), base.notes.end());
  for (const analysis::Note& note : blendNotes(base.index, sides, fill.patches))
    notes.push_back(inNumbersOf(note, base.users));
  boundary::BoundaryLoop named = inNumbersOf(sides, base.users);
  addSingularSupports(named, fill.report);
  const auto faces = makeFaces(fill);
  if (!faces) return fail(faces.error());
  const auto shape = joinResult(base.index, {}, {{*faces, sides, fill.report.largestGap}}, mode);
  if (!shape) return fail(inNumbersOf(shape.error(), base.users));
  return ShapeBlend{{*shape, std::move(fill), std::move(named)}, std::move(blend.natural)};
}

Result<ShapeBlend> strip(const Base& base,
                         const boundary::ChainPair& pair,
                         const BlendOptions& options,
                         ResultMode mode,
                         Progress* progress) {
  boundary::ChainPair named = pair;
  named.sides = inNumbersOf(std::move(named.sides), base.users);
  auto blend = blendChains(named, options, progress);
  if (!blend) return fail(blend.error());
  return joined(base, pair.sides, std::move(*blend), mode);
}

/// What is wished of two chains alone, if anything.
const char* wishOfPair(const BlendPicks& picks) {
  if (picks.isSetBack()) return "setback";
  if (!picks.pairs.empty()) return "pairs of vertices";
  if (picks.alignment != 0.0) return "alignment";
  if (picks.match != boundary::MatchKind::Auto) return "matching";
  return nullptr;
}

Result<ShapeBlend> junction(const Base& base,
                            const boundary::ChainRing& ring,
                            const BlendOptions& options,
                            ResultMode mode,
                            Progress* progress) {
  auto made = blendRing(ring, options, progress);
  if (!made) return fail(made.error());
  return joined(base, ring.sides, {std::move(*made), nullptr}, mode);
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
  if (!picks.isSetBack()) return strip({index}, pair, options, mode, progress);
  if (!picks.pairs.empty()) return fail({.code = ErrorCode::SetbackPairs});
  const auto trimmed = trimBack(index, picks, pair);
  if (!trimmed) return fail(trimmed.error());
  const auto inner = readChains(trimmed->index, trimmed->picks);
  if (!inner) return fail(inNumbersOf(inner.error(), trimmed->users));
  return strip({trimmed->index, trimmed->users, trimmed->notes}, *inner, options, mode, progress);
}

Result<ShapeBlend> reaching(const ShapeBlend& blend, const Reach& reach) {
  if (const auto error = validate(BlendOptions{.reach = reach})) return fail(*error);
  if (!blend.natural) return fail({.code = ErrorCode::JunctionReach, .value = reach.at(0, 0.0)});
  auto fill = blend.natural->reaching(reach);
  if (!fill) return fail(fill.error());
  addSingularSupports(blend.loop, fill->report);
  const auto faces = makeFaces(*fill);
  if (!faces) return fail(faces.error());
  return ShapeBlend{{*faces, std::move(*fill), blend.loop}, blend.natural};
}

}  // namespace fairing::occt
