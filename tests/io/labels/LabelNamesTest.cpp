// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelNames.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(LabelNames, tellLabelsFromImages) {
  for (const char* name : {"a/liver.seg.nrrd", "label_Brain.nrrd", "Segmentation-1.nii.gz", "organ mask.nii",
                           "SEG.nii", "head-LabelMap.mha"})
    EXPECT_TRUE(isNamedLikeLabels(name)) << name;
  for (const char* name : {"labels/head.nrrd", "segment.nrrd", "masked.nii", "head.nii.gz", ""})
    EXPECT_FALSE(isNamedLikeLabels(name)) << name;
}

TEST(LabelNames, tellAStructureAsPeopleWriteIt) {
  for (const auto& [file, name] : {std::pair("a/liver.nii.gz", "liver"),
                                   {"label_Brain.nii.gz", "Brain"},
                                   {"kidney_left.nii", "kidney left"},
                                   {"vertebrae_L1.nii.gz", "vertebrae L1"},
                                   {"Segmentation_upper__liver.seg.nrrd", "upper liver"},
                                   {"brain-mask.mha", "brain"},
                                   {"mask hip bone_label.mhd", "hip bone"},
                                   {"T1_mask_brain.nrrd", "T1 mask brain"}, // no longer at an end
                                   {"left-kidney.nhdr", "left-kidney"},
                                   {"segment.nrrd", "segment"},
                                   {"spleen & co.nii.gz", "spleen & co"},
                                   {"Gef\u00e4\u00dfe_label.nrrd", "Gef\u00e4\u00dfe"},
                                   {"\u809d.nii.gz", "\u809d"}})
    EXPECT_EQ(structureName(file), name) << file;
  // Nothing is told, or it is no volume.
  for (const char* file : {"label.nrrd", "seg_mask.nii.gz", "label_1.nii", "__.nrrd", "0042.mha", ".nii.gz",
                           "liver.png", "liver", ""})
    EXPECT_EQ(structureName(file), "") << file;
  EXPECT_EQ(volumeStem("a.b/label_1.nii.gz"), "label_1");
  EXPECT_EQ(volumeStem("a.b/label_1.gz"), "");
  EXPECT_LE(structureName(std::string(4000, 'a') + ".nii").size(), 210u) << "200, and that it goes on";
}

TEST(LabelNames, tellNobodysName) {
  const PatientLabel patient{"MEIER^ANNA L\u00c4", "P-12 345", "20240105"};
  for (const auto& [file, name] : {std::pair("MEIER_ANNA_liver.nii.gz", "liver"),
                                   {"liver-of-meier.nrrd", "liver of"},
                                   {"annameier_kidney_left_mask.nii", "kidney left"},
                                   {"rib 7 P12345.mha", "rib 7"},
                                   {"P-12-345_liver.mha", "liver"},
                                   {"Mei_er_liver.mha", "liver"},
                                   {"plan_eye_lens.nii", "plan eye lens"},
                                   {"l\u00e4_spleen.nii", "spleen"}, // a short part, as a word
                                   {"2024-01-05_liver.nii.gz", "liver"},
                                   {"05.01.2024 liver.nii.gz", "liver"},
                                   {"20240105_liver.nii.gz", "liver"},
                                   {"1.2.840.113619.2.55_liver.nrrd", "liver"},
                                   {"plane.nii", "plane"},
                                   {"rib_12.nii", "rib 12"}})
    EXPECT_EQ(structureName(file, patient), name) << file;
  for (const char* file : {"MEIER_ANNA.nii.gz", "Meier-2.nrrd", "p12345.nii", "P-12-345.nii", "20240105.mha"})
    EXPECT_EQ(structureName(file, patient), "") << file;
  // Of a file that says nothing of its patient dates and numbers alone are known.
  EXPECT_EQ(structureName("2024-01-05_liver.nii.gz"), "liver");
  EXPECT_EQ(structureName("kidney_left.nii"), "kidney left");
  EXPECT_EQ(withoutPatient("label_1 a.b", patient), "label_1 a.b") << "unchanged";
}

} // namespace
} // namespace limn
