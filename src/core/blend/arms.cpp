// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/arms.h"

namespace fairing {

std::array<Arm, 2> armsOf(const Patches& strip) {
  const spline::BsplineSurface& patch = strip[strip.size() / 2];
  const double middle = 0.5 * (patch.u.first() + patch.u.last());
  const double leg = (patch.v.last() - patch.v.first()) / 3.0;
  const auto south = patch.jet(middle, patch.v.first()), north = patch.jet(middle, patch.v.last());
  return {Arm{south.point, leg * south.v}, Arm{north.point, -leg * north.v}};
}

}  // namespace fairing
