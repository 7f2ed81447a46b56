// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/blending_integrand.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/uniform_patch/blending_tables.h"

namespace fairing::uniform_patch {
namespace {

using namespace tables;  // NOLINT: their names are those of the formulas

template <class T>
using Forms = std::array<T, kForms>;
template <class T>
using Invariants = std::array<T, kInvariants>;

template <class T>
T zero() {
  if constexpr (std::is_same_v<T, double>)
    return 0.0;
  else
    return T::Zero();
}

// x y z of the vector `v` of a jet, and the cross product of two of them.
template <class T>
const T* at(const JetOf<T>& jet, int v) {
  return &jet[std::size_t(3 * v)];
}
template <class T>
std::array<T, 3> cross(const T* x, const T* y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
template <class T>
T dot(const T* x, const T* y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

template <class T>
Forms<T> formsOf(const JetOf<T>& jet) {
  Forms<T> forms;
  forms.fill(zero<T>());
  for (const Dot& d : kDots) forms[d.form] += d.factor * dot(at(jet, d.x), at(jet, d.y));
  for (const Determinant& d : kDeterminants)
    forms[d.form] += dot(cross(at(jet, d.x), at(jet, d.y)).data(), at(jet, d.z));
  return forms;
}

template <class T>
Invariants<T> invariantsOf(const Forms<T>& forms) {
  Invariants<T> z;
  z.fill(zero<T>());
  for (const Taken& t : kTaken) z[t.invariant] = forms[t.form];
  for (const Product& p : kProducts) z[p.invariant] += p.factor * (forms[p.x] * forms[p.y]);
  return z;
}

// Everything the integrands are made of at the level of the invariants.
template <class T>
struct Terms {
  explicit Terms(const Invariants<T>& z)
      : inverse(1.0 / z[ID]),
        a(2.0 * z[Iqu] * z[ID] - 3.0 * z[Iq] * z[IDu]),
        b(2.0 * z[Iqv] * z[ID] - 3.0 * z[Iq] * z[IDv]) {
    using std::sqrt;
    const T inverse2 = inverse * inverse;
    p = sqrt(inverse) * (inverse2 * inverse2 * inverse) / 16.0;
    sa = 2.0 * p * (z[IG] * a - z[IF] * b);
    sb = 2.0 * p * (z[IE] * b - z[IF] * a);
    shape = 0.5 * (sa * a + sb * b);
    normal = (z[IT1] * z[IT1] + z[IT2] * z[IT2]) * inverse;
  }
  T inverse;  // 1 / D
  T a, b, p;
  T sa, sb;  // dS/da, dS/db
  T shape;   // S
  T normal;  // the normal part of |grad lap p|^2
};

template <class T>
T gradLaplacian2(const JetOf<T>& jet) {
  T sum = zero<T>();
  for (const auto& [x, y] : kGradLaplacian)
    for (int c = 0; c < 3; ++c) {
      const T g = at(jet, x)[c] + at(jet, y)[c];
      sum += g * g;
    }
  return sum;
}

// dF/dz of F = S + c Q but for |grad lap p|^2.
template <class T>
Invariants<T> slopesOf(const Invariants<T>& z, const Terms<T>& t, double c) {
  Invariants<T> s;
  s[IE] = t.p * t.b * t.b;
  s[IF] = -2.0 * t.p * t.a * t.b;
  s[IG] = t.p * t.a * t.a;
  s[ID] = 2.0 * (t.sa * z[Iqu] + t.sb * z[Iqv]) + t.inverse * (c * t.normal - 5.5 * t.shape);
  s[IDu] = -3.0 * z[Iq] * t.sa;
  s[IDv] = -3.0 * z[Iq] * t.sb;
  s[Iq] = -3.0 * (z[IDu] * t.sa + z[IDv] * t.sb);
  s[Iqu] = 2.0 * z[ID] * t.sa;
  s[Iqv] = 2.0 * z[ID] * t.sb;
  s[IT1] = (-2.0 * c) * t.inverse * z[IT1];
  s[IT2] = (-2.0 * c) * t.inverse * z[IT2];
  return s;
}

// d^2F/dz^2 without what slopesOf() says of products.
template <class T>
std::array<Invariants<T>, kInvariants> curvaturesOf(const Invariants<T>& z,
                                                    const Terms<T>& t,
                                                    double c) {
  // The invariants that a and b depend on, and their slopes there.
  constexpr Invariant kOfA[] = {ID, IDu, Iq, Iqu}, kOfB[] = {ID, IDv, Iq, Iqv};
  const std::array<T, 4> da = {2.0 * z[Iqu], -3.0 * z[Iq], -3.0 * z[IDu], 2.0 * z[ID]};
  const std::array<T, 4> db = {2.0 * z[Iqv], -3.0 * z[Iq], -3.0 * z[IDv], 2.0 * z[ID]};
  std::array<Invariants<T>, kInvariants> h;
  for (auto& row : h) row.fill(zero<T>());
  const auto pair = [&h](Invariant x, Invariant y, const T& value) {
    h[x][y] += value;
    h[y][x] += value;
  };
  const T aa = 2.0 * t.p * z[IG], ab = -2.0 * t.p * z[IF], bb = 2.0 * t.p * z[IE];
  const T pa = 2.0 * t.p * t.a, pb = 2.0 * t.p * t.b, fall = -5.5 * t.inverse;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      h[kOfA[i]][kOfA[j]] += aa * da[i] * da[j];
      h[kOfB[i]][kOfB[j]] += bb * db[i] * db[j];
      pair(kOfA[i], kOfB[j], ab * da[i] * db[j]);
    }
    pair(IG, kOfA[i], pa * da[i]);
    pair(IF, kOfA[i], -pb * da[i]);
    pair(IE, kOfB[i], pb * db[i]);
    pair(IF, kOfB[i], -pa * db[i]);
    pair(ID, kOfA[i], fall * t.sa * da[i]);
    pair(ID, kOfB[i], fall * t.sb * db[i]);
  }
  pair(ID, IE, fall * t.p * t.b * t.b);
  pair(ID, IF, -2.0 * fall * t.p * t.a * t.b);
  pair(ID, IG, fall * t.p * t.a * t.a);
  const T inverse2 = t.inverse * t.inverse;
  h[ID][ID] += inverse2 * (35.75 * t.shape - (2.0 * c) * t.normal);
  pair(ID, Iqu, 2.0 * t.sa);
  pair(ID, Iqv, 2.0 * t.sb);
  pair(Iq, IDu, -3.0 * t.sa);
  pair(Iq, IDv, -3.0 * t.sb);
  for (const Invariant i : {IT1, IT2}) {
    h[i][i] += (-2.0 * c) * t.inverse;
    pair(ID, i, (2.0 * c) * inverse2 * z[i]);
  }
  return h;
}

// The derivatives of the forms and of the invariants: their blocks of three numbers, as the lists
// above number them.
template <class T>
using FormSlopes = std::array<T, 3 * kFormBlocks.count>;
template <class T>
using InvariantSlopes = std::array<T, 3 * kInvariantBlocks.count>;

template <class T>
FormSlopes<T> formSlopes(const JetOf<T>& jet) {
  FormSlopes<T> slopes;
  slopes.fill(zero<T>());
  const auto add = [&slopes](Form form, Vector vector, double factor, const T* x) {
    T* block = &slopes[std::size_t(3 * kFormBlocks.of[form][vector])];
    for (int c = 0; c < 3; ++c) block[c] += factor * x[c];
  };
  for (const Dot& d : kDots) {
    add(d.form, d.x, d.factor, at(jet, d.y));
    add(d.form, d.y, d.factor, at(jet, d.x));
  }
  for (const Determinant& d : kDeterminants) {
    const T *x = at(jet, d.x), *y = at(jet, d.y), *z = at(jet, d.z);
    add(d.form, d.x, 1.0, cross(y, z).data());
    add(d.form, d.y, 1.0, cross(z, x).data());
    add(d.form, d.z, 1.0, cross(x, y).data());
  }
  return slopes;
}

// dF/dforms from dF/dinvariants.
template <class T>
Forms<T> throughProducts(const Forms<T>& forms, const Invariants<T>& slopes) {
  Forms<T> result;
  result.fill(zero<T>());
  for (const Taken& t : kTaken) result[t.form] += slopes[t.invariant];
  for (const Product& p : kProducts) {
    const T s = p.factor * slopes[p.invariant];
    result[p.x] += s * forms[p.y];
    result[p.y] += s * forms[p.x];
  }
  return result;
}

template <class T>
JetOf<T> gradientOf(const JetOf<T>& jet,
                    const FormSlopes<T>& blocks,
                    const Forms<T>& slopes,
                    double c) {
  JetOf<T> gradient;
  gradient.fill(zero<T>());
  for (int v = 0; v < kVectors; ++v)
    for (int b = kFormBlocks.first[v]; b < kFormBlocks.first[v + 1]; ++b)
      for (int i = 0; i < 3; ++i)
        gradient[std::size_t(3 * v + i)] +=
            slopes[std::size_t(kFormBlocks.row[b])] * blocks[std::size_t(3 * b + i)];
  for (const auto& [x, y] : kGradLaplacian)
    for (int i = 0; i < 3; ++i) {
      const T g = (2.0 * c) * (at(jet, x)[i] + at(jet, y)[i]);
      gradient[std::size_t(3 * x + i)] += g;
      gradient[std::size_t(3 * y + i)] += g;
    }
  return gradient;
}

template <class T>
InvariantSlopes<T> invariantSlopes(const Forms<T>& forms, const FormSlopes<T>& ofForms) {
  InvariantSlopes<T> slopes;
  slopes.fill(zero<T>());
  const auto add = [&](Invariant invariant, Form form, const T& factor) {
    for (int v = 0; v < kVectors; ++v) {
      if (!kFormBlocks.has(form, v)) continue;
      const T* from = &ofForms[std::size_t(3 * kFormBlocks.of[form][v])];
      T* to = &slopes[std::size_t(3 * kInvariantBlocks.of[invariant][v])];
      for (int c = 0; c < 3; ++c) to[c] += factor * from[c];
    }
  };
  for (const Taken& t : kTaken) add(t.invariant, t.form, zero<T>() + 1.0);
  for (const Product& p : kProducts) {
    add(p.invariant, p.x, p.factor * forms[p.y]);
    add(p.invariant, p.y, p.factor * forms[p.x]);
  }
  return slopes;
}

template <class T>
class Hessian {
 public:
  explicit Hessian(std::array<T, 405>& numbers) : numbers_(numbers) {}

