// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/EffectRows.h"

#include <cmath>

namespace limn {
namespace {

struct Group {
  const char* name;
  Message title;
  EffectSet effects;
  Effect speaker; ///< whose reason tells why the row is off
};

// In the order of the scene format's documentation.
const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"gradient", Message::tr("Boundaries (gradient)"), {Effect::gradient}, Effect::gradient},
      {"lighting",
       Message::tr("Light"),
       {Effect::lighting, Effect::diffuse, Effect::fixedLight},
       Effect::lighting},
      {"specular",
       Message::tr("Highlights"),
       {Effect::specular, Effect::phong, Effect::specularOfLight},
       Effect::specular},
      {"exponent_map",
       Message::tr("Highlight sharpness by boundary (SP)"),
       {Effect::exponentMap},
       Effect::exponentMap},
      {"opacity_map",
       Message::tr("Boundary emphasis (O)"),
       {Effect::opacityMap, Effect::opacityFactor},
       Effect::opacityMap},
      {"gradient_curve",
       Message::tr("Curve over boundary strength"),
       {Effect::gammaCurve, Effect::logCurve},
       Effect::gammaCurve},
      {"robust",
       Message::tr("Robust highlights"),
       {Effect::energyFactor, Effect::significance},
       Effect::significance},
      {"fog", Message::tr("Fog"), {Effect::fogLinear, Effect::fogExp, Effect::fogExp2}, Effect::fogExp},
      {"crop", Message::tr("Crop box"), {Effect::cutFaces}, Effect::cutFaces},
      {"early_termination",
       Message::tr("Rays end early"),
       {Effect::earlyTermination},
       Effect::earlyTermination},
      {"preintegration",
       Message::tr("Exact within each step (pre-integration)"),
       {Effect::preintegration},
       Effect::preintegration},
      {"empty_space_skipping",
       Message::tr("Skip empty space"),
       {Effect::emptySpaceSkipping},
       Effect::emptySpaceSkipping},
      {"gradient_opacity",
       Message::tr("Opacity by boundary strength"),
       {Effect::gradientOpacity},
       Effect::gradientOpacity},
      {"isosurface",
       Message::tr("Surface of one value"),
       {Effect::isosurface, Effect::hybrid},
       Effect::isosurface},
      {"jitter", Message::tr("Shifted samples (jitter)"), {Effect::jitter}, Effect::jitter},
      {"knee", Message::tr("Soft limit of brightness (knee)"), {Effect::knee}, Effect::knee},
      {"two_sided", Message::tr("Light on both sides"), {Effect::twoSided}, Effect::twoSided},
      {"region", Message::tr("Kept region"), {Effect::region}, Effect::region},
      {"label_looks", Message::tr("Looks of labels"), {Effect::labelLooks}, Effect::labelLooks},
      {"shadow", Message::tr("Shadows"), {Effect::shadow}, Effect::shadow},
      {"occlusion", Message::tr("Dark hollows (occlusion)"), {Effect::occlusion}, Effect::occlusion},
      {"smooth_normals", Message::tr("Smooth normals"), {Effect::smoothNormals}, Effect::smoothNormals},
      {"physical", Message::tr("Physical light"), {Effect::physical}, Effect::physical},
      {"own_weights", Message::tr("Own weights between voxels"), {Effect::ownWeights}, Effect::ownWeights},
  };
  return all;
}

// A crop box is no effect of a program by itself: it only shortens rays.
EffectRow cropRow(EffectRow row, const Scene& scene, const EffectPlan& plan) {
  const bool cuts = scene.crop != CropBox{};
  row.isOn = plan.isVisible && cuts;
  if (!cuts)
    row.reason = Message::tr("the crop box keeps the whole volume");
  else if (!plan.isVisible)
    row.reason = Message::tr("nothing of the volume can be seen");
  else if (plan.effects.has(Effect::cutFaces))
    row.reason = Message::tr("the crop box cuts the volume, and the cuts are lit as surfaces");
  else
    row.reason = Message::tr("the crop box cuts the volume");
  return row;
}

EffectRow rowOfGroup(const Group& group, const EffectPlan& plan) {
  EffectRow row{group.name, group.title, plan.effects.hasAny(group.effects), {}, group.effects};
  for (const EffectReason& reason : plan.reasons) {
    if (row.isOn && reason.isNeeded && group.effects.has(reason.effect))
      row.reason = row.reason.followedBy("; ", reason.reason);
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

Message timeNumber(double ms) {
  return Message::fixed(ms, ms < 10.0 ? 1 : 0);
}

// `size` is how large it is, with or without its spread.
Message costOfSize(const EffectCost& cost, const Message& size) {
  if (isLostInSpread(cost))
    return Message::tr("≈ 0 ms");
  if (cost.ms < 0.0 && cost.withoutMs > 0.0)
    return Message::tr("saves %1 of %2 ms").arg(size, timeNumber(cost.withoutMs));
  const Message time = Message::tr("%1 ms").arg(size);
  return cost.ms < 0.0 ? Message::tr("saves %1").arg(time) : time;
}

// Two digits, or all before the point.
Message levelsOf(double number) {
  return number < 10.0 ? Message::rounded(number, 2) : Message::fixed(number, 0);
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

bool isLostInSpread(const EffectCost& cost) {
  const double size = std::abs(cost.ms);
  return size <= 2.0 * cost.spreadMs || size < 0.05;
}

Message costText(const EffectCost& cost) {
  return costOfSize(cost, timeNumber(std::abs(cost.ms)));
}

Message costWithSpreadText(const EffectCost& cost) {
  return costOfSize(cost,
                    Message::tr("%1 ± %2").arg(timeNumber(std::abs(cost.ms)), timeNumber(cost.spreadMs)));
}

Message wouldCostText(const EffectCost& cost) {
  if (isLostInSpread(cost))
    return Message::tr("would take hardly any time");
  const Message size = timeNumber(std::abs(cost.ms));
  return cost.ms < 0.0 ? Message::tr("would save %1 of %2 ms").arg(size, timeNumber(cost.withoutMs))
                       : Message::tr("would take %1 ms more").arg(size);
}

Message wouldBringText(const PictureChange& change) {
  if (change.mostLevels < 0.5)
    return Message::tr("would change nothing in this picture that could be seen");
  return Message::tr("would change this picture by up to %1 of 255 levels, by %2 on average")
      .arg(levelsOf(change.mostLevels), levelsOf(change.meanLevels));
}

Message broughtText(const PictureChange& change) {
  if (change.mostLevels < 0.5)
    return Message::tr("changes nothing in this picture that could be seen");
  return Message::tr("changes this picture by up to %1 of 255 levels, by %2 on average")
      .arg(levelsOf(change.mostLevels), levelsOf(change.meanLevels));
}

} // namespace limn
