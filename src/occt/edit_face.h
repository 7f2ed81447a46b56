// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <memory>
#include <utility>

#include "core/edit/edit_surface.h"
#include "occt/result_mode.h"
#include "occt/shape_index.h"

namespace fairing::occt {

class FaceEdit;

/// An edited face.
struct ShapeEdit {
  TopoDS_Face face;    ///< the new face; its edges are those of the old one
  TopoDS_Shape shape;  ///< what was asked for: that face, a shell of it, or the base with it
  EditResult edit;
  bool trimmed = false;                      ///< whether the face is a part of its surface only
  std::shared_ptr<FaceEdit> live = nullptr;  ///< what guiding() moves
};

/// A face whose guidance changes. By one thread at a time.
class FaceEdit {
 public:
  /// Fails with FaceOutOfRange and the codes of SurfaceEdit::make().
  [[nodiscard]] static Result<FaceEdit> make(const ShapeIndex& index,
                                             int face,
                                             const EditOptions& options);
  /// The face under other guidance; looked up as `lookUp` asks. Fails with ResultInvalid and the
  /// codes of SurfaceEdit::under().
  [[nodiscard]] Result<ShapeEdit> under(const energy::Guidance& guidance, bool lookUp);
  /// The same, looked up again until that stands still.
  [[nodiscard]] Result<ShapeEdit> settled(const energy::Guidance& guidance, Progress* progress);
  /// under() costs one solve.
  [[nodiscard]] static bool isQuick() { return true; }
  /// What guided last.
  [[nodiscard]] const energy::Guidance& guidance() const { return guidance_; }
  /// How closely the surface stands for that of the face, mm.
  [[nodiscard]] double deviation() const { return deviation_; }

 private:
  FaceEdit(int number, TopoDS_Face face, bool trimmed, double deviation, SurfaceEdit edit)
      : number_(number),
        face_(std::move(face)),
        trimmed_(trimmed),
        deviation_(deviation),
        edit_(std::move(edit)) {}
  [[nodiscard]] Result<ShapeEdit> faced(Result<EditResult> edit) const;

  int number_;
  TopoDS_Face face_;
  bool trimmed_;
  double deviation_;
  SurfaceEdit edit_;
  energy::Guidance guidance_;
};

/// The face on an edited surface. Its trim stays: of a face that is trimmed out of its surface all
/// control points stay that have a say on the border, so it needs spans enough. A surface that is
/// no polynomial B-spline is converted, and a note says how closely. In the base the new face takes
/// the place of the old one. Fails with FaceOutOfRange, ResultInvalid and the codes of
/// editSurface().
[[nodiscard]] Result<ShapeEdit> editFace(const ShapeIndex& index,
                                         int face,
                                         const EditOptions& options,
                                         ResultMode mode = ResultMode::Patches,
                                         Progress* progress = nullptr);

/// The same edit under other guidance: one numeric factorisation, for previews. By one thread at a
/// time. Fails as FaceEdit::under() does.
[[nodiscard]] Result<ShapeEdit> guiding(const ShapeEdit& edit,
                                        const energy::Guidance& guidance,
                                        bool lookUp);

}  // namespace fairing::occt
