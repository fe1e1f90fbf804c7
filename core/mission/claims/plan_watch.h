// Tells from the trace of a POSH plan which of its elements ran, and when.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/posh/trace/trace_file.h"

namespace usar::mission {

/// Takes the pieces of a trace (agent::PlanTrace). It keeps the bytes of the run, about 4 MB for an hour. A piece that
/// begins as a trace does belongs to a new run of the plan. It stays where it was made, because it refers to its bytes.
class PlanWatch {
public:
    PlanWatch() = default;
    PlanWatch(const PlanWatch&) = delete;
    PlanWatch& operator=(const PlanWatch&) = delete;

    /// Called for each drive, element, form and act that runs in a cycle, by its name in the plan. `time` is that of
    /// the cycle, on the protocol clock.
    using Tell = std::function<void(const std::string& name, Seconds time)>;

    void take(std::string_view piece, const Tell& ran);
    /// Forgets the run.
    void clear();
    /// True if the newest plan has something of this name that could run.
    bool has(std::string_view name) const;

private:
    std::string bytes_;
    std::optional<posh::TraceFile> file_;
    std::optional<posh::TraceFile::Cursor> next_;  ///< It stands before the first cycle that is not told yet.
    std::shared_ptr<const posh::Program> program_; ///< of the newest cycle
};

} // namespace usar::mission
