// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <cstddef>

#include "core/spline/surface_grid.h"

namespace fairing::spline {

/// Two derivatives of a jet: their orders along v and their columns.
struct JetPair {
  int b = 0, d = 0, first = 0, second = 0;
};

/// The pairs of derivatives of the orders a and c along u.
struct JetPairs {
  int a = 0, c = 0;
  int count = 0;
  JetPair pairs[9] = {};
};

/// Orders (a, c) along u with a <= c.
inline constexpr int kOrderPairs = 10;

/// All pairs of derivatives of a jet by their orders along u, for second derivatives that are
/// summed along v first. Those of a < c stand for both orders; where a = c a pair comes both ways
/// round, or once (b <= d).
constexpr std::array<JetPairs, kOrderPairs> jetPairs(bool onceEach) {
  const auto column = [](int a, int b) {
    for (int k = 0; k < 9; ++k)
      if (kJetOrders[k][0] == a && kJetOrders[k][1] == b) return k;
    return -1;
  };
  std::array<JetPairs, kOrderPairs> all;
  std::size_t place = 0;
  for (int a = 0; a < 4; ++a)
    for (int c = a; c < 4; ++c, ++place) {
      JetPairs& orders = all[place];
      orders.a = a;
      orders.c = c;
      for (int b = 0; b < 4; ++b)
        for (int d = 0; d < 4; ++d)
          if ((a < c || b <= d || !onceEach) && column(a, b) >= 0 && column(c, d) >= 0)
            orders.pairs[orders.count++] = {b, d, column(a, b), column(c, d)};
    }
  return all;
}

}  // namespace fairing::spline
