// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/DialogController.h"

#include "app/frame/dialogs/MouseAndKeys.h"
#include "app/frame/dialogs/WindowsAbove.h"
#include "app/guide/GuideWindow.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/DialogRoom.h"
#include "widgets/theme/Icons.h"

#include <QApplication>
#include <QCheckBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

QString lastLine(const QByteArray& text) {
  return QString::fromUtf8(text).trimmed().section(QLatin1Char('\n'), -1);
}

QString withoutMnemonic(QString text) {
  return text.remove(QLatin1Char('&'));
}

void showChoice(QComboBox& box, const QActionGroup& group) {
  const QSignalBlocker quiet(box);
  const QList<QAction*> actions = group.actions();
  box.clear();
  for (qsizetype i = 0; i < actions.size(); ++i) {
    box.addItem(withoutMnemonic(actions[i]->text()));
    box.setItemData(static_cast<int>(i), actions[i]->toolTip(), Qt::ToolTipRole);
    if (!actions[i]->isEnabled())
      static_cast<QStandardItemModel*>(box.model())->item(static_cast<int>(i))->setEnabled(false);
    if (actions[i]->isChecked())
      box.setCurrentIndex(static_cast<int>(i));
  }
}

} // namespace

void showAbout(QWidget* parent) {
  const QString text =
      QObject::tr("<h3>Limn %1</h3><p>Shows CT and MR volumes in three dimensions: you shape which tissue is "
                  "seen, in which colour and how solid, and compare ways of lighting it side by "
                  "side.</p><p><b>Not for diagnosis.</b></p><p>Free software under the GNU General Public "
                  "License, version 3 or later.</p>")
          .arg(QStringLiteral(LIMN_VERSION));
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Limn"), text, QMessageBox::Close, parent);
  box->setIconPixmap(programIcon().pixmap(QSize(64, 64), parent->devicePixelRatioF()));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::NonModal);
  box->show();
}

StabilityDialog::StabilityDialog(const QString& program, const QString& folder, QWidget* parent)
    : QDialog(parent), m_program(program), m_folder(folder), m_text(new QLabel(this)),
      m_bar(new QProgressBar(this)), m_start(new QPushButton(tr("Check"), this)),
      m_stop(new QPushButton(tr("Stop"), this)), m_open(new QPushButton(tr("Open the report"), this)) {
  setWindowTitle(tr("Stability checks"));
  m_text->setWordWrap(true);
  m_text->setMinimumWidth(420);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setText(
      tr("Checks the graphics driver of this computer with pictures whose right result is known. Takes some "
         "minutes; you can go on working."));
  m_bar->setRange(0, 0);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(tr("Checking"));
  auto* row = new QHBoxLayout;
  row->addStretch();
  for (QPushButton* button : {m_open, m_stop, m_start})
    row->addWidget(button);
  auto* close = new QPushButton(tr("Close"), this);
  close->setToolTip(tr("Running checks go on."));
  row->addWidget(close);
  m_start->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addLayout(row);
  showRunning(false);
  m_open->hide();
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_start, &QPushButton::clicked, this, &StabilityDialog::start);
  connect(m_stop, &QPushButton::clicked, &m_process, &QProcess::kill);
  connect(m_open, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QDir(m_folder).filePath(QStringLiteral("stability.html"))));
  });
  connect(&m_process, &QProcess::finished, this, &StabilityDialog::showEnd);
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart)
      return; // finished tells
    showRunning(false);
    m_text->setText(tr("The checks could not be started: %1.").arg(m_process.errorString()));
  });
}

// Nobody is told of its end any more.
StabilityDialog::~StabilityDialog() {
  m_process.disconnect(this);
  m_process.kill();
  m_process.waitForFinished();
}

void StabilityDialog::start() {
  m_open->hide();
  m_text->setText(tr("Checking…"));
  showRunning(true);
  m_process.start(m_program, {QStringLiteral("stability"), QStringLiteral("-o"), m_folder});
}

