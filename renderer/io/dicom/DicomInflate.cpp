// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomInflate.h"

#include "scene/Error.h"

#include <sstream>
#include <vector>

#include <zlib.h>

namespace limn {
namespace {

constexpr std::size_t mostBytes = std::size_t{1} << 31;
constexpr int rawDeflate = -15;

struct Inflater {
  z_stream state{};
  Inflater() { inflateInit2(&state, rawDeflate); }
  ~Inflater() { inflateEnd(&state); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
};

} // namespace

std::unique_ptr<std::istream> inflated(std::istream& in, const std::string& file) {
  Inflater inflater;
  std::vector<char> input(1 << 16);
  std::vector<char> output(1 << 18);
  std::string result;
  int status = Z_OK;
  while (status == Z_OK) {
    if (inflater.state.avail_in == 0) {
      in.read(input.data(), static_cast<std::streamsize>(input.size()));
      inflater.state.next_in = reinterpret_cast<Bytef*>(input.data());
      inflater.state.avail_in = static_cast<uInt>(in.gcount());
    }
    inflater.state.next_out = reinterpret_cast<Bytef*>(output.data());
    inflater.state.avail_out = static_cast<uInt>(output.size());
    status = ::inflate(&inflater.state, Z_NO_FLUSH);
    result.append(output.data(), output.size() - inflater.state.avail_out);
    if (result.size() > mostBytes)
      throw Error(Error::Kind::input, "The deflated DICOM file " + file +
                                          " inflates to more than 2 GiB; decompress it with another tool.");
  }
  // A buffer error is the end of the input before the end of the data: what uses it checks its lengths.
  if (status != Z_STREAM_END && status != Z_BUF_ERROR)
    throw Error(Error::Kind::input, "The deflated DICOM file " + file +
                                        " is damaged: its data cannot be inflated. Copy it again.");
  return std::make_unique<std::istringstream>(std::move(result));
}

} // namespace limn
