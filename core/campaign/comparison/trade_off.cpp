#include "core/campaign/comparison/trade_off.h"

#include <algorithm>
#include <cmath>

#include "core/campaign/comparison/pairing.h"
#include "core/campaign/comparison/report.h"
#include "core/campaign/comparison/svg_canvas.h"
#include "core/campaign/statistics/sample.h"

namespace usar::campaign {

extern const char curve_style[]; // resources/reports/curve.css, for readers that know no CSS variables, too

namespace {

constexpr double width_px = 430.0, height_px = 300.0;
constexpr std::size_t colors = 8; ///< The style sheets have v0 to v7.

Middle middleOf(const std::vector<double>& values) {
    const std::vector<double> sorted = sortedCopy(values);
    return {quantileOfSorted(sorted, 0.5), {quantileOfSorted(sorted, 0.25), quantileOfSorted(sorted, 0.75)}};
}

TradePoint pointOf(const std::vector<RunFigures>& runs, const std::string& mission, const std::string& variant,
                   const Metric& x, const Metric& y) {
    TradePoint point;
    point.variant = variant;
    std::vector<double> xs, ys;
    for (const RunFigures& run : runs) {
        if (run.mission != mission || run.variant != variant || !counts(run.outcome))
            continue;
        ++point.runs;
        if (run.outcome != Outcome::Done)
            continue;
        ++point.done;
        const auto at_x = valueOf(run, x), at_y = valueOf(run, y);
        if (!at_x || !at_y)
            continue;
        xs.push_back(*at_x);
        ys.push_back(*at_y);
    }
    point.x = middleOf(xs);
    point.y = middleOf(ys);
    return point;
}

std::vector<std::string> missionsOf(const std::vector<RunFigures>& runs) {
    std::vector<std::string> missions;
    for (const RunFigures& run : runs)
        if (std::ranges::find(missions, run.mission) == missions.end())
            missions.push_back(run.mission);
    return missions;
}

Metric metricOf(const char* key) {
    const std::vector<Metric> all = usualMetrics();
    return *std::ranges::find(all, key, &Metric::key);
}

/// From the lowest to the highest quartile, with room beside them.
Scale scaleFor(const std::vector<TradePoint>& points, Middle TradePoint::*side, double first, double last) {
    double low = INFINITY, high = -INFINITY;
    for (const TradePoint& point : points) {
        low = std::min(low, (point.*side).half.low);
        high = std::max(high, (point.*side).half.high);
    }
    const double more = 0.12 * (high - low) + 1e-3 * std::abs(high) + 1e-9;
    return {low - more, high + more, first, last};
}

QString titleOf(const Metric& metric) {
    return QString::fromStdString(metric.title + ", " + metric.unit);
}

/// "fast", or "fast, 38 of 40 done".
QString labelOf(const TradePoint& point) {
    const QString name = nameOf(point.variant);
    return point.done == point.runs ? name : name + QString(", %1 of %2 done").arg(point.done).arg(point.runs);
}

/// The name of a variant in a plot.
struct Label {
    QPointF at; ///< where its line begins, or ends if it stands on the left of its dot
    bool on_left = false;
    double left = 0.0;
    double right = 0.0;

