// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <vtkSmartPointer.h>

class vtkImageData;

namespace limn {

/// A volume as VTK holds it, in millimetres along its own axes from its first voxel; where those axes were
/// left-handed the first one is turned round. `grid` says where that is.
struct VtkVolumeImage {
  vtkSmartPointer<vtkImageData> image; ///< stored values, before rescaling
  Grid grid;
};

/// Shares the voxels where it can: `volume` must outlive the image.
VtkVolumeImage vtkImageOf(const Volume& volume);

} // namespace limn
