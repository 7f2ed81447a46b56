// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <OSD.hxx>
#include <csignal>
#include <exception>

#include "cli/commands.h"
#include "cli/output.h"

namespace {

using fairing::cli::Outcome;

Outcome run(int argc, char** argv) {
  CLI::App app(
      "Fills holes in CAD shapes with fair B-spline faces that meet their neighbours smoothly.",
      "fairing");
  app.set_version_flag("--version", "fairing " FAIRING_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 within tolerance, 1 written but out of tolerance, 2 nothing written.");

  fairing::cli::FillArguments fill;
  CLI::App* fillCommand = app.add_subcommand("fill", "fill a hole, or every hole of a shape");
  fill.addTo(*fillCommand);

  fairing::cli::ReportArguments report;
  CLI::App* reportCommand =
      app.add_subcommand("report", "measure faces against the hole they fill");
  report.addTo(*reportCommand);

  fairing::cli::CompareArguments compare;
  CLI::App* compareCommand =
      app.add_subcommand("compare", "fill a hole with every energy and compare the shapes");
  compare.addTo(*compareCommand);

  fairing::cli::BlendArguments blend;
  CLI::App* blendCommand = app.add_subcommand("blend", "join two chains of edges by a strip");
  blend.addTo(*blendCommand);

  fairing::cli::CompareBlendArguments compareBlend;
  CLI::App* compareBlendCommand = app.add_subcommand(
      "compare-blend", "join two chains with every energy and compare the shapes");
  compareBlend.addTo(*compareBlendCommand);

  fairing::cli::EditArguments edit;
  CLI::App* editCommand = app.add_subcommand("edit", "shape a face anew under guidance");
  edit.addTo(*editCommand);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and --version
      app.exit(error);
      return Outcome::WithinTolerance;
    }
    fairing::cli::complain(error.what());
    return Outcome::NothingWritten;
  }
  if (*fillCommand) return fairing::cli::runFill(fill);
  if (*compareCommand) return fairing::cli::runCompare(compare);
  if (*compareBlendCommand) return fairing::cli::runCompareBlend(compareBlend);
  if (*reportCommand) return fairing::cli::runReport(report);
  if (*editCommand) return fairing::cli::runEdit(edit);
  return fairing::cli::runBlend(blend);
}

}  // namespace

int main(int argc, char** argv) {
  // The kernel's file readers rely on this: a reference to nothing in a damaged file becomes an
  // error instead of a crash. An interrupt is none, and keeps what it does.
  const auto interrupt = std::signal(SIGINT, SIG_DFL);
  OSD::SetSignal(false);
  std::signal(SIGINT, interrupt);
  try {
    return static_cast<int>(run(argc, argv));
  } catch (const std::exception& error) {
    fairing::cli::complain(error.what());
    return static_cast<int>(Outcome::NothingWritten);
  }
}
