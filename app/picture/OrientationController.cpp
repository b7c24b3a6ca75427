// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/OrientationController.h"

#include "app/window/WindowContext.h"
#include "regions/Cutting.h"
#include "scene/view/Camera.h"
#include "scene/volume/Orientation.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/view/CompareView.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

constexpr std::array<char, 6> directions{'L', 'R', 'P', 'A', 'S', 'I'};

QString directionName(char letter) {
  switch (letter) {
  case 'L':
    return OrientationDialog::tr("Left");
  case 'R':
    return OrientationDialog::tr("Right");
  case 'P':
    return OrientationDialog::tr("Back");
  case 'A':
    return OrientationDialog::tr("Front");
  case 'S':
    return OrientationDialog::tr("Head");
  default:
    return OrientationDialog::tr("Feet");
  }
}

// The letter of the other end: "LR", "PA" and "SI" are neighbours.
char opposite(char letter) {
  const auto place =
      static_cast<std::size_t>(std::find(directions.begin(), directions.end(), letter) - directions.begin());
  return directions[place ^ 1u];
}

// Where a standard view stands of voxels that tell no sides: "From the first row".
QString voxelViewName(const Grid& grid, StandardView view) {
  const Camera camera = standardView({}, grid, view);
  const glm::dvec3 from = glm::transpose(grid.direction) * (camera.position - camera.target);
  const glm::dvec3 size = glm::abs(from);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const bool isLast = from[axis] > 0.0;
  switch (axis) {
  case 0:
    return isLast ? OrientationController::tr("From the last column")
                  : OrientationController::tr("From the first column");
  case 1:
    return isLast ? OrientationController::tr("From the last row")
                  : OrientationController::tr("From the first row");
  default:
    return isLast ? OrientationController::tr("From the last slice")
                  : OrientationController::tr("From the first slice");
  }
}

// As a menu shows it. The key is the picture's own (ViewCommands): as a shortcut of the menu it would act
// wherever menus have the keyboard, where letters choose entries.
QString withKey(const QString& text, const QKeySequence& key) {
  return text + QLatin1Char('\t') + key.toString(QKeySequence::NativeText);
}

// The scene with its voxels where `volume` has them; what was cut by hand stays cut.
Scene lyingAs(Scene scene, const std::shared_ptr<const Volume>& volume) {
  scene.keep.cuts = cutsMoved(scene.keep.cuts, scene.volume->grid(), volume->grid());
  scene.volume = volume;
  return scene;
}

} // namespace

