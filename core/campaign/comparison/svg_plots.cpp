#include "core/campaign/comparison/svg_plots.h"

#include <algorithm>
#include <cmath>

#include "core/campaign/comparison/report.h"
#include "core/campaign/comparison/svg_canvas.h"

namespace usar::campaign {

namespace {

constexpr std::size_t most_marks = 300; ///< of one plot; more could not be told apart

/// The values that are drawn of many: every n-th, with the first and the last.
std::vector<std::size_t> drawnOf(std::size_t count) {
    std::vector<std::size_t> drawn;
    const std::size_t marks = std::min(count, most_marks);
    for (std::size_t i = 0; i < marks; ++i)
        drawn.push_back(marks == 1 ? 0 : i * (count - 1) / (marks - 1));
    return drawn;
}

/// An interval, its estimate and the margin, all as gains.
void drawGain(QXmlStreamWriter& xml, const Interval& gain, double estimate, double margin, const QString& label) {
    constexpr double width = 150.0, height = 22.0, middle = height / 2.0;
    SvgCanvas canvas(xml, width, height, "interval", label);
    const double widest = std::max({std::abs(gain.low), std::abs(gain.high), 1.6 * margin, 1e-9});
    const bool is_known = std::isfinite(widest);
    const double reach = 1.08 * (is_known ? widest : 1.6 * margin);
    const Scale x{-reach, reach, 2.0, width - 2.0};
    canvas.rectangle({x(-margin), 2.0}, {x(margin), height - 2.0}, "margin");
    canvas.line({x(0.0), 0.0}, {x(0.0), height}, "zero");
    if (!is_known)
        return;
    canvas.line({x(gain.low), middle}, {x(gain.high), middle}, "reach");
    for (const double end : {gain.low, gain.high})
        canvas.line({x(end), middle - 4.0}, {x(end), middle + 4.0}, "reach");
    canvas.circle({x(estimate), middle}, 3.5, "estimate");
}

/// A frame with values along its left side.
void drawValues(SvgCanvas& canvas, const Scale& y, double left, double right) {
    const std::vector<double> values = ticks(y.low, y.high, 4);
    for (const double value : values) {
        canvas.line({left, y(value)}, {right, y(value)}, "grid");
        canvas.text({left - 6.0, y(value) + 4.0}, "end", tickText(value, values));
    }
}

const char* classOf(double difference, const MetricComparison& result) {
    if (std::abs(difference) <= result.margin)
        return "same";
    return (difference < 0.0) == result.metric.lower_is_better ? "good" : "bad";
}

/// The steps of a curve, from the lowest value shown to the highest one.
std::vector<QPointF> stepsOf(const ProfileCurve& curve, std::size_t runs, const Scale& x, const Scale& y) {
    std::vector<QPointF> points{{x(x.low), y(0.0)}};
    for (const std::size_t i : drawnOf(curve.sorted.size())) {
        points.emplace_back(x(curve.sorted[i]), points.back().y());
        points.emplace_back(x(curve.sorted[i]), y(static_cast<double>(i + 1) / static_cast<double>(runs)));
    }
    points.emplace_back(x(x.high), points.back().y());
    return points;
}

/// Both curves have a value.
Scale scaleFor(const ProfileCurve& a, const ProfileCurve& b, double first, double last) {
    const double low = std::min(a.sorted.front(), b.sorted.front());
    const double high = std::max(a.sorted.back(), b.sorted.back());
    const double more = std::max(0.04 * (high - low), 1e-3 * std::abs(high) + 1e-9);
    return {low - more, high + more, first, last};
}

} // namespace

void drawInterval(QXmlStreamWriter& xml, const MetricComparison& result) {
    const bool turned = result.metric.lower_is_better;
    const Interval gain = turned ? Interval{-result.interval.high, -result.interval.low} : result.interval;
    drawGain(xml, gain, turned ? -result.difference : result.difference, result.margin,
             "difference " + amount(result.interval, result.metric));
}

void drawInterval(QXmlStreamWriter& xml, const SuccessComparison& success, double margin) {
    drawGain(xml, success.difference, success.count.candidate().rate() - success.count.baseline().rate(), margin,
             "difference " + percent(success.difference.low) + " to " + percent(success.difference.high) + " points");
}

void drawDifferences(QXmlStreamWriter& xml, const MetricComparison& result) {
    constexpr double width = 430.0, height = 190.0, left = 56.0, right = width - 8.0, top = 10.0,
                     bottom = height - 12.0;
    const std::vector<double>& sorted = result.sorted_differences;
    SvgCanvas canvas(xml, width, height, "plot",
                     "sorted differences of " + QString::fromStdString(result.metric.title));
    const double low = std::min(sorted.front(), -1.5 * result.margin);
    const double high = std::max(sorted.back(), 1.5 * result.margin);
    const double more = 0.05 * (high - low) + 1e-9;
    const Scale y{low - more, high + more, bottom, top};
    const Scale x{-0.5, static_cast<double>(sorted.size()) - 0.5, left, right};
    canvas.rectangle({left, y(result.margin)}, {right, y(-result.margin)}, "margin");
    drawValues(canvas, y, left, right);
    canvas.line({left, y(0.0)}, {right, y(0.0)}, "zero");
    const double radius = sorted.size() > 120 ? 2.0 : 3.0;
    for (const std::size_t i : drawnOf(sorted.size()))
        canvas.circle({x(static_cast<double>(i)), y(sorted[i])}, radius, classOf(sorted[i], result));
}

void drawProfile(QXmlStreamWriter& xml, const ProfileCurve& baseline, const ProfileCurve& candidate, std::size_t runs,
                 const Metric& metric) {
    constexpr double width = 880.0, height = 300.0, left = 56.0, right = width - 12.0, top = 34.0,
                     bottom = height - 40.0;
    if (baseline.sorted.empty() || candidate.sorted.empty())
        return;
    SvgCanvas canvas(xml, width, height, "plot wide", "share of seeds by " + QString::fromStdString(metric.title));
    const Scale x = scaleFor(baseline, candidate, left, right), y{0.0, 1.0, bottom, top};
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        canvas.line({left, y(share)}, {right, y(share)}, "grid");
        canvas.text({left - 6.0, y(share) + 4.0}, "end", QString("%1 %").arg(100.0 * share));
    }
    const std::vector<double> values = ticks(x.low, x.high, 8);
    for (const double value : values)
        canvas.text({x(value), bottom + 17.0}, "middle", tickText(value, values));
    canvas.text({(left + right) / 2.0, height - 4.0}, "middle",
                QString::fromStdString(metric.title + ", " + metric.unit));
    double at = left;
    for (const auto& [curve, style] : {std::pair(&baseline, "baseline"), std::pair(&candidate, "candidate")}) {
        canvas.path(stepsOf(*curve, runs, x, y), QString("curve ") + style);
        canvas.line({at, 14.0}, {at + 28.0, 14.0}, QString("curve ") + style);
        canvas.text({at + 34.0, 18.0}, "start", curve->name, "legend");
        at += (right - left) / 2.0;
    }
}

} // namespace usar::campaign
