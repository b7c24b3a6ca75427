// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/OrientationDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
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
    auto* box = m_boxes[axis] = new QComboBox;
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

} // namespace limn
