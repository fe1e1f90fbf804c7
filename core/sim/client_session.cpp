#include "core/sim/client_session.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/segments.h"
#include "core/protocol/writer.h"
#include "core/sim/world_controller.h"

namespace usar::sim {

namespace {

constexpr std::size_t most_waiting = 65536;
constexpr std::size_t shown_bytes = 120;

std::string quoted(std::string_view line) {
    return "'" + std::string(line.substr(0, shown_bytes)) + (line.size() > shown_bytes ? "...'" : "'");
}

std::string quoted(const protocol::Command& command) {
    return quoted(protocol::write(command));
}

/// The segments of a line, which must outlive them.
protocol::Segments segmentsOf(std::string_view line) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(line, diagnostics);
    return segments;
}

/// The line of a command with this word that its reader refused, and has told the log why; empty for all others.
std::string_view refusedLine(const protocol::Command& command, std::string_view word) {
    const auto* const raw = std::get_if<protocol::RawCommand>(&command);
    return raw && sameWord(std::string_view(raw->line).substr(0, word.size()), word) ? raw->line : std::string_view();
}

/// Returns the class that a refused INIT names, or else its robot's name, or an empty text if it has neither.
std::string wantedBy(std::string_view init) {
    const protocol::Segments segments = segmentsOf(init);
    const std::string_view wanted_class = segments.value("ClassName");
    return std::string(wanted_class.empty() ? segments.value("Name") : wanted_class);
}

/// Sets the place of each camera in the game's window.
void place(protocol::ConfigurationInfo& cameras, const ClientSession::Host& host) {
    for (protocol::ConfiguredItem& camera : cameras.items) {
        const auto [left_px, top_px] = host.place_of(camera.name);
        for (protocol::Setting& setting : camera.settings)
            if (setting.key.starts_with("TextureOffset"))
                setting.value = std::to_string(setting.key.ends_with('X') ? left_px : top_px);
    }
}

} // namespace

ClientSession::ClientSession(const World& world, protocol::Dialect profile, bool digests)
    : world_(world)
    , profile_(profile)
    , digests_(digests) {
    send(protocol::GameInfo{"BotDeathMatch", world.name, 0});
}

void ClientSession::receive(std::string_view bytes, const Log& log) {
    const std::size_t overlong = splitter_.overlongCount();
    splitter_.feed(bytes, [&](std::string_view line) { take(line, log); });
    if (splitter_.overlongCount() > overlong)
        log("dropped a line that does not end");
}

void ClientSession::take(std::string_view line, const Log& log) {
    std::string garbled;
    if (wire_)
        line = garbled = wire_->garbled(line);
    Diagnostics diagnostics;
    protocol::Command command = protocol::readCommand(line, diagnostics, profile_);
    for (const Diagnostic& diagnostic : diagnostics)
        log(quoted(line) + ": " + diagnostic.message);
    if (std::holds_alternative<protocol::GetStartPoses>(command)) {
        startPoses();
    } else if (const auto* const wanted = std::get_if<protocol::Lockstep>(&command)) {
        if (wanted->on && mayNotStep())
            log("refused LOCKSTEP: it has held the others up twice already");
        lockstep_ = wanted->on && !mayNotStep();
        send(protocol::LockstepInfo{lockstep_});
    } else if (waiting_.size() >= most_waiting) {
        log("ignored " + quoted(line) + ": too many commands wait for the next tick");
    } else {
        steps_waiting_ += std::holds_alternative<protocol::Step>(command) ? 1 : 0;
        waiting_.push_back(std::move(command));
    }
}

void ClientSession::leaveLockstep() {
    lockstep_ = false;
    ++taken_out_;
    send(protocol::LockstepInfo{false});
}

std::string ClientSession::takeOutput(Seconds now) {
    if (!wire_)
        return std::exchange(output_, {});
    wire_->push(std::exchange(output_, {}), now, lockstep_, false); // Answers between two ticks.
    FaultyWire::Arrived arrived = wire_->take(now);
    ticks_heard_ += lockstep_ ? static_cast<std::size_t>(arrived.ticks) : 0;
    return std::move(arrived.bytes);
}

