#include "core/mission/files/map_picture.h"

#include <algorithm>
#include <cmath>

#include <QLineF>
#include <QPainter>

#include "core/base/numbers.h"
#include "core/mapping/height_histogram.h"
#include "core/mapping/hole_fill.h"
#include "core/mission/files/picture_legend.h"

namespace usar::mission {

namespace {

using mapping::FilledRaster;
using mapping::HeightRange;
using mapping::Raster;

constexpr double legible_px = 600.0;
constexpr double longest_px = 8192.0;

Rectangle extentOf(const Raster& raster) {
    const double cell_m = raster.cell_size_m;
    const Vec2 top_left_m = raster.upper_left_center_m + Vec2(-cell_m / 2, cell_m / 2);
    const Vec2 size_m = Vec2(double(raster.columns), double(raster.rows)) * cell_m;
    return {{top_left_m.x(), top_left_m.y() - size_m.y()}, {top_left_m.x() + size_m.x(), top_left_m.y()}};
}

/// Extent of the picture in the map frame: the raster, and path and marks outside it (such as the way home from the
/// scan), up to a map's length around it.
Rectangle pictureExtent(const ScanRecord& record) {
    const Rectangle map = extentOf(record.raster);
    const Vec2 reach_m = Vec2::Constant(std::max(map.width_m(), map.height_m()));
    const Rectangle limit{map.min_m - reach_m, map.max_m + reach_m};
    const Vec2 border_m = Vec2::Constant(0.02 * reach_m.x());
    Rectangle extent = map;
    const auto include = [&](const Vec3& point_m) {
        if (!limit.contains(Vec2(point_m.head<2>())) || map.contains(Vec2(point_m.head<2>())))
            return;
        extent.min_m = extent.min_m.cwiseMin(point_m.head<2>() - border_m);
        extent.max_m = extent.max_m.cwiseMax(point_m.head<2>() + border_m);
    };
    std::for_each(record.path_m.begin(), record.path_m.end(), include);
    for (const agent::MapMark& mark : record.marks)
        include(mark.position_in_map_m);
    return extent;
}

/// Maps meters in the map frame to pixels; x points to the right, y up.
struct View {
    Rectangle extent;
    double pixels_per_m = 1.0;
    int width_px = 0;
    int height_px = 0;

    explicit View(const ScanRecord& record) {
        extent = pictureExtent(record);
        const double cell_m = record.raster.cell_size_m;
        const double shorter = std::min(extent.width_m(), extent.height_m()) / cell_m;
        const double longer = std::max(extent.width_m(), extent.height_m()) / cell_m;
        const double enlarged = std::min(std::ceil(legible_px / shorter), std::floor(longest_px / 2 / longer));
        const double pixels_per_cell = longer > longest_px ? longest_px / longer : std::max(1.0, enlarged);
        pixels_per_m = pixels_per_cell / cell_m;
        // A narrow strip gets unknown ground on both sides, so that the legend has room.
        const double narrow_m = std::max(0.0, legible_px / pixels_per_m - extent.width_m());
        extent.min_m.x() -= narrow_m / 2;
        extent.max_m.x() += narrow_m / 2;
        width_px = std::max(1, static_cast<int>(std::lround(extent.width_m() * pixels_per_m)));
        height_px = std::max(1, static_cast<int>(std::lround(extent.height_m() * pixels_per_m)));
    }

