// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <utility>

#include "core/blend/blend_loops.h"
#include "core/blend/natural_strip.h"
#include "occt/blend_notes.h"
#include "occt/make_faces.h"
#include "occt/setback.h"
#include "occt/support_notes.h"

namespace fairing::occt {
namespace {

/// The base of a blend, and the user's numbers for its edges.
struct Base {
  const ShapeIndex& index;
  const BlendPicks& picks;
  UserNumbers users;
};

/// What was spanned, in the base's own numbers, and how.
struct Spanned {
  boundary::BoundaryLoop sides;
  Blend blend;
};

Result<Spanned> strip(const Base& base, const BlendOptions& options, Progress* progress) {
  const auto pair = readChains(base.index, base.picks);
  if (!pair) return fail(pair.error());
  boundary::ChainPair named = *pair;
  named.sides = inNumbersOf(std::move(named.sides), base.users);
  auto made = blendChains(named, options, progress);
  if (!made) return fail(made.error());
  addBlendNotes(base.index, *pair, made->fill);
  return Spanned{pair->sides, std::move(*made)};
}

Result<Spanned> junction(const Base& base, const BlendOptions& options, Progress* progress) {
  auto loops = readLoops(base.index, base.picks);
  if (!loops) return fail(loops.error());
  auto made = blendLoops(*loops, options, progress);
  if (!made) return fail(made.error());
  return Spanned{std::move(*loops), {std::move(*made), nullptr}};
}

Result<ShapeBlend> joined(const Base& base, Spanned spanned, ResultMode mode) {
  FillResult& fill = spanned.blend.fill;
  boundary::BoundaryLoop named = inNumbersOf(spanned.sides, base.users);
  addSingularSupports(named, fill.report);
  const auto faces = makeFaces(fill);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(base.index, {}, {{*faces, spanned.sides, fill.report.largestGap}}, mode);
  if (!shape) return fail(inNumbersOf(shape.error(), base.users));
  return ShapeBlend{{*shape, std::move(fill), std::move(named)}, std::move(spanned.blend.natural)};
}

}  // namespace

Result<ShapeBlend> blendShape(const ShapeIndex& index,
                              const BlendPicks& picks,
                              const BlendOptions& options,
                              ResultMode mode,
                              Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  const auto blendOn = [&](const Base& base, auto span) -> Result<ShapeBlend> {
    auto spanned = span(base, options, progress);
    if (!spanned) return fail(spanned.error());
    return joined(base, std::move(*spanned), mode);
  };
  const bool isSetBack = picks.setback != std::array<double, 2>{};
  const auto several = meansJunction(index, picks);
  if (!several) return fail(several.error());
  if (*several && isSetBack) return fail({.code = ErrorCode::JunctionWish, .detail = "setback"});
  if (*several) return blendOn({index, picks, {}}, junction);
  if (!isSetBack) return blendOn({index, picks, {}}, strip);
  if (!picks.pairs.empty()) return fail({.code = ErrorCode::SetbackPairs});
  const auto trimmed = trimBack(index, picks);
  if (!trimmed) return fail(trimmed.error());
  return blendOn({trimmed->index, trimmed->picks, trimmed->users}, strip);
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
