#include "core/mission/world/world_session.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/mission/world/world_edits.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

namespace {

constexpr int answers_until_missed = 3; ///< the first may have been under way, and a slow server takes another tick
constexpr qint64 speed_span_ms = 1000;
const char* const topic = "world";
const char* const placing = "world/placing"; ///< topic of all things that did not appear, which are one notice

} // namespace

WorldSession::WorldSession() : link_(this), beat_(this) {
    beat_.setSingleShot(true);
    clock_.start();
    link_.setLineTaker([this](std::string_view line) { takeLine(line); });
    connect(&link_, &link::TcpLink::opened, this, [this] { opened(); });
    connect(&link_, &link::TcpLink::closed, this, [this] { closed(); });
    connect(&link_, &link::TcpLink::statusChanged, this, [this](const link::LinkStatus& status) {
        if (status.state == link::LinkState::Connecting || status.state == link::LinkState::Waiting)
            setState(WorldState::Connecting, status.trouble.toStdString());
        if (status.state == link::LinkState::Waiting && !std::exchange(waiting_, {}).empty())
            refuseWithoutConnection();
    });
    connect(&beat_, &QTimer::timeout, this, [this] { beat(); });
}

void WorldSession::setLimits(const WorldSessionLimits& limits) {
    limits_ = limits;
    link_.setLimits(limits.link);
}

void WorldSession::open(const QString& host, quint16 port) {
    ever_answered_ = silence_said_ = false;
    dialect_ = protocol::Dialect::Ut2004;
    kinds_.clear();
    link_.open(host, port);
}

void WorldSession::close() {
    link_.close();
    beat_.stop();
    waiting_.clear(); // Nobody waits for another server's objects.
    closed();
    setState(WorldState::Off);
}

void WorldSession::setPolling(std::optional<std::chrono::milliseconds> interval) {
    polling_ = interval;
    beat();
}

void WorldSession::setPaused(bool paused) {
    paused_ = paused;
    if (!paused && open_question_)
        open_question_->since.start();
    beat();
}

void WorldSession::opened() {
    closed();
    setState(WorldState::Asking);
    auto init = protocol::Init::worldController("MissionControl", dialect_);
    link_.send(protocol::write(init, dialect_));
    questions_left_ = std::max(questions_left_, 1);
    for (const protocol::Command& command : std::exchange(waiting_, {}))
        send(command);
    beat();
}

void WorldSession::closed() {
    open_question_.reset();
    classes_to_ask_.clear();
    awaited_.clear();
    ways_.clear();
    if (!std::exchange(view_.things, {}).empty())
        tell();
}

void WorldSession::send(const protocol::Command& command) {
    const link::LinkState state = link_.status().state;
    if (state == link::LinkState::Connecting)
        return waiting_.push_back(command);
    if (state != link::LinkState::Connected)
        return refuseWithoutConnection();
    if (const auto* const created = std::get_if<protocol::CreateObject>(&command)) {
        const std::string name = created->object_name.text();
        kinds_[name] = withoutPackage(created->class_name.text());
        awaited_[name] = {created->class_name.text(), 0};
    }
    if (const auto* const placed = std::get_if<protocol::PlaceObject>(&command))
        ways_.erase(placed->object_name.text()); // A jump must not count as speed.
    link_.send(protocol::write(command, dialect_));
    questions_left_ = limits_.settling_questions;
    if (!open_question_)
        ask();
    beat();
}

void WorldSession::refuseWithoutConnection() {
    emit noticed({Severity::Warning, "There is no connection to the world yet. Connect to a server first.", topic});
}

void WorldSession::refuse(const QString& name, const QString& reason) {
    if (awaited_.erase(name.toStdString()) == 0)
        return;
    kinds_.erase(name.toStdString());
    failToPlace("Could not place " + name.toStdString() + ": " + reason.toStdString() + ".");
}

/// Asks if it is time to, and schedules the next check.
void WorldSession::beat() {
    if (link_.status().state != link::LinkState::Connected)
        return;
    if (open_question_) {
        if (!paused_ && open_question_->since.hasExpired(limits_.answer.count()))
            return missAnswer();
        return beat_.start(limits_.answer / 4);
    }
    const bool settling = questions_left_ > 0 || !classes_to_ask_.empty();
    if (!settling && !polling_)
        return;
    const auto interval = settling && (!polling_ || *polling_ > limits_.settle) ? limits_.settle : *polling_;
    const std::chrono::milliseconds passed(since_asked_.isValid() ? since_asked_.elapsed() : interval.count());
    if (passed >= interval || !classes_to_ask_.empty())
        ask();
    beat_.start(open_question_ ? limits_.answer / 4 : std::max(interval - passed, std::chrono::milliseconds(1)));
}

