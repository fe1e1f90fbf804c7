// Results of SET, queued until somebody looks.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// The queue empties when read. Bounded: past `capacity` the oldest goes and is counted.
class ResponseModule {
public:
    static constexpr std::size_t capacity = 1024;

    void take(const protocol::InfoLine& line);
    std::vector<protocol::Response> takeAll();
    std::size_t overflowCount() const { return overflow_count_; }

private:
    std::deque<protocol::Response> queue_;
    std::size_t overflow_count_ = 0;
};

} // namespace usar::modules
