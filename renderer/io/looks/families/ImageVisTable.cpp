// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double tableTolerance = 1.0 / 255.0; // of colour and opacity
constexpr std::size_t mostRows = 1 << 20;
constexpr int writtenRows = 256;

/// Takes the next word off a text; empty at its end.
std::string_view takeWord(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

// A count of rows, and a row of fractions. Files of single numbers in lines begin with a switch, 0 or 1.
bool isImageVisTable(std::string_view text) {
  const std::string_view first = takeWord(text);
  const std::optional<double> count = numberIn(first);
  if (!count || !(*count >= 2.0) || first.find_first_not_of("0123456789") != std::string_view::npos)
    return false;
  for (int channel = 0; channel < 4; ++channel) {
    const std::optional<double> value = numberIn(takeWord(text));
    if (!value || !(std::abs(*value) <= 2.0 || !std::isfinite(*value)))
      return false;
  }
  return true;
}

/// The next row of a text; absent at its end.
std::optional<ControlPoint> takeRow(std::string_view& text, const std::string& file, std::size_t number) {
  double values[4]{};
  for (double& value : values) {
    const std::string_view word = takeWord(text);
    if (word.empty() && &value == values)
      return std::nullopt;
    const std::optional<double> read = numberIn(word);
    if (!read)
      failReading(file, Message::tr("its row %1 does not have four numbers").arg(number), saveLookAgain);
    value = *read;
  }
  return ControlPoint{0.0, {values[0], values[1], values[2]}, values[3]};
}

/// The rows at their places from 0 to 1.
std::vector<ControlPoint> rowsOf(std::string_view text, const std::string& file) {
  const double count = numberIn(takeWord(text)).value_or(0.0);
  std::vector<ControlPoint> rows;
  while (rows.size() <= mostRows) {
    const std::optional<ControlPoint> row = takeRow(text, file, rows.size() + 1);
    if (!row)
      break;
    rows.push_back(*row);
  }
  if (rows.size() > mostRows)
    failReading(file, Message::tr("it has more than %1 rows").arg(mostRows),
                Message::tr("save it with fewer rows"));
  if (rows.size() < 2 || static_cast<double>(rows.size()) != count)
    failReading(file, Message::tr("it has %1 rows where it says another number").arg(rows.size()),
                saveLookAgain);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].value = static_cast<double>(i) / static_cast<double>(rows.size() - 1);
  return rows;
}

std::vector<ReadLook> readImageVisTable(std::string_view text, const std::string& file,
                                        const std::optional<LookTarget>& target) {
  PointLook look;
  const std::vector<ControlPoint> rows = rowsOf(text, file);
  for (const ControlPoint& row : rows)
    checkedPoint(row, file, look.changes);
  look.points = simplified(rows, tableTolerance);
  look.isRelative = true;
  if (look.points.size() < rows.size())
    look.changes.push_back(Message::tr("Its %1 rows became %2 points, within %3 of colour and opacity.")
                               .arg(rows.size(), look.points.size(), Message::rounded(tableTolerance, 2)));
  return finished(std::move(look), file, target);
}

/// The furthest that straight lines between the rows lie from the function, of whose points the table has
/// none.
double distanceOf(const TransferFunction& table, const std::vector<ControlPoint>& points) {
  double furthest = 0.0;
  for (const ControlPoint& point : points) {
    const Classified seen = classify(table, point.value);
    const glm::dvec3 color = glm::abs(seen.color - point.color);
    furthest = std::max({furthest, std::abs(seen.opacity - point.opacity), color.r, color.g, color.b});
  }
  return furthest;
}

WrittenLook writeImageVisTable(const Preset& preset, const std::optional<LookTarget>& target) {
  if (!target)
    throw Error(
        Error::Kind::input,
        Message::tr("This format divides a volume's range of values into rows, and there is no volume; "
                    "open or name the volume that it is for (--for VOLUME)."));
  WrittenLook written{std::to_string(writtenRows) + "\n", {}};
  const TransferFunction function = pointsAlone(preset, written.changes);
  TransferFunction table;
  for (int row = 0; row < writtenRows; ++row) {
    const double value = target->low + (target->high - target->low) * row / (writtenRows - 1);
    const Classified seen = classify(function, value);
    table.points.push_back({value, seen.color, seen.opacity});
    for (const double part : {seen.color.r, seen.color.g, seen.color.b, seen.opacity})
      written.text += shortest(part) + " ";
    written.text += "\n";
  }
  const double furthest = distanceOf(table, function.points);
  if (furthest > 1e-6)
    written.changes.push_back(
        Message::tr("The curve became %1 rows from %2 to %3, which differ from it by up to %4.")
            .arg(writtenRows, Message::rounded(target->low, 6), Message::rounded(target->high, 6),
                 Message::rounded(furthest, 3)));
  return written;
}

} // namespace

LookFormat imageVisTableFormat() {
  return {Message::tr("ImageVis3D table"), {".1dt"}, isImageVisTable, readImageVisTable, writeImageVisTable};
}

} // namespace limn
