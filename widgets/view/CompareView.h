// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "scene/basics/Image.h"
#include "widgets/Gesture.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/overlay/ViewGeometry.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QImage>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class QMenu;

namespace limn {

class CameraFit;
class EmptyPanel;
class EngineSwitch;
class LabelFade;
class PanelStack;
class ViewInput;
enum class ViewTool;
/// Shows a volume in one picture or compares two ways of lighting or showing it: one camera, one engine, one
/// copy of the volume. Draws coarsely while something moves and strip by strip to full quality at
/// rest (pictures/); at rest the picture is bit for bit what the command line writes for the same scene and
/// size. It changes no scene: it asks, through its signals, and is given the answer through setScene().
/// The graphics driver draws, or the processor (drawing/). When the driver fails, everything in it is made
/// anew; when that fails too, the processor draws.
class CompareView : public QWidget {
  Q_OBJECT
  Q_MOC_INCLUDE(<QMenu>)

public:
  /// `engine` draws at first. One that `engines` lacks is never asked; without OpenGL (openGlOffer) there
  /// must be no `engines.driver`.
  explicit CompareView(DrawingEngines engines, Engine engine = Engine::rayCaster, QWidget* parent = nullptr);
  ~CompareView() override;

  /// What is to be seen, as it was pushed last to those who draw.
  const ViewOrder& order() const { return m_order; }

  /// Shows a scene; an equal one changes nothing. Without a volume the view invites to open one.
  void setScene(const Scene& scene);
  const Scene& scene() const { return m_order.comparison.scene; }

  /// Lets an engine draw, for a reason that is told with the pictures; nothing happens where there is none.
  void setEngine(Engine engine, const QString& reason);
  Engine engine() const;

  void setCompareLayout(CompareLayout layout);
  CompareLayout compareLayout() const { return m_order.comparison.layout; }

  /// The models of the two sides of a comparison, or the look that is compared instead; the single layout
  /// shows the scene as it is.
  void setSides(const SideModels& models, const std::optional<ComparedLook>& look);
  void setModels(ShadingModel left, ShadingModel right) { setSides({left, right}, std::nullopt); }

  /// Whether pictures at rest go on until they lie within half a level of the exact ones, as at first.
  void setRefinesAtRest(bool refines) {
    m_refinesAtRest = refines;
    set(m_order.refines, m_refinesAtRest && m_pauses == 0);
  }
  bool refinesAtRest() const { return m_refinesAtRest; } ///< though it may pause

  /// Resting pictures stay as they are while something is drawn for a file, until each pause has ended.
  void pauseRefinement(bool pauses) {
    m_pauses += pauses ? 1 : -1;
    setRefinesAtRest(m_refinesAtRest);
  }

  /// Where the border of the wipe lies, as a fraction of the view's width, 0..1.
  void setWipePosition(double fraction) { set(m_order.comparison.wipe, std::clamp(fraction, 0.0, 1.0)); }
  double wipePosition() const { return m_order.comparison.wipe; }

  /// The drawing time of a frame aimed at while something moves, ms, > 0.
  void setMovingMs(double ms) { set(m_order.movingMs, ms); }

  /// Where the picture at `position` (0 left, 1 right) lies, logical pixels.
  QRectF logicalRect(int position) const { return pictureRect(geometry(), position); }

  /// Width over height of one picture at present.
  double pictureAspect() const { return limn::pictureAspect(geometry()); }

  /// Whether labels, letters, scale and notes stand above the pictures; they do by default.
  void setOverlayVisible(bool visible) { set(m_order.hasOverlay, visible); }

  /// Whether the crop box stands over the pictures with a handle on each face; it does not by default.
  void setCropBoxVisible(bool visible);
  /// A box that stands in the place of the crop's, or none; none at first. Its faces are dragged as the
  /// crop's, and asked for by ViewInput::turnedBoxEdited.
  void setTurnedBox(const std::optional<TurnedBox>& box) { set(m_order.comparison.turnedBox, box); }
  bool cropBoxIsVisible() const { return m_order.hasCropBox; }

  /// Whether a cube shows how the picture lies, of which each face leads to the view from there; none does by
  /// default.
  void setCubeVisible(bool visible) { set(m_order.hasCube, visible); }

  /// Marks a place of the world in the pictures, or none; there is none at first. Where it is hidden in the
  /// picture of a side the mark says so.
  void setMark(const std::optional<glm::dvec3>& worldMm, const std::array<bool, 2>& isHidden = {}) {
    m_order.comparison.markIsHidden = isHidden;
    set(m_order.comparison.markMm, worldMm);
  }

  /// Marks where half of the light of a ray is gathered, or nothing; nothing at first.
  void setHalfMark(const std::optional<glm::dvec3>& worldMm) { set(m_order.comparison.halfMm, worldMm); }

