// Parts of a session that other parts need, without a socket and with a clock that the test sets.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/mission/session/incoming.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/spawn_life.h"
#include "core/mission/session/vigil.h"

namespace usar::test {

/// Keeps every notice.
struct NoticeBook {
    mission::Notices notices{[this](const mission::Notice& notice) { said.push_back(notice); }};
    std::vector<mission::Notice> said;

    /// Topics of the notices in their order; a minus stands before the end of a problem.
    std::vector<std::string> topics() const {
        std::vector<std::string> topics;
        for (const mission::Notice& notice : said)
            topics.push_back((notice.over ? "-" : "") + notice.topic);
        return topics;
    }
    bool saidWords(const char* words) const {
        return std::ranges::any_of(
            said, [words](const mission::Notice& notice) { return notice.text.find(words) != std::string::npos; });
    }
};

/// Records what a spawn asks its session to do.
struct SpawnScribe : mission::SpawnOwner {
    void sendInit(const protocol::Init& init) override { inits.push_back(init.robot_name); }
    void reconnect() override { ++reconnects; }
    void spawnChanged() override { ++changes; }
    void robotCame(const std::string& robot_name) override { came.push_back(robot_name); }
    void robotFailed(const std::string& reason) override { failures.push_back(reason); }

    std::vector<std::string> inits;
    std::vector<std::string> came;
    std::vector<std::string> failures;
    int reconnects = 0;
    int changes = 0;
};

} // namespace usar::test
