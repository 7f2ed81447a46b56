// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/ribbon.h"

namespace fairing::boundary {

Ribbon reversed(const Ribbon& ribbon) {
  Ribbon result;
  result.curve = [curve = ribbon.curve](double t) {
    const CurveSample sample = curve(1.0 - t);
    return CurveSample{sample.point, -sample.derivative};
  };
  if (ribbon.polynomial) result.polynomial = spline::reversed(*ribbon.polynomial);
  for (auto b = ribbon.breaks.rbegin(); b != ribbon.breaks.rend(); ++b)
    result.breaks.push_back({1.0 - b->t, b->continuity});
  if (ribbon.hasSupport())
    result.support = [support = ribbon.support](double t) { return support(1.0 - t); };
  return result;
}

}  // namespace fairing::boundary
