// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/NumberSliders.h"

#include "widgets/ValueText.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/TrackSlider.h"

#include <QGridLayout>
#include <QHBoxLayout>

#include <algorithm>

namespace limn {
namespace {

// Two handles need room between them. The rows of a panel are as wide as each other, so that one handle has
// as much, but beside a field that is wider than usual.
constexpr int shortestTrack = 48;
constexpr int shortestOfTwo = 100;

// Most fields are as wide as this needs, so that tracks end at one place; more digits or a longer unit get
// more.
const QString usualText = QStringLiteral("888.8\u00a0mm");

// All rows have their columns at the same places.
void setColumns(ResetLabel& label, TrackSlider& track, int shortest) {
  label.setFixedWidth(labelColumn);
  label.setWordWrap(true);
  track.setMinimumWidth(shortest);
}

} // namespace

ValueSlider::ValueSlider(const NumberSpec& spec, QWidget* parent)
    : QWidget(parent), m_spec(spec), m_label(new ResetLabel(spec.label)),
      m_slider(new TrackSlider(spec.scale, 1)),
      m_field(new NumberField(spec.lowest, spec.highest, spec.decimals)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_label);
  layout->addWidget(m_slider, 1);
  layout->addWidget(m_field);
  setColumns(*m_label, *m_slider, shortestTrack);
  m_label->setBuddy(m_field);
  m_field->setFitted(usualText);
  setValue(spec.defaultValue);
  setSpec(spec);
  setUnavailable({});

  connect(m_slider, &TrackSlider::valuesEdited, this,
          [this](const std::vector<double>& values, std::uint64_t id) { edit(values[0], id); });
  connect(m_field, &NumberField::numberEdited, this, [this](double v) { edit(v, nextGestureId()); });
  connect(m_label, &ResetLabel::resetRequested, this, [this] { edit(m_spec.defaultValue, nextGestureId()); });
}

void ValueSlider::setSpec(const NumberSpec& spec) {
  m_spec = spec;
  m_label->setText(spec.label);
  m_field->setUnit(spec.unit, spec.unitOfOne);
  m_field->setOtherUnit(spec.otherUnit.unit, spec.otherUnit.factor);
  m_field->setLimits(spec.lowest, spec.highest, spec.decimals);
  m_slider->setScale(spec.scale);
  m_slider->setDecimals(spec.decimals);
  m_field->setAccessibleName(spec.label);
  m_slider->setAccessibleName(spec.label);
  m_slider->setAccessibleDescription(describedFor(spec));
  m_slider->setReadOut(
      [spec](double value) { return valueText(value, unitBehind(spec, value), spec.decimals); });
  if (isEnabled())
    setToolTip(toolTipOf(spec, false));
}

void ValueSlider::setValue(double value) {
  m_slider->setValues({value});
  m_field->setNumber(value);
}

void ValueSlider::setUnavailable(const QString& reason) {
  setEnabled(reason.isEmpty());
  setToolTip(reason.isEmpty() ? toolTipOf(m_spec, false) : reason);
}

void ValueSlider::edit(double value, std::uint64_t gestureId) {
  m_field->setNumber(value);
  m_slider->setValues({value});
  emit valueEdited(value, {gestureId, changeText(m_spec), false, unitBehind(m_spec, value)});
}

RangeSlider::RangeSlider(const NumberSpec& spec, QWidget* parent)
    : QWidget(parent), m_spec(spec), m_label(new ResetLabel(spec.label)),
      m_slider(new TrackSlider(spec.scale, 2)),
      m_lower(new NumberField(spec.lowest, spec.highest, spec.decimals)),
      m_upper(new NumberField(spec.lowest, spec.highest, spec.decimals)) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(8);
  layout->setVerticalSpacing(4);
  layout->addWidget(m_label, 0, 0, 2, 1);
  layout->addWidget(m_slider, 0, 1, 2, 1);
  layout->addWidget(m_lower, 0, 2);
  layout->addWidget(m_upper, 1, 2);
  layout->setColumnStretch(1, 1);
  setColumns(*m_label, *m_slider, shortestOfTwo);
  for (NumberField* field : {m_lower, m_upper})
    field->setFitted(usualText);
  setRange(spec.defaultValue, spec.defaultUpper);
  setSpec(spec);
  setUnavailable({});

  connect(m_slider, &TrackSlider::valuesEdited, this,
          [this](const std::vector<double>& values, std::uint64_t id) { edit(values[0], values[1], id); });
  connect(m_lower, &NumberField::numberEdited, this,
          [this](double v) { edit(std::min(v, m_upper->number()), m_upper->number(), nextGestureId()); });
  connect(m_upper, &NumberField::numberEdited, this,
          [this](double v) { edit(m_lower->number(), std::max(v, m_lower->number()), nextGestureId()); });
  connect(m_label, &ResetLabel::resetRequested, this,
          [this] { edit(m_spec.defaultValue, m_spec.defaultUpper, nextGestureId()); });
}

void RangeSlider::setSpec(const NumberSpec& spec) {
  m_spec = spec;
  m_label->setText(spec.label);
  m_slider->setScale(spec.scale);
  m_slider->setDecimals(spec.decimals);
  for (NumberField* field : {m_lower, m_upper}) {
    field->setUnit(spec.unit);
    field->setOtherUnit(spec.otherUnit.unit, spec.otherUnit.factor);
    field->setLimits(spec.lowest, spec.highest, spec.decimals);
  }
  m_lower->setAccessibleName(
      tr("%1, %2").arg(spec.label, spec.lowerName.isEmpty() ? tr("from") : spec.lowerName));
  m_upper->setAccessibleName(
      tr("%1, %2").arg(spec.label, spec.upperName.isEmpty() ? tr("to") : spec.upperName));
  m_slider->setAccessibleName(spec.label);
  m_slider->setAccessibleDescription(describedFor(spec));
  m_slider->setReadOut([spec](double value) { return valueText(value, spec.unit, spec.decimals); });
  m_slider->setHandleNames({m_lower->accessibleName(), m_upper->accessibleName()});
  if (isEnabled())
    setToolTip(toolTipOf(spec, true));
  boundEnds();
}

void RangeSlider::setRange(double lower, double upper) {
  m_slider->setValues({lower, upper});
  m_lower->setNumber(lower);
  m_upper->setNumber(upper);
  boundEnds();
}

void RangeSlider::setLeastApart(double apart) {
  m_apart = apart;
  boundEnds();
}

void RangeSlider::boundEnds() {
  const double lower = m_lower->number(), upper = m_upper->number();
  m_lower->setBounds(m_spec.lowest, std::max(lower, upper - m_apart));
  m_upper->setBounds(std::min(upper, lower + m_apart), m_spec.highest);
}

void RangeSlider::setUnavailable(const QString& reason) {
  setEnabled(reason.isEmpty());
  setToolTip(reason.isEmpty() ? toolTipOf(m_spec, true) : reason);
}

void RangeSlider::edit(double lower, double upper, std::uint64_t gestureId) {
  setRange(lower, upper);
  emit rangeEdited(lower, upper, {gestureId, changeText(m_spec), false, m_spec.unit});
}

} // namespace limn
