// Names seen so far: nearly always a handful, but never slow when there are many.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <unordered_set>

namespace usar::posh {

/// Keeps views: the text must outlive it.
class NameSet {
public:
    /// False where the name was there already.
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
