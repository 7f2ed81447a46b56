// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <utility>

#include "core/blend/blend_loops.h"
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

/// What was spanned, in the base's own numbers, and the patches.
struct Blend {
  boundary::BoundaryLoop sides;
  FillResult result;
};

Result<Blend> strip(const Base& base, const BlendOptions& options, Progress* progress) {
  const auto pair = readChains(base.index, base.picks);
  if (!pair) return fail(pair.error());
  boundary::ChainPair named = *pair;
  named.sides = inNumbersOf(std::move(named.sides), base.users);
  auto made = blendChains(named, options, progress);
  if (!made) return fail(made.error());
  return Blend{pair->sides, std::move(*made)};
}

Result<Blend> junction(const Base& base, const BlendOptions& options, Progress* progress) {
  auto loops = readLoops(base.index, base.picks);
  if (!loops) return fail(loops.error());
  auto made = blendLoops(*loops, options, progress);
  if (!made) return fail(made.error());
  return Blend{std::move(*loops), std::move(*made)};
}

Result<ShapeFill> joined(const Base& base, Blend blend, ResultMode mode) {
  boundary::BoundaryLoop named = inNumbersOf(blend.sides, base.users);
  addSingularSupports(named, blend.result.report);
  const auto faces = makeFaces(blend.result);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(base.index, {}, {{*faces, blend.sides, blend.result.report.largestGap}}, mode);
  if (!shape) return fail(inNumbersOf(shape.error(), base.users));
  return ShapeFill{*shape, std::move(blend.result), std::move(named)};
}

}  // namespace

Result<ShapeFill> blendShape(const ShapeIndex& index,
                             const BlendPicks& picks,
                             const BlendOptions& options,
                             ResultMode mode,
                             Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  const auto blendOn = [&](const Base& base, auto span) -> Result<ShapeFill> {
    auto blend = span(base, options, progress);
    if (!blend) return fail(blend.error());
    return joined(base, std::move(*blend), mode);
  };
  const bool isSetBack = picks.setback != std::array<double, 2>{};
  const auto several = meansJunction(index, picks);
  if (!several) return fail(several.error());
  if (*several && isSetBack) return fail({.code = ErrorCode::JunctionWish, .detail = "setback"});
  if (*several) return blendOn({index, picks, {}}, junction);
  if (!isSetBack) return blendOn({index, picks, {}}, strip);
  const auto trimmed = trimBack(index, picks);
  if (!trimmed) return fail(trimmed.error());
  return blendOn({trimmed->index, trimmed->picks, trimmed->users}, strip);
}

}  // namespace fairing::occt
