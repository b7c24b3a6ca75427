// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/AccuracyController.h"
#include "app/panels/CropBoxController.h"
#include "app/panels/RayController.h"
#include "app/panels/curve/CurveController.h"
#include "app/panels/curve/EmphasisController.h"
#include "app/panels/curve/SuggestionController.h"
#include "app/panels/presets/EarlierLook.h"
#include "app/panels/presets/LookController.h"
#include "app/panels/presets/PresetController.h"
#include "app/panels/presets/ProjectionCurves.h"
#include "app/panels/presets/ThumbnailController.h"
#include "io/scenefile/SessionFile.h"

namespace limn {

class EffectsPanel;
class PropertiesPanel;

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
  PropertiesPanel& properties() { return m_properties; }

  /// Shows a volume that was opened; `histogram` is of its values. Null: none is open any more.
  void showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram);

  /// What a session file says of them.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

private:
  void addHistory();
  void connectProperties();
  void addEffects();
  void showScene(const Scene& scene);
  void showPreview(const Scene& scene, const std::string& preset);

  WindowContext& m_context;
  PresetController m_presets;
  PropertiesPanel& m_properties;
  EffectsPanel& m_effects;
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
