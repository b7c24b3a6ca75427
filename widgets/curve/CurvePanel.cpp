// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/CurvePanel.h"

#include "widgets/controls/ChoiceRow.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace limn {
namespace {

QToolButton* makeButton(const QString& text, const QString& name, const QString& help) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setAccessibleName(name);
  button->setToolTip(help);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

// Logical pixels.
constexpr int mostOfAName = 200;
constexpr int swatchSize = 12;

QIcon curveSwatch(const QColor& color) {
  QPixmap swatch(swatchSize, swatchSize);
  swatch.fill(color);
  return swatch;
}

} // namespace

CurvePanel::CurvePanel(QWidget* parent)
    : QStackedWidget(parent), m_value(new TransferFunctionEditor), m_gradient(new GradientOpacityEditor),
      m_whose(new QuietComboBox) {
  addWidget(m_value);
  addWidget(m_gradient);
  m_whose->setAccessibleName(tr("Whose curve"));
  m_whose->setToolTip(
      tr("<p>Whose curve is shown and edited: the one for all tissue, or that of a label that has "
         "its own (Properties ▸ Labels).</p>"));
  m_whose->setMaximumWidth(mostOfAName);
  m_whose->hide();
  connect(m_whose, &QComboBox::activated, this, [this](int row) {
    emit curveChosen(row > 0 ? std::optional(m_labelCurves[row - 1].place) : std::nullopt);
  });
  m_value->addLeading(makeSwitch(m_switches[0]));
  m_value->addLeading(m_whose);
  m_gradient->editor()->addLeading(makeSwitch(m_switches[1]), 0);
  setGradientState(GradientState::off);
  showGradient(false);
}

void CurvePanel::setLabelCurves(const QList<LabelCurve>& curves, std::optional<std::size_t> inHand) {
  const QSignalBlocker blocker(m_whose);
  const bool areListed =
      m_whose->count() > 0 &&
      std::ranges::equal(curves, m_labelCurves, [](const LabelCurve& a, const LabelCurve& b) {
        return a.place == b.place && a.name == b.name;
      });
  if (!areListed) {
    m_whose->clear();
    m_whose->addItem(tr("All tissue"));
    for (const LabelCurve& curve : curves)
      m_whose->addItem(curve.name);
  }
  for (int n = 0; n < curves.size(); ++n)
    if (!areListed || curves[n].color != m_labelCurves[n].color)
      m_whose->setItemIcon(n + 1, curveSwatch(curves[n].color));
  m_labelCurves = curves;
  int row = 0;
  for (qsizetype n = 0; n < curves.size(); ++n)
    if (inHand == curves[n].place)
      row = static_cast<int>(n) + 1;
  m_whose->setCurrentIndex(row);
  m_whose->setVisible(!curves.isEmpty());
}

void CurvePanel::setVolumeOpen(bool isOpen) {
  m_value->setEditable(isOpen);
  for (const Switch& pair : m_switches)
    pair.value->parentWidget()->setEnabled(isOpen);
}

QWidget* CurvePanel::makeSwitch(Switch& made) {
  auto* row = new QWidget;
  row->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  made.name = new QLabel(tr("Opacity over"));
  made.name->setForegroundRole(QPalette::PlaceholderText);
  made.value = makeButton(tr("Value"), tr("Opacity over value"),
                          tr("<p>How opaque tissue is by its value: the transfer function.</p>"));
  made.gradient = makeButton(tr("Gradient"), tr("Opacity over gradient"), {});
  layout->addWidget(made.name);
  layout->addSpacing(4);
  layout->addWidget(made.value);
  layout->addWidget(made.gradient);
  connect(made.value, &QAbstractButton::clicked, this, [this] { showGradient(false); });
  connect(made.gradient, &QAbstractButton::clicked, this, [this] { showGradient(true); });
  return row;
}

void CurvePanel::showGradient(bool shown) {
  const bool changes = shown != gradientIsShown();
  const bool hadFocus = currentWidget()->isAncestorOf(QApplication::focusWidget());
  setCurrentIndex(shown ? 1 : 0);
  setFocusProxy(currentWidget());
  for (const Switch& pair : m_switches) {
    pair.value->setChecked(!shown);
    pair.gradient->setChecked(shown);
  }
  if (!changes)
    return;
  if (hadFocus) // the keyboard stays on the switch
    (shown ? m_switches[1].gradient : m_switches[0].value)->setFocus();
  emit gradientShown(shown);
}

void CurvePanel::resizeEvent(QResizeEvent* event) {
  for (const Switch& pair : m_switches)
    pair.name->setVisible(width() >= 840);
  QStackedWidget::resizeEvent(event);
}

void CurvePanel::setGradientState(GradientState state) {
  const QString help =
      tr("<p>How much of the opacity is left by how fast the value changes, so that boundaries stay.</p>");
  const QString unused = tr("<p>This projection does not add up opacities along its rays; tissue does.</p>");
  for (const Switch& pair : m_switches) {
    const bool isBesideItsTick = &pair == &m_switches[1]; // which says whether the curve is used
    pair.gradient->setText(state == GradientState::unused ? tr("Gradient: unused")
                           : isBesideItsTick              ? tr("Gradient")
                           : state == GradientState::off  ? tr("Gradient: off")
                                                          : tr("Gradient: on"));
    pair.gradient->setToolTip(state == GradientState::unused ? help + unused : help);
  }
}

} // namespace limn
