#pragma once
#include <vector>

#include "runtime/destruction/split.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes a piece on a body of its own out of cells that were just taken from `parent`. It moves as the parent did at
/// its centre of mass; `motion` gets that. Pointers and references to shapes and bodies go stale.
ShapeHandle createPiece(EditContext& context, ShapeHandle parent, Piece piece, const MassMoments& moments,
                        PieceMotion& motion);
/// Makes a shape on the same body out of cells that were just taken from `shape`. Pointers to shapes go stale.
ShapeHandle createSplitShape(EditContext& context, ShapeHandle shape, Piece piece, const MassMoments& moments);
/// Puts a shape that lost its last anchor on a free body of its own, where it is.
void detachToNewBody(EditContext& context, ShapeHandle shape);
/// Removes a component of a shape's cells that is too small for a piece. Its mass must be subtracted already.
void discardPiece(EditContext& context, ShapeHandle parent, const Component& component);
/// Erases a shape with its heat, and its body if that has no other. Its lights go dark, its joints break.
void destroyShape(EditContext& context, ShapeHandle shape);
/// Erases a shape without voxels; its body stays.
void eraseEmptyShape(EditContext& context, ShapeHandle shape);
/// Erases a shape as destroyShape() does, and takes its voxels out of the accounts. No fragment of it may wait.
void eraseShape(EditContext& context, ShapeHandle shape);
/// Erases a body and its shapes. Their voxels become dust, a cloud a shape and palette entry.
void despawn(EditContext& context, BodyHandle body);

}  // namespace rubble
