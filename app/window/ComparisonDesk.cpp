// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ComparisonDesk.h"

#include "app/actions/Actions.h"
#include "app/document/Session.h"
#include "widgets/view/CompareView.h"

namespace limn {

ComparisonDesk::ComparisonDesk(Session& session, CompareView& view, const Actions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_view(view), m_actions(actions) {
  connect(actions.layouts, &QActionGroup::triggered, this,
          [this](QAction* chosen) { setLayout(static_cast<CompareLayout>(chosen->data().toInt())); });
  for (int side = 0; side < 2; ++side)
    connect(actions.models[static_cast<std::size_t>(side)], &QActionGroup::triggered, this,
            [this, side](QAction* chosen) {
              setSideModel(side, static_cast<ShadingModel>(chosen->data().toInt()));
            });
  connect(&view, &CompareView::modelChosen, this, &ComparisonDesk::setSideModel);
}

void ComparisonDesk::setLayout(CompareLayout layout) {
  m_beforeImage.reset();
  m_view.setCompareLayout(layout);
  checkOnly(*m_actions.layouts, static_cast<int>(layout));
  show();
}

void ComparisonDesk::setSideModel(int side, ShadingModel model) {
  if (m_view.compareLayout() == CompareLayout::single) {
    Shading shading = m_session.scene().shading;
    shading.model = model;
    m_session.setShading(shading, {nextGestureId(), tr("change model")});
    return;
  }
  (side == 0 ? m_left : m_right) = model;
  show();
}

void ComparisonDesk::showOpened() {
  const Scene& scene = m_session.scene();
  const bool isImage =
      scene.volume && imageNormalAxis(scene.volume->grid()) && scene.shading.model == ShadingModel::none;
  if (isImage && !m_beforeImage) {
    const CompareLayout before = m_view.compareLayout();
    setLayout(CompareLayout::single);
    m_beforeImage = before;
  } else if (!isImage && m_beforeImage) {
    setLayout(*m_beforeImage);
  }
}

void ComparisonDesk::show() {
  const ShadingModel single = m_session.scene().shading.model;
  const bool isSingle = m_view.compareLayout() == CompareLayout::single;
  m_view.setModels(m_left, m_right);
  emit modelsShown(isSingle ? std::vector{single} : std::vector{m_left, m_right});
  emit shown();
}

void ComparisonDesk::describe(SessionDocument& session) const {
  session.layout = m_view.compareLayout();
  session.leftModel = m_left;
  session.rightModel = m_right;
  session.wipe = m_view.wipePosition();
}

void ComparisonDesk::restore(const SessionDocument& session) {
  m_left = session.leftModel;
  m_right = session.rightModel;
  m_view.setWipePosition(session.wipe);
  setLayout(session.layout);
}

} // namespace limn