  // slopes' curvatures slopes, slopes those of the invariants
  void setProducts(const InvariantSlopes<T>& slopes,
                   const std::array<Invariants<T>, kInvariants>& curvatures) {
    constexpr const auto& blocks = kInvariantBlocks;
    for (int l = 0; l < kVectors; ++l) {
      std::array<T, 3 * kInvariants> right;  // curvatures times the blocks of vector l
      right.fill(zero<T>());
      for (int b = blocks.first[l]; b < blocks.first[l + 1]; ++b)
        for (std::size_t z = 0; z < kInvariants; ++z)
          for (std::size_t d = 0; d < 3; ++d)
            right[3 * z + d] +=
                curvatures[std::size_t(blocks.row[b])][z] * slopes[std::size_t(3 * b) + d];
      for (int k = l; k < kVectors; ++k) {
        T sum[9];
        std::fill(sum, sum + 9, zero<T>());
        for (int b = blocks.first[k]; b < blocks.first[k + 1]; ++b)
          addOuter(&slopes[std::size_t(3 * b)], &right[std::size_t(3 * blocks.row[b])], sum);
        std::copy(sum, sum + 9, block(k, l));
      }
    }
  }
  // The second derivative of s x y, x and y forms, where neither is differentiated twice.
  void addPair(Form x, Form y, const T& s, const FormSlopes<T>& slopes) {
    for (int k = 0; k < kVectors; ++k) {
      if (!kFormBlocks.has(x, k)) continue;
      T left[3];
      for (int c = 0; c < 3; ++c) left[c] = s * slopes[std::size_t(3 * kFormBlocks.of[x][k] + c)];
      for (int l = 0; l < kVectors; ++l) {
        if (!kFormBlocks.has(y, l)) continue;
        const T* right = &slopes[std::size_t(3 * kFormBlocks.of[y][l])];
        if (k >= l) addOuter(left, right, block(k, l));
        if (k <= l) addOuter(right, left, block(l, k));
      }
    }
  }
  void addDot(int k, int l, const T& s) {
    T* h = block(std::max(k, l), std::min(k, l));
    for (int c = 0; c < 3; ++c) h[4 * c] += k == l ? 2.0 * s : s;
  }
  // The second derivative of s det(x, y, .) where x is vector k, y is vector l: s times the matrix
  // whose entry (i, j) is the sum over m of epsilon_ijm z_m.
  void addSkew(int k, int l, const T& s, const T* z) {
    T* h = block(std::max(k, l), std::min(k, l));
    const T t = k > l ? s : T(-s);
    h[1] += t * z[2];
    h[2] -= t * z[1];
    h[3] -= t * z[2];
    h[5] += t * z[0];
    h[6] += t * z[1];
    h[7] -= t * z[0];
  }

