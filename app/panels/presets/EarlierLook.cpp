// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/EarlierLook.h"

#include "app/window/WindowContext.h"
#include "scene/presets/PresetFit.h"
#include "widgets/controls/MessageBar.h"

namespace limn {

EarlierLook::EarlierLook(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_use(context.actions.add(
          QStringLiteral("earlierLook"),
          {.text = tr("Use the &look of the volume before"),
           .place = {Menu::preset, 1, 3},
           .shortcut = tr("Ctrl+L"),
           .toolTip = tr("Shows this volume with curve and light of the one that was open before it.")})) {
  m_use->setEnabled(false);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { follow(scene); });
  connect(m_use, &QAction::triggered, this, &EarlierLook::use);
}

void EarlierLook::follow(const Scene& scene) {
  const std::shared_ptr<const Volume> before = m_volume.lock();
  // Where the voxels of one volume lie may change: orientation can be set by hand.
  const bool isSame = before && scene.volume && before->sharesVoxelsWith(*scene.volume);
  std::optional<Landmarks> landmarks;
  if (isSame) {
    landmarks = m_present->look.landmarks;
  } else {
    if (m_present)
      m_earlier = std::move(m_present);
    m_present.reset();
    if (scene.volume)
      landmarks = landmarksOf(m_context.document.histogram());
  }
  m_volume = scene.volume;
  if (scene.volume) {
    m_present = {presetOf(scene, tr("Earlier look").toStdString()), looksLikeHounsfield(*scene.volume)};
    m_present->look.landmarks = landmarks;
  }
  m_use->setEnabled(m_earlier && scene.volume);
}

void EarlierLook::use() {
  const std::shared_ptr<const Volume>& volume = m_context.session.scene().volume;
  if (!m_earlier || !volume)
    return;
  Preset look = m_earlier->look;
  const bool haveOneScale = m_earlier->isHounsfield && looksLikeHounsfield(*volume);
  if (haveOneScale)
    look.landmarks.reset();
  m_context.session.usePreset(fittedTo(look, m_context.document.histogram(), volume->grid()),
                              {nextGestureId(), tr("use the look of the volume before")});
  if (!haveOneScale)
    m_context.messages.show(
        MessageBar::Kind::warning,
        tr("The look of the volume before was fitted to the values of this one: not both are in "
           "Hounsfield units."));
}

} // namespace limn
