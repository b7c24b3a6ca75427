// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/HistogramButton.h"

#include "widgets/theme/Icons.h"

#include <QEvent>
#include <QGuiApplication>
#include <QMenu>

namespace limn {

HistogramButton::HistogramButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("histogramButton"));
  showIcon();
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  setMenu(new QMenu(this));
  menu()->setToolTipsVisible(true);
  addHeading(tr("Height"));
  addChoice(HistogramScale::linear, &HistogramView::scale, tr("Linear"),
            tr("As high as the number of voxels: large tissues stand out."));
  addChoice(HistogramScale::logarithmic, &HistogramView::scale, tr("Logarithmic"),
            tr("By the logarithm of the number of voxels: small tissues show beside large ones."));
  addChoice(HistogramScale::percentile, &HistogramView::scale, tr("Percentile"),
            tr("How many of the voxels lie at or below a value: 0 at the left, all of them at the right."));
  addHeading(tr("Of"));
  addChoice(HistogramPart::whole, &HistogramView::part, tr("The whole volume"), tr("Every voxel counts."));
  addChoice(HistogramPart::kept, &HistogramView::part, tr("What is kept"),
            tr("Voxels count that neither the crop box nor the kept region (body, labels) hides."));
  addChoice(HistogramPart::visible, &HistogramView::part, tr("What is visible"),
            tr("Of what is kept, voxels count to whose value the curve gives opacity, even where others hide "
               "them from the camera."));
  setView({});
}

void HistogramButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    showIcon();
  QToolButton::changeEvent(event);
}

// By the application's palette: the style sheet gives a button one of its own, from which no look can be
// told.
void HistogramButton::showIcon() {
  setIcon(themedIcon(QStringLiteral("histogram"), QGuiApplication::palette()));
}

void HistogramButton::addHeading(const QString& text) {
  menu()->addSection(text);
}

template <class Choice>
void HistogramButton::addChoice(Choice choice, Choice HistogramView::*part, const QString& text,
                                const QString& help) {
  QAction* action = menu()->addAction(text);
  action->setObjectName(QStringLiteral("histogram-") + QLatin1String(nameOf(choice)));
  action->setToolTip(help);
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [this, choice, part] {
    HistogramView chosen = m_view;
    chosen.*part = choice;
    setView(chosen);
    emit viewChosen(chosen);
  });
}

void HistogramButton::setView(const HistogramView& view) {
  m_view = view;
  QStringList chosen;
  for (QAction* action : menu()->actions()) {
    const QString name = action->objectName();
    action->setChecked(name == QStringLiteral("histogram-") + QLatin1String(nameOf(view.scale)) ||
                       name == QStringLiteral("histogram-") + QLatin1String(nameOf(view.part)));
    if (action->isChecked())
      chosen << action->text();
  }
  setAccessibleName(tr("Histogram: %1").arg(chosen.join(QStringLiteral(", "))));
  setToolTip(tr("<p>What stands behind the curve: %1.</p>").arg(chosen.join(QStringLiteral(", "))));
}

} // namespace limn
