// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/UndoStep.h"

#include <QUndoStack>

namespace limn {

UndoStep::UndoStep(const QUndoStack& stack)
    : m_stack(&stack), m_place(stack.index() - 1), m_step(stack.command(m_place)), m_isDone(m_step) {}

// With each step that comes at most one is forgotten.
void UndoStep::follow() {
  if (!m_step)
    return;
  const bool isForgotten = m_isDone && m_stack->index() > m_place && m_stack->command(m_place) != m_step;
  if (isForgotten)
    --m_place;
  if (m_stack->command(m_place) != m_step)
    m_step = nullptr;
  // One that was done and left at the lower end holds for good; any other has gone with what it did.
  m_isDone = m_step ? m_stack->index() > m_place : isForgotten && m_place < 0;
}

} // namespace limn
