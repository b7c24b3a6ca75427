// SPDX-License-Identifier: GPL-3.0-or-later
// What smooth normals make of the terraces of thick slices: for each volume, with and without a smoothing of
// 0.7 of the distance between slices, how far the normals of its surface (skin in CT, else the threshold
// between background and object) tilt towards the axis of the slices. Along runs of 8 slices, 16 places in
// each, the tilt is divided by its period: a slice and half of one (terraces), what lies between those, and
// two slices and more (shape). Figures are RMS in degrees over all runs; a window of Hann weighs the places
// of a run. The surface is that of the field itself, so both look at the same places.
//
// limn_terrace_gain VOLUME...
#include "io/VolumeReader.h"
#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <optional>

namespace limn {
namespace {

constexpr int slicesInRun = 8;
constexpr int placesInSlice = 16;
constexpr int placesInRun = slicesInRun * placesInSlice;
constexpr int linesApart = 3; // voxels

using Run = std::array<glm::dvec3, placesInRun>; // voxel indices on the surface

struct Axes {
  int slices = 2, along = 0, across = 1;
};

Axes axesOf(const Grid& grid) {
  Axes axes;
  for (int axis = 0; axis < 3; ++axis)
    if (grid.spacingMm[axis] > grid.spacingMm[axes.slices])
      axes.slices = axis;
  axes.along = (axes.slices + 1) % 3;
  axes.across = (axes.slices + 2) % 3;
  return axes;
}

// Where a line first rises to the value.
std::optional<glm::dvec3> surfaceAlong(const Volume& volume, int axis, glm::dvec3 index, double value) {
  const int count = volume.grid().dims[axis];
  const auto isInside = [&](double at) {
    index[axis] = at;
    return valueAt(volume, index) >= value;
  };
  if (isInside(0.0))
    return std::nullopt;
  double inside = 0.5;
  while (inside < count - 1 && !isInside(inside))
    inside += 0.5;
  if (inside >= count - 1)
    return std::nullopt;
  double outside = inside - 0.5;
  for (int n = 0; n < 20; ++n) {
    const double middle = 0.5 * (inside + outside);
    (isInside(middle) ? inside : outside) = middle;
  }
  index[axis] = inside;
  return index;
}

// Absent where the surface is torn: from place to place it moves by no more than a millimetre and a voxel.
std::optional<Run> runFrom(const Volume& volume, const Axes& axes, int slice, int line, double value) {
  Run run;
  const double most = 1.0 + 1.0 / volume.grid().spacingMm[axes.along];
  for (int n = 0; n < placesInRun; ++n) {
    glm::dvec3 index(0.0);
    index[axes.slices] = slice + static_cast<double>(n) / placesInSlice;
    index[axes.across] = line;
    const std::optional<glm::dvec3> found = surfaceAlong(volume, axes.along, index, value);
    if (!found ||
        (n > 0 && std::abs((*found)[axes.along] - run[static_cast<std::size_t>(n) - 1][axes.along]) > most))
      return std::nullopt;
    run[static_cast<std::size_t>(n)] = *found;
  }
  return run;
}

// Mean squares of tilts, degrees².
struct Tilt {
  double terraces = 0.0, between = 0.0, shape = 0.0;
};

void addRun(const std::array<double, placesInRun>& tilts, Tilt& sum) {
  double mean = 0.0;
  for (const double tilt : tilts)
    mean += tilt / placesInRun;
  for (int k = 1; k <= 2 * slicesInRun + 1; ++k) {
    std::complex<double> part = 0.0;
    for (int n = 0; n < placesInRun; ++n) {
      const double turn = 2.0 * std::numbers::pi * n / placesInRun;
      part += (tilts[static_cast<std::size_t>(n)] - mean) * 0.5 * (1.0 - std::cos(turn)) *
              std::polar(1.0, -k * turn);
    }
    // Both signs of the frequency; the squares of Hann's window have the mean 3/8.
    const double square = 2.0 * std::norm(part) / (placesInRun * placesInRun) / 0.375;
    const bool isTerrace = std::abs(k - slicesInRun) <= 1 || std::abs(k - 2 * slicesInRun) <= 1;
    (isTerrace ? sum.terraces : k <= slicesInRun / 2 ? sum.shape : sum.between) += square;
  }
}

void print(const char* what, const Tilt& sum, double runs) {
  std::printf("  %-8s terraces %6.2f°  between %6.2f°  shape %6.2f°\n", what, std::sqrt(sum.terraces / runs),
              std::sqrt(sum.between / runs), std::sqrt(sum.shape / runs));
}

void measure(const std::string& path) {
  const std::shared_ptr<const Volume> volume = readVolume(path);
  const Axes axes = axesOf(volume->grid());
  const double thickness = volume->grid().spacingMm[axes.slices];
  const double sigma = 0.7 * thickness;
  const auto begin = std::chrono::steady_clock::now();
  const auto smoothed = smoothedVolume(volume, sigma);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  const double value = looksLikeHounsfield(*volume) ? -300.0 : objectThreshold(histogramOf(*volume));
  Tilt without, with;
  int runs = 0;
  for (int slice = 1; slice + slicesInRun < volume->grid().dims[axes.slices] - 1; slice += slicesInRun / 2)
    for (int line = 1; line < volume->grid().dims[axes.across] - 1; line += linesApart)
      if (const std::optional<Run> run = runFrom(*volume, axes, slice, line, value)) {
        std::array<double, placesInRun> plain, smooth;
        for (std::size_t n = 0; n < run->size(); ++n) {
          const auto tiltOf = [&](const Volume& field) {
            const glm::dvec3 gradient =
                glm::transpose(volume->grid().direction) * gradientAt(field, (*run)[n]);
            const double length = glm::length(gradient);
            return length > 0.0
                       ? glm::degrees(std::asin(std::clamp(gradient[axes.slices] / length, -1.0, 1.0)))
                       : 0.0;
          };
          plain[n] = tiltOf(*volume);
          smooth[n] = tiltOf(*smoothed);
        }
        addRun(plain, without);
        addRun(smooth, with);
        ++runs;
      }
  const glm::dvec3& spacing = volume->grid().spacingMm;
  std::printf(
      "%s: slices %.2f mm, %.1f pixels apart, smoothing %.2f mm in %.0f ms, surface at %.0f, %d runs\n",
      path.c_str(), thickness, thickness / std::min(spacing[axes.along], spacing[axes.across]), sigma,
      took.count(), value, runs);
  print("without", without, runs);
  print("with", with, runs);
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  try {
    for (int i = 1; i < argc; ++i)
      limn::measure(argv[i]);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return argc > 1 ? 0 : 2;
}
