// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>

namespace limn::test {

/// Compares figures with those of cases and remembers which cases were compared, so that a test can fail for
/// a case that it left out. A case counts only where one of its figures met a computed one.
class CaseLedger {
public:
  /// |value - expected| ≤ tolerance.
  void expectNear(const std::string& id, const std::string& what, double value, double expected,
                  double tolerance) {
    EXPECT_NEAR(value, expected, tolerance) << id << " " << what;
    double& largest = m_largestErrors[id];
    largest = std::max(largest, std::abs(value - expected));
  }

  /// lowest ≤ value ≤ highest: an observed order in the band of the stated one.
  void expectWithin(const std::string& id, const std::string& what, double value, double lowest,
                    double highest) {
    EXPECT_GE(value, lowest) << id << " " << what;
    EXPECT_LE(value, highest) << id << " " << what;
    m_largestErrors[id];
  }

  /// Fails for every case that `isMeant(case)` admits and that was not compared, by its id.
  template <class Predicate>
  void expectEvery(const nlohmann::json& cases, Predicate isMeant) const {
    std::size_t meant = 0;
    for (const nlohmann::json& one : cases) {
      if (!isMeant(one))
        continue;
      ++meant;
      EXPECT_TRUE(m_largestErrors.contains(one["id"])) << one["id"] << " is compared by no test";
    }
    EXPECT_GT(meant, 0u) << "the file holds none of the cases meant";
    std::cout << m_largestErrors.size() << " cases compared, " << meant << " meant\n";
  }

  void print() const {
    for (const auto& [id, error] : m_largestErrors)
      std::cout << "  " << id << " " << error << "\n";
  }

private:
  std::map<std::string, double> m_largestErrors; ///< by id
};

} // namespace limn::test
