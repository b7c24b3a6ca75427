// SPDX-License-Identifier: GPL-3.0-or-later
// The JPEG decoder, compiled once for each depth against the jpeglib.h that the including file chose.

#include <csetjmp>

namespace limn {
namespace {

struct Failure {
  jpeg_error_mgr manager; // first, so that the library's pointer to it is one to this
  std::jmp_buf jump;
  char text[JMSG_LENGTH_MAX];
};

[[noreturn]] void stop(j_common_ptr info) {
  auto* failure = reinterpret_cast<Failure*>(info->err);
  info->err->format_message(info, failure->text);
  std::longjmp(failure->jump, 1);
}

// Pixels that the library had to guess are damage; marks it does not know and stray bytes lose nothing.
void judge(j_common_ptr info, int level) {
  const int code = info->err->msg_code;
  if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM && code != JWRN_JFIF_MAJOR)
    stop(info);
}

void stayQuiet(j_common_ptr) {}

void ignore(j_decompress_ptr) {}

// The whole stream lies in memory: to ask for more is to have reached a premature end.
boolean refill(j_decompress_ptr info) {
  info->err->msg_code = JWRN_JPEG_EOF;
  stop(reinterpret_cast<j_common_ptr>(info));
}

void skip(j_decompress_ptr info, long count) {
  if (count <= 0)
    return;
  if (static_cast<std::size_t>(count) > info->src->bytes_in_buffer)
    refill(info);
  info->src->next_input_byte += count;
  info->src->bytes_in_buffer -= static_cast<std::size_t>(count);
}

jpeg_source_mgr sourceOf(const std::vector<unsigned char>& stream) {
  jpeg_source_mgr source{};
  source.next_input_byte = stream.data();
  source.bytes_in_buffer = stream.size();
  source.init_source = ignore;
  source.fill_input_buffer = refill;
  source.skip_input_data = skip;
  source.resync_to_restart = jpeg_resync_to_restart;
  source.term_source = ignore;
  return source;
}

// Everything that owns memory was made by the caller: a jump out of here skips no destructor. Never inlined
// into the function that catches the jump, whose variables it might spoil.
[[gnu::noinline]] void decodeInto(jpeg_decompress_struct& info, jpeg_source_mgr& source,
                                  std::vector<JSAMPLE>& row, JpegPicture& picture) {
  info.src = &source;
  jpeg_read_header(&info, TRUE);
  picture.isMarkedYbr = info.saw_JFIF_marker || (info.saw_Adobe_marker && info.Adobe_transform == 1);
  info.jpeg_color_space = JCS_UNKNOWN;
  info.out_color_space = JCS_UNKNOWN;
  jpeg_start_decompress(&info);
  const std::size_t samples =
      static_cast<std::size_t>(info.output_width) * static_cast<std::size_t>(info.output_components);
  row.resize(samples);
  constexpr int width = BITS_IN_JSAMPLE == 8 ? 1 : 2;
  picture.bytes.reserve(samples * width * info.output_height);
  while (info.output_scanline < info.output_height) {
    JSAMPROW line = row.data();
    jpeg_read_scanlines(&info, &line, 1);
    for (const JSAMPLE sample : row)
      for (int byte = 0; byte < width; ++byte)
        picture.bytes.push_back(static_cast<unsigned char>(static_cast<unsigned>(sample) >> (8 * byte)));
  }
  jpeg_finish_decompress(&info);
}

JpegPicture decodeJpeg(const std::vector<unsigned char>& stream) {
  JpegPicture picture;
  std::vector<JSAMPLE> row;
  jpeg_source_mgr source = sourceOf(stream);
  jpeg_decompress_struct info{};
  Failure failure{};
  info.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = stop;
  failure.manager.emit_message = judge;
  failure.manager.output_message = stayQuiet;
  if (setjmp(failure.jump)) {
    jpeg_destroy_decompress(&info);
    throw JpegDamage(failure.text);
  }
  jpeg_create_decompress(&info);
  decodeInto(info, source, row, picture);
  jpeg_destroy_decompress(&info);
  return picture;
}

} // namespace
} // namespace limn
