// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "core/base/result.h"
#include "core/height_field/height_jet.h"

namespace fairing::height_field {

/// What a place asks of the height: form . jet = right, in units of what it may be off by.
struct HeightRow {
  double u = 0.0, v = 0.0;
  JetForm form = JetForm::Zero();
  double right = 0.0;
  double weight = 1.0;  ///< of its square: the length it stands for
  int side = -1;        ///< of the loop; -1 for what lies inside
  /// Off by so many times what is allowed.
  [[nodiscard]] double residual(const Heights& heights) const {
    return form.dot(heights.jet(u, v)) - right;
  }
};

/// A square of the energy: weight (form . jet - right)^2 / 2 at a place.
struct EnergySquare {
  JetForm form = JetForm::Zero();
  double right = 0.0;
  double weight = 1.0;
};

/// The squares at several places of one cell of the grid, gathered as rows over its basis
/// functions.
class CellSquares {
 public:
  void add(const JetBasis& at, const EnergySquare& square);
  [[nodiscard]] bool isEmpty() const { return rights_.empty(); }

 private:
  friend class HeightSystem;
  JetBasis at_;               // of any place of the cell
  std::vector<double> rows_;  // one after the other
  std::vector<double> rights_;
};

/// Gathers an energy and rows over the poles of a height.
class HeightSystem {
 public:
  HeightSystem(spline::KnotVector u, spline::KnotVector v);

  void addRow(const HeightRow& row);
  void addEnergy(const CellSquares& cell);

  /// The poles of least energy among those that meet the rows best in the sense of least squares.
  /// Fails with SystemSingular or NotFinite.
  [[nodiscard]] Result<Heights> solve() const;
  /// 1/2 x'Kx - g'x.
  [[nodiscard]] double energy(const Heights& heights) const;
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const spline::KnotVector& knotsU() const { return u_; }
  [[nodiscard]] const spline::KnotVector& knotsV() const { return v_; }

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  /// A symmetric matrix over the poles of a grid, its lower half stored by offset.
  struct Stencil {
    Eigen::MatrixXd entries;  // one pole a column, one offset a row
  };
  void add(Stencil& stencil, const JetBasis& at, const Eigen::MatrixXd& block) const;
  [[nodiscard]] Sparse toSparse(const Stencil& stencil) const;
  [[nodiscard]] int index(const JetBasis& at, int local) const;

  spline::KnotVector u_, v_;
  Stencil energy_, squares_;
  Eigen::VectorXd load_, target_;
  int rows_ = 0;
};

}  // namespace fairing::height_field
