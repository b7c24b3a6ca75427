// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/UndoStep.h"
#include "app/panels/UnseenCrop.h"
#include "scene/Scene.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <optional>

class QAction;
class QWidget;

namespace limn {

class CropSection;
struct WindowContext;

/// Shows the crop box in the picture while its action is checked, and while the crop section is used: on
/// while one goes from there to its handles in the view. Where nothing is cropped yet and the body is known
/// the action puts the box around that, and takes it back where nobody has moved it since. Undo of that step
/// puts the box away, too, and redo brings it back.
class CropBoxController : public QObject {
  Q_OBJECT

public:
  CropBoxController(WindowContext& context, const CropSection& section);

  bool isShown() const;
  void setShown(bool isShown);

private:
  // The box as the action has put it around the body.
  struct Begun {
    std::shared_ptr<const Volume> volume;
    CropBox crop;
    std::uint64_t gesture = 0;
    std::optional<UndoStep> step{}; ///< once it is done
    bool isUndone = false;
  };

  void show();
  void begin(bool isShown);
  bool isBegun(const Scene& scene) const; ///< it shows that box
  void followUndo();
  void followFocus(const QWidget* now);

  WindowContext& m_context;
  const CropSection& m_section;
  std::optional<Begun> m_begun;
  UnseenCrop m_unseen;
  QAction* m_action;
  bool m_hidTurned = false; ///< the action, just now
  bool m_isEdited = false;  ///< in its section, or in the view since
};

} // namespace limn
