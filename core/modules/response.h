// Queues the results of SET until they are taken.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// Reading empties the queue. Beyond `capacity` results, the oldest is dropped and counted.
class ResponseModule {
public:
    static constexpr std::size_t capacity = 1024;

    /// Call it with every info line of the connection.
    void take(const protocol::InfoLine& line);
    /// Returns all results, oldest first.
    std::vector<protocol::Response> takeAll();
    std::size_t overflowCount() const { return overflow_count_; }

private:
    std::deque<protocol::Response> queue_;
    std::size_t overflow_count_ = 0;
};

} // namespace usar::modules