void ClientSession::obeyWaiting(const Host& host) {
    const bool in_step = lockstep_ && robot_ && heard_tick_;
    std::size_t steps = in_step ? stepsOwed() : 0; // STEPs still to be taken; the last one ends this tick's commands.
    while (!waiting_.empty() && !(in_step && steps == 0)) {
        const protocol::Command command = std::move(waiting_.front());
        waiting_.pop_front();
        if (std::holds_alternative<protocol::Step>(command)) {
            --steps_waiting_;
            ticks_heard_ -= ticks_heard_ > 0 ? 1 : 0;
            if (lockstep_ && !in_step)
                break;
            steps -= steps > 0 ? 1 : 0;
        } else if (wire_) {
            wire_->push(command, host.now);
        } else {
            obey(command, host);
        }
    }
    if (wire_)
        for (const protocol::Command& command : wire_->takeCommands(host.now))
            obey(command, host);
}

void ClientSession::orphan() {
    orphan_ = robot_ != nullptr;
    output_.clear();
    heard_tick_ = false;
}

std::string ClientSession::wantedName() const {
    for (const protocol::Command& command : waiting_)
        if (const auto* const init = std::get_if<protocol::Init>(&command))
            return init->robot_name.text();
    return {};
}

void ClientSession::takeOver(ClientSession& fresh) {
    orphan_ = heard_tick_ = false;
    lockstep_ = fresh.lockstep_;
    output_ = std::move(fresh.output_);
    splitter_ = std::move(fresh.splitter_);
    wire_.reset();
    new_ = true; // Its faults will be set again.
    std::erase_if(waiting_, [](const auto& one) { return std::holds_alternative<protocol::Step>(one); });
    bool init_seen = false;
    for (protocol::Command& command : fresh.waiting_)
        if (init_seen || !std::holds_alternative<protocol::Init>(command))
            waiting_.push_back(std::move(command));
        else
            init_seen = true;
    steps_waiting_ = fresh.steps_waiting_;
}

void ClientSession::setFaults(const std::vector<Fault>& active, const Random& random) {
    new_ = false;
    silenced_ = false;
    if (robot_)
        robot_->setFaults(active);
    const bool of_link = std::ranges::any_of(active, [](const Fault& fault) {
        return fault.kind == FaultKind::LinkDelay || fault.kind == FaultKind::LinkLoss ||
               fault.kind == FaultKind::LinkHalfOpen;
    });
    if (of_link && !wire_)
        wire_.emplace(random);
    if (wire_)
        wire_->setFaults(active);
}

void ClientSession::obey(const protocol::Command& command, const Host& host) {
    if (const auto* const wanted = std::get_if<protocol::Init>(&command))
        init(*wanted, host);
    else if (WorldController::isControl(command))
        control(command, host);
    else if (const std::string_view line = refusedLine(command, "INIT"); !line.empty())
        refuse("Init", wantedBy(line), {}, host);
    else if (controls_ && !refusedLine(command, "CONTROL").empty())
        return;
    else if (!robot_)
        host.log("ignored " + quoted(command) + ": there is no robot on this connection");
    else if (attachCamera(command, host) || setViewports(command, host) || tellCameras(command, host))
        return;
    else if (std::holds_alternative<protocol::RawCommand>(command) || !obeyForRobot(command, host.now))
        obeyUnknown(command, host);
    else if (const auto trouble = robot_->takeTrouble())
        refuse("MisPkg", trouble->package, trouble->sentence, host);
}

/// Tells the person at the server by the log, and the client by a RES where the dialect has one. UT2004 itself answers
/// neither INIT nor MISPKG.
void ClientSession::refuse(const std::string& type, const std::string& name, const std::string& sentence,
                           const Host& host) {
    if (!sentence.empty())
        host.log(sentence);
    if (!isUdk())
        send(protocol::Response{host.now, type, name, false}, host.now);
}

void ClientSession::control(const protocol::Command& command, const Host& host) {
    if (!controls_)
        return host.log("ignored " + quoted(command) + ": this connection is not a world controller's");
    if (const auto* const asked = std::get_if<protocol::GetObjectStates>(&command))
        return send(host.objectStates(*asked));
    if (const auto trouble = host.control(command))
        host.log("ignored " + quoted(command) + ": " + *trouble);
}

