#include "widgets/models/plot/plot_texts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCoreApplication>
#include <QStringList>

#include "core/base/numbers.h"
#include "widgets/models/figures.h"
#include "widgets/models/parameter_display.h"

namespace usar::widgets {

namespace {

constexpr double never_s = std::numeric_limits<double>::infinity();

QString tr(const char* text) {
    return QCoreApplication::translate("usar::widgets::PlotView", text);
}

/// Four digits for small numbers: a slope of 0.0012 must not be shown as 0.00.
int decimalsOf(double shown) {
    const double size = std::abs(shown);
    return size >= 100.0 ? 1 : size >= 0.1 || size == 0.0 ? 2 : size >= 0.001 ? 4 : 6;
}

QString withUnit(double value, const std::string& unit, const QString& per) {
    const DisplayUnit display = displayUnit(unit);
    const double shown = value * display.factor;
    const QString figures = figure(shown, decimalsOf(shown));
    const QString words = display.text.isEmpty() && per.isEmpty() ? QString()
                          : display.text.isEmpty()                ? QStringLiteral("1") + per
                                                                  : display.text + per;
    return words.isEmpty() ? figures : figures + u' ' + words;
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

QString spokenPath(const std::string& path) {
    QString text = QString::fromStdString(path);
    if (text.startsWith(QStringLiteral("SEN ")))
        text.remove(0, 4);
    QStringList parts = text.split(u'/', Qt::SkipEmptyParts);
    if (parts.size() > 2 && parts[0] == parts[1])
        parts.removeFirst();
    return parts.join(u' ').simplified();
}

QString labelOf(const SeriesKey& key) {
    const QString field = spokenPath(key.path);
    return key.robot.empty() ? field : QString::fromStdString(key.robot) + QStringLiteral(" · ") + field;
}

QString momentText(double time_s) {
    if (!std::isfinite(time_s))
        return figure(time_s, 1);
    const auto tenths = std::llround(10.0 * std::abs(time_s));
    const QString text = clockText(Seconds(static_cast<double>(tenths / 10))) + u'.' + QString::number(tenths % 10);
    return time_s < 0.0 && tenths > 0 ? QChar(0x2212) + text : text;
}

QString readingText(const std::optional<Reading>& reading, const std::string& unit) {
    if (!reading)
        return figure(std::nan(""), 2);
    return (reading->exact ? QString() : QStringLiteral("≈ ")) + withUnit(reading->value, unit, {});
}

QString differenceText(const std::optional<double>& difference, const std::string& unit, const QString& per) {
    if (!difference)
        return figure(std::nan(""), 2);
    return (*difference > 0.0 ? QStringLiteral("+") : QString()) + withUnit(*difference, unit, per);
}

QString cursorSentences(const PlotModel& model) {
    const PlotCursors& cursors = model.cursors();
    if (!cursors.a_s && !cursors.b_s)
        return {};
    QStringList times;
    if (cursors.a_s)
        times << tr("Cursor A is at %1").arg(momentText(*cursors.a_s));
    if (cursors.b_s)
        times << tr("Cursor B is at %1").arg(momentText(*cursors.b_s));
    if (const std::optional<double> span = cursors.difference_s())
        times << tr("B is %1 from A").arg(differenceText(span, "s"));
    QString text = times.join(QStringLiteral(". ")) + u'.';
    for (const ShownSeries& each : model.shown()) {
        const CursorRow row = cursorRow(each.series->samples, cursors);
        QStringList parts;
        if (cursors.a_s)
            parts << tr("at A %1").arg(readingText(row.a, each.series->unit));
        if (cursors.b_s)
            parts << tr("at B %1").arg(readingText(row.b, each.series->unit));
        if (row.difference)
            parts << tr("difference %1").arg(differenceText(row.difference, each.series->unit));
        if (row.slope_per_s)
            parts << tr("slope %1").arg(differenceText(row.slope_per_s, each.series->unit, QStringLiteral("/s")));
        text += u' ' + labelOf(each.key) + QStringLiteral(": ") + parts.join(QStringLiteral(", ")) + u'.';
    }
    return text;
}

std::vector<QString> statisticsTexts(const Statistics& statistics, const std::string& unit) {
    const QString sign = statistics.exact ? QString() : QStringLiteral("≈ ");
    std::vector<QString> texts{sign + QString::number(statistics.count)};
    for (const double value : {statistics.least, statistics.most, statistics.mean, statistics.deviation})
        texts.push_back(statistics.count == 0 ? figure(std::nan(""), 2) : sign + withUnit(value, unit, {}));
    return texts;
}

std::vector<TableColumn> tableOf(const PlotModel& model) {
    std::vector<TableColumn> columns;
    std::vector<SeriesKey> taken;
    for (const ShownSeries& each : model.shown()) {
        if (std::ranges::find(taken, each.key) != taken.end())
            continue;
        taken.push_back(each.key);
        const std::string unit = each.series->unit.empty() ? "" : " [" + each.series->unit + ']';
        const std::string robot = each.key.robot.empty() ? "" : each.key.robot + ' ';
        columns.push_back({robot + each.key.path + unit, each.series->samples.knownSamples()});
    }
    return columns;
}

std::string csvOf(const std::vector<TableColumn>& columns) {
    std::string csv = "time_s";
    for (const TableColumn& each : columns)
        csv += ',' + csvCell(each.head);
    csv += '\n';
    std::vector<std::size_t> taken(columns.size(), 0);
    const auto next = [&](std::size_t i) {
        return taken[i] < columns[i].samples.size() ? columns[i].samples[taken[i]] : Sample{never_s, 0.0};
    };
    for (;;) {
        double time_s = never_s;
        for (std::size_t i = 0; i < columns.size(); ++i)
            time_s = std::min(time_s, next(i).time_s);
        if (time_s == never_s)
            return csv;
        appendShortest(csv, time_s);
        for (std::size_t i = 0; i < columns.size(); ++i) {
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
