// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/controls/BackgroundWork.h"

#include <QDeadlineTimer>
#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace limn {

struct FoundRegion;
struct WindowContext;

/// Asks of a volume that was opened whether something of it shall be hidden: what may lie beside the body,
/// or what was cut away of the volume before. Nothing is hidden without an answer, and another volume ends
/// the question.
class RegionOffers : public QObject {
  Q_OBJECT

public:
  explicit RegionOffers(WindowContext& context);

  /// Of a CT volume that was opened by itself and is shown wholly, because it is not sure which part is the
  /// body: looks beside the event loop whether something lies beside one, and asks whether to hide that.
  void offerBody();

  /// How long after it was found that may still be asked, ms, where something else was said meanwhile: a
  /// minute at first.
  void setAsksFor(int ms) { m_asksForMs = ms; }

  /// Whether it is still being found whether there is something to ask.
  bool isOffering() const { return m_offering.isRunning(); }
  /// Whether that is asked now.
  bool isAsking() const;

  void showScene(const Scene& scene);

signals:
  /// The list of cuts shall be this.
  void cutsWanted(const std::vector<limn::Cut>& cuts, const QString& gesture);

private:
  void askAboutTable(const std::shared_ptr<const Volume>& volume, const FoundRegion& found,
                     const QDeadlineTimer& end);
  void offerCutsOfBefore(const Scene& scene);

  WindowContext& m_context;
  std::shared_ptr<const Volume> m_volume; ///< the one that is open
  std::vector<Cut> m_cuts;                ///< of it, or of the last that was
  BackgroundWork m_offering;              ///< of a body
  int m_asksForMs = 60000;
};

} // namespace limn
