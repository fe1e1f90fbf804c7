// Counts lines from the server that have something wrong in them, and reports each kind of problem once.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "core/protocol/info_message.h"

namespace usar::mission {

/// A problem in a line, in words.
struct Complaint {
    std::string kind; ///< equal for all complaints of one kind
    std::string text;
};

/// Two complaints are of the same kind if their messages are of the same type and their texts differ only in numbers
/// and quoted words. After `kind_limit` kinds, new ones are only counted. Owned by one session.
class ComplaintBook {
public:
    static constexpr std::size_t kind_limit = 20;

    /// Returns a sentence for the user if the line has a problem of a new kind, else nullopt. Diagnostics of severity
    /// Note do not count as problems.
    std::optional<Complaint> take(const protocol::InfoLine& line);
    /// Number of lines with a problem.
    std::uint64_t count() const { return count_; }

private:
    std::set<std::string> kinds_;
    std::uint64_t count_ = 0;
};

} // namespace usar::mission