 private:
  T* block(int k, int l) {
    return &numbers_[std::size_t(9 * BlendingDerivatives<T>::blockIndex(k, l))];
  }
  static void addOuter(const T* x, const T* y, T* sum) {
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) sum[3 * c + d] += x[c] * y[d];
  }

  std::array<T, 405>& numbers_;
};

}  // namespace

template <class Number>
BlendingValue<Number> blendingValue(const JetOf<Number>& jet) {
  const Terms<Number> t(invariantsOf(formsOf(jet)));
  return {t.shape, gradLaplacian2(jet) - t.normal};
}

template <class Number>
void blendingGradient(const JetOf<Number>& jet, double c, BlendingDerivatives<Number>& result) {
  const Forms<Number> forms = formsOf(jet);
  const Invariants<Number> z = invariantsOf(forms);
  const Terms<Number> t(z);
  result.value = {t.shape, gradLaplacian2(jet) - t.normal};
  result.gradient = gradientOf(jet, formSlopes(jet), throughProducts(forms, slopesOf(z, t, c)), c);
}

template <class Number>
void blendingDerivatives(const JetOf<Number>& jet, double c, BlendingDerivatives<Number>& result) {
  const Forms<Number> forms = formsOf(jet);
  const Invariants<Number> z = invariantsOf(forms);
  const Terms<Number> t(z);
  const Invariants<Number> slopes = slopesOf(z, t, c);
  const Forms<Number> formwise = throughProducts(forms, slopes);
  const FormSlopes<Number> blocks = formSlopes(jet);
  result.value = {t.shape, gradLaplacian2(jet) - t.normal};
  result.gradient = gradientOf(jet, blocks, formwise, c);
  Hessian<Number> hessian(result.hessian);
  hessian.setProducts(invariantSlopes(forms, blocks), curvaturesOf(z, t, c));
  for (const Product& p : kProducts)
    hessian.addPair(p.x, p.y, p.factor * slopes[p.invariant], blocks);
  for (const Dot& d : kDots) hessian.addDot(d.x, d.y, d.factor * formwise[d.form]);
  for (const Determinant& d : kDeterminants) {
    const Number& s = formwise[d.form];
    hessian.addSkew(d.x, d.y, s, at(jet, d.z));
    hessian.addSkew(d.y, d.z, s, at(jet, d.x));
    hessian.addSkew(d.z, d.x, s, at(jet, d.y));
  }
  Number twice = zero<Number>();
  twice += 2.0 * c;
  for (const auto& [x, y] : kGradLaplacian) {
    hessian.addDot(x, x, 0.5 * twice);
    hessian.addDot(y, y, 0.5 * twice);
    hessian.addDot(x, y, twice);
  }
}

template BlendingValue<double> blendingValue(const JetOf<double>&);
template BlendingValue<Lanes> blendingValue(const JetOf<Lanes>&);
template void blendingGradient(const JetOf<double>&, double, BlendingDerivatives<double>&);
template void blendingGradient(const JetOf<Lanes>&, double, BlendingDerivatives<Lanes>&);
template void blendingDerivatives(const JetOf<double>&, double, BlendingDerivatives<double>&);
template void blendingDerivatives(const JetOf<Lanes>&, double, BlendingDerivatives<Lanes>&);

}  // namespace fairing::uniform_patch
