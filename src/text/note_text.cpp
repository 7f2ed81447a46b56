// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/note_text.h"

#include <fmt/format.h>

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
  }
  return {};
}

}  // namespace fairing::text
