// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

/// Words of the command line as numbers.
namespace fairing::cli {

/// UnknownChoice: a word that an option does not understand.
[[nodiscard]] Error unknown(const std::string& option, const std::string& word);

/// "7" or FreeCAD's "Edge7", with name "Edge".
[[nodiscard]] std::optional<int> parseNumber(std::string_view word, std::string_view name);
/// The same for a list. Fails with UnknownChoice.
[[nodiscard]] Result<std::vector<int>> parseNumbers(const std::vector<std::string>& words,
                                                    const std::string& option,
                                                    std::string_view name);
/// Three finite numbers, separated by commas, semicolons or blanks.
[[nodiscard]] std::optional<Eigen::Vector3d> parseVector(std::string_view word);
/// "3=7" or "Vertex3=Vertex7" as vertices 3 and 7. Fails with UnknownChoice.
[[nodiscard]] Result<std::vector<std::pair<int, int>>> parsePairs(
    const std::vector<std::string>& words, const std::string& option);
/// "7=G0" as edge 7 and "G0".
[[nodiscard]] std::optional<std::pair<int, std::string>> parseWish(std::string_view word);

}  // namespace fairing::cli
