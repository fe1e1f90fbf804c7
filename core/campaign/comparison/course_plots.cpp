#include "core/campaign/comparison/course_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/campaign/comparison/coverage_band.h"
#include "core/campaign/comparison/svg_canvas.h"
#include "core/mission/files/small_picture.h"

namespace usar::campaign {

namespace {

/// A rectangle on the ground, in meters.
struct Extent {
    double west = std::numeric_limits<double>::infinity(), east = -west, south = west, north = -west;

    void add(const std::vector<QPointF>& points) {
        for (const QPointF& point : points) {
            west = std::min(west, point.x());
            east = std::max(east, point.x());
            south = std::min(south, point.y());
            north = std::max(north, point.y());
        }
    }
    void addAll(const RunFigures& run) {
        for (const auto* points : {&run.course.path, &run.course.given_up, &run.course.collisions})
            add(*points);
    }
    bool empty() const { return east < west; }
};

/// Maps the ground onto pixels with one scale for both axes.
class MapScale {
public:
    MapScale(const Extent& extent, double width, double height, double margin) {
        const double wide_m = std::max(1.0, extent.east - extent.west);
        const double high_m = std::max(1.0, extent.north - extent.south);
        pixels_a_meter_ = std::min((width - 2.0 * margin) / wide_m, (height - 2.0 * margin) / high_m);
        left_ = (width - pixels_a_meter_ * (extent.east + extent.west)) / 2.0;
        bottom_ = (height + pixels_a_meter_ * (extent.north + extent.south)) / 2.0;
    }
    QPointF operator()(const QPointF& point_m) const {
        return {left_ + pixels_a_meter_ * point_m.x(), bottom_ - pixels_a_meter_ * point_m.y()};
    }
    double pixelsPerMeter() const { return pixels_a_meter_; }

private:
    double pixels_a_meter_ = 1.0;
    double left_ = 0.0;
    double bottom_ = 0.0;
};

std::vector<QPointF> onMap(const std::vector<QPointF>& points_m, const MapScale& at) {
    std::vector<QPointF> points;
    std::ranges::transform(points_m, std::back_inserter(points), at);
    return points;
}

void drawCross(SvgCanvas& canvas, const QPointF& at, double reach, const QString& style_class) {
    canvas.line({at.x() - reach, at.y() - reach}, {at.x() + reach, at.y() + reach}, style_class);
    canvas.line({at.x() - reach, at.y() + reach}, {at.x() + reach, at.y() - reach}, style_class);
}

void drawPlacesOf(SvgCanvas& canvas, const RunFigures& run, const MapScale& at, const QString& style_class) {
    for (const QPointF& place : onMap(run.course.given_up, at))
        canvas.circle(place, 3.5, "given-up " + style_class);
    for (const QPointF& place : onMap(run.course.collisions, at))
        drawCross(canvas, place, 4.0, "collision " + style_class);
}

/// A bar of a round number of meters, at most a third of the width.
void drawScaleBar(SvgCanvas& canvas, const MapScale& at, double width, double y) {
    const double most_m = width / 3.0 / at.pixelsPerMeter();
    const double unit_m = std::pow(10.0, std::floor(std::log10(most_m)));
    const double length_m = most_m >= 5.0 * unit_m ? 5.0 * unit_m : most_m >= 2.0 * unit_m ? 2.0 * unit_m : unit_m;
    const double right = width - 12.0, left = right - length_m * at.pixelsPerMeter();
    canvas.line({left, y}, {right, y}, "scale");
    canvas.text({left - 6.0, y + 4.0}, "end", QString("%1 m").arg(length_m));
}

/// Lines at round coordinates of the map frame, with their numbers at the left and below.
void drawMapGrid(SvgCanvas& canvas, const Extent& extent, const MapScale& at, double width, double bottom) {
    constexpr double left = 46.0, top = 8.0;
    const std::vector<double> xs = ticks(extent.west, extent.east, 8), ys = ticks(extent.south, extent.north, 6);
    for (const double value : xs) {
        const double x = at({value, 0.0}).x();
        canvas.line({x, top}, {x, bottom}, "grid");
        canvas.text({x, bottom + 14.0}, "middle", tickText(value, xs));
    }
    for (const double value : ys) {
        const double y = at({0.0, value}).y();
        canvas.line({left, y}, {width - 12.0, y}, "grid");
        canvas.text({left - 6.0, y + 4.0}, "end", tickText(value, ys));
    }
    canvas.text({width - 12.0, bottom + 14.0}, "end", "x, m");
    canvas.text({left, top + 4.0}, "start", "y, m");
}

void drawBand(SvgCanvas& canvas, const std::vector<CoverageSpread>& band, const Scale& x, const Scale& y,
              const QString& style_class) {
    std::vector<QPointF> outline, middle;
    for (const CoverageSpread& spread : band) {
        outline.emplace_back(x(spread.elapsed_s), y(spread.ninetieth_pct));
        middle.emplace_back(x(spread.elapsed_s), y(spread.median_pct));
    }
    for (auto spread = band.rbegin(); spread != band.rend(); ++spread)
        outline.emplace_back(x(spread->elapsed_s), y(spread->tenth_pct));
    canvas.path(outline, "spread " + style_class);
    canvas.path(middle, "curve " + style_class);
}

} // namespace

void drawCoverage(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate) {
    constexpr double width = 880.0, height = 300.0, left = 56.0, right = width - 12.0, top = 34.0,
                     bottom = height - 40.0;
    const double last_s = std::max(lastCoverage_s(baseline.runs), lastCoverage_s(candidate.runs));
    if (!(last_s > 0.0))
        return;
    SvgCanvas canvas(xml, width, height, "plot wide", "coverage over time");
    const Scale x{0.0, last_s, left, right}, y{0.0, 100.0, bottom, top};
    for (const double pct : {0.0, 25.0, 50.0, 75.0, 100.0}) {
        canvas.line({left, y(pct)}, {right, y(pct)}, "grid");
        canvas.text({left - 6.0, y(pct) + 4.0}, "end", QString("%1 %").arg(pct));
    }
    const std::vector<double> values = ticks(x.low, x.high, 8);
    for (const double value : values)
        canvas.text({x(value), bottom + 17.0}, "middle", tickText(value, values));
    canvas.text({(left + right) / 2.0, height - 4.0}, "middle", "Time since the start, s");
    double at = left;
    for (const auto& [variant, style_class] : {std::pair(&baseline, "baseline"), std::pair(&candidate, "candidate")}) {
        if (variant->name.isEmpty())
            continue;
        drawBand(canvas, coverageBand(variant->runs, last_s), x, y, style_class);
        canvas.line({at, 14.0}, {at + 28.0, 14.0}, QString("curve ") + style_class);
        canvas.text({at + 34.0, 18.0}, "start", variant->name, "legend");
        at += (right - left) / 2.0;
    }
}

bool havePlaces(const VariantRuns& baseline, const VariantRuns& candidate) {
    const auto has = [](const RunFigures* run) {
        return !run->course.given_up.empty() || !run->course.collisions.empty();
    };
    return std::ranges::any_of(baseline.runs, has) || std::ranges::any_of(candidate.runs, has);
}

void drawPlaces(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate) {
    constexpr double width = 880.0, height = 520.0, top = 30.0;
    Extent extent;
    for (const VariantRuns* variant : {&baseline, &candidate})
        for (const RunFigures* run : variant->runs)
            extent.addAll(*run);
    if (extent.empty())
        return;
    SvgCanvas canvas(xml, width, height, "plot wide", "places where runs collided and gave goals up");
    const MapScale at(extent, width, height - top - 16.0, 52.0);
    drawMapGrid(canvas, extent, at, width, height - top - 26.0);
    double legend = 0.0;
    for (const auto& [variant, style_class] : {std::pair(&baseline, "baseline"), std::pair(&candidate, "candidate")}) {
        if (variant->name.isEmpty())
            continue;
        for (const RunFigures* run : variant->runs)
            drawPlacesOf(canvas, *run, at, style_class);
        drawCross(canvas, {legend + 8.0, height - 14.0}, 4.0, QString("collision ") + style_class);
        canvas.circle({legend + 24.0, height - 14.0}, 3.5, QString("given-up ") + style_class);
        canvas.text({legend + 36.0, height - 10.0}, "start", variant->name, "legend");
        legend += width / 3.0;
    }
    drawScaleBar(canvas, at, width, height - 14.0);
}

bool drawMap(QXmlStreamWriter& xml, const RunFigures& run) {
    constexpr int most_px = 480; // Twice of what is shown, for paper and fine screens.
    if (run.picture.empty())
        return false;
    const QByteArray png = mission::smallPicture(QString::fromStdString(run.picture), most_px);
    if (png.isEmpty())
        return false;
    xml.writeStartElement("img");
    xml.writeAttribute("class", "map");
    xml.writeAttribute("alt", QString("map of run %1").arg(run.number));
    xml.writeAttribute("src", "data:image/png;base64," + QString::fromLatin1(png.toBase64()));
    xml.writeEndElement();
    return true;
}

void drawCourse(QXmlStreamWriter& xml, const RunFigures& run) {
    constexpr double width = 150.0, height = 110.0;
    if (run.course.path.size() < 2)
        return;
    Extent extent;
    extent.addAll(run);
    SvgCanvas canvas(xml, width, height, "course", QString("path of run %1").arg(run.number));
    const MapScale at(extent, width, height, 8.0);
    canvas.path(onMap(run.course.path, at), "way");
    canvas.circle(at(run.course.path.front()), 3.0, "start");
    canvas.circle(at(run.course.path.back()), 3.0, "end");
    drawPlacesOf(canvas, run, at, "one");
}

} // namespace usar::campaign