    QPointF toPixel(const Vec2& point_m) const {
        return {(point_m.x() - extent.min_m.x()) * pixels_per_m, (extent.max_m.y() - point_m.y()) * pixels_per_m};
    }
};

/// Returns the cell index under each pixel of one axis; outside the raster it is negative or too large.
std::vector<std::int64_t> cellsUnderPixels(int pixels, double pixels_per_cell, double offset_cells) {
    std::vector<std::int64_t> cells(static_cast<std::size_t>(pixels));
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = static_cast<std::int64_t>(std::floor((double(i) + 0.5) / pixels_per_cell + offset_cells));
    return cells;
}

/// Half way to the color of unknown ground.
std::uint32_t dulled(std::uint32_t color) {
    constexpr std::uint32_t without_lowest_bits = 0xfefefe;
    return 0xff000000 | (((color & without_lowest_bits) >> 1) + ((unknown_color & without_lowest_bits) >> 1));
}

void paintHeights(QImage& image, const FilledRaster& filled, const View& view, const HeightRange& range,
                  mapping::ColorMap colors) {
    const Raster& raster = filled.heights;
    const Rectangle map = extentOf(raster);
    const mapping::HeightGrid grid{raster.heights_m, raster.columns, raster.rows, raster.cell_size_m};
    const double per_cell = view.pixels_per_m * raster.cell_size_m;
    const auto columns =
        cellsUnderPixels(view.width_px, per_cell, (view.extent.min_m.x() - map.min_m.x()) / raster.cell_size_m);
    const auto rows =
        cellsUnderPixels(view.height_px, per_cell, (map.max_m.y() - view.extent.max_m.y()) / raster.cell_size_m);
    const auto isFilled = [&](std::int64_t column, std::int64_t row) { // Only asked where there is a height.
        return filled.mask.heights_m[static_cast<std::size_t>(row * raster.columns + column)] > 0.0f;
    };
    for (int y = 0; y < view.height_px; ++y) {
        const std::int64_t row = rows[static_cast<std::size_t>(y)];
        auto* pixels = reinterpret_cast<std::uint32_t*>(image.scanLine(y));
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const std::uint32_t color = mapping::shadeCell(grid, columns[x], row, range, colors);
            pixels[x] = color == 0 ? unknown_color : isFilled(columns[x], row) ? dulled(color) : color;
        }
    }
}

void paintPath(QPainter& painter, const ScanRecord& record, const View& view, double unit_px) {
    QPointF last(-1e9, -1e9);
    for (const Vec3& point_m : record.path_m) {
        const QPointF pixel = view.toPixel(point_m.head<2>());
        if (!point_m.allFinite() || QLineF(last, pixel).length() < 2.6 * unit_px)
            continue;
        drawMark(painter, agent::MarkKind::Path, pixel, unit_px);
        last = pixel;
    }
}

void paintMarks(QPainter& painter, const ScanRecord& record, const View& view, double unit_px) {
    using agent::MarkKind;
    // Rare and important marks are drawn on top of frequent ones.
    for (const MarkKind kind : {MarkKind::Path, MarkKind::LowRisk, MarkKind::HighRisk, MarkKind::Diversion,
                                MarkKind::GoalGivenUp, MarkKind::Landing, MarkKind::Recharge}) {
        for (const agent::MapMark& mark : record.marks) {
            if (mark.kind == kind && mark.position_in_map_m.allFinite())
                drawMark(painter, kind, view.toPixel(mark.position_in_map_m.head<2>()), unit_px);
        }
    }
}

void paintArea(QPainter& painter, const Rectangle& area, const View& view, double unit_px) {
    if (area.empty())
        return;
    const QPointF top_left = view.toPixel({area.min_m.x(), area.max_m.y()});
    const QPointF bottom_right = view.toPixel({area.max_m.x(), area.min_m.y()});
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 120), unit_px));
    painter.drawRect(QRectF(top_left, bottom_right));
    painter.setPen(QPen(QColor(120, 220, 255, 200), std::max(1.0, unit_px * 0.4), Qt::DashLine));
    painter.drawRect(QRectF(top_left, bottom_right));
}

/// `filled_m2`: surface of the holes that are filled in.
Legend legendOf(const ScanRecord& record, const View& view, const mapping::HeightLook& look, double filled_m2) {
    Legend legend;
    legend.range = colorRange(record.raster, look);
    legend.colors = look.color_map;
    legend.pixels_per_m = view.pixels_per_m;
    legend.text_px = std::clamp(std::min(view.width_px, view.height_px) / 45.0, 13.0, 80.0);
    legend.title = QString("%1  ·  %2  ·  %3")
                       .arg(QString::fromStdString(record.level), QString::fromStdString(record.robot_name),
                            QString::fromStdString(record.behavior_id));
    if (filled_m2 > 0.0)
        legend.title += QString("  ·  dull: small holes, filled in (%1 m²)")
                            .arg(QString::fromStdString(fixed(filled_m2, filled_m2 < 10.0 ? 1 : 0)));
    return legend;
}

