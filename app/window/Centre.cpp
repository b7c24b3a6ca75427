// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/Centre.h"

#include "app/window/MessageBar.h"
#include "cpu/CpuEngine.h"
#include "raycaster/RayCasterEngine.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"

#include <QMainWindow>
#include <QVBoxLayout>

namespace limn {

Centre::Centre(QMainWindow& window, const OpenGlOffer& openGl, ViewEngine engine,
               const std::optional<MemoryBudget>& memory) {
  auto* centre = new QWidget(&window);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  for (MessageBar** bar : {&recovery, &unsafe, &patient, &tour, &messages})
    column->addWidget(*bar = new MessageBar(centre));
  recovery->setObjectName(QStringLiteral("recoveryBar"));
  patient->setObjectName(QStringLiteral("patientBar"));
  tour->setObjectName(QStringLiteral("tourBar"));
  unsafe->setObjectName(QStringLiteral("unsafeBar"));
  view = new CompareView({openGl.problem.isEmpty() ? MakeEngine(makeRayCasterEngine) : MakeEngine(),
                          [memory] { return makeCpuEngine(0, memory.value_or(MemoryBudget())); }},
                         engine, centre);
  column->addWidget(planes = new PlaneDeck(*view, centre), 1);
  window.setCentralWidget(centre);
}

} // namespace limn
