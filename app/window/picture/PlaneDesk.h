// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/view/gestures/Probe.h"

#include <QObject>

namespace limn {

class Actions;
class CompareView;
class OpenDocument;
class PlaneDeck;
class Session;
class StatusTexts;
class TransferFunctionEditor;

/// One place and its value, shown wherever it matters: the crosshair in the slices, its mark in the picture,
/// its value on the curve. While the picture is probed, the probe's value stands on the curve; where one is
/// pinned there, the crosshair goes to its place.
class PlaneDesk : public QObject {
  Q_OBJECT

public:
  struct Parts {
    Session& session;
    const OpenDocument& document;
    PlaneDeck& deck;
    CompareView& view;
    TransferFunctionEditor& curve;
    StatusTexts& status;
    const Actions& actions;
  };

  PlaneDesk(const Parts& parts, QObject* parent);

  /// Pins the value of a place on the curve, and where there are slices puts the crosshair there.
  void goTo(const glm::dvec3& worldMm);

  /// Lights up in the slices what a point of the scene's curve governs, or nothing; the next scene ends it.
  void setEmphasised(std::optional<std::size_t> point);

  /// The slices in a session file.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

private:
  void showScene(const Scene& scene);
  void show();
  void showProbe(const std::optional<Probe>& probe);
  void showInSlices(const glm::dvec3& worldMm);
  void setLayout(PlaneLayout layout);

  Parts m_parts;
  PlaneContent m_content;
  std::optional<Probe> m_probe;
};

} // namespace limn
