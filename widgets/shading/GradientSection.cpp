// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/GradientSection.h"

#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>
#include <QLabel>

namespace limn {
namespace {

enum ReferenceChoice { automatic, largest, percentile, fixed };

// The same order as ReferenceChoice.
GradientReference referenceOf(int choice) {
  switch (choice) {
  case largest:
    return LargestReference{};
  case percentile:
    return PercentileReference{};
  case fixed:
    return FixedReference{};
  default:
    return AutomaticReference{};
  }
}

NumberSpec percentSpec() {
  return {.label = GradientSection::tr("Percentile"),
          .called = GradientSection::tr("Percentile of the full effect"),
          .help = GradientSection::tr("Boundaries stronger than this share of all voxels count as strongest; "
                                      "lower it when metal makes everything else look flat."),
          .unit = QStringLiteral("%"),
          .scale = {90.0, 100.0, false},
          .lowest = 0.1,
          .defaultValue = PercentileReference{}.percent};
}

NumberSpec fixedSpec() {
  return {.label = GradientSection::tr("At a change of"),
          .called = GradientSection::tr("Gradient of the full effect"),
          .help = GradientSection::tr("The change of value per millimetre that counts as the strongest "
                                      "boundary; smaller numbers emphasise weaker boundaries."),
          .unit = GradientSection::tr("per mm"),
          .scale = {0.01, 10000.0, true},
          .lowest = 0.0001,
          .highest = 1e6,
          .defaultValue = FixedReference{}.valuePerMm,
          .decimals = 4};
}

NumberSpec curveSpec() {
  return {
      .label = GradientSection::tr("Strength of it"),
      .called = GradientSection::tr("Strength of the gradient curve"),
      .help = GradientSection::tr(
          "How strongly the curve bends: the exponent of the gamma curve, the base of the logarithmic one."),
      .scale = {0.1, 100.0, true},
      .lowest = 0.01,
      .highest = 1000.0,
      .defaultValue = GradientCurve{}.parameter};
}

NumberSpec significanceSpec() {
  const Significance initial;
  return {.label = GradientSection::tr("Highlights begin at"),
          .called = GradientSection::tr("Boundaries with highlights"),
          .help = GradientSection::tr("Highlights fade in between these shares of the strongest boundary, so "
                                      "that noise in flat tissue does not sparkle."),
          .scale = {0.0, 1.0, false},
          .defaultValue = initial.low,
          .defaultUpper = initial.high,
          .decimals = 3};
}

NumberSpec kneeSpec() {
  return {.label = GradientSection::tr("Soft limit from (k)"),
          .called = GradientSection::tr("Soft limit (k)"),
          .help = GradientSection::tr("The brightness above which colours are held back smoothly; lower "
                                      "numbers keep more hue in highlights."),
          .scale = {0.0, 0.99, false},
          .defaultValue = *Shading{}.knee};
}

} // namespace

GradientSection::GradientSection(QWidget* parent) : ShadingSection(tr("Boundaries"), parent) {
  addReference();
  addCurve();
  addRobustExtras();
  showShading();
}

QString GradientSection::unusedBecause() const {
  return shows({ShadingModel::enhanced, ShadingModel::robust, ShadingModel::physical})
             ? QString()
             : tr("unused: not in this model");
}

void GradientSection::addReference() {
  m_reference =
      new ChoiceRow(tr("Full effect at"),
                    tr("Which boundary counts as the strongest; \"automatic\" is the largest for "
                       "enhanced and the 99.5th percentile for robust and physical."),
                    {tr("Automatic"), tr("Strongest boundary"), tr("Percentile"), tr("Number")}, automatic);
  m_percent = new ValueSlider(percentSpec());
  m_fixed = new ValueSlider(fixedSpec());
  for (QWidget* control : std::initializer_list<QWidget*>{m_reference, m_percent, m_fixed})
    contents()->addWidget(control);
  connect(m_reference, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    edit(&Shading::gradientReference, referenceOf(index), gesture);
  });
  connect(m_percent, &ValueSlider::valueEdited, this, [this](double percent, const Gesture& gesture) {
    edit(&Shading::gradientReference, PercentileReference{percent}, gesture);
  });
  connect(m_fixed, &ValueSlider::valueEdited, this, [this](double valuePerMm, const Gesture& gesture) {
    edit(&Shading::gradientReference, FixedReference{valuePerMm}, gesture);
  });
}

void GradientSection::addCurve() {
  m_curve = new ChoiceRow(
      tr("Weighting"),
      tr("How boundary strength is weighed; gamma below 1 and logarithmic lift weak boundaries."),
      {tr("Linear"), tr("Gamma"), tr("Logarithmic")}, static_cast<int>(GradientCurve::Type::linear));
  m_curveParameter = new ValueSlider(curveSpec());
  contents()->addWidget(m_curve);
  contents()->addWidget(m_curveParameter);
  connect(m_curve, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    const GradientCurve curve{static_cast<GradientCurve::Type>(index), shading().gradientCurve.parameter};
    edit(&Shading::gradientCurve, curve, gesture);
  });
  connect(m_curveParameter, &ValueSlider::valueEdited, this, [this](double value, const Gesture& gesture) {
    edit(&Shading::gradientCurve, GradientCurve{shading().gradientCurve.type, value}, gesture);
  });
}

