// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

namespace fairing::energy {

EnergyTerms membrane() {
  return {{1.0, {1, 0}, {1, 0}}, {1.0, {0, 1}, {0, 1}}};
}

}  // namespace fairing::energy
