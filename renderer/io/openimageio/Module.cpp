// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/openimageio/PictureLibrary.h"

#include <OpenImageIO/imageio.h>

namespace limn {
namespace {

using OIIO::TypeDesc;

StoredPicture::Sample sampleOf(const TypeDesc& stored) {
  switch (stored.basetype) {
  case TypeDesc::UINT8:
    return StoredPicture::Sample::uint8;
  case TypeDesc::UINT16:
    return StoredPicture::Sample::uint16;
  case TypeDesc::FLOAT:
    return StoredPicture::Sample::float32;
  default:
    return StoredPicture::Sample::other;
  }
}

std::optional<StoredPicture> open(const std::string& path) {
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  const std::shared_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wishes);
  if (!input) {
    OIIO::geterror(); // the library's words, which it would print at the end
    return std::nullopt;
  }
  const OIIO::ImageSpec& spec = input->spec();
  StoredPicture picture{spec.width,
                        spec.height,
                        spec.nchannels,
                        sampleOf(spec.format),
                        spec.get_string_attribute("ImageDescription"),
                        {}};
  picture.readRows = [input](void* to, int first, int count) {
    const OIIO::ImageSpec& own = input->spec();
    const bool isRead = input->read_scanlines(0, 0, own.y + first, own.y + first + count, 0, 0, own.nchannels,
                                              own.format, to);
    // Some damage is only left as a text, with the rows filled up.
    return input->geterror().empty() && isRead;
  };
  return picture;
}

OIIO::ImageSpec specOf(const PictureToWrite& picture) {
  using Format = PictureToWrite::Format;
  const bool isFloat = picture.format == Format::exr;
  const bool hasAlpha = isFloat || picture.hasAlpha;
  OIIO::ImageSpec spec(picture.width, picture.height, hasAlpha ? 4 : 3,
                       isFloat ? TypeDesc::FLOAT : TypeDesc::UINT8);
  if (isFloat && picture.hasRadiance) {
    spec.nchannels = 7;
    spec.channelnames = {"R", "G", "B", "A", "radiance.R", "radiance.G", "radiance.B"};
  }
  if (hasAlpha)
    spec.alpha_channel = 3;
  if (picture.hasAlpha)
    spec.attribute("oiio:UnassociatedAlpha", 1);
  if (picture.dotsPerInch > 0.0) {
    spec.attribute("ResolutionUnit", "in");
    spec.attribute("XResolution", static_cast<float>(picture.dotsPerInch));
    spec.attribute("YResolution", static_cast<float>(picture.dotsPerInch));
  }
  if (!isFloat)
    spec.attribute("oiio:ColorSpace", "sRGB");
  if (picture.format == Format::jpeg) {
    spec.attribute("CompressionQuality", 95);
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  if (picture.format == Format::tiff)
    spec.attribute("compression", "zip");
  // Or the library writes when it was: one scene would be other bytes each time.
  if (isFloat || picture.format == Format::tiff)
    spec.attribute("DateTime", "");
  if (!picture.description.empty())
    spec.attribute("ImageDescription", picture.description);
  return spec;
}

std::string reasonOf(const OIIO::ImageOutput* output) {
  const std::string reason = output ? output->geterror() : OIIO::geterror();
  return reason.empty() ? "no reason was given" : reason;
}

std::string write(const std::string& path, const PictureToWrite& picture) {
  const OIIO::ImageSpec spec = specOf(picture);
  const auto output = OIIO::ImageOutput::create(path);
  if (output && output->open(path, spec) && output->write_image(spec.format, picture.pixels) &&
      output->close())
    return {};
  return reasonOf(output.get());
}

} // namespace
} // namespace limn

/// What the program looks for.
extern "C" const limn::PictureLibrary limnPictureLibrary{limn::open, limn::write};
