// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"
#include "scene/Scene.h"
#include "scene/presets/Preset.h"
#include "scene/regions/PackedLabels.h"
#include "scene/view/Measurement.h"
#include "scene/view/NamedView.h"
#include "scene/view/PlaneSettings.h"
#include "widgets/Gesture.h"

#include <QObject>
#include <QUndoStack>

#include <memory>
#include <vector>

namespace limn {

/// Whether both show the same voxels: where they lie may differ, because orientation can be set by hand. None
/// is like none.
bool haveSameVoxels(const std::shared_ptr<const Volume>& a, const std::shared_ptr<const Volume>& b);

/// The scene with another projection. A surface at a value that the volume does not have, or one in
/// Hounsfield units in other data, begins between background and object; `histogram` is the volume's.
Scene withProjection(Scene scene, Projection projection, const Histogram& histogram);

/// The camera with parallel rays or with a vanishing point; the target plane keeps its size on screen.
Camera withProjection(Camera camera, Camera::Projection projection);

/// The one mutable scene of the program. Every change goes through here: edits become undo steps (one per
/// gesture), the camera moves without one. There is one signal, and it carries the new scene.
class Session : public QObject {
  Q_OBJECT

public:
  /// No more can be undone than so many steps: of more the oldest goes.
  static constexpr int mostSteps = 1000;

  /// Steps hold at most `mostLabelBytes` of maps of labels in memory (each cut has one); those of the oldest
  /// lie on the disk.
  explicit Session(QObject* parent = nullptr, std::size_t mostLabelBytes = std::size_t{256} << 20);

  const Scene& scene() const { return m_scene; }
  const std::string& volumePath() const { return m_volumePath; }
  QUndoStack& undoStack() { return m_undo; }

  /// The preset that the scene was last made from, as fitted to the volume; without a name there is none.
  /// Undo brings back the one before.
  const Preset& preset() const { return m_preset; }

  /// Whether the scene (but for the camera) differs from the one opened or saved last.
  bool isEdited() const { return !m_undo.isClean(); }

  /// Shows a freshly loaded scene, made from `preset`; the history of the former one ends.
  void open(const LoadedScene& loaded, const Preset& preset = {});

  /// Replaces everything but the camera as one undo step (a volume only by the same voxels where they lie
  /// otherwise) named by the gesture; edits with the gesture
  /// id of the step on top extend it. An equal scene changes nothing.
  void edit(const Scene& next, const Gesture& gesture);
  /// The same with the preset in use, be the scene as it was.
  void edit(const Scene& next, const Preset& preset, const Gesture& gesture);

  /// Shows the scene as a preset asks, but with its own model, as one undo step.
  void usePreset(const Preset& preset, const Gesture& gesture);

  /// From now on the scene counts as made from this preset; nothing else changes.
  void adoptPreset(const Preset& preset) { m_preset = preset; }

  void setTransferFunction(const TransferFunction& function, const Gesture& gesture) {
    editPart(&Scene::transferFunction, function, gesture);
  }
  void setGradientOpacity(const std::optional<GradientOpacity>& curve, const Gesture& gesture) {
    editPart(&Scene::gradientOpacity, curve, gesture);
  }
  void setShading(const Shading& shading, const Gesture& gesture) {
    editPart(&Scene::shading, shading, gesture);
  }
  void setQuality(const Quality& quality, const Gesture& gesture) {
    editPart(&Scene::quality, quality, gesture);
  }
  void setIsovalue(double isovalue, const Gesture& gesture) { editPart(&Scene::isovalue, isovalue, gesture); }
  void setFog(const Fog& fog, const Gesture& gesture) { editPart(&Scene::fog, fog, gesture); }
  void setKeep(const Region& keep, const Gesture& gesture) { editPart(&Scene::keep, keep, gesture); }
  void setCrop(const CropBox& crop, const Gesture& gesture) { editPart(&Scene::crop, crop, gesture); }

  /// Moves the camera; not undoable.
  void setCamera(const Camera& camera);

  /// What the slices beside the picture show. Like the camera they are a way of looking: no undo steps.
  const PlaneSettings& planes() const { return m_planes; }
  void setPlanes(const PlaneSettings& settings);

  /// What was measured and named in the volume, in slices and in the picture. Measured anew as one undo step,
  /// as `edit` does; a volume that is opened brings its own or none. Where one lies otherwise from now on
  /// they stay on their tissue.
  const std::vector<Measurement>& measurements() const { return m_measurements; }
  void setMeasurements(const std::vector<Measurement>& measurements, const Gesture& gesture);

  /// Cameras that are kept under names, of this volume. They are work: that they are others from now on is an
  /// undo step called `what`. Equal ones change nothing.
  const std::vector<NamedView>& views() const { return m_views; }
  void setViews(const std::vector<NamedView>& views, const QString& what);

  /// Tells once more of planes, measurements and views, to who has just come.
  void tellBeside();

  /// Of maps of labels that steps hold in memory, as far as they are packed.
  std::size_t labelBytes() const;

signals:
  void viewsChanged(const std::vector<limn::NamedView>& views);
  void sceneChanged(const limn::Scene& scene);
  void planesChanged(const limn::PlaneSettings& settings);
  void measurementsChanged(const std::vector<limn::Measurement>& measurements);

private:
  friend class SceneEdit;
  /// What the history holds of a map of labels, once for all steps that have it; null of none.
  std::shared_ptr<const PackedLabels> packed(const std::shared_ptr<const LabelMap>& map);
  void putOldLabelsAside() const;
  friend class MeasurementsEdit;
  friend class ViewsEdit;
  template <class Part>
  void editPart(Part Scene::*part, const Part& value, const Gesture& gesture) {
    Scene next = m_scene;
    next.*part = value;
    edit(next, gesture);
  }
  void replace(const Scene& scene);
  void replaceMeasurements(const std::vector<Measurement>& measurements);
  void replaceViews(const std::vector<NamedView>& views);

  Scene m_scene;
  PlaneSettings m_planes;
  std::vector<Measurement> m_measurements;
  std::vector<NamedView> m_views;
  Preset m_preset;
  std::string m_volumePath;
  QUndoStack m_undo;
  std::vector<std::weak_ptr<const PackedLabels>> m_packed; ///< that steps hold, the latest last
  std::size_t m_mostLabelBytes;
  std::shared_ptr<Room> m_aside = std::make_shared<Room>(); ///< of the oldest of them
};

} // namespace limn
