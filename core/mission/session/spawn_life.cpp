#include "core/mission/session/spawn_life.h"

#include <utility>

#include "core/base/result.h"
#include "core/base/text.h"

namespace usar::mission {

namespace {

/// Returns the INIT command for a request; fails if a protocol line cannot contain its names.
Result<protocol::Init> initOf(const SpawnRequest& request) {
    const auto class_name = protocol::Token::make(request.class_name);
    const auto robot_name = protocol::Name::make(request.robot_name);
    if (!class_name || !robot_name)
        return tl::unexpected(class_name ? robot_name.error() : class_name.error());
    return protocol::Init{*class_name, *robot_name, request.start_in_map};
}

} // namespace

std::optional<protocol::Init> SpawnLife::standingInit() const {
    const auto init = initOf(request_);
    if (!init || (state_ != SpawnState::Asked && state_ != SpawnState::Done))
        return std::nullopt;
    return *init;
}

void SpawnLife::ask(const SpawnRequest& request, bool connected, Seconds wall) {
    if (!connected) {
        notices_.trouble(Severity::Warning, Topic::NoConnection,
                         "There is no connection to spawn " + request.robot_name + " on. Connect first.");
    } else if (state_ == SpawnState::None) {
        init(request, wall);
    } else if (state_ == SpawnState::Failed) {
        waiting_ = request;
        owner_.reconnect();
    } else {
        notices_.say(Severity::Warning, Topic::SecondRobot,
                     robotName() + (done() ? " is" : " is being") +
                         " spawned here already, and a connection carries one robot. Reconnect to spawn another.");
    }
}

void SpawnLife::init(const SpawnRequest& request, Seconds wall) {
    request_ = request;
    const auto init = initOf(request);
    if (!init)
        return fail(SpawnState::None, init.error().text());
    set(SpawnState::Asked);
    asked_at_ = wall;
    owner_.sendInit(*init);
    if (protocol::isStation(request.class_name)) {
        set(SpawnState::Done);
        owner_.robotCame(request.robot_name);
    }
}

void SpawnLife::beginConnection() {
    set(SpawnState::None);
    spawned_at_ = Seconds{0.0};
}

void SpawnLife::connected(Seconds wall) {
    notices_.over(Topic::NoConnection);
    notices_.over(Topic::Link, "The connection is back. Spawn " + robotName() + " again to continue.");
    if (waiting_)
        init(*std::exchange(waiting_, std::nullopt), wall);
}

void SpawnLife::heard() {
    // Data of a robot that was not requested comes from a proxy that shares connections; it belongs to no spawn of
    // ours.
    if (state_ != SpawnState::Asked && state_ != SpawnState::Failed)
        return;
    set(SpawnState::Done);
    notices_.over(Topic::NoRobot);
    notices_.over(Topic::Spawn, robotName() + " has spawned after all.");
    owner_.robotCame(robotName());
}

void SpawnLife::passed(Seconds now) {
    if (done() && spawned_at_.count() == 0.0)
        spawned_at_ = now; // Still zero if a sensor message comes before the first STA.
}

void SpawnLife::look(Seconds wall, Seconds limit) {
    if (state_ != SpawnState::Asked || !asked_at_ || wall - *asked_at_ <= limit)
        return;
    fail(SpawnState::Failed, "Nothing from " + robotName() + " for " + spanText(limit) +
                                 " after INIT. Does the server know " + request_.class_name +
                                 ", is the start pose free and above the ground, and is the simulation running? "
                                 "Spawn again to try once more.");
}

void SpawnLife::answered(const protocol::Response& answer) {
    if (state_ != SpawnState::Asked || answer.ok || !sameWord(answer.type, "Init"))
        return;
    fail(SpawnState::Failed, "The server refused to spawn " + robotName() + ". Does it know " + request_.class_name +
                                 ", and is the start pose free and above the ground? Its log says what was wrong. "
                                 "Choose another start pose, and spawn again.");
}

SpawnState SpawnLife::loseConnection() {
    const SpawnState lost = state_;
    set(waiting_ ? SpawnState::Asked : SpawnState::None);
    return lost;
}

void SpawnLife::reportLoss(SpawnState lost) {
    if (lost == SpawnState::Done)
        notices_.trouble(Severity::Warning, Topic::Link,
                         "The connection is lost, and " + robotName() +
                             " with it. What was scanned is kept; spawn the robot again when connected.");
}

void SpawnLife::reportRefusal(SpawnState lost) {
    if (lost == SpawnState::Asked && !waiting_)
        fail(SpawnState::None, "The server closed the connection before " + robotName() +
                                   " sent anything. Is the start pose free, and is the server full? Spawn again "
                                   "when connected.");
}

void SpawnLife::sawInit(const protocol::Init& init) {
    request_.class_name = init.class_name;
    request_.robot_name = init.robot_name;
    set(SpawnState::Asked);
}

void SpawnLife::describe(SessionFigures& figures) const {
    figures.spawn = state_;
    figures.spawned = done();
    figures.spawned_at = spawned_at_;
}

void SpawnLife::set(SpawnState now) {
    state_ = now;
    owner_.spawnChanged();
}

void SpawnLife::fail(SpawnState now, const std::string& reason) {
    set(now);
    notices_.trouble(Severity::Error, Topic::Spawn, reason);
    owner_.robotFailed(reason);
}

} // namespace usar::mission
