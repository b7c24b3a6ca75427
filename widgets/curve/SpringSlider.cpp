// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/SpringSlider.h"

#include "widgets/controls/TrackSlider.h"

#include <QHBoxLayout>
#include <QTextDocumentFragment>

#include <algorithm>
#include <utility>

namespace limn {

SpringSlider::SpringSlider(const QString& label, const QString& help, const SliderScale& scale,
                           double neutral, std::function<QString(double)> readOut, QWidget* parent)
    : QWidget(parent), m_scale(scale), m_readOut(std::move(readOut)), m_number(new QLabel),
      m_slider(new TrackSlider(scale, 1)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(new QLabel(label));
  layout->addWidget(m_slider);
  layout->addWidget(m_number);
  m_number->setForegroundRole(QPalette::PlaceholderText);
  m_slider->setFixedWidth(88);
  m_slider->setOrigin(neutral);
  m_slider->setValues({neutral});
  m_slider->setAccessibleName(label);
  m_slider->setAccessibleDescription(QTextDocumentFragment::fromHtml(help).toPlainText());
  m_slider->setReadOut(m_readOut);
  setToolTip(help);

  connect(m_slider, &TrackSlider::valuesEdited, this,
          [this](const std::vector<double>& values, std::uint64_t id) {
            m_number->setText(m_readOut(values[0]));
            emit pulled(values[0], id);
          });
  connect(m_slider, &TrackSlider::dragEnded, this, [this, neutral] {
    m_slider->setValues({neutral});
    emit released();
  });
  measureNumber();
}

void SpringSlider::measureNumber() {
  // Room for what is longest, so that nothing moves under the hand.
  int width = 0;
  for (const double end : {m_scale.lowest, m_scale.highest})
    width = std::max(width, fontMetrics().horizontalAdvance(m_readOut(end)));
  m_number->setMinimumWidth(width);
}

} // namespace limn
