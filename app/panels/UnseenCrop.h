// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>

#include <functional>
#include <vector>

namespace limn {

struct WindowContext;

/// Finds out whether what the crop box takes away would be seen, so that no note tells of a crop that hides
/// nothing: once the picture rests, and beside the event loop.
class UnseenCrop : public QObject {
  Q_OBJECT

public:
  /// `isKnown` says of a scene whether its crop takes away nothing that is seen, without looking.
  UnseenCrop(WindowContext& context, std::function<bool(const Scene&)> isKnown);

private:
  void followScene(const Scene& scene);
  void judge();

  WindowContext& m_context;
  std::function<bool(const Scene&)> m_isKnown;
  std::vector<Scene> m_judged; ///< the sides of which it is known, or being found, what the crop hides
  BackgroundWork m_judging;
};

} // namespace limn
