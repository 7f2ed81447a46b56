// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Poly_Triangulation.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/energy/guidance.h"

namespace fairing::occt {

/// A face that holds a mesh and no surface: how meshes are handed over and stored. Triangles name
/// their corners from 0. Fails with MeshInvalid (no triangle, a corner that is not there) and
/// MeshFlipped (neighbours that are turned against each other).
[[nodiscard]] Result<TopoDS_Shape> meshFace(
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& points,
    const Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>& triangles);

/// The mesh of an .stl file, its equal corners joined. Fails with FileUnreadable and as meshFace().
[[nodiscard]] Result<TopoDS_Shape> readMesh(const std::string& path);

/// Nearest points on a mesh, with normals that change linearly across its triangles from those of
/// their corners, the means of the triangles round them. Weight 0 beside the mesh's border. May be
/// asked from any thread.
[[nodiscard]] std::function<energy::GuidanceSample(const Eigen::Vector3d&)> referenceOnMesh(
    const Handle(Poly_Triangulation) & mesh);

}  // namespace fairing::occt
