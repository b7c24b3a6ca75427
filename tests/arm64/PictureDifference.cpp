// SPDX-License-Identifier: GPL-3.0-or-later
// How far two pictures of a scene are apart: limn_picture_difference FIRST.exr SECOND.exr LEVELS prints the
// largest and the mean difference of their channels in 8-bit levels. Exit status 0 where no channel is
// further apart than LEVELS, 1 where one is, 2 where the pictures cannot be compared or show nothing.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace {

// Width, height and channels, and the channels of all pixels.
struct Picture {
  std::vector<int> shape;
  std::vector<float> values;
};

Picture pictureIn(const char* file) {
  const auto input = OIIO::ImageInput::open(file);
  if (!input)
    return {};
  const OIIO::ImageSpec& spec = input->spec();
  Picture picture{{spec.width, spec.height, spec.nchannels}, {}};
  picture.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.values.data()))
    return {};
  return picture;
}

} // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("limn_picture_difference takes two pictures and the levels that they may be apart\n", stderr);
    return 2;
  }
  const Picture first = pictureIn(words[1]), second = pictureIn(words[2]);
  const auto isSeen = [](float value) { return value > 0.0f; };
  if (first.shape != second.shape || std::ranges::none_of(first.values, isSeen)) {
    std::fprintf(stderr, "%s and %s cannot be compared: one cannot be read, is empty, or has another size\n",
                 words[1], words[2]);
    return 2;
  }
  double largest = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    const double levels = 255.0 * std::abs(double{first.values[i]} - double{second.values[i]});
    // What is no number is infinitely far.
    largest = std::isnan(levels) ? std::numeric_limits<double>::infinity() : std::max(largest, levels);
    sum += levels;
  }
  std::printf("largest %.5f, mean %.7f levels\n", largest, sum / static_cast<double>(first.values.size()));
  return largest <= std::strtod(words[3], nullptr) ? 0 : 1;
}
