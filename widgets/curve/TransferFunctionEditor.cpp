// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/TransferFunctionEditor.h"

#include "scene/function/TissueOpacity.h"
#include "widgets/ValueText.h"
#include "widgets/controls/Popups.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/curve/PointFields.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/curve/picture/Tissue.h"
#include "widgets/theme/Icons.h"

#include <QCheckBox>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

// Where values have no names, so much of the volume's range to either side counts as the same tissue.
constexpr double sameTissue = 1.0 / 40.0;

std::optional<Tissue> tissueOf(double value, const QString& unit) {
  return unit == QLatin1String("HU") ? tissueAt(value) : std::nullopt;
}

ValueBand bandOf(double value, const QString& unit, const ValueRange& range) {
  if (const auto tissue = tissueOf(value, unit))
    return {std::max(tissue->range.lowest, range.lowest), std::min(tissue->range.highest, range.highest)};
  const double reach = sameTissue * (range.highest - range.lowest);
  return {value - reach, value + reach};
}

QString factorText(double factor) {
  return QChar(0x00d7) + fixedNumber(factor, 2);
}

} // namespace

TissueButtons::TissueButtons(QWidget* parent) : QWidget(parent), m_label(new QLabel(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_label);
  layout->addWidget(button(tr("Less"), tr("Halves the opacity around the pinned value"), lessOpacity));
  layout->addWidget(button(tr("More"), tr("Doubles the opacity around the pinned value"), moreOpacity));
}

void TissueButtons::setValue(double value, const QString& unit, const ValueRange& range, int decimals) {
  m_value = value;
  m_unit = unit;
  m_range = range;
  m_text = valueText(value, unit, decimals);
  const auto tissue = tissueOf(value, unit);
  m_label->setText(tissue ? tr("Pinned: %1, %2").arg(m_text, tissue->name) : tr("Pinned: %1").arg(m_text));
}

QToolButton* TissueButtons::button(const QString& text, const QString& toolTip, double (*change)(double)) {
  auto* made = new QToolButton(this);
  made->setText(text);
  made->setToolTip(toolTip);
  made->setAccessibleName(tr("%1 of the pinned tissue", "less or more").arg(text));
  made->setFocusPolicy(Qt::StrongFocus);
  made->setProperty("framed", true);
  connect(made, &QToolButton::clicked, this, [this, change, text] {
    emit functionEdited(
        withOpacityChanged(m_function, bandOf(m_value, m_unit, m_range), change),
        {nextGestureId(), tr("%1 of %2", "less or more, a value").arg(text.toLower(), m_text)});
  });
  return made;
}

TransferFunctionEditor::TransferFunctionEditor(CurveSubject subject, QWidget* parent)
    : QWidget(parent), m_canvas(new TransferFunctionCanvas(subject)), m_fields(new PointFields(subject)),
      m_tissue(new TissueButtons(this)),
      m_opacity(new SpringSlider(
          TransferFunctionEditor::tr("Overall opacity"),
          TransferFunctionEditor::tr(
              "<p>Makes everything visible more solid or more transparent; what is invisible stays "
              "so.</p><p>×0.1 – ×10 of what it is, which is told until the curve changes otherwise. The "
              "slider springs "
              "back when let go, so that it can be pulled on; Shift drags finer.</p>"),
          {0.1, 10.0, true}, 1.0, factorText)),
      m_shift(new SpringSlider(TransferFunctionEditor::tr("Shift"),
                               TransferFunctionEditor::tr(
                                   "<p>Moves the whole curve to lower or higher values, so that other tissue "
                                   "appears.</p><p>Up to a quarter of the volume's range either way, default "
                                   "0. It springs back when let go; Shift drags finer.</p>"),
                               {-1.0, 1.0, false}, 0.0,
                               [this](double position) {
                                 const QString sign = position > 0.0 ? QStringLiteral("+") : QString();
                                 return sign + valueText(shiftOf(position), m_canvas->unit(),
                                                         m_canvas->shownDecimals());
                               })),
      m_fine(new QCheckBox(TransferFunctionEditor::tr("Fine low opacities"))), m_showAll(new QToolButton),
      m_more(new QToolButton) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 4);
  layout->setSpacing(0);
  layout->addWidget(makeControlRow());
  layout->addWidget(m_canvas, 1);
  setFocusProxy(m_canvas);
  connectCanvas();
  connectSliders();
  showPinOrPoints();
  showIcons();
}

