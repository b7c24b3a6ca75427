// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Orientation.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// LPS: +x is the patient's left, +y the back, +z the head.
constexpr std::array<std::string_view, 3> lettersOfAxes{"RL", "AP", "IS"};

struct SignedAxis {
  int axis = 0;
  double sign = 1.0;
};

SignedAxis axisNamed(char letter) {
  for (int axis = 0; axis < 3; ++axis)
    if (const auto end = lettersOfAxes[static_cast<std::size_t>(axis)].find(letter);
        end != std::string_view::npos)
      return {axis, end == 1 ? 1.0 : -1.0};
  return {-1, 0.0};
}

} // namespace

std::array<int, 3> patientAxes(const glm::dmat3& direction) {
  std::array<int, 3> order{0, 1, 2};
  std::array<int, 3> best = order;
  double largest = -1.0;
  do {
    double agreement = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      agreement += std::abs(direction[axis][order[static_cast<std::size_t>(axis)]]);
    if (agreement <= largest)
      continue;
    largest = agreement;
    best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

bool areAxisLetters(std::string_view letters) {
  std::array<int, 3> times{};
  for (const char letter : letters)
    if (const int axis = axisNamed(letter).axis; axis >= 0)
      ++times[static_cast<std::size_t>(axis)];
  return letters.size() == 3 && times == std::array{1, 1, 1};
}

std::string axisLettersOf(const Grid& grid) {
  const std::array<int, 3> axes = patientAxes(grid.direction);
  std::string letters;
  for (int axis = 0; axis < 3; ++axis) {
    const auto patient = static_cast<std::size_t>(axes[static_cast<std::size_t>(axis)]);
    letters += lettersOfAxes[patient][grid.direction[axis][static_cast<int>(patient)] > 0.0 ? 1 : 0];
  }
  return letters;
}

Grid withAxisLetters(Grid grid, const std::string& letters) {
  assert(areAxisLetters(letters));
  const glm::dvec3 centre = boxCentreMm(grid);
  grid.direction = glm::dmat3(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const SignedAxis patient = axisNamed(letters[static_cast<std::size_t>(axis)]);
    grid.direction[axis][patient.axis] = patient.sign;
  }
  grid.originMm += centre - boxCentreMm(grid);
  return grid;
}

std::shared_ptr<const Volume> orientedByHand(const Volume& volume, const std::string& letters) {
  VolumeInfo info = volume.info();
  info.orientationKnown = true;
  info.orientationByHand = letters;
  info.gridOfFile = gridOfFile(volume);
  std::erase(info.warnings, orientationUnknown);
  return std::make_shared<const Volume>(
      volume.placed(withAxisLetters(volume.grid(), letters), std::move(info)));
}

const Grid& gridOfFile(const Volume& volume) {
  const std::optional<Grid>& told = volume.info().gridOfFile;
  return told ? *told : volume.grid();
}

} // namespace limn
