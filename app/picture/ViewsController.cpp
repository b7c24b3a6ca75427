// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ViewsController.h"

#include "app/window/WindowContext.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

constexpr qsizetype mostKeys = 9; // Alt with a digit
constexpr int mostInMenu = 30;    // letters, beside the keys
constexpr int keptToldForMs = 6000;

QString nameOfView(const NamedView& view) {
  return QString::fromStdString(view.name);
}

auto viewNamed(std::vector<NamedView>& views, const QString& name) {
  return std::ranges::find(views, name.toStdString(), &NamedView::name);
}

// "View 1", the first that is free.
QString freeName(std::vector<NamedView> views) {
  for (int number = 1;; ++number)
    if (const QString name = ViewsController::tr("View %1").arg(number);
        viewNamed(views, name) == views.end())
      return name;
}

} // namespace

QString shortName(const NamedView& view, int mostLetters) {
  const QString name = nameOfView(view).simplified();
  return name.size() <= mostLetters ? name : name.left(mostLetters - 1).trimmed() + QChar(0x2026);
}

ViewsDialog::ViewsDialog(QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_note(new QLabel(this)),
      m_look(new QPushButton(tr("&Look from there"), this)), m_rename(new QPushButton(tr("&Rename"), this)),
      m_delete(new QPushButton(tr("&Delete"), this)) {
  setWindowTitle(tr("Kept views"));
  m_list->setAccessibleName(tr("Kept views"));
  m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  m_list->setTextElideMode(Qt::ElideMiddle);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_note->setWordWrap(true);
  m_look->setToolTip(tr("Enter or a double click does the same."));
  m_rename->setToolTip(tr("F2 does the same."));
  m_delete->setToolTip(tr("Delete does the same; undo brings it back."));
  m_look->setDefault(true);
  auto* close = new QPushButton(tr("Close"), this);
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {m_look, m_rename, m_delete})
    row->addWidget(button);
  row->addStretch();
  row->addWidget(close);
  auto* column = new QVBoxLayout(this);
  column->addWidget(m_list);
  column->addWidget(m_note);
  column->addLayout(row);
  const auto* erase = new QShortcut(QKeySequence::Delete, m_list, nullptr, nullptr, Qt::WidgetShortcut);
  connect(erase, &QShortcut::activated, this, &ViewsDialog::remove);
  // Once its editor is closed, which until then holds the item.
  connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
    QMetaObject::invokeMethod(
        this, [this, row = m_list->row(item), name = item->text().simplified()] { rename(row, name); },
        Qt::QueuedConnection);
  });
  connect(m_list, &QListWidget::itemDoubleClicked, this, &ViewsDialog::lookFrom);
  connect(m_list, &QListWidget::currentRowChanged, this, &ViewsDialog::showButtons);
  connect(m_look, &QPushButton::clicked, this, &ViewsDialog::lookFrom);
  connect(m_rename, &QPushButton::clicked, this, [this] { m_list->editItem(m_list->currentItem()); });
  connect(m_delete, &QPushButton::clicked, this, &ViewsDialog::remove);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  resize(420, 320);
  showButtons();
}

void ViewsDialog::setViews(const std::vector<NamedView>& views) {
  m_views = views;
  m_note->setText(views.empty() ? tr("No view is kept. \"Keep this view…\" keeps the one of the picture.")
                                : QString());
  showViews();
}

