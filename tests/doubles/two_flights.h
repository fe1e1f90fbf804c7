// A recording of two flights of one robot, as bytes, with what a behavior told and nothing else.
#pragma once

#include <chrono>
#include <string>

#include "core/agent/published_text.h"
#include "tests/doubles/plain_recording.h"

namespace usar::doubles {

inline std::string statusText(const std::string& state, double flown_m) {
    agent::BehaviorStatus status;
    status.battery_used_pct = 20.0;
    status.state = state;
    status.distance_flown_m = flown_m;
    std::string text;
    agent::appendText(text, status);
    return text;
}

/// The first flight begins at 1 s, says "out" at 2 s, and is landed at 3 s. The second one begins at 4 s and says
/// "again" at 5 s. The recording ends at 6 s, in flight.
inline std::string twoFlights() {
    using link::RecordKind;
    using namespace std::chrono_literals;
    std::string file;
    appendOldHead(file);
    const auto add = [&](link::RecordTime time, const std::string& name, const std::string& bytes) {
        appendPlain(file, {.kind = RecordKind::Note, .time = time, .line = {2}, .name = name, .bytes = bytes});
    };
    appendPlain(file, {.kind = RecordKind::Start, .bytes = "robot: R1\n"});
    appendPlain(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    appendPlain(file, {.kind = RecordKind::In, .bytes = "STA {Battery 1000}\r\nSTA {Battery 500}\r\n"});
    add(1s, "behavior", "airrobot/cpp\tR1\t0 0 3 4");
    add(2s, "published", statusText("out", 7.0));
    add(3s, "finished", "0 Landed on request.");
    add(4s, "behavior", "airrobot/posh\tR1\t0 0 3 4");
    add(5s, "published", statusText("again", 2.0));
    add(6s, "fault", "wind");
    return file;
}

} // namespace usar::doubles
