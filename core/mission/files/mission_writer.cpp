#include "core/mission/files/mission_writer.h"

#include <algorithm>
#include <cmath>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace usar::mission {

namespace {

/// Returns the degrees that the user typed, without the rounding error of the conversion to radians.
double typedDegrees(double angle_rad) {
    constexpr double grain = 1e9;
    return std::round(degrees(angle_rad) * grain) / grain;
}

QJsonValue written(const agent::ParameterValue& value, bool is_angle) {
    if (const auto* real = std::get_if<double>(&value))
        return is_angle ? typedDegrees(*real) : *real;
    if (const auto* whole = std::get_if<long long>(&value))
        return static_cast<qint64>(*whole);
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag;
    return QString::fromStdString(std::get<std::string>(value));
}

/// Returns the path relative to the folder if the plan is inside it, so that both can be moved together; else absolute.
QString planPath(const QString& plan, const QString& folder) {
    const QString absolute = QFileInfo(plan).absoluteFilePath();
    const QString relative = folder.isEmpty() ? absolute : QDir(folder).relativeFilePath(absolute);
    return relative.startsWith("..") ? absolute : relative;
}

} // namespace

QByteArray writeMission(const Mission& mission, const std::vector<agent::ParameterSpec>& specs, const QString& folder) {
    QJsonObject parameters;
    for (const auto& [id, value] : mission.parameters) {
        const bool is_angle = std::ranges::any_of(
            specs, [&id = id](const agent::ParameterSpec& spec) { return spec.id == id && spec.unit == "rad"; });
        parameters[QString::fromStdString(id)] = written(value, is_angle);
    }
    const Vec2 size_m = mission.area_in_map.max_m - mission.area_in_map.min_m;
    const QJsonObject area{{"x", mission.area_in_map.min_m.x()},
                           {"y", mission.area_in_map.min_m.y()},
                           {"width", size_m.x()},
                           {"height", size_m.y()}};
    QJsonObject all{{"name", QString::fromStdString(mission.name)},
                    {"world", QString::fromStdString(mission.world)},
                    {"robot", QString::fromStdString(mission.robot_class)},
                    {"start", QString::fromStdString(mission.start)},
                    {"behavior", QString::fromStdString(mission.behavior)},
                    {"area", area},
                    {"parameters", parameters},
                    {"cell_size_m", mission.cell_size_m}};
    if (!mission.plan.empty())
        all["plan"] = planPath(QString::fromStdString(mission.plan), folder);
    if (mission.area_in_map.empty())
        all.remove("area");
    if (mission.isolate)
        all["isolate"] = true;
    QJsonArray faults;
    for (const std::string& fault : mission.faults)
        faults.append(QString::fromStdString(fault));
    if (!faults.isEmpty())
        all["faults"] = faults;
    return QJsonDocument(all).toJson(QJsonDocument::Indented);
}

Result<void> writeMissionFile(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                              const QString& path) {
    QSaveFile file(path);
    const QByteArray json = writeMission(mission, specs, QFileInfo(path).absolutePath());
    if (file.open(QIODevice::WriteOnly) && file.write(json) == json.size() && file.commit())
        return {};
    return failure("the mission is not saved: " + file.errorString().toStdString(), path.toStdString(),
                   "Choose a folder that you may write to, with room on its disk");
}

} // namespace usar::mission
