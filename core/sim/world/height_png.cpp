#include "core/sim/world/height_png.h"

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <string>

#include <png.h>

namespace usar::sim {

namespace {

constexpr png_uint_32 longest_side = 16385;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Holds everything whose destructors a jump out of libpng must not skip; it is declared outside of the jump.
struct Job {
    File file{nullptr, std::fclose};
    png_structp png = nullptr;
    png_infop info = nullptr;
    HeightImage image;
    std::vector<png_bytep> rows;
    std::string trouble;
};

void onError(png_structp png, png_const_charp message) {
    static_cast<Job*>(png_get_error_ptr(png))->trouble = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void pointAtRows(Job& job) {
    job.rows.clear();
    for (std::size_t row = 0; row < job.image.rows; ++row)
        job.rows.push_back(reinterpret_cast<png_bytep>(job.image.values.data() + row * job.image.columns));
}

void swapOnSmallEndians(png_structp png) {
    if constexpr (std::endian::native == std::endian::little)
        png_set_swap(png);
}

bool decode(Job& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0)
        return false;
    png_init_io(job.png, job.file.get());
    png_set_user_limits(job.png, longest_side, longest_side);
    png_read_info(job.png, job.info);
    if (png_get_bit_depth(job.png, job.info) != 16 || png_get_color_type(job.png, job.info) != PNG_COLOR_TYPE_GRAY)
        png_error(job.png, "not a 16-bit grayscale picture");
    swapOnSmallEndians(job.png);
    png_set_interlace_handling(job.png);
    png_read_update_info(job.png, job.info);
    job.image.columns = png_get_image_width(job.png, job.info);
    job.image.rows = png_get_image_height(job.png, job.info);
    job.image.values.resize(job.image.columns * job.image.rows);
    pointAtRows(job);
    png_read_image(job.png, job.rows.data());
    png_read_end(job.png, nullptr);
    return true;
}

bool encode(Job& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0)
        return false;
    png_init_io(job.png, job.file.get());
    png_set_IHDR(job.png, job.info, static_cast<png_uint_32>(job.image.columns),
                 static_cast<png_uint_32>(job.image.rows), 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(job.png, job.info);
    swapOnSmallEndians(job.png);
    pointAtRows(job);
    png_write_image(job.png, job.rows.data());
    png_write_end(job.png, nullptr);
    return true;
}

} // namespace

Result<HeightImage> readHeightPng(const std::filesystem::path& file) {
    Job job;
    job.file.reset(std::fopen(file.c_str(), "rb"));
    if (!job.file)
        return failure("the height map cannot be opened", file.string(), "Check the file's name and its permissions");
    job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning);
    job.info = png_create_info_struct(job.png);
    const bool good = decode(job);
    png_destroy_read_struct(&job.png, &job.info, nullptr);
    if (!good)
        return failure("the height map cannot be read: " + job.trouble, file.string(),
                       "Give a 16-bit grayscale PNG, or generate the world again");
    return std::move(job.image);
}

Result<void> writeHeightPng(const HeightImage& image, const std::filesystem::path& file) {
    Job job;
    job.image = image;
    job.file.reset(std::fopen(file.c_str(), "wb"));
    if (!job.file)
        return failure("the height map cannot be written", file.string(), "Choose a folder that can be written to");
    job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning);
    job.info = png_create_info_struct(job.png);
    const bool encoded = encode(job);
    png_destroy_write_struct(&job.png, &job.info);
    const bool closed = std::fclose(job.file.release()) == 0;
    if (!encoded || !closed)
        return failure("the height map cannot be written: " +
                           (encoded ? std::string("only a part fits on the disk") : job.trouble),
                       file.string(), "Is the disk full?");
    return {};
}

} // namespace usar::sim
