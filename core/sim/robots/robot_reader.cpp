#include "core/sim/robots/robot_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include <sdf/sdf.hh>

#include "core/base/numbers.h"
#include "core/protocol/vehicle_words.h"
#include "core/sim/world/sdf_fields.h"

namespace usar::sim {

namespace {

constexpr const char* fix = "Fix the file; resources/robots/README.md describes robot files";
constexpr std::string_view prefix = "usar:";

std::vector<const sdf::Joint*> jointsOf(const sdf::Model& model) {
    std::vector<const sdf::Joint*> joints;
    for (uint64_t i = 0; i < model.JointCount(); ++i)
        joints.push_back(model.JointByIndex(i));
    return joints;
}

double numberIn(const sdf::Element& parent, const std::string& name, double otherwise) {
    return readNumber(textOf(parent, name)).value_or(otherwise);
}

std::optional<Vec3> vectorIn(const sdf::Element& parent, const std::string& name) {
    Vec3 vector = Vec3::Zero();
    return readNumbers(textOf(parent, name), vector.data(), 3) ? std::optional(vector) : std::nullopt;
}

/// Texts of all children with this name.
std::vector<std::string> textsOf(const sdf::Element& parent, const std::string& name) {
    std::vector<std::string> texts;
    for (sdf::ElementPtr child = parent.GetFirstElement(); child; child = child->GetNextElement())
        if (child->GetName() == name && child->GetValue())
            texts.push_back(child->GetValue()->GetAsString());
    return texts;
}

/// Reads our own children of an element by their names: numbers into `numbers`, and other texts into `words` if it is
/// given.
void readSettings(const sdf::Element& parent, Numbers& numbers,
                  std::map<std::string, std::string, std::less<>>* words) {
    for (sdf::ElementPtr child = parent.GetFirstElement(); child; child = child->GetNextElement()) {
        if (!child->GetName().starts_with(prefix) || !child->GetValue())
            continue;
        const std::string key = child->GetName().substr(prefix.size());
        const std::string text = child->GetValue()->GetAsString();
        if (const auto number = readNumber(text))
            numbers[key] = *number;
        else if (words)
            (*words)[key] = text;
    }
}

/// Builds a model from the elements of one file.
class RobotReading {
public:
    RobotReading(const std::filesystem::path& file, const sdf::Model& source)
        : file_(file)
        , source_(source)
        , joints_(jointsOf(source)) {}

    Result<RobotModel> read() {
        for (const auto step : {&RobotReading::readFacts, &RobotReading::readBase, &RobotReading::hangLinks,
                                &RobotReading::readSensors, &RobotReading::check})
            if (auto done = (this->*step)(); !done)
                return tl::unexpected(done.error());
        return std::move(model_);
    }

private:
    Result<void> readFacts() {
        model_.class_name = source_.Name();
        const sdf::ElementPtr facts = source_.Element()->FindElement("usar:robot");
        if (!facts)
            return refuse("the model has no usar:robot");
        model_.kind = protocol::vehicleKindOf(textOf(*facts, "usar:kind"));
        if (model_.kind == protocol::VehicleKind::Unknown)
            return refuse("usar:kind is GroundVehicle, AerialVehicle, NauticVehicle, LeggedRobot or StaticPlatform");
        model_.aliases = textsOf(*facts, "usar:alias");
        model_.steering = textOf(*facts, "usar:steering");
        const auto dimensions_m = vectorIn(*facts, "usar:dimensions");
        if (model_.steering.empty() || !dimensions_m)
            return refuse("usar:robot needs a usar:steering, and usar:dimensions of length, width and height");
        model_.dimensions_m = *dimensions_m;
        model_.center_of_gravity_m = vectorIn(*facts, "usar:center_of_gravity").value_or(Vec3::Zero());
        model_.battery_life = Seconds{numberIn(*facts, "usar:battery", model_.battery_life.count())};
        if (auto done = readDrive(*facts); !done)
            return done;
        if (auto done = readPackages(*facts); !done)
            return done;
        return readGrippers(*facts);
    }

