// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QObject>

#include <optional>

namespace limn {

class PlaneDesk;
class PointLight;
class Session;
class TransferFunctionCanvas;

/// Shows what a point of the curve governs for as long as the pointer rests on it: in the slices and in the
/// picture, and in no history.
class EmphasisDesk : public QObject {
  Q_OBJECT

public:
  EmphasisDesk(Session& session, TransferFunctionCanvas& canvas, PlaneDesk& planes, QObject* parent);

signals:
  /// What the picture is to show for a while. The session's own scene ends it.
  void previewed(const limn::Scene& scene);

private:
  void show(std::optional<std::size_t> point);

  Session& m_session;
  PlaneDesk& m_planes;
  PointLight* m_light;
};

} // namespace limn
