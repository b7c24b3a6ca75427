// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"

#include <QScrollArea>

namespace limn {

class QualitySection;
class ShadingSection;

/// The numbers of light and quality in folding sections. Controls that change nothing in the pictures shown
/// are disabled and say why in their tool tips.
class ShadingPanel : public QScrollArea {
  Q_OBJECT

public:
  explicit ShadingPanel(QWidget* parent = nullptr);

  void setShading(const Shading& shading);
  void setQuality(const Quality& quality);

  /// The models in the pictures on screen: one, or the two that are compared.
  void setModelsShown(const std::vector<ShadingModel>& models);

  const std::vector<ShadingSection*>& sections() const { return m_sections; }
  QualitySection* qualitySection() const { return m_quality; }

  QSize sizeHint() const override { return {320, 600}; }

signals:
  void shadingEdited(const limn::Shading& shading, const limn::Gesture& gesture);
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);

private:
  std::vector<ShadingSection*> m_sections;
  QualitySection* m_quality;
};

} // namespace limn