    Result<void> readBase() {
        for (uint64_t i = 0; i < source_.LinkCount(); ++i) {
            const sdf::Link& link = *source_.LinkByIndex(i);
            const bool hangs = std::ranges::any_of(
                joints_, [&](const sdf::Joint* joint) { return joint->ChildLinkName() == link.Name(); });
            if (hangs)
                continue;
            if (base_)
                return refuse("neither \"" + base_->Name() + "\" nor \"" + link.Name() + "\" hangs on a joint");
            base_ = &link;
        }
        if (!base_)
            return refuse("every link hangs on another: there is no base");
        if (base_->RawPose() != ignition::math::Pose3d::Zero)
            return refuse("the base \"" + base_->Name() + "\" must stand at the model's origin");
        auto body = bodyOf(*base_);
        if (!body)
            return tl::unexpected(body.error());
        model_.body.base = std::move(*body);
        model_.center_of_mass_in_base_m = toVec3(base_->Inertial().Pose().Pos());
        return {};
    }

    /// Adds parents before their children, whatever the order in the file.
    Result<void> hangLinks() {
        std::vector<std::pair<std::string, int>> open{{base_->Name(), -1}};
        for (std::size_t next = 0; next < open.size(); ++next) {
            const auto [parent_name, parent] = open[next];
            for (const sdf::Joint* joint : joints_) {
                if (joint->ParentLinkName() != parent_name)
                    continue;
                if (auto done = hangLink(*joint, parent); !done)
                    return done;
                open.emplace_back(joint->ChildLinkName(), static_cast<int>(model_.links.size()) - 1);
            }
        }
        if (model_.links.size() != joints_.size())
            return refuse("a joint has no way to the base \"" + base_->Name() + "\"");
        return {};
    }

    Result<void> hangLink(const sdf::Joint& joint, int parent) {
        const sdf::Link* const child = linkNamed(joint.ChildLinkName());
        const sdf::Link* const holder = linkNamed(joint.ParentLinkName());
        const sdf::JointAxis* const axis = joint.Axis();
        const bool turns = joint.Type() == sdf::JointType::REVOLUTE || joint.Type() == sdf::JointType::CONTINUOUS;
        if (!child || !holder || !axis || (!turns && joint.Type() != sdf::JointType::PRISMATIC))
            return refuse("the joint \"" + joint.Name() +
                          "\" must be revolute, continuous or prismatic, between two links");
        auto body = bodyOf(*child);
        if (!body)
            return tl::unexpected(body.error());
        const Vec3 center_m = toVec3(child->Inertial().Pose().Pos());
        const bool limited = joint.Type() != sdf::JointType::CONTINUOUS && std::abs(axis->Lower()) < 1e9;
        model_.body.links.push_back({.body = *std::move(body),
                                     .parent = parent,
                                     .link_in_parent = inverse(bodyInModel(*holder)) * bodyInModel(*child),
                                     .pivot_in_link_m = toVec3(joint.RawPose().Pos()) - center_m,
                                     .axis_in_link = toPose(joint.RawPose()).rotation() * toVec3(axis->Xyz()),
                                     .kind = turns ? JointKind::Revolute : JointKind::Prismatic,
                                     .lower = limited ? axis->Lower() : 1.0,
                                     .upper = limited ? axis->Upper() : -1.0,
                                     .damping = axis->Damping()});
        model_.links.push_back({child->Name(), joint.Name(), center_m, axis->Effort(), axis->MaxVelocity()});
        return {};
    }

