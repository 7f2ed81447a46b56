// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/edit/edit_surface.h"
#include "core/span/fill_options.h"
#include "occt/picks.h"
#include "occt/read_chains.h"
#include "occt/result_mode.h"
#include "occt/shape_index.h"
#include "text/words.h"

namespace fairing::cli {

/// What stands on the command line, as text: the words are looked at after parsing, so that each
/// mistake gets its sentence.
struct PickArguments {
  std::vector<std::string> edges, faces;
  std::string continuity = "G1";
  std::vector<std::string> edgeContinuity, tangents, symmetries;
  std::optional<double> gap, angle;

  void addTo(CLI::App& command);
  /// Fails with UnknownChoice.
  [[nodiscard]] Result<occt::Picks> picks() const;
  /// Zero is no tolerance, whatever it means elsewhere. Fails with ToleranceNotPositive.
  [[nodiscard]] Result<Tolerance> tolerance() const;
};

/// What every command that makes faces takes.
struct SolveArguments {
  std::string shape, out, report;
  std::string energy{text::word(FillOptions{}.energy)}, inner = "G1", result = "patches";
  std::string quadrature{text::word(FillOptions{}.quadrature.family)};
  int quadraturePoints = 0;
  int degree = 0, maxPoles = FillOptions{}.maxPoles;

  void addShape(CLI::App& command, const char* whatShape);
  /// What a comparison has not: the energy, and where the result goes.
  void addResult(CLI::App& command);
  void addChoices(CLI::App& command);
  /// Fails with UnknownChoice and with what the tolerance failed with.
  [[nodiscard]] Result<FillOptions> options(const Result<Tolerance>& tolerance) const;
  [[nodiscard]] Result<occt::ResultMode> mode() const;
};

/// What guides a surface.
struct GuideArguments {
  double lambda = 0.0, gamma = 0.0;
  std::string reference, guide;

  void addTo(CLI::App& command);
  /// Reads the reference and the guide file. Fails with the codes of readGuidance().
  [[nodiscard]] Result<energy::Guidance> read() const;
};

struct FillArguments {
  SolveArguments solve;
  PickArguments picks;
  std::string layout = "auto";
  std::vector<std::string> through, throughEdges, throughVertices;
  bool outer = false;
  GuideArguments guide;

  void addTo(CLI::App& command);
  /// What a comparison takes, too.
  void addHole(CLI::App& command);
  /// Reads the reference and the guide file, too. Fails with UnknownChoice, the codes of
  /// validate() and readGuidance().
  [[nodiscard]] Result<FillOptions> options() const;
  /// What the patches must pass through. Fails with UnknownChoice, EdgeOutOfRange, VertexOutOfRange
  /// and the codes of readThrough().
  [[nodiscard]] Result<std::vector<InnerConstraint>> innerConstraints(
      const occt::ShapeIndex& index) const;
};

/// A blend: two sides, or edges that make them.
struct BlendArguments {
  SolveArguments solve;
  std::vector<std::string> edges, from, to, edgeContinuity, pairs, cuts, ends, endFaces;
  std::string continuity = "G1", match = "auto";
  double alignment = 0.0;
  std::optional<double> gap, angle;
  std::vector<double> reachFrom{1.0}, reachTo{1.0};  ///< at the start, at the end
  std::string departureFrom = "free", departureTo = "free";
  double setbackFrom = 0.0, setbackTo = 0.0;
  std::vector<std::string> fromCurve, toCurve;
  bool flipFrom = false, flipTo = false;
  GuideArguments guide;

  void addTo(CLI::App& command);
  /// What a comparison takes, too.
  void addSides(CLI::App& command);
  /// Fails with UnknownChoice, OneSideOnly where `edges` are one chain, and the codes of
  /// groupEdges().
  [[nodiscard]] Result<occt::BlendPicks> picks(const occt::ShapeIndex& index) const;
  /// Reads the reference and the guide file, too. Fails with UnknownChoice, the codes of
  /// validate() and readGuidance().
  [[nodiscard]] Result<BlendOptions> options() const;
};

struct EditArguments {
  std::string shape, out, face, report;
  std::string energy{text::word(EditOptions{}.energy)}, keep;
  GuideArguments guide;
  int degree = 0, spans = 0;

  void addTo(CLI::App& command);
  /// Reads the reference and the guide file, too. Fails with UnknownChoice, the codes of
  /// validate() and readGuidance().
  [[nodiscard]] Result<EditOptions> options() const;
  /// The face. Fails with UnknownChoice.
  [[nodiscard]] Result<int> number() const;
};

/// Energies that are compared.
struct EnergyArguments {
  std::vector<std::string> words;  ///< none: all

  void addTo(CLI::App& command);
  /// Fails with UnknownChoice.
  [[nodiscard]] Result<std::vector<EnergyKind>> read() const;
};

/// The same fill with several energies.
struct CompareArguments {
  FillArguments fill;
  EnergyArguments energies;

  void addTo(CLI::App& command);
};

/// The same blend with several energies.
struct CompareBlendArguments {
  BlendArguments blend;
  EnergyArguments energies;

  void addTo(CLI::App& command);
};

struct ReportArguments {
  std::string shape, patches, report;
  PickArguments picks;

  void addTo(CLI::App& command);
};

}  // namespace fairing::cli
