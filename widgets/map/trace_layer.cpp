#include "widgets/map/trace_layer.h"

#include <bitset>
#include <cmath>
#include <utility>

namespace usar::widgets {

namespace {

constexpr int tile_px = 256;
constexpr double radius_px = 3.5;
constexpr double brush_px = radius_px + 1.5; ///< radius including the rim
constexpr int cell_px = 2;                   ///< size of a cell; only the newest mark in a cell is drawn
constexpr std::size_t most_tiles = 192;      ///< 48 MiB; if panning exceeds it, all tiles are made again

/// Paints the rim below existing dots, so that dots in a row look like one line with one rim.
void paintDot(QPainter& painter, const QPointF& at_px, QRgb color) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
    painter.drawEllipse(at_px, brush_px, brush_px);
    painter.setBrush(QColor(color));
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.drawEllipse(at_px, radius_px, radius_px);
}

} // namespace

QPointF TraceLayer::onScreenAxes(const Vec2& point_m) const {
    return orientation_ == MapOrientation::YUp ? QPointF(point_m.x(), -point_m.y())
                                               : QPointF(-point_m.y(), -point_m.x());
}

void TraceLayer::add(const Vec2& point_m, const QColor& color) {
    if (!point_m.allFinite())
        return;
    marks_.push_back({point_m, color.rgb()});
    const QPointF at_m = onScreenAxes(point_m);
    for (auto& [key, tile] : tiles_) {
        const QPointF at_px = at_m * std::exp2(key.level) - QPointF(key.column, key.row) * tile_px;
        if (!QRectF(tile.rect()).adjusted(-brush_px, -brush_px, brush_px, brush_px).contains(at_px))
            continue;
        QPainter painter(&tile);
        painter.setRenderHint(QPainter::Antialiasing);
        paintDot(painter, at_px, color.rgb());
    }
}

void TraceLayer::clear() {
    marks_.clear();
    tiles_.clear();
}

QImage TraceLayer::bake(const Key& key) const {
    QImage tile(tile_px, tile_px, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF sight = QRectF(tile.rect()).adjusted(-brush_px, -brush_px, brush_px, brush_px);
    constexpr std::size_t cells = tile_px / cell_px + 8;
    std::bitset<cells * cells> drawn;
    // Goes through the marks from the newest to the oldest; of marks that cover each other only the newest is drawn.
    std::vector<std::pair<QPointF, QRgb>> dots;
    for (auto mark = marks_.rbegin(); mark != marks_.rend(); ++mark) {
        const QPointF at_px =
            onScreenAxes(mark->point_m) * std::exp2(key.level) - QPointF(key.column, key.row) * tile_px;
        if (!sight.contains(at_px))
            continue;
        const auto column = static_cast<std::size_t>((at_px.x() + 8.0) / cell_px);
        const auto row = static_cast<std::size_t>((at_px.y() + 8.0) / cell_px);
        if (drawn.test(row * cells + column))
            continue;
        drawn.set(row * cells + column);
        dots.emplace_back(at_px, mark->color);
    }
    for (auto dot = dots.rbegin(); dot != dots.rend(); ++dot)
        paintDot(painter, dot->first, dot->second);
    return tile;
}

void TraceLayer::paint(QPainter& painter, const MapTransform& transform) const {
    if (marks_.empty())
        return;
    if (orientation_ != transform.orientation || tiles_.size() > most_tiles)
        tiles_.clear();
    orientation_ = transform.orientation;
    const double dots_per_m = transform.pixels_per_m * painter.device()->devicePixelRatioF();
    const int level = static_cast<int>(std::ceil(std::log2(dots_per_m)));
    const double side_px = tile_px / std::exp2(level) * transform.pixels_per_m;
    const QPointF origin_px = transform.toScreen(Vec2(0.0, 0.0));
    const auto first = [side_px](double from_px) { return static_cast<int>(std::floor(from_px / side_px)); };
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (int row = first(-origin_px.y()); row <= first(transform.viewport.height() - origin_px.y()); ++row)
        for (int column = first(-origin_px.x()); column <= first(transform.viewport.width() - origin_px.x());
             ++column) {
            const Key key{level, column, row};
            auto tile = tiles_.find(key);
            if (tile == tiles_.end())
                tile = tiles_.emplace(key, bake(key)).first;
            // Edges are on whole pixels and shared by neighbors, so that no seams are visible.
            const QPoint low(qRound(origin_px.x() + column * side_px), qRound(origin_px.y() + row * side_px));
            const QPoint high(qRound(origin_px.x() + (column + 1) * side_px),
                              qRound(origin_px.y() + (row + 1) * side_px));
            painter.drawImage(QRect(low, high - QPoint(1, 1)), tile->second);
        }
}

} // namespace usar::widgets
