// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <optional>

namespace fairing::solver {

/// A symmetric matrix whose entries vanish farther than `width` from the diagonal; the lower half
/// is kept, densely.
class BandMatrix {
 public:
  BandMatrix(int size, int width);

  [[nodiscard]] int size() const { return size_; }
  /// Entry (i, j) for 0 <= i - j <= width.
  [[nodiscard]] double& at(int i, int j) { return data_[place(i, j)]; }
  [[nodiscard]] double at(int i, int j) const { return data_[place(i, j)]; }
  void scale(double factor) { data_ *= factor; }
  /// Adds factor * (other (x) I3): a matrix of points that acts on each of their coordinates.
  void addThreefold(double factor, const BandMatrix& other);
  [[nodiscard]] Eigen::MatrixXd operator*(const Eigen::MatrixXd& right) const;

 private:
  friend class BandCholesky;
  using Stride = Eigen::OuterStride<>;
  using Block = Eigen::Ref<Eigen::MatrixXd, 0, Stride>;
  using ConstBlock = Eigen::Ref<const Eigen::MatrixXd, 0, Stride>;

  [[nodiscard]] Eigen::Index place(int i, int j) const {
    return Eigen::Index(j) * stride_ + (i - j);
  }
  /// A dense block whose first column starts at (i, j) and that reaches no farther than a block
  /// beyond the band. Only what lies on or below the diagonal belongs to the matrix.
  [[nodiscard]] Block block(int i, int j, int rows, int columns);
  [[nodiscard]] ConstBlock block(int i, int j, int rows, int columns) const;

  int size_, width_, stride_;
  Eigen::VectorXd data_;  // column j from its diagonal downwards, `stride` entries, the last ones 0
};

/// The Cholesky factor L of a banded matrix A = L L'. L has the same band.
class BandCholesky {
 public:
  /// Takes the matrix over; nothing if it is not positive definite. Cost size * width^2, shared by
  /// so many threads; the result does not depend on their number, to the last bit.
  [[nodiscard]] static std::optional<BandCholesky> factor(BandMatrix matrix, int threads = 1);

  /// The X of A X = right, right size x k.
  [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd right) const;

 private:
  static void eliminate(BandMatrix& matrix, int j, int columns, int threads);
  explicit BandCholesky(BandMatrix matrix) : factor_(std::move(matrix)) {}
  BandMatrix factor_;
};

}  // namespace fairing::solver
