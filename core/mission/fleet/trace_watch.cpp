#include "core/mission/fleet/trace_watch.h"

#include "core/base/text.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/fields.h"

namespace usar::mission {

std::vector<TraceSpot> TraceWatch::take(const SessionUpdate& update) {
    if (update.rewound)
        *this = {};
    std::vector<TraceSpot> spots;
    auto command = update.commands.begin();
    const auto obeyUpTo = [&](LineNumber line) {
        for (; command != update.commands.end() && command->after < line; ++command)
            obey(*command);
    };
    for (const protocol::InfoLine& line : update.lines) {
        obeyUpTo(line.number);
        now_ = protocol::timeOf(line.message).value_or(now_);
        if (const auto* const truth = std::get_if<protocol::GroundTruthReading>(&line.message))
            move(Source::GroundTruth, now_, truth->base_in_map.position_m, spots);
        else if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message))
            move(Source::Ins, now_, ins->base_in_map.position_m, spots);
    }
    for (; command != update.commands.end(); ++command)
        obey(*command);
    for (const agent::Published& published : update.published)
        if (const auto* const belief = std::get_if<agent::PoseEstimate>(&published))
            move(Source::Belief, belief->time, belief->base_in_map.position_m, spots);
    return spots;
}

/// Reads the command's text, because a command typed by the user is raw, and a replay has only the text.
void TraceWatch::obey(const SentCommand& command) {
    constexpr std::string_view word = "TRACE";
    if (!sameWord(std::string_view(command.text).substr(0, word.size()), word))
        return;
    Diagnostics diagnostics;
    const protocol::Command read = protocol::readCommand(command.text, diagnostics, protocol::Dialect::Ut2004);
    if (const auto* const trace = std::get_if<protocol::Trace>(&read))
        pen_.obey(*trace);
}

void TraceWatch::move(Source source, Seconds now, const Vec3& position_m, std::vector<TraceSpot>& spots) {
    if (source < best_)
        return;
    best_ = source;
    if (const auto color = pen_.markAt(now, position_m))
        spots.push_back({*color, position_m});
}

} // namespace usar::mission
