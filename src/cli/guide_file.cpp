// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/guide_file.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace fairing::cli {
namespace {

using nlohmann::json;

Eigen::Vector3d vectorAt(const json& entry, const char* key) {
  const auto v = entry.at(key).get<std::array<double, 3>>();
  return {v[0], v[1], v[2]};
}

/// What is wrong with a handle, or nothing.
std::string trouble(const energy::NormalHandle& handle) {
  if (!handle.point.allFinite() || !handle.normal.allFinite()) return "a coordinate is not finite";
  if (!(handle.normal.norm() > 0.0)) return "its normal is zero";
  if (!(handle.weight >= 0.0) || !std::isfinite(handle.weight))
    return "its weight must be zero or more";
  if (!(handle.radius > 0.0) || !std::isfinite(handle.radius))
    return "its radius must be above zero";
  return {};
}

}  // namespace

Result<std::vector<energy::NormalHandle>> readGuide(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail({.code = ErrorCode::FileUnreadable, .detail = path});
  const auto invalid = [&](const std::string& why) {
    return fail({.code = ErrorCode::GuideInvalid, .detail = path + ": " + why});
  };
  const json guide = json::parse(file, nullptr, false);
  if (guide.is_discarded()) return invalid("it is not JSON");
  if (!guide.is_object() || !guide.contains("normals") || !guide["normals"].is_array()) {
    return invalid("it has no list called \"normals\"");
  }
  std::vector<energy::NormalHandle> handles;
  for (const json& entry : guide["normals"]) {
    const std::string which = "normal " + std::to_string(handles.size() + 1) + " is wrong, ";
    try {
      energy::NormalHandle handle{.point = vectorAt(entry, "point"),
                                  .normal = vectorAt(entry, "normal"),
                                  .weight = entry.value("weight", 1.0),
                                  .radius = entry.at("radius").get<double>()};
      if (const std::string why = trouble(handle); !why.empty()) return invalid(which + why);
      handle.normal.normalize();
      handles.push_back(handle);
    } catch (const json::exception&) {
      return invalid(which +
                     "it needs \"point\" and \"normal\" of three numbers each and a \"radius\"");
    }
  }
  return handles;
}

}  // namespace fairing::cli
