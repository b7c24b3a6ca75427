// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/points/PointPopup.h"

#include "widgets/controls/NumberField.h"
#include "widgets/controls/color/ColorButton.h"
#include "widgets/controls/color/ColorPicker.h"
#include "widgets/curve/points/PointFields.h"

#include <QVBoxLayout>

namespace limn {

PointPopup::PointPopup(CurveSubject subject, const TransferFunction& function, std::size_t index,
                       const QString& unit, int decimals, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_function(function), m_index(index), m_unit(unit), m_decimals(decimals),
      m_fields(new PointFields(subject)), m_picker(new ColorPicker) {
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(12);
  layout->addWidget(m_fields);
  layout->addWidget(m_picker);
  m_picker->setVisible(hasColors(subject));
  m_fields->setPoints(function, {index}, unit, decimals);
  m_picker->setColor(function.points[index].color);

  connect(m_fields, &PointFields::functionEdited, this, &PointPopup::change);
  connect(m_fields, &PointFields::typingEnded, this, &QWidget::close);
  connect(m_picker, &ColorPicker::colorPicked, this, [this](const glm::dvec3& color, std::uint64_t id) {
    change(withPointColored(m_function, m_index, color), {id, tr("change colour of point")});
  });
}

void PointPopup::change(const TransferFunction& function, const Gesture& gesture) {
  m_function = function;
  m_fields->setPoints(function, {m_index}, m_unit, m_decimals);
  emit functionEdited(function, gesture);
}

} // namespace limn
