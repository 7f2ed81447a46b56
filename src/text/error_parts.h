// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "text/quantities.h"

/// Parts that sentences on errors are made of.
namespace fairing::text {

[[nodiscard]] inline std::string at(const Error& e) {
  return e.where ? " at " + point(*e.where) : std::string();
}

[[nodiscard]] inline std::string edge(const Error& e) {
  return fmt::format("Edge {}", e.edge);
}

[[nodiscard]] inline long count(const Error& e) {
  return std::lround(e.value);
}

}  // namespace fairing::text
