// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/parse.h"

#include <algorithm>
#include <charconv>

namespace fairing::cli {

Error unknown(const std::string& option, const std::string& word) {
  return {.code = ErrorCode::UnknownChoice, .detail = "\"" + word + "\" for " + option};
}

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

std::optional<Eigen::Vector3d> parseVector(std::string_view word) {
  constexpr std::string_view kSeparators = " \t\r,;";
  Eigen::Vector3d vector;
  for (int k = 0; k < 3; ++k) {
    word.remove_prefix(std::min(word.find_first_not_of(kSeparators), word.size()));
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), vector[k]);
    if (status != std::errc()) return std::nullopt;
    word.remove_prefix(std::size_t(end - word.data()));
    if (k < 2 && (word.empty() || kSeparators.find(word.front()) == std::string_view::npos))
      return std::nullopt;
  }
  if (word.find_first_not_of(kSeparators) != std::string_view::npos) return std::nullopt;
  return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

Result<std::vector<std::pair<int, int>>> parsePairs(const std::vector<std::string>& words,
                                                    const std::string& option) {
  constexpr std::string_view kName = "Vertex";
  std::vector<std::pair<int, int>> pairs;
  for (const std::string& word : words) {
    const std::size_t sign = std::min(word.find('='), word.size());
    const std::string_view both = word;
    const auto a = parseNumber(both.substr(0, sign), kName);
    const auto b = parseNumber(both.substr(std::min(sign + 1, both.size())), kName);
    if (!a || !b) return fail(unknown(option, word));
    pairs.emplace_back(*a, *b);
  }
  return pairs;
}

std::optional<std::pair<int, std::string>> parseWish(std::string_view word) {
  const std::size_t sign = word.find('=');
  const auto edge = parseNumber(word.substr(0, sign), "Edge");
  if (!edge || sign == std::string_view::npos) return std::nullopt;
  return std::pair(*edge, std::string(word.substr(sign + 1)));
}

}  // namespace fairing::cli
