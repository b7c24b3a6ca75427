// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/ProcessCost.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;
class vtkVolume;
class vtkVolumeMapper;

namespace limn {

enum class VtkMapper { gpu, fixedPoint };

/// Draws scenes with one of VTK's volume mappers into a window that is never shown: same camera, same
/// transfer function, same step and unit distance, coefficients of the same headlight. VTK lights with Phong
/// and highlights of the light's colour.
class VtkStage {
public:
  VtkStage(VtkMapper mapper, const glm::ivec2& size);
  ~VtkStage();

  /// The OpenGL renderer string.
  std::string renderer() const;

  /// Takes over a volume (its voxels are shared, not copied, unless its axes are left-handed) and forgets the
  /// mapper.
  void setVolume(std::shared_ptr<const Volume> volume);

  /// Brings everything up to `scene` and draws; returns when the pixels are there. The volume is the one set.
  /// Throws Error (usage) naming what VTK cannot draw.
  FrameCost draw(const Scene& scene);

  /// The picture over the scene's background, opaque.
  Image picture() const;

private:
  void makeVolume(const Scene& scene);
  void update(const Scene& scene);

  VtkMapper m_kind;
  std::shared_ptr<const Volume> m_volume;
  Grid m_grid; ///< right-handed
  vtkNew<vtkRenderWindow> m_window;
  vtkNew<vtkRenderer> m_renderer;
  vtkSmartPointer<vtkImageData> m_image;
  vtkSmartPointer<vtkVolume> m_actor;
  TransferFunction m_shown;
};

} // namespace limn
