// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Image.h"
#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/effects/EffectTimes.h"
#include "widgets/view/CompareLayout.h"
#include "widgets/view/CropBoxGeometry.h"
#include "widgets/view/InteractionQuality.h"
#include "widgets/view/PictureState.h"
#include "widgets/view/Probe.h"
#include "widgets/view/ReferenceDrawing.h"
#include "widgets/view/RestTurn.h"
#include "widgets/view/ViewKeys.h"
#include "widgets/view/ViewOverlay.h"

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>
#include <QVariantAnimation>

#include <array>
#include <memory>
#include <optional>

namespace limn {

class EmptyPanel;
class LoadingPanel;
class MessagePanel;
class ReferencePanel;
class ViewPictures;
struct Columns;

/// Shows a volume in one picture or compares two ways of lighting it: one camera, one transfer function, one
/// ray caster, one copy of the textures. Draws coarsely while something moves and strip by strip to full
/// quality at rest; at rest the picture is bit for bit what the command line writes for the same scene and
/// size. It changes no scene: it asks, through its signals, and is given the answer through setScene().
/// When the graphics driver fails, everything in it is made anew; when that fails too, the processor draws.
class CompareView : public QOpenGLWidget {
  Q_OBJECT

public:
  explicit CompareView(QWidget* parent = nullptr);
  ~CompareView() override;

  /// Shows a scene; an equal one changes nothing. Without a volume the view invites to open one.
  void setScene(const Scene& scene);
  const Scene& scene() const { return m_scene; }

  void setCompareLayout(CompareLayout layout);
  CompareLayout compareLayout() const { return m_layout; }

  /// The models of the two sides of a comparison; the single layout shows the scene's own.
  void setModels(ShadingModel left, ShadingModel right);

  /// Whether resting pictures go on to smaller steps until they lie within half a level of the exact ones;
  /// they do by default.
  void setRefinesAtRest(bool refines);
  bool refinesAtRest() const { return m_refinesAtRest; }

  /// Where the border of the wipe lies, as a fraction of the view's width, 0..1.
  void setWipePosition(double fraction);
  double wipePosition() const { return m_wipe; }

  /// The drawing time of a frame aimed at while something moves, ms, > 0.
  void setMovingMs(double ms) { m_quality.setTargetMs(ms); }
  double movingMs() const { return m_quality.targetMs(); }

  /// Where the picture at `position` (0 left, 1 right) lies, logical pixels.
  QRectF logicalRect(int position) const;

  /// What the left button does.
  void setTool(ViewTool tool);
  ViewTool tool() const { return m_tool; }

  /// Whether labels, letters, scale and notes stand above the pictures; they do by default.
  void setOverlayVisible(bool visible);

  /// Whether the crop box stands over the pictures with a handle on each face; it does not by default.
  void setCropBoxVisible(bool visible);
  bool cropBoxIsVisible() const { return m_cropBoxVisible; }

  /// Where the handle of a face stands in the picture at `position` (0 left, 1 right), logical pixels; absent
  /// where it cannot be taken hold of.
  std::optional<QPointF> cropHandle(CropFace face, int position = 0) const;

  /// Shows that something loads: `fraction` 0..1, or less than 0 where it is unknown.
  void setLoading(double fraction, const QString& text);
  void clearLoading();

  const PictureState& pictureState() const { return m_state; }

  /// The picture of side 0 or 1 over the background as shown at rest; null before it is complete.
  QImage currentPicture(int side);
  /// The same as premultiplied floats without background; absent before it is complete.
  std::optional<Image> restingImage(int side);
  /// What the pictures show, from left to right.
  std::vector<Scene> scenesOfSides() const;

  /// The scene as one side shows it.
  Scene sceneOfSide(int side) const;

  /// The same with the step of `restingImage`, which may have been refined.
  Scene sceneOfRestingImage(int side) const;

  /// Width over height of one picture at present.
  double pictureAspect() const;

