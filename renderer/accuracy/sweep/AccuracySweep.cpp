// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/AccuracySweep.h"

#include "accuracy/sweep/FigureText.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace limn {
namespace {

constexpr double sameP99_9 = 0.15;
constexpr double sameMean = 0.005;
constexpr double fasterBy = 0.9; ///< times differ by less between two runs

bool isAsAccurate(const ImageError& error, const ImageError& own) {
  return error.p99_9 <= own.p99_9 + sameP99_9 && error.mean <= own.mean + sameMean;
}

bool beats(const DecisionCost& cost, const DecisionCost& own) {
  return !cost.isDefault && cost.timesDefault <= fasterBy && isAsAccurate(cost.error, own.error) &&
         isAsAccurate(cost.fineError, own.fineError);
}

std::string sentenceOn(const DecisionCost& cost) {
  std::string memory;
  if (cost.extraMb != 0.0)
    memory = ", with " + threeDigits(std::abs(cost.extraMb)) + " MB " +
             (cost.extraMb > 0.0 ? "more" : "less") + " of graphics memory";
  return "Another way would be faster here and as accurate: " + cost.group + ", " + cost.name + ", in " +
         std::to_string(std::lround(100.0 * cost.timesDefault)) + " % of the time" + memory + ".";
}

constexpr std::size_t fewestTimes = 2;
constexpr std::size_t someTimes = 3;
constexpr std::size_t usualTimes = 7;

// The slower a picture, the less its time varies by a share, and the longer people wait for another.
std::size_t timesOf(double ms) {
  constexpr double quickMs = 100.0, slowMs = 1000.0;
  return ms <= quickMs ? usualTimes : ms <= slowMs ? someTimes : fewestTimes;
}

double elapsedMs(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

glm::ivec2 sizeAt(const OperatingPoint& point, const glm::ivec2& size) {
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * point.imageScale)), glm::ivec2(1));
}

OperatingPoint withStep(OperatingPoint point, double stepVoxels) {
  point.stepVoxels = stepVoxels;
  return point;
}

void addTolerances(std::vector<OperatingPoint>& points, const std::vector<double>& levels) {
  for (const double tolerance : levels) {
    points.emplace_back();
    points.back().toleranceLevels = tolerance;
  }
}

void addSteps(std::vector<OperatingPoint>& points, const OperatingPoint& point,
              const std::vector<double>& steps) {
  for (const double step : steps)
    points.push_back(withStep(point, step));
}

// One sweep while it runs.
class Sweep {
public:
  Sweep(AccuracyReport& report, const Scene& scene, const SweepRenderers& renderers,
        const ReportProgress& progress)
      : m_report(report), m_scene(scene), m_renderers(renderers), m_progress(progress) {}

  // Draws every point once, which gives its picture; of a family's first point it also compiles the program,
  // and under a tolerance finds the steps: those times count for nothing.
  void comparePictures(const std::vector<OperatingPoint>& points, const PrecisePixels& converged) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      tell(0.5 * static_cast<double>(i) / static_cast<double>(points.size()), points[i]);
      try {
        std::vector<double> times;
        m_report.points.push_back(compared(points[i], converged, times));
        m_times.push_back(std::move(times));
      } catch (const Error& error) {
        if (error.kind() != Error::Kind::usage)
          throw;
        m_report.remarks.push_back("Left out " + familyOf(points[i]) + ", " + stepOf(points[i]) + ": " +
                                   error.what());
      }
    }
  }

  void takeTimes() {
    for (std::size_t round = 0; round < usualTimes; ++round)
      for (std::size_t i = 0; i < m_times.size(); ++i) {
        if (!m_times[i].empty() && m_times[i].size() >= timesOf(m_times[i].front()))
          continue;
        const OperatingPoint& point = m_report.points[i].point;
        tell(0.5 + 0.5 *
                       (static_cast<double>(round) +
                        static_cast<double>(i) / static_cast<double>(m_times.size())) /
                       usualTimes,
             point);
        m_times[i].push_back(elapsedMs([&] { draw(point); }));
      }
    for (std::size_t i = 0; i < m_times.size(); ++i)
      m_report.points[i].ms = timingOf(m_times[i]);
  }

