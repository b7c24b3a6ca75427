// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/PictureDialog.h"

#include "app/document/Settings.h"
#include "app/files/saving/DrawingTime.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/TimeLeft.h"
#include "widgets/theme/Icons.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double cmPerInch = 2.54;
constexpr double narrowestCm = 2.0;
constexpr double widestCm = 60.0;
constexpr int narrowest = 16;      // pixels
constexpr int longestSide = 16384; // of a picture in a file, pixels: more than drivers draw at once
constexpr int tallest = 99999;     // that a height is told of, which follows from a width
constexpr int askedAgainMs = 250;
constexpr int changesPaths = 2; // what the dialog ends with beside Accepted and Rejected

QString wordOf(int number) {
  return QString::number(number);
}

} // namespace

bool hasOwnShape(const PictureOptions& options) {
  return options.size == PictureOptions::Size::pixels && !options.keepsShape;
}

double scaleOf(const PictureOptions& options, const QSize& screen) {
  switch (options.size) {
  case PictureOptions::Size::screen:
    return 1.0;
  case PictureOptions::Size::twice:
    return 2.0;
  case PictureOptions::Size::fourTimes:
    return 4.0;
  case PictureOptions::Size::print:
    return options.printCm / cmPerInch * printDotsPerInch / std::max(1, screen.width());
  case PictureOptions::Size::pixels:
    return options.keepsShape ? double(options.widthPixels) / std::max(1, screen.width())
                              : double(options.heightPixels) / std::max(1, screen.height());
  }
  return 1.0;
}

QSize sizeInFile(const PictureOptions& options, const QSize& screen, int beside) {
  const double scale = scaleOf(options, screen);
  const double width = hasOwnShape(options) ? options.widthPixels : screen.width() * scale;
  return {beside * std::max(1, qRound(width / beside)), std::max(1, qRound(screen.height() * scale))};
}

QString writtenOptions(const PictureOptions& options) {
  const SavedMarks& marks = options.marks;
  QStringList words{wordOf(static_cast<int>(options.size)), QString::number(options.printCm),
                    wordOf(static_cast<int>(options.ground))};
  for (const bool mark : {marks.names, marks.letters, marks.scale, marks.warning, marks.measurements})
    words << wordOf(mark ? 1 : 0);
  words << wordOf(options.widthPixels) << wordOf(options.heightPixels) << wordOf(options.keepsShape ? 1 : 0);
  return words.join(QLatin1Char(' '));
}

PictureOptions readOptions(const QString& text) {
  const QStringList words = text.split(QLatin1Char(' '));
  PictureOptions options;
  if (words.size() < 8)
    return options;
  options.size = static_cast<PictureOptions::Size>(std::clamp(words[0].toInt(), 0, 4));
  if (const double cm = words[1].toDouble(); cm >= narrowestCm && cm <= widestCm)
    options.printCm = cm;
  options.ground = static_cast<PictureOptions::Ground>(std::clamp(words[2].toInt(), 0, 3));
  SavedMarks& marks = options.marks;
  int at = 3;
  for (bool* mark : {&marks.names, &marks.letters, &marks.scale, &marks.warning, &marks.measurements})
    *mark = words[at++].toInt() != 0;
  for (int* side : {&options.widthPixels, &options.heightPixels})
    if (const int pixels = words.value(at++).toInt(); pixels >= narrowest && pixels <= longestSide)
      *side = pixels;
  options.keepsShape = words.value(at) != QStringLiteral("0");
  return options;
}

QString groundRemark(const QString& path, const PictureOptions& options) {
  const QFileInfo file(path);
  const QString ending = file.suffix().toLower();
  const bool isJpeg = ending == QLatin1String("jpg") || ending == QLatin1String("jpeg");
  if (!isJpeg || options.ground != PictureOptions::Ground::transparent)
    return {};
  return PictureDialog::tr("%1 has the ground of the screen: JPEG knows no transparent one. Save the picture "
                           "as PNG to have none.")
      .arg(file.fileName());
}

