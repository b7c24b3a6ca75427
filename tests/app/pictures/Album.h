// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSet>

#include <filesystem>

namespace limn::test {

/// Pictures of a window, written as PNGs whose names say what they show: "1280x800-dark-effects.png".
class Album {
public:
  /// Makes the folder. `prefix` begins every name.
  Album(std::filesystem::path folder, const QString& prefix);

  /// Writes a picture. Fails the test where the name is taken, the picture shows one colour alone, or it
  /// cannot be written.
  void add(const QImage& picture, const QString& name);

private:
  std::filesystem::path m_folder;
  QString m_prefix;
  QSet<QString> m_names;
};

} // namespace limn::test
