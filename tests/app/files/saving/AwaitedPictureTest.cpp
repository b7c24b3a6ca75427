// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/PictureSaving.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using Outcome = AwaitedPicture::Outcome;

const auto complete = [] { return true; };
const auto incomplete = [] { return false; };

PictureContent contentWith(double isovalue) {
  PictureContent content;
  content.scenes.emplace_back().isovalue = isovalue;
  return content;
}

TEST(AwaitedPicture, waitsUntilItIsCompleteAndIsThenForgotten) {
  AwaitedPicture picture;
  EXPECT_TRUE(picture.path().isEmpty());
  picture.await(QStringLiteral("/a.png"), contentWith(1.0));
  EXPECT_EQ(picture.look(contentWith(1.0), incomplete), Outcome::waits);
  EXPECT_EQ(picture.path(), QStringLiteral("/a.png"));
  EXPECT_EQ(picture.look(contentWith(1.0), complete), Outcome::complete);
  EXPECT_TRUE(picture.path().isEmpty());
}

TEST(AwaitedPicture, anotherSceneOrLayoutIsAnotherPictureHoweverComplete) {
  AwaitedPicture picture;
  picture.await(QStringLiteral("/a.png"), contentWith(1.0));
  EXPECT_EQ(picture.look(contentWith(2.0), complete), Outcome::changed);
  EXPECT_TRUE(picture.path().isEmpty());
  picture.await(QStringLiteral("/a.png"), contentWith(1.0));
  PictureContent wipe = contentWith(1.0);
  wipe.layout = CompareLayout::wipe;
  EXPECT_EQ(picture.look(wipe, complete), Outcome::changed);
}

TEST(AwaitedPicture, isAskedWhetherItIsCompleteOnlyWhileItIsTheOneThatWasAskedFor) {
  AwaitedPicture picture;
  picture.await(QStringLiteral("/a.png"), contentWith(1.0));
  int asked = 0;
  const auto count = [&] { return ++asked > 1; };
  picture.look(contentWith(1.0), count);
  picture.look(contentWith(2.0), count);
  EXPECT_EQ(asked, 1);
}

} // namespace
} // namespace limn
