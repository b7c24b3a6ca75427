// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/presets/Suggestion.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>
#include <vector>

namespace limn {

class SuggestionDialog;
struct ValueNames;
struct WindowContext;

/// Proposes bands of the transfer function for the boundaries in what is kept of the open volume, which it
/// looks for beside the event loop: once, until volume, kept region or crop change.
class SuggestionController : public QObject {
  Q_OBJECT

public:
  explicit SuggestionController(WindowContext& context);

signals:
  /// What the picture and the curve are to show for a while; it enters no history. The session's own scene
  /// ends it.
  void previewed(const limn::Scene& scene);

private:
  /// In what boundaries are looked for.
  struct Looked {
    std::shared_ptr<const Volume> volume;
    Region keep;
    CropBox crop;
    bool operator==(const Looked&) const = default;
  };

  /// What is proposed belongs to the scene's volume; what its curve shows already is marked.
  void showScene(const Scene& scene);
  void show();
  void markShown();
  void place();
  void look();
  void lookAnew();
  void receive(const std::vector<Suggestion>& suggestions);
  void preview(const std::optional<std::size_t>& index);
  void accept(std::size_t index);
  ValueNames names() const;

  WindowContext& m_context;
  QPointer<SuggestionDialog> m_dialog;
  Looked m_at; ///< whose boundaries are looked for or known
  std::vector<Suggestion> m_suggestions;
  bool m_isKnown = false;
  QTimer m_soon; ///< runs while what is kept changes: a face of the crop is dragged through many places
  BackgroundWork m_search;
};

} // namespace limn
