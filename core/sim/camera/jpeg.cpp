#include "core/sim/camera/jpeg.h"

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

namespace usar::sim {

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
