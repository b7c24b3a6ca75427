// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAbstractItemView;

namespace limn {

/// Of lists in panels whose rows bear marks, logical pixels: marks stand clear of each other.
inline constexpr int listRowHeight = 24;

/// Makes a list or a tree as high as its rows and the header that it shows, at most `mostRows` of them, from
/// where on it scrolls; one without rows is hidden. Rows are of one height.
void fitToRows(QAbstractItemView& view, int rows, int mostRows);

} // namespace limn
