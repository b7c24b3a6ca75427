// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/SavedOverlay.h"

#include <QDialog>
#include <QSize>
#include <QTimer>

#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace limn {

class NumberField;
class Settings;

/// How a picture of the view is saved.
struct PictureOptions {
  enum class Size { screen, twice, fourTimes, print, pixels };
  enum class Ground { shown, white, black, transparent };

  Size size = Size::screen;
  double printCm = 17.0;   ///< its width on paper, > 0; of `print` alone
  int widthPixels = 1920;  ///< > 0; of `pixels` alone, as are those that follow
  int heightPixels = 1080; ///< > 0; where it need not keep the shape
  bool keepsShape = true;  ///< that it has on screen: the height follows from the width
  Ground ground = Ground::shown;
  SavedMarks marks;
  bool operator==(const PictureOptions&) const = default;
};

/// Dots per inch of a picture for print, as journals ask for.
inline constexpr double printDotsPerInch = 300.0;

/// Whether a picture has another shape in its file than on screen: about the same middle its height shows as
/// much as there, as with `limn render --size`, and its width what fits.
bool hasOwnShape(const PictureOptions& options);

/// By what things are larger in the file of a picture that has this size on screen.
double scaleOf(const PictureOptions& options, const QSize& screen);

/// The pixels of its file; `beside`: so many pictures of one size share its width, in whole pixels each.
QSize sizeInFile(const PictureOptions& options, const QSize& screen, int beside = 1);

/// The options as one line of words and numbers for the settings, and back; what is not understood is as
/// usual.
QString writtenOptions(const PictureOptions& options);
PictureOptions readOptions(const QString& text);

/// What is to be said of a file that was asked for without a ground and has one; empty where nothing is.
QString groundRemark(const QString& path, const PictureOptions& options);

/// Of the 3D view, or a slice, which has no ground of its own.
enum class PictureKind { view, slice };

/// What is told of drawing a picture beside what is asked of it.
struct DrawingTold {
  /// How long one of a size takes, s; absent where nobody knows yet: it is asked again until somebody does.
  /// Empty: it takes no time.
  std::function<std::optional<double>(const QSize& size)> seconds = {};
  int beside = 1;                         ///< so many pictures of one size stand beside each other in it
  QString remark = {};                    ///< on what is saved; empty: nothing need be said
  QString paths = {};                     ///< of physical light: how far it is drawn; empty: there is none
  std::function<void()> changePaths = {}; ///< leads to where that is set, once the dialog is closed
};

/// Asks how large a picture is saved, on which ground, and which marks go with it; tells how long it will be
/// drawn where that is long.
class PictureDialog : public QDialog {
  Q_OBJECT

public:
  /// `screen` is the size of the picture on screen, device pixels.
  PictureDialog(const PictureOptions& options, const QSize& screen, QWidget* parent,
                PictureKind kind = PictureKind::view, const DrawingTold& told = {});

  PictureOptions options() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void prepareSize(const PictureOptions& options);
  void showSize(QFormLayout& form);
  void showLock();
  void addRemark(QFormLayout& form);
  void addPaths(QFormLayout& form);
  void addMark(const char* name, const QString& text, bool isOn);
  void tellSize();

  QSize m_screen;
  DrawingTold m_told;
  QTimer m_again; ///< until it is asked again how long drawing takes
  QComboBox* m_size;
  NumberField* m_cm;
  NumberField* m_width;  ///< pixels
  NumberField* m_height; ///< pixels
  QToolButton* m_shape;  ///< a lock: closed it keeps the shape
  QComboBox* m_ground;
  QLabel* m_pixels;
  std::vector<QCheckBox*> m_marks; ///< in the order of SavedMarks
};

/// Asks so; nothing where it is cancelled.
std::optional<PictureOptions> askHowToSave(const QSize& screen, Settings& settings, QWidget* parent,
                                           PictureKind kind = PictureKind::view,
                                           const DrawingTold& told = {});

} // namespace limn
