// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewKeys.h"

#include "scene/view/FirstView.h"

#include <QKeyEvent>

#include <numbers>

namespace limn {
namespace {

using namespace viewcommand;

constexpr double keyTurnDeg = 5.0; // of an arrow key
constexpr int wheelNotch = 120;

// Slicer's keys: a keypad key arrives as a digit or, with the number lock off, as a cursor key.
ViewCommand standardViewOf(int key, bool keypad, bool shift) {
  const auto pair = [shift](StandardView plain, StandardView shifted) {
    return LookFrom{shift ? shifted : plain};
  };
  if (key == Qt::Key_End || (keypad && key == Qt::Key_1))
    return pair(StandardView::anterior, StandardView::posterior);
  if (key == Qt::Key_PageDown || (keypad && key == Qt::Key_3))
    return pair(StandardView::left, StandardView::right);
  if (key == Qt::Key_Home || (keypad && key == Qt::Key_7))
    return pair(StandardView::superior, StandardView::inferior);
  if (key == Qt::Key_Insert || (keypad && key == Qt::Key_0))
    return LookFromNearest{};
  return std::monostate{};
}

ViewCommand letterCommandOf(int key) {
  switch (key) {
  case Qt::Key_A:
    return LookFrom{StandardView::anterior};
  case Qt::Key_P:
    return LookFrom{StandardView::posterior};
  case Qt::Key_L:
    return LookFrom{StandardView::left};
  case Qt::Key_S:
    return LookFrom{StandardView::superior};
  case Qt::Key_I:
    return LookFrom{StandardView::inferior};
  case Qt::Key_R:
    return Reset{};
  case Qt::Key_W:
    return UseTool{ViewTool::windowLevel};
  case Qt::Key_M:
    return UseTool{ViewTool::pan};
  case Qt::Key_Z:
    return UseTool{ViewTool::zoom};
  case Qt::Key_BracketLeft:
    return UseTool{ViewTool::rotate};
  case Qt::Key_Space:
    return Swap{};
  default:
    return std::monostate{};
  }
}

ViewCommand symbolCommandOf(int key) {
  switch (key) {
  case Qt::Key_Left:
    return Rotate{-1, 0};
  case Qt::Key_Right:
    return Rotate{1, 0};
  case Qt::Key_Up:
    return Rotate{0, -1};
  case Qt::Key_Down:
    return Rotate{0, 1};
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    return Zoom{1};
  case Qt::Key_Minus:
    return Zoom{-1};
  case Qt::Key_Question:
    return ListShortcuts{};
  case Qt::Key_Escape:
    return Cancel{};
  default:
    return std::monostate{};
  }
}

} // namespace

ViewCommand commandOf(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
    return std::monostate{};
  const int key = event.key();
  const bool keypad = event.modifiers() & Qt::KeypadModifier;
  const bool shift = event.modifiers() & Qt::ShiftModifier;
  if (const ViewCommand command = standardViewOf(key, keypad, shift); command.index() != 0)
    return command;
  if (const ViewCommand command = symbolCommandOf(key); command.index() != 0)
    return command;
  if (shift)
    return std::monostate{};
  if (key >= Qt::Key_0 && key <= Qt::Key_9 && !keypad)
    return WindowPreset{key - Qt::Key_0};
  return letterCommandOf(key);
}

std::optional<Camera> cameraAfter(const ViewCommand& command, const Camera& camera, const Grid& grid,
                                  double aspect) {
  const auto from = [&](StandardView view) { return framed(standardView(camera, grid, view), grid, aspect); };
  if (const auto* look = std::get_if<LookFrom>(&command))
    return from(look->view);
  if (std::holds_alternative<LookFromNearest>(command))
    return from(nearestStandardView(camera));
  if (std::holds_alternative<Reset>(command))
    return framed(firstView(camera, grid), grid, aspect);
  if (const auto* turn = std::get_if<Rotate>(&command)) {
    const double step = keyTurnDeg * std::numbers::pi / 180.0;
    return orbited(camera, -turn->right * step, -turn->down * step);
  }
  if (const auto* zoom = std::get_if<Zoom>(&command))
    return wheelZoomed(camera, zoom->notches * wheelNotch);
  return std::nullopt;
}

} // namespace limn
