// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace fairing::benchmarks {

/// A shape with a hole, made with OpenCASCADE's own builders.
struct Hole {
  std::string name;
  TopoDS_Shape shape;
  int edge = 0;  ///< one edge of the hole, FreeCAD's EdgeN
};

/// Holes in sheets of one surface (torus, sphere, cylinder, saddle, waves) and a box corner where
/// three fillets of different radii meet, all with four sides; and manySidedHoles(). Sizes in mm,
/// about 10 to 100.
[[nodiscard]] std::vector<Hole> makeHoles();

}  // namespace fairing::benchmarks
