// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ModelSection.h"

#include "scene/light/Shading.h"
#include "widgets/controls/NumberSliders.h"

#include <QLabel>
#include <QObject>
#include <QPushButton>

namespace limn {
namespace {

QStringList modelNames() {
  QStringList names;
  for (const ShadingModel model : shadingModels)
    names << modelName(model);
  return names;
}

ChoiceRow* modelRow(const QString& label, ShadingModel initial) {
  return new ChoiceRow(
      label,
      ModelSection::tr(
          "How tissue is lit: not at all, evenly, with boundaries emphasised, or "
          "the same without overflowing highlights; or by light that goes random ways through it."),
      modelNames(), static_cast<int>(initial));
}

NumberSpec exponentSpec() {
  return {.label = ModelSection::tr("Highlight sharpness (SP)"),
          .help = ModelSection::tr(
              "Small numbers give broad, soft highlights; large ones small, hard points of light."),
          .scale = {1.0, 1024.0, true},
          .lowest = 0.1,
          .defaultValue = Shading{}.exponent,
          .decimals = 1};
}

NumberSpec exponentRangeSpec() {
  const CoefficientRange initial = Shading{}.exponentRange;
  return {.label = ModelSection::tr("Highlight sharpness (SP)"),
          .help = ModelSection::tr("Highlights go from the first sharpness on flat tissue to the second at "
                                   "strong boundaries, so that edges glint and flat parts stay calm."),
          .scale = {1.0, 1024.0, true},
          .lowest = 0.1,
          .defaultValue = initial.atFlat,
          .defaultUpper = initial.atBoundary,
          .decimals = 1,
          .lowerName = ModelSection::tr("on flat tissue"),
          .upperName = ModelSection::tr("at boundaries")};
}

NumberSpec opacityRangeSpec() {
  const CoefficientRange initial = Shading{}.opacityRange;
  return {.label = ModelSection::tr("Boundary emphasis (O)"),
          .help = ModelSection::tr("Multiplies opacity: by the first number on flat tissue, which below 1 "
                                   "fades, and by the second at strong boundaries, which above 1 stand out."),
          .scale = {0.0, 8.0, false},
          .defaultValue = initial.atFlat,
          .defaultUpper = initial.atBoundary,
          .lowerName = ModelSection::tr("on flat tissue"),
          .upperName = ModelSection::tr("at boundaries")};
}

// The numbers of the paper's formulas, which presets replace by those that show their tissue best.
Shading asInThePaper(Shading shading) {
  const Shading literal;
  shading.exponentRange = literal.exponentRange;
  shading.opacityRange = literal.opacityRange;
  shading.gradientReference = literal.gradientReference;
  shading.gradientCurve = literal.gradientCurve;
  return shading;
}

} // namespace

ModelSection::ModelSection(QWidget* parent) : ShadingSection(tr("Shading"), parent) {
  m_model = addChoice(modelRow(tr("Model"), ShadingModel::classic), &Shading::model);
  m_sides = {modelRow(tr("Model, left"), ShadingModel::classic),
             modelRow(tr("Model, right"), ShadingModel::enhanced)};
  for (int side = 0; side < 2; ++side) {
    ChoiceRow* row = m_sides[static_cast<std::size_t>(side)];
    contents()->addWidget(row);
    connect(row, &ChoiceRow::indexEdited, this,
            [this, side](int index) { emit sideModelChosen(side, static_cast<ShadingModel>(index)); });
  }
  m_kept = new QLabel;
  m_kept->setObjectName(QStringLiteral("keptLook"));
  m_kept->setWordWrap(true);
  m_kept->setTextFormat(Qt::PlainText);
  m_kept->hide();
  contents()->addWidget(m_kept);
  m_classicHeading = new QLabel(modelName(ShadingModel::classic));
  m_rangesHeading = new QLabel;
  for (QLabel* heading : {m_classicHeading, m_rangesHeading})
    heading->setForegroundRole(QPalette::PlaceholderText);
  contents()->addWidget(m_classicHeading);
  m_exponent = addNumber(exponentSpec(), &Shading::exponent);
  contents()->addWidget(m_rangesHeading);
  m_exponentRange = addRange(exponentRangeSpec(), &Shading::exponentRange);
  m_opacityRange = addRange(opacityRangeSpec(), &Shading::opacityRange);
  m_literal = new QPushButton(tr("As in the paper"));
  m_literal->setObjectName(QStringLiteral("asInThePaper"));
  m_literal->setAccessibleName(m_literal->text());
  contents()->addWidget(m_literal, 0, Qt::AlignLeft);
  connect(m_literal, &QPushButton::clicked, this, [this] {
    setShading(asInThePaper(shading()));
    emit shadingEdited(shading(), {nextGestureId(), tr("enhanced as in the paper"), true});
  });
  showShading();
}

void ModelSection::setChosenModels(const std::vector<ShadingModel>& models, const QString& keptLook) {
  m_chosen = models;
  m_kept->setText(tr("\"%1\" at the left stays as it is; curve and light shape the right side, and "
                     "Preset ▸ Swap the sides exchanges both.")
                      .arg(keptLook));
  m_kept->setVisible(!keptLook.isEmpty());
  showShading();
}

void ModelSection::showShading() {
  const bool isComparison = m_chosen.size() > 1;
  m_model->setVisible(!isComparison);
  m_model->setIndex(static_cast<int>(shading().model));
  for (std::size_t side = 0; side < m_sides.size(); ++side) {
    m_sides[side]->setVisible(isComparison);
    if (isComparison)
      m_sides[side]->setIndex(static_cast<int>(m_chosen[side]));
  }
  m_exponent->setValue(shading().exponent);
  m_exponentRange->setRange(shading().exponentRange.atFlat, shading().exponentRange.atBoundary);
  m_opacityRange->setRange(shading().opacityRange.atFlat, shading().opacityRange.atBoundary);

  m_exponent->setUnavailable(
      whyUnused({ShadingModel::classic},
                tr("Only the classic model has one sharpness everywhere, and it is not shown.")));
  m_classicHeading->setEnabled(shows({ShadingModel::classic}));
  const QString noRange =
      whyUnused({ShadingModel::enhanced, ShadingModel::robust},
                tr("Only the enhanced and robust models follow boundaries, and none is shown."));
  const QString noExponent = noRange.isEmpty() ? QString() : noExponentRange();
  m_rangesHeading->setText(shows({ShadingModel::physical}) ? tr("Enhanced, robust and physical")
                                                           : tr("Enhanced and robust"));
  m_rangesHeading->setEnabled(noExponent.isEmpty());
  m_exponentRange->setUnavailable(noExponent);
  m_opacityRange->setUnavailable(noRange);
  const bool isLiteral = shading() == asInThePaper(shading());
  m_literal->setEnabled(noRange.isEmpty() && !isLiteral);
  m_literal->setToolTip(!noRange.isEmpty() ? noRange
                        : isLiteral        ? tr("The numbers are those of the paper.")
                                    : tr("Sharpness, emphasis and boundaries by the paper's formulas alone: "
                                         "presets have numbers that show their own tissue better."));
}

// Where neither enhanced nor robust shows, the highlights of physical surfaces alone have that range.
QString ModelSection::noExponentRange() const {
  const QString unused =
      whyUnused({ShadingModel::enhanced, ShadingModel::robust, ShadingModel::physical},
                tr("Only the enhanced, robust and physical models have such highlights, and none is shown."));
  if (!unused.isEmpty())
    return unused;
  const PhysicalLight& light = shading().physical;
  return light.surface > 0.0 && light.specularShare > 0.0
             ? QString()
             : tr("Physical light has highlights on surfaces with gloss alone, and there are none.");
}

QString modelName(ShadingModel model) {
  switch (model) {
  case ShadingModel::none:
    return QObject::tr("Unlit");
  case ShadingModel::classic:
    return QObject::tr("Classic");
  case ShadingModel::enhanced:
    return QObject::tr("Enhanced");
  case ShadingModel::robust:
    return QObject::tr("Robust");
  case ShadingModel::physical:
    return QObject::tr("Physical");
  }
  return {};
}

} // namespace limn