void addMetadata(QImage& image, const ScanRecord& record, const View& view) {
    for (const auto& [key, value] : metadataOf(record))
        image.setText(key, value);
    image.setText("pixels_per_m", numberText(view.pixels_per_m));
}

} // namespace

HeightRange colorRange(const Raster& raster, const mapping::HeightLook& look) {
    const HeightRange whole = raster.range().value_or(HeightRange{});
    if (look.fixed_range || !look.trimmed)
        return look.fixed_range.value_or(whole);
    mapping::HeightHistogram histogram(whole);
    histogram.add(raster.heights_m);
    return histogram.trimmed();
}

QImage mapPicture(const ScanRecord& record, const mapping::HeightLook& look) {
    if (record.raster.empty())
        return {};
    const View view(record);
    const double shorter_px = std::min(view.width_px, view.height_px);
    const FilledRaster filled = mapping::withHolesFilled(record.raster);
    const Legend legend = legendOf(record, view, look, filled.filled_m2());
    const int strip_px = legend.heightFor(view.width_px);
    QImage image(view.width_px, view.height_px + strip_px, QImage::Format_RGB32);
    paintHeights(image, filled, view, *legend.range, look.color_map);

    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(0, 0, view.width_px, view.height_px);
    const double unit_px = std::max(2.4, shorter_px / 260.0);
    paintArea(painter, record.area_in_map, view, unit_px);
    paintPath(painter, record, view, unit_px);
    paintMarks(painter, record, view, unit_px);
    painter.setClipping(false);
    legend.draw(painter, QRect(0, view.height_px, view.width_px, strip_px));
    painter.end();
    addMetadata(image, record, view);
    return image;
}

QImage legendPicture(const ScanRecord& record, const mapping::HeightLook& look) {
    if (record.raster.empty())
        return {};
    const View view(record);
    const Legend legend = legendOf(record, view, look, mapping::holes_m2(record.raster));
    QImage image(view.width_px, legend.heightFor(view.width_px), QImage::Format_RGB32);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    legend.draw(painter, image.rect());
    painter.end();
    addMetadata(image, record, view);
    return image;
}

QImage heightImage(const Raster& raster) {
    if (raster.empty())
        return {};
    const HeightRange range = raster.range().value_or(HeightRange{});
    const double scale_m = (double(range.maximum_m) - double(range.minimum_m)) / 65534.0;
    const double offset_m = double(range.minimum_m) - scale_m;
    QImage image(static_cast<int>(raster.columns), static_cast<int>(raster.rows), QImage::Format_Grayscale16);
    for (int row = 0; row < image.height(); ++row) {
        const float* heights_m = raster.heights_m.data() + row * raster.columns;
        auto* pixels = reinterpret_cast<std::uint16_t*>(image.scanLine(row));
        for (int column = 0; column < image.width(); ++column) {
            const double height_m = double(heights_m[column]);
            if (std::isnan(height_m))
                pixels[column] = 0;
            else
                pixels[column] =
                    scale_m > 0.0 ? static_cast<std::uint16_t>(std::lround((height_m - offset_m) / scale_m)) : 1;
        }
    }
    image.setText("height_scale_m", numberText(scale_m));
    image.setText("height_offset_m", numberText(offset_m));
    image.setText("unknown", "0");
    image.setText("cell_size_m", numberText(raster.cell_size_m));
    image.setText("upper_left_center_x_m", numberText(raster.upper_left_center_m.x()));
    image.setText("upper_left_center_y_m", numberText(raster.upper_left_center_m.y()));
    return image;
}

} // namespace usar::mission
