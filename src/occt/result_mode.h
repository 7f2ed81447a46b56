// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <string_view>

namespace fairing::occt {

/// What is made of the new faces.
enum class ResultMode {
  Patches,  ///< the new faces as they are
  Shell,    ///< the new faces sewn to one shell
  Base,     ///< the new faces sewn into the shape; a solid where that closes it
};

/// The words the command line, Python and documents use: "patches", "shell", "base".
[[nodiscard]] constexpr std::string_view word(ResultMode mode) {
  switch (mode) {
    case ResultMode::Shell:
      return "shell";
    case ResultMode::Base:
      return "base";
    case ResultMode::Patches:
      break;
  }
  return "patches";
}

[[nodiscard]] constexpr std::optional<ResultMode> resultModeFrom(std::string_view text) {
  for (const ResultMode mode : {ResultMode::Patches, ResultMode::Shell, ResultMode::Base}) {
    if (text == word(mode)) return mode;
  }
  return std::nullopt;
}

}  // namespace fairing::occt
