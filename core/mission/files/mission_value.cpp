#include "core/mission/files/mission_value.h"

#include <cmath>
#include <functional>

#include <QJsonArray>
#include <QJsonDocument>

#include "core/base/numbers.h"
#include "core/base/spelling.h"
#include "core/mission/files/json_reading.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

namespace {

using Setter = std::function<bool(Mission& mission, const QString& value)>;

Setter text(std::string Mission::*member) {
    return [member](Mission& mission, const QString& value) {
        mission.*member = value.toStdString();
        return !value.trimmed().isEmpty();
    };
}

Setter flag(bool Mission::*member) {
    return [member](Mission& mission, const QString& value) {
        mission.*member = value == "true";
        return value == "true" || value == "false";
    };
}

/// `put` returns false if the number is out of range.
Setter number(const std::function<bool(Mission& mission, double value)>& put) {
    return [put](Mission& mission, const QString& value) {
        const auto read = readNumber(value.toStdString());
        return read && std::isfinite(*read) && put(mission, *read);
    };
}

/// Moves the area's lower edge along one axis, and its size stays.
bool move(Rectangle& area, int axis, double to_m) {
    area.max_m[axis] += to_m - area.min_m[axis];
    area.min_m[axis] = to_m;
    return true;
}

bool resize(Rectangle& area, int axis, double size_m) {
    area.max_m[axis] = area.min_m[axis] + size_m;
    return size_m > 0.0;
}

const std::map<std::string, Setter>& setters() {
    static const std::map<std::string, Setter> all{
        {"name", text(&Mission::name)},
        {"world", text(&Mission::world)},
        {"robot", text(&Mission::robot_class)},
        {"start", text(&Mission::start)},
        {"preset", text(&Mission::preset)},
        {"adjust", flag(&Mission::adjust)},
        {"area.x", number([](Mission& mission, double value) { return move(mission.area_in_map, 0, value); })},
        {"area.y", number([](Mission& mission, double value) { return move(mission.area_in_map, 1, value); })},
        {"area.width", number([](Mission& mission, double value) { return resize(mission.area_in_map, 0, value); })},
        {"area.height", number([](Mission& mission, double value) { return resize(mission.area_in_map, 1, value); })},
        {"cell_size_m", number([](Mission& mission, double value) {
             mission.cell_size_m = value;
             return value >= smallest_cell_m && value <= largest_cell_m;
         })},
        {"limit_h", number([](Mission& mission, double value) {
             mission.limit_h = value;
             return value > 0.0;
         })}};
    return all;
}

/// A number, true or false as JSON writes them; everything else is a text.
agent::ParameterValue parameterFrom(const QString& value) {
    const QJsonArray read = QJsonDocument::fromJson('[' + value.toUtf8() + ']').array();
    const auto parameter = read.size() == 1 ? parameterOf(read.first()) : std::nullopt;
    return parameter.value_or(value.toStdString());
}

} // namespace

Result<void> setValue(Mission& mission, const QString& text) {
    const std::string key = text.section('=', 0, 0).trimmed().toStdString();
    const QString value = text.section('=', 1).trimmed();
    const std::string written = "--set " + text.toStdString();
    if (!text.contains('=') || key.empty())
        return failure("this is no KEY=VALUE", written, "For example --set area.width=40");
    static const std::string parameters = "parameters.";
    if (key.starts_with(parameters) && key.size() > parameters.size()) {
        mission.parameters[key.substr(parameters.size())] = parameterFrom(value);
    } else if (const auto found = setters().find(key); found == setters().end()) {
        std::vector<std::string> known{parameters + "ID"};
        for (const auto& [name, setter] : setters())
            known.push_back(name);
        return failure("unknown key \"" + key + "\"", written,
                       "did you mean \"" + nearestWord(key, known) +
                           "\"? Known here: " + textsOf(known).join(", ").toStdString());
    } else if (!found->second(mission, value)) {
        return failure("the value does not fit \"" + key + "\"", written, "Write it as in a mission file");
    }
    mission.places.erase(key);
    return {};
}

} // namespace usar::mission
