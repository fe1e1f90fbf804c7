#include "core/modules/response.h"

namespace usar::modules {

void ResponseModule::take(const protocol::InfoLine& line) {
    const auto* const response = std::get_if<protocol::Response>(&line.message);
    if (!response)
        return;
    if (queue_.size() == capacity) {
        queue_.pop_front();
        ++overflow_count_;
    }
    queue_.push_back(*response);
}

std::vector<protocol::Response> ResponseModule::takeAll() {
    std::vector<protocol::Response> all(queue_.begin(), queue_.end());
    queue_.clear();
    return all;
}

} // namespace usar::modules
