// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tuple>

#include "cli/arguments.h"
#include "cli/options.h"
#include "cli/parse.h"
#include "text/words.h"

namespace fairing::cli {

namespace {

void addReach(CLI::App& command, const char* name, std::vector<double>& reach, const char* help) {
  command.add_option(name, reach, help)->delimiter(',')->expected(1, 2)->allow_extra_args(false);
}

Result<boundary::Departure> departure(const char* option, const std::string& word) {
  const auto known = text::departureFrom(word);
  if (!known) return fail(unknown(option, word));
  return *known;
}

boundary::Leaving leaving(bool flipped) {
  return flipped ? boundary::Leaving::Backwards : boundary::Leaving::Onwards;
}

Reach reachOf(const std::vector<double>& from, const std::vector<double>& to) {
  Reach reach{from.front(), to.front()};
  if (from.size() > 1) reach.end[0] = from[1];
  if (to.size() > 1) reach.end[1] = to[1];
  return reach;
}

}  // namespace

void BlendArguments::addTo(CLI::App& command) {
  addSides(command);
  solve.addResult(command);
}

void BlendArguments::addSides(CLI::App& command) {
  solve.addShape(command, "the shape with the edges, .brep or .step");
  addList(
      command, "--from", from, "edges of one side, FreeCAD's numbers; one of a chain is enough");
  addList(command, "--to", to, "edges of the other side");
  addList(command,
          "--edges",
          edges,
          "in place of --from and --to: edges of two chains, or of three and more round a hole");
  addList(command, "--cuts", cuts, "edges from rim to rim that show where a junction is cut");
  command.add_option(
      "--continuity", continuity, "G0, G1 or G2 to every face beside the blend (default G1)");
  addList(command, "--edge-continuity", edgeContinuity, "of single edges, such as 7=G0,9=G2");
  addReach(
      command,
      "--reach-from",
      reachFrom,
      "how far the blend reaches on the first side; 1 = what the energy likes best; two numbers "
      "such as 1,1.5: at the start of an open side and at its end");
  addReach(command, "--reach-to", reachTo, "the same on the other side");
  command.add_option("--departure-from",
                     departureFrom,
                     "direction in which the blend leaves the first side: free (default), "
                     "perpendicular to the edge, or iso, along the face's iso-curves");
  command.add_option("--departure-to", departureTo, "the same on the other side");
  command.add_flag("--flip-from", flipFrom, "leave the first side the other way, over its face");
  command.add_flag("--flip-to", flipTo, "the same on the other side");
  command.add_option(
      "--setback-from",
      setbackFrom,
      "mm: start inside the faces of the first side, at this distance from its edges; "
      "the faces are trimmed back to there");
  command.add_option("--setback-to", setbackTo, "the same on the other side");
  addList(command,
          "--from-curve",
          fromCurve,
          "edges drawn on the faces of the first side, or a little off them, that make one curve: "
          "start there, the faces trimmed back to it");
  addList(command, "--to-curve", toCurve, "the same on the other side");
  command.add_option("--match",
                     match,
                     "which points of the sides belong together: auto, length or corners (default "
                     "auto: corner to corner where both sides have as many)");
  command.add_option("--alignment",
                     alignment,
                     "of closed sides: how far the second one is turned from where the blend is "
                     "least twisted, as a share of its length, -0.5 to 0.5");
  addList(command, "--pair", pairs, "vertices of the sides that belong together, such as 3=7,4=8");
  addList(command, "--ends", ends, "edges that join the ends of open sides: the blend meets them");
  addList(command, "--end-faces", endFaces, "faces that the ends of the blend follow, such as 3,4");
  command.add_option("--tolerance", gap, "largest gap, mm (default: 1e-6 of the blend's diagonal)");
  command.add_option("--angle", angle, "largest angle along an edge, degrees (default 0.02)");
  guide.addTo(command);
  solve.addChoices(command);
}

Result<occt::BlendPicks> BlendArguments::picks(const occt::ShapeIndex& index) const {
  occt::BlendPicks picks;
  const auto wishes = continuityWishes(edgeContinuity);
  if (!wishes) return fail(wishes.error());
  picks.edgeContinuity = *wishes;
  const auto common = text::continuityFrom(continuity);
  if (!common) return fail(unknown("--continuity", continuity));
  picks.continuity = *common;
  picks.setback = {setbackFrom, setbackTo};
  const auto firstCurve = parseNumbers(fromCurve, "--from-curve", "Edge");
  if (!firstCurve) return fail(firstCurve.error());
  const auto secondCurve = parseNumbers(toCurve, "--to-curve", "Edge");
  if (!secondCurve) return fail(secondCurve.error());
  picks.setbackCurve = {*firstCurve, *secondCurve};
  const auto matching = text::matchFrom(match);
  if (!matching) return fail(unknown("--match", match));
  picks.match = *matching;
  picks.alignment = alignment;
  const auto joined = parsePairs(pairs, "--pair");
  if (!joined) return fail(joined.error());
  picks.pairs = *joined;
  for (const auto& [numbers, option, kind, picked] :
       {std::tuple{&ends, "--ends", "Edge", &picks.ends},
        {&endFaces, "--end-faces", "Face", &picks.endFaces},
        {&cuts, "--cuts", "Edge", &picks.cuts}}) {
    auto parsed = parseNumbers(*numbers, option, kind);
    if (!parsed) return fail(parsed.error());
    *picked = std::move(*parsed);
  }
  const auto first = parseNumbers(from, "--from", "Edge");
  if (!first) return fail(first.error());
  const auto second = parseNumbers(to, "--to", "Edge");
  if (!second) return fail(second.error());
  const auto all = parseNumbers(edges, "--edges", "Edge");
  if (!all) return fail(all.error());
  picks.from = *first;
  picks.to = *second;
  if (all->empty()) return picks;
  if (!first->empty() || !second->empty())
    return fail(unknown("--edges", "it stands in place of --from and --to"));
  auto groups = occt::groupEdges(index, *all);
  if (!groups) return fail(groups.error());
  if (groups->size() < 2) return fail({.code = ErrorCode::OneSideOnly, .detail = "to"});
  picks.ring = groups->size() > 2;
  picks.from = groups->front();
  for (std::size_t k = 1; k < groups->size(); ++k)
    picks.to.insert(picks.to.end(), (*groups)[k].begin(), (*groups)[k].end());
  return picks;
}

Result<BlendOptions> BlendArguments::options() const {
  auto common = solve.options(toleranceFrom(gap, angle));
  if (!common) return fail(common.error());
  auto guidance = guide.read();
  if (!guidance) return fail(guidance.error());
  common->guidance = std::move(*guidance);
  const auto first = departure("--departure-from", departureFrom);
  if (!first) return fail(first.error());
  const auto second = departure("--departure-to", departureTo);
  if (!second) return fail(second.error());
  const BlendOptions chosen{std::move(*common),
                            reachOf(reachFrom, reachTo),
                            {*first, *second},
                            {leaving(flipFrom), leaving(flipTo)}};
  if (const auto error = validate(chosen)) return fail(*error);
  return chosen;
}

}  // namespace fairing::cli
