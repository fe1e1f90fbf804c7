#include "core/sim/servers/server_writer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/wire_frame.h"
#include "core/sim/servers/sensor_classes.h"
#include "core/sim/servers/server_ini.h"
#include "core/sim/simulation.h"

namespace usar::sim {

namespace {

using protocol::Dialect;

constexpr std::string_view leading_robot = "AirRobot"; ///< whose settings count first
constexpr int decimals = 6;                            ///< as in the robot files
constexpr Seconds message_period{0.2};                 ///< of UT2004, see protocol.md 1.8

std::string numberText(double value) {
    return fixed(std::abs(value) < 0.5e-6 ? 0.0 : value, decimals);
}

std::string vectorText(const Vec3& vector) {
    return "(X=" + numberText(vector.x()) + ",Y=" + numberText(vector.y()) + ",Z=" + numberText(vector.z()) + ")";
}

/// A robot that carries nothing that moves: what the server's own robot has of it must go.
bool isBare(const RobotModel& robot) {
    return robot.packages.empty() &&
           std::ranges::none_of(robot.sensors, [](const SensorModel& one) { return one.type == "Camera"; });
}

/// True if the items of this list in a server's file are parts that move and cameras.
bool isMovingPart(std::string_view key, std::string_view class_name) {
    return sameWord(key, "MisPkgs") || sameWord(key, "Cameras") || lowerCase(class_name).starts_with("usaractuator.");
}

/// What goes into a section besides the lines of items, by key.
using Entries = std::vector<std::pair<std::string, std::string>>;

/// Makes the parts of one server's file from the robots.
class Equipping {
public:
    Equipping(const RobotCatalog& robots, Dialect dialect, SensorClasses classes)
        : dialect_(dialect)
        , classes_(std::move(classes)) {
        for (const RobotModel& robot : robots)
            if (isOnServer(robot.class_name, dialect))
                robots_.push_back(&robot);
        std::ranges::stable_partition(
            robots_, [](const RobotModel* robot) { return sameWord(robot->class_name, leading_robot); });
    }

    const std::vector<const RobotModel*>& robots() const { return robots_; }
    const SensorClasses& classes() const { return classes_; }
    std::vector<std::string> takeLeftOut() { return std::move(left_out_); }

    /// The settings of the class of these sensors; empty if no robot says any.
    Entries settingsFor(const std::string& type) {
        Entries entries;
        for (const ServerSetting& setting : settingsOf(type, dialect_))
            if (const auto value = agreed(type, setting))
                entries.emplace_back(setting.theirs, numberText(*value));
        if (!entries.empty() && sameWord(type, "RangeScanner"))
            entries.emplace(entries.begin(), "HiddenSensor", "True");
        return entries;
    }

    /// Scalars of a robot's section.
    Entries factsOf() const {
        if (dialect_ == Dialect::Udk)
            return {};
        return {{"bMountByUU", "False"}, batteryLife(), {"msgTimer", numberText(message_period.count())}};
    }
    /// UDK's robots carry a sensor that is the battery, or have no battery.
    bool hasBatteries() const { return dialect_ == Dialect::Udk; }
    static std::pair<std::string, std::string> batteryLife() {
        return {"batteryLife", fixed(survey_battery_life.count(), 0)};
    }

    /// True if the sensor gets a line in this list.
    bool isWritten(const SensorModel& sensor, std::string_view key) const {
        return classes_.contains(sensor.type) && sameWord(key, listKeyOf(sensor.type, dialect_));
    }

    /// The lines of the robot's sensors.
    std::vector<std::string> itemsOf(const RobotModel& robot) {
        std::vector<std::string> lines;
        for (const SensorModel& sensor : robot.sensors) {
            const auto known = classes_.find(sensor.type);
            if (known == classes_.end())
                leaveOut(robot, sensor, "this server has no class for it, or one that is unknown");
            else if (sensor.link >= 0 && dialect_ == Dialect::Udk)
                leaveOut(robot, sensor, "it hangs on " + sensor.mount + ", which the server's actuator carries");
            else
                lines.push_back(lineOf(sensor, known->second));
        }
        return lines;
    }

private:
    std::string lineOf(const SensorModel& sensor, const std::string& class_name) const {
        const Pose sensor_on_wire = protocol::acrossWire(sensor.sensor_in_link);
        return std::string(listKeyOf(sensor.type, dialect_)) + "=(ItemClass=class'" + class_name + "',ItemName=\"" +
               sensor.name + "\"" + (sensor.link >= 0 ? ",Parent=\"" + sensor.mount + "\"" : "") +
               ",Position=" + vectorText(sensor_on_wire.position_m) +
               ",Direction=" + vectorText(protocol::anglesOf(sensor_on_wire)) + ")";
    }