/// Chooses the camera that the image server shows to a viewer. Returns true for these two commands only.
bool ClientSession::attachCamera(const protocol::Command& command, const Host& host) {
    const auto* const attach = std::get_if<protocol::AttachCamera>(&command);
    if (!attach && !std::holds_alternative<protocol::DetachCamera>(command))
        return false;
    const bool ok = host.attach(command);
    if (!isUdk())
        window_set_ = protocol::Response{{}, "Camera", attach ? attach->camera_name : std::string(), ok};
    return true;
}

bool ClientSession::hasCamera(std::string_view name) const {
    return std::ranges::any_of(robot_->cameras(), [&](const SeenFrom& one) { return sameWord(one.camera, name); });
}

/// Chooses the cameras of this robot that the image server's window shows. Returns true for this command only, which
/// UDK does not know.
bool ClientSession::setViewports(const protocol::Command& command, const Host& host) {
    const auto* const wanted = std::get_if<protocol::SetViewports>(&command);
    if (!wanted || isUdk())
        return false;
    Viewports viewports = host.shown();
    viewports.four = wanted->layout == protocol::ViewLayout::Quad;
    protocol::Response answer{{}, "Viewports", "", true};
    answer.parts.push_back({"Config", viewports.four ? "QuadView" : "SingleView", true});
    for (std::size_t i = 0; i < (viewports.four ? wanted->views.size() : 1); ++i) {
        const std::string& view = wanted->views[i];
        if (view.empty())
            continue; // Stays unchanged.
        const bool off = sameWord(view, "Disabled") || sameWord(view, "None");
        const bool fine = off || hasCamera(view);
        if (off)
            viewports.cameras[i].reset();
        else if (fine)
            viewports.cameras[i] = CameraChoice{robot_name_, view};
        answer.parts.push_back({"Viewport" + std::to_string(i + 1), view, fine});
        answer.ok = answer.ok && fine;
    }
    host.show(viewports);
    window_set_ = std::move(answer);
    return true;
}

/// Answers the question about cameras in UDK's way, which tells where they are in the window. Returns true for this
/// question in this dialect only.
bool ClientSession::tellCameras(const protocol::Command& command, const Host& host) {
    const auto* const asked = std::get_if<protocol::GetConfiguration>(&command);
    if (!asked || !isUdk() || !sameWord(asked->type, "Camera"))
        return false;
    protocol::ConfigurationInfo cameras = robot_->configuration("Camera", asked->name);
    place(cameras, host);
    if (robot_->alive())
        send(cameras, host.now);
    return true;
}

void ClientSession::obeyUnknown(const protocol::Command& command, const Host& host) {
    const std::string line = protocol::write(command);
    const protocol::Segments segments = segmentsOf(line);
    // UT2004 answers every SET except that of a joint, at the tick; UDK obeys at once and never answers.
    const bool is_set = sameWord(segments.typeWord(), "SET") && !sameWord(segments.value("Type"), "Joint");
    if (is_set && isUdk() && robot_->alive())
        robot_->set(command);
    else if (is_set)
        set_asked_ = command;
    else
        host.log("ignored " + quoted(line) + ": not a command of this server, or not for this robot");
}

/// Returns false for commands that this robot does not understand. A robot with an empty battery accepts every command
/// and does nothing.
bool ClientSession::obeyForRobot(const protocol::Command& command, Seconds now) {
    if (const auto* const asked = std::get_if<protocol::GetGeometry>(&command))
        geometry_asked_ = *asked;
    else if (const auto* const configuration = std::get_if<protocol::GetConfiguration>(&command))
        configuration_asked_ = *configuration;
    else if (const auto* const trace = std::get_if<protocol::Trace>(&command); trace && !isUdk())
        pen_.obey(*trace);
    else
        return !robot_->alive() || robot_->obey(command);
    if (isUdk())
        answer(now); // Any number of queries per tick, each at once.
    return true;
}

