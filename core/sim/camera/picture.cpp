#include "core/sim/camera/picture.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

namespace usar::sim {

void paste(Picture& whole, const Picture& part, int x, int y) {
    for (int row = 0; row < part.height_px; ++row)
        std::copy_n(part.at(0, row), 3 * part.width_px, whole.at(x, y + row));
}

Picture cut(const Picture& whole, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height) {
    const auto left = static_cast<int>(std::clamp<std::int64_t>(x, 0, whole.width_px - 1));
    const auto top = static_cast<int>(std::clamp<std::int64_t>(y, 0, whole.height_px - 1));
    Picture part(static_cast<int>(std::clamp<std::int64_t>(width, 1, whole.width_px - left)),
                 static_cast<int>(std::clamp<std::int64_t>(height, 1, whole.height_px - top)));
    for (int row = 0; row < part.height_px; ++row)
        std::copy_n(whole.at(left, top + row), 3 * part.width_px, part.at(0, row));
    return part;
}

std::string jpegOf(const Picture& picture, int quality) {
    jpeg_compress_struct writer{};
    jpeg_error_mgr errors{};
    writer.err = jpeg_std_error(&errors); // Ends the program on an error: no input could cause one.
    jpeg_create_compress(&writer);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&writer, &bytes, &size);
    writer.image_width = static_cast<JDIMENSION>(picture.width_px);
    writer.image_height = static_cast<JDIMENSION>(picture.height_px);
    writer.input_components = 3;
    writer.in_color_space = JCS_RGB;
    jpeg_set_defaults(&writer);
    jpeg_set_quality(&writer, quality, TRUE);
    writer.dct_method = JDCT_FASTEST;
    jpeg_start_compress(&writer, TRUE);
    while (writer.next_scanline < writer.image_height) {
        // The row is only read, although libjpeg does not say so in its signature.
        auto* row = const_cast<unsigned char*>(picture.at(0, static_cast<int>(writer.next_scanline)));
        jpeg_write_scanlines(&writer, &row, 1);
    }
    jpeg_finish_compress(&writer);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    jpeg_destroy_compress(&writer);
    std::free(bytes);
    return file;
}

} // namespace usar::sim
