// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/note_text.h"

#include <fmt/format.h>

#include "core/energy/guidance.h"
#include "text/quantities.h"

namespace fairing::text {

std::string sentence(const analysis::Note& note) {
  switch (note.code) {
    case analysis::NoteCode::EdgeAbsorbed:
      return fmt::format("Edge {} is too short ({}) to be a side of its own: the fill absorbs it.",
                         note.edge,
                         length(note.value));
    case analysis::NoteCode::SupportSingular:
      return fmt::format(
          "The face beside edge {} has no normal at {}: it is taken from the face nearby.",
          note.edge,
          point(note.where));
    case analysis::NoteCode::CurvatureUnknown:
      return fmt::format(
          "The face beside edge {} has no curvature at {}: the edge is met tangentially there.",
          note.edge,
          point(note.where));
    case analysis::NoteCode::LoopUnfit:
      return fmt::format(
          "The hole turns {} from the plane it is trimmed over: another layout suits it better.",
          angle(note.value));
    case analysis::NoteCode::ShapeLimit:
      return fmt::format(
          "The energy was still falling after {:.0f} steps: the best shape so far is kept.",
          note.value);
    case analysis::NoteCode::ShapeStopped:
      return fmt::format(
          "Stopped after {:.0f} steps towards the least energy: the best shape so far is kept.",
          note.value);
    case analysis::NoteCode::ShapeUndefined:
      return fmt::format(
          "The energy is undefined near {}, where the surface it starts from has no normal: the "
          "thin plate is kept.",
          point(note.where));
    case analysis::NoteCode::StripCreased:
      return note.value > 0.0
                 ? fmt::format(
                       "The faces beside the end of edge {} meet at {}: from {} on the blend has a "
                       "crease.",
                       note.edge,
                       angle(note.value),
                       point(note.where))
                 : fmt::format(
                       "The side turns at the end of edge {} and is met in position only: from {} "
                       "on the blend has a crease.",
                       note.edge,
                       point(note.where));
    case analysis::NoteCode::StripFolds:
      return fmt::format(
          "The blend folds: {} of it is turned over about {}; another alignment, or pairs of "
          "vertices, may help.",
          percent(note.value),
          point(note.where));
    case analysis::NoteCode::CutsItself:
      return fmt::format("The blend cuts through itself over {} about {}; less reach may help.",
                         length(note.value),
                         point(note.where));
    case analysis::NoteCode::CutsFace:
      return fmt::format("The blend cuts through face {}, which it joins, over {} about {}.",
                         note.face,
                         length(note.value),
                         point(note.where));
    case analysis::NoteCode::BasesOverlap:
      return fmt::format("The shapes that the blend joins overlap over {} about {}.",
                         length(note.value),
                         point(note.where));
    case analysis::NoteCode::SetbackOffFace:
      return fmt::format(
          "The curve that the blend is set back to was laid onto face {}: edge {} is {} off it at "
          "{}.",
          note.face,
          note.edge,
          length(note.value),
          point(note.where));
    case analysis::NoteCode::SetbackExtended:
      return fmt::format(
          "The curve that the blend is set back to was extended by {} from the end of edge {} at "
          "{} "
          "to the border of face {}.",
          length(note.value),
          note.edge,
          point(note.where),
          note.face);
    case analysis::NoteCode::FaceConverted:
      return fmt::format(
          "Face {} is no polynomial B-spline: it was converted, {} off at most, and so is its "
          "border.",
          note.face,
          length(note.value));
    case analysis::NoteCode::LookUpsStopped:
      return fmt::format(
          "Stopped after looking the guide up {:.0f} of at most {} times: it may not be followed "
          "to "
          "the end.",
          note.value,
          energy::kLookUps + 1);
    case analysis::NoteCode::ReferenceShort:
      return fmt::format(
          "The reference does not cover {} of the surface: the energy alone shapes it there.",
          percent(note.value));
  }
  return {};
}

}  // namespace fairing::text
