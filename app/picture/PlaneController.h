// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"
#include "widgets/curve/picture/CanvasPicture.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/view/gestures/Probe.h"

#include <QObject>

#include <optional>

class QActionGroup;

namespace limn {

struct WindowContext;

/// One place and its value, shown wherever it matters: the crosshair in the slices (CrosshairController marks
/// it in the picture), its value on the curve. While the picture is probed, the probe's value stands on the
/// curve; where one is pinned there, the crosshair goes to its place.
class PlaneController : public QObject {
  Q_OBJECT

public:
  /// The action that cuts open to the crosshair (CrosshairController) must have been registered.
  explicit PlaneController(WindowContext& context);

  /// Pins the value of a place on the curve, and where there are slices puts the crosshair there.
  void goTo(const glm::dvec3& worldMm);

  /// Lights up in the slices what a point of the scene's curve governs, or of that of a label, or nothing;
  /// the next scene ends it.
  void setEmphasised(std::optional<std::size_t> point, std::optional<std::size_t> label);

  /// What is measured in the volume, and which of it is in hand.
  void setMeasured(const std::vector<Measured>& measured, const std::shared_ptr<const Volume>& volume,
                   std::optional<std::size_t> inHand);

  /// What stands out in the slices: a piece before it is cut.
  void setLit(const limn::PlaneLit& lit);

  /// The slices in a session file.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

signals:
  /// The value under the pointer, or else under the crosshair, belongs on the curve.
  void valueMarked(const std::optional<limn::ValueMark>& mark);
  void valuePinned(std::optional<double> value);
  void probed(const std::optional<limn::Probe>& probe);

private:
  void addLayouts();
  void showScene(const Scene& scene);
  void show();
  void showProbe(const std::optional<Probe>& probe);
  void showInSlices(const glm::dvec3& worldMm);
  void setLayout(PlaneLayout layout);

  WindowContext& m_context;
  QActionGroup* m_layouts; ///< data: PlaneLayout as int
  PlaneContent m_content;
  std::optional<Probe> m_probe;
};

} // namespace limn
