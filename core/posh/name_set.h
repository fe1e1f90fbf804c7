// Names seen so far: nearly always a handful, but never slow when there are many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace usar::posh {

/// Keeps views: the text must outlive it.
class NameSet {
public:
    /// False where the name was there already.
    bool insert(std::string_view name) {
        if (!many_.empty())
            return many_.insert(name).second;
        if (std::find(few_.begin(), few_.end(), name) != few_.end())
            return false;
        few_.push_back(name);
        if (few_.size() > most_compared)
            many_.insert(few_.begin(), few_.end());
        return true;
    }

private:
    static constexpr std::size_t most_compared = 16;
    std::vector<std::string_view> few_;
    std::unordered_set<std::string_view> many_;
};

} // namespace usar::posh
