// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/saving/AwaitedPicture.h"

#include <QObject>

class QLabel;
class QStatusBar;
class QToolButton;

namespace limn {

class CompareView;
class Settings;

/// Asks where a view's picture is to be saved and waits until it is complete; meanwhile a row of the status
/// bar says so and offers to cancel.
class PictureSaving : public QObject {
  Q_OBJECT

public:
  /// The row stands in `status`, where it takes nothing from the picture: that would begin anew in another
  /// size.
  PictureSaving(CompareView& view, Settings& settings, QStatusBar& status, QObject* parent);

  /// Asks for a path; `suggested` is a name without ending.
  void ask(const QString& suggested);

  /// Looks whether an awaited picture is complete, once the event loop is back: the view may be drawing.
  void lookSoon();

signals:
  /// The picture at rest is the one that was asked for.
  void complete(const QString& path);
  void failed(const QString& sentence);

private:
  void look();
  void forget();
  PictureContent content() const;

  CompareView& m_view;
  Settings& m_settings;
  AwaitedPicture m_awaited;
  QLabel* m_text;
  QToolButton* m_stop;
};

} // namespace limn
