// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"

#include <QObject>

#include <memory>
#include <optional>

class QAction;

namespace limn {

struct WindowContext;

/// The look of the volume that was open before the present one, for the next patient: the same curve and
/// light, moved onto the values of what is open where the two have no common scale.
class EarlierLook : public QObject {
  Q_OBJECT

public:
  explicit EarlierLook(WindowContext& context);

private:
  void follow(const Scene& scene);
  void use();

  /// A look, and the data that it was shaped on.
  struct Shaped {
    Preset look; ///< knows the landmarks of those data
    bool isHounsfield = false;
  };

  WindowContext& m_context;
  QAction* m_use;                       ///< shows that look, as one undo step; out of use while there is none
  std::weak_ptr<const Volume> m_volume; ///< that `m_present` belongs to
  std::optional<Shaped> m_present;
  std::optional<Shaped> m_earlier;
};

} // namespace limn
