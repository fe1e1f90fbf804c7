#include "core/sim/simulation.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/sim/simulation_state.h"

namespace usar::sim {

namespace {

constexpr std::size_t most_log_sentences = 1000;
// What one client may cause to be logged: bursts, and a few sentences a second of simulated time.
constexpr double most_at_once = 50.0;
constexpr double more_per_s = 5.0;
constexpr std::uint64_t connection_streams = std::uint64_t(3) << 40; // Beyond the random streams of sensors and winds.
constexpr std::size_t most_viewers = 64;

/// With control bytes written as \\x1b, so that a client cannot steer the terminal that shows the log.
std::string printable(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte != 0x7f)
            out += c;
        else
            out += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
    return out;
}

} // namespace

void Simulation::State::log(ClientId client, const std::string& sentence) {
    Chatter& chatter = chatters[client];
    chatter.allowance = std::min(most_at_once, chatter.allowance + more_per_s * (now() - chatter.at).count());
    chatter.at = now();
    if (chatter.allowance < 1.0 || sentences.size() >= most_log_sentences) {
        ++chatter.left_out;
        return;
    }
    chatter.allowance -= 1.0;
    tellLeftOut(client);
    sentences.push_back("client " + std::to_string(client.value) + ": " + printable(sentence));
}

void Simulation::State::tellLeftOut(ClientId client) {
    const auto found = chatters.find(client);
    if (found == chatters.end() || found->second.left_out == 0)
        return;
    sentences.push_back("client " + std::to_string(client.value) + ": " +
                        std::to_string(std::exchange(found->second.left_out, 0)) +
                        " more sentences about it were left out");
}

std::optional<std::string> Simulation::State::control(ClientId client, const protocol::Command& command) {
    auto trouble = controller.obey(command, client.value);
    const auto* const creation = std::get_if<protocol::CreateObject>(&command);
    if (!trouble || !creation)
        return trouble;
    if (refused.size() < most_log_sentences)
        refused.push_back({creation->object_name.text(), *std::move(trouble)});
    return std::nullopt;
}

bool Simulation::State::attachCamera(const protocol::Command& command) {
    if (const auto* const detach = std::get_if<protocol::DetachCamera>(&command))
        return attached.erase(detach->client_address.text()) > 0;
    const auto& attach = std::get<protocol::AttachCamera>(command);
    const std::string address = attach.client_address.text();
    const bool known = std::ranges::any_of(sessions, [&](const auto& one) {
        if (!one.second.robot() || !sameWord(one.second.robotName(), attach.robot_name))
            return false;
        return std::ranges::any_of(one.second.robot()->cameras(), [&](const SeenFrom& camera) {
            return attach.camera_name.empty() || sameWord(camera.camera, attach.camera_name);
        });
    });
    if (known && (attached.contains(address) || attached.size() < most_viewers))
        attached[address] = {attach.robot_name.text(), attach.camera_name};
    return known;
}

std::pair<int, int> Simulation::State::placeInWindow(ClientId client, std::string_view camera) const {
    constexpr int most_views = 4;
    int count = 0;
    int number = 0;
    int width_px = 0;
    int height_px = 0;
    for (const auto& [id, session] : sessions) {
        if (!session.robot())
            continue;
        for (const SeenFrom& one : session.robot()->cameras()) {
            if (id == client && sameWord(one.camera, camera))
                number = count;
            if (count++ < most_views) {
                width_px = std::max(width_px, one.width_px);
                height_px = std::max(height_px, one.height_px);
            }
        }
    }
    return {number % 2 * width_px, number / 2 * height_px};
}

