// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/PointFields.h"

#include "widgets/ValueText.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/NumberField.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

constexpr double farthest = 1e9; // of what can be typed

// As far as a drag would take a point: to its neighbours. Several have no number of their own.
ValueRange reachAmong(const TransferFunction& function, const PointIndices& indices, CurveSubject subject) {
  ValueRange reach{std::max(-farthest, lowestPlace(subject)), farthest};
  if (const std::size_t i = indices.front(); indices.size() == 1) {
    if (i > 0)
      reach.lowest = std::max(reach.lowest, function.points[i - 1].value);
    if (i + 1 < function.points.size())
      reach.highest = std::min(reach.highest, function.points[i + 1].value);
  }
  return reach;
}

TransferFunction withOpacityAt(const TransferFunction& function, const PointIndices& indices,
                               double opacity) {
  TransferFunction edited = function;
  for (const std::size_t i : indices)
    edited.points[i].opacity = std::clamp(opacity, 0.0, 1.0);
  return edited;
}

TransferFunction withColorAt(const TransferFunction& function, const PointIndices& indices,
                             const glm::dvec3& color) {
  TransferFunction edited = function;
  for (const std::size_t i : indices)
    edited = withPointColored(edited, i, color);
  return edited;
}

QString pickedColorText(const PointIndices& indices) {
  return indices.size() > 1 ? PointFields::tr("change colour of %1 points").arg(indices.size())
                            : PointFields::tr("change colour of point");
}

} // namespace

PointFields::PointFields(CurveSubject subject, QWidget* parent)
    : QWidget(parent), m_subject(subject), m_which(new QLabel), m_opacityName(new QLabel(tr("Opacity"))),
      m_value(new NumberField(std::max(-farthest, lowestPlace(subject)), farthest, 1)),
      m_opacity(new NumberField(0.0, 1.0, 4)), m_color(new ColorButton(pickedColorText({}))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_which);
  layout->addWidget(m_value);
  layout->addWidget(m_opacityName);
  layout->addWidget(m_opacity);
  layout->addWidget(m_color);
  m_which->setForegroundRole(QPalette::PlaceholderText);
  m_opacityName->setForegroundRole(QPalette::PlaceholderText);
  m_opacityName->setBuddy(m_opacity);
  m_which->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Point %1 of %2").arg(8).arg(8)));
  m_value->setFixedWidth(104);
  m_opacity->setFixedWidth(64);
  m_opacity->setShownAs(opacityText);
  m_opacity->setSingleStep(0.01);
  m_opacity->setTakesPercent(true);
  nameFields();

  connect(m_value, &NumberField::numberEdited, this, [this](double value) {
    const std::size_t i = m_selected.front();
    const TransferFunction moved = withPointMoved(m_function, i, value, m_function.points[i].opacity);
    m_value->setNumber(moved.points[i].value); // a neighbour may stand between the decimals that are shown
    emit functionEdited(
        moved, {nextGestureId(),
                tr("move point to %1").arg(valueText(moved.points[i].value, m_unit, m_value->decimals()))});
  });
  connect(m_opacity, &NumberField::numberEdited, this, [this](double opacity) {
    emit functionEdited(withOpacityAt(m_function, m_selected, opacity),
                        {nextGestureId(), tr("set opacity to %1").arg(opacityText(opacity))});
  });
  connect(m_color, &ColorButton::colorEdited, this,
          [this](const glm::dvec3& color, const Gesture& gesture) { pickColor(color, gesture.id); });
  connect(m_color, &ColorButton::takenBack, this, &PointFields::takeBackColor);
  for (NumberField* field : {m_value, m_opacity})
    field->installEventFilter(this);
  setPoints({}, {}, {}, 1);
}

void PointFields::nameFields() {
  const bool ofValue = m_subject == CurveSubject::value;
  m_value->setAccessibleName(ofValue ? tr("Value of the selected point")
                                     : tr("Gradient of the selected point"));
  m_opacity->setAccessibleName(tr("Opacity of the selected point"));
  m_color->setAccessibleName(tr("Colour of the selected point"));
  m_opacity->setToolTip(ofValue ? tr("How much tissue of this value hides what lies behind it: 0 (invisible) "
                                     "– 1 (solid), or per cent such as 10 %")
                                : tr("How much is left of the opacity where the value changes this fast: 0 "
                                     "(none) – 1 (all), or per cent such as 10 %"));
  m_color->setToolTip(tr("The colour in which tissue of this value is drawn"));
}

