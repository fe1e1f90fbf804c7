#include "core/agent/posh/posh_debugger.h"

#include <algorithm>
#include <utility>

#include "core/posh/run/trace_event.h"

namespace usar::agent {

namespace {

/// The reason for a halt in words; `text` is the text of the trace record that hit the breakpoint.
std::string reasonOf(const posh::Breakpoint& breakpoint, const std::string& names, const std::string& text) {
    const std::pair<std::string, std::string> around[] = {
        {"before ", ""},
        {"after ", ""},
        {"", " answered " + std::string(posh::toText(breakpoint.result))},
        {"the verdict on ", " changed"},
        {"", " was interrupted"},
        {"", " wrote " + text}}; // in the order of BreakOn
    const auto& [before, after] = around[static_cast<std::size_t>(breakpoint.on)];
    return before + names + after;
}

} // namespace

std::vector<std::string> PoshDebugger::set(const SetBreakpoints& all) {
    std::erase_if(known_, [&](const auto& entry) {
        const bool stays = std::ranges::find(all.breakpoints, entry.second.asked) != all.breakpoints.end();
        if (!stays)
            breakpoints_.remove(entry.second.number);
        return !stays;
    });
    std::vector<std::string> refused;
    for (const PlanBreakpoint& asked : all.breakpoints) {
        if (known_.contains(asked.id))
            continue;
        const auto number = breakpoints_.add(asked.what);
        if (number)
            known_[asked.id] = {asked, *number};
        else
            refused.push_back("The breakpoint at " + asked.what.names + " is left out: " + number.error().text());
    }
    return refused;
}

void PoshDebugger::set(const SetPins& pins, posh::Engine& engine) {
    pins_.releaseAll();
    for (const SensePin& pin : pins.senses)
        pins_.pinSense(pin.call, pin.answer);
    for (const ActPin& pin : pins.acts)
        pins_.pinAct(pin.call, pin.result);
    drives_off_ = pins.drives_off;
    switchDrives(engine);
}

void PoshDebugger::switchDrives(posh::Engine& engine) const {
    const posh::Program& program = *engine.program();
    for (posh::Index drive = 0; drive < program.drives.size(); ++drive)
        engine.switchDrive(drive, true);
    for (const DriveOff& off : drives_off_) {
        const posh::Index place = posh::findPlace(program, off.path, off.names);
        if (place != posh::nowhere && program.places[place].kind == posh::PlaceKind::Drive)
            engine.switchDrive(program.places[place].item, false);
    }
}

std::optional<PlanHalted> PoshDebugger::afterCycle(const posh::Engine& engine, Seconds now) {
    const std::vector<posh::BreakHit> hits = breakpoints_.takeHits();
    const Soon soon = std::exchange(soon_, Soon::No);
    if (hits.empty() && soon == Soon::No)
        return std::nullopt;
    halted_ = true;
    PlanHalted news{.cycle = engine.cycleNumber(), .time = now};
    if (hits.empty()) {
        news.reason = soon == Soon::Step ? "one cycle further" : "as asked";
        return news;
    }
    const posh::BreakHit& hit = hits.front();
    for (const auto& [id, known] : known_)
        if (known.number == hit.breakpoint) {
            news.breakpoint = id;
            news.reason = reasonOf(known.asked.what, posh::namePathOf(*engine.program(), hit.record.place), hit.text);
        }
    news.path = posh::pathOf(*engine.program(), hit.record.place);
    return news;
}

} // namespace usar::agent
