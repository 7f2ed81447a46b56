// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/arguments.h"

#include <charconv>

#include "cli/guide_file.h"
#include "occt/reference.h"
#include "occt/shape_file.h"
#include "text/words.h"

namespace fairing::cli {
namespace {

Error unknown(const std::string& option, const std::string& word) {
  return {.code = ErrorCode::UnknownChoice, .detail = "\"" + word + "\" for " + option};
}

/// "7" or FreeCAD's "Edge7".
std::optional<int> parseNumber(std::string_view word, std::string_view name) {
  if (word.starts_with(name)) word.remove_prefix(name.size());
  int number = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (status != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

Result<std::vector<int>> parseNumbers(const std::vector<std::string>& words,
                                      const std::string& option,
                                      std::string_view name) {
  std::vector<int> numbers;
  for (const std::string& word : words) {
    const auto number = parseNumber(word, name);
    if (!number) return fail(unknown(option, word));
    numbers.push_back(*number);
  }
  return numbers;
}

void addList(CLI::App& command,
             const char* name,
             std::vector<std::string>& list,
             const char* help) {
  command.add_option(name, list, help)->delimiter(',')->allow_extra_args(false);
}

}  // namespace

void PickArguments::addTo(CLI::App& command) {
  addList(command,
          "--edges",
          edges,
          "edges of the hole, FreeCAD's numbers; one is enough (default: every hole)");
  addList(
      command, "--faces,--face", faces, "faces that are to be replaced: their border is the hole");
  command.add_option(
      "--continuity", continuity, "G0 or G1, of every edge with a face beside it (default G1)");
  addList(command, "--edge-continuity", edgeContinuity, "of single edges, such as 7=G0,9=G1");
  command.add_option("--tolerance", gap, "largest gap, mm (default: 1e-6 of the hole's diagonal)");
  command.add_option("--angle", angle, "largest angle along an edge, degrees (default 0.02)");
}

Result<occt::Picks> PickArguments::picks() const {
  occt::Picks result;
  const auto edgeNumbers = parseNumbers(edges, "--edges", "Edge");
  const auto faceNumbers = parseNumbers(faces, "--faces", "Face");
  if (!edgeNumbers) return fail(edgeNumbers.error());
  if (!faceNumbers) return fail(faceNumbers.error());
  result.edges = *edgeNumbers;
  result.faces = *faceNumbers;
  const auto common = text::continuityFrom(continuity);
  if (!common) return fail(unknown("--continuity", continuity));
  result.continuity = *common;
  for (const std::string& word : edgeContinuity) {
    const std::size_t sign = word.find('=');
    const auto edge = parseNumber(std::string_view(word).substr(0, sign), "Edge");
    const auto wish =
        sign == std::string::npos ? std::nullopt : text::continuityFrom(word.substr(sign + 1));
    if (!edge || !wish) return fail(unknown("--edge-continuity", word));
    result.edgeContinuity[*edge] = *wish;
  }
  return result;
}

Result<Tolerance> PickArguments::tolerance() const {
  Tolerance result;
  if (gap && !(*gap > 0.0)) return fail({.code = ErrorCode::ToleranceNotPositive, .value = *gap});
  result.gap = gap.value_or(result.gap);
  result.angle = angle.value_or(result.angle);
  return result;
}

void FillArguments::addTo(CLI::App& command) {
  command.add_option("SHAPE", shape, "the shape with the hole, .brep or .step")->required();
  command.add_option("-o,--out", out, "where the result goes, .brep or .step")->required();
  picks.addTo(command);
  command.add_option("--layout", layout, "auto or quad (default auto)");
  command.add_option("--energy", energy, "thin-plate or membrane (default thin-plate)");
  command.add_option("--lambda", lambda, "weight of the guiding normals (default 0)");
  command.add_option("--gamma", gamma, "weight of the reference surface (default 0)");
  command.add_option(
      "--reference", reference, "shape whose faces guide the surface: points and normals");
  command.add_option("--guide", guide, "JSON file with guiding normals");
  command.add_option("--degree", degree, "3 to 9 (default: chosen from the edges)");
  command.add_option("--max-poles", maxPoles, "largest number of control points (default 10000)");
  command.add_option("--result", result, "patches, shell or base (default patches)");
  command.add_option("--report", report, "JSON file for the numbers");
}

Result<FillOptions> FillArguments::options() const {
  FillOptions chosen;
  const auto layoutKind = text::layoutFrom(layout);
  const auto energyKind = text::energyFrom(energy);
  if (!layoutKind) return fail(unknown("--layout", layout));
  if (!energyKind) return fail(unknown("--energy", energy));
  chosen.layout = *layoutKind;
  chosen.energy = *energyKind;
  const auto tolerance = picks.tolerance();
  if (!tolerance) return fail(tolerance.error());
  chosen.tolerance = *tolerance;
  chosen.degree = degree;
  chosen.maxPoles = maxPoles;
  chosen.guidance.lambda = lambda;
  chosen.guidance.gamma = gamma;
  if (!guide.empty()) {
    auto handles = readGuide(guide);
    if (!handles) return fail(handles.error());
    chosen.guidance.handles = std::move(*handles);
  }
  if (!reference.empty()) {
    const auto faces = occt::readShape(reference);
    if (!faces) return fail(faces.error());
    auto nearest = occt::referenceOn(*faces);
    if (!nearest) return fail(nearest.error());
    chosen.guidance.reference = std::move(*nearest);
  }
  if (const auto error = validate(chosen)) return fail(*error);
  return chosen;
}

Result<occt::ResultMode> FillArguments::mode() const {
  const auto known = occt::resultModeFrom(result);
  if (!known) return fail(unknown("--result", result));
  return *known;
}

void ReportArguments::addTo(CLI::App& command) {
  command.add_option("SHAPE", shape, "the shape with the hole, .brep or .step")->required();
  command.add_option("PATCHES", patches, "the faces that fill it, .brep or .step")->required();
  picks.addTo(command);
  command.add_option("--report", report, "JSON file for the numbers");
}

}  // namespace fairing::cli
