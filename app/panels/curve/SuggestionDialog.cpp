// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/SuggestionDialog.h"

#include "widgets/ValueText.h"
#include "widgets/curve/picture/Tissue.h"
#include "widgets/theme/Theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QObject>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

// CT numbers, HU.
bool isAir(double value) {
  return value < -500.0;
}

bool isSoft(double value) {
  return value > -150.0 && value < 200.0;
}

bool isBone(double value) {
  return value > 300.0;
}

// A value is told to some hundredths of the step over its boundary.
QString numberText(double value, const Boundary& boundary, const QString& unit) {
  return valueText(value, unit, decimalsFor(std::max((boundary.high - boundary.low) / 20.0, 1e-9)));
}

QString placeText(const Boundary& boundary, const ValueNames& names) {
  return QObject::tr("Surface at %1").arg(numberText(boundary.value(), boundary, names.unit));
}

constexpr int swatchSize = 20;

// The property of a row and its button that says which suggestion they are of.
constexpr const char* indexProperty = "suggestion";

QPixmap swatchOf(const glm::dvec3& color, const QColor& outline, double devicePixelRatio) {
  QPixmap pixmap(QSize(swatchSize, swatchSize) * devicePixelRatio);
  pixmap.setDevicePixelRatio(devicePixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(outline);
  painter.setBrush(QColor::fromRgbF(static_cast<float>(color.r), static_cast<float>(color.g),
                                    static_cast<float>(color.b)));
  painter.drawRoundedRect(QRectF(0.5, 0.5, swatchSize - 1, swatchSize - 1), 4.0, 4.0);
  return pixmap;
}

} // namespace

QString boundaryName(const Boundary& boundary, const ValueNames& names) {
  if (!names.isHounsfield)
    return placeText(boundary, names);
  if (isAir(boundary.low) && isSoft(boundary.high))
    return QObject::tr("Skin and airways");
  if (isSoft(boundary.low) && isBone(boundary.high))
    return QObject::tr("Bone");
  const auto low = tissueAt(boundary.low);
  const auto high = tissueAt(boundary.high);
  if (low && high && low->name != high->name)
    return QObject::tr("From %1 to %2", "two tissues").arg(low->name, high->name);
  if (low && high)
    return QObject::tr("Within %1", "a tissue").arg(low->name);
  return placeText(boundary, names);
}

QString boundaryExplained(const Boundary& boundary, const ValueNames& names) {
  const double percent = 100.0 * boundary.share;
  const QString low = numberText(boundary.low, boundary, {});
  const QString high = numberText(boundary.high, boundary, names.unit);
  const QString share = plainNumber(percent, percent < 9.5 ? 1 : 0);
  const QString place = placeText(boundary, names);
  return boundaryName(boundary, names) == place // which is said
             ? QObject::tr("Between %1 and %2; %3 % of all boundaries").arg(low, high, share)
             : QObject::tr("%1, between %2 and %3; %4 % of all boundaries").arg(place, low, high, share);
}

SuggestionDialog::SuggestionDialog(QWidget* parent)
    : QDialog(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)) {
  setWindowTitle(tr("Suggested bands"));
  m_text->setWordWrap(true);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(tr("Looking for boundaries"));
  auto* list = new QWidget;
  m_rows = new QVBoxLayout(list);
  m_rows->setContentsMargins(0, 0, 8, 0);
  m_rows->setSpacing(4);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(list);
  auto* close = new QPushButton(tr("Close"), this);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  auto* column = new QVBoxLayout(this);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addWidget(scroll, 1);
  column->addWidget(close, 0, Qt::AlignRight);
  resize(560, 400);
}

void SuggestionDialog::showProgress(double fraction) {
  clearRows();
  m_text->setText(tr("Looking for where materials touch…"));
  m_bar->setRange(0, 100);
  m_bar->setValue(static_cast<int>(100.0 * fraction));
  m_bar->show();
}

