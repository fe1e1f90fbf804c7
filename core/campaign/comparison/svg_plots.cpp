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

/// How many differences lie below and above a range.
struct Beyond {
    std::ptrdiff_t below = 0;
    std::ptrdiff_t above = 0;
};

Beyond beyond(const std::vector<double>& sorted, double low, double high) {
    return {std::lower_bound(sorted.begin(), sorted.end(), low) - sorted.begin(),
            sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), high)};
}

/// The differences that are drawn in their place; a few of failed runs would press all others onto one line. The fences
/// are Tukey's outer ones: three times the middle half's width beyond it. Where more than a tenth lie beyond them, they
/// are no exceptions, and all are drawn. The margin is always seen.
Scale shownDifferences(const MetricComparison& result, double first, double last) {
    const std::vector<double>& sorted = result.sorted_differences;
    double low = sorted.front(), high = sorted.back();
    const double quarter = quantileOfSorted(sorted, 0.25), three_quarters = quantileOfSorted(sorted, 0.75);
    const double fence = 3.0 * (three_quarters - quarter);
    const auto [below, above] = beyond(sorted, quarter - fence, three_quarters + fence);
    if (10 * (below + above) <= std::ssize(sorted)) {
        low = std::max(low, quarter - fence);
        high = std::min(high, three_quarters + fence);
    }
    low = std::min(low, -1.5 * result.margin);
    high = std::max(high, 1.5 * result.margin);
    const double more = 0.05 * (high - low) + 1e-9;
    return {low - more, high + more, first, last};
}

/// Says in the corners how many differences stand at the edge because they lie beyond it.
void writeBeyond(SvgCanvas& canvas, const MetricComparison& result, const Scale& y, double left, double right) {
    const std::vector<double>& sorted = result.sorted_differences;
    const auto [below, above] = beyond(sorted, y.low, y.high);
    if (above > 0)
        canvas.text({right - 16.0, y(y.high) + 13.0}, "end",
                    QString("%1 up to %2").arg(above).arg(amount(sorted.back(), result.metric, true)));
    if (below > 0)
        canvas.text({left + 16.0, y(y.low) - 5.0}, "start",
                    QString("%1 down to %2").arg(below).arg(amount(sorted.front(), result.metric, true)));
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

/// One of the curves has a value at least.
Scale scaleFor(const ProfileCurve& a, const ProfileCurve& b, double first, double last) {
    const ProfileCurve& one = a.sorted.empty() ? b : a;
    const ProfileCurve& other = b.sorted.empty() ? a : b;
    const double low = std::min(one.sorted.front(), other.sorted.front());
    const double high = std::max(one.sorted.back(), other.sorted.back());
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
    const Scale y = shownDifferences(result, bottom, top);
    const Scale x{-0.5, static_cast<double>(sorted.size()) - 0.5, left, right};
    canvas.rectangle({left, y(result.margin)}, {right, y(-result.margin)}, "margin");
    drawValues(canvas, y, left, right);
    canvas.line({left, y(0.0)}, {right, y(0.0)}, "zero");
    const double radius = sorted.size() > 120 ? 2.0 : 3.0;
    for (const std::size_t i : drawnOf(sorted.size()))
        canvas.circle({x(static_cast<double>(i)), y(std::clamp(sorted[i], y.low, y.high))}, radius,
                      classOf(sorted[i], result));
    writeBeyond(canvas, result, y, left, right);
}

void drawProfile(QXmlStreamWriter& xml, const ProfileCurve& baseline, const ProfileCurve& candidate, std::size_t runs,
                 const Metric& metric) {
    constexpr double width = 880.0, height = 300.0, left = 56.0, right = width - 12.0, top = 34.0,
                     bottom = height - 40.0;
    if (baseline.sorted.empty() && candidate.sorted.empty())
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
        if (curve->name.isEmpty())
            continue;
        canvas.path(stepsOf(*curve, runs, x, y), QString("curve ") + style);
        canvas.line({at, 14.0}, {at + 28.0, 14.0}, QString("curve ") + style);
        canvas.text({at + 34.0, 18.0}, "start", curve->name, "legend");
        at += (right - left) / 2.0;
    }
}

} // namespace usar::campaign
