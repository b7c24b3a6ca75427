// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"
#include "io/dicom/header/DicomParser.h"
#include "io/dicom/header/DicomTags.h"

namespace limn::test {
namespace {

DicomDataset parsed(const DicomBuilder& file) {
  TemporaryFolder folder;
  file.write(folder.path() / "image");
  return parseDicom(folder.path() / "image").dataset;
}

TEST(DicomParser, everyAttributeThatHasANameIsKept) {
  DicomBuilder file = slice(1, 0.0);
  for (const tag::Attribute& attribute : tag::all) {
    if (attribute.kind == tag::Kind::sequence)
      file.sequence(attribute.tag, {DicomBuilder().text(tag::stackId, "SH", "1")});
    else if (attribute.kind == tag::Kind::value)
      file.text(attribute.tag, "LO", "text");
  }
  const DicomDataset dataset = parsed(file);
  for (const tag::Attribute& attribute : tag::all) {
    const auto found = dataset.elements.find(attribute.tag);
    EXPECT_EQ(found != dataset.elements.end(), attribute.kind != tag::Kind::pixels)
        << std::hex << attribute.tag;
    if (attribute.kind == tag::Kind::sequence && found != dataset.elements.end()) {
      EXPECT_EQ(found->second.items.size(), 1u) << std::hex << attribute.tag;
    }
  }
}

TEST(DicomParser, theListOfAttributesIsInOrderAndNamesEachOnce) {
  for (std::size_t i = 1; i < tag::all.size(); ++i)
    EXPECT_LT(tag::all[i - 1].tag, tag::all[i].tag);
}

// PS3.5, 7.1.2: only the value representations named there have the long form. "D ", of a private attribute
// that pads, stands within "OD OF" and is none of them.
TEST(DicomParser, aDamagedValueRepresentationIsNotTakenForOneOfTheLongForm) {
  for (const char* vr : {"D ", " O", "B "}) {
    const DicomDataset dataset = parsed(slice(1, 0.0).text(0x00090010, vr, "ab"));
    EXPECT_EQ(textOf(dataset, tag::seriesInstance), "1.2.3.4") << vr;
  }
}

} // namespace
} // namespace limn::test
