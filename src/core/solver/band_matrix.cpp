// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/band_matrix.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

// Columns lie one after the other, each from its diagonal on, so that the entry to the right of
// another is stride - 1 farther: dense blocks of the band are ordinary matrices with that stride,
// and the factorisation is the dense blocked one, right-looking, cut off at the band
// [AndersonEtAl1999] routine pbtrf. What lies above the diagonal of such a block falls onto the
// zeros at the end of earlier columns and is not touched.

namespace fairing::solver {
namespace {

// Columns factored at once: enough for products of blocks, few beside the band. From 32 to 96 there
// is little between them at a width of 370.
constexpr int kBlock = 48;

// Rows and columns of the tiles that threads take one by one: the same whatever their number, and
// with it every rounding.
constexpr int kTile = 96;

}  // namespace

BandMatrix::BandMatrix(int size, int width)
    : size_(size), width_(std::min(width, size - 1)), stride_(width_ + kBlock) {
  data_.setZero(Eigen::Index(size_) * stride_);
}

BandMatrix::Block BandMatrix::block(int i, int j, int rows, int columns) {
  return Eigen::Map<Eigen::MatrixXd, 0, Stride>(
      data_.data() + place(i, j), rows, columns, Stride(stride_ - 1));
}

BandMatrix::ConstBlock BandMatrix::block(int i, int j, int rows, int columns) const {
  return Eigen::Map<const Eigen::MatrixXd, 0, Stride>(
      data_.data() + place(i, j), rows, columns, Stride(stride_ - 1));
}

Eigen::MatrixXd BandMatrix::operator*(const Eigen::MatrixXd& right) const {
  FAIRING_ASSERT(right.rows() == size_);
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(size_, right.cols());
  for (int j = 0; j < size_; ++j) {
    const int below = std::min(width_, size_ - 1 - j);
    const auto column = data_.segment(place(j, j), below + 1);
    product.middleRows(j, below + 1) += column * right.row(j);
    product.row(j) += column.tail(below).transpose() * right.middleRows(j + 1, below);
  }
  return product;
}

void BandMatrix::addThreefold(double factor, const BandMatrix& other) {
  FAIRING_ASSERT(size_ == 3 * other.size_ && width_ >= 3 * other.width_);
  for (int j = 0; j < other.size_; ++j)
    for (int i = j; i <= std::min(j + other.width_, other.size_ - 1); ++i)
      for (int c = 0; c < 3; ++c) at(3 * i + c, 3 * j + c) += factor * other.at(i, j);
}

// What is below a factored diagonal block, tile by tile: first its own columns, then what they take
// from those to the right.
void BandCholesky::eliminate(BandMatrix& matrix, int j, int columns, int threads) {
  const int next = j + columns, below = std::min(matrix.width_, matrix.size_ - next);
  const int tiles = (below + kTile - 1) / kTile;
  const auto heightFrom = [&](int tile) { return std::min(kTile, below - tile * kTile); };
  const auto panel = [&](int tile, int height) {
    return matrix.block(next + tile * kTile, j, height, columns);
  };
  parallelFor(threads, tiles, [&](int tile) {
    BandMatrix::Block rows = panel(tile, heightFrom(tile));
    matrix.block(j, j, columns, columns)
        .triangularView<Eigen::Lower>()
        .transpose()
        .solveInPlace<Eigen::OnTheRight>(rows);
  });
  parallelFor(threads, tiles, [&](int tile) {
    const int width = heightFrom(tile), at = next + tile * kTile,
              left = below - tile * kTile - width;
    const BandMatrix::Block own = panel(tile, width);
    matrix.block(at, at, width, width).selfadjointView<Eigen::Lower>().rankUpdate(own, -1.0);
    if (left > 0)
      matrix.block(at + width, at, left, width).noalias() -=
          panel(tile + 1, left) * own.transpose();
  });
}

std::optional<BandCholesky> BandCholesky::factor(BandMatrix matrix, int threads) {
  for (int j = 0; j < matrix.size_; j += kBlock) {
    const int columns = std::min(kBlock, matrix.size_ - j);
    BandMatrix::Block diagonal = matrix.block(j, j, columns, columns);
    const Eigen::LLT<BandMatrix::Block> llt(diagonal);
    if (llt.info() != Eigen::Success) return std::nullopt;
    eliminate(matrix, j, columns, threads);
  }
  return BandCholesky(std::move(matrix));
}

Eigen::MatrixXd BandCholesky::solve(Eigen::MatrixXd right) const {
  const int size = factor_.size_, last = (size - 1) / kBlock * kBlock;
  for (int j = 0; j < size; j += kBlock) {
    const int columns = std::min(kBlock, size - j), next = j + columns,
              below = std::min(factor_.width_, size - next);
    auto x = right.middleRows(j, columns);
    factor_.block(j, j, columns, columns).triangularView<Eigen::Lower>().solveInPlace(x);
    right.middleRows(next, below) -= factor_.block(next, j, below, columns) * x;
  }
  for (int j = last; j >= 0; j -= kBlock) {
    const int columns = std::min(kBlock, size - j), next = j + columns,
              below = std::min(factor_.width_, size - next);
    auto x = right.middleRows(j, columns);
    x -= factor_.block(next, j, below, columns).transpose() * right.middleRows(next, below);
    factor_.block(j, j, columns, columns)
        .transpose()
        .triangularView<Eigen::Upper>()
        .solveInPlace(x);
  }
  return right;
}

}  // namespace fairing::solver
