// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <string>

namespace fairing::text {

/// Numbers with their units as people read them. Lengths and angles come in mm and degrees.
[[nodiscard]] std::string length(double mm);                    ///< "12 nm", "0.27 mm"
[[nodiscard]] std::string angle(double degrees);                ///< "0.004" and the degree sign
[[nodiscard]] std::string percent(double share);                ///< 0.031: "3.1 %"
[[nodiscard]] std::string point(const Eigen::Vector3d& where);  ///< "(12, 3.1, 0)"
[[nodiscard]] std::string number(double value);                 ///< four digits

}  // namespace fairing::text
