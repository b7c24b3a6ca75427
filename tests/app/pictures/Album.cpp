// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pictures/Album.h"

#include <gtest/gtest.h>

namespace limn::test {
namespace {

bool hasOneColour(const QImage& picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.pixel(x, y) != picture.pixel(0, 0))
        return false;
  return true;
}

} // namespace

Album::Album(std::filesystem::path folder, const QString& prefix)
    : m_folder(std::move(folder)), m_prefix(prefix) {
  std::filesystem::create_directories(m_folder);
}

void Album::add(const QImage& picture, const QString& name) {
  const QString path = QString::fromStdString((m_folder / (m_prefix + name).toStdString()).string() + ".png");
  EXPECT_FALSE(m_names.contains(name)) << name.toStdString() << " would be overwritten";
  m_names.insert(name);
  EXPECT_FALSE(hasOneColour(picture)) << name.toStdString() << " shows nothing";
  EXPECT_TRUE(picture.save(path)) << "cannot write " << path.toStdString();
}

} // namespace limn::test
