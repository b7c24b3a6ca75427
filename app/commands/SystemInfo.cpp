// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/SystemInfo.h"

#include "gl/DriverFacts.h"
#include "gl/DriverHealth.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"

#include <QString>
#include <QSysInfo>
#include <QtGlobal>

#include <cstdio>
#include <thread>

namespace limn {
namespace {

void printDriver(const DriverFacts& driver) {
  std::printf("OpenGL      %s\n", driver.renderer.c_str());
  std::printf("version     %s, GLSL %s\n", driver.version.c_str(), driver.shadingLanguage.c_str());
  std::printf("3D textures up to %d texels along an edge\n", driver.largest3dTexture);
  std::printf("resets      %s\n", driver.tellsOfResets ? "are told" : "are not told by this driver");
}

// Draws a small head in every model, so that a report holds what the driver says of the shaders.
void printTrial() {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 16.0});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300.0, glm::dvec3(0.9, 0.6, 0.5), 0.0},
                                   {300.0, glm::dvec3(1.0, 0.9, 0.8), 0.5}};
  try {
    RayCaster caster;
    for (const ShadingModel model :
         {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
      scene.shading.model = model;
      caster.render(scene, {16, 16});
    }
    std::printf("drawing     works in all four models\n");
  } catch (const DriverError& error) {
    std::printf("drawing     %s\n%s", error.what(), error.details().c_str());
  } catch (const Error& error) {
    std::printf("drawing     %s\n", error.what());
  }
}

} // namespace

void printSystemInfo() {
  std::printf("limn        %s\n", LIMN_VERSION);
  std::printf("Qt          %s\n", qVersion());
  std::printf("system      %s, %s\n", QSysInfo::prettyProductName().toUtf8().constData(),
              QSysInfo::currentCpuArchitecture().toUtf8().constData());
  std::printf("processors  %u\n", std::thread::hardware_concurrency());
  try {
    const HeadlessContext context;
    printDriver(driverFacts());
    printTrial();
  } catch (const Error& error) {
    std::printf("OpenGL      none: %s\n", error.what());
  }
}

} // namespace limn
