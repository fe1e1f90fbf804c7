// Reads what TraceEncoder wrote: any cycle of a long run, even while the file is still being written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/posh/trace/trace_codec.h"

namespace usar::posh {

/// One cycle of a recorded run, with the events between it and the next cycle.
struct TracedCycle {
    /// Counts from 1, as in the engine.
    std::uint64_t number = 0;
    std::int64_t time_ms = 0;               ///< in the engine's time
    std::shared_ptr<const Program> program; ///< nullptr if the plan in the file cannot be compiled
    std::size_t plan = 0;                   ///< index of the plan among those in the file
    std::vector<trace_codec::Entry> events;
    std::vector<trace_codec::Entry> behind; ///< events after the end of the cycle, such as a stop or a replacement
    std::vector<std::string> texts;         ///< the text with number n is at index n - 1

    /// Empty if the event has no text; valid as long as the cycle is.
    std::string_view textOf(const trace_codec::Entry& entry) const {
        return entry.text == 0 ? std::string_view() : std::string_view(texts[entry.text - 1]);
    }
};

/// An index over the bytes of a trace file. It does not own the bytes; they must outlive it. The bytes need not be
/// trustworthy: at a damaged frame the trace ends.
class TraceFile {
public:
    /// Indexes the bytes. Fails if they do not begin with the magic of this version.
    static Result<TraceFile> open(std::string_view bytes);

    /// Continues with a file that has grown: `bytes` must begin with the bytes already known, but may be at another
    /// address. A frame that is not complete yet is left for later.
    void extend(std::string_view bytes);

    /// Number of cycles in complete frames.
    std::size_t cycleCount() const { return cycle_count_; }
    /// Describes where a frame of unknown kind ended the trace; empty if there was none.
    const std::string& damage() const { return damage_; }
    /// Text of a plan as it was recorded; `plan` must be less than planCount().
    const std::string& planText(std::size_t plan) const { return plans_[plan].text; }
    std::size_t planCount() const { return plans_.size(); }

    /// Reads one cycle after the other. Must not outlive the file or its bytes.
    class Cursor {
    public:
        /// Returns the next cycle, which is valid until the next call; nullptr after the last cycle and at a damaged
        /// one. In a file that grows, what comes behind a cycle after it was returned is passed over.
        const TracedCycle* next();

    private:
        friend class TraceFile;
        Cursor(const TraceFile& file, std::size_t offset, std::size_t plan) : file_(&file), at_(offset), plan_(plan) {}
        bool deltaFollows() const;
        bool readCycle(trace_codec::Frame kind, ByteReader bytes);
        bool readEvents(ByteReader& bytes, std::vector<trace_codec::Entry>& events);
        bool readChange(ByteReader& bytes, trace_codec::Entry& entry);
        bool readNew(ByteReader& bytes, trace_codec::Entry& entry);
        bool readText(ByteReader& bytes, std::uint32_t& number);
        void readBehind();
        void recallAnswers();
        void stamp(std::vector<trace_codec::Entry>& events) const;

        const TraceFile* file_;
        std::size_t at_;
        std::size_t plan_;                      ///< number of plans before `at_`
        std::optional<std::size_t> keyed_plan_; ///< `plan_` at the last key frame
        std::int64_t step_ms_ = 0;              ///< time between the two previous cycles
        TracedCycle cycle_;
        std::vector<trace_codec::Entry> before_;  ///< events of the previous cycle as coded, without cached answers
        std::vector<trace_codec::Entry> now_;     ///< the same for the current cycle
        std::vector<trace_codec::Entry> answers_; ///< newest answers by sense call
    };
    /// Returns a cursor whose next cycle is the first one of the file.
    Cursor begin() const { return {*this, trace_codec::magic.size(), 0}; }
    /// Returns a cursor whose next cycle is this one, or the first recorded cycle after it.
    Cursor seek(std::uint64_t cycle) const;

private:
    /// A key frame.
    struct Key {
        std::uint64_t cycle = 0;
        std::size_t offset = 0; ///< byte offset of the frame
        std::size_t plan = 0;   ///< number of plans before it
    };
    /// A plan and what it compiles to; the program is nullptr if it does not compile.
    struct RecordedPlan {
        std::string text;
        std::shared_ptr<const Program> program;
    };
    /// One complete frame of the file.
    struct FrameView {
        trace_codec::Frame kind = trace_codec::Frame::Plan;
        std::string_view body;
        std::size_t end = 0; ///< byte offset of the next frame
    };
    /// Returns the frame at a byte offset; nullopt if there is no complete one.
    std::optional<FrameView> frameAt(std::size_t offset) const;
    /// Adds one frame to the index.
    void index(const FrameView& frame, std::size_t offset);

    std::string_view bytes_;
    std::size_t indexed_ = 0; ///< number of bytes that are indexed
    std::size_t cycle_count_ = 0;
    std::vector<Key> keys_;
    std::vector<RecordedPlan> plans_;
    std::string damage_;
};

} // namespace usar::posh
