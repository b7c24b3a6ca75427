// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"
#include "io/dicom/header/DicomHeader.h"
#include "io/dicom/header/DicomTags.h"

namespace limn::test {
namespace {

std::string decodedName(const std::string& characterSet, const std::string& bytes) {
  const TemporaryFolder folder;
  slice(1, 0.0)
      .text(tag::characterSet, "CS", characterSet)
      .text(tag::patientName, "PN", bytes)
      .write(folder.path() / "image");
  return utf8TextOf(parseDicom(folder.path() / "image").dataset, tag::patientName);
}

// The examples of PS3.5, annexes H (Japanese), I (Korean), J and K (Chinese).
TEST(DicomCharacterSet, namesOfEastAsiaAreDecodedAsTheStandardShows) {
  EXPECT_EQ(decodedName("\\ISO 2022 IR 87", "Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B="
                                            "\x1b$B$d$^$@\x1b(B^\x1b$B$?$m$&\x1b(B"),
            "Yamada^Tarou=山田^太郎=やまだ^たろう");
  EXPECT_EQ(decodedName("ISO 2022 IR 13\\ISO 2022 IR 87",
                        "\xd4\xcf\xc0\xde^\xc0\xdb\xb3=\x1b$B;3ED\x1b(J^\x1b$BB@O:\x1b(J"),
            "ﾔﾏﾀﾞ^ﾀﾛｳ=山田^太郎");
  EXPECT_EQ(decodedName("\\ISO 2022 IR 149", "Hong^Gildong=\x1b$)C\xfb\xf3^\x1b$)C\xd1\xce\xd4\xd7="
                                             "\x1b$)C\xc8\xab^\x1b$)C\xb1\xe6\xb5\xbf"),
            "Hong^Gildong=洪^吉洞=홍^길동");
  EXPECT_EQ(decodedName("GB18030", "Wang^XiaoDong=\xcd\xf5^\xd0\xa1\xb6\xab"), "Wang^XiaoDong=王^小东");
  EXPECT_EQ(decodedName("ISO_IR 192", "Wang^XiaoDong=\xe7\x8e\x8b^\xe5\xb0\x8f\xe6\x9d\xb1"),
            "Wang^XiaoDong=王^小東");
}

TEST(DicomCharacterSet, alphabetsOfOneByteAreDecoded) {
  EXPECT_EQ(decodedName("ISO_IR 100", "Buc^J\xe9r\xf4me"), "Buc^Jérôme");
  EXPECT_EQ(decodedName("ISO_IR 144", "\xbb\xee\xda"), "Люк");
  EXPECT_EQ(decodedName("ISO_IR 126", "\xc4\xe9\xef\xed"), "Διον");
  EXPECT_EQ(decodedName("ISO_IR 138", "\xf9\xf8\xe5\xef"), "שרון");
}

// Many writers name a set for code extensions where none are used.
TEST(DicomCharacterSet, theTermsThatScannersWriteAreUnderstood) {
  EXPECT_EQ(decodedName("ISO 2022 IR 100", "Buc^J\xe9r\xf4me"), "Buc^Jérôme");
  EXPECT_EQ(decodedName("ISO 2022 IR 87", "\x1b$B;3ED\x1b(B"), "山田");
  EXPECT_EQ(decodedName("ISO_IR 100\\ISO 2022 IR 144", "J\xe9r"), "Jér");
}

TEST(DicomCharacterSet, whatIsNotOfTheSetLeavesTheRestReadable) {
  for (const char* set : {"", "ISO_IR 192", "nonsense"}) {
    const std::string text = decodedName(set, "Buc^J\xe9r");
    EXPECT_TRUE(text.starts_with("Buc^J") && text.ends_with("r")) << set << ": " << text;
  }
}

} // namespace
} // namespace limn::test