void WorldSession::ask() {
    protocol::GetObjectStates question;
    if (!classes_to_ask_.empty()) {
        question.class_name = protocol::Name::mended(classes_to_ask_.front());
        classes_to_ask_.pop_front();
    } else {
        since_asked_.start();
        questions_left_ = std::max(0, questions_left_ - 1);
    }
    open_question_.emplace(Question{question.class_name.text(), {}});
    open_question_->since.start();
    link_.send(protocol::write(question, dialect_));
}

void WorldSession::missAnswer() {
    open_question_.reset();
    if (!ever_answered_ && dialect_ == protocol::Dialect::Ut2004) {
        dialect_ = protocol::Dialect::Udk; // UDK's class has another name, and a connection accepts one INIT.
        const link::LinkStatus status = link_.status();
        return link_.open(status.host, status.port);
    }
    const std::string where = placeOf(link_.status());
    if (ever_answered_)
        setState(WorldState::Asking, where + " no longer says where things are. Is the game paused there?");
    else
        setState(WorldState::Refused, "The server at " + where +
                                          " does not answer as a world controller, so things cannot be put into its "
                                          "world. The embedded simulator can.");
    if (!std::exchange(silence_said_, true))
        emit noticed({Severity::Warning, view_.trouble, topic});
    questions_left_ = std::max(questions_left_, 1);
    since_asked_.start();
    beat_.start(limits_.answer);
}

void WorldSession::takeLine(std::string_view text) {
    const protocol::InfoLine& line = reader_.read(text);
    const auto* const objects = std::get_if<protocol::WorldObjects>(&line.message);
    if (!objects)
        return;
    ever_answered_ = true;
    if (std::exchange(silence_said_, false))
        emit noticed({.severity = Severity::Note, .text = {}, .topic = topic, .over = true});
    const std::string class_name = open_question_ ? open_question_->class_name : std::string();
    open_question_.reset();
    view_.state = WorldState::Ready;
    view_.trouble.clear();
    if (class_name.empty())
        takeThings(*objects);
    else
        for (const protocol::WorldObject& object : objects->objects)
            if (kinds_[object.name].empty())
                kinds_[object.name] = withoutPackage(class_name);
    for (WorldThing& thing : view_.things)
        thing.class_name = kinds_[thing.name];
    tell();
    beat();
}

void WorldSession::takeThings(const protocol::WorldObjects& objects) {
    std::vector<WorldThing> things;
    for (const protocol::WorldObject& object : objects.objects)
        things.push_back({object.name,
                          {},
                          object.size_m,
                          object.object_in_map,
                          velocityOf(object.name, object.object_in_map.position_m)});
    view_.things = std::move(things);
    std::erase_if(ways_, [this](const auto& way) {
        return std::ranges::none_of(view_.things, [&](const WorldThing& thing) { return thing.name == way.first; });
    });
    noteAwaited();
    learnKinds();
}

Vec3 WorldSession::velocityOf(const std::string& name, const Vec3& position_m) {
    std::deque<Sample>& way = ways_[name];
    const qint64 now_ms = clock_.elapsed();
    way.push_back({now_ms, position_m});
    while (way.size() > 2 && now_ms - way[1].at_ms >= speed_span_ms)
        way.pop_front();
    const double span_s = static_cast<double>(now_ms - way.front().at_ms) / 1000.0;
    return span_s > 0.05 ? Vec3((position_m - way.front().position_m) / span_s) : Vec3(Vec3::Zero());
}

/// The server does not report the class of a thing, but it lists the things of a class.
void WorldSession::learnKinds() {
    bool strangers = false;
    for (const WorldThing& thing : view_.things)
        strangers |= kinds_.try_emplace(thing.name).second;
    if (strangers)
        classes_to_ask_.assign(classes_.begin(), classes_.end());
}

void WorldSession::noteAwaited() {
    std::size_t came = 0;
    for (const WorldThing& thing : view_.things)
        came += std::erase_if(awaited_, [&](const auto& one) { return sameWord(one.first, thing.name); });
    if (came > 0 && std::exchange(placing_failed_, false))
        emit noticed({.severity = Severity::Note, .text = {}, .topic = placing, .over = true});
    for (auto one = awaited_.begin(); one != awaited_.end();) {
        if (++one->second.answers < answers_until_missed) {
            questions_left_ = std::max(questions_left_, 1);
            ++one;
            continue;
        }
        failToPlace("Could not place " + one->first +
                    ": something (a tree?) is in the way, or the server does not know " + one->second.class_name +
                    ". Choose another place or class.");
        kinds_.erase(one->first);
        one = awaited_.erase(one);
    }
}

void WorldSession::failToPlace(std::string sentence) {
    placing_failed_ = true;
    emit noticed({Severity::Warning, std::move(sentence), placing});
}

void WorldSession::setState(WorldState state, std::string trouble) {
    view_.state = state;
    view_.trouble = std::move(trouble);
    tell();
}

} // namespace usar::mission
