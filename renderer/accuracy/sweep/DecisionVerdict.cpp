// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/FigureText.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double sameP99_9 = 0.15;
constexpr double sameMean = 0.005;
constexpr double fasterBy = 0.9; ///< times differ by less between two runs

bool isAsAccurate(const ImageError& error, const ImageError& own) {
  return error.p99_9 <= own.p99_9 + sameP99_9 && error.mean <= own.mean + sameMean;
}

bool beats(const DecisionCost& cost, const DecisionCost& own) {
  return !cost.isDefault && cost.timesDefault <= fasterBy && isAsAccurate(cost.error, own.error) &&
         isAsAccurate(cost.fineError, own.fineError);
}

std::string sentenceOn(const DecisionCost& cost) {
  std::string memory;
  if (cost.extraMb != 0.0)
    memory = ", with " + threeDigits(std::abs(cost.extraMb)) + " MB " +
             (cost.extraMb > 0.0 ? "more" : "less") + " of graphics memory";
  return "Another way would be faster here and as accurate: " + cost.group + ", " + cost.name + ", in " +
         std::to_string(std::lround(100.0 * cost.timesDefault)) + " % of the time" + memory + ".";
}

} // namespace

std::vector<std::string> verdictOn(const std::vector<DecisionCost>& costs) {
  std::vector<std::string> sentences;
  for (const DecisionCost& cost : costs) {
    const auto own = std::ranges::find_if(
        costs, [&cost](const DecisionCost& other) { return other.isDefault && other.group == cost.group; });
    if (own != costs.end() && beats(cost, *own))
      sentences.push_back(sentenceOn(cost));
  }
  if (sentences.empty() && !costs.empty())
    sentences.emplace_back("No other way of any decision was as accurate here and faster by a tenth.");
  return sentences;
}

} // namespace limn
