// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ShadingPanel.h"

#include "widgets/shading/GradientSection.h"
#include "widgets/shading/LightSection.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/shading/QualitySection.h"

#include <QScrollBar>
#include <QVBoxLayout>

namespace limn {

ShadingPanel::ShadingPanel(QWidget* parent)
    : QScrollArea(parent), m_sections{new ModelSection, new GradientSection, new LightSection},
      m_quality(new QualitySection) {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (ShadingSection* section : m_sections) {
    layout->addWidget(section);
    connect(section, &ShadingSection::shadingEdited, this,
            [this](const Shading& shading, const Gesture& gesture) {
              setShading(shading);
              emit shadingEdited(shading, gesture);
            });
  }
  layout->addWidget(m_quality);
  layout->addStretch(1);
  // What is needed most stands open; the rest waits folded.
  m_sections[1]->setFolded(true);
  connect(m_quality, &QualitySection::qualityEdited, this, &ShadingPanel::qualityEdited);
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // Nothing may hide under the scroll bar.
  setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void ShadingPanel::setShading(const Shading& shading) {
  for (ShadingSection* section : m_sections)
    section->setShading(shading);
}

void ShadingPanel::setQuality(const Quality& quality) {
  m_quality->setQuality(quality);
}

void ShadingPanel::setModelsShown(const std::vector<ShadingModel>& models) {
  for (ShadingSection* section : m_sections)
    section->setModelsShown(models);
}

} // namespace limn