    bool covers(const Label& other) const {
        constexpr double line = 15.0;
        return std::abs(at.y() - other.at.y()) < line && left < other.right && other.left < right;
    }
};

/// The names beside their dots; where one would cover another, or leave the plot, it stands higher or lower.
std::vector<Label> labelsOf(const TradeOff& trade_off, const Scale& x, const Scale& y) {
    constexpr double character = 7.0, beside = 7.0, step = 15.0;
    std::vector<Label> labels;
    for (const TradePoint& point : trade_off.points) {
        const QPointF dot(x(point.x.median), y(point.y.median));
        const double width = character * static_cast<double>(labelOf(point).size());
        Label label;
        label.on_left = dot.x() + beside + width > x.last && dot.x() - x.first > x.last - dot.x();
        label.at.setX(label.on_left ? dot.x() - beside : dot.x() + beside);
        label.left = label.on_left ? label.at.x() - width : label.at.x();
        label.right = label.left + width;
        const auto fits = [&](double height) {
            label.at.setY(height);
            return height < y.first && height > y.last &&
                   std::ranges::none_of(labels, [&](const Label& other) { return label.covers(other); });
        };
        bool found = false;
        for (int steps = 0; !found && steps * step < y.first - y.last; ++steps)
            found = fits(dot.y() - beside + steps * step) || fits(dot.y() - beside - steps * step);
        if (!found) // There are more names than lines.
            label.at.setY(dot.y() - beside);
        labels.push_back(label);
    }
    return labels;
}

/// One plot with its upper left corner at `corner`.
void drawInto(SvgCanvas& canvas, const TradeOff& trade_off, QPointF corner) {
    const double left = corner.x() + 52.0, right = corner.x() + width_px - 12.0, top = corner.y() + 26.0,
                 bottom = corner.y() + height_px - 42.0;
    const Scale x = scaleFor(trade_off.points, &TradePoint::x, left, right);
    const Scale y = scaleFor(trade_off.points, &TradePoint::y, bottom, top);
    canvas.text({left, corner.y() + 14.0}, "start", nameOf(trade_off.mission) + ": " + titleOf(trade_off.y), "title");
    canvas.text({(left + right) / 2.0, corner.y() + height_px - 6.0}, "middle", titleOf(trade_off.x));
    const std::vector<double> rows = ticks(y.low, y.high, 5), columns = ticks(x.low, x.high, 6);
    for (const double value : rows) {
        canvas.line({left, y(value)}, {right, y(value)}, "grid");
        canvas.text({left - 6.0, y(value) + 4.0}, "end", tickText(value, rows));
    }
    for (const double value : columns)
        canvas.text({x(value), bottom + 17.0}, "middle", tickText(value, columns));
    const std::vector<Label> labels = labelsOf(trade_off, x, y);
    for (std::size_t i = 0; i < trade_off.points.size(); ++i) {
        const TradePoint& point = trade_off.points[i];
        const QPointF at(x(point.x.median), y(point.y.median));
        const QString color = QString(" v%1").arg(point.place % colors); // The name has it, too, if it is far away.
        canvas.line({x(point.x.half.low), at.y()}, {x(point.x.half.high), at.y()}, "reach" + color);
        canvas.line({at.x(), y(point.y.half.low)}, {at.x(), y(point.y.half.high)}, "reach" + color);
        canvas.circle(at, 3.5, "estimate" + color);
        canvas.text(labels[i].at, labels[i].on_left ? "end" : "start", labelOf(point), "legend" + color);
    }
}

QString spokenTitle(const TradeOff& trade_off) {
    return QString::fromStdString(trade_off.x.title + " against " + trade_off.y.title + " in ") +
           nameOf(trade_off.mission);
}

} // namespace

std::vector<TradeOff> tradeOffsOf(const std::vector<RunFigures>& runs) {
    std::vector<TradeOff> all;
    const std::vector<std::string> variants = variantsOf(runs);
    for (const std::string& mission : missionsOf(runs))
        for (const char* key : {"rmse_m", "coverage_pct"}) {
            TradeOff trade_off{mission, metricOf("duration_s"), metricOf(key), {}};
            for (std::size_t place = 0; place < variants.size(); ++place) {
                TradePoint point = pointOf(runs, mission, variants[place], trade_off.x, trade_off.y);
                point.place = place;
                if (std::isfinite(point.x.median))
                    trade_off.points.push_back(std::move(point));
            }
            if (trade_off.points.size() >= std::min<std::size_t>(variants.size(), 2))
                all.push_back(std::move(trade_off));
        }
    return all;
}

void drawTradeOff(QXmlStreamWriter& xml, const TradeOff& trade_off) {
    SvgCanvas canvas(xml, width_px, height_px, "plot", spokenTitle(trade_off));
    drawInto(canvas, trade_off, {0.0, 0.0});
}

QByteArray tradeOffPicture(const std::vector<TradeOff>& trade_offs, const std::string& title) {
    if (trade_offs.empty())
        return {};
    constexpr double gap = 20.0;
    const auto rows = static_cast<double>((trade_offs.size() + 1) / 2);
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.writeStartDocument();
    {
        SvgCanvas canvas(xml, 2.0 * width_px + gap, rows * height_px, "picture", nameOf(title));
        canvas.style(curve_style);
        for (std::size_t i = 0; i < trade_offs.size(); ++i)
            drawInto(canvas, trade_offs[i],
                     {static_cast<double>(i % 2) * (width_px + gap), static_cast<double>(i / 2) * height_px});
    }
    xml.writeEndDocument();
    return bytes + '\n';
}

} // namespace usar::campaign
