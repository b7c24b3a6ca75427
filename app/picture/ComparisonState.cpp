// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ComparisonState.h"

#include "app/picture/ComparisonController.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QString>

#include <string>

namespace limn {
namespace {

// What the session file calls it, whatever the language.
const std::string snapshotName = "(before)";

} // namespace

void RightModel::choose(ShadingModel model) {
  if (model == ShadingModel::physical && shown != ShadingModel::physical)
    before = shown;
  shown = model;
}

bool ComparisonState::isWithSnapshot() const {
  return look && isSnapshot(*look);
}

std::optional<ShadingModel> ComparisonState::shownOwnModel() const {
  return ownModel ? std::optional(ownModel->shown) : std::nullopt;
}

std::vector<ShadingModel> ComparisonState::models(bool isSingle, ShadingModel ofScene) const {
  if (isSingle)
    return {ofScene};
  if (look)
    return {look->shading->model, shownOwnModel().value_or(ofScene)};
  return {left, right.shown};
}

// Both looks are named after their presets; what was remembered says so where the names tell no difference.
std::optional<ComparedLook> ComparisonState::comparedLook(const QString& own, bool isFitted) const {
  if (!look)
    return std::nullopt;
  const bool isBefore = isSnapshot(*look);
  QString name =
      isBefore ? QString::fromStdString(look->note) : presetWords(QString::fromStdString(look->name));
  if (isBefore)
    name = name.isEmpty() ? ComparisonController::tr("Before")
           : name == own  ? ComparisonController::tr("%1, before", "a preset").arg(name)
                          : name;
  else if (lookFrom)
    name = ComparisonController::tr("%1, modified", "a preset").arg(name);
  else if (isFitted)
    name = fittedWords(QString::fromStdString(look->name));
  const QString ownName = own.isEmpty() ? ComparisonController::tr("Now") : own;
  ComparedLook compared{*look, {name.toStdString(), ownName.toStdString()}};
  compared.shown.isWhole = look->isWhole || isBefore;
  compared.ownModel = shownOwnModel();
  return compared;
}

void ComparisonState::endLook() {
  look.reset();
  lookFrom.reset();
  ownModel.reset();
}

void ComparisonState::setSideModel(int side, ShadingModel model) {
  if (side == 1)
    (look ? *ownModel : right).choose(model);
  else if (look)
    look->shading->model = model;
  else
    left = model;
}

void ComparisonState::setRightPhysical(bool is) {
  for (RightModel* each : {&right, ownModel ? &*ownModel : nullptr})
    if (each)
      is ? each->choose(ShadingModel::physical) : each->leavePhysical();
}

void ComparisonState::describe(SessionDocument& session) const {
  session.layout = wanted; // what gave way comes back with the room
  session.layoutIsAsked = isAsked;
  session.leftModel = left;
  session.rightModel = right.shown;
  session.ownModel = shownOwnModel();
  session.comparedLook = look;
  session.comparedFrom = lookFrom;
}

// The scene beside a look has the model that it had there.
void ComparisonState::take(const ShownSides& sides) {
  endLook();
  wanted = sides.layout;
  if (pictureCount(sides.layout) == 1)
    return;
  look = sides.look;
  if (look && look->name == lookWithoutName)
    look->name = ComparisonController::tr("Other look").toStdString();
  if (!look) {
    left = sides.left;
    right = {.shown = sides.right};
  }
}

ComparisonState comparisonOf(const SessionDocument& session, const Shading& shading) {
  ComparisonState state{.left = session.leftModel,
                        .right = {.shown = session.rightModel},
                        .look = session.comparedLook,
                        .lookFrom = session.comparedFrom,
                        .ownModel = {},
                        .wanted = session.layout,
                        .isAsked = session.layoutIsAsked};
  if (state.look && session.ownModel)
    state.ownModel = {.shown = *session.ownModel};
  if (state.look && !state.look->shading)
    state.look->shading = shading;
  return state;
}

Preset snapshotOf(const Scene& scene, const QString& called) {
  Preset snapshot = presetOf(scene, snapshotName);
  snapshot.note = called.toStdString();
  return snapshot;
}

bool isSnapshot(const Preset& look) {
  return look.name == snapshotName;
}

} // namespace limn
