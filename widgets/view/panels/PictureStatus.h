// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/view/pictures/PictureState.h"

#include <QString>
#include <QWidget>

#include <array>
#include <vector>

class QLabel;
class QToolButton;

namespace limn {

/// How close the pictures on screen come to the exact ones, in parts of one line; parts that are not known
/// are empty. Of several pictures the worst is told.
struct PictureStatusText {
  QString badge;    ///< "preview", "refining", "exact to the screen" or that it is not
  QString estimate; ///< "within 0.7 of 255 levels"
  QString step;     ///< "refined, step 1/16 voxel"
  QString time;     ///< "23 ms"
  QString engine;   ///< "OpenGL" or "processor"
  QString toolTip;  ///< the same for who wants to know exactly, several lines
  bool operator==(const PictureStatusText&) const = default;

  /// The parts in one line, but for the badge.
  QString line() const;
};

/// Of pictures in that state, of a scene.
PictureStatusText pictureStatusText(const PictureState& told, const Scene& scene);

/// A step in units of the smallest voxel spacing: "1/16 voxel", "0.3 voxel", "2 voxels".
QString stepText(double stepVoxels);

/// "23 ms", from a second on "1.9 s".
QString timeText(double ms);

/// An error in 8-bit levels; never "0".
QString levelsText(double levels);

/// Texts as wide as those that commonly stand in each part while a picture moves and refines: with room for
/// them, what is next to a part need not move when it changes.
std::vector<PictureStatusText> commonStatusTexts();

/// Says in the status bar how close the pictures come to the exact ones: one badge, and behind it, when it is
/// pressed, levels and steps. Each part keeps its place while numbers change; where the room is narrow, the
/// parts that matter least are left out.
class PictureStatus : public QWidget {
  Q_OBJECT

public:
  explicit PictureStatus(QWidget* parent = nullptr);

  void setText(const PictureStatusText& text);
  const PictureStatusText& text() const { return m_text; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  static constexpr std::size_t partCount = 5;
  std::array<int, partCount> widths() const;
  void arrange();

  PictureStatusText m_text;
  QToolButton* m_badge;
  std::array<QLabel*, partCount - 1> m_labels{}; ///< estimate, step, time, engine
  std::array<QWidget*, partCount> m_parts{};     ///< the badge and those
  int m_padding = 0;                             ///< that the style gives to a part
};

} // namespace limn
