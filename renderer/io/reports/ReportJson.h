// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/ReadOptions.h"
#include "scene/PictureFigures.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

struct AccuracyReport;
struct BenchRow;
struct BrickRow;
struct EqualErrorRow;
struct NamedReport;
struct EffectCost;
struct EffectRow;
struct ScaleRow;
struct StabilityReport;
class Volume;

/// What is told of a picture that Limn saved, from its own file: of a figure each value that its panels have,
/// once.
struct CarriedFacts {
  std::optional<glm::ivec2> size; ///< pixels; absent of a PDF
  std::vector<std::string> curves, models, lights, views;
  std::vector<std::string> hidden;    ///< what of the volume, in words; empty: nothing
  std::optional<double> withinLevels; ///< of the exact picture, as it was stated
  std::string statement;              ///< how many pixels, and how sure that is; empty: nothing was stated
  std::vector<std::string> volumes;   ///< that it needs, as their names are stored
};

/// What is told of a volume.
struct VolumeFacts {
  std::shared_ptr<const Volume> volume;
  std::vector<SeriesSummary> series;
  double gradientMax = 0.0;        ///< value/mm
  double gradientPercentile = 0.0; ///< the 99.5th, value/mm
};

/// What is told of a picture that was drawn.
struct PictureReport {
  std::string file;
  glm::ivec2 size{0};
  std::string engine;
  double ms = 0.0;
  std::optional<double> withinLevels; ///< of the exact picture, where that was asked for
  std::string statement;              ///< how many pixels, and how sure that is
  std::optional<PictureFigures> figures;
  std::vector<std::string> notes;
  /// Of a picture of physical light: paths of a pixel, their standard errors, and how long they took.
  struct Paths {
    int count = 0;
    std::optional<double> rmsLevels, p99_9Levels;
    double seconds = 0.0;
    bool isFiltered = false; ///< their noise: what is left is an estimate
  };
  std::optional<Paths> paths{};
};

// What machines read of Limn: one JSON object each, keys as the command line documents them.

std::string pictureJson(const PictureReport& picture);

/// Nothing of the patient. `picture` is the one by which the volume was named, if it was.
std::string volumeJson(const VolumeFacts& facts, const std::optional<CarriedFacts>& picture = {});

/// Of a picture without its volume.
std::string carriedJson(const CarriedFacts& picture);

/// The effects of a scene. `costs` has one entry per row, absent where an effect costs nothing; so has
/// `wouldCosts`, of those that are off, which stand under "if_switched_on".
std::string effectsJson(const std::string& renderer, const std::vector<EffectRow>& rows,
                        const std::vector<std::optional<EffectCost>>& costs,
                        const std::vector<std::optional<EffectCost>>& wouldCosts);

/// `machine` names processor and renderer. `equalErrors` may be empty.
std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows,
                      const std::vector<EqualErrorRow>& equalErrors);

/// How opening and drawing grow with the size of volumes, and what ranks do.
std::string scaleJson(const std::string& machine, const std::vector<ScaleRow>& rows,
                      const std::vector<BrickRow>& bricks);

/// Errors are null where the exact picture did not converge.
std::string accuracyJson(const AccuracyReport& report);

/// One line per point, comma separated, with a header; errors are empty where there are none.
std::string accuracyCsv(const AccuracyReport& report);

/// The same of many reports in one table: in front of each line its report, scene, machine, renderer and the
/// size of its pictures in pixels.
std::string cohortCsv(const std::vector<NamedReport>& reports);

/// Figures that are no numbers are null.
std::string stabilityJson(const StabilityReport& report);

} // namespace limn
