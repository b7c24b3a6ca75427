// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/CompareLayout.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QToolButton;

namespace limn {

/// What a picture shows, from left to right.
struct PictureContent {
  std::vector<Scene> scenes;
  CompareLayout layout = CompareLayout::single;
  bool operator==(const PictureContent&) const = default;
};

/// A picture that is saved once it is complete, if it is still the one that was asked for.
class AwaitedPicture {
public:
  void await(const QString& path, const PictureContent& asked) {
    m_path = path;
    m_asked = asked;
  }
  void forget() { m_path.clear(); }

  /// Where it is to be saved; empty while none is awaited.
  const QString& path() const { return m_path; }

  enum class Outcome { waits, complete, changed };

  /// What has become of it, while one is awaited; it is forgotten unless it waits on. `isComplete` is asked
  /// only of the picture that was asked for.
  Outcome look(const PictureContent& now, const std::function<bool()>& isComplete) {
    const Outcome outcome = now != m_asked ? Outcome::changed
                            : isComplete() ? Outcome::complete
                                           : Outcome::waits;
    if (outcome != Outcome::waits)
      forget();
    return outcome;
  }

private:
  QString m_path;
  PictureContent m_asked;
};

struct WindowContext;

/// Asks where a view's picture is to be saved and waits until it is complete; meanwhile a row of the status
/// bar says so and offers to cancel.
class PictureSaving : public QObject {
  Q_OBJECT

public:
  /// The row stands in the status bar, where it takes nothing from the picture: that would begin anew in
  /// another size.
  explicit PictureSaving(WindowContext& context);

signals:
  /// The picture at rest is the one that was asked for.
  void complete(const QString& path);

private:
  void ask();
  void look();
  void forget();
  PictureContent content() const;

  WindowContext& m_context;
  AwaitedPicture m_awaited;
  QLabel* m_text;
  QToolButton* m_stop;
};

} // namespace limn
