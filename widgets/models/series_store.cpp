#include "widgets/models/series_store.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"

namespace usar::widgets {

namespace {

constexpr double another_run_s = 1.0;
constexpr double never_s = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the value to draw: a number, 0 or 1 for a flag, NaN (a gap) for "nan"; nullopt for other texts.
std::optional<double> drawable(const protocol::Field& field) {
    if (field.number)
        return std::isfinite(*field.number) ? *field.number : no_number;
    if (field.text == "True")
        return 1.0;
    if (field.text == "False")
        return 0.0;
    return field.text == "nan" ? std::optional(no_number) : std::nullopt;
}

/// Quotes a cell that contains a comma, a quote or a line end.
std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string cell = "\"";
    for (const char c : text)
        cell += c == '"' ? std::string("\"\"") : std::string(1, c);
    return cell + '"';
}

} // namespace

bool SeriesStore::add(const std::string& path, const std::string& unit) {
    if (path.empty() || std::ranges::find(series_, path, &Series::path) != series_.end())
        return false;
    series_.push_back({++last_history_, path, unit, {}, 0});
    return true;
}

bool SeriesStore::remove(const std::string& path) {
    return std::erase_if(series_, [&](const Series& series) { return series.path == path; }) > 0;
}

void SeriesStore::clear() {
    series_.clear();
    newest_s_.reset();
}

bool SeriesStore::take(const protocol::InfoLine& line, Seconds now) {
    if (series_.empty())
        return false;
    const double time_s = protocol::timeOf(line.message).value_or(now).count();
    if (!std::isfinite(time_s))
        return false;
    if (newest_s_ && time_s < *newest_s_ - another_run_s)
        startAgain();
    newest_s_ = std::max(newest_s_.value_or(time_s), time_s);
    bool any = false;
    for (const protocol::Field& field : protocol::fieldsOf(line.message)) {
        const auto found = std::ranges::find(series_, field.path(), &Series::path);
        if (found == series_.end())
            continue;
        append(*found, field, time_s);
        any = true;
    }
    return any;
}

std::optional<double> SeriesStore::oldestTime_s() const {
    std::optional<double> oldest;
    for (const Series& series : series_)
        if (!series.samples.empty())
            oldest = std::min(oldest.value_or(series.samples.front().time_s), series.samples.front().time_s);
    return oldest;
}

void SeriesStore::startAgain() {
    for (Series& series : series_) {
        series.samples.clear();
        series.dropped = 0;
        series.history = ++last_history_;
    }
    newest_s_.reset();
}

void SeriesStore::append(Series& series, const protocol::Field& field, double time_s) {
    const std::optional<double> value = drawable(field);
    if (!value || (!series.samples.empty() && time_s < series.samples.back().time_s))
        return;
    if (series.samples.empty() && series.unit.empty())
        series.unit = field.unit;
    series.samples.push_back({time_s, *value});
    if (series.samples.size() > capacity_) {
        series.samples.pop_front();
        ++series.dropped;
    }
}

std::optional<double> valueAt(const Series& series, double time_s) {
    const auto after = std::ranges::upper_bound(series.samples, time_s, {}, &Sample::time_s);
    if (after == series.samples.begin() || std::isnan(std::prev(after)->value))
        return std::nullopt;
    return std::prev(after)->value;
}

std::string csvOf(const std::vector<Series>& series) {
    std::string csv = "time_s";
    for (const Series& each : series)
        csv += ',' + csvCell(each.path + (each.unit.empty() ? "" : " [" + each.unit + ']'));
    csv += '\n';
    std::vector<std::size_t> taken(series.size(), 0);
    const auto next = [&](std::size_t i) {
        return taken[i] < series[i].samples.size() ? series[i].samples[taken[i]] : Sample{never_s, no_number};
    };
    for (;;) {
        double time_s = never_s;
        for (std::size_t i = 0; i < series.size(); ++i)
            time_s = std::min(time_s, next(i).time_s);
        if (time_s == never_s)
            return csv;
        appendShortest(csv, time_s);
        for (std::size_t i = 0; i < series.size(); ++i) {
            csv += ',';
            const Sample sample = next(i);
            if (sample.time_s != time_s)
                continue;
            ++taken[i];
            if (std::isfinite(sample.value))
                appendShortest(csv, sample.value);
        }
        csv += '\n';
    }
}

} // namespace usar::widgets
