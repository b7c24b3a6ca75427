// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/PhantomParts.h"

#include <cmath>

namespace limn {
namespace {

namespace hu {
constexpr double air = -1000, fat = -100, skin = 20, muscle = 50, compactBone = 1200, diploe = 450,
                 greyMatter = 38, whiteMatter = 28, fluid = 8, vitreous = 12, lens = 90, dentine = 1700,
                 enamel = 2600, metal = 8000;
}

constexpr double edge = 1.5;

void addShells(std::vector<PhantomPart>& parts) {
  // Neck first, so that the head covers its upper end.
  parts.push_back({{0, 22, -112}, {52, 50, 60}, hu::skin, edge});
  parts.push_back({{0, 22, -112}, {50, 48, 58}, hu::fat, edge});
  parts.push_back({{0, 22, -112}, {46, 44, 56}, hu::muscle, edge});
  // The face below the skull.
  parts.push_back({{0, -40, -58}, {60, 58, 60}, hu::skin, edge});
  parts.push_back({{0, -40, -58}, {58, 56, 58}, hu::fat, edge});
  parts.push_back({{0, -40, -58}, {55, 53, 55}, hu::muscle, edge});
  // Nose.
  parts.push_back({{0, -92, -34}, {13, 18, 22}, hu::skin, edge});
  // Scalp.
  parts.push_back({{0, 0, 18}, {80, 98, 92}, hu::skin, edge});
  parts.push_back({{0, 0, 18}, {78, 96, 90}, hu::fat, edge});
  parts.push_back({{0, 0, 18}, {75, 93, 87}, hu::muscle, edge});
}

void addSkullAndBrain(std::vector<PhantomPart>& parts) {
  parts.push_back({{0, 0, 18}, {71, 89, 83}, hu::compactBone, edge});
  parts.push_back({{0, 0, 18}, {69, 87, 81}, hu::diploe, edge});
  parts.push_back({{0, 0, 18}, {66, 84, 78}, hu::compactBone, edge});
  parts.push_back({{0, 0, 18}, {64, 82, 76}, hu::fluid, edge});
  parts.push_back({{0, 0, 18}, {62, 80, 74}, hu::greyMatter, edge});
  for (const double side : {-1.0, 1.0}) {
    parts.push_back({{side * 29, 0, 24}, {25, 64, 54}, hu::whiteMatter, edge});
    parts.push_back({{side * 10, -14, 30}, {6, 26, 11}, hu::fluid, edge});
    parts.push_back({{side * 15, 22, 26}, {7, 20, 10}, hu::fluid, edge});
  }
  parts.push_back({{0, 4, 16}, {3, 12, 9}, hu::fluid, edge});
}

void addFace(std::vector<PhantomPart>& parts) {
  for (const double side : {-1.0, 1.0}) {
    // Cheek bones, orbits with the eyes, maxillary sinuses.
    parts.push_back({{side * 40, -48, -25}, {13, 14, 9}, hu::compactBone, edge});
    parts.push_back({{side * 31, -61, -8}, {19, 17, 18}, hu::compactBone, edge});
    parts.push_back({{side * 31, -64, -8}, {15.5, 15.5, 15}, hu::fat, edge});
    parts.push_back({{side * 31, -67, -8}, {12, 12, 12}, hu::vitreous, edge});
    parts.push_back({{side * 31, -76, -8}, {4.5, 2.6, 4.5}, hu::lens, edge});
    parts.push_back({{side * 24, -62, -36}, {12, 17, 15}, hu::compactBone, edge});
    parts.push_back({{side * 24, -62, -36}, {10, 15, 13}, hu::air, edge});
    // The mandible's branches.
    parts.push_back({{side * 44, -24, -62}, {6.5, 15, 28}, hu::compactBone, edge});
    parts.push_back({{side * 35, -46, -86}, {8, 22, 9}, hu::compactBone, edge});
  }
  parts.push_back({{0, -70, -91}, {29, 10, 10}, hu::compactBone, edge});
  parts.push_back({{0, -66, -52}, {30, 18, 7}, hu::compactBone, edge});
  // Frontal sinus, nasal cavity, mouth.
  parts.push_back({{0, -79, 22}, {18, 9, 12}, hu::compactBone, edge});
  parts.push_back({{0, -79, 22}, {13, 5, 7}, hu::air, edge});
  parts.push_back({{0, -72, -30}, {8, 22, 18}, hu::air, edge});
  parts.push_back({{0, -48, -68}, {22, 24, 6}, hu::muscle, edge});
  parts.push_back({{0, 2, -72}, {10, 8, 44}, hu::air, edge});
}

void addTeeth(std::vector<PhantomPart>& parts) {
  // Two arcs of fourteen teeth; a molar of the lower left carries the filling.
  for (int i = 0; i < 14; ++i) {
    const double angle = (i - 6.5) / 6.5 * 1.2;
    const double x = 31.0 * std::sin(angle);
    const double y = -42.0 - 36.0 * std::cos(angle);
    const double width = 2.6 + 1.4 * std::abs(angle);
    parts.push_back({{x, y, -61}, {width, width, 6.0}, hu::enamel, 1.0});
    parts.push_back({{x, y, -60}, {width - 1.2, width - 1.2, 4.6}, hu::dentine, 1.0});
    parts.push_back({{x, y, -76}, {width, width, 6.0}, hu::enamel, 1.0});
    parts.push_back({{x, y, -77}, {width - 1.2, width - 1.2, 4.6}, hu::dentine, 1.0});
    if (i == 12)
      parts.push_back({{x, y, -72}, {2.2, 2.2, 1.8}, hu::metal, 1.0});
  }
}

void addSpine(std::vector<PhantomPart>& parts) {
  for (int i = 0; i < 5; ++i) {
    const double z = -62.0 - 19.0 * i;
    parts.push_back({{0, 26, z}, {15, 12, 7.5}, hu::compactBone, edge});
    parts.push_back({{0, 26, z}, {13, 10, 5.5}, hu::diploe, edge});
    parts.push_back({{0, 50, z - 3}, {5, 16, 5}, hu::compactBone, edge});
    parts.push_back({{0, 42, z}, {8, 7, 12}, hu::fluid, edge});
  }
}

} // namespace

std::vector<PhantomPart> phantomParts() {
  std::vector<PhantomPart> parts;
  addShells(parts);
  addSkullAndBrain(parts);
  addFace(parts);
  addTeeth(parts);
  addSpine(parts);
  return parts;
}

} // namespace limn
