// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/sliders/ValueSlider.h"

#include "widgets/ValueText.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/ResetLabel.h"
#include "widgets/controls/sliders/TrackSlider.h"

#include <QHBoxLayout>

namespace limn {
namespace {

constexpr int shortestTrack = 48;

// One width in all panels, unless many digits and a long unit need more.
int fieldWidth(const NumberSpec& spec) {
  return spec.unit.size() > 2 && spec.decimals > 3 ? 120 : 92;
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
  m_label->setFixedWidth(labelColumn);
  m_label->setWordWrap(true);
  m_slider->setMinimumWidth(shortestTrack);

  m_label->setBuddy(m_field);
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
  m_field->setFixedWidth(fieldWidth(spec));
  m_field->setSuffix(spec.unit.isEmpty() ? QString() : QChar(0x00a0) + spec.unit);
  m_field->setLimits(spec.lowest, spec.highest, spec.decimals);
  m_slider->setScale(spec.scale);
  m_slider->setDecimals(spec.decimals);
  m_field->setAccessibleName(spec.label);
  m_slider->setAccessibleName(spec.label);
  m_slider->setAccessibleDescription(describedFor(spec));
  m_slider->setReadOut([spec](double value) { return valueText(value, spec.unit, spec.decimals); });
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
  emit valueEdited(value, {gestureId, changeText(m_spec.label)});
}

} // namespace limn
