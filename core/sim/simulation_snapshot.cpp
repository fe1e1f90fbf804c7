// Snapshots of a simulation: recording its inputs and replaying them.
#include <algorithm>
#include <bit>

#include "core/sim/simulation_state.h"

namespace usar::sim {

namespace {

/// FNV-1a, 64 bit.
class Digest {
public:
    void add(std::uint64_t value) {
        for (int byte = 0; byte < 8; ++byte)
            value_ = (value_ ^ ((value >> (8 * byte)) & 0xff)) * 1099511628211ull;
    }
    void add(const Pose& pose) {
        for (const double number : {pose.position_m.x(), pose.position_m.y(), pose.position_m.z(), pose.roll_rad,
                                    pose.pitch_rad, pose.yaw_rad})
            add(std::bit_cast<std::uint64_t>(number));
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ull;
};

} // namespace

/// Records an input. Successive bytes of one client within one tick become one entry, because it does not matter how
/// they were split into chunks.
void Simulation::State::keep(JournalEntry::Kind kind, std::uint32_t client, std::string_view bytes) {
    if (!options.keeps_journal)
        return;
    journal_bytes += bytes.size() + sizeof(JournalEntry);
    if (journal_bytes > most_journal_bytes) {
        journal = {}; // A run of weeks; its snapshots are refused.
        return;
    }
    JournalEntry* const last = journal.empty() ? nullptr : &journal.back();
    if (kind == JournalEntry::Kind::Receive && last && last->kind == kind && last->client == client &&
        last->tick == ticks)
        last->bytes += bytes;
    else
        journal.push_back({kind, ticks, client, std::string(bytes)});
}

std::uint64_t Simulation::State::digest() const {
    Digest digest;
    digest.add(ticks);
    for (const auto& [client, session] : sessions) {
        digest.add(client.value);
        digest.add(session.saidDigest());
        if (session.robot())
            digest.add(session.robot()->figures().base_in_map);
    }
    for (const SceneObject& object : scene.objects)
        digest.add(object.body_in_map);
    return digest.value();
}

/// If the client's INIT names a robot that waits for a client, the client gets that robot at once, because time stands
/// still until then.
bool Simulation::State::adopt(ClientId client, ClientSession& session) {
    const std::string name = session.wantedName();
    const auto orphan = std::ranges::find_if(
        sessions, [&](const auto& one) { return one.second.isOrphan() && one.second.robotName() == name; });
    if (name.empty() || orphan == sessions.end())
        return false;
    orphan->second.takeOver(session);
    auto taken = sessions.extract(orphan);
    taken.key() = client;
    sessions.erase(client);
    sessions.insert(std::move(taken));
    log(client, "goes on with '" + name + "'");
    return true;
}

Result<Snapshot> Simulation::snapshot() const {
    if (!state_->options.keeps_journal)
        return failure("this run keeps no record of its input, which a snapshot needs", "snapshot",
                       "Run it in usar-sim or in the window");
    if (state_->journal_bytes > most_journal_bytes)
        return failure("this run has received too much input to be saved", "snapshot", "Restart the simulator");
    Snapshot snapshot{state_->options, state_->ticks, state_->digest(), state_->journal};
    snapshot.options.robots.reset();
    if (snapshot.options.world_source.empty())
        snapshot.options.world_source = state_->world.name;
    return snapshot;
}

void Simulation::apply(const JournalEntry& entry) {
    const ClientId client{entry.client};
    switch (entry.kind) {
    case JournalEntry::Kind::Connect:
        connect();
        break;
    case JournalEntry::Kind::Disconnect:
        disconnect(client);
        break;
    case JournalEntry::Kind::Receive:
        receive(client, entry.bytes);
        break;
    case JournalEntry::Kind::Release:
        releaseFromLockstep(client);
        break;
    case JournalEntry::Kind::AddFault:
        if (const auto fault = readFault(entry.bytes))
            addFault(*fault);
        break;
    case JournalEntry::Kind::EndFault:
        endFault(static_cast<int>(entry.client));
        break;
    case JournalEntry::Kind::Resume:
        state_->keep(entry.kind);
        std::erase_if(state_->sessions, [](const auto& one) { return !one.second.robot(); });
        for (auto& [id, session] : state_->sessions)
            session.orphan();
        break;
    }
}

Result<std::unique_ptr<Simulation>> Simulation::resume(World world, std::shared_ptr<const RobotCatalog> robots,
                                                       const Snapshot& snapshot, const ResumeWatch& watch) {
    SimulationOptions options = snapshot.options;
    options.robots = std::move(robots);
    auto made = make(std::move(world), options);
    if (!made)
        return made;
    Simulation& simulation = **made;
    auto entry = snapshot.journal.begin();
    const auto applyUntilNow = [&] {
        for (; entry != snapshot.journal.end() && entry->tick <= simulation.state_->ticks; ++entry)
            simulation.apply(*entry);
    };
    const Seconds whole = static_cast<double>(snapshot.ticks) * snapshot.options.tick;
    for (applyUntilNow(); simulation.state_->ticks < snapshot.ticks; applyUntilNow()) {
        if (watch && !watch(simulation.now(), whole))
            return failure("it was given up before the saved moment was reached",
                           "snapshot of " + snapshot.options.world_source);
        simulation.step();
        for (auto& [client, session] : simulation.state_->sessions)
            session.takeOutput(simulation.now()); // As the server did in the original run.
    }
    if (simulation.state_->digest() != snapshot.digest)
        return failure("the replayed run differs from the saved one", "snapshot of " + snapshot.options.world_source,
                       "Use the world, the robot files and the program that it was saved with");
    simulation.apply({.kind = JournalEntry::Kind::Resume, .tick = snapshot.ticks});
    simulation.takeLog();
    simulation.takeRefused();
    simulation.takeFaultNews();
    simulation.takeCut();
    simulation.takeVanished();
    simulation.takeSilenced();
    return made;
}

void Simulation::letOrphansGo() {
    for (const ClientId client : awaited())
        if (state_->sessions.at(client).isOrphan())
            releaseFromLockstep(client);
}

std::vector<Simulation::Orphan> Simulation::orphans() const {
    std::vector<Orphan> waiting;
    for (const auto& [client, session] : state_->sessions)
        if (session.isOrphan())
            waiting.push_back({"USARBot." + session.robot()->body().model().class_name, session.robotName(),
                               session.robot()->figures().base_in_map});
    return waiting;
}

} // namespace usar::sim
