#include "core/sim/snapshot.h"

#include <charconv>
#include <limits>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr std::string_view first_line = "USARSim snapshot 1";
constexpr std::string_view record_kinds = "cdrlfeo";

void add(std::string& out, std::string_view key, std::string_view value) {
    out.append(key).append(" ").append(value).append("\n");
}

void add(std::string& out, std::string_view key, std::uint64_t value) {
    add(out, key, std::to_string(value));
}

void addNumber(std::string& out, std::string_view key, double value) {
    std::string text;
    appendShortest(text, value);
    add(out, key, text);
}

/// Reads a snapshot file piece by piece and keeps the first error.
class SnapshotReading {
public:
    explicit SnapshotReading(std::string_view file) : rest_(file) {}

    bool done() const { return rest_.empty() || error_; }
    const std::optional<Error>& error() const { return error_; }

    std::string_view line() {
        ++line_;
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) {
            fail("the file is cut short");
            return {};
        }
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return line;
    }

    std::string bytes(std::uint64_t count) {
        if (count >= rest_.size() || rest_[count] != '\n') {
            fail("the file is cut short, or bytes are missing");
            return {};
        }
        std::string bytes(rest_.substr(0, count));
        rest_.remove_prefix(count + 1);
        return bytes;
    }

    /// Fails above `most`, so that a damaged digit cannot ask for a run that takes forever to replay.
    std::uint64_t whole(std::string_view text, std::string_view what,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
        std::uint64_t value = 0;
        const auto [end, trouble] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (trouble != std::errc() || end != text.data() + text.size() || value > most)
            fail("'" + std::string(text) + "' is not a valid " + std::string(what));
        return value;
    }

    double number(std::string_view text, std::string_view what) {
        const auto value = readNumber(text);
        if (!value || !(*value > 0.0))
            fail("'" + std::string(text) + "' is not a valid " + std::string(what));
        return value.value_or(1.0);
    }

    Fault fault(std::string_view text) {
        const auto fault = readFault(text);
        if (!fault)
            fail(fault.error());
        return fault.value_or(Fault{});
    }

    void fail(const std::string& what) {
        fail(Error{what, "snapshot, line " + std::to_string(line_), "Choose a file that Save snapshot has written"});
    }
    void fail(const Error& error) {
        if (!error_)
            error_ = error;
    }

private:
    std::string_view rest_;
    int line_ = 0;
    std::optional<Error> error_;
};

void readHead(SnapshotReading& reading, std::string_view key, std::string_view value, Snapshot& snapshot) {
    SimulationOptions& options = snapshot.options;
    if (key == "world")
        options.world_source = value;
    else if (key == "seed")
        options.seed = reading.whole(value, "seed");
    else if (key == "profile")
        options.profile = value == "udk" ? protocol::Dialect::Udk : protocol::Dialect::Ut2004;
    else if (key == "tick_s")
        options.tick = Seconds{reading.number(value, "time")};
    else if (key == "physics_steps_per_tick")
        options.physics_steps_per_tick = static_cast<int>(reading.whole(value, "number of steps", 10'000));
    else if (key == "battery_life_s")
        options.battery_life = Seconds{reading.number(value, "time")};
    else if (key == "noise")
        options.noise = value != "off";
    else if (key == "fault")
        options.faults.push_back(reading.fault(value));
    else if (key == "ticks")
        snapshot.ticks = reading.whole(value, "number of ticks", 100'000'000);
    else if (key == "digest")
        snapshot.digest = reading.whole(value, "digest");
    else
        reading.fail("unknown word '" + std::string(key) + "'");
}

} // namespace

std::string write(const Snapshot& snapshot) {
    const SimulationOptions& options = snapshot.options;
    std::string out(first_line);
    out += '\n';
    add(out, "world", options.world_source);
    add(out, "seed", options.seed);
    add(out, "profile", options.profile == protocol::Dialect::Udk ? "udk" : "ut2004");
    addNumber(out, "tick_s", options.tick.count());
    add(out, "physics_steps_per_tick", static_cast<std::uint64_t>(options.physics_steps_per_tick));
    if (options.battery_life)
        addNumber(out, "battery_life_s", options.battery_life->count());
    add(out, "noise", options.noise ? "on" : "off");
    for (const Fault& fault : options.faults)
        add(out, "fault", write(fault));
    add(out, "ticks", snapshot.ticks);
    add(out, "digest", snapshot.digest);
    add(out, "journal", snapshot.journal.size());
    for (const JournalEntry& entry : snapshot.journal) {
        out += static_cast<char>(entry.kind);
        for (const std::uint64_t value : {entry.tick, std::uint64_t(entry.client), std::uint64_t(entry.bytes.size())})
            out += " " + std::to_string(value);
        out += '\n';
        out += entry.bytes;
        out += '\n';
    }
    return out;
}

Result<Snapshot> readSnapshot(std::string_view file) {
    SnapshotReading reading(file);
    Snapshot snapshot;
    if (reading.line() != first_line)
        return failure("this is not a snapshot", "line 1", "Choose a file that Save snapshot has written");
    std::uint64_t entries = 0;
    while (!reading.done()) {
        std::string_view line = reading.line();
        const std::string_view key = takeWord(line);
        if (key == "journal") {
            entries = reading.whole(trimmed(line), "number of entries");
            break;
        }
        readHead(reading, key, trimmed(line), snapshot);
    }
    for (; entries > 0 && !reading.error(); --entries) {
        std::string_view line = reading.line();
        const std::string_view kind = takeWord(line);
        JournalEntry entry;
        if (kind.size() != 1 || record_kinds.find(kind.front()) == std::string_view::npos)
            reading.fail("'" + std::string(kind) + "' is not a kind of entry");
        else
            entry.kind = static_cast<JournalEntry::Kind>(kind.front());
        entry.tick = reading.whole(takeWord(line), "tick");
        entry.client = static_cast<std::uint32_t>(reading.whole(takeWord(line), "client"));
        entry.bytes = reading.bytes(reading.whole(takeWord(line), "count of bytes"));
        snapshot.journal.push_back(std::move(entry));
    }
    if (reading.error())
        return tl::unexpected(*reading.error());
    return snapshot;
}

} // namespace usar::sim
