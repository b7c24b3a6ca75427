// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/EffectRows.h"

#include <cmath>
#include <cstdio>

namespace limn {
namespace {

struct Group {
  const char* name;
  const char* title;
  EffectSet effects;
  Effect speaker; ///< whose reason tells why the row is off
};

// In the order of the scene format's documentation.
const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"gradient", "Boundaries (gradient)", {Effect::gradient}, Effect::gradient},
      {"lighting", "Light", {Effect::lighting, Effect::diffuse, Effect::fixedLight}, Effect::lighting},
      {"specular",
       "Highlights",
       {Effect::specular, Effect::phong, Effect::specularOfLight},
       Effect::specular},
      {"exponent_map", "Highlight sharpness by boundary (SP)", {Effect::exponentMap}, Effect::exponentMap},
      {"opacity_map",
       "Boundary emphasis (O)",
       {Effect::opacityMap, Effect::opacityFactor},
       Effect::opacityMap},
      {"gradient_curve",
       "Curve over boundary strength",
       {Effect::gammaCurve, Effect::logCurve},
       Effect::gammaCurve},
      {"robust", "Robust highlights", {Effect::energyFactor, Effect::significance}, Effect::significance},
      {"fog", "Fog", {Effect::fogLinear, Effect::fogExp, Effect::fogExp2}, Effect::fogExp},
      {"crop", "Crop box", {Effect::cutFaces}, Effect::cutFaces},
      {"early_termination", "Rays end early", {Effect::earlyTermination}, Effect::earlyTermination},
      {"preintegration",
       "Exact within each step (pre-integration)",
       {Effect::preintegration},
       Effect::preintegration},
      {"empty_space_skipping", "Skip empty space", {Effect::emptySpaceSkipping}, Effect::emptySpaceSkipping},
      {"gradient_opacity",
       "Opacity by boundary strength",
       {Effect::gradientOpacity},
       Effect::gradientOpacity},
      {"isosurface", "Surface of one value", {Effect::isosurface, Effect::hybrid}, Effect::isosurface},
      {"jitter", "Shifted samples (jitter)", {Effect::jitter}, Effect::jitter},
      {"knee", "Soft limit of brightness (knee)", {Effect::knee}, Effect::knee},
      {"two_sided", "Light on both sides", {Effect::twoSided}, Effect::twoSided},
      {"region", "Kept region", {Effect::region}, Effect::region},
  };
  return all;
}

// A crop box is no effect of a program by itself: it only shortens rays.
EffectRow cropRow(EffectRow row, const Scene& scene, const EffectPlan& plan) {
  const bool cuts = scene.crop != CropBox{};
  row.isOn = plan.isVisible && cuts;
  if (!cuts)
    row.reason = "the crop box keeps the whole volume";
  else if (!plan.isVisible)
    row.reason = "nothing of the volume can be seen";
  else if (plan.effects.has(Effect::cutFaces))
    row.reason = "the crop box cuts the volume, and the cuts are lit as surfaces";
  else
    row.reason = "the crop box cuts the volume";
  return row;
}

EffectRow rowOfGroup(const Group& group, const EffectPlan& plan) {
  EffectRow row{group.name, group.title, plan.effects.hasAny(group.effects), {}, group.effects};
  for (const EffectReason& reason : plan.reasons) {
    if (row.isOn && reason.isNeeded && group.effects.has(reason.effect))
      row.reason += (row.reason.empty() ? "" : "; ") + reason.reason;
    if (!row.isOn && reason.effect == group.speaker)
      row.reason = reason.reason;
  }
  return row;
}

// Where no effect of a row can be had because of one that the speaker does not know, that one speaks.
void letOthersSpeak(EffectRow& row, const EffectPlan& plan) {
  if (row.isOn)
    return;
  for (const EffectReason& reason : plan.reasons)
    if (row.effects.has(reason.effect) && reason.isDropped)
      row.reason = reason.reason;
}

} // namespace

std::vector<EffectRow> effectRows(const Scene& scene, const EffectPlan& plan) {
  std::vector<EffectRow> rows;
  for (const Group& group : groups()) {
    EffectRow row = rowOfGroup(group, plan);
    letOthersSpeak(row, plan);
    rows.push_back(row.name == "crop" ? cropRow(row, scene, plan) : row);
  }
  return rows;
}

std::string costText(const EffectCost& cost) {
  const double size = std::abs(cost.ms);
  if (size <= cost.spreadMs || size < 0.05)
    return "≈ 0 ms";
  char number[32];
  std::snprintf(number, sizeof number, size < 10.0 ? "%.1f ms" : "%.0f ms", size);
  return cost.ms < 0.0 ? std::string("saves ") + number : number;
}

} // namespace limn
