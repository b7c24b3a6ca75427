// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/SystemReason.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <system_error>

namespace limn {
namespace {

TEST(SystemReason, isTheSystemsOwnInEnglish) {
  for (const int error :
       {EPERM, ENOENT, EIO, EACCES, EEXIST, ENOTDIR, EISDIR, ENOSPC, EROFS, ENAMETOOLONG, EDQUOT, EINVAL})
    EXPECT_EQ(systemReason(error).english(), std::generic_category().message(error));
}

TEST(SystemReason, isAPhraseOfItsOwnWithinASentence) {
  EXPECT_EQ(Message::tr("Cannot write %1: %2.").arg("a.png", systemReason(EACCES)).english(),
            "Cannot write a.png: Permission denied.");
}

} // namespace
} // namespace limn
