#include "core/sim/world/world_marks_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/base/numbers.h"
#include "core/sim/world/plant_csv.h"
#include "core/sim/world/sdf_fields.h"

namespace usar::sim {

namespace {

std::optional<Vec3> positionIn(const sdf::Element& element) {
    const auto numbers = numbersIn<3>(element);
    return numbers ? std::optional(Vec3(numbers->data())) : std::nullopt;
}

Result<void> readScatter(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto uri = childText(element, "usar:uri");
    if (!uri || uri->empty())
        return refusal("a usar:scatter needs a usar:uri", file, element);
    auto plants = readPlantCsv(file.parent_path() / *uri);
    if (!plants)
        return tl::unexpected(plants.error());
    world.plants.insert(world.plants.end(), plants->begin(), plants->end());
    return {};
}

Result<void> readWater(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto number = [&](const std::string& name) {
        const auto text = childText(element, name);
        const auto value = text ? readNumber(*text) : std::nullopt;
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    const auto surface_z_m = number("usar:surface_z");
    const auto density_kg_m3 = number("usar:density");
    if (!surface_z_m || !density_kg_m3 || !(*density_kg_m3 > 0.0))
        return refusal("a usar:water needs a usar:surface_z and a usar:density above zero", file, element);
    if (world.water)
        return refusal("there is a second usar:water, but one water covers the whole world", file, element);
    world.water = Water{*surface_z_m, *density_kg_m3};
    return {};
}

Result<void> readStartPose(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto name = attributeOf(element, "name");
    const auto numbers = numbersIn<6>(element);
    if (!name || !numbers)
        return refusal("a usar:start_pose needs a name and x y z roll pitch yaw", file, element);
    if (std::ranges::find(world.start_poses, *name, &NamedPose::name) != world.start_poses.end())
        return refusal("there are two start poses named \"" + *name + "\"", file, element);
    const auto& [x, y, z, roll, pitch, yaw] = *numbers;
    world.start_poses.push_back({*name, {{x, y, z}, roll, pitch, yaw}});
    return {};
}

Result<void> readRfidTag(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto text = attributeOf(element, "id");
    const auto id = text ? readInteger(*text) : std::nullopt;
    const auto position_m = positionIn(element);
    if (!id || *id < 0 || *id > std::numeric_limits<int>::max() || !position_m)
        return refusal("a usar:rfid_tag needs a whole number from 0 up as its id, and x y z", file, element);
    const int tag_id = static_cast<int>(*id);
    if (std::ranges::find(world.rfid_tags, tag_id, &RfidTag::id) != world.rfid_tags.end())
        return refusal("there are two tags with the id " + std::to_string(tag_id), file, element);
    world.rfid_tags.push_back({tag_id, attributeOf(element, "memory").value_or(""), *position_m});
    return {};
}

Result<void> readVictim(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto name = attributeOf(element, "name");
    if (!name)
        return refusal("a usar:victim needs a name", file, element);
    Victim victim{*name, attributeOf(element, "status").value_or(""), {}};
    for (sdf::ElementPtr part = element.GetFirstElement(); part; part = part->GetNextElement()) {
        const auto kind = victimPartKind(attributeOf(*part, "kind").value_or(""));
        const auto position_m = positionIn(*part);
        if (part->GetName() != "usar:part" || !kind || !position_m)
            return refusal(
                "the victim \"" + *name +
                    "\" is made of usar:part with a kind (Head, Arm, Hand, Chest, Pelvis, Leg, Foot) and x y z",
                file, element);
        victim.parts.push_back({*kind, *position_m});
    }
    if (victim.parts.empty())
        return refusal("the victim \"" + *name + "\" has no usar:part, so nobody can find it", file, element);
    world.victims.push_back(std::move(victim));
    return {};
}

Result<void> readSound(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto name = attributeOf(element, "name");
    const auto loudness_db = numberOf(element, "loudness");
    const auto position_m = positionIn(element);
    if (!name || !loudness_db || !position_m)
        return refusal("a usar:sound needs a name, a loudness in dB, and x y z", file, element);
    world.sounds.push_back({*name, *loudness_db, *position_m});
    return {};
}

Result<void> readGas(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto gas = attributeOf(element, "gas");
    const auto density = numberOf(element, "density");
    const auto position_m = positionIn(element);
    if (!gas || !density || *density < 0.0 || !position_m)
        return refusal("a usar:gas needs a gas such as CO2, a density from 0 up, and x y z", file, element);
    world.gases.push_back({*gas, *density, *position_m});
    return {};
}

Result<void> readGpsReference(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const auto latitude_deg = numberOf(element, "latitude");
    const auto longitude_deg = numberOf(element, "longitude");
    if (!latitude_deg || !longitude_deg || std::abs(*latitude_deg) > 90.0 || std::abs(*longitude_deg) > 180.0)
        return refusal("a usar:gps_reference needs a latitude within +-90 and a longitude within +-180 degrees", file,
                       element);
    world.gps_reference = {*latitude_deg, *longitude_deg};
    return {};
}

struct Mark {
    const char* name;
    Result<void> (*read)(sdf::Element&, const std::filesystem::path& file, World&);
};

constexpr std::array marks{Mark{"usar:scatter", readScatter},
                           Mark{"usar:water", readWater},
                           Mark{"usar:start_pose", readStartPose},
                           Mark{"usar:rfid_tag", readRfidTag},
                           Mark{"usar:victim", readVictim},
                           Mark{"usar:sound", readSound},
                           Mark{"usar:gas", readGas},
                           Mark{"usar:gps_reference", readGpsReference}};

} // namespace

Result<void> readMark(sdf::Element& element, const std::filesystem::path& file, World& world) {
    const std::string& name = element.GetName();
    if (!name.starts_with("usar:"))
        return {};
    const auto mark = std::ranges::find(marks, name, &Mark::name);
    if (mark == marks.end())
        return refusal("there is no element named " + name + " in a world", file, element);
    return mark->read(element, file, world);
}

} // namespace usar::sim
