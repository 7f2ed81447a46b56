// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <utility>

#include "core/blend/blend_loops.h"
#include "occt/make_faces.h"
#include "occt/support_notes.h"

namespace fairing::occt {

namespace {

/// What was spanned, and the patches.
struct Blend {
  boundary::BoundaryLoop sides;
  FillResult result;
};

Result<Blend> strip(const ShapeIndex& index,
                    const BlendPicks& picks,
                    const BlendOptions& options,
                    Progress* progress) {
  auto pair = readChains(index, picks);
  if (!pair) return fail(pair.error());
  auto made = blendChains(*pair, options, progress);
  if (!made) return fail(made.error());
  return Blend{std::move(pair->sides), std::move(*made)};
}

Result<Blend> junction(const ShapeIndex& index,
                       const BlendPicks& picks,
                       const BlendOptions& options,
                       Progress* progress) {
  auto loops = readLoops(index, picks);
  if (!loops) return fail(loops.error());
  auto made = blendLoops(*loops, options, progress);
  if (!made) return fail(made.error());
  return Blend{std::move(*loops), std::move(*made)};
}

}  // namespace

Result<ShapeFill> blendShape(const ShapeIndex& index,
                             const BlendPicks& picks,
                             const BlendOptions& options,
                             ResultMode mode,
                             Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  const auto several = meansJunction(index, picks);
  if (!several) return fail(several.error());
  auto blend = (*several ? junction : strip)(index, picks, options, progress);
  if (!blend) return fail(blend.error());
  FillResult& result = blend->result;
  addSingularSupports(blend->sides, result.report);
  const auto faces = makeFaces(result);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(index, {}, {{*faces, blend->sides, result.report.largestGap}}, mode);
  if (!shape) return fail(shape.error());
  return ShapeFill{*shape, std::move(result), std::move(blend->sides)};
}

}  // namespace fairing::occt