  /// What draws when the graphics driver has failed; without it the view shows the sentence alone.
  void setProcessorRenderer(DrawOnProcessor renderer);
  bool drawsOnProcessor() const { return m_onProcessor; }

  /// How many shader programs were compiled so far.
  int compiledPrograms() const;

  /// Whether the pictures rest and all that is done at rest is done.
  bool isIdle() const { return m_state.resting && !m_restTimer.isActive() && !m_probeTimer.isActive(); }

  QSize sizeHint() const override { return {960, 540}; }
  QSize minimumSizeHint() const override { return {240, 180}; }

public slots:
  /// Asks for a standard view that fills the picture with the volume; reset is the one of a
  /// freshly opened volume.
  void lookFrom(limn::StandardView view);
  void resetCamera();

  /// Measures at rest what each effect of the picture costs whose effects are told; the next change of what
  /// is shown stops it.
  void measureEffects();

signals:
  void cameraEdited(const limn::Camera& camera);
  void windowLevelEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  void cropEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  /// What lies under the pointer while Shift is held; nothing when it ends or hits nothing.
  void probed(const std::optional<limn::Probe>& probe);
  void pinRequested(double value);
  void modelChosen(int side, limn::ShadingModel model);
  void wipeMoved(double fraction);
  void toolChanged(limn::ViewTool tool);
  void windowPresetRequested(int number); ///< 0 the full range, 1..9 the presets
  void shortcutListRequested();
  void maximiseRequested();
  void pictureStateChanged(const limn::PictureState& state);
  /// What the picture, called `picture`, calls for; of two pictures the right one.
  void effectsChanged(const std::vector<limn::EffectRow>& rows, const QString& picture);
  void effectTimesChanged(const limn::EffectTimes& times);
  /// Drawing failed; the view already shows the sentence.
  void errorOccurred(const QString& sentence);
  /// Drawing had failed, and works again.
  void graphicsRestored(const QString& sentence);
  void openFolderRequested();
  void openFileRequested();
  void sampleRequested();
  void loadingCancelled();

protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  /// A pressed button until its release; `first` and `last` in logical pixels.
  struct Drag {
    Qt::MouseButton button = Qt::NoButton;
    DragKind kind = DragKind::none;
    bool wipe = false;   ///< of the wipe's border
    bool mayPin = false; ///< a Shift+click that has not moved yet
    QPointF first, last;
    QRectF side;
    Camera camera;                ///< before
    TransferFunction function;    ///< before
    CropBox crop;                 ///< before
    std::optional<CropFace> face; ///< of the crop box
    QPointF grip;                 ///< from the handle's centre to the pointer
    Gesture gesture;
  };

  static constexpr double budgetMs = 30.0;     // of drawing in one turn of the event loop
  static constexpr double restBudgetMs = 20.0; // of drawing what nobody waits for
  static constexpr int showEveryMs = 200;      // while refining: showing costs as much as a turn of it

  // Drawing (CompareView.cpp)
  void makePanels();
  void makePictures();
  void releasePictures();
  void redraw();
  void showOtherParts();
  void drawCoarsely();
  std::array<Columns, 2> seenColumns() const;
  void refine();
  GradientScale gradientScaleOfSide(int side) const;
  glm::ivec2 deviceSize() const;
  std::vector<PixelRect> rects() const;
  int sideShownAt(int position) const { return m_swapped ? 1 - position : position; }
  void updatePanels();
  void wakeLabels();

  // When drawing fails (CompareViewFailure.cpp)
  void makeReference();
  void guarded(const std::function<void()>& work);
  bool isDriverLost();
  void stopDrawing();
  void fail(const QString& sentence);
  void failDriver(const QString& sentence, const QString& details);
  void rebuildGraphics(bool withContext);
  void renewContext();
  void giveUpGraphics();
  void drawOnProcessor();
  void showReference(const std::vector<QImage>& pictures, bool isComplete);
  void leaveProcessor();
  void noteRecovery();