PictureDialog::PictureDialog(const PictureOptions& options, const QSize& screen, QWidget* parent,
                             PictureKind kind, const DrawingTold& told)
    : QDialog(parent), m_screen(screen), m_told(told), m_size(new QuietComboBox(this)),
      m_cm(new NumberField(narrowestCm, widestCm, 1, this)),
      m_width(new NumberField(narrowest, longestSide, 0, this)),
      m_height(new NumberField(narrowest, longestSide, 0, this)), m_shape(new QToolButton(this)),
      m_ground(new QuietComboBox(this)), m_pixels(new QLabel(this)) {
  setObjectName(QStringLiteral("pictureDialog"));
  setWindowTitle(kind == PictureKind::slice ? tr("Save the slice") : tr("Save the picture"));
  m_pixels->setObjectName(QStringLiteral("picturePixels"));
  prepareSize(options);
  m_ground->setObjectName(QStringLiteral("pictureGround"));
  m_ground->addItems({tr("As on screen"), tr("White"), tr("Black"), tr("Transparent")});
  m_ground->setCurrentIndex(static_cast<int>(options.ground));
  m_ground->setToolTip(tr("What stands behind the tissue. JPEG knows no transparent ground."));

  auto* form = new QFormLayout;
  if (!told.remark.isEmpty())
    addRemark(*form);
  form->addRow(tr("Si&ze"), m_size);
  form->addRow(tr("&Width"), m_cm);
  form->addRow(tr("&Width"), m_width);
  form->addRow(tr("&Height"), m_height);
  form->addRow(QString(), m_shape);
  form->addRow(QString(), m_pixels);
  if (!told.paths.isEmpty())
    addPaths(*form);
  form->addRow(tr("&Ground"), m_ground);
  form->setRowVisible(m_ground, kind == PictureKind::view);
  auto* marks = new QVBoxLayout;
  form->addRow(tr("With it"), marks);
  const SavedMarks& on = options.marks;
  addMark("pictureNames",
          kind == PictureKind::slice ? tr("&Names: plane, place, window")
                                     : tr("Model &names, and what is hidden"),
          on.names);
  addMark("pictureLetters", tr("&Letters of the sides (R, L, …)"), on.letters);
  addMark("pictureScale", tr("Scale &bar"), on.scale);
  addMark("pictureWarning", tr("\"Not for &diagnosis\""), on.warning);
  addMark("pictureMeasurements", tr("&Measurements"), on.measurements);
  for (QCheckBox* mark : m_marks)
    marks->addWidget(mark);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
  save->setObjectName(QStringLiteral("pictureSave"));
  save->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(buttons);
  column->setSizeConstraint(QLayout::SetFixedSize); // no gap where a row goes
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  m_again.setSingleShot(true);
  connect(&m_again, &QTimer::timeout, this, &PictureDialog::tellSize);
  connect(m_size, &QComboBox::currentIndexChanged, this, [this, form] { showSize(*form); });
  for (const NumberField* side : {m_cm, m_width, m_height})
    connect(side, &NumberField::numberEdited, this, &PictureDialog::tellSize);
  connect(m_shape, &QToolButton::toggled, this, [this, form] { showSize(*form); });
  showSize(*form);
}

void PictureDialog::prepareSize(const PictureOptions& options) {
  m_size->setObjectName(QStringLiteral("pictureSize"));
  m_size->addItems({tr("As on screen"), tr("Twice as large"), tr("Four times as large"),
                    tr("For print, 300 dpi"), tr("Size in pixels")});
  m_size->setCurrentIndex(static_cast<int>(options.size));
  m_cm->setObjectName(QStringLiteral("pictureWidth"));
  m_cm->setSuffix(QChar(0x00a0) + tr("cm"));
  m_cm->setAccessibleName(tr("Width on paper"));
  m_cm->setNumber(options.printCm);
  m_width->setObjectName(QStringLiteral("pictureWidthPixels"));
  m_width->setAccessibleName(tr("Width in pixels"));
  m_width->setNumber(options.widthPixels);
  m_height->setObjectName(QStringLiteral("pictureHeightPixels"));
  m_height->setAccessibleName(tr("Height in pixels"));
  m_height->setNumber(options.heightPixels);
  for (NumberField* side : {m_width, m_height}) {
    side->setSuffix(QChar(0x00a0) + tr("pixels"));
    side->setToolTip(tr("From %1 to %2 pixels.").arg(narrowest).arg(longestSide));
  }
  m_shape->setObjectName(QStringLiteral("pictureShape"));
  m_shape->setText(tr("Shape of the &view"));
  m_shape->setToolTip(
      tr("Locked: the height follows from the width. Unlocked: the picture shows as much from top to "
         "bottom as on screen, and at the sides what fits."));
  m_shape->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_shape->setCheckable(true);
  m_shape->setChecked(options.keepsShape);
}

