// Turns a run into the bytes of a trace file while it happens: a cycle that is as the one before costs a few bytes.
#pragma once

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/posh/trace_codec.h"

namespace usar::posh {

/// Watches one engine. Whoever owns the file takes the bytes, as often as it likes, and appends them to it; every frame
/// is whole once the file holds its last byte.
class TraceEncoder final : public TraceObserver {
public:
    /// The text that the engine's program was read from.
    explicit TraceEncoder(std::string plan_text) : plan_text_(std::move(plan_text)) {}
    /// Before the engine is given another program: the text of that.
    void setPlanText(std::string plan_text) { plan_text_ = std::move(plan_text); }

    void takeProgram(const std::shared_ptr<const Program>& program) override;
    void take(const TraceRecord& record, std::string_view text) override;
    /// What came since the last call; after the end of the run, what happened behind its last cycle as well.
    std::string takeBytes();

private:
    using Entry = trace_codec::Entry;

    std::uint32_t numberOf(std::string_view text);
    void encodeCycle();
    void encodeDifference();
    std::size_t findBefore(const Entry& entry, std::size_t from) const;
    void appendRun();
    void appendChange(const Entry& before, const Entry& now);
    void appendNew(const Entry& entry);
    void appendText(std::uint32_t number);
    void encodeBetween();
    void appendFrame(trace_codec::Frame kind);
    void forgetTexts();

    std::string plan_text_;
    std::string bytes_{trace_codec::magic};
    std::string body_; ///< of the frame that is made
    std::vector<Entry> now_;
    std::vector<Entry> before_;
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> texts_;
    std::size_t texts_written_ = 0;
    std::uint64_t run_ = 0; ///< events that are as before and not yet written
    int until_key_ = 0;
    std::int64_t time_ms_ = 0;
    std::int64_t step_ms_ = 0;
    bool in_cycle_ = false;
};

} // namespace usar::posh
