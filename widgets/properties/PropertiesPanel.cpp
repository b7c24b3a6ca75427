// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/PropertiesPanel.h"

#include "widgets/controls/NumberSliders.h"
#include "widgets/properties/CropSection.h"
#include "widgets/properties/CutSection.h"
#include "widgets/properties/FogSection.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/properties/MeasureSection.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/shading/GradientSection.h"
#include "widgets/shading/LightSection.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/shading/PhysicalSection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

namespace limn {
namespace {

NumberSpec stepSpec() {
  return {.label = QualitySection::tr("Step"),
          .called = QualitySection::tr("Step between samples"),
          .help = QualitySection::tr("The distance between samples along a ray, in voxels: smaller is closer "
                                     "to exact, larger is faster."),
          .unit = QualitySection::tr("voxels"),
          .unitOfOne = QualitySection::tr("voxel"),
          .scale = {0.05, 4.0, true},
          .lowest = 0.01,
          .highest = 16.0,
          .defaultValue = Quality{}.stepVoxels,
          .decimals = 3};
}

NumberSpec terminationSpec() {
  return {.label = QualitySection::tr("Stop when opaque to"),
          .called = QualitySection::tr("Opacity at which rays stop"),
          .help = QualitySection::tr("A ray stops where so much light is already blocked: lower is faster "
                                     "but loses a little light, 1 never stops early."),
          .scale = {0.9, 1.0, false},
          .lowest = 0.01,
          .defaultValue = Quality{}.earlyTermination,
          .decimals = 4};
}

} // namespace

QualitySection::QualitySection(QWidget* parent)
    : FoldingSection(tr("Quality"), parent),
      m_step(addNumber(new ValueSlider(stepSpec()), &Quality::stepVoxels)),
      m_termination(addNumber(new ValueSlider(terminationSpec()), &Quality::earlyTermination)) {
  addPreintegration();
  addJitter();
  setQuality(m_quality);
}

void QualitySection::setQuality(const Quality& quality) {
  m_quality = quality;
  m_step->setValue(quality.stepVoxels);
  m_termination->setValue(quality.earlyTermination);
  m_preintegration->setIndex(static_cast<int>(quality.preintegrated));
  m_jitter->setChecked(quality.jitter);
}

void QualitySection::addPreintegration() {
  m_preintegration = new ChoiceRow(
      tr("Curve between samples"),
      tr("Whether the curve is averaged from one sample to the next (pre-integration), so that narrow peaks "
         "are not stepped over; automatic does so where the step is too large for the curve."),
      {tr("Automatic"), tr("Always averaged"), tr("Never averaged")},
      static_cast<int>(Preintegration::automatic));
  contents()->addWidget(m_preintegration);
  connect(m_preintegration, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    m_quality.preintegrated = static_cast<Preintegration>(index);
    emit qualityEdited(m_quality, gesture);
  });
}

void QualitySection::addJitter() {
  m_jitter = new QCheckBox(tr("Shift the samples (jitter)"));
  m_jitter->setAccessibleName(m_jitter->text());
  m_jitter->setToolTip(tr("<p>Shifts each pixel's samples by a fixed random part of a step: rings from a "
                          "large step turn into fine grain.</p><p>On or off, default off.</p>"));
  contents()->addWidget(m_jitter);
  connect(m_jitter, &QAbstractButton::clicked, this, [this](bool on) {
    m_quality.jitter = on;
    emit qualityEdited(m_quality, switchGesture(m_jitter->text(), on));
  });
}

ValueSlider* QualitySection::addNumber(ValueSlider* slider, double Quality::*member) {
  contents()->addWidget(slider);
  connect(slider, &ValueSlider::valueEdited, this, [this, member](double value, const Gesture& gesture) {
    m_quality.*member = value;
    emit qualityEdited(m_quality, gesture);
  });
  return slider;
}

PropertiesPanel::PropertiesPanel(QWidget* parent)
    : SectionPanel(parent), m_projection(new ProjectionSection), m_model(new ModelSection),
      m_light(new LightSection), m_physical(new PhysicalSection),
      m_sections({m_model, new GradientSection, m_light, m_physical}), m_use(m_sections.size()),
      m_crop(new CropSection), m_cuts(new CutSection), m_labels(new LabelSection),
      m_measures(new MeasureSection), m_fog(new FogSection), m_quality(new QualitySection) {
  stack({m_projection, m_sections[0], m_sections[1], m_sections[2], m_sections[3], m_crop, m_cuts, m_labels,
         m_measures, m_fog, m_quality});
  // What is needed most stands open; the rest waits folded.
  m_sections[1]->setFolded(true);
  foldUnused();
  connectSections();
}

