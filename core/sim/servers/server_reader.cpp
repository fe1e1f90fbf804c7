#include "core/sim/servers/server_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/wire_frame.h"
#include "core/sim/servers/sensor_classes.h"
#include "core/sim/servers/server_ini.h"

namespace usar::sim {

namespace {

using protocol::Dialect;

constexpr std::string_view robot_prefix = "usarbot.";
constexpr double close_enough = 1e-3; ///< m and rad

double numberIn(const IniFields& fields, std::string_view name) {
    return readNumberPrefix(fieldIn(fields, name)).value;
}

Vec3 vectorIn(std::string_view value) {
    const IniFields fields = fieldsOf(value);
    return {numberIn(fields, "X"), numberIn(fields, "Y"), numberIn(fields, "Z")};
}

ServerItem itemOf(const IniFields& fields) {
    const Vec3 angles_rad = vectorIn(fieldIn(fields, "Direction"));
    const Pose on_wire{.position_m = vectorIn(fieldIn(fields, "Position")),
                       .roll_rad = angles_rad.x(),
                       .pitch_rad = angles_rad.y(),
                       .yaw_rad = angles_rad.z()};
    return {std::string(classIn(fieldIn(fields, "ItemClass"))), std::string(fieldIn(fields, "ItemName")),
            std::string(fieldIn(fields, "Parent")), protocol::acrossWire(on_wire)};
}

/// Adds a scalar; a text that is neither number nor truth value is left out.
void addNumber(Numbers& numbers, std::string_view key, std::string_view value) {
    const NumberPrefix number = readNumberPrefix(value);
    if (number.used > 0)
        numbers[lowerCase(key)] = number.value;
    else if (sameWord(value, "True") || sameWord(value, "False"))
        numbers[lowerCase(key)] = sameWord(value, "True") ? 1.0 : 0.0;
}

bool isList(std::string_view key) {
    return sameWord(key, "Sensors") || sameWord(key, "Cameras") || sameWord(key, "AddParts");
}

auto isCalled(std::string_view class_name) {
    return [class_name](const ServerRobot& robot) { return sameWord(robot.class_name, class_name); };
}

/// Adds what the section says of its robot. A file may have several sections of one robot; all of them count.
void addToRobot(std::vector<ServerRobot>& robots, const IniSection& section) {
    const std::string class_name = section.name.substr(robot_prefix.size());
    const auto known = std::ranges::find_if(robots, isCalled(class_name));
    ServerRobot& robot = known != robots.end() ? *known : robots.emplace_back(ServerRobot{class_name, {}, {}});
    for (const std::string& line : section.lines) {
        const auto [key, value] = entryOf(line);
        if (isList(key))
            robot.items.push_back(itemOf(fieldsOf(value)));
        else
            addNumber(robot.numbers, key, value);
    }
}

bool isPlaced(const SensorModel& ours, const ServerItem& theirs) {
    const Pose& wanted = ours.sensor_in_link;
    const Pose& found = theirs.item_in_parent;
    return (wanted.position_m - found.position_m).cwiseAbs().maxCoeff() < close_enough &&
           wanted.rotation().angularDistance(found.rotation()) < close_enough &&
           sameWord(theirs.parent, ours.link < 0 ? "" : ours.mount);
}

void compareSettings(const RobotModel& robot, const SensorModel& ours, const ServerItem& theirs,
                     const ServerFile& server, std::vector<std::string>& differences) {
    const auto section = server.settings.find(lowerCase(theirs.class_name));
    for (const ServerSetting& setting : settingsOf(ours.type, server.dialect)) {
        const auto wanted = ours.numbers.find(setting.ours);
        if (wanted == ours.numbers.end())
            continue;
        const bool told = section != server.settings.end() && section->second.contains(lowerCase(setting.theirs));
        const double found = told ? section->second.at(lowerCase(setting.theirs)) : 0.0;
        if (!told || std::abs(found - wanted->second) > close_enough)
            differences.push_back(robot.class_name + ": " + ours.type + " " + ours.name + " wants a " +
                                  std::string(setting.theirs) + " of " + shortest(wanted->second) +
                                  ", and the server " + (told ? "has " + shortest(found) : "says none"));
    }
}

} // namespace

const ServerRobot* ServerFile::robot(std::string_view class_name) const {
    const auto found = std::ranges::find_if(robots, isCalled(class_name));
    return found == robots.end() ? nullptr : &*found;
}

Result<ServerFile> readServerFile(std::string_view text) {
    ServerFile file;
    for (const IniSection& section : sectionsOf(text)) {
        if (lowerCase(section.name).starts_with("usarsensor."))
            file.dialect = Dialect::Udk;
        for (const std::string& line : section.lines) {
            const auto [key, value] = entryOf(line);
            if (sameWord(key, "AddParts"))
                file.dialect = Dialect::Udk;
            else if (!isList(key))
                addNumber(file.settings[lowerCase(section.name)], key, value);
        }
        if (lowerCase(section.name).starts_with(robot_prefix))
            addToRobot(file.robots, section);
    }
    if (file.robots.empty())
        return failure("there is no section of a robot in it", "", "Give a server's USARBot.ini or DefaultUSAR.ini");
    return file;
}

std::vector<std::string> differencesOf(const RobotModel& ours, const ServerFile& server) {
    const ServerRobot* const theirs = server.robot(ours.class_name);
    if (!theirs)
        return {ours.class_name + ": the server's file has no section for it"};
    const SensorClasses classes = stockClasses(server.dialect);
    std::vector<std::string> differences;
    for (const SensorModel& sensor : ours.sensors) {
        if (!classes.contains(sensor.type) || (sensor.link >= 0 && server.dialect == Dialect::Udk))
            continue;
        const std::string what = ours.class_name + ": " + sensor.type + " " + sensor.name;
        const auto found = std::ranges::find_if(theirs->items, [&](const ServerItem& item) {
            return sameWord(item.name, sensor.name) && mayHaveClass(sensor.type, item.class_name, classes);
        });
        if (found == theirs->items.end()) {
            differences.push_back(what + " is missing");
            continue;
        }
        if (!isPlaced(sensor, *found))
            differences.push_back(what + " stands elsewhere or looks elsewhere");
        compareSettings(ours, sensor, *found, server, differences);
    }
    return differences;
}

} // namespace usar::sim
