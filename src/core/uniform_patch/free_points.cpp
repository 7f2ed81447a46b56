// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/free_points.h"

#include <Eigen/LU>
#include <cmath>

#include "core/uniform_patch/span_quadrature.h"

// A curve of constant u asks  A D = C  of the net D, a row of A holding the basis functions at its
// parameter; one of constant v asks  D B' = E. With A and B of full rank on the inner points the
// directions left are  Z Y W',  Z and W the null spaces of A and B, so everything is done on one
// line of control points at a time. Of each row one point is solved for, so that Z stays local.

namespace fairing::uniform_patch {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

// Coefficients smaller than this beside the largest of a row are rounding.
constexpr double kRank = 1e-9;

// What a curve may be off what it has to meet, in diameters of the border: rounding.
constexpr double kContradiction = 1e-9;

RowVectorXd basisAt(double parameter, int points) {
  RowVectorXd row = RowVectorXd::Zero(points);
  const SpanPlace place(parameter, points - 3);
  row.segment<4>(place.span) = cubicRows(place.local).row(0);
  return row;
}

// The constraints of one direction on its line of control points.
class Line {
 public:
  Line(int points, const std::vector<const FixedCurve*>& curves) : points_(points) {
    rows_.resize(Index(curves.size()), points);
    for (std::size_t k = 0; k < curves.size(); ++k)
      rows_.row(Index(k)) = basisAt(curves[k]->parameter, points);
    choosePivots();
    numberTerms();
  }

  [[nodiscard]] const MatrixXd& rows() const { return rows_; }
  [[nodiscard]] int freeCount() const { return freeCount_; }
  [[nodiscard]] const std::vector<FreePoints::Term>& terms(int point) const {
    return terms_[std::size_t(point)];
  }
  /// The moves of the pivots that change what the kept rows give by `gap`, one row a row.
  [[nodiscard]] MatrixXd correction(const MatrixXd& gap) const {
    MatrixXd result = MatrixXd::Zero(points_, gap.cols());
    if (kept_.empty()) return result;
    const MatrixXd moves = ofPivots_.partialPivLu().solve(gap(kept_, Eigen::all));
    for (std::size_t k = 0; k < pivots_.size(); ++k) result.row(pivots_[k]) = moves.row(Index(k));
    return result;
  }

 private:
  // The largest coefficient of every row once the pivots before it are eliminated.
  void choosePivots() {
    MatrixXd left = rows_.middleCols(kRings, points_ - 2 * kRings);
    for (Index k = 0; k < left.rows(); ++k) {
      Index pivot = 0;
      if (left.row(k).cwiseAbs().maxCoeff(&pivot) < kRank) continue;  // the others imply it
      kept_.push_back(k);
      pivots_.push_back(kRings + pivot);
      for (Index below = k + 1; below < left.rows(); ++below)
        left.row(below) -= left(below, pivot) / left(k, pivot) * left.row(k);
    }
    ofPivots_ = rows_(kept_, pivots_);
  }

  void numberTerms() {
    terms_.resize(std::size_t(points_));
    std::vector<Index> free;
    for (Index i = kRings; i < points_ - kRings; ++i) {
      if (std::find(pivots_.begin(), pivots_.end(), i) != pivots_.end()) continue;
      terms_[std::size_t(i)].push_back({static_cast<int>(free.size()), 1.0});
      free.push_back(i);
    }
    freeCount_ = static_cast<int>(free.size());
    if (kept_.empty() || free.empty()) return;
    const MatrixXd others = ofPivots_.partialPivLu().solve(MatrixXd(rows_(kept_, free)));
    for (std::size_t k = 0; k < pivots_.size(); ++k)
      for (int f = 0; f < freeCount_; ++f)
        if (std::abs(others(Index(k), f)) > kRank)
          terms_[std::size_t(pivots_[k])].push_back({f, -others(Index(k), f)});
  }

  int points_, freeCount_ = 0;
  MatrixXd rows_;  // curve x control point
  std::vector<Index> kept_, pivots_;
  MatrixXd ofPivots_;  // rows_ where kept, at the pivots
  std::vector<std::vector<FreePoints::Term>> terms_;
};

// One coordinate of a net as a matrix, and of what the curves ask.
MatrixXd coordinate(const ControlNet& net, int c) {
  MatrixXd result(net.rows, net.columns);
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j) result(i, j) = net.points(net.index(i, j), c);
  return result;
}

MatrixXd wishes(const std::vector<const FixedCurve*>& curves, const MatrixXd& own, int c) {
  MatrixXd asked = own;
  for (std::size_t k = 0; k < curves.size(); ++k)
    if (curves[k]->points) asked.row(Index(k)) = curves[k]->points->col(c).transpose();
  return asked;
}

// Free points are numbered along the shorter direction first, which keeps matrices narrow.
FreePoints freePoints(const ControlNet& net, const Line& u, const Line& v) {
  FreePoints free;
  free.count = u.freeCount() * v.freeCount();
  free.terms.resize(std::size_t(net.rows * net.columns));
  const bool alongV = v.freeCount() <= u.freeCount();
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j)
      for (const FreePoints::Term& x : u.terms(i))
        for (const FreePoints::Term& y : v.terms(j))
          free.terms[std::size_t(net.index(i, j))].push_back(
              {alongV ? x.free * v.freeCount() + y.free : y.free * u.freeCount() + x.free,
               x.factor * y.factor});
  return free;
}

