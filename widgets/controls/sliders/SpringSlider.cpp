// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/sliders/SpringSlider.h"

#include "widgets/controls/sliders/TrackSlider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTextDocumentFragment>

namespace limn {

SpringSlider::SpringSlider(const QString& label, const QString& help, const SliderScale& scale,
                           double neutral, std::function<QString(double)> readOut, QWidget* parent)
    : QWidget(parent), m_number(new QLabel(readOut(neutral))), m_slider(new TrackSlider(scale, 1)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(new QLabel(label));
  layout->addWidget(m_slider);
  layout->addWidget(m_number);
  m_number->setForegroundRole(QPalette::PlaceholderText);
  m_number->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("+1000 HU")));
  m_slider->setFixedWidth(104);
  m_slider->setOrigin(neutral);
  m_slider->setValues({neutral});
  m_slider->setAccessibleName(label);
  m_slider->setAccessibleDescription(QTextDocumentFragment::fromHtml(help).toPlainText());
  m_slider->setReadOut(readOut);
  setToolTip(help);

  connect(m_slider, &TrackSlider::valuesEdited, this,
          [this, readOut](const std::vector<double>& values, std::uint64_t id) {
            m_number->setText(readOut(values[0]));
            emit pulled(values[0], id);
          });
  connect(m_slider, &TrackSlider::dragEnded, this, [this, neutral, readOut] {
    m_slider->setValues({neutral});
    m_number->setText(readOut(neutral));
    emit released();
  });
}

} // namespace limn
