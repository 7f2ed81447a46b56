// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Three tables say how the integrands depend on the jet; values, gradients and second derivatives
// are all read off them (blending_integrand.cpp).
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

namespace fairing::uniform_patch::tables {

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
inline constexpr Dot kDots[] = {
    {E, Ru, Ru, 1},
    {Eu, Ru, Ruu, 2},
    {Ev, Ru, Ruv, 2},
    {F, Ru, Rv, 1},
    {Fu, Ruu, Rv, 1},
    {Fu, Ru, Ruv, 1},
    {Fv, Ruv, Rv, 1},
    {Fv, Ru, Rvv, 1},
    {G, Rv, Rv, 1},
    {Gu, Rv, Ruv, 2},
    {Gv, Rv, Rvv, 2},
};

// form += det(x, y, z)
struct Determinant {
  Form form;
  Vector x, y, z;
};
inline constexpr Determinant kDeterminants[] = {
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
inline constexpr Product kProducts[] = {
    {ID, E, G, 1},    {ID, F, F, -1},   {IDu, Eu, G, 1},  {IDu, E, Gu, 1},  {IDu, Fu, F, -2},
    {IDv, Ev, G, 1},  {IDv, E, Gv, 1},  {IDv, Fv, F, -2}, {Iq, E, N, 1},    {Iq, F, M, -2},
    {Iq, G, L, 1},    {Iqu, Eu, N, 1},  {Iqu, Fu, M, -2}, {Iqu, Gu, L, 1},  {Iqu, E, Nu, 1},
    {Iqu, F, Mu, -2}, {Iqu, G, Lu, 1},  {Iqv, Ev, N, 1},  {Iqv, Fv, M, -2}, {Iqv, Gv, L, 1},
    {Iqv, E, Nv, 1},  {Iqv, F, Mv, -2}, {Iqv, G, Lv, 1},
};

struct Taken {
  Invariant invariant;
  Form form;
};
inline constexpr Taken kTaken[] = {{IE, E}, {IF, F}, {IG, G}, {IT1, T1}, {IT2, T2}};

// The vectors of the gradient of the Laplacian: g = x + y.
inline constexpr Vector kGradLaplacian[2][2] = {{Ruuu, Ruvv}, {Ruuv, Rvvv}};

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
inline constexpr Blocks<kForms> kFormBlocks = listFormBlocks();

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
inline constexpr Blocks<kInvariants> kInvariantBlocks = listInvariantBlocks();

}  // namespace fairing::uniform_patch::tables