  /// Whether the crop is known to hide nothing that would be seen, so that no note tells of it.
  void setCropHidesNothing(bool hides) { set(m_order.comparison.cropHidesNothing, hides); }
  /// Draws what was measured over the pictures; nothing at first.
  void setMeasures(const std::vector<SeenMeasure>& measures) { set(m_order.comparison.measures, measures); }

  /// Turns go about this place of the world from now on, which is marked while one lasts; nothing: about the
  /// camera's target, as at first.
  void setTurnsAbout(const std::optional<glm::dvec3>& worldMm) {
    set(m_order.comparison.turnsAboutMm, worldMm);
  }
  const std::optional<glm::dvec3>& turnsAbout() const { return m_order.comparison.turnsAboutMm; }

  /// Whether lines of the scissors take away what they go around, or all else; at first the former.
  void setLinesRemoveInside(bool isInside);

  /// What reads pointer and keys, and asks for what is not of the view itself: windows, crops, measurements.
  ViewInput& input() const { return *m_input; }

  /// The preset that the scene is shown as a preview of, which the pictures then say; empty: it is none.
  void setPreview(const std::string& preset) { set(m_order.comparison.preview, preset); }

  /// What the left button does; at first it rotates. Esc in the view returns to that.
  void setTool(ViewTool tool);
  ViewTool tool() const;

  /// What the view offers where there is no volume.
  EmptyPanel& emptyPanel() const;

  /// Shows that something loads: `fraction` 0..1, or less than 0 where it is unknown.
  void setLoading(double fraction, const QString& text);
  void clearLoading();

  PictureState pictureState() const;

  /// What was measured, from now on told in place of estimates; to be set again when that changes.
  void setMeasuredErrors(MeasuredErrors errors);

  /// The picture of side 0 or 1 over the background as shown at rest; null before it is complete.
  QImage currentPicture(int side);
  /// The same as premultiplied floats without background; absent before it is complete.
  std::optional<Image> restingImage(int side);
  /// What the pictures show, from left to right.
  std::vector<Scene> scenesOfSides() const { return limn::scenesOfSides(m_order.comparison); }

  /// The side that shows the scene as it is edited: of compared looks the right one.
  int ownSide() const { return limn::ownSide(m_order.comparison); }

  /// The scene as one side shows it.
  Scene sceneOfSide(int side) const { return limn::sceneOfSide(m_order.comparison, side); }

  /// The same with the step of `restingImage`, which may have been refined.
  Scene sceneOfRestingImage(int side) const;

  QSize sizeHint() const override { return {960, 540}; }
  QSize minimumSizeHint() const override { return {240, 180}; }

public slots:
  /// Asks for a standard view framed on what is visible; reset is the one of a freshly opened volume.
  void lookFrom(limn::StandardView view);
  void resetCamera();

  /// Measures at rest what each effect of the picture costs whose effects are told, or no longer; the next
  /// change of what is shown stops it, too.
  void measureEffects(bool measures = true);

signals:
  /// By the gesture of this id: what one drag, or one run of notches or key presses, asks for has one id.
  void cameraEdited(const limn::Camera& camera, std::uint64_t gesture);
  /// The same, but nobody asked: the pictures changed their shape, or what is visible.
  void cameraFitted(const limn::Camera& camera);
  void modelChosen(int side, limn::ShadingModel model);
  /// A menu opens that offers presets for the picture of a side; it is to be filled.
  void presetMenuAsked(QMenu* menu, int side);
  void swapAsked(); ///< the two pictures shall change their sides
  void wipeMoved(double fraction);
  void toolChanged(limn::ViewTool tool);
  /// A line of the scissors is being drawn corner by corner from now on, or no longer.
  void cornersBegun(bool isBegun);
  /// Whenever anything in it changes.
  void told(const limn::ViewNews& news);
  /// Drawing failed; the view already shows the sentence.
  void errorOccurred(const QString& sentence);
  /// Drawing had failed, and works again.
  void graphicsRestored(const QString& sentence);
  void loadingCancelled();

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  template <class T>
  void set(T& part, const T& value) {
    part = value;
    push();
  }
  void push();
  void take(const ViewNews& news);
  void connectEngines();
  void connectInput();
  void arrangeParts();
  ViewGeometry geometry() const;
  void setSwapped(bool swapped);
  void updatePanels();
  void showPreparing(double fraction);
  void offerModels(int position);

  ViewOrder m_order;
  bool m_hasCorners = false;   ///< of a line that is drawn so
  bool m_refinesAtRest = true; ///< unless it pauses
  int m_pauses = 0;            ///< of refinement
  bool m_isShown = false;
  bool m_isPreparing = false; ///< it is said that a volume is got ready
  QString m_problem;          ///< why nothing is drawn, as the panels say it
  EngineSwitch* m_engines;
  CameraFit* m_fit;
  ViewInput* m_input;
  PanelStack* m_panels;
  LabelFade* m_labels;
};

} // namespace limn