QWidget* TransferFunctionEditor::makeControlRow() {
  m_fine->setToolTip(tr("<p>Stretches the lower part of the opacity axis, where small changes show most in "
                        "the picture; the curve itself stays.</p><p>On or off, default off.</p>"));
  m_fine->setAccessibleName(tr("Fine low opacities"));
  connect(m_fine, &QAbstractButton::toggled, m_canvas, &TransferFunctionCanvas::setFineLowOpacities);
  m_showAll->setToolTip(tr("Show all values of the volume (also: double click on the axis)"));
  m_showAll->setAccessibleName(tr("Show all values"));
  connect(m_showAll, &QAbstractButton::clicked, m_canvas, &TransferFunctionCanvas::resetView);

  m_more->setObjectName(QStringLiteral("moreCurveTools"));
  m_more->setToolTip(tr("Tools that find no room here."));
  m_more->setAccessibleName(tr("More tools"));
  m_more->setFocusPolicy(Qt::TabFocus);
  connect(m_more, &QAbstractButton::clicked, this, &TransferFunctionEditor::openMore);

  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(12);
  m_row = layout;
  layout->addWidget(m_fields);
  layout->addWidget(m_tissue);
  layout->addStretch(1);
  for (QWidget* tool : toolsInOrder())
    layout->addWidget(tool);
  layout->addWidget(m_more);
  layout->addWidget(m_showAll);
  // The bar above the plot shifts too, dragging all points does nearly what the opacity does.
  m_tools = {m_fine, m_opacity, m_shift};
  // The row never makes the window wider: what finds no room stands behind the button.
  row->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return row;
}

void TransferFunctionEditor::addLeading(QWidget* control, int place) {
  m_row->insertWidget(place < 0 ? m_leading : place, control);
  ++m_leading;
  control->installEventFilter(this);
  placeTools();
}

void TransferFunctionEditor::addTrailing(QWidget* control) {
  m_row->insertWidget(m_row->count() - 1, control);
  ++m_trailing;
  control->installEventFilter(this);
  placeTools();
}

void TransferFunctionEditor::setEditable(bool editable) {
  m_canvas->setEnabled(editable);
  for (QWidget* control : std::initializer_list<QWidget*>{m_opacity, m_shift, m_fine, m_showAll, m_more})
    control->setEnabled(editable);
  m_isEditable = editable;
  showPinOrPoints();
}

void TransferFunctionEditor::connectCanvas() {
  connect(m_canvas, &TransferFunctionCanvas::transferFunctionEdited, this,
          [this](const TransferFunction& function, const Gesture& gesture) {
            showSelection();
            emit transferFunctionEdited(function, gesture);
          });
  connect(m_canvas, &TransferFunctionCanvas::valueHovered, this, &TransferFunctionEditor::valueHovered);
  connect(m_canvas, &TransferFunctionCanvas::selectionChanged, this, [this] {
    m_pinIsLatest = m_pinIsLatest && m_canvas->selected().empty();
    showSelection();
  });
  connect(m_canvas, &TransferFunctionCanvas::pinChanged, this, [this] {
    m_pinIsLatest = m_canvas->hasPin();
    showSelection();
  });
  connect(m_canvas, &TransferFunctionCanvas::numbersRequested, m_fields, &PointFields::focusValue);
  connect(m_canvas, &TransferFunctionCanvas::pointDetailsRequested, this,
          &TransferFunctionEditor::openDetails);
  connect(m_fields, &PointFields::functionEdited, m_canvas, &TransferFunctionCanvas::edit);
  connect(m_fields, &PointFields::typingEnded, m_canvas, qOverload<>(&QWidget::setFocus));
  connect(m_tissue, &TissueButtons::functionEdited, m_canvas, &TransferFunctionCanvas::edit);
}