    Result<BodyDescription> bodyOf(const sdf::Link& link) const {
        const ignition::math::MassMatrix3d& mass = link.Inertial().MassMatrix();
        if (!(mass.Mass() > 0.0) || mass.OffDiagonalMoments().Length() > 1e-9 ||
            link.Inertial().Pose().Rot() != ignition::math::Quaterniond::Identity)
            return refuse("the link \"" + link.Name() +
                          "\" needs a mass above zero and moments about its own axes only");
        BodyDescription body{.mass_kg = mass.Mass(), .inertia_kg_m2 = toVec3(mass.DiagonalMoments())};
        for (uint64_t i = 0; i < link.CollisionCount(); ++i) {
            auto part = partOf(*link.CollisionByIndex(i), toVec3(link.Inertial().Pose().Pos()));
            if (!part)
                return tl::unexpected(part.error());
            body.parts.push_back(std::move(*part));
        }
        const sdf::Element& ours = *link.Element();
        body.friction = numberIn(ours, "usar:friction", body.friction);
        body.restitution = numberIn(ours, "usar:restitution", body.restitution);
        body.rolling_friction_m = numberIn(ours, "usar:rolling_friction", body.rolling_friction_m);
        return body;
    }

    Result<BodyPart> partOf(const sdf::Collision& collision, const Vec3& center_of_mass_m) const {
        Pose part_in_body = toPose(collision.RawPose());
        part_in_body.position_m -= center_of_mass_m;
        const auto shape = shapeIn(*collision.Geom());
        if (!shape)
            return refuse("the collision \"" + collision.Name() + "\" is neither box, cylinder, capsule nor sphere");
        return BodyPart{shape->shape, part_in_body};
    }

    Result<void> readSensors() {
        for (int index = -1; index < static_cast<int>(model_.links.size()); ++index) {
            const std::string name = index < 0 ? base_->Name() : model_.links[static_cast<std::size_t>(index)].name;
            const sdf::Link& link = *linkNamed(name);
            for (uint64_t i = 0; i < link.SensorCount(); ++i)
                if (auto done = readSensor(*link.SensorByIndex(i), index, name); !done)
                    return done;
        }
        return {};
    }

    Result<void> readSensor(const sdf::Sensor& sensor, int link, const std::string& link_name) {
        SensorModel model;
        model.type = attributeOf(*sensor.Element(), "usar:type").value_or("");
        model.name = sensor.Name();
        model.link = link;
        model.sensor_in_link = toPose(sensor.RawPose());
        if (model.type.empty())
            return refuse("the sensor \"" + model.name + "\" has no usar:type");
        readSettings(*sensor.Element(), model.numbers, &model.words);
        const auto mount = model.words.find("mount");
        model.mount = mount != model.words.end() ? mount->second : link < 0 ? "HARD" : link_name;
        model_.sensors.push_back(std::move(model));
        return {};
    }

    Result<void> readDrive(const sdf::Element& facts) {
        const sdf::ElementConstPtr drive = facts.FindElement("usar:drive");
        if (!drive)
            return refuse("usar:robot has no usar:drive");
        model_.drive.kind = attributeOf(*drive, "kind").value_or("");
        model_.drive.joints = textsOf(*drive, "usar:joint");
        readSettings(*drive, model_.drive.numbers, nullptr);
        return {};
    }

    Result<void> readPackages(const sdf::Element& facts) {
        for (sdf::ElementPtr child = facts.GetFirstElement(); child; child = child->GetNextElement()) {
            if (child->GetName() != "usar:package")
                continue;
            PackageModel package{attributeOf(*child, "name").value_or(""), textsOf(*child, "usar:joint"),
                                 vectorIn(*child, "usar:tip")};
            if (package.name.empty() || package.joints.empty())
                return refuse("a usar:package needs a name and at least one usar:joint");
            model_.packages.push_back(std::move(package));
        }
        return {};
    }

    Result<void> readGrippers(const sdf::Element& facts) {
        for (sdf::ElementPtr child = facts.GetFirstElement(); child; child = child->GetNextElement()) {
            if (child->GetName() != "usar:gripper")
                continue;
            GripperModel gripper{attributeOf(*child, "name").value_or(""), attributeOf(*child, "package").value_or(""),
                                 textsOf(*child, "usar:joint"), vectorIn(*child, "usar:tip").value_or(Vec3::Zero())};
            if (gripper.name.empty() || gripper.joints.empty())
                return refuse("a usar:gripper needs a name and at least one usar:joint");
            model_.grippers.push_back(std::move(gripper));
        }
        return {};
    }