Result<void> checkCurve(const ControlNet& net, const FixedCurve& curve) {
  const bool alongV = curve.constant == FixedCurve::Constant::U;
  const int last = alongV ? net.rows : net.columns, length = alongV ? net.columns : net.rows;
  const bool inside = curve.parameter >= 3.0 && curve.parameter <= last;
  if (!inside)
    return fail({.code = ErrorCode::CurveOutside,
                 .value = curve.parameter,
                 .detail = std::string(alongV ? "u" : "v") + " from 3 to " + std::to_string(last)});
  if (curve.points && (curve.points->rows() != length || !curve.points->allFinite()))
    return fail({.code = ErrorCode::NotFinite});
  return {};
}

}  // namespace

spline::Poles curvePoints(const ControlNet& net, const FixedCurve& curve) {
  const bool alongV = curve.constant == FixedCurve::Constant::U;
  const RowVectorXd basis = basisAt(curve.parameter, alongV ? net.rows : net.columns);
  spline::Poles points(alongV ? net.columns : net.rows, 3);
  for (int c = 0; c < 3; ++c) {
    const MatrixXd own = coordinate(net, c);
    points.col(c) = alongV ? (basis * own).transpose().eval() : (own * basis.transpose()).eval();
  }
  return points;
}

spline::Poles FreePoints::spread(const spline::Poles& moves) const {
  spline::Poles all = spline::Poles::Zero(Index(terms.size()), 3);
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (const Term& term : terms[k]) all.row(Index(k)) += term.factor * moves.row(term.free);
  return all;
}

spline::Poles FreePoints::gather(const spline::Poles& slopes) const {
  spline::Poles free = spline::Poles::Zero(count, 3);
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (const Term& term : terms[k]) free.row(term.free) += term.factor * slopes.row(Index(k));
  return free;
}

int FreePoints::couplingWidth(const ControlNet& net) const {
  int width = 0;
  forEachSpan(net, [&](const std::array<int, 16>& points) {
    int least = count, most = 0;
    for (const int point : points)
      for (const Term& term : terms[std::size_t(point)]) {
        least = std::min(least, term.free);
        most = std::max(most, term.free);
      }
    width = std::max(width, most - least);
  });
  return width;
}

Result<ConstrainedNet> constrain(const ControlNet& net, const std::vector<FixedCurve>& curves) {
  if (const auto valid = validate(net); !valid) return fail(valid.error());
  std::vector<const FixedCurve*> ofU, ofV;
  for (const FixedCurve& curve : curves) {
    if (const auto fits = checkCurve(net, curve); !fits) return fail(fits.error());
    (curve.constant == FixedCurve::Constant::U ? ofU : ofV).push_back(&curve);
  }
  const Line u(net.rows, ofU), v(net.columns, ofV);
  ConstrainedNet result{net, freePoints(net, u, v)};
  MatrixXd missU = MatrixXd::Zero(u.rows().rows(), net.columns), missV(v.rows().rows(), net.rows);
  missV.setZero();
  for (int c = 0; c < 3; ++c) {
    MatrixXd points = coordinate(net, c);
    const MatrixXd askedU = wishes(ofU, u.rows() * points, c),
                   askedV = wishes(ofV, v.rows() * points.transpose(), c);
    // rings do not move: the corrections are of the inner points alone
    const int innerU = net.rows - 2 * kRings, innerV = net.columns - 2 * kRings;
    points.middleCols(kRings, innerV) +=
        u.correction(askedU - u.rows() * points).middleCols(kRings, innerV);
    points.middleRows(kRings, innerU) +=
        v.correction(askedV - v.rows() * points.transpose()).transpose().middleRows(kRings, innerU);
    missU += (askedU - u.rows() * points).cwiseAbs2();
    missV += (askedV - v.rows() * points.transpose()).cwiseAbs2();
    for (int i = 0; i < net.rows; ++i)
      for (int j = 0; j < net.columns; ++j) result.net.points(net.index(i, j), c) = points(i, j);
  }
  const auto worst = [&](const std::vector<const FixedCurve*>& family,
                         const MatrixXd& miss) -> Result<void> {
    if (family.empty()) return {};
    Index curve = 0, place = 0;
    const double off = std::sqrt(miss.maxCoeff(&curve, &place));
    if (off <= kContradiction * borderDiameter(net)) return {};
    const FixedCurve& wrong = *family[std::size_t(curve)];
    return fail({.code = ErrorCode::CurvesContradict,
                 .value = off,
                 .detail = std::string(wrong.constant == FixedCurve::Constant::U ? "u" : "v") +
                           " = " + std::to_string(wrong.parameter)});
  };
  if (const auto fits = worst(ofU, missU); !fits) return fail(fits.error());
  if (const auto fits = worst(ofV, missV); !fits) return fail(fits.error());
  return result;
}

}  // namespace fairing::uniform_patch
