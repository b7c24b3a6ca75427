// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/CurveMenu.h"

#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QMenu>

namespace limn {
namespace {

void addPointActions(QMenu& menu, TransferFunctionCanvas& canvas, std::size_t index) {
  if (!contains(canvas.selected(), index))
    canvas.selectPoints({index});
  const std::size_t count = canvas.selected().size();
  QAction* deletion = menu.addAction(
      count > 1 ? TransferFunctionCanvas::tr("Delete %1 points").arg(count)
                : TransferFunctionCanvas::tr("Delete"),
      &canvas, [&canvas] { canvas.apply(withoutSelected(canvas.plot(), canvas.shownDecimals())); });
  deletion->setEnabled(canvas.transferFunction().points.size() > 1);
  menu.addAction(hasColors(canvas.subject()) ? TransferFunctionCanvas::tr("Colour and numbers…")
                                             : TransferFunctionCanvas::tr("Numbers…"),
                 &canvas, [&canvas, index] { emit canvas.pointDetailsRequested(index); });
}

} // namespace

void openCurveMenu(TransferFunctionCanvas& canvas, const QPointF& position) {
  auto* menu = new QMenu(&canvas);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const CurveHit hit = hitAt(canvas.transform(), canvas.transferFunction(), position);
  if (hit.part == CurveHit::Part::point)
    addPointActions(*menu, canvas, hit.index);
  else
    menu->addAction(TransferFunctionCanvas::tr("Add point here"), &canvas,
                    [&canvas, position] { canvas.addPoint(position); });
  menu->addSeparator();
  menu->addAction(TransferFunctionCanvas::tr("Select all points"), &canvas,
                  [&canvas] { canvas.selectPoints(allPoints(canvas.transferFunction())); });
  menu->addAction(TransferFunctionCanvas::tr("Show all values"), &canvas, &TransferFunctionCanvas::resetView);
  if (canvas.hasPin())
    menu->addAction(TransferFunctionCanvas::tr("Remove the pin"), &canvas,
                    [&canvas] { canvas.setPinnedValue(std::nullopt); });
  menu->popup(canvas.mapToGlobal(position.toPoint()));
}

} // namespace limn