void PointFields::setPoints(const TransferFunction& function, const PointIndices& selected,
                            const QString& unit, int decimals) {
  m_function = function;
  m_selected = selected;
  m_unit = unit;
  m_which->setText(describedSelection());
  m_value->setVisible(!selected.empty());
  m_opacity->setVisible(!selected.empty());
  m_opacityName->setVisible(!selected.empty());
  m_color->setVisible(!selected.empty() && hasColors(m_subject));
  m_value->setEnabled(selected.size() == 1);
  m_value->setToolTip(selected.size() > 1 ? tr("Several points are selected: move them together in the plot")
                                          : tr("Where the point stands on the axis, between its neighbours"));
  m_value->setSuffix(unit.isEmpty() || selected.size() > 1 ? QString() : QChar(0x00a0) + unit);
  if (selected.empty())
    return;
  const ValueRange reach = reachAmong(function, selected, m_subject);
  m_value->setLimits(reach.lowest, reach.highest, decimals);
  showCommon(*m_value, &ControlPoint::value);
  showCommon(*m_opacity, &ControlPoint::opacity);
  std::vector<glm::dvec3> colors;
  for (const std::size_t i : selected)
    colors.push_back(function.points[i].color);
  m_color->setColors(colors);
}

// The number of all that are selected, or none where theirs differ.
void PointFields::showCommon(NumberField& field, double ControlPoint::*number) const {
  const double first = m_function.points[m_selected.front()].*number;
  const bool isMixed =
      std::ranges::any_of(m_selected, [&](std::size_t i) { return m_function.points[i].*number != first; });
  isMixed ? field.setMixed() : field.setNumber(first);
}

void PointFields::pickColor(const glm::dvec3& color, std::uint64_t gestureId) {
  if (m_picking != gestureId) {
    m_picking = gestureId;
    m_beforePick = m_function;
  }
  emit functionEdited(withColorAt(m_function, m_selected, color), {gestureId, pickedColorText(m_selected)});
}

void PointFields::takeBackColor(std::uint64_t gestureId) {
  if (m_picking != gestureId || m_beforePick.points.size() != m_function.points.size())
    return;
  TransferFunction before = m_function;
  for (const std::size_t i : m_selected)
    before = withPointColored(before, i, m_beforePick.points[i].color);
  emit functionEdited(before, {gestureId, pickedColorText(m_selected)});
}

void PointFields::focusValue() {
  NumberField* field = m_selected.size() == 1 ? m_value : m_opacity;
  field->setFocus(Qt::ShortcutFocusReason);
  field->selectAll();
}

bool PointFields::eventFilter(QObject* watched, QEvent* event) {
  auto* field = qobject_cast<NumberField*>(watched);
  if (!field || event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape)
    field->takeBack();
  else if (key != Qt::Key_Return && key != Qt::Key_Enter)
    return false;
  else if (!field->commit())
    return true; // to be typed once more
  emit typingEnded(key == Qt::Key_Escape);
  return true;
}

QString PointFields::describedSelection() const {
  if (m_selected.empty())
    return m_function.points.empty() ? tr("Double click in the plot to add a point")
                                     : tr("Click the curve to add a point");
  if (m_selected.size() > 1)
    return tr("%1 points").arg(m_selected.size());
  return tr("Point %1 of %2").arg(m_selected.front() + 1).arg(m_function.points.size());
}

PointPopup::PointPopup(CurveSubject subject, const TransferFunction& function, const PointIndices& points,
                       const QString& unit, int decimals, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_points(points), m_unit(unit), m_decimals(decimals),
      m_fields(new PointFields(subject)), m_picker(new ColorPicker) {
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(12);
  layout->addWidget(m_fields);
  layout->addWidget(m_picker);
  m_picker->setVisible(hasColors(subject));
  m_fields->setPoints(function, points, unit, decimals);
  m_picker->setColor(function.points[points.front()].color);

  connect(m_fields, &PointFields::functionEdited, this, &PointPopup::change);
  connect(m_fields, &PointFields::typingEnded, this, [this](bool isTakenBack) {
    if (isTakenBack)
      m_picker->takeBack();
    close();
  });
  connect(m_picker, &ColorPicker::colorPicked, m_fields, &PointFields::pickColor);
  connect(m_picker, &ColorPicker::takenBack, m_fields, &PointFields::takeBackColor);
}

// Wherever in it the keyboard is.
void PointPopup::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isEnter && m_picker->refusal().isEmpty())
    close();
  if (isEnter)
    return;
  if (event->matches(QKeySequence::Cancel))
    m_picker->takeBack();
  QFrame::keyPressEvent(event);
}

void PointPopup::change(const TransferFunction& function, const Gesture& gesture) {
  m_fields->setPoints(function, m_points, m_unit, m_decimals);
  emit functionEdited(function, gesture);
}

} // namespace limn
