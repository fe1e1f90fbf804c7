#include "core/sim/servers/sensor_classes.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"

namespace usar::sim {

namespace {

using protocol::Dialect;

struct ClassRow {
    std::string_view type;
    std::string_view ut2004; ///< empty: none, or unknown
    std::string_view udk;
};

constexpr std::array class_rows{
    ClassRow{"Sonar", "USARBot.SonarSensor", "USARSensor.SonarSensor"},
    ClassRow{"RangeScanner", "USARBot.RangeScanner", "USARSensor.SICK"},
    ClassRow{"IRScanner", "USARBot.IRScanner", "USARSensor.IRScanner"},
    ClassRow{"IR", "USARBot.IRSensor", "USARSensor.IRSensor"},
    ClassRow{"Range", "USARBot.RangeSensor", ""},
    ClassRow{"INS", "USARBot.INS", "USARSensor.INS"},
    ClassRow{"GroundTruth", "USARBot.GroundTruth", "USARSensor.GroundTruth"},
    ClassRow{"Odometry", "USARBot.Odometry", "USARSensor.Odometry"},
    ClassRow{"Encoder", "", "USARSensor.Encoder"},
    ClassRow{"Tachometer", "", "USARSensor.Tachometer"},
    ClassRow{"Touch", "USARBot.Touch", "USARSensor.Touch"},
    ClassRow{"Accel", "", "USARSensor.Acceleration"},
    ClassRow{"AcceleroMeter", "", "USARSensor.AcceleroMeter"},
    ClassRow{"GPS", "USARBot.GPSSensor", "USARSensor.GPSSensor"},
    ClassRow{"RFID", "USARBot.RFIDSensor", ""},
    ClassRow{"VictSensor", "USARBot.VictSensor", ""},
    ClassRow{"Camera", "USARBot.RobotCamera", "USARSensor.USARCamera"},
};

struct SettingRow {
    std::string_view type;
    ServerSetting setting;
    bool udk_only = false;
};

constexpr std::array setting_rows{
    SettingRow{"Sonar", {"max_range", "MaxRange"}},
    SettingRow{"Sonar", {"min_range", "MinRange"}},
    SettingRow{"Sonar", {"beam_angle", "BeamAngle"}},
    SettingRow{"RangeScanner", {"max_range", "MaxRange"}},
    SettingRow{"RangeScanner", {"min_range", "MinRange"}},
    SettingRow{"RangeScanner", {"resolution", "Resolution"}},
    SettingRow{"RangeScanner", {"fov", "ScanFov"}},
    SettingRow{"IRScanner", {"max_range", "MaxRange"}},
    SettingRow{"IRScanner", {"min_range", "MinRange"}},
    SettingRow{"IRScanner", {"resolution", "Resolution"}},
    SettingRow{"IRScanner", {"fov", "ScanFov"}},
    SettingRow{"IR", {"max_range", "MaxRange"}},
    SettingRow{"IR", {"min_range", "MinRange"}},
    SettingRow{"Range", {"max_range", "MaxRange"}},
    SettingRow{"Range", {"min_range", "MinRange"}},
    SettingRow{"INS", {"precision", "Precision"}},
    SettingRow{"Encoder", {"resolution", "Resolution"}},
    SettingRow{"Touch", {"diameter", "Diameter"}},
    SettingRow{"VictSensor", {"max_range", "Distance"}},
    SettingRow{"VictSensor", {"horizontal_fov", "HorizontalFOV"}},
    SettingRow{"VictSensor", {"vertical_fov", "VerticalFOV"}},
    SettingRow{"Camera", {"fov", "CameraFOV"}, true},
    SettingRow{"Camera", {"min_fov", "CameraMinFOV"}, true},
    SettingRow{"Camera", {"max_fov", "CameraMaxFOV"}, true},
};

/// See protocol.md 2.4.
constexpr std::array<std::string_view, 10> ut2004_alone{"ATRVJr", "ERS",        "OmniP2AT",  "P2AT",  "P2DX",
                                                        "Sedan",  "StereoP2AT", "Submarine", "Talon", "TeleMax"};
constexpr std::array<std::string_view, 2> udk_alone{"KR60", "P3AT"};

} // namespace

SensorClasses stockClasses(Dialect dialect) {
    SensorClasses classes;
    for (const ClassRow& row : class_rows)
        if (const std::string_view name = dialect == Dialect::Udk ? row.udk : row.ut2004; !name.empty())
            classes.emplace(row.type, name);
    return classes;
}

std::vector<ServerSetting> settingsOf(std::string_view type, Dialect dialect) {
    std::vector<ServerSetting> settings;
    for (const SettingRow& row : setting_rows)
        if (sameWord(row.type, type) && (dialect == Dialect::Udk || !row.udk_only))
            settings.push_back(row.setting);
    return settings;
}

bool isOnServer(std::string_view class_name, Dialect dialect) {
    const auto is_it = [class_name](std::string_view one) { return sameWord(one, class_name); };
    return dialect == Dialect::Udk ? std::ranges::none_of(ut2004_alone, is_it) : std::ranges::none_of(udk_alone, is_it);
}

std::string_view listKeyOf(std::string_view type, Dialect dialect) {
    if (dialect == Dialect::Udk)
        return "AddParts";
    return sameWord(type, "Camera") ? "Cameras" : "Sensors";
}

std::string_view serverFileName(Dialect dialect) {
    return dialect == Dialect::Udk ? "DefaultUSAR.ini" : "USARBot.ini";
}

} // namespace usar::sim
