// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Items.h"

#include "scene/basics/Error.h"

#include <dcmtk/dcmdata/dcdicent.h>
#include <dcmtk/dcmdata/dcelem.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <dcmtk/dcmdata/dcsequen.h>
#include <dcmtk/dcmdata/dcvrfd.h>

#include <charconv>
#include <cmath>
#include <cstdio>

namespace limn::dicom {

bool holds(DcmItem& item, const DcmTagKey& tag) {
  return item.tagExistsWithValue(tag);
}

std::string textIn(DcmItem& item, const DcmTagKey& tag) {
  OFString text;
  if (item.findAndGetOFStringArray(tag, text).bad())
    return {};
  std::string plain(text.c_str(), text.size());
  plain.erase(plain.find_last_not_of(std::string(" \0", 2)) + 1);
  plain.erase(0, plain.find_first_not_of(' '));
  return plain;
}

std::vector<double> numbersIn(DcmItem& item, const DcmTagKey& tag) {
  DcmElement* element = nullptr;
  if (item.findAndGetElement(tag, element).bad())
    return {};
  constexpr unsigned long most = 64; // no attribute of a look has more
  std::vector<double> numbers;
  for (unsigned long i = 0; i < std::min(element->getVM(), most); ++i) {
    Float64 number = 0.0;
    if (element->getFloat64(number, i).bad() || !std::isfinite(number))
      return {};
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<double> numberIn(DcmItem& item, const DcmTagKey& tag) {
  const std::vector<double> numbers = numbersIn(item, tag);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::vector<std::uint16_t> wordsIn(DcmItem& item, const DcmTagKey& tag) {
  DcmElement* element = nullptr;
  if (item.findAndGetElement(tag, element).bad())
    return {};
  Uint16* words = nullptr;
  if (element->getUint16Array(words).bad() || !words)
    return {};
  return {words, words + element->getLengthField() / sizeof(Uint16)};
}

std::vector<DcmItem*> itemsIn(DcmItem& item, const DcmTagKey& tag) {
  DcmSequenceOfItems* sequence = nullptr;
  if (item.findAndGetSequence(tag, sequence).bad() || !sequence)
    return {};
  std::vector<DcmItem*> items;
  for (DcmObject* next = nullptr; (next = sequence->nextInContainer(next));)
    items.push_back(static_cast<DcmItem*>(next));
  return items;
}

std::string nameOf(const DcmTagKey& tag) {
  return std::string(DcmTag(tag).getTagName()) + " " + tag.toString().c_str();
}

std::string decimalText(double number) {
  constexpr std::size_t longest = 16;
  char text[40];
  const auto shortest = std::to_chars(text, text + sizeof text, number);
  int digits = 16;
  std::string written(text, shortest.ptr);
  while (written.size() > longest) {
    std::snprintf(text, sizeof text, "%.*g", digits--, number);
    written = text;
  }
  return written;
}

void require(bool succeeded, const DcmTagKey& tag) {
  if (!succeeded)
    throw Error(Error::Kind::other,
                Message::tr("The attribute %1 cannot be written; please report it.").arg(nameOf(tag)));
}

void putText(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
  require(item.putAndInsertOFStringArray(tag, OFString(text.data(), text.size())).good(), tag);
}

void putNumbers(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& numbers) {
  const auto count = static_cast<unsigned long>(numbers.size());
  require(item.putAndInsertFloat64Array(tag, numbers.data(), count).good(), tag);
}

void putCount(DcmItem& item, const DcmTagKey& tag, int number) {
  require(item.putAndInsertUint16(tag, static_cast<Uint16>(number)).good(), tag);
}

void putNothing(DcmItem& item, const DcmTagKey& tag) {
  require(item.insertEmptyElement(tag).good(), tag);
}

DcmItem& addItem(DcmItem& item, const DcmTagKey& sequence) {
  DcmItem* added = nullptr;
  require(item.findOrCreateSequenceItem(sequence, added, -2).good() && added, sequence);
  return *added;
}

} // namespace limn::dicom