void Simulation::State::obeyAll() {
    for (auto& [id, session] : sessions) {
        const ClientId client = id;
        session.obeyWaiting({[&](const protocol::Init& init, const auto& why) { return spawn(client, init, why); },
                             [&](const protocol::Init& init) { return nameOf(client, init); },
                             [&](const protocol::Init& init, const auto& why) { return stationAt(client, init, why); },
                             [&](const protocol::Command& command) { return control(client, command); },
                             [&](const protocol::GetObjectStates& asked) { return controller.states(asked); },
                             [&](const protocol::Command& command) { return attachCamera(command); },
                             [&](const Viewports& wanted) { viewports = wanted; },
                             [&] { return viewports.value_or(Viewports{}); },
                             [&](const std::string& camera) { return placeInWindow(client, camera); },
                             [&](const std::string& sentence) { log(client, sentence); }, now()});
    }
}

void Simulation::State::followFaults() {
    const std::vector<FaultStatus> changed = faults.advance(now());
    fault_news.insert(fault_news.end(), changed.begin(), changed.end());
    for (const FaultStatus& one : changed)
        if (sentences.size() < most_log_sentences)
            sentences.push_back(sentenceOf(one));
    for (auto& [client, session] : sessions) {
        if (!changed.empty() || session.isNew())
            setFaults(client, session);
        if (session.overfull())
            log(client, "too much data is held back by a fault: the connection is cut");
        if (session.overfull() || (session.robot() && faults.takeCut(session.robotName())))
            cut.push_back(client);
        const auto removes = [&, since = now() - session.spawnedAt()](const Fault& fault) {
            return fault.kind == FaultKind::Vanish && since >= Seconds{fault.number("after")};
        };
        if (session.robot() && std::ranges::any_of(faults.activeOn(session.robotName()), removes)) {
            log(client, "'" + session.robotName() + "' has vanished");
            vanished.push_back(session.robotName());
            rememberFigures(client, session);
            session.loseRobot();
        }
        const auto silences = [this](const Fault& fault) {
            return fault.kind == FaultKind::LinkHalfOpen && fault.lasts == without_end &&
                   now() - fault.from >= silence_limit;
        };
        if (session.robot() && session.lockstep() && !session.silenced() &&
            std::ranges::any_of(faults.activeOn(session.robotName()), silences)) {
            log(client, "'" + session.robotName() + "' hears nothing more, and time waits for it");
            silenced.push_back(session.robotName());
            session.silence(true);
        }
    }
}

void Simulation::State::rememberFigures(ClientId client, const ClientSession& session) {
    if (session.robot())
        last_gone = RobotTruth{session.robot()->figures(), client, session.robotName()};
}

void Simulation::State::setFaults(ClientId client, ClientSession& session) {
    const std::vector<Fault> active = faults.activeOn(session.robotName());
    session.setFaults(active, seeded(options.seed, connection_streams + client.value));
    for (const Fault& fault : active)
        if (session.robot() && !session.robot()->canHave(fault))
            log(client, "the fault '" + write(fault) + "' does nothing to '" + session.robotName() +
                            "', which has no " + (fault.kind == FaultKind::Rotor ? "rotors" : "such sensor"));
}

void Simulation::State::move() {
    std::vector<Robot*> robots;
    for (auto& [id, session] : sessions)
        if (session.robot())
            robots.push_back(session.robot());
    if (robots.empty() && scene.objects.empty())
        return;
    const Seconds dt = options.tick / options.physics_steps_per_tick;
    for (int i = 0; i < options.physics_steps_per_tick; ++i) {
        const Vec3 wind_m_s = faults.wind(dt);
        for (Robot* const robot : robots) {
            robot->feelWind(wind_m_s);
            robot->beforeStep(dt);
        }
        carryObjects(scene, *physics, dt);
        physics->step(dt);
        for (Robot* const robot : robots)
            robot->afterStep(dt);
    }
}

void Simulation::State::reportAll() {
    refresh(scene, *physics);
    for (auto& [id, session] : sessions) {
        session.report(now());
        if (auto mark = session.takeMark(now())) {
            addMark(scene, *std::move(mark));
            ++marks_made;
        }
    }
}

Result<std::unique_ptr<Simulation>> Simulation::make(World world, SimulationOptions options) {
    auto prepared = PreparedWorld::make(std::move(world));
    if (!prepared)
        return tl::unexpected(prepared.error());
    return make(*std::move(prepared), std::move(options));
}

