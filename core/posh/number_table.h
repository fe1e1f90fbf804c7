// Which number a name has: a table that keeps numbers only, and asks whoever has the names for them. Several times
// faster than std::unordered_map for the short names of plans, which are looked up tens of thousands of times.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace usar::posh {

/// `name_of(number)` in the functions below gives the name that was noted under that number: always the same.
class NumberTable {
public:
    using Number = std::uint32_t;
    static constexpr Number none = std::numeric_limits<Number>::max();

    /// Room for as many names without growing.
    void reserve(std::size_t names) {
        if (2 * names > slots_.size())
            grow(std::bit_ceil(2 * names));
    }

    /// `none` where the name was never noted.
    template <class NameOf>
    Number find(std::string_view name, NameOf&& name_of) const {
        return slots_.empty() ? none : slots_[slotOf(name, hashOf(name), name_of)].number;
    }

    /// The number that the name has already; else `fresh`, which it has from now on.
    template <class NameOf>
    Number findOrNote(std::string_view name, Number fresh, NameOf&& name_of) {
        reserve(count_ + 1);
        const std::uint32_t hash = hashOf(name);
        Slot& slot = slots_[slotOf(name, hash, name_of)];
        if (slot.number != none)
            return slot.number;
        slot = {hash, fresh};
        ++count_;
        return fresh;
    }

private:
    struct Slot {
        std::uint32_t hash = 0;
        Number number = none;
    };

    /// Eight bytes at a time; the last ones overlap those before.
    static std::uint32_t hashOf(std::string_view name) {
        std::uint64_t hash = name.size();
        const auto mix = [&hash](std::uint64_t part) {
            hash = (hash ^ part) * 0x9E37'79B9'7F4A'7C15U;
            hash ^= hash >> 32U;
        };
        const char* const bytes = name.data();
        if (name.size() >= 8) {
            for (std::size_t at = 0; at + 8 < name.size(); at += 8)
                mix(load<std::uint64_t>(bytes + at));
            mix(load<std::uint64_t>(bytes + name.size() - 8));
        } else if (name.size() >= 4) {
            mix(load<std::uint32_t>(bytes) | std::uint64_t{load<std::uint32_t>(bytes + name.size() - 4)} << 32U);
        } else {
            for (const char c : name)
                mix(static_cast<unsigned char>(c));
        }
        return static_cast<std::uint32_t>(hash);
    }
    template <class Word>
    static Word load(const char* bytes) {
        Word word = 0;
        std::memcpy(&word, bytes, sizeof word);
        return word;
    }

    /// Where the name is, or would be; there is always a free slot.
    template <class NameOf>
    std::size_t slotOf(std::string_view name, std::uint32_t hash, NameOf& name_of) const {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
            const Slot& slot = slots_[at];
            if (slot.number == none || (slot.hash == hash && std::string_view(name_of(slot.number)) == name))
                return at;
        }
    }
    void grow(std::size_t size) {
        std::vector<Slot> larger(size < 16 ? 16 : size);
        for (const Slot& slot : slots_) {
            if (slot.number == none)
                continue;
            std::size_t at = slot.hash & (larger.size() - 1);
            while (larger[at].number != none)
                at = (at + 1) & (larger.size() - 1);
            larger[at] = slot;
        }
        slots_ = std::move(larger);
    }

    std::vector<Slot> slots_; ///< as many as a power of two, at least half of them free
    std::size_t count_ = 0;
};

} // namespace usar::posh
