// A lock-free ring buffer that passes a run from the engine's thread to one reader. The engine never waits: if the
// reader is too slow, the oldest records are dropped and counted.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "core/posh/run/trace_event.h"

namespace usar::posh {

/// For one writer (the engine's thread) and one reader in any thread. Writing neither locks nor allocates memory.
class TraceRing final : public TraceObserver {
public:
    static constexpr std::size_t longest_text = 80; ///< in bytes; longer texts are cut, possibly inside a character

    struct Entry {
        TraceRecord record;
        std::uint32_t program = 0; ///< number of programs loaded before the record
        std::string text;
    };

    /// `capacity` is the number of records, rounded up to a power of two.
    explicit TraceRing(std::size_t capacity = 1 << 14);

    void takeProgram(const std::shared_ptr<const Program>&) override { ++programs_; }
    void take(const TraceRecord& record, std::string_view text) override;

    /// For the reader: appends the records since the last call, oldest first.
    void read(std::vector<Entry>& out);
    /// For the reader: the total number of records that were dropped before it could read them.
    std::uint64_t dropped() const { return dropped_; }

private:
    /// A record in the ring, protected by a sequence lock: `turn` is odd while the slot is being written. All words are
    /// atomic, because the reader may read them at any time.
    struct Slot {
        static constexpr std::size_t record_words = sizeof(TraceRecord) / 8;
        static constexpr std::size_t text_words = longest_text / 8;
        std::atomic<std::uint64_t> turn{0};
        std::array<std::atomic<std::uint64_t>, record_words + 1 + text_words> words{};
    };
    /// Returns false if the record with this number has been overwritten.
    bool readSlot(std::uint64_t number, Entry& entry) const;

    std::vector<Slot> slots_;
    std::atomic<std::uint64_t> written_{0}; ///< number of records written
    std::uint32_t programs_ = 0;            ///< used by the writer only
    std::uint64_t read_ = 0;                ///< number of records read or dropped; used by the reader only
    std::uint64_t dropped_ = 0;             ///< used by the reader only
};

} // namespace usar::posh
