// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/finish_on_interrupt.h"
#include "cli/output.h"
#include "occt/edit_face.h"
#include "occt/shape_file.h"
#include "text/edit_text.h"

namespace fairing::cli {

Outcome runEdit(const EditArguments& arguments) {
  const auto face = arguments.number();
  if (!face) return complain(face.error());
  const auto options = arguments.options();
  if (!options) return complain(options.error());
  if (const auto writable = checkOutputs(arguments.out, arguments.report); !writable)
    return complain(writable.error());
  const auto shape = occt::readShape(arguments.shape);
  if (!shape) return complain(shape.error());
  FinishOnInterrupt interrupt;
  const auto edited = occt::editFace(
      occt::ShapeIndex(*shape), *face, *options, occt::ResultMode::Patches, interrupt.progress());
  if (!edited) return complain(edited.error());
  const auto written = occt::writeShape(edited->shape, arguments.out);
  if (!written) return complain(written.error());
  fmt::print("{}", text::table(edited->edit.report));
  if (!arguments.report.empty()) {
    const nlohmann::json report = text::toJson(edited->edit);
    if (const auto told = writeJson(report, arguments.report); !told) complain(told.error());
  }
  return Outcome::WithinTolerance;
}

}  // namespace fairing::cli