void ClientSession::init(const protocol::Init& wanted, const Host& host) {
    if (initialized_)
        return host.log("ignored a second INIT: a connection can have only one robot");
    const auto [name, why] = host.nameOf(wanted);
    protocol::Init named = wanted;
    named.robot_name = protocol::Name::mended(name);
    robot_name_ = named.robot_name;
    const std::string_view bare_name = withoutPackage(wanted.class_name.text());
    controls_ = sameWord(bare_name, "WorldController");
    // A station has no sensors and does not move, so it sends no data.
    const bool is_station = protocol::isStation(bare_name);
    if (!controls_ && !is_station)
        robot_ = host.spawn(named, why);
    if (robot_ && isUdk()) // Sent unasked, a line for each.
        for (const SeenFrom& camera : robot_->cameras())
            tellCameras(protocol::GetConfiguration{"Camera", protocol::Name::mended(camera.camera)}, host);
    spawned_at_ = host.now;
    if (is_station)
        station_in_map_ = host.stationAt(named, why);
    initialized_ = robot_ || controls_ || station_in_map_; // After a refused INIT the client may try again.
    if (!initialized_)
        refuse("Init", named.class_name.text(), {}, host); // The log has the reason already.
}

void ClientSession::startPoses() {
    protocol::StartPoses poses;
    for (const NamedPose& start : world_.start_poses)
        poses.poses.push_back({start.name, start.pose_in_map});
    send(poses);
}

void ClientSession::report(Seconds now) {
    if (!robot_)
        return;
    answer(now);
    heard_tick_ = !orphan_;
    lines_.clear();
    robot_->measure(now, std::exchange(first_tick_, false), lines_);
    for (const protocol::InfoMessage& line : lines_)
        send(line, now);
    if (wire_)
        wire_->push(std::exchange(output_, {}), now, lockstep_, true);
}

std::optional<TraceMark> ClientSession::takeMark(Seconds now) {
    if (!robot_ || !pen_.on())
        return std::nullopt;
    const Vec3 at_m = robot_->figures().base_in_map.position_m;
    const auto color = pen_.markAt(now, at_m);
    return color ? std::optional(TraceMark{robot_name_, *color, at_m}) : std::nullopt;
}

void ClientSession::answer(Seconds now) {
    if (const auto asked = std::exchange(geometry_asked_, {}); asked && robot_->alive())
        send(robot_->geometry(asked->type, asked->name), now);
    if (const auto asked = std::exchange(configuration_asked_, {}); asked && robot_->alive())
        send(robot_->configuration(asked->type, asked->name), now);
    if (auto result = std::exchange(window_set_, {}); result && robot_->alive()) {
        result->time = now;
        send(*result, now);
    }
    if (const auto asked = std::exchange(set_asked_, {}); asked && robot_->alive())
        send(resultOf(*asked, now));
}

protocol::Response ClientSession::resultOf(const protocol::Command& asked, Seconds now) {
    std::optional<protocol::Response> result = robot_->set(asked);
    if (!result) {
        const std::string line = protocol::write(asked);
        const protocol::Segments segments = segmentsOf(line);
        result =
            protocol::Response{{}, std::string(segments.value("Type")), std::string(segments.value("Name")), false};
    }
    result->time = now;
    return *result;
}

void ClientSession::send(const protocol::InfoMessage& message, Seconds now) {
    const std::size_t before = output_.size();
    if (isUdk()) {
        const RobotModel* const model = robot_ ? &robot_->body().model() : nullptr;
        const auto steers = [model](std::string_view largest_angle) {
            return model && model->drive.kind == "ackermann" &&
                   numberOr(model->drive.numbers, largest_angle, 0.0) > 0.0;
        };
        const protocol::UdkRobot robot{model ? model->class_name : std::string(), steers("max_front_steer"),
                                       steers("max_rear_steer")};
        protocol::writeUdk(message, now, robot, output_);
    } else {
        protocol::write(message, output_);
        output_ += "\r\n";
    }
    for (std::size_t i = before; digests_ && i < output_.size(); ++i)
        said_digest_ = (said_digest_ ^ static_cast<unsigned char>(output_[i])) * 1099511628211ull;
    if (orphan_)
        output_.clear(); // No client is there to read it.
}

} // namespace usar::sim
