// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/support_notes.h"

namespace fairing::occt {
namespace {

constexpr int kSamples = 33;  // along a side

}  // namespace

void addSingularSupports(const boundary::BoundaryLoop& loop, analysis::FillReport& report) {
  for (const boundary::BoundarySide& side : loop.sides) {
    if (side.continuity == Continuity::G0) continue;
    for (int i = 0; i < kSamples; ++i) {
      const auto support = side.ribbon.support(double(i) / (kSamples - 1));
      if (!support.singular && !support.isLimit) continue;
      report.notes.push_back({analysis::NoteCode::SupportSingular, side.edge, support.point});
      break;
    }
  }
}

}  // namespace fairing::occt