void TransferFunctionEditor::connectSliders() {
  connect(m_opacity, &SpringSlider::pulled, this, [this](double factor, std::uint64_t id) {
    pull(*m_opacity, withOpacityScaled(pullBase(id), factor),
         {id, tr("change overall opacity %1").arg(factorText(factor))});
  });
  connect(m_shift, &SpringSlider::pulled, this, [this](double position, std::uint64_t id) {
    const double offset = shiftOf(position);
    pull(*m_shift, shifted(pullBase(id), offset),
         {id, tr("shift curve by %1").arg(valueText(offset, m_canvas->unit(), m_canvas->shownDecimals()))});
  });
  for (SpringSlider* slider : {m_opacity, m_shift})
    connect(slider, &SpringSlider::released, this, [this] { m_pullId = 0; });
}

const TransferFunction& TransferFunctionEditor::pullBase(std::uint64_t gestureId) {
  if (m_pullId != gestureId) {
    m_pullId = gestureId;
    m_pullBase = m_canvas->transferFunction();
  }
  return m_pullBase;
}

void TransferFunctionEditor::pull(const SpringSlider& slider, const TransferFunction& function,
                                  const Gesture& gesture) {
  for (SpringSlider* other : {m_opacity, m_shift})
    if (other != &slider)
      other->forgetPull();
  m_pulled = function;
  m_canvas->edit(function, gesture);
}

// What a pull did is told until the curve is another one.
void TransferFunctionEditor::forgetPulls() {
  if (m_canvas->transferFunction() == m_pulled)
    return;
  m_opacity->forgetPull();
  m_shift->forgetPull();
}

double TransferFunctionEditor::shiftOf(double position) const {
  // Quadratic, so that the middle of the short track is fine.
  return position * std::abs(position) * 0.25 * (m_range.highest - m_range.lowest);
}

int TransferFunctionEditor::typedDecimals() const {
  return std::min(9, decimalsFor((m_range.highest - m_range.lowest) / 10000.0));
}

void TransferFunctionEditor::setTransferFunction(const TransferFunction& function) {
  m_canvas->setTransferFunction(function);
  showSelection();
}

void TransferFunctionEditor::setHistogram(const Histogram& histogram) {
  m_range = histogram.range;
  m_canvas->setHistogram(histogram);
  m_shift->measureNumber();
  showSelection();
}

void TransferFunctionEditor::setUnit(const QString& unit) {
  m_canvas->setUnit(unit);
  m_shift->measureNumber();
  showSelection();
}

void TransferFunctionEditor::setMark(const std::optional<ValueMark>& mark) {
  m_canvas->setMark(mark);
}

void TransferFunctionEditor::setPinnedValue(std::optional<double> value) {
  m_canvas->setPinnedValue(value);
}

void TransferFunctionEditor::showSelection() {
  forgetPulls();
  m_fields->setPoints(m_canvas->transferFunction(), m_canvas->selected(), m_canvas->unit(), typedDecimals());
  m_tissue->setTransferFunction(m_canvas->transferFunction());
  if (const auto pinned = m_canvas->pinnedValue())
    m_tissue->setValue(*pinned, m_canvas->unit(), m_range, m_canvas->shownDecimals());
  showPinOrPoints();
}

// There is room for one of them: what the user turned to last.
void TransferFunctionEditor::showPinOrPoints() {
  m_fields->setVisible(m_isEditable && !m_pinIsLatest);
  m_tissue->setVisible(m_isEditable && m_pinIsLatest);
  placeTools();
}

void TransferFunctionEditor::openDetails(std::size_t index) {
  const TransferFunction& function = m_canvas->transferFunction();
  const PointIndices& selected = m_canvas->selected();
  auto* popup = new PointPopup(m_canvas->subject(), function,
                               contains(selected, index) ? selected : PointIndices{index}, m_canvas->unit(),
                               typedDecimals(), this);
  connect(popup, &PointPopup::functionEdited, m_canvas, &TransferFunctionCanvas::edit);
  // The release of the click that opens it comes after the pointer has left for it; where it closes, the
  // pointer may be anywhere.
  connect(popup, &QObject::destroyed, m_canvas, &TransferFunctionCanvas::forgetPointer);
  const QPoint centre = positionOf(m_canvas->transform(), function.points[index]).toPoint();
  showPopupAt(*popup, QRect(m_canvas->mapToGlobal(centre) - QPoint(10, 10), QSize(20, 20)));
  popup->fields()->focusValue();
}

void TransferFunctionEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    showIcons();
  QWidget::changeEvent(event);
}

void TransferFunctionEditor::resizeEvent(QResizeEvent* event) {
  placeTools();
  QWidget::resizeEvent(event);
}

