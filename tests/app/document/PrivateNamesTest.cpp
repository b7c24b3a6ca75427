// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/PrivateNames.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const PatientLabel quillon{"ZEBEDEE^QUILLON", "PID-77.4411", "19870615"};

TEST(PrivateNames, partsOfTheNameAndTheNumberAreFoundHoweverTheyAreWritten) {
  for (const char* name :
       {"Quillon", "ct_zebedee_2", "QuillonZ", "pid774411", "PID 77 4411 head", "head.PID-77.4411"})
    EXPECT_TRUE(mayNameThePatient(name, quillon)) << name;
  for (const char* name : {"head", "DICOM", "CT 3", "series2.nii.gz", "phantom:3"})
    EXPECT_FALSE(mayNameThePatient(name, quillon)) << name;
}

TEST(PrivateNames, shortNamesCountAsWholeWords) {
  const PatientLabel li{"LI^NA", "7", ""};
  EXPECT_TRUE(mayNameThePatient("Li-Na", li));
  EXPECT_TRUE(mayNameThePatient("case 7", li));
  EXPECT_FALSE(mayNameThePatient("Limn", li));
  EXPECT_FALSE(mayNameThePatient("series17", li));
}

TEST(PrivateNames, datesAndUidsAreFoundWithoutKnowingThem) {
  for (const char* name :
       {"20240312", "2024-03-12 CT", "ct12.03.2024", "1.2.826.0.1.3680043", "MR.1.3.12.2.1107.5"})
    EXPECT_TRUE(mayNameThePatient(name, {})) << name;
  for (const char* name : {"256x256x108", "99999999", "1.5.2", "120240312", "v2.0.1"})
    EXPECT_FALSE(mayNameThePatient(name, {})) << name;
}

TEST(PrivateNames, lettersOfEveryAlphabetCount) {
  const PatientLabel patient{"Müller^Jörg", "", ""};
  EXPECT_TRUE(mayNameThePatient(QString::fromUtf8("MÜLLER_ct"), patient));
  EXPECT_FALSE(mayNameThePatient("muller", patient)); // another word
}

TEST(PrivateNames, aPathIsAsTellingAsItsParts) {
  EXPECT_TRUE(pathMayNameThePatient("../Quillon/CT", quillon));
  EXPECT_FALSE(pathMayNameThePatient("../studies/CT", quillon));
}

TEST(PrivateNames, aNameThatTellsIsReplacedByWhatTheVolumeIs) {
  Grid grid;
  grid.dims = {2, 3, 4};
  VolumeInfo info;
  info.modality = "CT";
  info.patient = quillon;
  const Volume volume(grid, std::vector<std::int16_t>(24, 1), {}, {}, info);
  EXPECT_EQ(shareableName("/data/quillon", volume), "ct-2x3x4");
  EXPECT_EQ(shareableName("/data/quillon/head", volume), "head");
  EXPECT_EQ(plainDescription(volume), QString::fromUtf8("CT 2×3×4"));
}

} // namespace
} // namespace limn