    Result<void> check() {
        std::set<std::string> names;
        for (const SensorModel& sensor : model_.sensors)
            if (!names.insert(sensor.type + " " + sensor.name).second)
                return refuse("there are two sensors \"" + sensor.name + "\" of type " + sensor.type);
        std::vector<std::string> wanted = model_.drive.joints;
        for (const PackageModel& package : model_.packages)
            wanted.insert(wanted.end(), package.joints.begin(), package.joints.end());
        for (const GripperModel& gripper : model_.grippers) {
            wanted.insert(wanted.end(), gripper.joints.begin(), gripper.joints.end());
            if (!gripper.package.empty() && std::ranges::none_of(model_.packages, [&](const PackageModel& package) {
                    return package.name == gripper.package;
                }))
                return refuse("there is no package \"" + gripper.package + "\" for the gripper " + gripper.name);
        }
        for (const std::string& joint : wanted)
            if (!model_.linkOnJoint(joint))
                return refuse("there is no joint \"" + joint + "\"");
        return {};
    }

    tl::unexpected<Error> refuse(const std::string& what) const { return failure(what, file_.string(), fix); }
    const sdf::Link* linkNamed(const std::string& name) const { return source_.LinkByName(name); }

    /// Pose in the model's frame of the link's center of mass, with the link's axes.
    static Pose bodyInModel(const sdf::Link& link) {
        return toPose(link.RawPose()) * Pose{.position_m = toVec3(link.Inertial().Pose().Pos())};
    }

    std::filesystem::path file_;
    const sdf::Model& source_;
    std::vector<const sdf::Joint*> joints_;
    const sdf::Link* base_ = nullptr;
    RobotModel model_;
};

Result<RobotModel> readFile(const std::filesystem::path& file) {
    const auto root = loadSdf(file);
    if (!root)
        return tl::unexpected(root.error());
    if (!root->Model())
        return failure("there is no model in it", file.string(), fix);
    return RobotReading(file, *root->Model()).read();
}

/// A robot, and the state of its file when it was read.
struct ReadRobot {
    std::filesystem::file_time_type written;
    std::uintmax_t bytes;
    RobotModel robot;
};

} // namespace

/// Keeps the robots it has read, because every start of a simulator needs all of them.
Result<RobotModel> readRobot(const std::filesystem::path& file) {
    static std::mutex one_at_a_time;
    static std::map<std::filesystem::path, ReadRobot> known;
    std::error_code trouble;
    const std::filesystem::path path = std::filesystem::absolute(file, trouble);
    const auto written = std::filesystem::last_write_time(path, trouble);
    const std::uintmax_t bytes = trouble ? 0 : std::filesystem::file_size(path, trouble);
    if (trouble)
        return readFile(file); // Its error says what is wrong.
    const std::scoped_lock lock(one_at_a_time);
    const auto found = known.find(path);
    if (found != known.end() && found->second.written == written && found->second.bytes == bytes)
        return found->second.robot;
    auto robot = readFile(file);
    if (robot)
        known.insert_or_assign(path, ReadRobot{written, bytes, *robot});
    return robot;
}

RobotsRead readRobots(const std::filesystem::path& folder) {
    RobotsRead read;
    std::error_code trouble;
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder, trouble))
        if (entry.path().extension() == ".sdf")
            files.insert(entry.path());
    if (trouble)
        read.refused.push_back({"this folder of robots cannot be read", folder.string(), "Check its name"});
    for (const std::filesystem::path& file : files) {
        auto robot = readRobot(file);
        if (!robot)
            read.refused.push_back(robot.error());
        else if (findRobot(read.robots, robot->class_name))
            read.refused.push_back(
                {"there is a " + robot->class_name + " already", file.string(), "Give it another class name"});
        else
            read.robots.push_back(std::move(*robot));
    }
    return read;
}

} // namespace usar::sim