// How many of the tools the row has room for.
int TransferFunctionEditor::toolsWithRoom() const {
  const auto widthOf = [this](const QWidget* widget) {
    return widget->sizeHint().width() + m_row->spacing();
  };
  const auto roomOf = [&widthOf](const QWidget* control) { // which may be shown only at times
    return control->isHidden() ? 0 : widthOf(control);
  };
  const QMargins margins = layout()->contentsMargins();
  const QWidget* numbers = m_pinIsLatest ? static_cast<QWidget*>(m_tissue) : m_fields;
  int room = width() - margins.left() - margins.right() - widthOf(numbers) - widthOf(m_showAll);
  for (int i = 0; i < m_leading; ++i)
    room -= roomOf(m_row->itemAt(i)->widget());
  for (int i = 0; i < m_trailing; ++i)
    room -= roomOf(m_row->itemAt(m_row->count() - 2 - i)->widget());
  int whole = 0;
  for (const QWidget* tool : m_tools)
    whole += widthOf(tool);
  const int count = static_cast<int>(m_tools.size());
  if (whole <= room)
    return count;
  room -= widthOf(m_more);
  int fitting = 0;
  while (fitting < count && (room -= widthOf(m_tools[static_cast<std::size_t>(fitting)])) >= 0)
    ++fitting;
  return fitting;
}

// Tools that find no room are behind the button beside the row, and come back when a point is let go.
void TransferFunctionEditor::placeTools() {
  const int inRow = toolsWithRoom();
  for (int i = 0; i < static_cast<int>(m_tools.size()); ++i)
    if (QWidget* tool = m_tools[static_cast<std::size_t>(i)]; tool->parentWidget() != m_morePanel)
      tool->setVisible(i < inRow);
  m_more->setVisible(inRow < static_cast<int>(m_tools.size()));
}

// They stand in its panel as long as that is open.
void TransferFunctionEditor::openMore() {
  if (m_morePanel) // the one before is being closed
    return;
  m_morePanel = new QFrame(this, Qt::Popup); // no earlier: it would part the row from the window's Tab order
  m_morePanel->setFrameShape(QFrame::StyledPanel);
  m_morePanel->installEventFilter(this);
  auto* column = new QVBoxLayout(m_morePanel);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(12);
  for (QWidget* tool : toolsInOrder())
    if (tool->isHidden()) {
      column->addWidget(tool);
      tool->show();
    }
  showPopupAt(*m_morePanel, QRect(m_more->mapToGlobal(QPoint(0, 0)), m_more->size()));
}

// In the row they have their places, and their turn when somebody presses Tab.
void TransferFunctionEditor::takeBackMore() {
  if (!m_morePanel)
    return;
  const std::array<QWidget*, 3> tools = toolsInOrder();
  for (QWidget* tool : tools) {
    m_row->removeWidget(tool);
    m_row->insertWidget(m_row->indexOf(m_more), tool);
  }
  const auto isOfTools = [&](const QWidget* widget) {
    return std::ranges::any_of(
        tools, [&](const QWidget* tool) { return tool == widget || tool->isAncestorOf(widget); });
  };
  QWidget* last = m_more;
  do
    last = last->previousInFocusChain();
  while (isOfTools(last));
  for (QWidget* tool : tools) {
    auto* slider = tool->findChild<TrackSlider*>();
    QWidget* next = slider ? slider : tool;
    QWidget::setTabOrder(last, next);
    last = next;
  }
  std::exchange(m_morePanel, nullptr)->deleteLater();
  placeTools();
}

std::array<QWidget*, 3> TransferFunctionEditor::toolsInOrder() const {
  return {m_opacity, m_shift, m_fine};
}

bool TransferFunctionEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_morePanel && event->type() == QEvent::Hide)
    QMetaObject::invokeMethod(this, &TransferFunctionEditor::takeBackMore,
                              Qt::QueuedConnection); // once it is closed
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)
    placeTools(); // a control of the row takes room, or does so no longer
  return QWidget::eventFilter(watched, event);
}

void TransferFunctionEditor::showIcons() {
  m_showAll->setIcon(themedIcon(QStringLiteral("show-all"), palette()));
  m_more->setIcon(themedIcon(QStringLiteral("more-tools"), palette()));
}

} // namespace limn
