// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Image.h"
#include "scene/effects/EffectPlan.h"

#include <memory>
#include <string>

namespace limn {

/// Throws Error (usage) naming what slices cannot draw: every projection but composite and X-ray, which is
/// white blended alike. Blending knows one operation, and no slice knows those before it.
void requireSliceable(const Scene& scene);

/// The effects of a scene that a slice draws: what the scene calls for, less what belongs to the march along
/// a ray, with the reason.
EffectPlan sliceEffects(const Scene& scene, const SceneFacts& facts);

/// In which order slabs are blended; both are the same picture but for rounding, which is smaller front to
/// back (the lecture's formula): there the blender subtracts the whole opacity so far from 1 and not a faint
/// layer's, of which little is left in a float.
enum class BlendOrder { frontToBack, backToFront };

/// Draws scenes as the lecture does: polygons parallel to the picture through the 3D texture, sorted and
/// blended with *over*. A polygon stands for the slab between two planes; each of its pixels clips its own
/// ray to the slab and to the box, takes one sample at the middle of that piece and weighs it by the piece's
/// length, so that the picture is of second order in the step, at the box's faces too. Shares textures,
/// uniforms and shader blocks with the ray caster.
///
/// Blends in 32-bit floats: thousands of faint layers leave nothing in 8 bits. Each layer's rounding adds
/// less than 2⁻²² to a channel. There is no early termination: pixels pay for every slab.
///
/// All calls, construction and destruction included, need the same context (OpenGL 3.0 or newer) current.
class SliceRenderer {
public:
  /// Throws Error (openGl) where the driver lacks what drawing needs, naming it.
  explicit SliceRenderer(BlendOrder order = BlendOrder::frontToBack);
  ~SliceRenderer();
  SliceRenderer(SliceRenderer&&) noexcept;
  SliceRenderer& operator=(SliceRenderer&&) noexcept;

  /// Draws a whole picture off screen in 32-bit floats and reads it back: premultiplied RGBA without
  /// background, zero outside the volume. Throws Error (usage) for what slices cannot draw.
  Image render(const Scene& scene, const glm::ivec2& size);

  /// A sentence each where the volume had to be down-sampled and where the last picture's step would have
  /// needed too many slabs; empty otherwise.
  Message limitation() const;

  /// Of the weights between voxels, as SceneFacts has them.
  int filterBits();

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace limn