    void leaveOut(const RobotModel& robot, const SensorModel& sensor, const std::string& why) {
        left_out_.push_back(robot.class_name + ": " + sensor.type + " " + sensor.name + " is left out; " + why);
    }

    /// The first robot's value of the setting; notes who wants another one.
    std::optional<double> agreed(const std::string& type, const ServerSetting& setting) {
        std::optional<double> value;
        std::set<std::string> noted;
        for (const RobotModel* robot : robots_)
            for (const SensorModel& sensor : robot->sensors) {
                const auto wanted = sensor.numbers.find(setting.ours);
                if (sensor.type != type || wanted == sensor.numbers.end())
                    continue;
                if (!value)
                    value = wanted->second;
                else if (numberText(*value) != numberText(wanted->second) && noted.insert(robot->class_name).second)
                    left_out_.push_back(robot->class_name + ": its " + type + " wants a " +
                                        std::string(setting.theirs) + " of " + shortest(wanted->second) + " and gets " +
                                        shortest(*value) + ", because a server has one for all");
            }
        return value;
    }

    Dialect dialect_;
    SensorClasses classes_;
    std::vector<const RobotModel*> robots_;
    std::vector<std::string> left_out_;
};

bool isSectionOf(const IniSection& section, const RobotModel& robot) {
    return sameWord(section.name, "USARBot." + robot.class_name);
}

/// True for a line whose key is that of one of the entries.
bool isEntry(const std::string& line, const Entries& entries) {
    const std::string_view key = entryOf(line).first;
    return std::ranges::any_of(entries, [key](const auto& entry) { return sameWord(key, entry.first); });
}

/// Puts entries and items into the section of this name, in place of its lines with the same keys and of those that are
/// replaced. A file may have several sections of one name: such lines go from all of them, and the first gets the new.
template <class IsReplaced>
void setLines(std::vector<IniSection>& sections, const std::string& name, const Entries& entries,
              const std::vector<std::string>& items, const IsReplaced& is_replaced) {
    for (IniSection& same : sections)
        if (sameWord(same.name, name))
            std::erase_if(same.lines,
                          [&](const std::string& line) { return isEntry(line, entries) || is_replaced(line); });
    IniSection* const found = findSection(sections, name);
    IniSection& section = found ? *found : sections.emplace_back(IniSection{name, {}});
    while (!section.lines.empty() && trimmed(section.lines.back()).empty())
        section.lines.pop_back();
    for (const auto& [key, value] : entries)
        section.lines.push_back(key + "=" + value);
    section.lines.insert(section.lines.end(), items.begin(), items.end());
    section.lines.emplace_back();
}

/// True for a line of the server's file that ours replace.
bool isReplaced(const std::string& line, const RobotModel& robot, const Equipping& equipping) {
    const auto [key, value] = entryOf(line);
    const IniFields fields = fieldsOf(value);
    const std::string_view class_name = classIn(fieldIn(fields, "ItemClass"));
    if (isBare(robot) && isMovingPart(key, class_name))
        return true;
    if (class_name.empty())
        return false;
    const std::string_view name = fieldIn(fields, "ItemName");
    return std::ranges::any_of(equipping.classes(),
                               [&](const auto& known) { return sameWord(known.second, class_name); }) ||
           std::ranges::any_of(robot.sensors, [&, key = key](const SensorModel& sensor) {
               return sameWord(sensor.name, name) && equipping.isWritten(sensor, key);
           });
}

void equip(std::vector<IniSection>& sections, Equipping& equipping) {
    const auto nothing_else = [](const std::string&) { return false; };
    for (const auto& [type, class_name] : equipping.classes())
        if (const Entries entries = equipping.settingsFor(type); !entries.empty())
            setLines(sections, class_name, entries, {}, nothing_else);
    if (equipping.hasBatteries())
        setLines(sections, "USARSensor.Battery", {Equipping::batteryLife()}, {}, nothing_else);
    for (const RobotModel* robot : equipping.robots())
        setLines(sections, "USARBot." + robot->class_name, equipping.factsOf(), equipping.itemsOf(*robot),
                 [&equipping, robot](const std::string& line) { return isReplaced(line, *robot, equipping); });
}

/// Takes over the classes by which the server's file calls sensors with the names of ours. The section of the robot
/// itself counts before others, because another robot may use the name for something else.
SensorClasses learnedClasses(const std::vector<IniSection>& sections, const RobotCatalog& robots, Dialect dialect) {
    const SensorClasses stock = stockClasses(dialect);
    SensorClasses classes = stock;
    std::set<std::string> learned;
    const auto learn = [&](const RobotModel& robot, const std::string& line) {
        const auto [key, value] = entryOf(line);
        const IniFields fields = fieldsOf(value);
        const std::string_view class_name = classIn(fieldIn(fields, "ItemClass"));
        if (class_name.empty())
            return;
        for (const SensorModel& sensor : robot.sensors)
            if (sameWord(fieldIn(fields, "ItemName"), sensor.name) && sameWord(key, listKeyOf(sensor.type, dialect)) &&
                stock.contains(sensor.type) && mayHaveClass(sensor.type, class_name, stock) &&
                learned.insert(sensor.type).second)
                classes[sensor.type] = class_name;
    };
    for (const bool its_own : {true, false})
        for (const IniSection& section : sections)
            for (const RobotModel& robot : robots)
                if (isSectionOf(section, robot) == its_own)
                    for (const std::string& line : section.lines)
                        learn(robot, line);
    return classes;
}

std::vector<std::string> head(Dialect dialect) {
    const std::string where = dialect == Dialect::Udk ? "UDKGame/Config" : "System";
    return {
        "; The sensors of USAR Mission Control's robots for a USARSim server on " +
            std::string(dialect == Dialect::Udk ? "UDK." : "UT2004."),
        "; \"usar-mission server-files\" makes this file from the robot files. It says nothing about wheels, joints",
        "; and cameras' packages, so merge it into the " + std::string(serverFileName(dialect)) + " in " + where +
            " instead of replacing that;",
        "; real-server.md says how. Meters and radians; x forward, y right, z down.", ""};
}

} // namespace

ServerText writeServerFile(const RobotCatalog& robots, Dialect dialect) {
    std::vector<IniSection> sections{{{}, head(dialect)}};
    Equipping equipping(robots, dialect, stockClasses(dialect));
    equip(sections, equipping);
    return {textOf(sections, "\n"), equipping.takeLeftOut()};
}

Result<ServerText> mergeServerFile(std::string_view server_text, const RobotCatalog& robots, Dialect dialect) {
    std::vector<IniSection> sections = sectionsOf(server_text);
    const auto is_robot = [](const IniSection& one) { return lowerCase(one.name).starts_with("usarbot."); };
    if (std::ranges::none_of(sections, is_robot))
        return failure("there is no section of a robot in it", "",
                       "Give the server's own " + std::string(serverFileName(dialect)));
    for (const IniSection& section : sections)
        if (std::ranges::any_of(robots, [&section](const RobotModel& one) { return isSectionOf(section, one); }))
            for (const std::string& line : section.lines)
                if (const auto [key, value] = entryOf(line); sameWord(key, "bMountByUU") && sameWord(value, "true"))
                    return failure("its parts are measured in Unreal units, which cannot be mixed with meters",
                                   section.name, "Take USARSim's original file");
    Equipping equipping(robots, dialect, learnedClasses(sections, robots, dialect));
    equip(sections, equipping);
    const bool dos = server_text.find("\r\n") != std::string_view::npos;
    return ServerText{textOf(sections, dos ? "\r\n" : "\n"), equipping.takeLeftOut()};
}

} // namespace usar::sim
