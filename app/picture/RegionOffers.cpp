// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/RegionOffers.h"

#include "app/core/sources/KeptRegion.h"
#include "app/window/WindowContext.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Orientation.h"
#include "widgets/Gesture.h"
#include "widgets/controls/MessageBar.h"

#include <algorithm>

namespace limn {
namespace {

// Whether two grids hold their voxels at the same places, but for what is lost as files write numbers.
bool areAlike(const Grid& a, const Grid& b) {
  if (a.dims != b.dims)
    return false;
  const double least = std::min({a.spacingMm.x, a.spacingMm.y, a.spacingMm.z});
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(a.dims - 1);
    if (glm::distance(indexToWorld(a, index), indexToWorld(b, index)) > 0.01 * least)
      return false;
  }
  return true;
}

QString tableQuestion() {
  return RegionOffers::tr("Hide the table and the holder? It is not certain which part is the body.");
}

} // namespace

RegionOffers::RegionOffers(WindowContext& context) : m_context(context) {}

void RegionOffers::offerBody() {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume || scene.volume->room() || scene.keep.kind != Region::Kind::all ||
      imageNormalAxis(scene.volume->grid()) || !looksLikeHounsfield(*scene.volume))
    return;
  m_offering.start([this, volume = scene.volume](const Effort& effort) -> BackgroundWork::Deliver {
    Progress progress;
    progress.isCancelled = effort.isCancelled;
    const FoundRegion found = bodyOf(*volume, progress);
    // A remark says that it is doubtful what lies beside the body, and that something does.
    if (found.remark.empty() || found.region.kind != Region::Kind::body)
      return [] {};
    return [this, volume, found] { askAboutTable(volume, found, QDeadlineTimer(m_asksForMs)); };
  });
}

// What is said of the volume itself goes before, and is dismissed first. A question that comes long after the
// volume only interrupts: the View menu has its answer.
void RegionOffers::askAboutTable(const std::shared_ptr<const Volume>& volume, const FoundRegion& found,
                                 const QDeadlineTimer& end) {
  if (end.hasExpired())
    return;
  const auto isAsShown = [this, volume] {
    const Scene& shown = m_context.session.scene();
    return shown.volume == volume && shown.keep.kind == Region::Kind::all;
  };
  if (!isAsShown())
    return;
  if (m_context.messages.isWanted()) {
    connect(
        &m_context.messages, &MessageBar::wanted, this,
        [this, volume, found, end] { askAboutTable(volume, found, end); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
    return;
  }
  m_context.messages.show(MessageBar::Kind::question, tableQuestion(), {},
                          {tr("Hide them"),
                           [this, isAsShown, found] {
                             m_context.messages.hide();
                             if (isAsShown())
                               m_context.session.setKeep(found.region, {nextGestureId(), tr("body only")});
                           }},
                          {tr("Leave them"), {}});
}

bool RegionOffers::isAsking() const {
  return m_context.messages.isAsking() && m_context.messages.sentence() == tableQuestion();
}

void RegionOffers::showScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    m_offering.cancel();
    offerCutsOfBefore(scene);
    m_volume = scene.volume;
    if (isAsking())
      m_context.messages.hide(); // it was about the volume before
  }
  if (scene.volume)
    m_cuts = scene.keep.cuts;
}

// Another series of the same grid shows the same body: what hides one hides the other.
void RegionOffers::offerCutsOfBefore(const Scene& scene) {
  const bool suits = m_volume && scene.volume && !m_cuts.empty() && scene.keep.cuts.empty() &&
                     !scene.volume->sharesVoxelsWith(*m_volume) &&
                     areAlike(m_volume->grid(), scene.volume->grid());
  if (!suits)
    return;
  m_context.messages.show(MessageBar::Kind::question,
                          tr("The volume before lies on the same grid and was cut by hand."), {},
                          {tr("Cut this one likewise"),
                           [this, volume = scene.volume, cuts = m_cuts] {
                             m_context.messages.hide();
                             if (m_context.session.scene().volume == volume)
                               emit cutsWanted(cuts, tr("cuts of the volume before"));
                           }},
                          {tr("Not now"), {}});
}

} // namespace limn
