#include "core/mapping/geotiff.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <string>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

/// Types of the values of a field, as TIFF 6.0 numbers them.
enum class Type : std::uint16_t { Ascii = 2, Short = 3, Long = 4, Double = 12 };

/// The directory of a TIFF: its fields must be added in the order of their tags. Values that do not fit into their
/// field come behind the directory.
class Directory {
public:
    /// `offset`: where in the file the directory is; `count`: number of its fields.
    Directory(std::uint32_t offset, std::uint16_t count)
        : values_at_(offset + 2 + 12 * std::uint32_t(count) + 4)
        , fields_left_(count) {
        fields_.add(count);
    }

    void addShort(std::uint16_t tag, std::uint16_t value) { addShorts(tag, std::array{value}); }
    void addLong(std::uint16_t tag, std::uint32_t value) { addLongs(tag, std::array{value}); }
    void addShorts(std::uint16_t tag, std::span<const std::uint16_t> values) { addField(tag, Type::Short, values); }
    void addLongs(std::uint16_t tag, std::span<const std::uint32_t> values) { addField(tag, Type::Long, values); }
    void addDoubles(std::uint16_t tag, std::span<const double> values) { addField(tag, Type::Double, values); }
    /// The text gets its final zero.
    void addText(std::uint16_t tag, const std::string& text) {
        addField(tag, Type::Ascii, std::span(text.c_str(), text.size() + 1));
    }

    /// The directory and the values behind it.
    ByteBuffer finished() {
        assert(fields_left_ == 0);
        fields_.add(std::uint32_t(0)); // There is no other directory.
        fields_.add(std::string_view(values_.bytes().data(), values_.size()));
        return std::move(fields_);
    }

private:
    template <class Values>
    void addField(std::uint16_t tag, Type type, const Values& values) {
        --fields_left_;
        fields_.add(tag);
        fields_.add(static_cast<std::uint16_t>(type));
        fields_.add(static_cast<std::uint32_t>(values.size()));
        ByteBuffer bytes;
        for (const auto value : values)
            bytes.add(value);
        const std::string_view text(bytes.bytes().data(), bytes.size());
        if (text.size() <= 4)
            return fields_.addField(text, 4);
        fields_.add(values_at_ + static_cast<std::uint32_t>(values_.size()));
        values_.addField(text, text.size() + text.size() % 2); // Values begin at even offsets.
    }

    ByteBuffer fields_;
    ByteBuffer values_;
    std::uint32_t values_at_;
    std::uint16_t fields_left_;
};

constexpr std::uint32_t directory_at = 8; ///< behind the header
constexpr std::uint16_t field_count = 17;
constexpr std::uint32_t tile_bytes = std::uint32_t(geotiff_tile * geotiff_tile) * sizeof(float);

std::int64_t tilesFor(std::int64_t cells) {
    return (cells + geotiff_tile - 1) / geotiff_tile;
}

/// GeoKeys of a local system, which is one of the user's own.
constexpr char citation[] = "map frame|";
constexpr std::uint16_t citation_length = sizeof(citation) - 1;
constexpr std::array<std::uint16_t, 20> geo_keys{1,    1,     0,
                                                 4,    1024,  0,
                                                 1,    32767, // GTModelType: user-defined
                                                 1025, 0,     1,
                                                 1, // GTRasterType: cells are areas
                                                 1026, 34737, citation_length,
                                                 0, // GTCitation
                                                 3076, 0,     1,
                                                 9001}; // ProjLinearUnits: the meter

/// `tiles_at`: offset of the first tile, of which each has the same size.
ByteBuffer directoryOf(const Raster& raster, std::uint32_t tiles_at) {
    const double cell_m = raster.cell_size_m;
    const Vec2 corner_m = raster.upper_left_center_m + Vec2(-0.5, 0.5) * cell_m;
    std::vector<std::uint32_t> offsets(static_cast<std::size_t>(tilesFor(raster.columns) * tilesFor(raster.rows)));
    for (std::size_t i = 0; i < offsets.size(); ++i)
        offsets[i] = tiles_at + static_cast<std::uint32_t>(i) * tile_bytes;
    Directory directory(directory_at, field_count);
    directory.addLong(256, static_cast<std::uint32_t>(raster.columns));
    directory.addLong(257, static_cast<std::uint32_t>(raster.rows));
    directory.addShort(258, 32); // BitsPerSample
    directory.addShort(259, 1);  // Compression: none
    directory.addShort(262, 1);  // PhotometricInterpretation: black is zero
    directory.addShort(277, 1);  // SamplesPerPixel
    directory.addShort(284, 1);  // PlanarConfiguration
    directory.addShort(322, static_cast<std::uint16_t>(geotiff_tile));
    directory.addShort(323, static_cast<std::uint16_t>(geotiff_tile));
    directory.addLongs(324, offsets);
    directory.addLongs(325, std::vector<std::uint32_t>(offsets.size(), tile_bytes));
    directory.addShort(339, 3); // SampleFormat: floating point
    directory.addDoubles(33550, std::array{cell_m, cell_m, 0.0});
    directory.addDoubles(33922, std::array{0.0, 0.0, 0.0, corner_m.x(), corner_m.y(), 0.0});
    directory.addShorts(34735, geo_keys);
    directory.addText(34737, citation);
    directory.addText(42113, fixed(double(no_data_m), 0));
    return directory.finished();
}

ByteBuffer tileOf(const Raster& raster, std::int64_t first_column, std::int64_t first_row) {
    ByteBuffer tile;
    tile.reserve(tile_bytes);
    for (std::int64_t row = first_row; row < first_row + geotiff_tile; ++row)
        for (std::int64_t column = first_column; column < first_column + geotiff_tile; ++column) {
            const bool inside = row < raster.rows && column < raster.columns;
            const float height_m =
                inside ? raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)] : no_data_m;
            tile.add(std::isnan(height_m) ? no_data_m : height_m);
        }
    return tile;
}

} // namespace

bool writeGeoTiff(const Raster& raster, const ByteSink& sink) {
    assert(!raster.empty());
    const std::size_t directory_size = directoryOf(raster, 0).size();
    ByteBuffer file;
    file.add(std::string_view("II"));
    file.add(std::uint16_t(42));
    file.add(directory_at);
    if (!file.sendTo(sink))
        return false;
    if (!directoryOf(raster, directory_at + static_cast<std::uint32_t>(directory_size)).sendTo(sink))
        return false;
    for (std::int64_t row = 0; row < raster.rows; row += geotiff_tile)
        for (std::int64_t column = 0; column < raster.columns; column += geotiff_tile)
            if (!tileOf(raster, column, row).sendTo(sink))
                return false;
    return true;
}

} // namespace usar::mapping