OrientationDialog::OrientationDialog(const std::string& letters, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Orientation of the volume"));
  auto* column = new QVBoxLayout(this);
  auto* note = new QLabel(
      tr("The file does not say how its voxels lie in the patient. Say where each axis runs to; the "
         "picture follows. A wrong answer swaps left and right: compare with something known."));
  note->setWordWrap(true);
  column->addWidget(note);
  auto* grid = new QGridLayout;
  const std::array names{tr("Columns run to"), tr("Rows run to"), tr("Slices run to")};
  for (std::size_t axis = 0; axis < m_boxes.size(); ++axis) {
    const int row = static_cast<int>(axis);
    auto* label = new QLabel(names[axis]);
    auto* box = m_boxes[axis] = new QuietComboBox;
    for (const char letter : directions)
      box->addItem(directionName(letter), letter);
    box->setAccessibleName(names[axis]);
    label->setBuddy(box);
    auto* flipped = new QPushButton(tr("Flip"));
    flipped->setAutoDefault(false);
    flipped->setAccessibleName(tr("Flip: %1").arg(names[axis]));
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1);
    grid->addWidget(flipped, row, 2);
    connect(box, &QComboBox::activated, this,
            [this, axis, box] { choose(axis, static_cast<char>(box->currentData().toInt())); });
    connect(flipped, &QPushButton::clicked, this, [this, axis] { flip(axis); });
  }
  column->addLayout(grid);
  auto* buttons = new QDialogButtonBox(this);
  auto* use = buttons->addButton(tr("Keep"), QDialogButtonBox::AcceptRole);
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  column->addWidget(buttons);
  connect(use, &QPushButton::clicked, this, [this] { emit lettersChosen(m_letters); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setLetters(letters);
}

void OrientationDialog::setLetters(const std::string& letters) {
  m_letters = letters;
  for (std::size_t axis = 0; axis < m_boxes.size(); ++axis)
    m_boxes[axis]->setCurrentIndex(m_boxes[axis]->findData(letters[axis]));
}

// Whichever axis ran along this direction takes the one that gets free.
void OrientationDialog::choose(std::size_t axis, char letter) {
  std::string next = m_letters;
  for (char& other : next)
    if (other == letter || other == opposite(letter))
      other = next[axis];
  next[axis] = letter;
  setLetters(next);
  emit lettersChosen(next);
}

void OrientationDialog::flip(std::size_t axis) {
  choose(axis, opposite(m_letters[axis]));
}

OrientationController::OrientationController(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_menu(context.actions.addMenu(tr("&Look from"), {Menu::view, 2, 5})),
      m_views(context.actions.addGroup()) {
  ActionList& actions = context.actions;
  addViews(*m_menu);
  m_menu->addSeparator();
  QAction* reset = actions.add(QStringLiteral("resetCamera"),
                               {.text = withKey(tr("Reset camera"), Qt::Key_R), .needsVolume = true});
  m_setOrientation =
      actions.add(QStringLiteral("setOrientation"),
                  {.text = tr("Set &orientation…"),
                   .toolTip = tr("Says which side is left where the volume's file does not.")});
  m_menu->addActions({reset, &actions.find("cameraBack"), &actions.find("cameraForward")});
  m_menu->addSeparator();
  m_menu->addActions({m_setOrientation, addCube()});
  m_setOrientation->setEnabled(false);
  QToolButton* button = actions.makeMenuButton({}, QToolButton::InstantPopup);
  button->setText(tr("Look from"));
  actions.giveIcon(*button, QStringLiteral("compass"));
  connect(reset, &QAction::enabledChanged, button, &QWidget::setEnabled); // without a volume
  actions.addMenuButton(*button, m_menu, {6, 2});
  connect(reset, &QAction::triggered, &context.view, &CompareView::resetCamera);
  connect(m_setOrientation, &QAction::triggered, this, &OrientationController::ask);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { showScene(scene); });
}

void OrientationController::addViews(QMenu& menu) {
  const auto add = [this](StandardView view, const char* name, const QString& text, const QKeySequence& key) {
    m_context.actions
        .addChoice(*m_views, QStringLiteral("view-") + QLatin1String(name), static_cast<int>(view),
                   {.text = withKey(text, key), .needsVolume = true})
        ->setCheckable(false);
    m_viewNames << text;
    m_viewKeys << key;
  };
  add(StandardView::anterior, "anterior", tr("Anterior (front)"), Qt::Key_A);
  add(StandardView::posterior, "posterior", tr("Posterior (back)"), Qt::Key_P);
  add(StandardView::left, "left", tr("Left"), Qt::Key_L);
  add(StandardView::right, "right", tr("Right"), QKeySequence(Qt::SHIFT | Qt::Key_PageDown));
  add(StandardView::superior, "superior", tr("Superior (above)"), Qt::Key_S);
  add(StandardView::inferior, "inferior", tr("Inferior (below)"), Qt::Key_I);
  menu.addActions(m_views->actions());
  connect(m_views, &QActionGroup::triggered, this, [this](const QAction* chosen) {
    m_context.view.lookFrom(static_cast<StandardView>(chosen->data().toInt()));
  });
}

QAction* OrientationController::addCube() {
  QAction* cube = m_context.actions.add(
      QStringLiteral("orientationCube"),
      {.text = tr("Show orientation &cube"),
       .toolTip = tr("A cube in the picture shows how it lies; a click on a face looks from there."),
       .isCheckable = true});
  cube->setChecked(m_context.settings.cubeIsShown());
  m_context.view.setCubeVisible(cube->isChecked());
  connect(cube, &QAction::triggered, this, [this](bool isShown) {
    m_context.view.setCubeVisible(isShown);
    m_context.settings.setCubeIsShown(isShown);
  });
  return cube;
}

void OrientationController::showScene(const Scene& scene) {
  if (scene.volume == m_volume)
    return;
  m_volume = scene.volume;
  const bool isKnown = !m_volume || m_volume->info().orientationKnown;
  const bool isByHand = m_volume && !m_volume->info().orientationByHand.empty();
  m_setOrientation->setEnabled(!isKnown || isByHand);
  for (qsizetype i = 0; i < m_viewNames.size(); ++i) {
    QAction* action = m_views->actions()[i];
    const QString name =
        isKnown ? m_viewNames[i]
                : voxelViewName(m_volume->grid(), static_cast<StandardView>(action->data().toInt()));
    action->setText(withKey(name, m_viewKeys[i]));
  }
  if (m_dialog && !m_setOrientation->isEnabled())
    m_dialog->close();
  else if (m_dialog)
    m_dialog->setLetters(axisLettersOf(m_volume->grid()));
}

void OrientationController::ask() {
  if (!m_volume || !m_setOrientation->isEnabled())
    return;
  if (!m_dialog) {
    m_dialog = new OrientationDialog(axisLettersOf(m_volume->grid()), &m_context.window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &OrientationDialog::lettersChosen, this, &OrientationController::orient);
    connect(m_dialog, &QDialog::rejected, this, &OrientationController::takeBack);
    m_asFound = m_volume;
    m_answered.reset();
  }
  m_dialog->show();
  m_dialog->raise();
}

void OrientationController::orient(const std::string& letters) {
  if (!m_volume || m_volume->info().orientationByHand == letters)
    return;
  const Scene next = lyingAs(m_context.session.scene(), m_answered = orientedByHand(*m_volume, letters));
  m_context.session.edit(next,
                         {nextGestureId(), tr("set orientation %1").arg(QString::fromStdString(letters))});
}

// Whatever was shown on trial goes, unless something else has taken its place.
void OrientationController::takeBack() {
  if (!m_answered || m_context.session.scene().volume != m_answered)
    return;
  const Scene next = lyingAs(m_context.session.scene(), m_asFound);
  m_context.session.edit(next, {nextGestureId(), tr("take back the orientation")});
}

} // namespace limn
