// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

namespace fairing::energy {

EnergyTerms thinPlate() {
  return {{1.0, {2, 0}, {2, 0}}, {2.0, {1, 1}, {1, 1}}, {1.0, {0, 2}, {0, 2}}};
}

}  // namespace fairing::energy
