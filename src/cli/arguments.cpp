// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/arguments.h"

#include "cli/guide_file.h"
#include "cli/options.h"
#include "cli/parse.h"
#include "cli/through.h"
#include "occt/inner_constraints.h"
#include "text/words.h"

namespace fairing::cli {
namespace {

void addRepeated(CLI::App& command,
                 const char* name,
                 std::vector<std::string>& list,
                 const char* help) {
  command.add_option(name, list, help)->allow_extra_args(false);
}

using Directions = std::map<int, occt::EdgeDirection>;

/// "7=0,0,1" into the directions of edges.
Result<void> addDirections(const std::vector<std::string>& words,
                           const std::string& option,
                           occt::EdgeDirection::Kind kind,
                           Directions& directions) {
  for (const std::string& word : words) {
    const auto wish = parseWish(word);
    const auto direction = wish ? parseVector(wish->second) : std::nullopt;
    if (!direction || !(direction->norm() > 0.0)) return fail(unknown(option, word));
    directions[wish->first] = {*direction, kind};
  }
  return {};
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
      "--continuity", continuity, "G0, G1 or G2 to every face beside the hole (default G1)");
  addList(command, "--edge-continuity", edgeContinuity, "of single edges, such as 7=G0,9=G2");
  addRepeated(command,
              "--tangent",
              tangents,
              "EDGE=x,y,z: a direction in the tangent plane along an edge, in place of a face");
  addRepeated(command,
              "--symmetry",
              symmetries,
              "EDGE=x,y,z: normal of a symmetry plane that an edge lies in");
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
  const auto wishes = continuityWishes(edgeContinuity);
  if (!wishes) return fail(wishes.error());
  result.edgeContinuity = *wishes;
  using Kind = occt::EdgeDirection::Kind;
  const auto added = addDirections(tangents, "--tangent", Kind::Tangent, result.directions);
  if (!added) return fail(added.error());
  const auto mirrored = addDirections(symmetries, "--symmetry", Kind::Symmetry, result.directions);
  if (!mirrored) return fail(mirrored.error());
  return result;
}

Result<Tolerance> PickArguments::tolerance() const {
  return toleranceFrom(gap, angle);
}

void SolveArguments::addShape(CLI::App& command, const char* whatShape) {
  command.add_option("SHAPE", shape, whatShape)->required();
}

void SolveArguments::addResult(CLI::App& command) {
  command.add_option("-o,--out", out, "where the result goes, .brep or .step")->required();
  command.add_option(
      "--energy",
      energy,
      "thin-plate, membrane, mean-curvature-gradient, "
      "mean-curvature-gradient-minimum, minimum-variation, total-curvature or triharmonic "
      "(default " +
          energy + ")");
  command.add_option("--result", result, "patches, shell or base (default patches)");
}

void SolveArguments::addChoices(CLI::App& command) {
  command.add_option(
      "--quadrature", quadrature, "gauss or lobatto, for energies of the shape (default gauss)");
  command.add_option("--quadrature-points",
                     quadraturePoints,
                     "points a span and direction, 2 to 32 (default: chosen from the degree)");
  command.add_option(
      "--inner-continuity", inner, "how patches meet each other, G1 or G2 (default G1)");
  command.add_option("--degree", degree, "3 to 9 (default: chosen from the edges)");
  command.add_option("--max-poles",
                     maxPoles,
                     "largest number of control points (default " + std::to_string(maxPoles) + ")");
  command.add_option("--report", report, "JSON file for the numbers");
}

Result<FillOptions> SolveArguments::options(const Result<Tolerance>& tolerance) const {
  const auto energyKind = text::energyFrom(energy);
  if (!energyKind) return fail(unknown("--energy", energy));
  const auto between = text::continuityFrom(inner);
  if (!between || *between == Continuity::G0) return fail(unknown("--inner-continuity", inner));
  if (!tolerance) return fail(tolerance.error());
  const auto family = text::quadratureFrom(quadrature);
  if (!family) return fail(unknown("--quadrature", quadrature));
  FillOptions chosen;
  chosen.inner = *between;
  chosen.energy = *energyKind;
  chosen.quadrature = {quadraturePoints, *family};
  chosen.tolerance = *tolerance;
  chosen.degree = degree;
  chosen.maxPoles = maxPoles;
  return chosen;
}

Result<occt::ResultMode> SolveArguments::mode() const {
  return modeFrom(result);
}

void GuideArguments::addTo(CLI::App& command) {
  command.add_option("--lambda", lambda, "weight of the guiding normals (default 0)");
  command.add_option("--gamma", gamma, "weight of the reference surface (default 0)");
  command.add_option(
      "--reference", reference, "shape whose faces guide the surface: points and normals");
  command.add_option("--guide", guide, "JSON file with guiding normals: handles, a field");
}

Result<energy::Guidance> GuideArguments::read() const {
  return readGuidance(lambda, gamma, guide, reference);
}

void FillArguments::addTo(CLI::App& command) {
  addHole(command);
  command.add_flag("--outer", outer, "fill outer borders, too, where no edge is given");
  solve.addResult(command);
}

void FillArguments::addHole(CLI::App& command) {
  solve.addShape(command, "the shape with the hole, .brep or .step");
  picks.addTo(command);
  command.add_option("--layout", layout, "auto, quad, star, o-grid or trimmed (default auto)");
  addRepeated(
      command,
      "--through",
      through,
      "x,y,z: a point to pass through; or a file: the edges and lone vertices of a shape, or "
      "points, one a line");
  addList(command, "--through-edges", throughEdges, "edges of SHAPE to pass through");
  addList(command, "--through-vertices", throughVertices, "vertices of SHAPE to pass through");
  guide.addTo(command);
  solve.addChoices(command);
}

Result<FillOptions> FillArguments::options() const {
  const auto layoutKind = text::layoutFrom(layout);
  if (!layoutKind) return fail(unknown("--layout", layout));
  auto chosen = solve.options(picks.tolerance());
  if (!chosen) return chosen;
  chosen->layout = *layoutKind;
  auto guidance = guide.read();
  if (!guidance) return fail(guidance.error());
  chosen->guidance = std::move(*guidance);
  if (const auto error = validate(*chosen)) return fail(*error);
  return chosen;
}

Result<std::vector<InnerConstraint>> FillArguments::innerConstraints(
    const occt::ShapeIndex& index) const {
  std::vector<InnerConstraint> all;
  for (const std::string& word : through) {
    auto read = readThrough(word);
    if (!read) return fail(read.error());
    all.insert(all.end(), read->begin(), read->end());
  }
  const auto edges = parseNumbers(throughEdges, "--through-edges", "Edge");
  if (!edges) return fail(edges.error());
  const auto vertices = parseNumbers(throughVertices, "--through-vertices", "Vertex");
  if (!vertices) return fail(vertices.error());
  const auto parts = occt::throughParts(index, *edges, *vertices);
  if (!parts) return fail(parts.error());
  all.insert(all.end(), parts->begin(), parts->end());
  return all;
}

void EditArguments::addTo(CLI::App& command) {
  command.add_option("SHAPE", shape, "the shape with the face, .brep or .step")->required();
  command.add_option("-o,--out", out, "where the new face goes, .brep or .step")->required();
  command.add_option("--face", face, "the face to edit, FreeCAD's number")->required();
  command.add_option("--energy", energy, "thin-plate or membrane (default thin-plate)");
  command.add_option("--keep",
                     keep,
                     "G0, G1 or G2: what stays along the border (default G1; G0 for the membrane)");
  guide.addTo(command);
  command.add_option(
      "--degree", degree, "3 to 9: raise the face's degree to it (default: its own)");
  command.add_option(
      "--spans",
      spans,
      "1 to 64: split the face into as many along each direction (default: its own)");
  command.add_option("--report", report, "JSON file for the numbers");
}

Result<EditOptions> EditArguments::options() const {
  EditOptions chosen;
  const auto energyKind = text::energyFrom(energy);
  if (!energyKind) return fail(unknown("--energy", energy));
  chosen.energy = *energyKind;
  if (!keep.empty()) {
    chosen.keep = text::continuityFrom(keep);
    if (!chosen.keep) return fail(unknown("--keep", keep));
  }
  chosen.degree = degree;
  chosen.spans = spans;
  auto guidance = guide.read();
  if (!guidance) return fail(guidance.error());
  chosen.guidance = std::move(*guidance);
  if (const auto error = validate(chosen)) return fail(*error);
  return chosen;
}

Result<int> EditArguments::number() const {
  const auto numbers = parseNumbers({face}, "--face", "Face");
  if (!numbers) return fail(numbers.error());
  return numbers->front();
}

void EnergyArguments::addTo(CLI::App& command) {
  addList(command, "--energies", words, "which to compare (default: all)");
}

Result<std::vector<EnergyKind>> EnergyArguments::read() const {
  if (words.empty()) return text::allEnergies();
  std::vector<EnergyKind> energies;
  for (const std::string& word : words) {
    const auto energy = text::energyFrom(word);
    if (!energy) return fail(unknown("--energies", word));
    energies.push_back(*energy);
  }
  return energies;
}

void CompareArguments::addTo(CLI::App& command) {
  fill.addHole(command);
  energies.addTo(command);
}

void CompareBlendArguments::addTo(CLI::App& command) {
  blend.addSides(command);
  energies.addTo(command);
}

void ReportArguments::addTo(CLI::App& command) {
  command.add_option("SHAPE", shape, "the shape with the hole, .brep or .step")->required();
  command.add_option("PATCHES", patches, "the faces that fill it, .brep or .step")->required();
  picks.addTo(command);
  command.add_option("--report", report, "JSON file for the numbers");
}

}  // namespace fairing::cli
