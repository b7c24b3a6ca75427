// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QUndoCommand>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace limn {

struct ComparedLook;

/// The model at the right of a comparison. Physical light comes and goes with the scene's, so that undo
/// brings back what was there before it.
struct RightModel {
  ShadingModel shown = ShadingModel::enhanced;
  ShadingModel before = ShadingModel::enhanced; ///< physical light
  void choose(ShadingModel model);
  void leavePhysical() { shown = shown == ShadingModel::physical ? before : shown; }
  bool operator==(const RightModel&) const = default;
};

/// What is compared, as undo and a session file bring it back: two models, or a look with the scene's own.
struct ComparisonState {
  ShadingModel left = ShadingModel::classic; ///< of two models
  RightModel right;
  std::optional<Preset> look;         ///< at the left; its light has a model
  std::optional<Preset> lookFrom;     ///< the preset that it was made from, where it was changed since
  std::optional<RightModel> ownModel; ///< of the right then, where it is not the scene's
  CompareLayout wanted = CompareLayout::sideBySide;
  bool isAsked = false; ///< for by somebody: the layout holds where it has little room, too

  bool operator==(const ComparisonState&) const = default;

  bool isWithSnapshot() const;

  std::optional<ShadingModel> shownOwnModel() const;

  /// The models in the pictures, from left to right, where the scene has `ofScene`.
  std::vector<ShadingModel> models(bool isSingle, ShadingModel ofScene) const;

  /// The look, with the names of both, where the preset in use is called `own` (empty: there is none);
  /// `isFitted`: its curve was moved onto the values of the volume.
  std::optional<ComparedLook> comparedLook(const QString& own, bool isFitted = false) const;

  /// Models are compared from now on.
  void endLook();

  /// The model of a side (0 left, 1 right) of two; beside a look the right one must have a model of its own.
  void setSideModel(int side, ShadingModel model);

  void setRightPhysical(bool is);

  void describe(SessionDocument& session) const;

  /// What a picture shows that was opened; a single one leaves the models of two.
  void take(const ShownSides& sides);
};

/// What a session file tells. A look without a light has this one.
ComparisonState comparisonOf(const SessionDocument& session, const Shading& shading);

/// The scene's look of this moment, remembered as "before". `called` is how it is called, empty where it has
/// no name.
Preset snapshotOf(const Scene& scene, const QString& called);
bool isSnapshot(const Preset& look);

/// A step between two states, the second of which is shown as it is pushed.
class ComparisonEdit : public QUndoCommand {
public:
  using Show = std::function<void()>;

  ComparisonEdit(const QString& text, Show before, Show after)
      : QUndoCommand(text), m_before(std::move(before)), m_after(std::move(after)) {}

  void undo() override { m_before(); }
  void redo() override {
    if (std::exchange(m_wasShown, true))
      m_after();
  }

private:
  Show m_before, m_after;
  bool m_wasShown = false;
};

} // namespace limn
