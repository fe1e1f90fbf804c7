#include "widgets/models/run_comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/mapping/raster_export.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

std::string tr(const char* text) {
    return QObject::tr(text).toStdString();
}

tl::unexpected<Error> notARun(const QString& path, std::string what) {
    return failure(std::move(what), QFileInfo(path).fileName().toStdString(),
                   tr("Choose a .json file that a mission left beside its pictures, or save the results again"));
}

/// nullopt unless the value is a number.
std::optional<double> number(const QJsonValue& value) {
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

/// The picture that the summary names; if the folder was moved, the one beside it.
QString pictureOf(const QJsonObject& summary, const QString& path) {
    const QString ending = QString::fromLatin1(mapping::picture_ending);
    for (const QJsonValue file : summary["files"].toArray())
        if (file.toString().endsWith(ending) && QFile::exists(file.toString()))
            return file.toString();
    const QString beside = QFileInfo(path).path() + u'/' + QFileInfo(path).completeBaseName() + ending;
    return QFile::exists(beside) ? beside : QString();
}

/// Which of two values is better.
enum class Better { Less, More, Neither };

/// A figure of a run, and how it is written.
struct Figure {
    const char* name;
    const char* help;
    std::optional<double> RunFigures::*value;
    int decimals;
    const char* unit;
    Better better;
};

constexpr Figure figures[] = {
    {QT_TR_NOOP("Coverage"), QT_TR_NOOP("Part of the mission area whose height is known"), &RunFigures::coverage_pct, 1,
     "%", Better::More},
    {QT_TR_NOOP("Of what can be reached"),
     QT_TR_NOOP("Part of what a robot could reach of the area whose height is known"),
     &RunFigures::reachable_coverage_pct, 1, "%", Better::More},
    {QT_TR_NOOP("Time"), QT_TR_NOOP("On the robot's clock"), &RunFigures::duration_s, 0, "s", Better::Less},
    {QT_TR_NOOP("Distance"), QT_TR_NOOP("As the robot estimates it"), &RunFigures::distance_m, 0, "m", Better::Less},
    {QT_TR_NOOP("Lowest"), QT_TR_NOOP("Lowest place of the whole map"), &RunFigures::lowest_m, 1, "m", Better::Neither},
    {QT_TR_NOOP("Highest"), QT_TR_NOOP("Highest place of the whole map"), &RunFigures::highest_m, 1, "m",
     Better::Neither},
    {QT_TR_NOOP("Error"), QT_TR_NOOP("Root mean square difference to the simulator's true heights, on open ground"),
     &RunFigures::error_m, 2, "m", Better::Less},
    {QT_TR_NOOP("Charges"), QT_TR_NOOP("How often the battery was charged"), &RunFigures::charges, 0, "", Better::Less},
    {QT_TR_NOOP("Collisions"), QT_TR_NOOP("As the simulator counted them"), &RunFigures::collisions, 0, "",
     Better::Less}};

QString withUnit(const QString& text, const Figure& figure) {
    return *figure.unit ? text + u' ' + QString::fromLatin1(figure.unit) : text;
}

QString written(double value, const Figure& figure) {
    if (figure.value == &RunFigures::duration_s)
        return durationText(Seconds(value));
    return withUnit(widgets::figure(value, figure.decimals), figure);
}

/// Values that are written alike are alike.
double rounded(double value, const Figure& figure) {
    const double scale = std::pow(10.0, figure.decimals);
    return std::round(value * scale) / scale;
}

QString differenceText(double difference, const Figure& figure) {
    if (difference == 0.0)
        return QObject::tr("same");
    const QString text = written(std::abs(difference), figure);
    return (difference > 0.0 ? QStringLiteral("+") : QStringLiteral("−")) + text;
}

/// The value that no run betters; nullopt if all that are known are alike, or the figure has no better.
std::optional<double> bestOf(const std::vector<RunFigures>& runs, const Figure& figure) {
    std::vector<double> known;
    for (const RunFigures& run : runs)
        if (const auto& value = run.*figure.value)
            known.push_back(rounded(*value, figure));
    if (known.empty() || figure.better == Better::Neither)
        return std::nullopt;
    const auto [least, most] = std::ranges::minmax(known);
    if (least == most)
        return std::nullopt;
    return figure.better == Better::Less ? least : most;
}

ComparedRow rowOf(const Figure& figure, const std::vector<RunFigures>& runs) {
    ComparedRow row{QObject::tr(figure.name), QObject::tr(figure.help), {}};
    const std::optional<double> best = bestOf(runs, figure);
    for (const RunFigures& run : runs) {
        const auto& first = runs.front().*figure.value;
        const auto& value = run.*figure.value;
        ComparedCell cell{value ? written(*value, figure) : widgets::figure(std::nan(""), 0), {}, false};
        if (value && first && &run != &runs.front())
            cell.difference = differenceText(rounded(*value, figure) - rounded(*first, figure), figure);
        cell.better = value && best && rounded(*value, figure) == *best;
        row.cells.push_back(cell);
    }
    return row;
}

ComparedRow textRow(const QString& name, const QString& help, const std::vector<RunFigures>& runs,
                    const std::function<QString(const RunFigures&)>& text) {
    ComparedRow row{name, help, {}};
    for (const RunFigures& run : runs) {
        const QString words = text(run);
        row.cells.push_back({words.isEmpty() ? widgets::figure(std::nan(""), 0) : words, {}, false});
    }
    return row;
}

QString endOf(const RunFigures& run) {
    return !run.success ? QString() : *run.success ? QObject::tr("complete") : QObject::tr("ended early");
}

} // namespace

Result<RunFigures> readRun(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return notARun(path, tr("cannot be read"));
    QJsonParseError error;
    const QByteArray text = file.readAll();
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        const auto line = text.left(error.offset).count('\n') + 1;
        return notARun(path, QObject::tr("is garbled at line %1").arg(line).toStdString());
    }
    const QJsonObject summary = document.object();
    if (!summary.contains("success") || !summary.contains("duration_s"))
        return notARun(path, tr("is not the summary of a run"));
    const QJsonObject map = summary["map"].toObject();
    RunFigures run{.path = path, .mission = summary["mission"].toString(), .behavior = summary["behavior"].toString()};
    run.success = summary["success"].isBool() ? std::optional(summary["success"].toBool()) : std::nullopt;
    run.coverage_pct = number(summary["coverage_pct"]);
    run.reachable_coverage_pct = number(summary["reachable_coverage_pct"]);
    run.duration_s = number(summary["duration_s"]);
    run.distance_m = number(summary["distance_m"]);
    run.lowest_m = number(map["minimum_m"]);
    run.highest_m = number(map["maximum_m"]);
    run.error_m = number(summary["rmse_m"]);
    run.charges = number(summary["charges"]);
    run.collisions = number(summary["collisions"]);
    run.picture = pictureOf(summary, path);
    return run;
}

std::vector<ComparedRow> compared(const std::vector<RunFigures>& runs) {
    std::vector<ComparedRow> rows;
    rows.push_back(textRow(QObject::tr("Result"), QObject::tr("How the mission ended"), runs, endOf));
    rows.push_back(textRow(QObject::tr("Behavior"), QObject::tr("What decided"), runs, &RunFigures::behavior));
    for (const Figure& figure : figures)
        rows.push_back(rowOf(figure, runs));
    return rows;
}

QString titleOf(const RunFigures& run) {
    const QString name = run.title.isEmpty() ? QFileInfo(run.path).completeBaseName() : run.title;
    return run.mission.isEmpty() ? name : run.mission + u'\n' + name;
}

} // namespace usar::widgets
