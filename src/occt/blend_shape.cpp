// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include "occt/make_faces.h"
#include "occt/support_notes.h"

namespace fairing::occt {

Result<ShapeFill> blendShape(const ShapeIndex& index,
                             const BlendPicks& picks,
                             const BlendOptions& options,
                             ResultMode mode,
                             Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  auto pair = readChains(index, picks);
  if (!pair) return fail(pair.error());
  auto blend = blendChains(*pair, options, progress);
  if (!blend) return fail(blend.error());
  addSingularSupports(pair->sides, blend->report);
  const auto faces = makeFaces(*blend);
  if (!faces) return fail(faces.error());
  const auto shape = joinResult(index, {}, {{*faces, pair->sides, blend->report.largestGap}}, mode);
  if (!shape) return fail(shape.error());
  return ShapeFill{*shape, std::move(*blend), std::move(pair->sides)};
}

}  // namespace fairing::occt
