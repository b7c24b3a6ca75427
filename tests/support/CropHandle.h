// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <gtest/gtest.h>

namespace limn::test {

/// Where the handle of a face of the crop box stands in the picture at `position`, logical pixels of the
/// view.
inline QPointF cropHandle(const CompareView& view, CropFace face, int position = 0) {
  const Scene& scene = view.scene();
  const ViewProjection projection = viewProjection(scene.camera, view.logicalRect(position));
  for (const CropHandle& handle : cropBoxShape(scene.crop, scene.volume->grid(), projection).handles)
    if (handle.face == face)
      return handle.centre;
  ADD_FAILURE() << "the handle cannot be taken hold of";
  return {};
}

} // namespace limn::test
