// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_shape.h"

#include "occt/inner_constraints.h"
#include "occt/make_faces.h"
#include "occt/read_boundary.h"

namespace fairing::occt {
namespace {

constexpr int kSamples = 33;  // along a side

/// A note for every side that is to be met tangentially and whose face has no normal somewhere.
std::vector<analysis::Note> singularSupports(const boundary::BoundaryLoop& loop) {
  std::vector<analysis::Note> notes;
  for (const boundary::BoundarySide& side : loop.sides) {
    if (side.continuity == Continuity::G0) continue;
    for (int i = 0; i < kSamples; ++i) {
      const auto support = side.ribbon.support(double(i) / (kSamples - 1));
      if (!support.singular && !support.isLimit) continue;
      notes.push_back({analysis::NoteCode::SupportSingular, side.edge, support.point});
      break;
    }
  }
  return notes;
}

}  // namespace

Result<ShapeFill> fillShape(const ShapeIndex& index,
                            const Picks& picks,
                            const FillOptions& options,
                            ResultMode mode,
                            Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  auto loop = readBoundary(index, picks);
  if (!loop) return fail(loop.error());
  if (const auto error = checkThrough(*loop, options.through)) return fail(*error);
  auto fill = fillHole(*loop, options, progress);
  if (!fill) return fail(fill.error());
  for (const analysis::Note& note : singularSupports(*loop)) fill->report.notes.push_back(note);
  const auto faces = makeFaces(*fill);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(index, picks.faces, {{*faces, *loop, fill->report.largestGap}}, mode);
  if (!shape) return fail(shape.error());
  return ShapeFill{*shape, std::move(*fill), std::move(*loop)};
}

}  // namespace fairing::occt