void SuggestionDialog::showSentence(const QString& sentence) {
  clearRows();
  m_bar->hide();
  m_text->setText(sentence);
}

void SuggestionDialog::setSuggestions(const std::vector<Suggestion>& suggestions, const ValueNames& names) {
  showSentence(suggestions.empty()
                   ? tr("Nothing in this volume has a boundary that stands out.")
                   : tr("Each band makes one boundary visible, and the uppermost all beyond it; those that "
                        "stand out most come first. Point at a row to see it in the picture; Use puts it "
                        "into the curve, in one step of the history."));
  for (std::size_t i = 0; i < suggestions.size(); ++i)
    m_rows->addWidget(rowFor(suggestions[i], i, names));
  m_rows->addStretch();
}

void SuggestionDialog::setShown(const std::vector<bool>& shown) {
  m_isSettling = true; // a button that falls out of use gives the focus on: nobody went to the next row
  for (std::size_t i = 0; i < std::min(shown.size(), m_buttons.size()); ++i) {
    m_buttons[i]->setEnabled(!shown[i]);
    m_buttons[i]->setText(shown[i] ? tr("In the curve") : tr("Use"));
  }
  m_isSettling = false;
}

void SuggestionDialog::clearRows() {
  preview(std::nullopt);
  m_buttons.clear();
  while (QLayoutItem* item = m_rows->takeAt(0)) {
    if (item->widget())
      item->widget()->deleteLater();
    delete item;
  }
}

QWidget* SuggestionDialog::rowFor(const Suggestion& suggestion, std::size_t index, const ValueNames& names) {
  auto* row = new QWidget;
  row->setObjectName(QStringLiteral("suggestionRow"));
  auto* swatch = new QLabel(row);
  swatch->setPixmap(swatchOf(suggestion.top.color, themeColors(palette()).outline, devicePixelRatioF()));
  auto* text = new QLabel(row);
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  const QString name = boundaryName(suggestion.boundary, names);
  const QString why = boundaryExplained(suggestion.boundary, names);
  text->setText(QStringLiteral("<b>%1</b><br/>%2").arg(name.toHtmlEscaped(), why.toHtmlEscaped()));
  auto* use = new QPushButton(tr("Use"), row);
  use->setAccessibleName(tr("Use the band %1").arg(name));
  use->setAccessibleDescription(why);
  connect(use, &QPushButton::clicked, this, [this, index] { emit chosen(index); });
  m_buttons.push_back(use);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(4, 4, 4, 4);
  line->setSpacing(12);
  line->addWidget(swatch, 0, Qt::AlignTop);
  line->addWidget(text, 1);
  line->addWidget(use, 0, Qt::AlignVCenter);
  for (QWidget* watched : {row, static_cast<QWidget*>(use)}) {
    watched->setProperty(indexProperty, static_cast<qulonglong>(index));
    watched->installEventFilter(this);
  }
  return row;
}

bool SuggestionDialog::eventFilter(QObject* watched, QEvent* event) {
  const QVariant index = watched->property(indexProperty);
  const bool isRow = watched->objectName() == QLatin1String("suggestionRow");
  if (index.isValid() && !m_isSettling &&
      (event->type() == QEvent::FocusIn || (isRow && event->type() == QEvent::Enter)))
    preview(static_cast<std::size_t>(index.toULongLong()));
  if (index.isValid() && (event->type() == QEvent::FocusOut || (isRow && event->type() == QEvent::Leave)))
    preview(std::nullopt);
  return QDialog::eventFilter(watched, event);
}

void SuggestionDialog::hideEvent(QHideEvent* event) {
  preview(std::nullopt);
  QDialog::hideEvent(event);
}

void SuggestionDialog::preview(const std::optional<std::size_t>& index) {
  if (index == m_previewed)
    return;
  m_previewed = index;
  emit previewed(index);
}

} // namespace limn
