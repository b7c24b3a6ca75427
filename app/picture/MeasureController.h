// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/MeasureText.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/view/overlay/MeasureMarks.h"

#include <QObject>
#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace limn {

class HintBar;
struct Ray;
struct WindowContext;
enum class PlaneTool;

/// What is measured in slices and in the picture: finds what it says of the volume, makes each change one
/// undo step that is called by what was measured, and shows it in slices, picture and list. In the picture
/// places are picked where half of the light of a ray is gathered.
class MeasureController : public QObject {
  Q_OBJECT

public:
  explicit MeasureController(WindowContext& context);

  /// Whether one has been begun in the picture that lacks places.
  bool isDrawing() const { return m_open.has_value(); }

public slots:
  /// The measurements shall be these.
  void edit(const limn::MeasurementsEdited& edited);
  /// The same where somebody edits the list of them.
  void editListed(const limn::MeasurementsEdited& edited);
  /// Takes one in hand and leads the crosshair to it.
  void goTo(std::size_t number);
  /// The left button measures so from now on, in the picture and in slices; ellipses in these alone.
  void useTool(limn::Measurement::Kind kind);

signals:
  /// What there is, of which volume (null: none is open), and what of it is in hand.
  void shown(const std::vector<limn::Measured>& measured, const std::shared_ptr<const limn::Volume>& volume,
             std::optional<std::size_t> inHand);

private:
  void refresh();
  void show();
  void findHidden();
  std::vector<Measurement> placed() const;
  void showTool();
  void showBar();
  bool hasSlices() const;
  void layAside(); ///< the tools that measure
  void remove();
  bool drop(); ///< what lacks places; false where nothing does
  bool drawsFrom(const Ray& ray, int side) const;
  void pick(const Ray& ray, int side);
  void stretch(const Ray& ray, int side);
  void take(const MeasureHandle& handle, std::uint64_t gesture);
  void lead(const Ray& ray, int side);
  std::optional<glm::dvec3> placeSeen(const Ray& ray, int side);
  void say(const QString& sentence);
  void sayNext(const QString& hint); ///< or, empty, that nothing is being drawn any more

  // A handle that is being led in the picture.
  struct Led {
    MeasureHandle handle;
    std::uint64_t gesture = 0;
    std::vector<Measurement> before;
  };

  WindowContext& m_context;
  HintBar* m_bar;                         ///< what to click while a tool that measures is in hand
  std::shared_ptr<const Volume> m_volume; ///< of which they are
  std::vector<Measured> m_measured;
  std::optional<std::size_t> m_inHand;
  std::optional<Measurement> m_open;       ///< that lacks places, which are being picked in the picture
  std::optional<glm::dvec3> m_stretchedTo; ///< its next place, while a drag draws it
  std::optional<Led> m_led;
  QString m_next;          ///< what was said to do next of what is being drawn
  QString m_said;          ///< of the tool in hand
  bool m_isAtRest = false; ///< the picture
  /// Which of them lay behind what was seen on each side when it came to rest, or in what was cut away; may
  /// be shorter.
  std::vector<std::array<bool, 2>> m_hidden;
  std::vector<Measurement> m_lookedFor;
  BackgroundWork m_looking; ///< for them
};

} // namespace limn
