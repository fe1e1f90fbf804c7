// A hash table from names to numbers that stores only the numbers and asks its caller for the names. It is several
// times faster than std::unordered_map for the short names of plans, which are looked up tens of thousands of times.
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

/// Uses open addressing. In the functions below, `name_of(number)` returns the name that was stored with that number;
/// it must always return the same name. Names cannot be removed.
class NumberTable {
public:
    using Number = std::uint32_t;
    static constexpr Number none = std::numeric_limits<Number>::max(); ///< never a name's number

    /// Makes room for this many names without growing again.
    void reserve(std::size_t names) {
        if (2 * names > slots_.size())
            grow(std::bit_ceil(2 * names));
    }

    /// Returns the number of a name, or `none` if the name is not in the table.
    /// Takes constant time on average; `name_of` is called for numbers with the same hash only.
    template <class NameOf>
    Number find(std::string_view name, NameOf&& name_of) const {
        return slots_.empty() ? none : slots_[slotOf(name, hashOf(name), name_of)].number;
    }

    /// Returns the number of a name. If the name is not in the table yet, it is stored with the number `fresh`.
    /// `fresh` must not be `none`. Growing invalidates no numbers.
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
    /// The hash is stored so that most other names are told apart without asking for them.
    struct Slot {
        std::uint32_t hash = 0;
        Number number = none;
    };

    /// Mixes eight bytes at a time; the last eight may overlap the ones before them.
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
    /// Reads a number from any address in the byte order of this machine, so hashes must not be stored in files.
    template <class Word>
    static Word load(const char* bytes) {
        Word word = 0;
        std::memcpy(&word, bytes, sizeof word);
        return word;
    }

    /// Returns the slot of a name, or the free slot where it would go. The search ends because at least half of the
    /// slots are free.
    template <class NameOf>
    std::size_t slotOf(std::string_view name, std::uint32_t hash, NameOf& name_of) const {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
            const Slot& slot = slots_[at];
            if (slot.number == none || (slot.hash == hash && std::string_view(name_of(slot.number)) == name))
                return at;
        }
    }
    /// `size` must be a power of two; the table has at least 16 slots.
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

    std::vector<Slot> slots_; ///< a power of two in number, at least half of them free
    std::size_t count_ = 0;
};

} // namespace usar::posh
