// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/options.h"

#include "cli/parse.h"
#include "text/words.h"

namespace fairing::cli {

void addList(CLI::App& command,
             const char* name,
             std::vector<std::string>& list,
             const char* help) {
  command.add_option(name, list, help)->delimiter(',')->allow_extra_args(false);
}

Result<std::map<int, Continuity>> continuityWishes(const std::vector<std::string>& words) {
  std::map<int, Continuity> wishes;
  for (const std::string& word : words) {
    const auto wish = parseWish(word);
    const auto asked = wish ? text::continuityFrom(wish->second) : std::nullopt;
    if (!asked) return fail(unknown("--edge-continuity", word));
    wishes[wish->first] = *asked;
  }
  return wishes;
}

Result<Tolerance> toleranceFrom(std::optional<double> gap, std::optional<double> angle) {
  Tolerance result;
  if (gap && !(*gap > 0.0)) return fail({.code = ErrorCode::ToleranceNotPositive, .value = *gap});
  result.gap = gap.value_or(result.gap);
  result.angle = angle.value_or(result.angle);
  return result;
}

Result<occt::ResultMode> modeFrom(const std::string& word) {
  const auto known = occt::resultModeFrom(word);
  if (!known) return fail(unknown("--result", word));
  return *known;
}

}  // namespace fairing::cli
