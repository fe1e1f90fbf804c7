// Tells from the trace of a POSH plan which of its elements ran, and when.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/posh/trace/trace_file.h"

namespace usar::mission {

/// Takes the pieces of a trace (agent::PlanTrace). It keeps the bytes of the run, about 4 MB for an hour. A piece that
/// begins as a trace does belongs to a new run of the plan.
class PlanWatch {
public:
    /// Called for each drive, element, form and act that runs in a cycle, by its name in the plan. `time` is that of
    /// the cycle, on the protocol clock.
    using Tell = std::function<void(const std::string& name, Seconds time)>;

    /// `cycled`, if any, is called after each cycle with its time.
    void take(std::string_view piece, const Tell& ran, const std::function<void(Seconds)>& cycled = {});
    /// True if the newest plan has something of this name that could run.
    bool has(std::string_view name) const;

private:
    std::string bytes_;
    std::optional<posh::TraceFile> file_;
    std::shared_ptr<const posh::Program> program_; ///< of the newest cycle
    std::uint64_t next_ = 1;                       ///< number of the first cycle that is not told yet
};

} // namespace usar::mission
