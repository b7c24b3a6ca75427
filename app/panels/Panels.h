// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/AccuracyController.h"
#include "app/panels/CropBoxController.h"
#include "app/panels/RayController.h"
#include "app/panels/curve/CurveController.h"
#include "app/panels/curve/SuggestionController.h"
#include "app/panels/presets/LookController.h"
#include "app/panels/presets/PresetController.h"
#include "app/panels/presets/ThumbnailController.h"
#include "io/scenefile/SessionFile.h"
#include "scene/effects/EffectRows.h"

#include <QObject>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QAction;

namespace limn {

class EffectsPanel;
class PointLight;
class PropertiesPanel;
struct WindowContext;

/// The curves of the kinds of pictures of one volume: maximum, minimum, average and X-ray say nothing with a
/// curve made for tissue, so each brings its own, and gives the one before back.
class ProjectionCurves {
public:
  /// Keeps what a scene shows for its kind of picture; the curves of another volume are forgotten.
  void note(const Scene& scene);

  /// The scene as another kind of picture (withProjection), with the curve last shown as that kind or, the
  /// first time, with its own; `histogram` is the volume's. Kinds that show tissue share one.
  Scene changed(const Scene& scene, Projection projection, const Histogram& histogram) const;

private:
  enum class Kind { tissue, maximum, minimum, average, xray };
  static Kind kindOf(Projection projection);
  static TransferFunction ownCurve(const Scene& scene, Kind kind, const Histogram& histogram);

  std::shared_ptr<const Volume> m_volume;
  std::map<Kind, TransferFunction> m_shown;
};

/// Shows what a point of the curve governs for as long as the pointer rests on it: in the slices and in the
/// picture, and in no history.
class EmphasisController : public QObject {
  Q_OBJECT

public:
  EmphasisController(WindowContext& context, const CurveController& curves);

signals:
  /// The slices are to light up what this point governs, of the scene's curve or of that of a label, or
  /// nothing.
  void lit(std::optional<std::size_t> point, std::optional<std::size_t> label);

private:
  void show(std::optional<std::size_t> point);

  WindowContext& m_context;
  const CurveController& m_curves;
  PointLight* m_light;
};

/// The look of the volume that was open before the present one, for the next patient: the same curve and
/// light, moved onto the values of what is open where the two have no common scale.
class EarlierLook : public QObject {
  Q_OBJECT

public:
  explicit EarlierLook(WindowContext& context);

  /// A look, and the data that it was shaped on.
  struct Shaped {
    Preset look; ///< knows the landmarks of those data
    bool isHounsfield = false;
  };
  const std::optional<Shaped>& earlier() const { return m_earlier; }
  void setEarlier(const std::optional<Shaped>& earlier);

private:
  void follow(const Scene& scene);
  void use();

  WindowContext& m_context;
  QAction* m_use;                       ///< shows that look, as one undo step; out of use while there is none
  std::weak_ptr<const Volume> m_volume; ///< that `m_present` belongs to
  std::optional<Shaped> m_present;
  std::optional<Shaped> m_earlier;
};

/// The docks around the picture: presets and history at the left, properties, effects, accuracy and the ray
/// at the right, the curve below.
class Panels : public QObject {
  Q_OBJECT

public:
  explicit Panels(WindowContext& context);

  PresetController& presets() { return m_presets; }
  LookController& looks() { return m_looks; }
  ThumbnailController& thumbnails() { return m_thumbnails; }
  AccuracyController& accuracy() { return m_accuracy; }
  RayController& ray() { return m_ray; }
  EmphasisController& emphasis() { return m_emphasis; }
  CurvePanel& curve() const { return m_curves.panel(); }
  CurveController& curves() { return m_curves; }
  PropertiesPanel& properties() { return m_properties; }

  /// Shows a volume that was opened; `histogram` is of its values. Null: none is open any more.
  void showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram);

  /// Selects a label in the list, which comes to the front, and shows the curve that it has.
  void takeLabel(std::size_t place);

  /// Brings to the front how far saved pictures of physical light are drawn.
  void showSavedPaths();

  /// Whether looks are being imported or accuracy is measured.
  bool isBusy() const { return m_looks.isBusy() || m_accuracy.isBusy(); }

  /// What a session file says of them.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

  /// What they know beside that, for a window that takes this one's place.
  struct Memory {
    std::map<std::string, Scene> switchedOff;
    ProjectionCurves projections;
    std::optional<EarlierLook::Shaped> earlier;
    AccuracyController::Memory accuracy;
    std::vector<bool> foldedProperties; ///< SectionPanel::folded
  };
  Memory memory() const;
  /// Of the same volume, which is shown already.
  void takeOver(const Memory& memory);

private:
  void addHistory();
  void connectProperties();
  void addEffects();
  std::set<std::string> switchableEffects(const std::vector<EffectRow>& rows) const;
  void switchEffect(const QString& effect, bool isOn);
  void showScene(const Scene& scene);
  void showPreview(const Scene& scene, const std::string& preset);

  WindowContext& m_context;
  PresetController m_presets;
  PropertiesPanel& m_properties;
  EffectsPanel& m_effects;
  std::map<std::string, Scene> m_switchedOff; ///< effects, by name, with what had them; of this volume
  AccuracyController m_accuracy;
  RayController m_ray;
  CurveController m_curves;
  CropBoxController m_cropBox;
  SuggestionController m_suggestions;
  EmphasisController m_emphasis;
  EarlierLook m_earlier;
  LookController m_looks;
  ThumbnailController m_thumbnails;
  ProjectionCurves m_projections;
};

} // namespace limn
