/// @file
/// A strict pass over the text of a Wavefront OBJ file. What the OBJ parser
/// gets to see afterwards is well-formed: it would read `v 1 x 2` as zeros and
/// skip faces whose indices lead nowhere.
#pragma once

#include <set>
#include <string>

#include "core/base/result.h"

namespace rtb {

/// The lines of an OBJ file that make a triangle mesh.
struct ObjText {
  /// `v x y z`, `vn x y z`, `vt u v` and `f` lines, the faces in smoothing
  /// groups (`s`) of their own: quads in kQuads, others in none.
  std::string text;
  /// Vertices (from 0) that are not finite; they stand as zeros in `text`.
  std::set<int> non_finite;
  int non_finite_uvs = 0;  ///< Texture coordinates, zeros in `text` too.
  int skipped_faces = 0;   ///< Of fewer than three vertices.
};

/// Largest number of vertices in one face.
inline constexpr int kMaxFaceVertices = 1024;

/// The smoothing group of faces of four vertices.
inline constexpr unsigned int kQuads = 4;

/// Checks numbers and indices, and keeps what makes a mesh. Lines of other
/// kinds (names, groups, materials, curves) are passed over.
/// @param file names the text in errors.
/// @return an Error when a number is not one, or an index is 0 or refers to
/// nothing.
Result<ObjText> CheckObjText(const std::string& text, const std::string& file);

}  // namespace rtb
