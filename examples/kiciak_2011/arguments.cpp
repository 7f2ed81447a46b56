// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arguments.h"

#include <CLI/CLI.hpp>

namespace fairing::kiciak {

using uniform_patch::FixedCurve;
using uniform_patch::PatchFunctional;
using uniform_patch::PatchStart;

void Arguments::addTo(CLI::App& app) {
  app.add_option("net", in, "control net: \"n m\", then n m lines \"x y z\"")->required();
  app.add_option("-o,--out", out, "where the optimised net goes, in the same format")->required();
  app.add_option("--c", weight, "weight C of the parametrisation beside the shape, free of units")
      ->capture_default_str();
  app.add_option("--start", start, "where the minimisation starts")
      ->check(CLI::IsMember({"triharmonic", "coons", "given"}))
      ->capture_default_str();
  app.add_option("--functional", functional, "what is minimised: F = S + c Q, or T alone")
      ->check(CLI::IsMember({"blending", "triharmonic"}))
      ->capture_default_str();
  app.add_option("--fix-u", fixU, "parameters u whose curves stay where the given net has them")
      ->delimiter(',');
  app.add_option("--fix-v", fixV, "the same of v")->delimiter(',');
  app.add_option(
         "--stretch", stretch, "factors of x, y, z before the minimisation, undone after it")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::PositiveNumber);
  app.add_option("--steps", steps, "most Newton steps")->check(CLI::Range(0, 1000000));
  app.add_option("--threads", threads, "the result is the same with any number")
      ->check(CLI::Range(1, 1024));
  app.add_option("--report", report, "JSON file for the values and the history of the steps");
}

uniform_patch::PatchOptions Arguments::options() const {
  uniform_patch::PatchOptions options;
  if (functional == "triharmonic") options.functional = PatchFunctional::Triharmonic;
  if (start == "coons") options.start = PatchStart::Coons;
  if (start == "given") options.start = PatchStart::Given;
  for (const double u : fixU) options.curves.push_back({FixedCurve::Constant::U, u});
  for (const double v : fixV) options.curves.push_back({FixedCurve::Constant::V, v});
  if (!stretch.empty()) options.transformation.diagonal() << stretch[0], stretch[1], stretch[2];
  options.blending.weight = weight;
  options.blending.stepLimit = steps;
  options.blending.threads = threads;
  return options;
}

}  // namespace fairing::kiciak
