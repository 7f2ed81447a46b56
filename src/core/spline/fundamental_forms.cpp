// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/fundamental_forms.h"

#include <Eigen/Geometry>

namespace fairing::spline {
namespace {

using Eigen::Vector3d;

// The jet's columns and k = R_u x R_v with its derivatives.
struct Named {
  explicit Named(const ThirdOrderJet& jet)
      : u(jet.col(0)),
        v(jet.col(1)),
        uu(jet.col(2)),
        uv(jet.col(3)),
        vv(jet.col(4)),
        uuu(jet.col(5)),
        uuv(jet.col(6)),
        uvv(jet.col(7)),
        vvv(jet.col(8)),
        k(u.cross(v)),
        ku(uu.cross(v) + u.cross(uv)),
        kv(uv.cross(v) + u.cross(vv)) {}
  // The change of another one along a jet.
  Named(const Named& r, const ThirdOrderJet& along) : Named(along) {
    k = u.cross(r.v) + r.u.cross(v);
    ku = uu.cross(r.v) + r.uu.cross(v) + u.cross(r.uv) + r.u.cross(uv);
    kv = uv.cross(r.v) + r.uv.cross(v) + u.cross(r.vv) + r.u.cross(vv);
  }

  Vector3d u, v, uu, uv, vv, uuu, uuv, uvv, vvv, k, ku, kv;
};

// The part of the chain rule that does not go through k.
ThirdOrderJet pullBackDirect(const Named& r, const FundamentalForms& s) {
  ThirdOrderJet d;
  d.col(0) = 2.0 * (s.e.value * r.u + s.e.u * r.uu + s.e.v * r.uv) + s.f.value * r.v +
             s.f.u * r.uv + s.f.v * r.vv;
  d.col(1) = 2.0 * (s.g.value * r.v + s.g.u * r.uv + s.g.v * r.vv) + s.f.value * r.u +
             s.f.u * r.uu + s.f.v * r.uv;
  d.col(2) = 2.0 * s.e.u * r.u + s.f.u * r.v + s.l.value * r.k + s.l.u * r.ku + s.l.v * r.kv;
  d.col(3) = (2.0 * s.e.v + s.f.u) * r.u + (s.f.v + 2.0 * s.g.u) * r.v + s.m.value * r.k +
             s.m.u * r.ku + s.m.v * r.kv;
  d.col(4) = s.f.v * r.u + 2.0 * s.g.v * r.v + s.n.value * r.k + s.n.u * r.ku + s.n.v * r.kv;
  d.col(5) = s.l.u * r.k;
  d.col(6) = (s.l.v + s.m.u) * r.k;
  d.col(7) = (s.m.v + s.n.u) * r.k;
  d.col(8) = s.n.v * r.k;
  return d;
}

// Slopes with respect to k, k_u, k_v.
struct NormalSlopes {
  NormalSlopes(const Named& r, const FundamentalForms& s)
      : k(s.l.value * r.uu + s.m.value * r.uv + s.n.value * r.vv + s.l.u * r.uuu +
          (s.l.v + s.m.u) * r.uuv + (s.m.v + s.n.u) * r.uvv + s.n.v * r.vvv),
        ku(s.l.u * r.uu + s.m.u * r.uv + s.n.u * r.vv),
        kv(s.l.v * r.uu + s.m.v * r.uv + s.n.v * r.vv) {}

  Vector3d k, ku, kv;
};

// The part that goes through the cross products: a . (dx x b) = dx . (b x a).
void addThroughNormal(const Named& r, const NormalSlopes& s, ThirdOrderJet& d) {
  d.col(0) += r.v.cross(s.k) + r.uv.cross(s.ku) + r.vv.cross(s.kv);
  d.col(1) += s.k.cross(r.u) + s.ku.cross(r.uu) + s.kv.cross(r.uv);
  d.col(2) += r.v.cross(s.ku);
  d.col(3) += s.ku.cross(r.u) + r.v.cross(s.kv);
  d.col(4) += s.kv.cross(r.u);
}

}  // namespace

ThirdOrderJet thirdOrderJet(const Partials& partials) {
  ThirdOrderJet jet;
  jet << partials.col(4), partials.col(1), partials.col(8), partials.col(5), partials.col(2),
      partials.col(12), partials.col(9), partials.col(6), partials.col(3);
  return jet;
}

FundamentalForms fundamentalForms(const ThirdOrderJet& jet) {
  const Named r(jet);
  return {
      {r.u.dot(r.u), 2.0 * r.u.dot(r.uu), 2.0 * r.u.dot(r.uv)},
      {r.u.dot(r.v), r.uu.dot(r.v) + r.u.dot(r.uv), r.uv.dot(r.v) + r.u.dot(r.vv)},
      {r.v.dot(r.v), 2.0 * r.v.dot(r.uv), 2.0 * r.v.dot(r.vv)},
      {r.k.dot(r.uu), r.ku.dot(r.uu) + r.k.dot(r.uuu), r.kv.dot(r.uu) + r.k.dot(r.uuv)},
      {r.k.dot(r.uv), r.ku.dot(r.uv) + r.k.dot(r.uuv), r.kv.dot(r.uv) + r.k.dot(r.uvv)},
      {r.k.dot(r.vv), r.ku.dot(r.vv) + r.k.dot(r.uvv), r.kv.dot(r.vv) + r.k.dot(r.vvv)},
  };
}

ThirdOrderJet pullBack(const ThirdOrderJet& jet, const FundamentalForms& slopes) {
  const Named r(jet);
  ThirdOrderJet d = pullBackDirect(r, slopes);
  addThroughNormal(r, NormalSlopes(r, slopes), d);
  return d;
}

// pullBackDirect() and NormalSlopes are linear in what is named, addThroughNormal() in both.
ThirdOrderJet pullBackChange(const ThirdOrderJet& jet,
                             const ThirdOrderJet& along,
                             const FundamentalForms& slopes) {
  const Named r(jet), change(r, along);
  ThirdOrderJet d = pullBackDirect(change, slopes);
  addThroughNormal(change, NormalSlopes(r, slopes), d);
  addThroughNormal(r, NormalSlopes(change, slopes), d);
  return d;
}

}  // namespace fairing::spline
