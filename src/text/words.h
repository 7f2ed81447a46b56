// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "core/analysis/curvature_picture.h"
#include "core/boundary/chain_match.h"
#include "core/boundary/continuity.h"
#include "core/boundary/departure.h"
#include "core/energy/energy_kind.h"
#include "core/layout/layout_kind.h"
#include "core/spline/quadrature.h"

/// The words people, files and scripts use for our choices. Documents store them: change none, add
/// only.
namespace fairing::text {

[[nodiscard]] std::string_view word(Continuity continuity);          ///< "G0", "G1", "G2"
[[nodiscard]] std::string_view word(EnergyKind energy);              ///< "thin-plate", ...
[[nodiscard]] std::string_view word(LayoutKind layout);              ///< "auto", "quad", ...
[[nodiscard]] std::string_view word(boundary::Departure departure);  ///< "free", "iso", ...

[[nodiscard]] std::string_view word(boundary::MatchKind match);  ///< "auto", "length", "corners"
[[nodiscard]] std::string_view word(analysis::CurvatureQuantity quantity);  ///< "mean", "k1", ...

/// Every energy, in the order they are told in.
[[nodiscard]] std::vector<EnergyKind> allEnergies();
[[nodiscard]] std::string_view word(spline::QuadratureFamily family);  ///< "gauss", "lobatto"

[[nodiscard]] std::optional<Continuity> continuityFrom(std::string_view text);
[[nodiscard]] std::optional<EnergyKind> energyFrom(std::string_view text);
[[nodiscard]] std::optional<LayoutKind> layoutFrom(std::string_view text);
[[nodiscard]] std::optional<boundary::Departure> departureFrom(std::string_view text);
[[nodiscard]] std::optional<boundary::MatchKind> matchFrom(std::string_view text);
[[nodiscard]] std::optional<analysis::CurvatureQuantity> quantityFrom(std::string_view text);
[[nodiscard]] std::optional<spline::QuadratureFamily> quadratureFrom(std::string_view text);

}  // namespace fairing::text