void StabilityDialog::showEnd(int exitCode, QProcess::ExitStatus status) {
  showRunning(false);
  const QString summary = lastLine(m_process.readAllStandardOutput());
  const QString error = lastLine(m_process.readAllStandardError());
  if (status == QProcess::CrashExit)
    m_text->setText(tr("The checks ended before they were complete, by you or by the driver."));
  else
    m_text->setText(exitCode == 0 || error.isEmpty() ? summary : summary + QLatin1Char('\n') + error);
  m_open->setVisible(status == QProcess::NormalExit &&
                     QDir(m_folder).exists(QStringLiteral("stability.html")));
}

void StabilityDialog::showRunning(bool runs) {
  m_bar->setVisible(runs);
  m_stop->setVisible(runs);
  m_start->setVisible(!runs);
}

SettingsDialog::SettingsDialog(const ActionList& actions, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Settings"));
  auto* rows = new QGridLayout(this); // boxes of one width
  rows->setColumnStretch(1, 1);
  rows->setSizeConstraint(QLayout::SetFixedSize); // follows what is said below a choice
  const auto addWhole = [&](QWidget* widget) { rows->addWidget(widget, rows->rowCount(), 0, 1, 2); };
  for (const ActionList::Setting& setting : actions.settings()) {
    if (setting.choice) {
      auto* label = new QLabel(setting.label);
      QComboBox* box = choiceOf(*setting.choice, setting.label);
      label->setBuddy(box);
      rows->addWidget(label, rows->rowCount(), 0);
      rows->addWidget(box, rows->rowCount() - 1, 1);
      if (!setting.consequence.isEmpty())
        rows->addWidget(consequenceOf(setting), rows->rowCount(), 1);
    } else if (setting.action->isCheckable()) {
      addWhole(switchOf(*setting.action));
    } else {
      addWhole(buttonOf(*setting.action));
    }
  }
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  addWhole(buttons);
}

QComboBox* SettingsDialog::choiceOf(QActionGroup& group, const QString& name) {
  auto* box = new QuietComboBox;
  box->setMinimumWidth(220); // all alike
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  showChoice(*box, group);
  for (QAction* action : group.actions())
    connect(action, &QAction::changed, box, [box, &group] { showChoice(*box, group); });
  connect(box, &QComboBox::activated, this, [&group](int index) { group.actions()[index]->trigger(); });
  return box;
}

QLabel* SettingsDialog::consequenceOf(const ActionList::Setting& setting) {
  auto* label = new QLabel(setting.consequence);
  label->setWordWrap(true);
  label->hide();
  connect(setting.choice, &QActionGroup::triggered, label, &QWidget::show);
  return label;
}

QPushButton* SettingsDialog::buttonOf(QAction& action) {
  auto* button = new QPushButton(action.text());
  button->setAutoDefault(false);
  button->setToolTip(action.toolTip());
  connect(button, &QPushButton::clicked, &action, &QAction::trigger);
  return button;
}

QCheckBox* SettingsDialog::switchOf(QAction& action) {
  auto* box = new QCheckBox(withoutMnemonic(action.text()));
  box->setToolTip(action.toolTip());
  box->setChecked(action.isChecked());
  connect(&action, &QAction::toggled, box, &QCheckBox::setChecked);
  connect(box, &QCheckBox::clicked, &action, &QAction::trigger);
  return box;
}

// Of its own: a box that was opened has its list inside.
int SettingsDialog::fieldInHand() const {
  return static_cast<int>(findChildren<QWidget*>(Qt::FindDirectChildrenOnly).indexOf(focusWidget()));
}

void SettingsDialog::takeInHand(int field) {
  if (QWidget* taken = findChildren<QWidget*>(Qt::FindDirectChildrenOnly).value(field))
    taken->setFocus();
}

