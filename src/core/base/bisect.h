// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

/// Where something that holds at `inside` and not at `outside` ceases to: the last place found to
/// hold after `halvings` of the stretch between. `holds` takes a place.
template <class Holds>
[[nodiscard]] double bisect(double inside, double outside, int halvings, const Holds& holds) {
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace fairing
