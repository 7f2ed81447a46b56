// SPDX-License-Identifier: LGPL-2.1-or-later
#include "net_file.h"

#include <fmt/format.h>

#include <fstream>

namespace fairing::kiciak {

using uniform_patch::ControlNet;

namespace {

// More along a direction than any patch has: a damaged file must not ask for all memory.
constexpr int kMost = 10000;

}  // namespace

Result<ControlNet> readNet(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail({.code = ErrorCode::FileUnreadable, .detail = path});
  const auto invalid = [&](const std::string& why) {
    return fail({.code = ErrorCode::NetInvalid, .detail = path + ": " + why});
  };
  ControlNet net;
  if (!(file >> net.rows >> net.columns) || std::min(net.rows, net.columns) < 1 ||
      std::max(net.rows, net.columns) > kMost)
    return invalid("it does not begin with two numbers of control points");
  net.points.resize(Eigen::Index(net.rows) * net.columns, 3);
  for (Eigen::Index k = 0; k < net.points.rows(); ++k)
    for (int c = 0; c < 3; ++c)
      if (!(file >> net.points(k, c)))
        return invalid(
            fmt::format("control point {} of {} is not three numbers", k + 1, net.points.rows()));
  if (std::string more; file >> more) return invalid("it goes on after the last control point");
  return net;
}

Result<void> writeNet(const ControlNet& net, const std::string& path) {
  std::ofstream file(path);
  file << fmt::format("{} {}\n", net.rows, net.columns);
  for (const auto& point : net.points.rowwise())
    file << fmt::format("{:.17g} {:.17g} {:.17g}\n", point[0], point[1], point[2]);
  file.close();
  if (!file) return fail({.code = ErrorCode::FileUnwritable, .detail = path});
  return {};
}

}  // namespace fairing::kiciak
