// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/accuracy/RivalPoints.h"

#include "app/lab/bench/Bench.h"
#include "io/ImageFile.h"
#include "scene/PictureFigures.h"
#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

constexpr double rivalSteps[] = {2.0, 1.0, 0.5, 0.25};
const char* const rivals[] = {"vtk-gpu", "vtk-fixedpoint"};

// Of colours over the background, where either picture shows something.
ImageError errorOf(const BytePicture& picture, const PrecisePixels& exact, const glm::dvec3& background) {
  PrecisePixels shown(exact.size(), glm::dvec4(0.0)), wanted = shown;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::uint8_t* bytes = picture.bytes.data() + 3 * i;
    const glm::dvec3 color = glm::dvec3(bytes[0], bytes[1], bytes[2]) / 255.0;
    const glm::dvec3 off = glm::abs(color - background);
    const bool isShown = std::max({off.r, off.g, off.b}) > 1.0 / 255.0;
    if (!isShown && !isCovered(glm::vec4(exact[i])))
      continue;
    shown[i] = glm::dvec4(color, 1.0);
    const glm::dvec3 over = glm::dvec3(exact[i]) + (1.0 - exact[i].a) * background;
    wanted[i] = glm::dvec4(glm::clamp(over, 0.0, 1.0), 1.0);
  }
  return imageError(shown, wanted);
}

MeasuredPoint measured(Contender& contender, const Scene& scene, const PrecisePixels& exact, int frames) {
  contender.drawFirst(scene);
  std::vector<double> ms;
  for (int i = 0; i < frames; ++i)
    ms.push_back(contender.draw(scene).ms);
  const BytePicture picture = pictureOf(contender);
  const glm::ivec2 size(scene.image.width, scene.image.height);
  if (picture.size != size)
    throw Error(Error::Kind::other, "The picture of " + contender.program() + " has another size.");
  MeasuredPoint point;
  point.point.rival = contender.program();
  point.point.stepVoxels = scene.quality.stepVoxels;
  point.point.earlyTermination = scene.quality.earlyTermination;
  point.error = errorOf(picture, exact, scene.image.background);
  point.ms = timingOf(ms);
  point.peakMb = contender.peakMb();
  return point;
}

} // namespace

void addRivals(AccuracyReport& report, const Scene& scene, const RivalSource& source,
               const PrecisePixels& exact, int frames, const ReportProgress& progress) {
  Scene one = scene;
  one.quality = {};
  int done = 0;
  bool isAny = false;
  for (const char* rival : rivals) {
    BenchEntries entries;
    entries.engines = {rival};
    entries.readOptions = source.readOptions;
    try {
      const auto contenders = contendersFor(entries, source.volumePath);
      for (const double step : rivalSteps) {
        if (progress)
          progress(done++ / 8.0, Message::tr("Measuring %1, %2").arg(rival).arg("step " + threeDigits(step)));
        one.quality.stepVoxels = step;
        report.points.push_back(measured(*contenders.front(), one, exact, frames));
        isAny = true;
      }
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      report.remarks.push_back(std::string("Left out ") + rival + ": " + error.what());
    }
  }
  if (!isAny)
    return;
  report.remarks.push_back(
      "VTK's mappers drew behind Limn's points, not in turns with them; they are measured "
      "against the exact picture lit from both sides, as they light it, rounded to 8 bits.");
  findOrders(report.points);
  markPareto(report.points);
}

} // namespace limn
