// SPDX-License-Identifier: LGPL-2.1-or-later
// kiciak_2011 IN.txt -o OUT.txt: the bicubic blending patch of three rings of control points.
// docs/algorithms/kiciak.md says what it minimises.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "arguments.h"
#include "net_file.h"
#include "text/error_text.h"

namespace {

using namespace fairing;
using uniform_patch::BlendingOutcome;
using uniform_patch::BlendingReport;

enum Exit { kDone = 0, kNotConverged = 1, kNothingWritten = 2 };

void complain(const std::string& sentence) {
  fmt::print(stderr, "kiciak_2011: {}\n", sentence);
}

int complain(const Error& error) {
  complain(text::sentence(error));
  return kNothingWritten;
}

const char* name(BlendingOutcome outcome) {
  switch (outcome) {
    case BlendingOutcome::Converged:
      return "converged";
    case BlendingOutcome::StepLimit:
      return "step limit";
    case BlendingOutcome::Cancelled:
      return "cancelled";
    case BlendingOutcome::Stalled:
      return "stalled";
  }
  return "";
}

nlohmann::ordered_json summary(const BlendingReport& report) {
  return {{"T", report.triharmonic},
          {"S", report.shape},
          {"Q", report.parametrisation},
          {"F", report.value()},
          {"iterations", report.steps.size()},
          {"seconds", report.seconds},
          {"outcome", name(report.outcome)}};
}

nlohmann::ordered_json history(const BlendingReport& report) {
  nlohmann::ordered_json json = summary(report);
  json["c"] = report.c;
  json["steps"] = nlohmann::ordered_json::array();
  for (const uniform_patch::BlendingStep& step : report.steps)
    json["steps"].push_back({{"F", step.value},
                             {"slope", step.slope},
                             {"damping", step.damping},
                             {"length", step.length},
                             {"factorisations", step.factorisations},
                             {"corrections", step.corrections}});
  return json;
}

// One sentence for a result that is not what was asked for.
int judge(const kiciak::Arguments& arguments, const BlendingReport& report) {
  if (report.outcome == BlendingOutcome::Converged) return kDone;
  if (report.outcome == BlendingOutcome::StepLimit)
    complain(fmt::format("{} steps did not reach the minimum{}; the best net found is written.",
                         report.steps.size(),
                         arguments.weight > 0.0 ? "" : ", for C = 0 leaves the parameters open"));
  else
    complain("No step lowers F though its slope is not zero; the best net found is written.");
  return kNotConverged;
}

int run(const kiciak::Arguments& arguments) {
  const auto net = kiciak::readNet(arguments.in);
  if (!net) return complain(net.error());
  const uniform_patch::PatchOptions options = arguments.options();
  if (arguments.weight == 0.0 && arguments.functional == "blending")
    complain(
        "C = 0 minimises the shape alone and leaves the parametrisation open: expect many steps.");
  const auto result = uniform_patch::optimisePatch(*net, options);
  if (!result) return complain(result.error());
  if (const auto written = kiciak::writeNet(result->net, arguments.out); !written)
    return complain(written.error());
  if (!arguments.report.empty()) {
    std::ofstream file(arguments.report);
    file << history(result->report).dump(2) << '\n';
    file.close();
    if (!file) return complain({.code = ErrorCode::FileUnwritable, .detail = arguments.report});
  }
  fmt::print("{}\n", summary(result->report).dump());
  return judge(arguments, result->report);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Bicubic blending patches with optimised shape, after Kiciak 2011.", "kiciak_2011");
  app.footer(
      "Prints one line of JSON. Exit status: 0 minimum reached, 1 written without it, 2 nothing "
      "written.");
  kiciak::Arguments arguments;
  arguments.addTo(app);
  try {
    app.parse(argc, argv);
    return run(arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    complain(error.what());
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return kNothingWritten;
}
