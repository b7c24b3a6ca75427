// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace limn::test {

/// Curves computed from what a format says and as read agree to this.
inline constexpr double sameCurve = 1e-6;

/// The only look of a text.
inline ReadLook onlyLook(const std::string& text, const std::optional<LookTarget>& target = {}) {
  const std::vector<ReadLook> looks = parseLooks(text, "/somewhere/demo.look", target);
  EXPECT_EQ(looks.size(), 1u);
  return looks.front();
}

/// Whether one of the sentences has these words, and each ends as one.
inline bool isTold(const std::vector<Message>& changes, const std::string& words) {
  bool isFound = false;
  for (const Message& change : changes) {
    EXPECT_TRUE(change.english().ends_with(".")) << change.english();
    isFound |= change.english().find(words) != std::string::npos;
  }
  return isFound;
}

inline std::string allOf(const std::vector<Message>& changes) {
  std::string text;
  for (const Message& change : changes)
    text += change.english() + "\n";
  return text;
}

/// The sentence with which a text is refused; empty where it is read.
inline std::string refusal(const std::string& text, const std::optional<LookTarget>& target = {}) {
  try {
    parseLooks(text, "/somewhere/demo.look", target);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input) << error.what();
    EXPECT_NE(std::string(error.what()).find("demo.look"), std::string::npos) << error.what();
    return error.what();
  }
}

inline double difference(const Classified& a, const Classified& b) {
  const glm::dvec3 color = glm::abs(a.color - b.color);
  return std::max({color.r, color.g, color.b, std::abs(a.opacity - b.opacity)});
}

/// The largest difference of a function to what is expected, over a range in so many steps.
inline double largestDifference(const TransferFunction& function,
                                const std::function<Classified(double)>& expected, double low, double high,
                                int steps = 9973) {
  double largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double value = low + (high - low) * i / steps;
    largest = std::max(largest, difference(classify(function, value), expected(value)));
  }
  return largest;
}

/// Linear between points of (x, y), the plain way; constant outside; at a step the last one holds.
inline double linearAt(const std::vector<std::pair<double, double>>& points, double x) {
  if (x < points.front().first)
    return points.front().second;
  double y = points.back().second;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (x >= points[i].first && x < points[i + 1].first)
      y = points[i].second + (x - points[i].first) / (points[i + 1].first - points[i].first) *
                                 (points[i + 1].second - points[i].second);
  return x >= points.back().first ? points.back().second : y;
}

/// Written under a file name and read again.
inline ReadLook readBack(const Preset& preset, const std::string& fileName,
                         const std::optional<LookTarget>& target = {}) {
  const std::vector<ReadLook> looks = parseLooks(lookAs(fileName, preset, target).text, fileName, target);
  EXPECT_EQ(looks.size(), 1u);
  return looks.front();
}

} // namespace limn::test
