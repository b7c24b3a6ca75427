// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/PdfDescription.h"

#include "io/AtomicFile.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

class PdfDescription : public testing::Test {
protected:
  std::string readBack(const std::string& content) {
    const std::filesystem::path path = folder.path() / "figure.pdf";
    writeFileAtomically(path, content);
    return readPdfDescription(path);
  }

  test::TemporaryFolder folder;
};

TEST_F(PdfDescription, isReadWhereverItStands) {
  const std::string text = R"({"name": "a < b & c > d", "more": "&lt;"})";
  // Pieces of 65,536 bytes are read: the marks lie across their ends, too.
  for (const std::size_t before : {0u, 100u, 65000u, 65530u, 65536u, 200000u})
    EXPECT_EQ(readBack("%PDF-1.4\n" + std::string(before, 'x') + pdfMetadata(text) + std::string(70000, 'y')),
              text)
        << before;
}

TEST_F(PdfDescription, isEmptyOfOtherFiles) {
  EXPECT_EQ(readBack(""), "");
  EXPECT_EQ(readBack("%PDF-1.4 of another program"), "");
  EXPECT_EQ(readBack("%PDF-1.4 <limn:description> cut off"), "");
  EXPECT_EQ(readPdfDescription(folder.path() / "missing.pdf"), "");
}

TEST_F(PdfDescription, tellsPdfFilesByTheirFirstBytes) {
  const std::filesystem::path path = folder.path() / "named.png";
  writeFileAtomically(path, "%PDF-1.7\n");
  EXPECT_TRUE(isPdf(path));
  writeFileAtomically(path, "%PD");
  EXPECT_FALSE(isPdf(path));
  EXPECT_FALSE(isPdf(folder.path()));
  EXPECT_FALSE(isPdf(folder.path() / "missing.pdf"));
}

} // namespace
} // namespace limn
