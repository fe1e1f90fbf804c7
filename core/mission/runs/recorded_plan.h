// Which parts of a POSH plan were active when, read from its trace piece by piece.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/trace/run_activity.h"
#include "core/posh/trace/trace_file.h"

namespace usar::mission {

/// The innermost parts that were active in a cycle.
struct ActiveParts {
    std::string plan;
    std::uint64_t cycle = 0;
    std::vector<std::string> paths; ///< "robot ▸ work ▸ drive"; empty: none
    bool operator==(const ActiveParts&) const = default;
};

/// Keeps no more of the trace than what follows its last key frame. Neither copied nor moved.
class RecordedPlan {
public:
    using Tell = std::function<void(const ActiveParts&)>;
    explicit RecordedPlan(Tell tell) : tell_(std::move(tell)) {}
    RecordedPlan(const RecordedPlan&) = delete;
    RecordedPlan& operator=(const RecordedPlan&) = delete;

    /// Takes the next piece of a trace file, or the first of another run, and tells each change of the active parts.
    /// Pieces behind a lost first one say nothing.
    void take(std::string_view piece);

private:
    /// The complete frame at `offset`: its kind and its end; nullopt if there is none yet.
    std::optional<std::pair<posh::trace_codec::Frame, std::size_t>> frameAt(std::size_t offset) const;
    /// Where the last complete key among the frames that were not read begins; 0 if there is none.
    std::size_t lastKey() const;
    void begin(std::string bytes);
    /// Reads the cycles up to the byte at `end`.
    void readTo(std::size_t end);
    void read(const posh::TracedCycle& cycle);

    Tell tell_;
    std::string bytes_;      ///< a trace file of its own: magic, the newest plan and what came since the last key
    std::string plan_frame_; ///< bytes of the newest frame with a plan
    std::size_t taken_ = 0;  ///< bytes of complete frames that were read
    std::optional<posh::TraceFile> file_;
    std::optional<posh::TraceFile::Cursor> cursor_;
    posh::RunActivity activity_;
    ActiveParts told_;
};

} // namespace usar::mission
