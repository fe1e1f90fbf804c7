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

class MarksReader {
public:
    MarksReader(const std::filesystem::path& file, World& world) : file_(file), world_(world) {}

    Result<void> readScatter(sdf::Element& element);
    Result<void> readWater(sdf::Element& element);
    Result<void> readStartPose(sdf::Element& element);
    Result<void> readRfidTag(sdf::Element& element);
    Result<void> readVictim(sdf::Element& element);
    Result<void> readSound(sdf::Element& element);
    Result<void> readGas(sdf::Element& element);
    Result<void> readGpsReference(sdf::Element& element);
    tl::unexpected<Error> refuse(const std::string& what, const sdf::Element& element) const {
        return refusal(what, file_, element);
    }

private:
    const std::filesystem::path& file_;
    World& world_;
};

struct Mark {
    const char* name;
    Result<void> (MarksReader::*read)(sdf::Element&);
};

constexpr std::array marks{Mark{"usar:scatter", &MarksReader::readScatter},
                           Mark{"usar:water", &MarksReader::readWater},
                           Mark{"usar:start_pose", &MarksReader::readStartPose},
                           Mark{"usar:rfid_tag", &MarksReader::readRfidTag},
                           Mark{"usar:victim", &MarksReader::readVictim},
                           Mark{"usar:sound", &MarksReader::readSound},
                           Mark{"usar:gas", &MarksReader::readGas},
                           Mark{"usar:gps_reference", &MarksReader::readGpsReference}};

std::optional<Vec3> positionIn(const sdf::Element& element) {
    const auto numbers = numbersIn<3>(element);
    return numbers ? std::optional(Vec3(numbers->data())) : std::nullopt;
}

Result<void> MarksReader::readScatter(sdf::Element& element) {
    const auto uri = childText(element, "usar:uri");
    if (!uri || uri->empty())
        return refuse("a usar:scatter needs a usar:uri", element);
    auto plants = readPlantCsv(file_.parent_path() / *uri);
    if (!plants)
        return tl::unexpected(plants.error());
    world_.plants.insert(world_.plants.end(), plants->begin(), plants->end());
    return {};
}

Result<void> MarksReader::readWater(sdf::Element& element) {
    const auto number = [&](const std::string& name) {
        const auto text = childText(element, name);
        const auto value = text ? readNumber(*text) : std::nullopt;
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    const auto surface_z_m = number("usar:surface_z");
    const auto density_kg_m3 = number("usar:density");
    if (!surface_z_m || !density_kg_m3 || !(*density_kg_m3 > 0.0))
        return refuse("a usar:water needs a usar:surface_z and a usar:density above zero", element);
    if (world_.water)
        return refuse("there is a second usar:water, but one water covers the whole world", element);
    world_.water = Water{*surface_z_m, *density_kg_m3};
    return {};
}

Result<void> MarksReader::readStartPose(sdf::Element& element) {
    const auto name = attributeOf(element, "name");
    const auto numbers = numbersIn<6>(element);
    if (!name || !numbers)
        return refuse("a usar:start_pose needs a name and x y z roll pitch yaw", element);
    for (const NamedPose& other : world_.start_poses)
        if (other.name == *name)
            return refuse("there are two start poses named \"" + *name + "\"", element);
    const auto& [x, y, z, roll, pitch, yaw] = *numbers;
    world_.start_poses.push_back({*name, {{x, y, z}, roll, pitch, yaw}});
    return {};
}

Result<void> MarksReader::readRfidTag(sdf::Element& element) {
    const auto text = attributeOf(element, "id");
    const auto id = text ? readInteger(*text) : std::nullopt;
    const auto position_m = positionIn(element);
    if (!id || *id < 0 || *id > std::numeric_limits<int>::max() || !position_m)
        return refuse("a usar:rfid_tag needs a whole number from 0 up as its id, and x y z", element);
    const int tag_id = static_cast<int>(*id);
    for (const RfidTag& other : world_.rfid_tags)
        if (other.id == tag_id)
            return refuse("there are two tags with the id " + std::to_string(tag_id), element);
    world_.rfid_tags.push_back({tag_id, attributeOf(element, "memory").value_or(""), *position_m});
    return {};
}

Result<void> MarksReader::readVictim(sdf::Element& element) {
    const auto name = attributeOf(element, "name");
    if (!name)
        return refuse("a usar:victim needs a name", element);
    Victim victim{*name, attributeOf(element, "status").value_or(""), {}};
    for (sdf::ElementPtr part = element.GetFirstElement(); part; part = part->GetNextElement()) {
        const auto kind = victimPartKind(attributeOf(*part, "kind").value_or(""));
        const auto position_m = positionIn(*part);
        if (part->GetName() != "usar:part" || !kind || !position_m)
            return refuse(
                "the victim \"" + *name +
                    "\" is made of usar:part with a kind (Head, Arm, Hand, Chest, Pelvis, Leg, Foot) and x y z",
                element);
        victim.parts.push_back({*kind, *position_m});
    }
    if (victim.parts.empty())
        return refuse("the victim \"" + *name + "\" has no usar:part, so nobody could find it", element);
    world_.victims.push_back(std::move(victim));
    return {};
}

Result<void> MarksReader::readSound(sdf::Element& element) {
    const auto name = attributeOf(element, "name");
    const auto loudness_db = numberOf(element, "loudness");
    const auto position_m = positionIn(element);
    if (!name || !loudness_db || !position_m)
        return refuse("a usar:sound needs a name, a loudness in dB, and x y z", element);
    world_.sounds.push_back({*name, *loudness_db, *position_m});
    return {};
}

Result<void> MarksReader::readGas(sdf::Element& element) {
    const auto gas = attributeOf(element, "gas");
    const auto density = numberOf(element, "density");
    const auto position_m = positionIn(element);
    if (!gas || !density || *density < 0.0 || !position_m)
        return refuse("a usar:gas needs a gas such as CO2, a density from 0 up, and x y z", element);
    world_.gases.push_back({*gas, *density, *position_m});
    return {};
}

Result<void> MarksReader::readGpsReference(sdf::Element& element) {
    const auto latitude_deg = numberOf(element, "latitude");
    const auto longitude_deg = numberOf(element, "longitude");
    if (!latitude_deg || !longitude_deg || std::abs(*latitude_deg) > 90.0 || std::abs(*longitude_deg) > 180.0)
        return refuse("a usar:gps_reference needs a latitude within +-90 and a longitude within +-180 degrees",
                      element);
    world_.gps_reference = {*latitude_deg, *longitude_deg};
    return {};
}

} // namespace

Result<void> readMark(sdf::Element& element, const std::filesystem::path& file, World& world) {
    MarksReader reader(file, world);
    const std::string& name = element.GetName();
    if (!name.starts_with("usar:"))
        return {};
    const auto mark = std::find_if(marks.begin(), marks.end(), [&](const Mark& each) { return name == each.name; });
    if (mark == marks.end())
        return reader.refuse("there is no element named " + name + " in a world", element);
    return (reader.*mark->read)(element);
}

} // namespace usar::sim
