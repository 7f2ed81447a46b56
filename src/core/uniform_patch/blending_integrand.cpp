// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/blending_integrand.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

// Three tables say how the integrands depend on the jet; values, gradients and second derivatives
// are all read off them.
//
//   forms       the first form E, F, G and the second form L, M, N against k = R_u x R_v, each with
//               its first derivatives, and t1 = k . g1, t2 = k . g2 of the gradient of the
//               Laplacian g1 = R_uuu + R_uvv, g2 = R_uuv + R_vvv:  sums of dot products and of
//               determinants of the jet's vectors
//   invariants  D = E G - F^2 and q = E N - 2 F M + G L with their first derivatives: sums of
//               products of two forms; E, F, G, t1, t2 are taken over
//   integrands  with a = 2 q_u D - 3 q D_u, b the same along v, p = D^(-11/2) / 16:
//               S = p (G a^2 - 2 F a b + E b^2),   Q = |g1|^2 + |g2|^2 - (t1^2 + t2^2) / D,
//               for H = q / (2 D^(3/2)) has H_u = a / (4 D^(5/2)).

namespace fairing::uniform_patch {
namespace {

// The jet's vectors.
enum Vector { Ru, Rv, Ruu, Ruv, Rvv, Ruuu, Ruuv, Ruvv, Rvvv, kVectors };
enum Form { E, Eu, Ev, F, Fu, Fv, G, Gu, Gv, L, Lu, Lv, M, Mu, Mv, N, Nu, Nv, T1, T2, kForms };
enum Invariant { IE, IF, IG, ID, IDu, IDv, Iq, Iqu, Iqv, IT1, IT2, kInvariants };

// form += factor x . y
struct Dot {
  Form form;
  Vector x, y;
  double factor;
};
constexpr Dot kDots[] = {
    {E, Ru, Ru, 1},
    {Eu, Ru, Ruu, 2},
    {Ev, Ru, Ruv, 2},  //
    {F, Ru, Rv, 1},
    {Fu, Ruu, Rv, 1},
    {Fu, Ru, Ruv, 1},
    {Fv, Ruv, Rv, 1},
    {Fv, Ru, Rvv, 1},  //
    {G, Rv, Rv, 1},
    {Gu, Rv, Ruv, 2},
    {Gv, Rv, Rvv, 2},
};

// form += det(x, y, z)
struct Determinant {
  Form form;
  Vector x, y, z;
};
constexpr Determinant kDeterminants[] = {
    {L, Ru, Rv, Ruu},   {Lu, Ru, Rv, Ruuu}, {Lu, Ru, Ruv, Ruu}, {Lv, Ru, Rv, Ruuv},
    {Lv, Ruv, Rv, Ruu}, {Lv, Ru, Rvv, Ruu}, {M, Ru, Rv, Ruv},   {Mu, Ru, Rv, Ruuv},
    {Mu, Ruu, Rv, Ruv}, {Mv, Ru, Rv, Ruvv}, {Mv, Ru, Rvv, Ruv}, {N, Ru, Rv, Rvv},
    {Nu, Ru, Rv, Ruvv}, {Nu, Ruu, Rv, Rvv}, {Nu, Ru, Ruv, Rvv}, {Nv, Ru, Rv, Rvvv},
    {Nv, Ruv, Rv, Rvv}, {T1, Ru, Rv, Ruuu}, {T1, Ru, Rv, Ruvv}, {T2, Ru, Rv, Ruuv},
    {T2, Ru, Rv, Rvvv},
};

// invariant += factor x y
struct Product {
  Invariant invariant;
  Form x, y;
  double factor;
};
constexpr Product kProducts[] = {
    {ID, E, G, 1},    {ID, F, F, -1},                                       //
    {IDu, Eu, G, 1},  {IDu, E, Gu, 1},  {IDu, Fu, F, -2},                   //
    {IDv, Ev, G, 1},  {IDv, E, Gv, 1},  {IDv, Fv, F, -2},                   //
    {Iq, E, N, 1},    {Iq, F, M, -2},   {Iq, G, L, 1},                      //
    {Iqu, Eu, N, 1},  {Iqu, Fu, M, -2}, {Iqu, Gu, L, 1},  {Iqu, E, Nu, 1},  //
    {Iqu, F, Mu, -2}, {Iqu, G, Lu, 1},                                      //
    {Iqv, Ev, N, 1},  {Iqv, Fv, M, -2}, {Iqv, Gv, L, 1},  {Iqv, E, Nv, 1},  //
    {Iqv, F, Mv, -2}, {Iqv, G, Lv, 1},
};

struct Taken {
  Invariant invariant;
  Form form;
};
constexpr Taken kTaken[] = {{IE, E}, {IF, F}, {IG, G}, {IT1, T1}, {IT2, T2}};

// The vectors of the gradient of the Laplacian: g = x + y.
constexpr Vector kGradLaplacian[2][2] = {{Ruuu, Ruvv}, {Ruuv, Rvvv}};

// Which vectors a form or an invariant depends on: the blocks of its derivative that do not vanish,
// those of one vector a stretch.
template <int rows>
struct Blocks {
  constexpr void add(int r, int vector) { of[r][vector] = 0; }
  constexpr bool has(int r, int vector) const { return of[r][vector] >= 0; }
  constexpr void number() {
    for (int v = 0; v < kVectors; ++v) {
      first[v] = count;
      for (int r = 0; r < rows; ++r)
        if (has(r, v)) {
          of[r][v] = count;
          row[count++] = r;
        }
    }
    first[kVectors] = count;
  }
  constexpr Blocks() {
    for (auto& line : of)
      for (int& entry : line) entry = -1;
  }
  int of[rows][kVectors] = {};         // number of a block, or -1
  int row[rows * int(kVectors)] = {};  // of every block
  int first[kVectors + 1] = {};        // block of every vector
  int count = 0;
};

constexpr Blocks<kForms> listFormBlocks() {
  Blocks<kForms> blocks;
  for (const Dot& d : kDots)
    for (const Vector v : {d.x, d.y}) blocks.add(d.form, v);
  for (const Determinant& d : kDeterminants)
    for (const Vector v : {d.x, d.y, d.z}) blocks.add(d.form, v);
  blocks.number();
  return blocks;
}
constexpr Blocks<kForms> kFormBlocks = listFormBlocks();

constexpr Blocks<kInvariants> listInvariantBlocks() {
  Blocks<kInvariants> blocks;
  for (int v = 0; v < kVectors; ++v) {
    for (const Taken& t : kTaken)
      if (kFormBlocks.has(t.form, v)) blocks.add(t.invariant, v);
    for (const Product& p : kProducts)
      if (kFormBlocks.has(p.x, v) || kFormBlocks.has(p.y, v)) blocks.add(p.invariant, v);
  }
  blocks.number();
  return blocks;
}
constexpr Blocks<kInvariants> kInvariantBlocks = listInvariantBlocks();

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
