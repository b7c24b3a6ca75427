// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

class QModelIndex;
class QPainter;
class QStyleOptionViewItem;

namespace limn {

/// What lists of presets have in common, in logical pixels; `index` has presetRole.

/// Marks the card of a preset that is in use, under the pointer or has the keyboard.
void paintPresetCard(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                     const QRectF& card);

/// What a preset makes of the volume, where that is known and there is something to see, otherwise its curve;
/// with a star where it is a favourite.
void paintPresetPicture(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                        const QRectF& place);

} // namespace limn