void PropertiesPanel::connectSections() {
  for (ShadingSection* section : m_sections)
    connect(section, &ShadingSection::shadingEdited, this,
            [this](const Shading& shading, const Gesture& gesture) {
              m_scene.shading = shading;
              setShading(shading);
              emit shadingEdited(shading, gesture);
            });
  connect(m_light, &LightSection::presetChosen, this, &PropertiesPanel::lightChosen);
  connect(m_model, &ModelSection::sideModelChosen, this, &PropertiesPanel::modelChosen);
  connect(m_quality, &QualitySection::qualityEdited, this, &PropertiesPanel::qualityEdited);
  connect(m_projection, &ProjectionSection::projectionEdited, this, &PropertiesPanel::projectionEdited);
  connect(m_projection, &ProjectionSection::isovalueEdited, this, &PropertiesPanel::isovalueEdited);
  connect(m_crop, &CropSection::cropEdited, this, &PropertiesPanel::cropEdited);
  // It lies below what is always there; once the scene has come to all sections.
  connect(
      m_labels, &LabelSection::opened, this, [this] { scrollTo(*m_labels); }, Qt::QueuedConnection);
  connect(
      m_measures, &MeasureSection::begun, this, [this] { ensureWidgetVisible(m_measures); },
      Qt::QueuedConnection);
  connect(m_fog, &FogSection::fogEdited, this, &PropertiesPanel::fogEdited);
}

void PropertiesPanel::showSavedPaths() {
  m_physical->setFolded(false);
  scrollTo(*m_physical->until());
  m_physical->until()->box()->setFocus(Qt::OtherFocusReason);
}

void PropertiesPanel::setScene(const Scene& scene) {
  const bool otherProjection = scene.projection != m_scene.projection;
  if (!m_scene.volume || !scene.volume || !m_scene.volume->sharesVoxelsWith(*scene.volume))
    m_light->forgetHeadlight();
  m_scene = scene;
  widget()->setEnabled(scene.volume != nullptr); // of nothing there is nothing to set
  m_light->setCamera(scene.camera);
  setShading(scene.shading);
  setQuality(scene.quality);
  m_projection->setScene(scene);
  m_crop->setScene(scene);
  m_cuts->setScene(scene);
  m_labels->setScene(scene);
  m_fog->setScene(scene);
  if (otherProjection)
    showModels();
}

void PropertiesPanel::setShading(const Shading& shading) {
  for (ShadingSection* section : m_sections)
    section->setShading(shading);
}

void PropertiesPanel::setQuality(const Quality& quality) {
  m_quality->setQuality(quality);
}

void PropertiesPanel::setModelsShown(const std::vector<ShadingModel>& models, const QString& keptLook) {
  const auto edited = keptLook.isEmpty() ? models.begin() : models.end() - 1;
  m_models.assign(edited, models.end());
  m_kept.assign(models.begin(), edited);
  m_model->setChosenModels(models, keptLook);
  showModels();
}

void PropertiesPanel::showModels() {
  const bool lit = usesLight(m_scene.projection);
  for (std::size_t i = 0; i < m_sections.size(); ++i) {
    ShadingSection* section = m_sections[i];
    section->setModelsShown(lit ? m_models : std::vector(m_models.size(), ShadingModel::none), m_kept);
    setUnused(i, lit ? section->unusedBecause() : tr("unused: this projection is unlit"));
  }
}

// What comes to be unused folds, once; what folded so comes back when it is used again.
void PropertiesPanel::setUnused(std::size_t section, const QString& reason) {
  FoldingSection* folding = m_sections[section];
  Use& use = m_use[section];
  folding->setSummary(reason);
  if (use.isUnused == !reason.isEmpty())
    return;
  use.isUnused = !reason.isEmpty();
  if (use.isUnused) {
    use.foldedForNow = !folding->isFolded();
    folding->setFolded(true);
  } else if (use.foldedForNow) {
    folding->setFolded(false);
  }
}

void PropertiesPanel::foldUnused() {
  m_crop->setFolded(m_scene.crop == CropBox{});
  m_cuts->setFolded(m_scene.keep.cuts.empty());
  m_labels->setFolded(m_scene.keep.kind != Region::Kind::labels);
  m_measures->setFolded(!m_measures->hasRows());
  m_fog->setFolded(m_scene.fog.mode == Fog::Mode::none);
}

} // namespace limn
