// A set of names that is fast for the usual handful of names and not slow for many.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <unordered_set>

namespace usar::posh {

/// Stores views, so the text that they point into must outlive the set. The first 16 names are in an array; more go
/// into a hash set.
class NameSet {
public:
    /// Adds a name; returns false if it is already in the set.
    bool insert(std::string_view name) {
        if (!many_.empty())
            return many_.insert(name).second;
        const auto end = few_.begin() + static_cast<std::ptrdiff_t>(count_);
        if (std::find(few_.begin(), end, name) != end)
            return false;
        if (count_ < few_.size()) {
            few_[count_++] = name;
        } else {
            many_.insert(few_.begin(), few_.end());
            many_.insert(name);
        }
        return true;
    }

private:
    std::array<std::string_view, 16> few_;
    std::size_t count_ = 0;
    std::unordered_set<std::string_view> many_;
};

} // namespace usar::posh
