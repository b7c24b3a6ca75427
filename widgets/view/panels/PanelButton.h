// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace limn {

/// A button of a panel that lies over the pictures: `text` is its label and what assistive technology reads,
/// `name` its object name.
QPushButton* panelButton(const QString& text, const QString& name, QWidget* parent);

} // namespace limn