  // While nothing changes (CompareViewRest.cpp)
  void updateState();
  void probeError();
  void workAtRest();
  RestTurn restTurn();
  void leaveRest();
  void showEffects();
  void tellEffects(const std::vector<EffectRow>& rows, const QString& picture);
  void showTimes(const EffectTimes& times);
  int sideOfEffects() const { return pictureCount(m_layout) - 1; }

  // What stands above the pictures (CompareViewOverlay.cpp)
  void paintOverlay();
  std::vector<QRectF> paintTitles(QPainter& painter);
  std::vector<QRectF> paintNotes(QPainter& painter);
  void paintOrientation(QPainter& painter, const std::vector<QRectF>& plates);
  std::optional<ScaleMark> scaleMark() const;
  QRectF labelPlateOf(int position, const SideLabel& label) const;
  QRectF steadyLabelRect(int position) const;
  SideLabel differenceTitle() const;
  QRectF differenceTitleRect() const;
  Note differenceNote() const;
  SideLabel labelOf(int position) const;
  QRectF labelRect(int position) const;

  // Input (CompareViewInput.cpp)
  void beginDrag(QMouseEvent* event);
  void continueDrag(QMouseEvent* event);
  void cancelDrag();
  void dragWindowLevel(const QPointF& to);
  bool onWipeBorder(const QPointF& point) const;
  int labelAt(const QPointF& point) const;
  int positionAt(const QPointF& point) const;
  std::optional<Probe> probeAt(const QPointF& point) const;
  void showProbe(const std::optional<Probe>& probe, const QPointF& point);
  void popUpModels(int position);
  void hover(QMouseEvent* event);
  void setSwapped(bool swapped);
  bool obey(const ViewCommand& command);

  // The crop box over the pictures (CompareViewCrop.cpp)
  int pictureUnder(const QPointF& point) const;
  CropBoxShape cropShape(int position) const;
  std::optional<CropHandle> cropHandleAt(const QPointF& point) const;
  bool beginCropDrag(const QMouseEvent& event);
  void dragCrop(const QPointF& to);
  void resetFace(CropFace face);
  void paintCropBoxes(QPainter& painter) const;
  Note cropNote(const CropHandle& handle) const;

  Scene m_scene;
  CompareLayout m_layout = CompareLayout::single;
  std::array<ShadingModel, 2> m_models{ShadingModel::classic, ShadingModel::enhanced};
  double m_wipe = 0.5;
  ViewTool m_tool = ViewTool::rotate;
  bool m_swapped = false;
  bool m_overlayVisible = true;
  bool m_cropBoxVisible = false;
  bool m_refinesAtRest = true;

  std::unique_ptr<ViewPictures> m_pictures; ///< lives with the OpenGL context
  InteractionQuality m_quality;
  bool m_stale = true; ///< the scene changed since it was last drawn
  QTimer m_idleTimer;  ///< from the last coarse picture to the start of refinement
  QTimer m_refineTimer;
  QTimer m_restTimer;
  QTimer m_probeTimer;              ///< from a coarse picture to the measure of its error
  std::vector<EffectRow> m_effects; ///< as told last
  QString m_effectsPicture;
  EffectTimes m_times;
  QElapsedTimer m_sinceShown;
  PictureState m_state;
  QString m_error;
  QString m_failureDetails; ///< what the driver wrote
  int m_driverFailures = 0; ///< in a row
  bool m_onProcessor = false;
  ReferenceDrawing* m_reference = nullptr;

  std::optional<Drag> m_drag;
  std::optional<Probe> m_probe;
  QPointF m_probePoint;
  int m_hoveredLabel = -1;
  bool m_wipeHovered = false;
  std::optional<CropFace> m_hoveredFace;
  QVariantAnimation m_labelFade;
  QTimer m_labelTimer;

  EmptyPanel* m_empty = nullptr;
  MessagePanel* m_message = nullptr;
  LoadingPanel* m_loading = nullptr;
  ReferencePanel* m_referencePanel = nullptr;
};

} // namespace limn
