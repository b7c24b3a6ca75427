// SPDX-License-Identifier: GPL-3.0-or-later
// Floats, whole and in bricks, lead to the converged picture: how far from it, and as soon.
#include "accuracy/sweep/ConvergedPicture.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/FoldedPicture.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/ModelName.h"
#include "support/Heads.h"
#include "support/RendererRules.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 convergedSize{96, 80};

void redrawPrecisely(const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                     PrecisePixels& pixels) {
  ReferencePicture picture{size, std::move(pixels), std::vector<int>(wanted.size(), 0)};
  redrawReference(picture, scene, wanted);
  pixels = std::move(picture.pixels);
}

DrawPrecisely inFloats(const DrawScene& draw) {
  return [draw](const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                PrecisePixels& pixels) {
    const Image drawn = draw(scene, size);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (wanted[i])
        pixels[i] = glm::dvec4(drawn.pixels[i]);
  };
}

void tell(const std::string& what, const ConvergedPicture& picture, const ConvergedPicture& exact) {
  const ImageError error = imageError(picture.pixels, exact.pixels);
  std::cout << what << ": " << (picture.facts.converged ? "converged" : "NOT converged") << ", fineness "
            << picture.facts.fineness.value_or(0.0) << " step " << picture.facts.stepVoxels << ", last change "
            << picture.facts.lastChangeLevels << " mean " << picture.facts.lastMeanChange << "; from exact p99.9 "
            << error.p99_9 << " mean " << error.mean << " largest " << error.largest << "\n";
}

TEST(ConvergedInFloats, measure) {
  for (const bool isReal : {false, true})
    for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic, ShadingModel::robust})
      for (const Projection projection :
           {Projection::composite, Projection::mip, Projection::xray, Projection::compositeIsosurface}) {
        Scene scene = isReal ? test::headScene(test::ctHead(), model) : test::noisyPhantom(model);
        scene.projection = projection;
        std::cout << (isReal ? "head " : "phantom ") << nameOf(model) << " " << static_cast<int>(projection) << "\n";
        const ConvergedPicture exact = convergedPicture(scene, convergedSize, redrawPrecisely);
        tell("  double ", exact, exact);
        CpuRenderer renderer;
        tell("  float  ", convergedPicture(scene, convergedSize, inFloats([&](const Scene& s, const glm::ivec2& z) {
               return renderer.render(s, z);
             })), exact);
        tell("  bricks4", convergedPicture(scene, convergedSize, inFloats([&](const Scene& s, const glm::ivec2& z) {
               return drawInBricks(s, z, 4);
             })), exact);
      }
}

} // namespace
} // namespace limn
