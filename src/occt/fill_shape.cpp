// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_shape.h"

#include "occt/make_faces.h"
#include "occt/read_boundary.h"

namespace fairing::occt {

Result<ShapeFill> fillShape(const ShapeIndex& index,
                            const Picks& picks,
                            const FillOptions& options,
                            ResultMode mode,
                            Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  auto loop = readBoundary(index, picks);
  if (!loop) return fail(loop.error());
  auto fill = fillHole(*loop, options, progress);
  if (!fill) return fail(fill.error());
  const auto faces = makeFaces(*fill);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(index, picks.faces, {{*faces, *loop, fill->report.largestGap}}, mode);
  if (!shape) return fail(shape.error());
  return ShapeFill{*shape, std::move(*fill), std::move(*loop)};
}

}  // namespace fairing::occt
