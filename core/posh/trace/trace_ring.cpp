#include "core/posh/trace/trace_ring.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace usar::posh {

TraceRing::TraceRing(std::size_t capacity) : slots_(std::bit_ceil(std::max<std::size_t>(capacity, 2))) {}

void TraceRing::take(const TraceRecord& record, std::string_view text) {
    const std::uint64_t number = written_.load(std::memory_order_relaxed);
    Slot& slot = slots_[number & (slots_.size() - 1)];
    slot.turn.store(2 * number + 1, std::memory_order_relaxed);
    const auto words = std::bit_cast<std::array<std::uint64_t, Slot::record_words>>(record);
    // Each store has release order, so that the reader cannot see it before the odd turn.
    for (std::size_t i = 0; i < words.size(); ++i)
        slot.words[i].store(words[i], std::memory_order_release);
    const std::size_t length = std::min(text.size(), longest_text);
    slot.words[Slot::record_words].store(std::uint64_t{programs_} << 32 | length, std::memory_order_release);
    for (std::size_t at = 0; at < length; at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, length - at));
        slot.words[Slot::record_words + 1 + at / 8].store(word, std::memory_order_release);
    }
    slot.turn.store(2 * number + 2, std::memory_order_release);
    written_.store(number + 1, std::memory_order_release);
}

void TraceRing::read(std::vector<Entry>& out) {
    const std::uint64_t written = written_.load(std::memory_order_acquire);
    if (written - read_ > slots_.size()) {
        dropped_ += written - slots_.size() - read_;
        read_ = written - slots_.size();
    }
    for (; read_ != written; ++read_) {
        Entry entry;
        if (readSlot(read_, entry))
            out.push_back(std::move(entry));
        else
            ++dropped_; // Overwritten while it was read
    }
}

bool TraceRing::readSlot(std::uint64_t number, Entry& entry) const {
    const Slot& slot = slots_[number & (slots_.size() - 1)];
    if (slot.turn.load(std::memory_order_acquire) != 2 * number + 2)
        return false;
    std::array<std::uint64_t, Slot::record_words> words{};
    for (std::size_t i = 0; i < words.size(); ++i)
        words[i] = slot.words[i].load(std::memory_order_acquire);
    entry.record = std::bit_cast<TraceRecord>(words);
    const std::uint64_t more = slot.words[Slot::record_words].load(std::memory_order_acquire);
    entry.program = static_cast<std::uint32_t>(more >> 32);
    std::array<char, longest_text> text{};
    const std::size_t length = std::min<std::size_t>(more & 0xFFFFFFFF, longest_text);
    for (std::size_t at = 0; at < length; at += 8) {
        const std::uint64_t word = slot.words[Slot::record_words + 1 + at / 8].load(std::memory_order_acquire);
        std::memcpy(text.data() + at, &word, 8);
    }
    entry.text.assign(text.data(), length);
    return slot.turn.load(std::memory_order_relaxed) == 2 * number + 2;
}

} // namespace usar::posh