Result<std::unique_ptr<Simulation>> Simulation::make(PreparedWorld world, SimulationOptions options) {
    if (!(options.tick > Seconds{0.0}) || options.physics_steps_per_tick < 1)
        return failure("a tick needs a length and at least one physics step", "simulation options");
    if (options.battery_life && !(*options.battery_life > Seconds{0.0}))
        return failure("a battery must last longer than 0 s", "simulation options");
    return std::unique_ptr<Simulation>(new Simulation(std::make_unique<State>(std::move(world), options)));
}

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}

Simulation::~Simulation() = default;

ClientId Simulation::connect() {
    const ClientId client{++state_->last_client.value};
    state_->keep(JournalEntry::Kind::Connect, client.value);
    state_->sessions.try_emplace(client, state_->world, state_->options.profile, state_->options.keeps_journal);
    return client;
}

void Simulation::disconnect(ClientId client) {
    state_->keep(JournalEntry::Kind::Disconnect, client.value);
    if (const auto found = state_->sessions.find(client); found != state_->sessions.end()) {
        state_->rememberFigures(client, found->second);
        state_->sessions.erase(found);
    }
    state_->tellLeftOut(client);
    state_->chatters.erase(client);
    state_->controller.clientLeft(client.value);
}

void Simulation::receive(ClientId client, std::string_view bytes) {
    const auto found = state_->sessions.find(client);
    if (found == state_->sessions.end())
        return;
    state_->keep(JournalEntry::Kind::Receive, client.value, bytes);
    found->second.receive(bytes, [&](const std::string& sentence) { state_->log(client, sentence); });
    if (!found->second.robot())
        state_->adopt(client, found->second);
}

std::string Simulation::takeOutput(ClientId client) {
    const auto found = state_->sessions.find(client);
    return found == state_->sessions.end() ? std::string() : found->second.takeOutput(now());
}

bool Simulation::readyToStep() const {
    return awaited().empty();
}

bool Simulation::hasLockstepClients() const {
    return std::ranges::any_of(state_->sessions, [](const auto& one) { return one.second.lockstep(); });
}

std::vector<ClientId> Simulation::awaited() const {
    std::vector<ClientId> clients;
    for (const auto& [client, session] : state_->sessions)
        if (!session.ready() || session.isOrphan())
            clients.push_back(client);
    return clients;
}

void Simulation::releaseFromLockstep(ClientId client) {
    const auto found = state_->sessions.find(client);
    if (found == state_->sessions.end())
        return;
    state_->keep(JournalEntry::Kind::Release, client.value);
    if (found->second.isOrphan()) {
        state_->rememberFigures(client, found->second);
        state_->sessions.erase(found);
    } else {
        found->second.leaveLockstep();
    }
}

bool Simulation::mayStep(ClientId client) const {
    const auto found = state_->sessions.find(client);
    return found != state_->sessions.end() && !found->second.mayNotStep();
}

bool Simulation::idle() const {
    return std::ranges::all_of(state_->sessions, [](const auto& one) { return one.second.idle(); });
}

void Simulation::step() {
    state_->obeyAll();
    state_->followFaults();
    state_->move();
    ++state_->ticks;
    state_->reportAll();
}

int Simulation::addFault(const Fault& fault) {
    state_->keep(JournalEntry::Kind::AddFault, 0, write(fault));
    return state_->faults.add(fault);
}

bool Simulation::endFault(int id) {
    state_->keep(JournalEntry::Kind::EndFault, static_cast<std::uint32_t>(id));
    for (auto& [client, session] : state_->sessions)
        session.silence(false); // The next tick tells whether another fault silences it.
    return state_->faults.end(id);
}

const std::vector<FaultStatus>& Simulation::faults() const {
    return state_->faults.all();
}

std::vector<FaultStatus> Simulation::takeFaultNews() {
    return std::exchange(state_->fault_news, {});
}

std::vector<ClientId> Simulation::takeCut() {
    return std::exchange(state_->cut, {});
}

