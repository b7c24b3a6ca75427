// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QObject>

#include <optional>

namespace limn {

class Actions;
class CompareView;
class Session;

/// Which models are compared, and in which layout: chosen by buttons and in the pictures, shown by both.
class ComparisonDesk : public QObject {
  Q_OBJECT

public:
  ComparisonDesk(Session& session, CompareView& view, const Actions& actions, QObject* parent);

  void setLayout(CompareLayout layout);

  /// The model of a side (0 left, 1 right) of a comparison; of a single picture the scene's own.
  void setSideModel(int side, ShadingModel model);

  /// A scene has been opened. An unlit image (imageLook) is shown alone: no model of light tells it from
  /// another. What is opened after it has the layout from before, unless someone chose one meanwhile.
  void showOpened();

  /// Shows models and layout of the moment.
  void show();

  /// Layout, models and border in a session file.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

signals:
  /// The models in the pictures on screen, from left to right.
  void modelsShown(const std::vector<limn::ShadingModel>& models);
  void shown();

private:
  Session& m_session;
  CompareView& m_view;
  const Actions& m_actions;
  ShadingModel m_left = ShadingModel::classic;
  ShadingModel m_right = ShadingModel::enhanced;
  std::optional<CompareLayout> m_beforeImage; ///< while an image is shown alone
};

} // namespace limn
