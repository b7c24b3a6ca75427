// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewCommands.h"

#include "scene/view/FirstView.h"
#include "widgets/view/overlay/OrientationMarks.h"

#include <QKeyEvent>

#include <algorithm>
#include <numbers>
#include <span>

namespace limn {
namespace {

using namespace viewcommand;

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

using KeyCommand = std::pair<int, ViewCommand>;

const KeyCommand letterCommands[] = {{Qt::Key_A, LookFrom{StandardView::anterior}},
                                     {Qt::Key_P, LookFrom{StandardView::posterior}},
                                     {Qt::Key_L, LookFrom{StandardView::left}},
                                     {Qt::Key_S, LookFrom{StandardView::superior}},
                                     {Qt::Key_I, LookFrom{StandardView::inferior}},
                                     {Qt::Key_R, Reset{}},
                                     {Qt::Key_W, UseTool{ViewTool::windowLevel}},
                                     {Qt::Key_M, UseTool{ViewTool::pan}},
                                     {Qt::Key_Z, UseTool{ViewTool::zoom}},
                                     {Qt::Key_X, UseTool{ViewTool::scissors}},
                                     {Qt::Key_K, UseTool{ViewTool::piece}},
                                     {Qt::Key_D, UseTool{ViewTool::distance}},
                                     {Qt::Key_G, UseTool{ViewTool::angle}},
                                     {Qt::Key_E, UseTool{ViewTool::ellipse}},
                                     {Qt::Key_N, UseTool{ViewTool::mark}},
                                     {Qt::Key_BracketLeft, UseTool{ViewTool::rotate}},
                                     {Qt::Key_Space, Swap{}}};

const KeyCommand symbolCommands[] = {
    {Qt::Key_Left, Rotate{-1, 0}},      {Qt::Key_Right, Rotate{1, 0}}, {Qt::Key_Up, Rotate{0, -1}},
    {Qt::Key_Down, Rotate{0, 1}},       {Qt::Key_Plus, Zoom{1}},       {Qt::Key_Equal, Zoom{1}},
    {Qt::Key_Minus, Zoom{-1}},          {Qt::Key_Return, CloseLine{}}, {Qt::Key_Enter, CloseLine{}},
    {Qt::Key_Backspace, ShortenLine{}}, {Qt::Key_Delete, Remove{}},    {Qt::Key_Escape, Cancel{}}};

ViewCommand commandIn(std::span<const KeyCommand> commands, int key) {
  const auto found = std::ranges::find(commands, key, &KeyCommand::first);
  return found == commands.end() ? std::monostate{} : found->second;
}

} // namespace

bool isRepeatable(const ViewCommand& command) {
  return std::holds_alternative<Rotate>(command) || std::holds_alternative<Zoom>(command);
}

ViewCommand commandOf(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
    return std::monostate{};
  const int key = event.key();
  const bool keypad = event.modifiers() & Qt::KeypadModifier;
  const bool shift = event.modifiers() & Qt::ShiftModifier;
  if (const ViewCommand command = standardViewOf(key, keypad, shift); command.index() != 0)
    return command;
  if (const ViewCommand command = commandIn(symbolCommands, key); command.index() != 0)
    return command;
  if (shift)
    return std::monostate{};
  if (key >= Qt::Key_0 && key <= Qt::Key_9 && !keypad)
    return WindowPreset{key - Qt::Key_0};
  return commandIn(letterCommands, key);
}

std::optional<Camera> cameraAfter(const ViewCommand& command, const Camera& camera, const Volume& volume,
                                  const ViewFrame& frame) {
  const Grid& grid = volume.grid();
  const auto fitted = [&](const Camera& placed) {
    return framed(placed, grid, frame.visible(), frame.aspect);
  };
  const auto from = [&](StandardView view) { return fitted(standardView(camera, grid, view)); };
  if (const auto* look = std::get_if<LookFrom>(&command))
    return from(look->view);
  if (const auto* look = std::get_if<LookAlong>(&command)) {
    Camera placed = standardView(camera, grid, StandardView::anterior);
    placed.position = placed.target + glm::length(placed.position - placed.target) * look->from;
    placed.up = look->up;
    return fitted(placed);
  }
  if (std::holds_alternative<LookFromNearest>(command))
    return from(nearestStandardView(camera));
  if (std::holds_alternative<Reset>(command))
    return fitted(firstView(camera, grid, volume.info().orientationKnown));
  if (const auto* turn = std::get_if<Rotate>(&command)) {
    const double step = keyTurnDeg * std::numbers::pi / 180.0;
    return orbitedAbout(camera, -turn->right * step, -turn->down * step,
                        centreBeforeEye(camera, frame.turnsAbout));
  }
  if (const auto* zoom = std::get_if<Zoom>(&command))
    return wheelZoomed(camera, zoom->notches * wheelNotch);
  return std::nullopt;
}

} // namespace limn
