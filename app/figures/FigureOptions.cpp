// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figures/FigureOptions.h"

#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

namespace limn {
namespace {

QString markText(FigureMark mark) {
  switch (mark) {
  case FigureMark::panelLetters:
    return FigureOptions::tr("Letters a, b, …");
  case FigureMark::names:
    return FigureOptions::tr("Names and light");
  case FigureMark::orientation:
    return FigureOptions::tr("Sides of the patient");
  case FigureMark::scaleBar:
    return FigureOptions::tr("Scale bar");
  case FigureMark::curve:
    return FigureOptions::tr("Curve and colours");
  case FigureMark::labels:
    return FigureOptions::tr("Labels and colours");
  case FigureMark::measurements:
    return FigureOptions::tr("Measurements");
  case FigureMark::accuracy:
    return FigureOptions::tr("Accuracy");
  case FigureMark::region:
    return FigureOptions::tr("What is hidden");
  case FigureMark::notForDiagnosis:
    return FigureOptions::tr("“Not for diagnosis”");
  }
  return {};
}

// A row of several fields, whose name leads to the first.
void addRow(QFormLayout& form, const QString& name, QWidget& first, QHBoxLayout* row) {
  row->setSpacing(8);
  auto* label = new QLabel(name);
  label->setBuddy(&first);
  form.addRow(label, row);
}

int decimalsOf(FigureSettings::Unit unit) {
  return unit == FigureSettings::Unit::pixels ? 0 : 2;
}

} // namespace

FigureOptions::FigureOptions(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(6);
  addSize(*form);
  m_page = new QuietComboBox(this);
  m_page->setObjectName(QStringLiteral("figurePage"));
  m_page->addItems({tr("White"), tr("Black"), tr("Transparent, pictures too")});
  connect(m_page, &QComboBox::activated, this, [this](int index) {
    FigureSettings settings = m_settings;
    settings.page = figurePages[static_cast<std::size_t>(index)];
    change(settings);
  });
  form->addRow(tr("P&age"), m_page);
  addMarks(*form);
  show();
}

NumberField* FigureOptions::field(const QString& name, const QString& what, const Limits& limits) {
  auto* field = new NumberField(limits.lowest, limits.highest, limits.decimals, this);
  field->setObjectName(name);
  field->setAccessibleName(what);
  return field;
}

void FigureOptions::addSize(QFormLayout& form) {
  auto* width = new QHBoxLayout;
  m_width = field(QStringLiteral("figureWidth"), tr("Width"), {0.1, mostFigurePixels, 2});
  m_unit = new QuietComboBox(this);
  m_unit->setObjectName(QStringLiteral("figureUnit"));
  m_unit->setAccessibleName(tr("Unit of the size"));
  m_unit->addItems({tr("pixels"), tr("cm")});
  width->addWidget(m_width, 1);
  width->addWidget(m_unit);
  addRow(form, tr("&Width"), *m_width, width);
  auto* height = new QHBoxLayout;
  m_height = field(QStringLiteral("figureHeight"), tr("Height"), {0.1, mostFigurePixels, 2});
  m_hasHeight = new QCheckBox(tr("fixed"), this);
  m_hasHeight->setObjectName(QStringLiteral("figureHasHeight"));
  m_hasHeight->setAccessibleName(tr("A fixed height"));
  m_hasHeight->setToolTip(tr("Without a fixed height, the figure is as high as its pictures ask."));
  height->addWidget(m_height, 1);
  height->addWidget(m_hasHeight);
  addRow(form, tr("&Height"), *m_height, height);
  m_dots = field(QStringLiteral("figureDots"), tr("Resolution"), {fewestDotsPerInch, mostDotsPerInch, 0});
  m_dots->setSuffix(tr(" dpi"));
  form.addRow(tr("&Resolution"), m_dots);
  m_text = field(QStringLiteral("figureText"), tr("Height of the text"), {2.0, 72.0, 1});
  m_text->setSuffix(tr(" pt"));
  form.addRow(tr("&Text"), m_text);
  const auto edit = [this](NumberField* one, auto set) {
    connect(one, &NumberField::numberEdited, this, [this, set](double number) {
      FigureSettings settings = m_settings;
      set(settings, number);
      change(settings);
    });
  };
  edit(m_width, [](FigureSettings& settings, double number) { settings.width = number; });
  edit(m_height, [](FigureSettings& settings, double number) { settings.height = number; });
  edit(m_dots, [](FigureSettings& settings, double number) { settings.dotsPerInch = number; });
  edit(m_text, [](FigureSettings& settings, double number) { settings.textPoints = number; });
  connect(m_unit, &QComboBox::activated, this,
          [this](int index) { changeUnit(figureUnits[static_cast<std::size_t>(index)]); });
  connect(m_hasHeight, &QCheckBox::clicked, this, [this](bool hasHeight) {
    FigureSettings settings = m_settings;
    settings.height = hasHeight ? std::optional(m_usualHeight) : std::nullopt;
    change(settings);
  });
}

void FigureOptions::addMarks(QFormLayout& form) {
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(4);
  for (std::size_t i = 0; i < figureMarks.size(); ++i) {
    auto* box = m_marks[i] = new QCheckBox(markText(figureMarks[i]), this);
    box->setObjectName(QStringLiteral("figureMark-") + QLatin1String(nameOf(figureMarks[i])));
    connect(box, &QCheckBox::clicked, this, [this, i](bool isShown) {
      FigureSettings settings = m_settings;
      settings.marks[i] = isShown;
      change(settings);
    });
    grid->addWidget(box, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
  }
  form.addRow(grid);
}

// The size stays what it is.
void FigureOptions::changeUnit(FigureSettings::Unit unit) {
  if (unit == m_settings.unit)
    return;
  FigureSettings settings = m_settings;
  settings.unit = unit;
  const auto converted = [&](double length) {
    const double pixels = toPixels(m_settings, length);
    return unit == FigureSettings::Unit::pixels
               ? std::round(pixels)
               : length / toPixels(settings, 1.0) * toPixels(m_settings, 1.0);
  };
  settings.width = converted(m_settings.width);
  if (m_settings.height)
    settings.height = converted(*m_settings.height);
  change(settings);
}

void FigureOptions::setSettings(const FigureSettings& settings) {
  m_settings = settings;
  show();
}

void FigureOptions::setUsualHeight(double height) {
  m_usualHeight = height;
  if (!m_settings.height)
    m_height->setNumber(height);
}

void FigureOptions::change(const FigureSettings& settings) {
  m_settings = settings;
  show();
  emit edited(settings);
}

void FigureOptions::show() {
  const int decimals = decimalsOf(m_settings.unit);
  for (NumberField* length : {m_width, m_height})
    length->setLimits(decimals == 0 ? fewestFigurePixels : 0.5, mostFigurePixels, decimals);
  m_width->setNumber(m_settings.width);
  m_height->setNumber(m_settings.height.value_or(m_usualHeight));
  m_height->setEnabled(m_settings.height.has_value());
  m_hasHeight->setChecked(m_settings.height.has_value());
  m_dots->setNumber(m_settings.dotsPerInch);
  m_text->setNumber(m_settings.textPoints);
  m_unit->setCurrentIndex(static_cast<int>(m_settings.unit));
  m_page->setCurrentIndex(static_cast<int>(m_settings.page));
  for (std::size_t i = 0; i < m_marks.size(); ++i)
    m_marks[i]->setChecked(m_settings.marks[i]);
}

} // namespace limn
