#include "core/protocol/info/configurations.h"

#include <algorithm>
#include <string_view>

#include "core/protocol/segments.h"
#include "core/protocol/vehicle_words.h"

namespace usar::protocol {

namespace {

const Setting* settingOf(const ConfiguredItem& item, std::string_view key) {
    const auto found =
        std::ranges::find_if(item.settings, [key](const Setting& one) { return sameWord(one.key, key); });
    return found == item.settings.end() ? nullptr : &*found;
}

std::optional<double> numberOf(const ConfiguredItem& item, std::string_view key, std::string_view other_key = {}) {
    const Setting* setting = settingOf(item, key);
    if (!setting && !other_key.empty())
        setting = settingOf(item, other_key);
    return setting ? setting->number : std::nullopt;
}

std::optional<bool> flagOf(const ConfiguredItem& item, std::string_view key, std::string_view other_key) {
    const Setting* setting = settingOf(item, key);
    if (!setting)
        setting = settingOf(item, other_key);
    return setting ? std::optional(sameWord(setting->value, "True")) : std::nullopt;
}

std::optional<int> whole(const std::optional<double>& number) {
    constexpr double most = 1e6;
    return number && *number >= 0 && *number <= most ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

std::optional<int> pixelsOf(const ConfiguredItem& item, std::string_view key) {
    return whole(numberOf(item, key));
}

bool isPackage(const ConfigurationInfo& info) {
    return sameWord(info.type, "MisPkg") || sameWord(info.type, "Actuator");
}
bool isCamera(const ConfigurationInfo& info) {
    return sameWord(info.type, "Camera");
}
bool isRobot(const ConfigurationInfo& info) {
    return info.type.empty() || vehicleKindOf(info.type) != VehicleKind::Unknown;
}
bool hasOpcodes(const ConfiguredItem& item) {
    return settingOf(item, "Opcode") != nullptr;
}
bool isEffecter(const ConfigurationInfo& info) {
    return std::ranges::any_of(info.items, hasOpcodes);
}

/// Takes over one setting of a link, under the key of either dialect.
void take(LinkConfiguration& link, const Setting& setting) {
    if (sameWord(setting.key, "JointType"))
        link.prismatic = sameWord(setting.value, "Prismatic");
    else if (sameWord(setting.key, "MaxSpeed"))
        link.speed_limit = setting.number;
    else if (sameWord(setting.key, "MaxTorque"))
        link.torque_limit = setting.number;
    else if (sameWord(setting.key, "MinRange") || sameWord(setting.key, "MinValue"))
        link.smallest = setting.number;
    else if (sameWord(setting.key, "MaxRange") || sameWord(setting.key, "MaxValue"))
        link.largest = setting.number;
}

void dropLimitsThatAreNone(LinkConfiguration& link) {
    if (link.smallest && link.largest && *link.smallest > *link.largest)
        link.smallest = link.largest = std::nullopt;
}

CameraConfiguration cameraOf(const ConfiguredItem& item) {
    const bool degrees_on_wire = settingOf(item, "TextureResolutionX") != nullptr;
    const auto angle = [&](std::string_view key) {
        const std::optional<double> value = numberOf(item, key);
        return value && degrees_on_wire ? std::optional(radians(*value)) : value;
    };
    return {item.name,
            angle("CameraFov"),
            angle("CameraDefFov"),
            angle("CameraMinFov"),
            angle("CameraMaxFov"),
            pixelsOf(item, "TextureOffsetX"),
            pixelsOf(item, "TextureOffsetY"),
            pixelsOf(item, "TextureResolutionX"),
            pixelsOf(item, "TextureResolutionY")};
}

} // namespace

std::optional<double> ConfiguredItem::number(const std::string& key) const {
    const auto found =
        std::ranges::find_if(settings, [&](const Setting& one) { return one.number && sameWord(one.key, key); });
    return found == settings.end() ? std::nullopt : found->number;
}

std::optional<RobotConfiguration> robotConfigurationOf(const ConfigurationInfo& info) {
    if (!isRobot(info) || info.items.size() != 1)
        return std::nullopt;
    const ConfiguredItem& item = info.items.front();
    const Setting* const steering = settingOf(item, "SteeringType");
    return RobotConfiguration{item.name,
                              vehicleKindOf(info.type),
                              steering ? steering->value : std::string(),
                              numberOf(item, "Mass"),
                              numberOf(item, "MaxSpeed"),
                              numberOf(item, "MaxTorque"),
                              numberOf(item, "MaxFrontSteer"),
                              numberOf(item, "MaxRearSteer"),
                              numberOf(item, "MaxLinearVelocity"),
                              numberOf(item, "MaxLateralVelocity"),
                              numberOf(item, "MaxAltitudeVelocity"),
                              numberOf(item, "MaxRotationalVelocity")};
}

std::vector<PackageConfiguration> packageConfigurationsOf(const ConfigurationInfo& info) {
    std::vector<PackageConfiguration> packages;
    if (!isPackage(info))
        return packages;
    for (const ConfiguredItem& item : info.items) {
        PackageConfiguration& package = packages.emplace_back(PackageConfiguration{item.name, {}});
        for (const Setting& setting : item.settings) {
            if (sameWord(setting.key, "Link"))
                package.links.emplace_back().link = whole(setting.number).value_or(0);
            else if (!package.links.empty())
                take(package.links.back(), setting);
        }
        std::ranges::for_each(package.links, dropLimitsThatAreNone);
    }
    return packages;
}

std::vector<CameraConfiguration> cameraConfigurationsOf(const ConfigurationInfo& info) {
    std::vector<CameraConfiguration> cameras;
    if (isCamera(info))
        std::ranges::transform(info.items, std::back_inserter(cameras), cameraOf);
    return cameras;
}

std::vector<EffecterConfiguration> effecterConfigurationsOf(const ConfigurationInfo& info) {
    std::vector<EffecterConfiguration> effecters;
    for (const ConfiguredItem& item : info.items) {
        if (!hasOpcodes(item))
            continue;
        EffecterConfiguration& effecter = effecters.emplace_back(EffecterConfiguration{info.type, item.name, {}});
        for (const Setting& setting : item.settings) {
            if (sameWord(setting.key, "Opcode"))
                effecter.opcodes.emplace_back().opcode = setting.value;
            else if (!effecter.opcodes.empty() && sameWord(setting.key, "MinVal"))
                effecter.opcodes.back().smallest = setting.number;
            else if (!effecter.opcodes.empty() && sameWord(setting.key, "MaxVal"))
                effecter.opcodes.back().largest = setting.number;
        }
    }
    return effecters;
}

std::vector<SensorConfiguration> sensorConfigurationsOf(const ConfigurationInfo& info) {
    std::vector<SensorConfiguration> sensors;
    if (isRobot(info) || isPackage(info) || isCamera(info) || isEffecter(info))
        return sensors;
    for (const ConfiguredItem& item : info.items) {
        const std::optional<double> interval_s = numberOf(item, "ScanInterval");
        sensors.push_back({info.type, item.name, numberOf(item, "MaxRange"), numberOf(item, "MinRange"),
                           numberOf(item, "BeamAngle"), numberOf(item, "Resolution", "EncoderResolution"),
                           numberOf(item, "Fov", "HorizontalFOV"), numberOf(item, "VerticalFOV"),
                           interval_s ? std::optional(Seconds(*interval_s)) : std::nullopt,
                           flagOf(item, "Paning", "Panning"), flagOf(item, "Tilting", "Tilting")});
    }
    return sensors;
}

} // namespace usar::protocol
