// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"

#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QStandardItemModel;
class QToolButton;
class QTreeView;

namespace limn {

/// The presets as a searchable list, grouped: the user's own, then the built-in ones by modality. A click or
/// Enter chooses; names are unique over both lists. It saves and deletes nothing itself.
class PresetBrowser : public QWidget {
  Q_OBJECT

public:
  explicit PresetBrowser(QWidget* parent = nullptr);

  void setPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own);

  /// Marks a preset by name, without choosing it, as the one in use; an unknown or empty name marks none. A
  /// choice by the user marks nothing by itself: its receiver answers with this where the preset took effect,
  /// and with an empty name where an edit left it.
  void setCurrent(const QString& name);

  /// Puts the keyboard into the search field.
  void focusSearch();

  QSize sizeHint() const override { return {232, 480}; }

signals:
  void presetChosen(const QString& name);
  void saveRequested();
  /// Only for the user's own presets.
  void deleteRequested(const QString& name);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void makeList();
  QWidget* makeButtons();
  void refill();
  void search(const QString& text);
  void mark(const QString& name);
  void choose(const QModelIndex& index);
  QString ownPresetInHand() const;
  void showButtons();
  bool handleSearchKey(int key);

  std::vector<Preset> m_builtIn;
  std::vector<Preset> m_own;
  QString m_current; ///< the preset in use
  QLineEdit* m_search;
  QTreeView* m_list;
  QLabel* m_nothing;
  QPushButton* m_save;
  QToolButton* m_delete;
  QAction* m_searchIcon;
  QStandardItemModel* m_model;
  QSortFilterProxyModel* m_filtered;
};

} // namespace limn