// A height that follows is told, whatever it is; one that is chosen lies within what can be drawn.
void PictureDialog::showSize(QFormLayout& form) {
  const auto size = static_cast<PictureOptions::Size>(m_size->currentIndex());
  const bool isInPixels = size == PictureOptions::Size::pixels;
  form.setRowVisible(m_cm, size == PictureOptions::Size::print);
  form.setRowVisible(m_width, isInPixels);
  form.setRowVisible(m_height, isInPixels);
  form.setRowVisible(m_shape, isInPixels);
  const bool isFree = !m_shape->isChecked();
  m_height->setEnabled(isFree);
  m_height->setLimits(isFree ? narrowest : 1, isFree ? longestSide : tallest, 0);
  if (isFree)
    m_height->setNumber(std::clamp(m_height->number(), double(narrowest), double(longestSide)));
  showLock();
  tellSize();
}

void PictureDialog::showLock() {
  m_shape->setIcon(themedIcon(m_shape->isChecked() ? QStringLiteral("lock") : QStringLiteral("lock-open"),
                              m_shape->palette()));
}

void PictureDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    showLock();
}

void PictureDialog::addRemark(QFormLayout& form) {
  auto* remark = new QLabel(m_told.remark, this);
  remark->setObjectName(QStringLiteral("pictureRemark"));
  remark->setWordWrap(true);
  form.addRow(remark);
}

// They stand among the properties of light, which the dialog is in the way of.
void PictureDialog::addPaths(QFormLayout& form) {
  auto* paths =
      new QLabel(QStringLiteral("%1 · <a href=\"#\">%2</a>").arg(m_told.paths, tr("Change…")), this);
  paths->setObjectName(QStringLiteral("picturePaths"));
  paths->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  paths->setToolTip(
      tr("How far pictures of physical light that are saved are drawn; it is set in Properties."));
  form.addRow(tr("Physical light"), paths);
  connect(paths, &QLabel::linkActivated, this, [this] {
    connect(this, &QDialog::finished, this, m_told.changePaths);
    done(changesPaths);
  });
}

void PictureDialog::addMark(const char* name, const QString& text, bool isOn) {
  auto* mark = new QCheckBox(text, this);
  mark->setObjectName(QLatin1String(name));
  mark->setChecked(isOn);
  m_marks.push_back(mark);
}

PictureOptions PictureDialog::options() const {
  PictureOptions options;
  options.size = static_cast<PictureOptions::Size>(m_size->currentIndex());
  options.printCm = m_cm->number();
  options.widthPixels = qRound(m_width->number());
  options.heightPixels = qRound(m_height->number());
  options.keepsShape = m_shape->isChecked();
  options.ground = static_cast<PictureOptions::Ground>(m_ground->currentIndex());
  options.marks = {m_marks[0]->isChecked(), m_marks[1]->isChecked(), m_marks[2]->isChecked(),
                   m_marks[3]->isChecked(), m_marks[4]->isChecked()};
  return options;
}

void PictureDialog::tellSize() {
  const QSize size = sizeInFile(options(), m_screen, m_told.beside);
  if (m_shape->isChecked())
    m_height->setNumber(size.height());
  const std::optional<double> known = m_told.seconds ? m_told.seconds(size) : 0.0;
  const double seconds = known.value_or(0.0);
  const bool fits = std::max(size.width(), size.height()) <= longestSide;
  const QString pixels = tr("%1 × %2 pixels").arg(size.width()).arg(size.height());
  m_pixels->setText(fits && seconds >= longSeconds
                        ? tr("%1, %2 to draw", "pixels, a time").arg(pixels, aboutText(seconds))
                    : fits && !known ? tr("%1, the time to draw is being estimated", "pixels").arg(pixels)
                    : fits           ? pixels
                                     : tr("%1 × %2 pixels: more than %3 a side cannot be drawn")
                                 .arg(size.width())
                                 .arg(size.height())
                                 .arg(longestSide));
  if (!known)
    m_again.start(askedAgainMs);
  if (auto* save = findChild<QPushButton*>(QStringLiteral("pictureSave")))
    save->setEnabled(fits);
}

std::optional<PictureOptions> askHowToSave(const QSize& screen, Settings& settings, QWidget* parent,
                                           PictureKind kind, const DrawingTold& told) {
  PictureDialog dialog(readOptions(settings.pictureOptions()), screen, parent, kind, told);
  const int answer = dialog.exec();
  if (answer == QDialog::Rejected)
    return std::nullopt;
  // Whoever goes to change the paths comes back to what was chosen here.
  settings.setPictureOptions(writtenOptions(dialog.options()));
  return answer == QDialog::Accepted ? std::optional(dialog.options()) : std::nullopt;
}

} // namespace limn
