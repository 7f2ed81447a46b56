// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "core/uniform_patch/optimise_patch.h"

namespace CLI {
class App;
}

namespace fairing::kiciak {

/// What the program is called with.
struct Arguments {
  std::string in, out, report;
  std::string start = "triharmonic", functional = "blending";
  double weight = 1e-3;
  std::vector<double> fixU, fixV;
  std::vector<double> stretch;
  int threads = 1;
  int steps = 100;

  void addTo(CLI::App& app);
  [[nodiscard]] uniform_patch::PatchOptions options() const;
};

}  // namespace fairing::kiciak