void GradientSection::addRobustExtras() {
  auto* heading = new QLabel(tr("Highlights and limits"));
  heading->setForegroundRole(QPalette::PlaceholderText);
  contents()->addWidget(heading);
  m_energyHelp = tr("<p>Dims broad highlights so that sharp and broad ones carry the same light.</p><p>On or "
                    "off, default on.</p>");
  m_energy = addSwitch(tr("Dim broad highlights"), m_energyHelp, &Shading::energyFactor);
  m_significanceHelp = tr("<p>Keeps highlights to clear boundaries, so that noise does not sparkle.</p><p>On "
                          "or off, default on.</p>");
  m_significanceOn = new QCheckBox(tr("Highlights only at boundaries"));
  m_significance = new RangeSlider(significanceSpec());
  m_kneeHelp = tr("<p>Holds bright colours back smoothly instead of clipping them to white.</p><p>On or off, "
                  "default on.</p>");
  m_kneeOn = new QCheckBox(tr("Soft limit for brightness"));
  m_knee = new ValueSlider(kneeSpec());
  for (QWidget* control : std::initializer_list<QWidget*>{m_significanceOn, m_significance, m_kneeOn, m_knee})
    contents()->addWidget(control);
  for (QCheckBox* box : {m_significanceOn, m_kneeOn})
    box->setAccessibleName(box->text());
  connect(m_significanceOn, &QAbstractButton::clicked, this, [this](bool on) {
    edit(&Shading::significance, on ? std::optional(Significance{}) : std::nullopt,
         switchGesture(m_significanceOn->text(), on));
  });
  connect(m_significance, &RangeSlider::rangeEdited, this,
          [this](double low, double high, const Gesture& gesture) {
            edit(&Shading::significance, Significance{low, high}, gesture);
          });
  connect(m_kneeOn, &QAbstractButton::clicked, this, [this](bool on) {
    edit(&Shading::knee, on ? Shading{}.knee : std::nullopt, switchGesture(m_kneeOn->text(), on));
  });
  connect(m_knee, &ValueSlider::valueEdited, this,
          [this](double knee, const Gesture& gesture) { edit(&Shading::knee, knee, gesture); });
}

void GradientSection::showReference() {
  const GradientReference& reference = shading().gradientReference;
  m_reference->setIndex(static_cast<int>(reference.index()));
  m_percent->setVisible(reference.index() == percentile);
  m_fixed->setVisible(reference.index() == fixed);
  if (const auto* share = std::get_if<PercentileReference>(&reference))
    m_percent->setValue(share->percent);
  if (const auto* number = std::get_if<FixedReference>(&reference))
    m_fixed->setValue(number->valuePerMm);
}

void GradientSection::showCurve() {
  const GradientCurve& curve = shading().gradientCurve;
  m_curve->setIndex(static_cast<int>(curve.type));
  m_curveParameter->setVisible(curve.type != GradientCurve::Type::linear);
  m_curveParameter->setValue(curve.parameter);
}

void GradientSection::showRobustExtras() {
  const Shading& shown = shading();
  m_energy->setChecked(shown.energyFactor);
  m_significanceOn->setChecked(shown.significance.has_value());
  if (shown.significance)
    m_significance->setRange(shown.significance->low, shown.significance->high);
  m_kneeOn->setChecked(shown.knee.has_value());
  if (shown.knee)
    m_knee->setValue(*shown.knee);

  const QString reason =
      whyUnused({ShadingModel::robust}, tr("Only the robust model does this, and it is not shown."));
  limn::setUnavailable(*m_energy, reason, m_energyHelp);
  limn::setUnavailable(*m_significanceOn, reason, m_significanceHelp);
  const QString off = tr("Switch the line above on first.");
  m_significance->setUnavailable(shown.significance ? reason : off);
  const QString unlimited = whyUnused({ShadingModel::robust, ShadingModel::physical},
                                      tr("Only the robust and physical models do this, and none is shown."));
  limn::setUnavailable(*m_kneeOn, unlimited, m_kneeHelp);
  m_knee->setUnavailable(shown.knee ? unlimited : off);
}

void GradientSection::showShading() {
  const QString reason =
      whyUnused({ShadingModel::enhanced, ShadingModel::robust, ShadingModel::physical},
                tr("Only the enhanced, robust and physical models follow boundaries, and none is shown."));
  for (ChoiceRow* row : {m_reference, m_curve})
    row->setUnavailable(reason);
  for (ValueSlider* slider : {m_percent, m_fixed, m_curveParameter})
    slider->setUnavailable(reason);
  showReference();
  showCurve();
  showRobustExtras();
}

} // namespace limn