DialogController::DialogController(WindowContext& context) : QObject(&context.window), m_context(context) {
  qApp->installEventFilter(new DialogRoom(this));
  new WindowsAbove(context.window);
  QAction* settings =
      context.actions.add(QStringLiteral("settings"),
                          {.text = tr("&Settings…"), .place = {Menu::edit, 3, 1}, .shortcut = tr("Ctrl+,")});
  settings->setMenuRole(QAction::PreferencesRole);
  connect(settings, &QAction::triggered, this, &DialogController::showSettings);
  addHelp();
}

void DialogController::addHelp() {
  ActionList& actions = m_context.actions;
  const QAction* guide =
      actions.add(QStringLiteral("guide"),
                  {.text = tr("&Guide"),
                   .place = {Menu::help, 1, 1},
                   .shortcut = QKeySequence::HelpContents,
                   .toolTip = tr("Opens the guide at what it says of the panel with the keyboard.")});
  QAction* shortcuts =
      actions.add(QStringLiteral("shortcuts"), {.text = tr("Mouse and &keys"), .place = {Menu::help, 1, 3}});
  // Where it is typed with Shift, a keyboard may tell that as well.
  shortcuts->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(Qt::SHIFT | Qt::Key_Question)});
  const QAction* stability = actions.add(
      QStringLiteral("stability"),
      {.text = tr("&Stability checks…"),
       .place = {Menu::help, 1, 4},
       .toolTip = tr("Checks what this computer's driver draws where renderers are known to fail.")});
  const QAction* about =
      actions.add(QStringLiteral("about"), {.text = tr("&About Limn"), .place = {Menu::help, 1, 5}});
  connect(guide, &QAction::triggered, this,
          [this] { showGuide(guidePlaceOf(m_context.window.focusWidget())); });
  connect(shortcuts, &QAction::triggered, this,
          [this] { showShortcuts(m_context.actions, &m_context.window); });
  connect(stability, &QAction::triggered, this, &DialogController::showStability);
  connect(about, &QAction::triggered, this, [this] { showAbout(&m_context.window); });
}

bool DialogController::isBusy() const {
  const QList<QDialog*> dialogs = m_context.window.findChildren<QDialog*>();
  return (m_stability && m_stability->isChecking()) ||
         std::ranges::any_of(dialogs, [this](const QDialog* dialog) {
           return dialog->isVisible() && dialog != m_settings && dialog != m_guide;
         });
}

DialogController::Memory DialogController::memory() const {
  Memory memory;
  if (m_settings && m_settings->isVisible())
    memory.settingsField = m_settings->fieldInHand();
  if (!m_guide || !m_guide->isVisible())
    return memory;
  const GuideView& page = m_guide->page();
  const int heading = page.headingAtTop();
  memory.guidePlace = heading < 0 ? guidePlaceOf(nullptr) : page.headings()[heading].anchor;
  return memory;
}

void DialogController::takeOver(const Memory& memory) {
  if (memory.guidePlace)
    showGuide(*memory.guidePlace);
  if (memory.settingsField) {
    showSettings();
    m_settings->takeInHand(*memory.settingsField);
  }
}

void DialogController::showSettings() {
  if (!m_settings) {
    m_settings = new SettingsDialog(m_context.actions, &m_context.window);
    m_settings->setAttribute(Qt::WA_DeleteOnClose);
  }
  m_settings->show();
  m_settings->raise();
  m_settings->activateWindow();
}

// It stays while it is hidden: checks go on, and what they found is there when it is opened again.
void DialogController::showStability() {
  if (!m_stability)
    m_stability =
        new StabilityDialog(QCoreApplication::applicationFilePath(),
                            QString::fromStdString(m_context.folders.reports.string()), &m_context.window);
  m_stability->show();
  m_stability->raise();
}

// It stays while it is hidden, where the reader left it.
void DialogController::showGuide(const QString& place) {
  if (!m_guide)
    m_guide = new GuideWindow(&m_context.window);
  m_guide->show();
  m_guide->raise();
  m_guide->activateWindow();
  m_guide->showPlace(place);
}

} // namespace limn
