#include "widgets/models/plot/plot_layout.h"

#include <cmath>
#include <limits>

#include <QJsonArray>

namespace usar::widgets {

namespace {

constexpr int version = 1;
constexpr const char* mend = "Arrange the plots again, and save the layout";

tl::unexpected<Error> wrong(const QString& key, const char* expected) {
    return failure(std::string("this entry of a plot layout is not ") + expected, key.toStdString(), mend);
}

/// Reads an entry that may be missing.
Result<void> readFlag(const QJsonObject& object, const QString& key, bool& flag) {
    if (const QJsonValue value = object.value(key); value.isBool())
        flag = value.toBool();
    else if (!value.isUndefined())
        return wrong(key, "true or false");
    return {};
}

Result<void> readText(const QJsonObject& object, const QString& key, std::string& text) {
    if (const QJsonValue value = object.value(key); value.isString())
        text = value.toString().toStdString();
    else if (!value.isUndefined())
        return wrong(key, "a text");
    return {};
}

Result<void> readWindow(const QJsonObject& object, double& window_s) {
    const QString key = QStringLiteral("window_s");
    const QJsonValue value = object.value(key);
    if (value.isUndefined())
        return {};
    if (value.toString() == QStringLiteral("all"))
        window_s = std::numeric_limits<double>::infinity();
    else if (value.isDouble() && value.toDouble() > 0.0)
        window_s = value.toDouble();
    else
        return wrong(key, "a number of seconds above zero or \"all\"");
    return {};
}

Result<std::vector<PlotSeries>> readCanvas(const QJsonObject& canvas) {
    const QString key = QStringLiteral("series");
    const QJsonValue list = canvas.value(key);
    if (!list.isUndefined() && !list.isArray())
        return wrong(key, "a list");
    std::vector<PlotSeries> all;
    for (const QJsonValue& each : list.toArray()) {
        PlotSeries series;
        const QJsonObject object = each.toObject();
        for (const auto& [name, text] : {std::pair(QStringLiteral("robot"), &series.robot),
                                         {QStringLiteral("path"), &series.path},
                                         {QStringLiteral("unit"), &series.unit}})
            if (const Result<void> read = readText(object, name, *text); !read)
                return tl::unexpected(read.error());
        if (series.path.empty())
            return wrong(key, "a list of objects with a \"path\"");
        all.push_back(series);
    }
    return all;
}

QJsonObject toJson(const PlotSeries& series) {
    QJsonObject object{{QStringLiteral("robot"), QString::fromStdString(series.robot)},
                       {QStringLiteral("path"), QString::fromStdString(series.path)}};
    if (!series.unit.empty())
        object.insert(QStringLiteral("unit"), QString::fromStdString(series.unit));
    return object;
}

} // namespace

QJsonObject toJson(const PlotLayout& layout) {
    QJsonArray canvases;
    for (const std::vector<PlotSeries>& canvas : layout.canvases) {
        QJsonArray list;
        for (const PlotSeries& series : canvas)
            list.append(toJson(series));
        canvases.append(QJsonObject{{QStringLiteral("series"), list}});
    }
    const QJsonValue window = std::isfinite(layout.window_s) ? QJsonValue(layout.window_s) : QJsonValue("all");
    return {{QStringLiteral("version"), version},
            {QStringLiteral("follow_robot"), layout.follow_robot},
            {QStringLiteral("statistics"), layout.statistics},
            {QStringLiteral("window_s"), window},
            {QStringLiteral("canvases"), canvases}};
}

Result<PlotLayout> plotLayoutFrom(const QJsonObject& object) {
    PlotLayout layout;
    for (const Result<void>& read :
         {readFlag(object, QStringLiteral("follow_robot"), layout.follow_robot),
          readFlag(object, QStringLiteral("statistics"), layout.statistics), readWindow(object, layout.window_s)})
        if (!read)
            return tl::unexpected(read.error());
    const QString key = QStringLiteral("canvases");
    const QJsonValue list = object.value(key);
    if (list.isUndefined())
        return layout;
    if (!list.isArray() || list.toArray().isEmpty())
        return wrong(key, "a list with at least one canvas");
    if (list.toArray().size() > static_cast<qsizetype>(PlotLayout::most_canvases))
        return wrong(key, "a list of at most 8 canvases");
    layout.canvases.clear();
    for (const QJsonValue& each : list.toArray()) {
        if (!each.isObject())
            return wrong(key, "a list of objects");
        Result<std::vector<PlotSeries>> canvas = readCanvas(each.toObject());
        if (!canvas)
            return tl::unexpected(canvas.error());
        layout.canvases.push_back(*canvas);
    }
    return layout;
}

} // namespace usar::widgets
