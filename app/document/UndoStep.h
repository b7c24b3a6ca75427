// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QUndoCommand;
class QUndoStack;

namespace limn {

/// One step of an undo stack, known by itself: its number becomes another's once the oldest steps are
/// forgotten.
class UndoStep {
public:
  /// The step that was done last.
  explicit UndoStep(const QUndoStack& stack);

  /// Looks where the step is now. To be called each time that the stack's index has changed, because a step
  /// that comes later may lie where one lay that is gone.
  void follow();

  /// Whether it is done: neither undone nor gone with another volume. It stays so once it is too old to be
  /// undone.
  bool isDone() const { return m_isDone; }

private:
  const QUndoStack* m_stack;
  int m_place;                ///< among the stack's steps
  const QUndoCommand* m_step; ///< null once it has left the stack
  bool m_isDone;
};

} // namespace limn
