// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/arguments.h"
#include "cli/options.h"
#include "cli/parse.h"
#include "text/words.h"

namespace fairing::cli {

void BlendArguments::addTo(CLI::App& command) {
  solve.addFiles(command, "the shape with the edges, .brep or .step");
  addList(
      command, "--from", from, "edges of one side, FreeCAD's numbers; one of a chain is enough");
  addList(command, "--to", to, "edges of the other side");
  addList(command,
          "--edges",
          edges,
          "in place of --from and --to: edges of two chains, or of three and more closed ones");
  command.add_option(
      "--continuity", continuity, "G0, G1 or G2 to every face beside the blend (default G1)");
  addList(command, "--edge-continuity", edgeContinuity, "of single edges, such as 7=G0,9=G2");
  command.add_option("--reach-from",
                     reachFrom,
                     "how far the blend reaches on the first side; 1 = what the energy likes best");
  command.add_option("--reach-to", reachTo, "the same on the other side");
  command.add_option("--tolerance", gap, "largest gap, mm (default: 1e-6 of the blend's diagonal)");
  command.add_option("--angle", angle, "largest angle along an edge, degrees (default 0.02)");
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
  picks.from = groups->front();
  for (std::size_t k = 1; k < groups->size(); ++k)
    picks.to.insert(picks.to.end(), (*groups)[k].begin(), (*groups)[k].end());
  return picks;
}

Result<BlendOptions> BlendArguments::options() const {
  auto common = solve.options(toleranceFrom(gap, angle));
  if (!common) return fail(common.error());
  BlendOptions chosen{std::move(*common), {reachFrom, reachTo}};
  if (const auto error = validate(chosen)) return fail(*error);
  return chosen;
}

}  // namespace fairing::cli
