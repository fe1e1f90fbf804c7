// Carries a run from the engine's thread to one reader without ever making the engine wait: what the reader is too slow
// for is dropped, oldest first, and counted.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "core/posh/trace_event.h"

namespace usar::posh {

/// One writer (the engine), one reader; no locks, no allocation when writing.
class TraceRing final : public TraceObserver {
public:
    static constexpr std::size_t longest_text = 80; ///< bytes; longer ones are cut

    struct Entry {
        TraceRecord record;
        std::uint32_t program = 0; ///< how many programs were put in before it
        std::string text;
    };

    /// `capacity` in records, rounded up to a power of two.
    explicit TraceRing(std::size_t capacity = 1 << 14);

    void takeProgram(const std::shared_ptr<const Program>&) override { ++programs_; }
    void take(const TraceRecord& record, std::string_view text) override;

    /// For the reader: appends what came since the last call, oldest first.
    void read(std::vector<Entry>& out);
    /// For the reader: records that it never saw, in all.
    std::uint64_t dropped() const { return dropped_; }

private:
    /// `turn` is odd while the slot is written. All words are atomic: the reader may look at any time.
    struct Slot {
        static constexpr std::size_t record_words = sizeof(TraceRecord) / 8;
        static constexpr std::size_t text_words = longest_text / 8;
        std::atomic<std::uint64_t> turn{0};
        std::array<std::atomic<std::uint64_t>, record_words + 1 + text_words> words{};
    };
    bool readSlot(std::uint64_t number, Entry& entry) const;

    std::vector<Slot> slots_;
    std::atomic<std::uint64_t> written_{0};
    std::uint32_t programs_ = 0; ///< writer's
    std::uint64_t read_ = 0;     ///< reader's, as the next
    std::uint64_t dropped_ = 0;
};

} // namespace usar::posh
