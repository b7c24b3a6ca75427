// SPDX-License-Identifier: GPL-3.0-or-later
#include "VtkStage.h"

#include "VtkImage.h"
#include "scene/basics/Error.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/RayFrame.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

namespace limn {
namespace {

bool isDrawable(Projection projection) {
  return projection == Projection::composite || projection == Projection::mip ||
         projection == Projection::minip || projection == Projection::xray ||
         projection == Projection::isosurface;
}

void requireDrawableByVtk(const Scene& scene, VtkMapper mapper) {
  const LightingTerms terms = lightingTerms(scene.shading);
  const char* beyond = nullptr;
  if (!isDrawable(scene.projection))
    beyond = "averages and hybrid projections";
  else if (scene.projection == Projection::isosurface && mapper == VtkMapper::fixedPoint)
    beyond = "isosurfaces, which its fixed-point caster does not know,";
  else if (scene.shading.model != ShadingModel::none && scene.shading.model != ShadingModel::classic)
    beyond = "the enhanced and robust models";
  else if (terms.lightDirection)
    beyond = "fixed light";
  else if (scene.fog.mode != Fog::Mode::none)
    beyond = "fog";
  else if (scene.crop != CropBox{})
    beyond = "a crop box";
  else if (scene.gradientOpacity)
    beyond = "gradient opacity by Limn's definition";
  if (beyond)
    throw Error(Error::Kind::usage, std::string("The benchmark does not draw ") + beyond + " with VTK.");
}

// Both functions over the stored values.
void setFunction(vtkVolumeProperty& property, const Scene& scene, const Rescale& rescale) {
  const TransferFunction& function = scene.transferFunction;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  color->AllowDuplicateScalarsOn();
  opacity->AllowDuplicateScalarsOn();
  for (const ControlPoint& point : function.points) {
    const double stored = (point.value - rescale.intercept) / rescale.slope;
    // An X-ray is the composite of something white; a surface is opaque.
    const glm::dvec3 shown = scene.projection == Projection::xray ? glm::dvec3(1.0) : point.color;
    color->AddRGBPoint(stored, shown.r, shown.g, shown.b);
    opacity->AddPoint(stored, scene.projection == Projection::isosurface ? 1.0 : point.opacity);
  }
  if (scene.projection == Projection::isosurface)
    property.GetIsoSurfaceValues()->SetValue(0, (scene.isovalue - rescale.intercept) / rescale.slope);
  property.SetColor(color);
  property.SetScalarOpacity(opacity);
  property.SetScalarOpacityUnitDistance(function.unitDistanceMm);
}

void setLighting(vtkVolumeProperty& property, const Scene& scene) {
  const LightingTerms terms = lightingTerms(scene.shading);
  property.SetInterpolationTypeToLinear();
  property.SetShade(terms.isLit && scene.projection != Projection::xray);
  property.SetAmbient(terms.ambient);
  property.SetDiffuse(terms.diffuse);
  property.SetSpecular(terms.specular);
  property.SetSpecularPower(terms.exponent.atBoundary);
}

template <class Mapper>
vtkSmartPointer<vtkVolumeMapper> mapperWithStep(double step) {
  const auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetImageSampleDistance(1.0f);
  mapper->SetSampleDistance(static_cast<float>(step));
  return mapper;
}

void setCamera(vtkCamera& camera, const Camera& wanted, const Grid& grid) {
  const glm::dmat3 toGrid = glm::transpose(grid.direction);
  const glm::dvec3 position = toGrid * (wanted.position - grid.originMm);
  const glm::dvec3 target = toGrid * (wanted.target - grid.originMm);
  const glm::dvec3 up = toGrid * basisOf(wanted).up;
  camera.SetPosition(position.x, position.y, position.z);
  camera.SetFocalPoint(target.x, target.y, target.z);
  camera.SetViewUp(up.x, up.y, up.z);
  camera.SetViewAngle(wanted.fovYDeg);
  camera.SetParallelProjection(wanted.projection == Camera::Projection::orthographic);
  camera.SetParallelScale(wanted.heightMm / 2.0);
}

} // namespace

VtkStage::VtkStage(VtkMapper mapper, const glm::ivec2& size) : m_kind(mapper) {
  m_window->SetOffScreenRendering(1);
  m_window->SetMultiSamples(0);
  m_window->SetSize(size.x, size.y);
  m_window->AddRenderer(m_renderer);
  m_renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  m_renderer->AddLight(headlight);
  // The context is no part of the first picture.
  m_window->Render();
}

VtkStage::~VtkStage() = default;

std::string VtkStage::renderer() const {
  // The driver's report has a line for it.
  const std::string report = m_window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:";
  const auto at = report.find(key);
  if (at == std::string::npos)
    return "unknown";
  const auto begin = report.find_first_not_of(' ', at + key.size());
  return report.substr(begin, report.find('\n', begin) - begin);
}

void VtkStage::setVolume(std::shared_ptr<const Volume> volume) {
  if (m_actor)
    m_renderer->RemoveVolume(m_actor);
  m_actor = nullptr;
  m_image = nullptr;
  m_volume = std::move(volume);
  const VtkVolumeImage made = vtkImageOf(*m_volume);
  m_image = made.image;
  m_grid = made.grid;
}

void VtkStage::makeVolume(const Scene& scene) {
  const double step = stepMm(scene);
  const auto mapper = m_kind == VtkMapper::gpu ? mapperWithStep<vtkOpenGLGPUVolumeRayCastMapper>(step)
                                               : mapperWithStep<vtkFixedPointVolumeRayCastMapper>(step);
  mapper->SetInputData(m_image);
  if (scene.projection == Projection::mip)
    mapper->SetBlendModeToMaximumIntensity();
  if (scene.projection == Projection::minip)
    mapper->SetBlendModeToMinimumIntensity();
  if (scene.projection == Projection::isosurface)
    mapper->SetBlendModeToIsoSurface();
  m_actor = vtkSmartPointer<vtkVolume>::New();
  m_actor->SetMapper(mapper);
  setLighting(*m_actor->GetProperty(), scene);
  setFunction(*m_actor->GetProperty(), scene, m_volume->rescale());
  m_renderer->AddVolume(m_actor);
}

void VtkStage::update(const Scene& scene) {
  if (!m_actor)
    makeVolume(scene);
  else if (m_shown != scene.transferFunction)
    setFunction(*m_actor->GetProperty(), scene, m_volume->rescale());
  m_shown = scene.transferFunction;
  const glm::dvec3& background = scene.image.background;
  m_renderer->SetBackground(background.r, background.g, background.b);
  setCamera(*m_renderer->GetActiveCamera(), scene.camera, m_grid);
  m_renderer->ResetCameraClippingRange();
}

FrameCost VtkStage::draw(const Scene& scene) {
  requireDrawableByVtk(scene, m_kind);
  m_window->SetSize(scene.image.width, scene.image.height);
  return costOf([&] {
    update(scene);
    m_window->Render();
    m_window->WaitForCompletion();
  });
}

Image VtkStage::picture() const {
  const int* size = m_window->GetSize();
  Image image({size[0], size[1]});
  vtkNew<vtkUnsignedCharArray> bytes;
  m_window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, bytes);
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      // VTK's rows go upwards.
      const unsigned char* rgba =
          bytes->GetPointer(4 * (static_cast<vtkIdType>(size[1] - 1 - y) * size[0] + x));
      image.at(x, y) = {rgba[0] / 255.0f, rgba[1] / 255.0f, rgba[2] / 255.0f, 1.0f};
    }
  return image;
}

} // namespace limn
