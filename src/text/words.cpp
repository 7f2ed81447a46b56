// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/words.h"

#include <array>
#include <utility>

namespace fairing::text {
namespace {

template <class T, std::size_t n>
using Words = std::array<std::pair<T, std::string_view>, n>;

constexpr Words<Continuity, 3> kContinuities{
    {{Continuity::G0, "G0"}, {Continuity::G1, "G1"}, {Continuity::G2, "G2"}}};
constexpr Words<EnergyKind, 7> kEnergies{
    {{EnergyKind::Membrane, "membrane"},
     {EnergyKind::ThinPlate, "thin-plate"},
     {EnergyKind::MeanCurvatureGradient, "mean-curvature-gradient"},
     {EnergyKind::MeanCurvatureGradientMinimum, "mean-curvature-gradient-minimum"},
     {EnergyKind::MinimumVariation, "minimum-variation"},
     {EnergyKind::TotalCurvature, "total-curvature"},
     {EnergyKind::Triharmonic, "triharmonic"}}};
constexpr Words<LayoutKind, 7> kLayouts{{{LayoutKind::Auto, "auto"},
                                         {LayoutKind::Quad, "quad"},
                                         {LayoutKind::Star, "star"},
                                         {LayoutKind::OGrid, "o-grid"},
                                         {LayoutKind::Strip, "strip"},
                                         {LayoutKind::Junction, "junction"},
                                         {LayoutKind::Trimmed, "trimmed"}}};
constexpr Words<boundary::Departure, 3> kDepartures{
    {{boundary::Departure::Free, "free"},
     {boundary::Departure::Perpendicular, "perpendicular"},
     {boundary::Departure::Iso, "iso"}}};
constexpr Words<boundary::MatchKind, 3> kMatches{{{boundary::MatchKind::Auto, "auto"},
                                                  {boundary::MatchKind::Length, "length"},
                                                  {boundary::MatchKind::Corners, "corners"}}};

using analysis::CurvatureQuantity;
constexpr Words<CurvatureQuantity, 5> kQuantities{
    {{CurvatureQuantity::Mean, "mean"},
     {CurvatureQuantity::Gauss, "gauss"},
     {CurvatureQuantity::K1, "k1"},
     {CurvatureQuantity::K2, "k2"},
     {CurvatureQuantity::MeanGradient, "mean-gradient"}}};
constexpr Words<spline::QuadratureFamily, 2> kQuadratures{
    {{spline::QuadratureFamily::Gauss, "gauss"}, {spline::QuadratureFamily::Lobatto, "lobatto"}}};

template <class T, std::size_t n>
std::string_view find(const Words<T, n>& words, T value) {
  for (const auto& [known, text] : words) {
    if (known == value) return text;
  }
  return {};
}

template <class T, std::size_t n>
std::optional<T> find(const Words<T, n>& words, std::string_view text) {
  for (const auto& [value, known] : words) {
    if (known == text) return value;
  }
  return std::nullopt;
}

}  // namespace

std::string_view word(Continuity continuity) {
  return find(kContinuities, continuity);
}
std::string_view word(EnergyKind energy) {
  return find(kEnergies, energy);
}
std::string_view word(LayoutKind layout) {
  return find(kLayouts, layout);
}
std::string_view word(boundary::Departure departure) {
  return find(kDepartures, departure);
}
std::string_view word(boundary::MatchKind match) {
  return find(kMatches, match);
}
std::string_view word(analysis::CurvatureQuantity quantity) {
  return find(kQuantities, quantity);
}

std::vector<EnergyKind> allEnergies() {
  std::vector<EnergyKind> all;
  for (const auto& [energy, word] : kEnergies) all.push_back(energy);
  return all;
}

std::string_view word(spline::QuadratureFamily family) {
  return find(kQuadratures, family);
}

std::optional<Continuity> continuityFrom(std::string_view text) {
  return find(kContinuities, text);
}
std::optional<EnergyKind> energyFrom(std::string_view text) {
  return find(kEnergies, text);
}
std::optional<LayoutKind> layoutFrom(std::string_view text) {
  return find(kLayouts, text);
}
std::optional<boundary::Departure> departureFrom(std::string_view text) {
  return find(kDepartures, text);
}
std::optional<boundary::MatchKind> matchFrom(std::string_view text) {
  return find(kMatches, text);
}
std::optional<analysis::CurvatureQuantity> quantityFrom(std::string_view text) {
  return find(kQuantities, text);
}

std::optional<spline::QuadratureFamily> quadratureFrom(std::string_view text) {
  return find(kQuadratures, text);
}

}  // namespace fairing::text
