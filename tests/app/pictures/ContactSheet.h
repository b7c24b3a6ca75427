// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <vector>

namespace limn::test {

struct NamedPicture {
  QString name; ///< below the picture, in lines
  QImage picture;
};

/// Pictures beside each other on pages of at most `columns` · `rows`, each as large as `cell` allows.
std::vector<QImage> contactSheet(const std::vector<NamedPicture>& pictures, int columns, int rows,
                                 const QSize& cell);

} // namespace limn::test
