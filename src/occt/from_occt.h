// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace fairing::occt {

inline Eigen::Vector3d fromOcct(const gp_XYZ& a) {
  return {a.X(), a.Y(), a.Z()};
}
inline Eigen::Vector3d fromOcct(const gp_Pnt& a) {
  return fromOcct(a.XYZ());
}
inline Eigen::Vector3d fromOcct(const gp_Vec& a) {
  return fromOcct(a.XYZ());
}

inline gp_Pnt toPoint(const Eigen::Vector3d& a) {
  return {a.x(), a.y(), a.z()};
}

}  // namespace fairing::occt