Seconds Simulation::now() const {
    return state_->now();
}

const SimulationOptions& Simulation::options() const {
    return state_->options;
}

const World& Simulation::world() const {
    return state_->world;
}

const RayCaster& Simulation::caster() const {
    return state_->caster;
}

CameraScene Simulation::cameraScene() const {
    CameraScene seen{
        .still = state_->still, .tick = state_->ticks, .attached = state_->attached, .viewports = state_->viewports};
    for (const auto& [client, session] : state_->sessions)
        if (session.robot())
            addRobot(seen, *session.robot(), session.robotName(), client.value);
    addObjects(seen, state_->scene);
    addMarks(seen, state_->world);
    return seen;
}

std::vector<RobotTruth> Simulation::robots() const {
    std::vector<RobotTruth> truths;
    for (const auto& [client, session] : state_->sessions)
        if (session.robot())
            truths.push_back({session.robot()->figures(), client, session.robotName()});
    return truths;
}

std::optional<RobotTruth> Simulation::lastGone() const {
    return state_->last_gone;
}

protocol::WorldObjects Simulation::objects() const {
    return state_->controller.states({});
}

std::vector<RadioStation> Simulation::radios() const {
    const Vec3 up_m(0.0, 0.0, state_->options.radio.antenna_height_m);
    std::vector<RadioStation> radios;
    for (const auto& [client, session] : state_->sessions) {
        if (const Robot* const robot = session.robot())
            radios.push_back({session.robotName(), robot->figures().base_in_map.position_m + up_m, !robot->alive()});
        else if (const auto& station = session.stationInMap())
            radios.push_back({session.robotName(), station->position_m + up_m});
    }
    return radios;
}

int Simulation::obstaclesBetween(const Vec3& a_in_map_m, const Vec3& b_in_map_m) const {
    RadioParameters all = state_->options.radio;
    all.most_obstacles = 1000;
    return sim::obstaclesBetween(state_->caster, a_in_map_m, b_in_map_m, all);
}

double Simulation::radioStrength_dbm(const RadioStation& a, const RadioStation& b) const {
    const RadioParameters& radio = state_->options.radio;
    return strengthOver((a.antenna_in_map_m - b.antenna_in_map_m).norm(),
                        sim::obstaclesBetween(state_->caster, a.antenna_in_map_m, b.antenna_in_map_m, radio), radio);
}

std::vector<TraceMark> Simulation::traceMarksSince(std::uint64_t made) const {
    const std::vector<TraceMark>& marks = state_->scene.trace_marks;
    const std::uint64_t fresh =
        std::min<std::uint64_t>(state_->marks_made - std::min(made, state_->marks_made), marks.size());
    return {marks.end() - static_cast<std::ptrdiff_t>(fresh), marks.end()};
}

std::uint64_t Simulation::traceMarksMade() const {
    return state_->marks_made;
}

void Simulation::learn(RobotModel model) {
    auto robots = std::make_shared<RobotCatalog>(state_->options.robots ? *state_->options.robots : RobotCatalog{});
    std::erase_if(*robots, [&](const RobotModel& one) { return sameWord(one.class_name, model.class_name); });
    robots->push_back(std::move(model));
    if (state_->options.robots)
        state_->former_robots.push_back(state_->options.robots);
    state_->options.robots = std::move(robots);
}

std::size_t Simulation::clientCount() const {
    return state_->sessions.size();
}

std::vector<std::string> Simulation::takeVanished() {
    return std::exchange(state_->vanished, {});
}

std::vector<std::string> Simulation::takeSilenced() {
    return std::exchange(state_->silenced, {});
}

std::vector<RefusedObject> Simulation::takeRefused() {
    return std::exchange(state_->refused, {});
}

std::vector<std::string> Simulation::takeLog() {
    return std::exchange(state_->sentences, {});
}

void Simulation::sumUpLog() {
    for (const auto& [client, chatter] : state_->chatters)
        state_->tellLeftOut(client);
}

} // namespace usar::sim