private:
  void tell(double fraction, const OperatingPoint& point) const {
    if (m_progress)
      m_progress(fraction, Message::tr("Measuring %1, %2").arg(familyOf(point)).arg(stepOf(point)));
  }

  void draw(const OperatingPoint& point) const {
    m_renderers.draw(m_scene, point, sizeAt(point, m_report.size));
  }

  MeasuredPoint compared(const OperatingPoint& point, const PrecisePixels& converged,
                         std::vector<double>& times) {
    MeasuredPoint measured;
    measured.point = point;
    // Memory depends on the family, not on the step.
    const auto [known, isNew] = m_peaks.try_emplace(familyOf(point), 0.0);
    if (isNew)
      known->second = m_renderers.peakMb(m_scene, point, sizeAt(point, m_report.size));
    measured.peakMb = known->second;
    const double ms = elapsedMs([&] { draw(point); });
    if (!isNew && !point.toleranceLevels)
      times.push_back(ms);
    measured.error = imageError(enlarged(m_renderers.picture(), m_report.size), converged);
    return measured;
  }

  AccuracyReport& m_report;
  const Scene& m_scene;
  const SweepRenderers& m_renderers;
  const ReportProgress& m_progress;
  std::vector<std::vector<double>> m_times;
  std::map<std::string, double> m_peaks;
};

} // namespace

std::vector<std::string> verdictOn(const std::vector<DecisionCost>& costs) {
  std::vector<std::string> sentences;
  for (const DecisionCost& cost : costs) {
    const auto own = std::ranges::find_if(
        costs, [&cost](const DecisionCost& other) { return other.isDefault && other.group == cost.group; });
    if (own != costs.end() && beats(cost, *own))
      sentences.push_back(sentenceOn(cost));
  }
  if (sentences.empty() && !costs.empty())
    sentences.emplace_back("No other way of any decision was as accurate here and faster by a tenth.");
  return sentences;
}

std::vector<OperatingPoint> usualPoints() {
  const std::vector<double> all{2.0, 1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125}, some{1.0, 0.5, 0.25, 0.125};
  std::vector<OperatingPoint> points;
  OperatingPoint point;
  addSteps(points, point, all);
  addTolerances(points, {8.0, 4.0, 2.0, 1.0, 0.5});
  point.preintegrated = true;
  addSteps(points, point, some);
  point = {};
  point.gradients = GradientSource::precomputed;
  addSteps(points, point, some);
  point = {};
  point.earlyTermination = 1.0;
  addSteps(points, point, {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125});
  point.earlyTermination = 0.98;
  addSteps(points, point, {0.5, 0.125});
  point = {};
  point.imageScale = 0.5;
  addSteps(points, point, {2.0, 1.0, 0.5});
  point = {};
  point.engine = Engine::slices;
  addSteps(points, point, some);
  point.engine = Engine::reference;
  addSteps(points, point, {0.5, 0.125});
  return points;
}

std::vector<OperatingPoint> fewPoints() {
  std::vector<OperatingPoint> points;
  addSteps(points, {}, {2.0, 1.0, 0.5, 0.25, 0.125, 0.0625});
  addTolerances(points, {2.0, 0.5});
  return points;
}

std::vector<OperatingPoint> withPoint(std::vector<OperatingPoint> points, const OperatingPoint& asked) {
  const auto coarseness = [](const OperatingPoint& point) {
    return point.toleranceLevels.value_or(point.stepVoxels);
  };
  auto place = points.end();
  for (auto point = points.begin(); point != points.end(); ++point) {
    if (*point == asked)
      return points;
    if (familyOf(*point) != familyOf(asked))
      continue;
    place = std::next(point);
    if (coarseness(*point) < coarseness(asked)) {
      place = point;
      break;
    }
  }
  points.insert(place, asked);
  return points;
}

void measurePoints(AccuracyReport& report, const Scene& scene, const std::vector<OperatingPoint>& points,
                   const PrecisePixels& converged, const SweepRenderers& renderers,
                   const ReportProgress& progress) {
  report.points.clear();
  Sweep sweep(report, scene, renderers, progress);
  sweep.comparePictures(points, converged);
  sweep.takeTimes();
  findOrders(report.points);
  markPareto(report.points);
}

Image enlarged(const Image& image, const glm::ivec2& size) {
  if (image.size == size)
    return image;
  Image result(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec2 scale = glm::vec2(image.size) / glm::vec2(size);
      const glm::vec2 place =
          glm::clamp((glm::vec2(x, y) + 0.5f) * scale - 0.5f, glm::vec2(0.0f), glm::vec2(image.size - 1));
      const glm::ivec2 low(place);
      const glm::ivec2 high = glm::min(low + 1, image.size - 1);
      const glm::vec2 f = place - glm::vec2(low);
      const glm::vec4 upper = glm::mix(image.at(low.x, low.y), image.at(high.x, low.y), f.x);
      const glm::vec4 lower = glm::mix(image.at(low.x, high.y), image.at(high.x, high.y), f.x);
      result.at(x, y) = glm::mix(upper, lower, f.y);
    }
  return result;
}

} // namespace limn
