// Counts lines with something wrong in them, and says each kind of wrong once.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "core/protocol/info_message.h"

namespace usar::mission {

/// `topic` is one word for all complaints of a kind.
struct Complaint {
    std::string topic;
    std::string text;
};

/// Two complaints are of one kind when the messages are of one type and the texts differ only in numbers and quoted
/// words. After `kind_limit` kinds new ones are counted in silence. Owned by one session.
class ComplaintBook {
public:
    static constexpr std::size_t kind_limit = 20;

    /// A sentence for the person when this kind is new. Notes are not complaints.
    std::optional<Complaint> take(const protocol::InfoLine& line);
    std::uint64_t count() const { return count_; }

private:
    std::set<std::string> kinds_;
    std::uint64_t count_ = 0;
};

} // namespace usar::mission
