// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/FigureSettings.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace limn {

class NumberField;

/// Size, page and marks of a figure.
class FigureOptions : public QWidget {
  Q_OBJECT

public:
  explicit FigureOptions(QWidget* parent = nullptr);

  void setSettings(const FigureSettings& settings);
  const FigureSettings& settings() const { return m_settings; }

  /// What the height would be that follows from the pictures, in the settings' unit: where a person begins
  /// who wants another one.
  void setUsualHeight(double height);

signals:
  void edited(const limn::FigureSettings& settings);

private:
  struct Limits {
    double lowest, highest;
    int decimals;
  };

  void addSize(QFormLayout& form);
  void addMarks(QFormLayout& form);
  NumberField* field(const QString& name, const QString& what, const Limits& limits);
  void change(const FigureSettings& settings);
  void changeUnit(FigureSettings::Unit unit);
  void show();

  FigureSettings m_settings;
  double m_usualHeight = 10.0;
  NumberField* m_width = nullptr;
  NumberField* m_height = nullptr;
  NumberField* m_dots = nullptr;
  NumberField* m_text = nullptr;
  QCheckBox* m_hasHeight = nullptr;
  QComboBox* m_unit = nullptr;
  QComboBox* m_page = nullptr;
  std::array<QCheckBox*, figureMarks.size()> m_marks{};
};

} // namespace limn
