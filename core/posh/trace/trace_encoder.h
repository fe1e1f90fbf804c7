// Encodes a run as the bytes of a trace file while it happens. A cycle like the one before takes only a few bytes.
#pragma once

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/posh/trace/trace_codec.h"

namespace usar::posh {

/// Watches one engine, in its thread. The owner of the file calls takeBytes as often as it likes and appends the result
/// to the file. takeBytes never splits a frame.
class TraceEncoder final : public TraceObserver {
public:
    /// `plan_text` is the text that the engine's program was read from.
    explicit TraceEncoder(std::string plan_text) : plan_text_(std::move(plan_text)) {}
    /// Sets the text of the next program; call it before the engine gets that program.
    void setPlanText(std::string plan_text) { plan_text_ = std::move(plan_text); }

    void takeProgram(const std::shared_ptr<const Program>& program) override;
    void take(const TraceRecord& record, std::string_view text) override;
    /// Returns the bytes since the last call; the first ones begin with the magic. Between cycles they include the
    /// events after the last cycle.
    std::string takeBytes();

private:
    using Entry = trace_codec::Entry;

    /// Returns the number of a text and numbers a new one.
    std::uint32_t numberOf(std::string_view text);
    void encodeCycle();
    void encodeDifference();
    /// Returns the index of the same event in the previous cycle, searching from `from`, or the number of its events.
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
    std::string body_;          ///< body of the frame that is being made
    std::vector<Entry> now_;    ///< events of the current cycle, or after the last one
    std::vector<Entry> before_; ///< events of the previous cycle
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> texts_;
    std::size_t texts_written_ = 0;
    std::uint64_t run_ = 0;    ///< number of unchanged events that are not yet written
    int until_key_ = 0;        ///< number of cycles before the next key frame
    std::int64_t time_ms_ = 0; ///< time of the previous cycle
    std::int64_t step_ms_ = 0; ///< time between the two previous cycles
    bool in_cycle_ = false;
};

} // namespace usar::posh
