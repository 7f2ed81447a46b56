// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

namespace fairing::energy {

// |R_uuu + R_uvv|^2 + |R_uuv + R_vvv|^2
EnergyTerms triharmonic() {
  return {{1.0, {3, 0}, {3, 0}},
          {2.0, {3, 0}, {1, 2}},
          {1.0, {1, 2}, {1, 2}},
          {1.0, {2, 1}, {2, 1}},
          {2.0, {2, 1}, {0, 3}},
          {1.0, {0, 3}, {0, 3}}};
}

}  // namespace fairing::energy
