// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/SystemReason.h"

#include <cerrno>
#include <system_error>

namespace limn {

Message systemReason(int error) {
  switch (error) {
  case EPERM:
    return Message::tr("Operation not permitted");
  case ENOENT:
    return Message::tr("No such file or directory");
  case EIO:
    return Message::tr("Input/output error");
  case EACCES:
    return Message::tr("Permission denied");
  case EEXIST:
    return Message::tr("File exists");
  case ENOTDIR:
    return Message::tr("Not a directory");
  case EISDIR:
    return Message::tr("Is a directory");
  case ENOSPC:
    return Message::tr("No space left on device");
  case EROFS:
    return Message::tr("Read-only file system");
  case ENAMETOOLONG:
    return Message::tr("File name too long");
  case EDQUOT:
    return Message::tr("Disk quota exceeded");
  default:
    return Message(std::generic_category().message(error));
  }
}

} // namespace limn
