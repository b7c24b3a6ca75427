// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGuiApplication>

#include <array>
#include <optional>

namespace limn {

/// Qt's fonts, which need an application, for commands that need no display. While one lives there is no
/// other application.
class FontsWithoutDisplay {
public:
  FontsWithoutDisplay();

private:
  int m_count = 3;
  std::array<char, 5> m_name{"limn"};
  std::array<char, 10> m_option{"-platform"};
  std::array<char, 10> m_platform{"offscreen"};
  std::array<char*, 4> m_words{m_name.data(), m_option.data(), m_platform.data(), nullptr};
  std::optional<QGuiApplication> m_application;
};

} // namespace limn
