// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/LightPresets.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

class QCheckBox;

namespace limn {

class ChoiceRow;
class CropSection;
class CutSection;
class FogSection;
class LabelSection;
class LightSection;
class MeasureSection;
class ModelSection;
class PhysicalSection;
class ProjectionSection;
class ShadingSection;
class ValueSlider;

/// Closer to exact or faster: the sampling step, where a ray may stop, and two ways to hide the steps.
class QualitySection : public FoldingSection {
  Q_OBJECT

public:
  explicit QualitySection(QWidget* parent = nullptr);

  void setQuality(const Quality& quality);

signals:
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);

private:
  ValueSlider* addNumber(ValueSlider* slider, double Quality::*member);
  void addPreintegration();
  void addJitter();

  Quality m_quality;
  ValueSlider* m_step;
  ValueSlider* m_termination;
  ChoiceRow* m_preintegration = nullptr;
  QCheckBox* m_jitter = nullptr;
};

/// What a scene says beside its curves, in folding sections: projection, light, crop, labels, fog, quality;
/// and what was measured.
/// Controls that change nothing in the pictures shown are disabled and say why in their tool tips; a section
/// that the scene does not use says so in its header.
class PropertiesPanel : public SectionPanel {
  Q_OBJECT

public:
  explicit PropertiesPanel(QWidget* parent = nullptr);

  void setScene(const Scene& scene);
  void setShading(const Shading& shading);
  void setQuality(const Quality& quality);

  /// Folds what the scene does not use and opens what it does: for a scene freshly opened.
  void foldUnused();

  /// The models in the pictures on screen: one, or the two that are compared. `keptLook` is called the look
  /// at the left that keeps its own light, so that nothing here edits it; empty: none does.
  void setModelsShown(const std::vector<ShadingModel>& models, const QString& keptLook = {});

  /// Scrolls to how far saved pictures of physical light are drawn, which gets the keyboard.
  void showSavedPaths();

  CropSection* cropSection() const { return m_crop; }
  CutSection* cutSection() const { return m_cuts; }
  LabelSection* labelSection() const { return m_labels; }
  MeasureSection* measureSection() const { return m_measures; }

  QSize sizeHint() const override { return {320, 600}; }

signals:
  void shadingEdited(const limn::Shading& shading, const limn::Gesture& gesture);
  /// Another model for a side of a comparison, 0 left, 1 right.
  void modelChosen(int side, limn::ShadingModel model);
  /// A whole light in one go, after its edit.
  void lightChosen(limn::LightPreset light);
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);
  void projectionEdited(limn::Projection projection, const limn::Gesture& gesture);
  void isovalueEdited(double isovalue, const limn::Gesture& gesture);
  void cropEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  void fogEdited(const limn::Fog& fog, const limn::Gesture& gesture);

private:
  void connectSections();
  void showModels();
  void setUnused(std::size_t section, const QString& reason);

  Scene m_scene;
  std::vector<ShadingModel> m_models{ShadingModel::classic}; ///< lit by the scene
  std::vector<ShadingModel> m_kept;                          ///< of the look at the left
  ProjectionSection* m_projection;
  ModelSection* m_model;
  LightSection* m_light;
  PhysicalSection* m_physical;
  std::vector<ShadingSection*> m_sections; ///< the model's first
  /// Of a section of light.
  struct Use {
    bool isUnused = false;
    bool foldedForNow = false; ///< because it came to be unused while it was open
  };
  std::vector<Use> m_use;
  CropSection* m_crop;
  CutSection* m_cuts;
  LabelSection* m_labels;
  MeasureSection* m_measures;
  FogSection* m_fog;
  QualitySection* m_quality;
};

} // namespace limn
