// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>

#include <vector>

class QWidget;

namespace limn {

class EmptyPanel;
class LoadingPanel;
class MessagePanel;
class ReferencePanel;

/// What covers the pictures of a view where there is nothing to show, where drawing failed, where the
/// processor draws, and while something loads.
class PanelStack : public QObject {
  Q_OBJECT

public:
  explicit PanelStack(QWidget* view);

  /// Lays everything over the view as it is now and shows what applies: `sentence` says why nothing is drawn
  /// and is empty where it is; `onProcessor`: pictures of the processor stand in, once there are some.
  void arrange(bool hasVolume, const QString& sentence, bool onProcessor);

  /// `fraction` 0..1, or less than 0 where it is unknown.
  void setLoading(double fraction, const QString& text);
  void clearLoading();

  /// Why the processor draws, and what the driver wrote; no pictures are there yet.
  void setReason(const QString& sentence, const QString& details);
  void setPictures(const std::vector<QImage>& pictures);

signals:
  void openFolderRequested();
  void openFileRequested();
  void sampleRequested();
  void loadingCancelled();
  void retryRequested();       ///< after a failure of any kind
  void driverRetryRequested(); ///< while the processor draws

private:
  QWidget* m_view;
  EmptyPanel* m_empty;
  MessagePanel* m_message;
  LoadingPanel* m_loading;
  ReferencePanel* m_reference;
};

} // namespace limn
