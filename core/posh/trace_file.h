// Reads what TraceEncoder wrote: any cycle of a long run, also while it is being written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/posh/trace_codec.h"

namespace usar::posh {

/// One cycle as it was, with what happened between it and the next.
struct TracedCycle {
    std::uint64_t number = 0;
    std::int64_t time_ms = 0;
    std::shared_ptr<const Program> program; ///< none where the plan in the file cannot be read
    std::size_t plan = 0;                   ///< its number in the file
    std::vector<trace_codec::Entry> events;
    std::vector<trace_codec::Entry> behind; ///< after its end: a stop, a replacement
    std::vector<std::string> texts;         ///< by number, from 1

    std::string_view textOf(const trace_codec::Entry& entry) const {
        return entry.text == 0 ? std::string_view() : std::string_view(texts[entry.text - 1]);
    }
};

/// An index over the bytes of a file, which it does not own. Bytes are untrusted: what is damaged ends the trace there,
/// and `damage` says so.
class TraceFile {
public:
    /// An error when the bytes do not begin as a trace of this version.
    static Result<TraceFile> open(std::string_view bytes);

    /// The file has grown: `bytes` begin with those known already. A frame that is not whole yet is left for later.
    void extend(std::string_view bytes);

    std::size_t cycleCount() const { return cycle_count_; }
    std::uint64_t firstCycle() const { return keys_.empty() ? 0 : keys_.front().cycle; }
    const std::string& damage() const { return damage_; }
    const std::string& planText(std::size_t plan) const { return plans_[plan].text; }
    std::size_t planCount() const { return plans_.size(); }

    /// Reads cycles one after another. Must not outlive the file or its bytes.
    class Cursor {
    public:
        /// The next cycle, valid until the next call; nothing behind the last.
        const TracedCycle* next();

    private:
        friend class TraceFile;
        Cursor(const TraceFile& file, std::size_t offset, std::size_t plan) : file_(&file), at_(offset), plan_(plan) {}
        bool deltaFollows() const;
        bool readCycle(trace_codec::Frame kind, trace_codec::Bytes bytes);
        bool readEvents(trace_codec::Bytes& bytes, std::vector<trace_codec::Entry>& events);
        bool readChange(trace_codec::Bytes& bytes, trace_codec::Entry& entry);
        bool readNew(trace_codec::Bytes& bytes, trace_codec::Entry& entry);
        bool readText(trace_codec::Bytes& bytes, std::uint32_t& number);
        void readBehind();
        void recallAnswers();
        void stamp(std::vector<trace_codec::Entry>& events) const;

        const TraceFile* file_;
        std::size_t at_;
        std::size_t plan_;                      ///< number of plans that stand before `at_`
        std::optional<std::size_t> keyed_plan_; ///< `plan_` at the last key frame
        std::int64_t step_ms_ = 0;
        TracedCycle cycle_;
        std::vector<trace_codec::Entry> before_; ///< as coded
        std::vector<trace_codec::Entry> now_;
        std::vector<trace_codec::Entry> answers_; ///< newest, by sense call
    };
    Cursor begin() const { return {*this, trace_codec::magic.size(), 0}; }
    /// The next of the cursor is that cycle, or the first behind it that was recorded.
    Cursor seek(std::uint64_t cycle) const;

private:
    struct Key {
        std::uint64_t cycle = 0;
        std::size_t offset = 0;
        std::size_t plan = 0;
    };
    struct RecordedPlan {
        std::string text;
        std::shared_ptr<const Program> program;
    };
    struct FrameView {
        trace_codec::Frame kind = trace_codec::Frame::Plan;
        std::string_view body;
        std::size_t end = 0;
    };
    /// Nothing where no whole frame stands.
    std::optional<FrameView> frameAt(std::size_t offset) const;
    void index(const FrameView& frame, std::size_t offset);

    std::string_view bytes_;
    std::size_t indexed_ = 0; ///< bytes
    std::size_t cycle_count_ = 0;
    std::vector<Key> keys_;
    std::vector<RecordedPlan> plans_;
    std::string damage_;
};

} // namespace usar::posh