void ViewsDialog::showViews() {
  const int row = m_list->currentRow();
  const QSignalBlocker quiet(m_list);
  m_list->clear();
  for (const NamedView& view : m_views) {
    auto* item = new QListWidgetItem(nameOfView(view), m_list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
    item->setToolTip(shortName(view, 200).toHtmlEscaped());
  }
  m_list->setCurrentRow(std::clamp(row, m_list->count() > 0 ? 0 : -1, m_list->count() - 1));
  showButtons();
}

void ViewsDialog::showButtons() {
  for (QPushButton* button : {m_look, m_rename, m_delete})
    button->setEnabled(m_list->currentRow() >= 0);
}

// Names that mean nothing, or two, are not taken: the list shows again what is.
void ViewsDialog::rename(int row, const QString& name) {
  std::vector<NamedView> views = m_views;
  if (row < 0 || row >= static_cast<int>(views.size()))
    return;
  NamedView& view = views[static_cast<std::size_t>(row)];
  const QString before = shortName(view);
  const bool isTaken = name != nameOfView(view) && viewNamed(views, name) != views.end();
  m_note->setText(name.isEmpty() ? tr("A view needs a name.")
                  : isTaken      ? tr("Another view has that name; choose one of its own.")
                                 : QString());
  view.name = name.toStdString();
  if (name.isEmpty() || isTaken || views == m_views)
    showViews();
  else
    emit viewsEdited(views, tr("rename view \"%1\"").arg(before));
}

void ViewsDialog::remove() {
  const int row = m_list->currentRow();
  if (row < 0)
    return;
  std::vector<NamedView> views = m_views;
  const QString name = shortName(views[static_cast<std::size_t>(row)]);
  views.erase(views.begin() + row);
  emit viewsEdited(views, tr("delete view \"%1\"").arg(name));
}

void ViewsDialog::lookFrom() {
  if (m_list->currentRow() >= 0)
    emit viewChosen(m_views[static_cast<std::size_t>(m_list->currentRow())].camera);
}

ViewsController::ViewsController(WindowContext& context, QMenu& menu)
    : QObject(&context.window), m_context(context), m_menu(menu), m_actions(context.actions.addGroup()),
      m_keep(context.actions.add(
          QStringLiteral("keepView"),
          {.text = tr("&Keep this view…"),
           .toolTip = tr("Keeps from where the picture is seen, under a name. Sessions and scenes keep it."),
           .needsVolume = true})),
      m_manage(context.actions.add(QStringLiteral("manageViews"),
                                   {.text = tr("Re&name or delete views…"),
                                    .toolTip = tr("Lists the views that were kept of this volume.")})) {
  m_actions->addAction(m_keep);
  menu.addSeparator();
  menu.addActions({m_keep, m_manage});
  m_manage->setEnabled(false);
  connect(m_keep, &QAction::triggered, this, &ViewsController::askForName);
  connect(m_manage, &QAction::triggered, this, &ViewsController::manage);
  connect(&context.session, &Session::viewsChanged, this, &ViewsController::showViews);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

void ViewsController::askForName() {
  if (!m_context.session.scene().volume)
    return;
  auto* dialog = new QInputDialog(&m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Keep this view"));
  dialog->setLabelText(tr("Name (a view of the same name is replaced):"));
  dialog->setTextValue(freeName(m_context.session.views()));
  dialog->setOkButtonText(tr("Keep"));
  const auto* buttons = dialog->findChild<QDialogButtonBox*>();
  connect(dialog, &QInputDialog::textValueChanged, buttons, [buttons](const QString& entered) {
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!entered.trimmed().isEmpty());
  });
  connect(dialog, &QInputDialog::textValueSelected, this, &ViewsController::keep);
  dialog->open();
}

void ViewsController::keep(const QString& name) {
  const NamedView view{name.simplified().toStdString(), m_context.session.scene().camera};
  if (view.name.empty() || !m_context.session.scene().volume)
    return;
  std::vector<NamedView> views = m_context.session.views();
  const auto before = viewNamed(views, nameOfView(view));
  if (before != views.end())
    *before = view;
  else
    views.push_back(view);
  m_context.session.setViews(views, tr("keep view \"%1\"").arg(shortName(view)));
  m_context.window.statusBar()->showMessage(
      tr("Kept. View ▸ Look from has \"%1\", Alt+1 … Alt+9 look from the first nine.").arg(shortName(view)),
      keptToldForMs);
}

void ViewsController::manage() {
  if (!m_dialog) {
    m_dialog = new ViewsDialog(&m_context.window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &ViewsDialog::viewChosen, this, &ViewsController::viewChosen);
    connect(m_dialog, &ViewsDialog::viewsEdited, &m_context.session, &Session::setViews);
    m_dialog->setViews(m_context.session.views());
  }
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
}

// Those of before go once the menu that may have chosen one is done.
void ViewsController::showViews(const std::vector<NamedView>& views) {
  for (QAction* action : m_actions->actions())
    if (action != m_keep) {
      m_actions->removeAction(action);
      m_menu.removeAction(action);
      action->deleteLater();
    }
  for (const NamedView& view : views) {
    auto* action =
        new QAction(shortName(view, mostInMenu).replace(QLatin1Char('&'), QStringLiteral("&&")), m_actions);
    m_menu.insertAction(m_manage, action);
    m_actions->addAction(action);
    if (const qsizetype number = m_actions->actions().size() - 1; number <= mostKeys)
      action->setShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_0 + number)));
    connect(action, &QAction::triggered, this, [this, camera = view.camera] { emit viewChosen(camera); });
  }
  m_manage->setEnabled(!views.empty());
  if (m_dialog)
    m_dialog->setViews(views);
}

void ViewsController::showScene(const Scene& scene) {
  if (m_dialog && !scene.volume)
    m_dialog->close();
}

} // namespace limn
